//! What is an engine for its remedies? Sums that can be compared; its rods may be unknown, then c_k stays a symbol.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::loads::{self, Missing};
use crate::numbers;
use crate::order::{self, Coefficients, Factor, OrderSum};
use crate::proof::Sense;

/// An engine whose masses can be compared.
#[derive(Clone, Debug)]
pub struct ComparableEngine {
    engine: Engine,
}

impl ComparableEngine {
    /// The engine of this layout.
    ///
    /// # Errors
    /// What the layout lacks for its masses to be compared.
    pub fn new(engine: &Engine) -> Result<Self, Missing> {
        order::comparable(engine).map_err(loads::Missing::from)?;
        Ok(ComparableEngine { engine: engine.clone() })
    }

    /// The layout.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// The force of one order and sense.
    pub fn force(&self, order: u32, sense: Sense) -> OrderSum {
        self.weighed(order, sense, |_| BigRational::one())
    }

    /// Its moment about position 0.
    pub fn moment(&self, order: u32, sense: Sense) -> OrderSum {
        self.weighed(order, sense, BigRational::clone)
    }

    fn weighed(&self, order: u32, sense: Sense, weighing: impl Fn(&BigRational) -> BigRational) -> OrderSum {
        OrderSum::new(order::contributions(&self.engine, order, sense).iter().map(|one| one.weighed(&weighing)))
    }

    /// A vector in multiples of m r; `None` where its coefficient is not known.
    pub fn value(&self, sum: &OrderSum, order: u32, sense: Sense) -> Option<Complex<f64>> {
        let coefficients = Coefficients::default();
        let term = |(factor, sum): (&Factor, &PhasorSum)| {
            let coefficient = coefficients.in_sense(factor, order, Some(sense))?;
            Some(coefficient.to_complex() * numbers::evaluate(sum))
        };
        sum.parts().iter().map(term).sum()
    }

    /// m r in kilogram-metres, and r in metres; `None` where the layout does not give them.
    pub fn scale(&self) -> Option<[BigRational; 2]> {
        let radius = self.engine.dimensions().crank_radius.clone()?;
        self.engine.dimensions().mass.as_ref()?;
        Some([self.engine.unit_mass() * &radius, radius])
    }
}
