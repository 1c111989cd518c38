//! Why is a sum not zero, told without primes? Few vectors, vectors on one side, or components along one direction.
//!
//! Everything here is decided in exact numbers: angles by their fractions, components as sums of roots or between fractions.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::plainest::{Component, Reason, Size};
use super::symmetry::mirror_axis;
use crate::exact::{PhasorSum, Term, Turn};
use crate::motion::Enclosure;
use crate::numbers::{self, Form, Root};

/// The directions tried are those of the vectors and across them, of at most this many vectors.
const MOST_TRIED: usize = 24;
/// Bits behind the point when a component is enclosed.
const BITS: u32 = 128;
/// A component is reported to at most this many decimal places.
const MOST_PLACES: u32 = 4;
/// A component is reported to more places where it would have fewer units of its last place.
const LEAST_UNITS: u32 = 1000;

/// The plainest reason why a sum that is not zero is not.
pub(super) fn reason(sum: &PhasorSum) -> Reason {
    let vectors = sum.on_lines();
    match vectors.as_slice() {
        [only] => Reason::OneVector(only.clone()),
        [first, second] => Reason::TwoVectors([first.clone(), second.clone()]),
        [a, b, c] => of_three([a.clone(), b.clone(), c.clone()])
            .or_else(|| one_side(&vectors))
            .or_else(|| component(&vectors))
            .unwrap_or(Reason::Certificate),
        _ => one_side(&vectors).or_else(|| component(&vectors)).unwrap_or(Reason::Certificate),
    }
}

/// The inequality of the triangle, and the one triangle with equal sides.
fn of_three(mut vectors: [Term; 3]) -> Option<Reason> {
    let [a, b, c] = &vectors;
    if a.weight == b.weight && b.weight == c.weight {
        return Some(Reason::ThreeAlike(vectors));
    }
    vectors.sort_by(|one, other| other.weight.cmp(&one.weight).then_with(|| one.angle.cmp(&other.angle)));
    let [longest, second, third] = &vectors;
    (longest.weight >= &second.weight + &third.weight).then_some(Reason::OneTooLong(vectors))
}

/// The direction that all vectors are within less than 90° of.
fn one_side(vectors: &[Term]) -> Option<Reason> {
    let half = BigRational::new(1.into(), 2.into());
    let next = |index: usize| &vectors[(index + 1) % vectors.len()].angle;
    // Behind the vector with the wide gap after it the others follow within less than half a turn.
    let last = (0..vectors.len()).find(|&index| *(next(index) - &vectors[index].angle).turns() > half)?;
    let within = (&vectors[last].angle - next(last)).turns() * half;
    let middle = Turn::new(next(last).turns() + &within);
    Some(Reason::OneSide { middle, within: Turn::new(within) })
}

/// Components along a mirror line where there is one; else along the direction that tells it most plainly.
fn component(vectors: &[Term]) -> Option<Reason> {
    let quarter = Turn::fraction(1, 4);
    let mirror = mirror_axis(vectors);
    let is_mirror_line = mirror.is_some();
    let directions = match mirror {
        Some(axis) => vec![axis],
        None => {
            let own = vectors.iter().take(MOST_TRIED).map(|term| term.angle.clone());
            let own = own.flat_map(|angle| [&angle + &quarter, angle]);
            [Turn::zero(), quarter.clone()].into_iter().chain(own).collect()
        }
    };
    let component = |along: &Turn, size: Size| {
        let (vectors, along) = (vectors.to_vec(), along.clone());
        Reason::Component(Component { vectors, along, is_mirror_line, size })
    };
    let told = directions.iter().filter_map(|along| Some((along, roots(vectors, along)?)));
    let told = told.filter(|(_, form)| is_plainly_not_zero(form));
    if let Some((along, form)) = told.min_by_key(|(_, form)| weight_of(form)) {
        let low = enclosed(vectors, along)?.low;
        return Some(match low.is_positive() {
            true => component(along, Size::Roots(form)),
            false => component(&along.opposite(), Size::Roots(form.scaled(&-BigRational::one()))),
        });
    }
    let ends = |along: &Turn| {
        let Enclosure { low, high } = enclosed(vectors, along)?;
        let (along, low, high) = match high.is_negative() {
            true => (along.opposite(), -high, -low),
            false => (along.clone(), low, high),
        };
        let (low, high) = rounded(&low, &high)?;
        Some((along, low, high))
    };
    let longest = directions.iter().take(2).filter_map(ends).max_by(|one, other| one.1.cmp(&other.1));
    longest.map(|(along, low, high)| component(&along, Size::Between(low, high)))
}

/// The components along a direction as a sum of roots, where all their cosines are known.
fn roots(vectors: &[Term], along: &Turn) -> Option<Form> {
    vectors.iter().try_fold(Form::rational(BigRational::zero()), |sum, term| {
        Some(sum.plus(&numbers::known_cosine(&(&term.angle - along))?.scaled(&term.weight)))
    })
}

/// Different roots of whole numbers free of squares are in no rational proportion, and positive numbers do not cancel.
fn is_plainly_not_zero(form: &Form) -> bool {
    let terms = form.terms();
    let has_known_roots = terms.iter().all(|(root, _)| matches!(root, Root::One | Root::Whole(_)));
    let signs = || terms.iter().map(|(_, coefficient)| coefficient.is_positive());
    let is_of_one_sign = signs().all(|positive| positive) || signs().all(|positive| !positive);
    has_known_roots && !terms.is_empty() && (terms.len() <= 2 || is_of_one_sign)
}

/// Rational numbers are plainer than roots, one is plainer than two.
fn weight_of(form: &Form) -> (bool, usize) {
    (form.as_rational().is_none(), form.terms().len())
}

/// Ends that enclose the components along a direction and exclude zero.
fn enclosed(vectors: &[Term], along: &Turn) -> Option<Enclosure> {
    let [component, _] = numbers::enclose(&PhasorSum::new(vectors.to_vec()).turned(&-along), BITS);
    component.sign().map(|_| component)
}

/// Positive ends rounded outwards to as few decimal places as tell them apart from zero well.
fn rounded(low: &BigRational, high: &BigRational) -> Option<(BigRational, BigRational)> {
    let ten = BigInt::from(10);
    let scale = |places: u32| BigRational::from_integer(ten.pow(places));
    let enough = |places: &u32| (low * scale(*places)).floor() >= BigRational::from_integer(LEAST_UNITS.into());
    let unit = scale((0..MOST_PLACES).find(enough).unwrap_or(MOST_PLACES));
    let (low, high) = ((low * &unit).floor() / &unit, (high * &unit).ceil() / &unit);
    low.is_positive().then_some((low, high))
}
