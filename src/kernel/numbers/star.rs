//! Which numbers are the conjugates of a sum? In decimals, all at once: from them closed forms are proposed.
//!
//! The maps `ζ_N ↦ ζ_N^a`, a prime to N, carry a sum to its conjugates. A form that is right is right for all of them.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_complex::Complex;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::budget::Budget;
use crate::exact::{IntegerSum, PhasorSum, Term, Turn, vanishes};

/// Closed forms are looked for up to this conductor.
const LARGEST_CONDUCTOR: u64 = 1000;
/// Larger weights leave too few digits of a float to propose anything.
const LARGEST_WEIGHT: u64 = 1 << 22;

/// `unit · Σ weight · e^{2πi·exponent/conductor}`: whole coprime weights, each exponent once, an even conductor.
#[derive(Clone, Debug)]
pub(super) struct Star {
    pub conductor: u64,
    pub unit: BigRational,
    pub terms: Vec<(u64, i64)>,
}

impl Star {
    /// The sum over the least even conductor; none above the largest conductor or weight.
    pub fn of(sum: &PhasorSum) -> Option<Star> {
        let whole = IntegerSum::collect(sum.terms());
        let (conductor, terms) = whole.in_machine_words()?;
        let common = terms.iter().fold(conductor, |common, (exponent, _)| common.gcd(exponent)).max(1);
        let conductor = conductor / common;
        // Before doubling: an odd conductor has the same field.
        if conductor > LARGEST_CONDUCTOR {
            return None;
        }
        let double = if conductor.is_odd() { 2 } else { 1 };
        let content = terms.iter().fold(0, |content: i64, (_, weight)| content.gcd(weight)).max(1);
        let terms: Vec<_> = terms.into_iter().map(|(e, w)| (e / common * double, w / content)).collect();
        let total: u64 = terms.iter().map(|(_, weight)| weight.unsigned_abs()).sum();
        let unit = BigRational::new(content.into(), whole.scale);
        (total <= LARGEST_WEIGHT).then_some(Star { conductor: conductor * double, unit, terms })
    }

    /// The same star turned so that its first vector points to 0, over the least even conductor for that.
    pub fn turned_to_first(&self) -> Star {
        let first = self.terms.first().map_or(0, |(exponent, _)| *exponent);
        let n = self.conductor;
        let exponents = || self.terms.iter().map(|(exponent, _)| (exponent + n - first) % n);
        let common = exponents().fold(n, |common, exponent| common.gcd(&exponent));
        let double = if (n / common).is_odd() { 2 } else { 1 };
        let mut terms: Vec<(u64, i64)> =
            exponents().map(|e| e / common * double).zip(self.terms.iter().map(|(_, weight)| *weight)).collect();
        terms.sort_unstable();
        Star { conductor: n / common * double, unit: self.unit.clone(), terms }
    }

    /// The same star over a conductor that 4 divides.
    pub fn over_fourths(self) -> Star {
        let factor = if self.conductor.is_multiple_of(4) { 1 } else { 2 };
        let terms = self.terms.into_iter().map(|(exponent, weight)| (exponent * factor, weight)).collect();
        Star { conductor: self.conductor * factor, unit: self.unit, terms }
    }

    /// The sum without its unit.
    pub fn to_sum(&self) -> PhasorSum {
        let term = |&(exponent, weight): &(u64, i64)| Term {
            angle: Turn::new(BigRational::new(exponent.into(), self.conductor.into())),
            weight: BigRational::from_integer(weight.into()),
        };
        PhasorSum::new(self.terms.iter().map(term).collect())
    }

    /// The numbers prime to the conductor, 1 first.
    pub fn units(&self) -> Vec<u64> {
        (1..=self.conductor).filter(|a| a.gcd(&self.conductor) == 1).collect()
    }

    /// The sum without its unit under each of the maps, in decimals.
    pub fn conjugates(&self) -> Vec<Complex<f64>> {
        let n = self.conductor;
        let step = std::f64::consts::TAU / n as f64;
        let table: Vec<Complex<f64>> = (0..n).map(|j| Complex::from_polar(1.0, step * j as f64)).collect();
        let image = |a: u64| self.terms.iter().map(|&(e, w)| table[(e * a % n) as usize] * w as f64).sum();
        self.units().into_iter().map(image).collect()
    }

    /// `|S|²` without its unit, over the same conductor.
    pub fn squared(&self) -> Star {
        let n = self.conductor;
        let unit = &self.unit * &self.unit;
        let conjugate: Vec<_> = self.terms.iter().map(|&(e, w)| ((n - e) % n, w)).collect();
        Star { conductor: n, unit, terms: product(n, &self.terms, &conjugate) }
    }

    /// Whether the sum without its unit is this number, given as a sum; one exact test.
    pub fn is(&self, number: &PhasorSum, budget: &mut Budget) -> bool {
        let difference = || self.minus(number);
        budget.test() && difference().is_some_and(|(conductor, terms)| vanishes(&conductor, &terms))
    }

    /// Whether `(S − middle)² = square`, without the unit; one exact test.
    pub fn is_from(&self, middle: &PhasorSum, square: &PhasorSum, budget: &mut Budget) -> bool {
        let decide = || {
            let (conductor, terms) = self.minus(middle)?;
            let whole: Option<Vec<(u64, i64)>> = terms.into_iter().map(|(e, w)| Some((e, w.to_i64()?))).collect();
            let scale = IntegerSum::collect(middle.terms()).scale;
            let unit = BigRational::new(BigInt::one(), &scale * &scale);
            let whole = collected(whole?);
            // Products of weights stay in words.
            let total: u64 = whole.iter().map(|(_, weight)| weight.unsigned_abs()).sum();
            let terms = (total < 1 << 31).then(|| product(conductor, &whole, &whole))?;
            let squared = Star { conductor, unit: BigRational::one(), terms };
            let (conductor, terms) = squared.minus(&square.scaled(&unit.recip()))?;
            Some(vanishes(&conductor, &terms))
        };
        budget.test() && decide().unwrap_or(false)
    }

    /// A whole multiple of `S − number` as exponents and weights over one conductor.
    fn minus(&self, number: &PhasorSum) -> Option<(u64, Vec<(u64, BigInt)>)> {
        let number = IntegerSum::collect(number.terms());
        let other = number.conductor.to_u64()?;
        let conductor = self.conductor.lcm(&other);
        let own = self.terms.iter().map(|(e, w)| (e * (conductor / self.conductor), &number.scale * *w));
        let theirs = number.terms.iter().filter_map(|(e, w)| Some((e.to_u64()? * (conductor / other), -w)));
        Some((conductor, own.chain(theirs).collect()))
    }
}

fn product(conductor: u64, one: &[(u64, i64)], other: &[(u64, i64)]) -> Vec<(u64, i64)> {
    let mut dense = vec![0_i64; conductor as usize];
    for (e, w) in one {
        for (f, v) in other {
            dense[((e + f) % conductor) as usize] += w * v;
        }
    }
    (0..conductor).zip(dense).filter(|(_, weight)| !weight.is_zero()).collect()
}

fn collected(terms: Vec<(u64, i64)>) -> Vec<(u64, i64)> {
    let mut by_exponent: BTreeMap<u64, i64> = BTreeMap::new();
    for (exponent, weight) in terms {
        *by_exponent.entry(exponent).or_insert(0) += weight;
    }
    by_exponent.into_iter().filter(|(_, weight)| *weight != 0).collect()
}
