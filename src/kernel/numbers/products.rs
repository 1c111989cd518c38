//! Is a length a root times one or two cosines? `q√d cos t cos u`: so Q over the squared cosines is rational, in each conjugate.

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::budget::Budget;
use super::form::Form;
use super::quadratic::NEAR;
use crate::exact::{Turn, modulo};

/// Pairs of cosines are looked for up to this conductor.
const LARGEST_FOR_PAIRS: u64 = 800;
/// More agreeing pairs than this are not gone through.
const MOST_PAIRS: usize = 4;

/// Lengths whose squares have these conjugates, the plainest first, to be tested exactly.
pub(super) struct Products<'a> {
    pub values: &'a [f64],
    pub units: &'a [u64],
    pub conductor: u64,
}

impl Products<'_> {
    /// `q√d cos(2πt)`, t in (0, ¼) over twice the conductor.
    pub fn of_one(&self, budget: &mut Budget) -> Vec<Form> {
        let all = 1..self.conductor / 2;
        if !budget.weigh(all.clone().count()) {
            return Vec::new();
        }
        all.filter_map(|j| self.form(&[j])).collect()
    }

    /// `q√d cos(2πt) cos(2πu)`, t and u without those of a rational or quadratic square.
    pub fn of_two(&self, budget: &mut Budget) -> Vec<Form> {
        let all: Vec<u64> = (1..self.conductor / 2).filter(|j| 12 * j % self.conductor != 0).collect();
        let Some(other) = self.other() else { return Vec::new() };
        if self.conductor > LARGEST_FOR_PAIRS || !budget.weigh(all.len() * (all.len() + 1) / 2) {
            return Vec::new();
        }
        // Only pairs for which the quotient of two conjugates is right need a closer look.
        let quotient = self.values[other] / self.values[0];
        let quotients: Vec<f64> = all.iter().map(|&j| self.square(j, other) / self.square(j, 0)).collect();
        let mut forms = Vec::new();
        for (place, &j) in all.iter().enumerate() {
            for (&k, second) in all[place..].iter().zip(&quotients[place..]) {
                if (quotients[place] * second / quotient - 1.0).abs() < NEAR {
                    forms.extend(self.form(&[j, k]));
                }
            }
            if forms.len() >= MOST_PAIRS {
                break;
            }
        }
        forms
    }

    /// A map that changes the number.
    fn other(&self) -> Option<usize> {
        let first = self.values[0];
        (1..self.values.len()).find(|&place| (self.values[place] / first - 1.0).abs() > 1e-6)
    }

    /// `cos²(2πt)` with `t = j/2N`, under one of the maps: `½(1 + cos(2πaj/N))`.
    fn square(&self, j: u64, place: usize) -> f64 {
        let exponent = j * self.units[place] % self.conductor;
        let cosine = (std::f64::consts::TAU * exponent as f64 / self.conductor as f64).cos();
        (1.0 + cosine) / 2.0
    }

    /// The form with these cosines, where all conjugates agree.
    fn form(&self, cosines: &[u64]) -> Option<Form> {
        let quotient =
            |place: usize| self.values[place] / cosines.iter().map(|&j| self.square(j, place)).product::<f64>();
        let first = quotient(0);
        let agree = (1..self.values.len()).all(|place| (quotient(place) / first - 1.0).abs() < NEAR.sqrt() / 10.0);
        if !agree {
            return None;
        }
        // Four times a squared cosine divides a prime of the conductor, so these denominators suffice.
        let radical: u64 = modulo::prime_divisors(self.conductor).iter().product();
        let denominator = radical.checked_pow(u32::try_from(cosines.len()).ok()?)?;
        let whole = (first * denominator as f64).round().to_i64()?;
        let square = Form::rational(BigRational::new(whole.into(), denominator.into()));
        let angle = |j: &u64| Turn::new(BigRational::new((*j).into(), (2 * self.conductor).into()));
        cosines.iter().try_fold(square.square_root(), |form, j| form.times(&Form::cosine(BigRational::one(), angle(j))))
    }
}
