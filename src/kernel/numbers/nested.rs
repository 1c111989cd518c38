//! Is a real number half a sum and half a difference of roots? `Q = A ± √B`, with A and B sums of square roots.
//!
//! For a map σ that is its own inverse on Q, `A = (Q + σQ)/2` and `B = (Q − σQ)²/4` lie in a smaller field.

use num_rational::BigRational;

use super::budget::Budget;
use super::form::Form;
use super::quadratic::{self, NEAR};
use super::radicals::as_sum;
use super::star::Star;

/// A real sum without its unit in this way; its conjugates are at hand.
pub(super) fn of(sum: &Star, values: &[f64], budget: &mut Budget) -> Vec<Form> {
    let units = sum.units();
    let n = sum.conductor;
    let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    let same = |a: f64, b: f64| (a - b).abs() <= NEAR * size;
    let place = |unit: u64| units.binary_search(&(unit % n)).ok();
    let mut tried: Vec<f64> = vec![values[0]];
    let mut forms = Vec::new();
    for (&unit, &image) in units.iter().zip(values) {
        let returns = place(unit * unit).is_some_and(|back| same(values[back], values[0]));
        if tried.iter().any(|&known| same(known, image)) || !returns || !budget.weigh(4 * values.len()) {
            continue;
        }
        tried.push(image);
        let partner = |at: usize| place(units[at] * unit).map_or(f64::NAN, |partner| values[partner]);
        // What is left of numbers that cancel is their rounding.
        let whole = |sum: f64| if same(sum, 0.0) { 0.0 } else { sum };
        let sums: Vec<f64> = (0..values.len()).map(|at| whole(values[at] + partner(at))).collect();
        let squares: Vec<f64> = (0..values.len()).map(|at| (values[at] - partner(at)).powi(2)).collect();
        forms.extend(decided(sum, &sums, &squares, values[0] > image, budget));
    }
    forms
}

/// The form from twice A and four times B, if that is what the sum is.
fn decided(sum: &Star, sums: &[f64], squares: &[f64], is_larger: bool, budget: &mut Budget) -> Option<Form> {
    let (units, n) = (sum.units(), sum.conductor);
    let half = BigRational::new(1.into(), 2.into());
    let middle = quadratic::propose(sums, &units, n, quadratic::over_sixteen)?.scaled(&half);
    let square = quadratic::propose(squares, &units, n, quadratic::over_sixteen)?.scaled(&(&half * &half));
    if !sum.is_from(&as_sum(&middle)?, &as_sum(&square)?, budget) {
        return None;
    }
    let sign = BigRational::from_integer(if is_larger { 1.into() } else { (-1).into() });
    Some(middle.plus(&square.square_root().scaled(&sign)))
}
