//! What are the sums of an engine in numbers? Each coefficient of its motion is enclosed once.

use super::{Missing, Swing, Vector, scale};
use crate::engine::{Engine, Mechanism};
use crate::motion::Coefficient;
use crate::order::{self, Coefficients, Factor, OrderSum, exactly_one};
use crate::proof::Sense;

/// Forces from here on are refused: their sums and squares would leave the range of decimals.
const LARGEST: f64 = 1e150;

/// The motions of the cylinders, and the coefficients that were asked of them.
pub(super) struct Motion {
    /// The different ones.
    pub mechanisms: Vec<Mechanism>,
    /// Whether some crankshaft turns faster than the reference, whose coefficients are then those of other orders.
    pub has_faster: bool,
    coefficients: Coefficients,
}

impl Motion {
    pub fn new(engine: &Engine) -> Result<Self, Missing> {
        if scale(engine).is_some_and(|scale| !(scale.force() < LARGEST && scale.torque() < LARGEST)) {
            return Err(Missing::TooLarge);
        }
        let mechanisms: Vec<Mechanism> = engine.mechanisms().into_iter().cloned().collect();
        if mechanisms.is_empty() {
            return Err(Missing::Rods);
        }
        order::comparable(engine)?;
        let has_faster = engine.faster_crank().is_some();
        Ok(Motion { mechanisms, has_faster, coefficients: Coefficients::default() })
    }

    /// The value of a factor: computed, and counted, once.
    pub fn coefficient(&self, factor: &Factor, order: u32) -> Coefficient {
        match self.coefficients.of(factor, order) {
            Some(coefficient) => coefficient,
            None => unreachable!("loads need an engine with given rods"),
        }
    }

    /// How many coefficients were computed.
    pub fn computed(&self) -> usize {
        self.coefficients.computed()
    }

    pub fn vector(&self, sum: &OrderSum, order: u32, sense: Sense) -> Vector {
        Vector::new(sum, |factor| match self.coefficients.in_sense(factor, order, Some(sense)) {
            Some(coefficient) => coefficient,
            None => unreachable!("loads need an engine with given rods"),
        })
    }

    /// What the two sums of an order trace.
    pub fn swing(&self, [direct, reverse]: [OrderSum; 2], order: u32) -> Swing {
        let vectors = [self.vector(&direct, order, Sense::Direct), self.vector(&reverse, order, Sense::Reverse)];
        Swing::new(vectors, [&direct, &reverse], order)
    }

    /// The coefficient that all cylinders have in common, where a vector asked for it.
    pub fn common(&self, order: u32) -> Option<Coefficient> {
        if self.has_faster {
            return None;
        }
        let [mechanism] = &self.mechanisms[..] else { return None };
        let (factor, sign) = Factor::of_rod(Some(mechanism.rod()?), order);
        if !factor.exists(order) {
            return None;
        }
        if factor == Factor::One {
            return Some(exactly_one());
        }
        let known = self.coefficients.known(&factor, order)?;
        Some(Coefficient { re: known.re.times(&sign), im: known.im.times(&sign) })
    }
}
