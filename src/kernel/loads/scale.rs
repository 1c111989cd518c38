//! What turns multiples of m r ω² into newtons?

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::engine::{Engine, LengthUnit};
use crate::numbers;
use crate::proof::Quantity;
use crate::table::Unit;

/// What the multiples are multiples of.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// Mass m in kilograms.
    pub mass: BigRational,
    /// Crank radius r in metres.
    pub crank_radius: BigRational,
    /// Speed in revolutions a minute.
    pub speed: BigRational,
}

impl Scale {
    /// Angular speed ω in radians a second.
    pub fn omega(&self) -> f64 {
        numbers::angular_speed(self.speed.to_f64().unwrap_or(f64::INFINITY))
    }

    /// m r ω² in newtons.
    pub fn force(&self) -> f64 {
        (&self.mass * &self.crank_radius).to_f64().unwrap_or(f64::INFINITY) * self.omega() * self.omega()
    }

    /// Whether nothing moves, so that every load of the masses is 0.
    pub fn is_at_rest(&self) -> bool {
        self.force() == 0.0
    }

    /// m r² ω² in newton-metres.
    pub fn torque(&self) -> f64 {
        self.force() * self.crank_radius.to_f64().unwrap_or(f64::INFINITY)
    }
}

/// What the moments of a layout are counted in, besides the force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arm {
    /// Metres.
    Metre,
    /// The spacing a of the cylinders, which the file does not say.
    Spacing,
}

impl Arm {
    /// The unit of the positions of a layout: a file that gives them without a unit gives metres.
    pub fn of(engine: &Engine) -> Self {
        let known = engine.positions_given() || engine.length_unit() == LengthUnit::Metre;
        if known { Arm::Metre } else { Arm::Spacing }
    }
}

/// What turns the multiples of a layout into newtons; none where mass, crank radius or speed is missing.
pub fn scale(engine: &Engine) -> Option<Scale> {
    let mechanism = engine.dimensions();
    Some(Scale {
        mass: mechanism.mass.as_ref().map(|_| engine.unit_mass())?,
        crank_radius: mechanism.crank_radius.clone()?,
        speed: mechanism.speed.clone()?,
    })
}

/// What forces, moments or torques of a layout are counted in: newtons where the scale is known, else multiples.
pub fn unit(engine: &Engine, scale: Option<&Scale>, quantity: impl Into<Quantity>) -> Unit {
    match (scale, quantity.into(), Arm::of(engine)) {
        (Some(_), Quantity::FORCE, _) => Unit::NEWTON,
        (Some(_), Quantity::MOMENT, Arm::Spacing) => Unit::NEWTON_SPACING,
        (Some(_), Quantity::MOMENT, Arm::Metre) | (Some(_), Quantity::Axial(_), _) => Unit::NEWTON_METRE,
        (None, Quantity::FORCE, _) => Unit::MULTIPLE,
        (None, Quantity::MOMENT, Arm::Spacing) => Unit::MULTIPLE_SPACING,
        (None, Quantity::MOMENT, Arm::Metre) => Unit::MULTIPLE_METRE,
        (None, Quantity::Axial(_), _) => Unit::TORQUE_MULTIPLE,
    }
}
