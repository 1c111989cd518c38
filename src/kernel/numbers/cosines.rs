//! Which few cosines make up a real sum? What whole polygons add is nothing, and is taken off.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::Zero;

use super::form::Form;
use super::star::Star;
use crate::exact::{Turn, modulo};

/// Longer sums of cosines tell a reader nothing; decimals do.
const MOST_COSINES: usize = 6;

/// A real sum, without its unit, as `Σ q cos(2πt)`, `0 ≤ t ≤ ¼`; none with more than six cosines.
pub(super) fn of(sum: &Star) -> Option<Form> {
    let n = sum.conductor;
    // Twice the mean with the mirror image: like weights at t and −t.
    let mut weights = vec![0_i64; n as usize];
    for &(exponent, weight) in &sum.terms {
        weights[exponent as usize] += weight;
        weights[((n - exponent) % n) as usize] += weight;
    }
    take_polygons_off(&mut weights, n);
    let mut folded: BTreeMap<u64, i64> = BTreeMap::new();
    for (exponent, weight) in (0..n).zip(weights).filter(|(_, weight)| *weight != 0) {
        let (exponent, weight) = fold(exponent, weight, n);
        *folded.entry(exponent).or_insert(0) += weight;
    }
    folded.retain(|_, weight| *weight != 0);
    // 60° and 90° add to the rational part, or nothing.
    if folded.len() > MOST_COSINES + 2 {
        return None;
    }
    let half = |weight: i64| BigRational::new(weight.into(), 2.into());
    let angle = |exponent: u64| Turn::new(BigRational::new(exponent.into(), n.into()));
    let parts = folded.into_iter().map(|(exponent, weight)| Form::cosine(half(weight), angle(exponent)));
    let form = parts.fold(Form::rational(BigRational::zero()), |form, part| form.plus(&part));
    (form.terms().len() <= MOST_COSINES).then_some(form)
}

/// Takes off polygons whose corners mostly have the same weight.
fn take_polygons_off(weights: &mut [i64], n: u64) {
    for prime in modulo::prime_divisors(n) {
        let step = (n / prime) as usize;
        for first in 0..step {
            let mut counts: BTreeMap<i64, usize> = BTreeMap::new();
            (first..weights.len()).step_by(step).for_each(|corner| *counts.entry(weights[corner]).or_default() += 1);
            let Some((common, _)) = counts.into_iter().max_by_key(|(_, count)| *count) else { continue };
            (first..weights.len()).step_by(step).for_each(|corner| weights[corner] -= common);
        }
    }
}

/// The cosine of an exponent by that of one in the first quarter.
fn fold(exponent: u64, weight: i64, n: u64) -> (u64, i64) {
    let upper = exponent.min(n - exponent);
    if 4 * upper > n { (n / 2 - upper, -weight) } else { (upper, weight) }
}
