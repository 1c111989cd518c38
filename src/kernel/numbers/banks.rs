//! Is a star the star of one bank, two or three times, each turned? As in a V, `S = (1 ± e(c))·M`, and in a W, `S = (1 ± e(c) + e(2c))·M`.
//!
//! So `|S| = |M|·2|cos|`, or with two cosines, as `1 + 2 cos x = 4 cos(½x + 30°) cos(½x − 30°)` and `2 cos x − 1 = 4 cos(½x + 60°) cos(½x − 60°)`; and the
//! direction is that of M and a rational turn. The division is one of sums of turns, term by term, and so proves itself.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::One;

use super::budget::Budget;
use super::form::Form;
use super::star::Star;
use crate::exact::Turn;

/// A star taken apart.
pub(super) struct Split {
    /// The star of one bank.
    pub bank: Star,
    /// The length of the bank factor.
    pub factor: Form,
    /// The direction of the bank factor.
    pub turn: Turn,
}

/// The bank factors that are looked for: two banks first.
const FACTORS: [&[&[i64]]; 2] = [&[&[1, 1], &[1, -1]], &[&[1, 1, 1], &[1, -1, 1]]];

/// The star as a product, where it is one within the budget.
pub(super) fn split(star: &Star, budget: &mut Budget) -> Option<Split> {
    let half = star.conductor / 2;
    // Opposite directions are one direction with a sign.
    let mut signed: BTreeMap<u64, i64> = BTreeMap::new();
    for &(exponent, weight) in &star.terms {
        *signed.entry(exponent % half).or_insert(0) += if exponent < half { weight } else { -weight };
    }
    signed.retain(|_, weight| *weight != 0);
    let first = *signed.keys().next()?;
    for factors in FACTORS {
        for &other in signed.keys().skip(1) {
            for factor in factors {
                if !budget.weigh(2 * signed.len()) {
                    return None;
                }
                let step = other - first;
                let Some(bank) = divided(&signed, step, factor, half) else { continue };
                let bank = Star { conductor: star.conductor, unit: star.unit.clone(), terms: bank };
                let (length, turn) = of_factor(factor, step, star.conductor)?;
                let is_opposite = length.to_float() < 0.0;
                let factor = if is_opposite { length.scaled(&-BigRational::one()) } else { length };
                return Some(Split { bank, factor, turn: if is_opposite { turn.opposite() } else { turn } });
            }
        }
    }
    None
}

/// A bank factor as a real number times a turn.
fn of_factor(factor: &[i64], step: u64, conductor: u64) -> Option<(Form, Turn)> {
    let part = |numerator: u64, denominator: u64| Turn::new(BigRational::new(numerator.into(), denominator.into()));
    let (half, number) = (part(step, 2 * conductor), |whole: i64| BigRational::from_integer(whole.into()));
    match factor {
        // |1 + e(c)| = 2 |cos ½c|; −e(c) is e(c + ½).
        [_, sign] => {
            let angle = if *sign == 1 { half } else { &half + &Turn::fraction(1, 4) };
            Some((Form::cosine(number(2), angle.clone()), angle))
        }
        [_, sign, ..] => {
            let off = if *sign == 1 { Turn::fraction(1, 12) } else { Turn::fraction(1, 6) };
            let [more, less] = [&half + &off, &half - &off].map(|angle| Form::cosine(BigRational::one(), angle));
            Some((more.times(&less)?.scaled(&number(4)), part(step, conductor)))
        }
        [] | [_] => None,
    }
}

/// `M` with `S = Σ factor_j e(j·step) M`, where it has fewer terms than S.
fn divided(signed: &BTreeMap<u64, i64>, step: u64, factor: &[i64], half: u64) -> Option<Vec<(u64, i64)>> {
    let at = |exponent: u64| {
        let weight = signed.get(&(exponent % half)).copied().unwrap_or(0);
        if exponent % (2 * half) < half { weight } else { -weight }
    };
    let reach = factor.len() as u64 - 1;
    let mut bank: BTreeMap<u64, i64> = BTreeMap::new();
    let mut steps = 0;
    // A chain starts at a vector with none a step before it.
    let starts = |exponent: &&u64| (1..=reach).all(|back| at(**exponent + back * (2 * half - step)) == 0);
    for &start in signed.keys().filter(starts) {
        let mut exponent = start;
        // The last vectors of the bank, the nearest first.
        let mut last = vec![0; factor.len() - 1];
        loop {
            let known: i64 = last.iter().zip(&factor[1..]).map(|(weight, part)| weight * part).sum();
            let left = at(exponent) - known;
            last.rotate_right(1);
            last[0] = left;
            if last.iter().all(|weight| *weight == 0) {
                break;
            }
            steps += 1;
            if steps > 3 * signed.len() {
                return None;
            }
            *bank.entry(exponent % half).or_insert(0) += if exponent % (2 * half) < half { left } else { -left };
            exponent += step;
        }
    }
    let bank: Vec<(u64, i64)> = bank.into_iter().filter(|(_, weight)| *weight != 0).collect();
    // Multiplied out again it must be the whole star: chains without a start are not in it.
    let mut product: BTreeMap<u64, i64> = BTreeMap::new();
    for &(exponent, weight) in &bank {
        for (exponent, part) in (exponent..).step_by(usize::try_from(step).ok()?).zip(factor) {
            let weight = weight * part;
            *product.entry(exponent % half).or_insert(0) += if exponent % (2 * half) < half { weight } else { -weight };
        }
    }
    product.retain(|_, weight| *weight != 0);
    (product == *signed && bank.len() < signed.len()).then_some(bank)
}
