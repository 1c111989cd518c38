//! What is a remedy made of? Weights that turn, each at a multiple of the crank speed.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::comparable_engine::ComparableEngine;
use crate::exact::Turn;
use crate::numbers::{self, Direction, Form};
use crate::order::OrderSum;
use crate::proof::Sense;

/// A weight on the crankshaft (order 1, direct) or on a balancer shaft.
#[derive(Clone, Debug, PartialEq)]
pub struct Weight {
    /// How many times it turns in a revolution of the crankshaft.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Where it stands along the crankshaft, in the unit of the positions.
    pub position: BigRational,
    /// `U e^{iγ}`: its mass-radius in multiples of m r, in its direction at θ = 0.
    pub vector: OrderSum,
}

impl Weight {
    /// What it adds to the vector of its order and sense: `2n²U e^{iγ}` (theory, section 3).
    pub fn adds(&self) -> OrderSum {
        self.vector.scaled(&doubled_square(self.order))
    }

    /// The length U in closed form, in multiples of m r, or of m r |c_k| where one sum is multiplied by c_k.
    pub fn modulus(&self) -> Option<Form> {
        match self.vector.only() {
            Some((_, sum)) => numbers::modulus(sum),
            None => self.vector.vanishes().then(|| Form::rational(BigRational::zero())),
        }
    }

    /// Its direction γ at θ = 0 in closed form; `None` where it is none, or where a coefficient that is not real turns it.
    pub fn direction(&self) -> Option<Direction> {
        let (factor, sum) = self.vector.only()?;
        let half = || sum.turned(&Turn::fraction(1, 2));
        if factor.is_negative(self.order)? { numbers::direction_of(&half()) } else { numbers::direction_of(sum) }
    }

    /// U in multiples of m r and γ in degrees, in decimals; `None` where c_k is not known.
    pub fn decimals(&self, subject: &ComparableEngine) -> Option<[f64; 2]> {
        let value = subject.value(&self.vector, self.order, self.sense)?;
        Some([value.norm(), numbers::degrees(value)])
    }

    /// U in kilogram-metres; `None` where the layout gives no numbers.
    pub fn mass_radius(&self, subject: &ComparableEngine) -> Option<f64> {
        let [unit, _] = subject.scale()?;
        Some(self.decimals(subject)?[0] * unit.to_f64()?)
    }

    /// Whether it turns with the crankshaft at its speed.
    pub fn is_on_the_crank(&self) -> bool {
        (self.order, self.sense) == (1, Sense::Direct)
    }

    /// Its mass in kilograms at the crank radius; `None` where the layout gives no numbers.
    pub fn mass_at_crank_radius(&self, subject: &ComparableEngine) -> Option<f64> {
        let [_, radius] = subject.scale()?;
        Some(self.mass_radius(subject)? / radius.to_f64()?)
    }
}

/// `2n²`.
pub(super) fn doubled_square(order: u32) -> BigRational {
    let order = u64::from(order);
    BigRational::from_integer((2 * order * order).into())
}
