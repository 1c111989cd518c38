//! What is the length of a sum exactly? Decimals propose, exact arithmetic decides, the plainest true form wins.
//!
//! From the conjugates of a sum in decimals forms of several kinds are proposed, a file a kind. A form is taken only where
//! its difference from the sum, again a sum of rotating vectors, is proved to be zero (theory, section 6).

use std::cell::RefCell;

use num_rational::BigRational;
use num_traits::One;

use super::banks::Split;
use super::budget::Budget;
use super::form::Form;
use super::memory::{self, Memory};
use super::products::Products;
use super::radicals::{as_sum, number};
use super::rational_direction::rational_direction;
use super::star::Star;
use super::{banks, cosines, cost, nested, quadratic, trace};
use crate::exact::PhasorSum;

/// Forms that cost no more are plain enough: no other is looked for.
const PLAIN: usize = 12;

/// `|S|` in closed form; `None` for conductors above 1000, and where none is found within the [`Budget`].
pub fn modulus(sum: &PhasorSum) -> Option<Form> {
    let star = memory::star(sum);
    if let Some(known) = LENGTHS.with_borrow(|lengths| lengths.get(&star)) {
        return known;
    }
    let length = modulus_within(sum, &mut Budget::new());
    LENGTHS.with_borrow_mut(|lengths| lengths.keep(star, length.clone()));
    length
}

thread_local! {
    static LENGTHS: RefCell<Memory<Option<Form>>> = const { RefCell::new(Memory::new()) };
}

/// The same, and what is left of the budget.
pub fn modulus_within(sum: &PhasorSum, budget: &mut Budget) -> Option<Form> {
    if let [only] = sum.collected().as_slice() {
        return Some(Form::rational(num_traits::abs(only.weight.clone())));
    }
    let star = Star::of(sum)?;
    let length = length(&star.turned_to_first(), rational_direction(sum).map(|turn| sum.turned(&-&turn)), budget)?;
    Some(length.scaled(&star.unit))
}

/// `|S|` by the quadratic step alone: a root of at most four square roots, which a person writes where the field is small. What the plainest form
/// is compared with.
pub fn modulus_by_roots(sum: &PhasorSum) -> Option<Form> {
    let star = Star::of(sum)?;
    let turned = star.turned_to_first();
    let (square, mut budget) = (turned.squared(), Budget::new());
    let values: Vec<f64> = turned.conjugates().iter().map(num_complex::Complex::norm_sqr).collect();
    let form = quadratic::propose(&values, &square.units(), square.conductor, quadratic::over_sixteen)?;
    let is_right = as_sum(&form).is_some_and(|number| square.is(&number, &mut budget));
    is_right.then(|| form.square_root().scaled(&star.unit))
}

/// A real sum in closed form; `None` for conductors above 1000, and where none is found within the [`Budget`].
pub fn real(sum: &PhasorSum) -> Option<Form> {
    real_within(sum, &mut Budget::new())
}

/// The same, and what is left of the budget.
pub fn real_within(sum: &PhasorSum, budget: &mut Budget) -> Option<Form> {
    let star = Star::of(sum)?;
    let form = plainest(real_forms(&star, &values_of(&star), budget), &star.unit)?;
    Some(form.scaled(&star.unit))
}

/// The same positive number, plainer where that can be: `√3 cos 15° + √3 sin 15°` is `3√2/2`.
pub fn plainer(number: Form) -> Form {
    if cost::of(&number) <= PLAIN {
        return number;
    }
    let found = as_sum(&number).and_then(|sum| modulus(&sum));
    let forms = [Some(number.clone()), found].into_iter().flatten().collect();
    plainest(forms, &BigRational::one()).unwrap_or(number)
}

fn values_of(real: &Star) -> Vec<f64> {
    real.conjugates().into_iter().map(|value| value.re).collect()
}

/// The form whose multiple by the unit reads best.
pub(super) fn plainest(forms: Vec<Form>, unit: &BigRational) -> Option<Form> {
    forms.into_iter().min_by_key(|form| cost::of(&form.scaled(unit)))
}

/// Forms of a real sum without its unit, each of them proved.
fn real_forms(sum: &Star, values: &[f64], budget: &mut Budget) -> Vec<Form> {
    let mean = trace::of_terms(sum.conductor, &sum.terms);
    let first = values[0];
    if values.iter().all(|value| (value - first).abs() <= 1e-7 * first.abs().max(1.0))
        && sum.is(&number(mean.clone()), budget)
    {
        return vec![Form::rational(mean)];
    }
    let proved = |form: Form, budget: &mut Budget| as_sum(&form).filter(|number| sum.is(number, budget)).map(|_| form);
    let roots = quadratic::propose(values, &sum.units(), sum.conductor, quadratic::over_sixteen);
    let mut forms: Vec<Form> = roots.and_then(|form| proved(form, budget)).into_iter().collect();
    if forms.is_empty() {
        forms.extend(nested::of(sum, values, budget));
        forms.extend(cosines::of(sum).and_then(|form| proved(form, budget)));
    }
    forms
}

/// The length of a star without its unit; `upright` is the sum turned to its direction, where that is a rational turn.
fn length(star: &Star, upright: Option<PhasorSum>, budget: &mut Budget) -> Option<Form> {
    if let [(_, weight)] = star.terms.as_slice() {
        return Some(Form::rational(BigRational::from_integer(weight.unsigned_abs().into())));
    }
    let square = star.squared();
    let conjugates = star.conjugates();
    let values: Vec<f64> = conjugates.iter().map(num_complex::Complex::norm_sqr).collect();
    let mut forms: Vec<Form> = real_forms(&square, &values, budget).iter().map(Form::square_root).collect();
    let is_plain = |forms: &[Form]| forms.iter().any(|form| cost::of(form) <= PLAIN);
    if is_plain(&forms) {
        return plainest(forms, &star.unit);
    }
    let units = star.units();
    let products = Products { values: &values, units: &units, conductor: star.conductor };
    let proved = |form: &Form, budget: &mut Budget| {
        form.times(form).and_then(|f| as_sum(&f)).is_some_and(|number| square.is(&number, budget))
    };
    forms.extend(products.of_one(budget).into_iter().find(|form| proved(form, budget)));
    if let Some(upright) = upright.as_ref().and_then(Star::of) {
        let unit = &upright.unit / &star.unit;
        let real = real_forms(&upright, &values_of(&upright), budget);
        forms.extend(real.into_iter().map(|form| form.scaled(&unit)));
    }
    if !is_plain(&forms) {
        forms.extend(of_banks(star, budget));
    }
    if !is_plain(&forms) {
        let pairs = products.of_two(budget);
        forms.extend(pairs.into_iter().find(|form| proved(form, budget)));
    }
    plainest(forms, &star.unit)
}

/// The length of one bank times that of the bank factor.
fn of_banks(star: &Star, budget: &mut Budget) -> Option<Form> {
    let Split { bank, factor, .. } = banks::split(star, budget)?;
    let bank = bank.turned_to_first();
    let sum = bank.to_sum();
    let upright = rational_direction(&sum).map(|turn| sum.turned(&-&turn));
    length(&Star { unit: BigRational::one(), ..bank }, upright, budget)?.times(&factor)
}
