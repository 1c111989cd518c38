//! How long is a rotating vector, where does it point, and is it zero?

use num_complex::Complex;
use num_traits::ToPrimitive;

use crate::exact::PhasorSum;
use crate::motion::{Coefficient, Enclosure};
use crate::numbers;
use crate::order::{Factor, OrderSum};

/// What is known of a vector that is a sum of several coefficients times exact sums.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Zero, proved: each of its exact sums vanishes.
    Zero,
    /// Not zero, proved: one exact sum with a coefficient that is not zero, or an enclosure that excludes zero.
    NotZero,
    /// Not zero by its decimals, which are farther from it than their roundings: computed, not proved.
    Computed,
    /// Only the coefficients could make it cancel, and they do so to this length, in the unit of the vector.
    Undecided {
        /// The vector is shorter than this.
        below: f64,
    },
}

impl Outcome {
    /// Whether it is proved to be zero; none where that is not decided.
    pub fn vanishes(&self) -> Option<bool> {
        match self {
            Outcome::Zero => Some(true),
            Outcome::NotZero => Some(false),
            Outcome::Computed | Outcome::Undecided { .. } => None,
        }
    }
}

/// A rotating vector: `Σ coefficient · sum`.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Decimal value; zero where it is proved to be.
    pub value: Complex<f64>,
    /// Whether it is zero.
    pub outcome: Outcome,
    /// How far the value may be off, besides its roundings.
    doubt: f64,
}

impl Vector {
    /// The vector of this sum, whose coefficients `coefficient` tells.
    pub(super) fn new(sum: &OrderSum, coefficient: impl Fn(&Factor) -> Coefficient) -> Self {
        let nonzero = !sum.parts().keys().any(Factor::may_be_zero);
        let pairs: Vec<_> = sum.parts().iter().map(|(factor, sum)| (coefficient(factor), sum)).collect();
        let vector = Self::of(&pairs, nonzero);
        // Decimals prove nothing.
        match vector.outcome == Outcome::NotZero && sum.parts().keys().any(Factor::is_decimal) {
            true => Vector { outcome: Outcome::Computed, ..vector },
            false => vector,
        }
    }

    /// The vector `Σ coefficient · sum` of sums that do not vanish.
    ///
    /// `nonzero` says that no coefficient is zero, by theorem; else that is read from their enclosures.
    pub(super) fn of(pairs: &[(Coefficient, &PhasorSum)], nonzero: bool) -> Self {
        match pairs {
            [] => Vector { value: Complex::new(0.0, 0.0), outcome: Outcome::Zero, doubt: 0.0 },
            [(c, sum)] if nonzero || excludes_zero(&[c.re.clone(), c.im.clone()]) => {
                Vector { value: c.to_complex() * numbers::evaluate(sum), outcome: Outcome::NotZero, doubt: 0.0 }
            }
            _ => enclosed(pairs),
        }
    }

    /// Whether it is proved to be zero.
    pub fn vanishes(&self) -> bool {
        self.outcome == Outcome::Zero
    }

    /// How far the decimals may be off, besides their roundings.
    pub fn doubt(&self) -> f64 {
        self.doubt
    }
}

fn enclosed(pairs: &[(Coefficient, &PhasorSum)]) -> Vector {
    let total = numbers::enclose_weighted(pairs.iter().map(|(coefficient, sum)| (coefficient.clone(), *sum)));
    let largest = |part: &Enclosure| part.largest().to_f64().unwrap_or(f64::INFINITY);
    let width = |part: &Enclosure| part.width().to_f64().unwrap_or(f64::INFINITY);
    let [re, im] = &total;
    let is_not_zero = excludes_zero(&total);
    // Beside a part that is not zero, one that may be zero is taken as zero: its middle is nothing but roundings.
    let float = |part: &Enclosure| if is_not_zero && part.contains_zero() { 0.0 } else { part.to_float() };
    let (outcome, doubt) = match is_not_zero {
        true => (Outcome::NotZero, width(re).hypot(width(im)).next_up()),
        false => {
            let below = largest(re).hypot(largest(im)).next_up();
            (Outcome::Undecided { below }, 2.0 * below)
        }
    };
    Vector { value: Complex::new(float(re), float(im)), outcome, doubt }
}

fn excludes_zero(parts: &[Enclosure; 2]) -> bool {
    !parts.iter().all(Enclosure::contains_zero)
}
