//! Is a star two equal stars, one turned? As the two banks of a V are: `S = (1 ± e(c))·M` and `|S| = |M|·2|cos|`.
//!
//! The division is one of sums of turns, term by term, and so proves itself.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::One;

use super::budget::Budget;
use super::form::Form;
use super::star::Star;
use crate::exact::Turn;

/// The star of one bank and the length of the bank factor.
pub(super) fn split(star: &Star, budget: &mut Budget) -> Option<(Star, Form)> {
    let half = star.conductor / 2;
    // Opposite directions are one direction with a sign.
    let mut signed: BTreeMap<u64, i64> = BTreeMap::new();
    for &(exponent, weight) in &star.terms {
        *signed.entry(exponent % half).or_insert(0) += if exponent < half { weight } else { -weight };
    }
    signed.retain(|_, weight| *weight != 0);
    let first = *signed.keys().next()?;
    for &other in signed.keys().skip(1) {
        for sign in [1, -1] {
            if !budget.weigh(2 * signed.len()) {
                return None;
            }
            let Some(bank) = divided(&signed, other - first, sign, half) else { continue };
            // |1 + e(c)| = 2 |cos ½c|; −e(c) is e(c + ½).
            let turn = if sign == 1 { other - first } else { other - first + half };
            let angle = Turn::new(BigRational::new(turn.into(), (2 * star.conductor).into()));
            let factor = Form::cosine(BigRational::from_integer(2.into()), angle);
            let factor = if factor.to_float() < 0.0 { factor.scaled(&-BigRational::one()) } else { factor };
            return Some((Star { conductor: star.conductor, unit: star.unit.clone(), terms: bank }, factor));
        }
    }
    None
}

/// `M` with `S = (1 + sign·e(step)) M`, where it has fewer terms than S.
fn divided(signed: &BTreeMap<u64, i64>, step: u64, sign: i64, half: u64) -> Option<Vec<(u64, i64)>> {
    let at = |exponent: u64| {
        let weight = signed.get(&(exponent % half)).copied().unwrap_or(0);
        if exponent % (2 * half) < half { weight } else { -weight }
    };
    let mut bank: BTreeMap<u64, i64> = BTreeMap::new();
    let mut steps = 0;
    // A chain starts at a vector with none a step before it.
    for &start in signed.keys().filter(|&&exponent| at(exponent + 2 * half - step) == 0) {
        let (mut exponent, mut left) = (start, at(start));
        while left != 0 {
            steps += 1;
            if steps > 2 * signed.len() {
                return None;
            }
            let folded = if exponent % (2 * half) < half { left } else { -left };
            *bank.entry(exponent % half).or_insert(0) += folded;
            exponent += step;
            left = at(exponent) - sign * left;
        }
    }
    let bank: Vec<(u64, i64)> = bank.into_iter().filter(|(_, weight)| *weight != 0).collect();
    // Multiplied out again it must be the whole star: chains without a start are not in it.
    let mut product: BTreeMap<u64, i64> = BTreeMap::new();
    for &(exponent, weight) in &bank {
        for (exponent, weight) in [(exponent, weight), (exponent + step, sign * weight)] {
            *product.entry(exponent % half).or_insert(0) += if exponent % (2 * half) < half { weight } else { -weight };
        }
    }
    product.retain(|_, weight| *weight != 0);
    (product == *signed && bank.len() < signed.len()).then_some(bank)
}
