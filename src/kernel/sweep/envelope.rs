//! What does an engine fit into? Length, breadth and height from a simple geometry, all of whose numbers are stated.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::engine::Engine;
use crate::loads::Arm;

/// The assumptions, as multiples of the crank radius r where nothing else is said.
#[derive(Clone, Debug, PartialEq)]
pub struct Geometry {
    /// Bore D; 2 is that of an engine whose bore is its stroke.
    pub bore: f64,
    /// Rod ratio where the engine names none.
    pub rod_ratio: f64,
    /// Half the width of a bank across its axis, in bores.
    pub half_width: f64,
    /// From the piston pin at top dead centre to the top of the bank, in bores.
    pub above_pin: f64,
    /// Radius of the crankcase.
    pub crankcase: f64,
    /// Distance of neighbouring cylinders of a bank where the engine gives no length, in bores.
    pub spacing: f64,
    /// Length beyond the centres of the outermost cylinders, both ends together, in bores.
    pub ends: f64,
}

impl Default for Geometry {
    fn default() -> Self {
        Geometry {
            bore: 2.0,
            rod_ratio: 0.25,
            half_width: 0.6,
            above_pin: 1.5,
            crankcase: 1.6,
            spacing: 1.2,
            ends: 1.2,
        }
    }
}

/// What an engine fits into, in multiples of the crank radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Envelope {
    /// Along the crankshaft; none where the positions are in metres and the crank radius is not known.
    pub length: Option<f64>,
    /// Across the reference direction.
    pub breadth: f64,
    /// Along it.
    pub height: f64,
    /// Metres per crank radius, where the engine gives it.
    pub metres: Option<f64>,
}

/// The box round an engine; none for one with cylinders of different strokes, and with links, whose tops lie elsewhere.
pub fn envelope(engine: &Engine, geometry: &Geometry) -> Option<Envelope> {
    let one = BigRational::from_integer(1.into());
    if engine.cylinders().iter().any(|cylinder| cylinder.crank_radius != one) {
        return None;
    }
    let bore = geometry.bore;
    let half = geometry.half_width * bore;
    let radius = geometry.crankcase;
    let (mut left, mut right, mut low, mut high) = (-radius, radius, -radius, radius);
    for cylinder in engine.cylinders() {
        let ratio = match &cylinder.mechanism {
            None => geometry.rod_ratio,
            Some(mechanism) => mechanism.rod()?.ratio.to_f64().unwrap_or(0.0),
        };
        if ratio <= 0.0 {
            return None;
        }
        let top = 1.0 + 1.0 / ratio + geometry.above_pin * bore;
        let (sin, cos) = (std::f64::consts::TAU * cylinder.bank.turns().to_f64()?).sin_cos();
        for (along, across) in [(top, half), (top, -half), (0.0, half), (0.0, -half)] {
            let (up, aside) = (along * cos - across * sin, along * sin + across * cos);
            (left, right) = (left.min(aside), right.max(aside));
            (low, high) = (low.min(up), high.max(up));
        }
    }
    let positions = || engine.cylinders().iter().map(|cylinder| &cylinder.position);
    let between = (positions().max()? - positions().min()?).to_f64()?;
    let metres =
        engine.dimensions().crank_radius.as_ref().filter(|radius| !radius.is_zero()).and_then(ToPrimitive::to_f64);
    let length = match (Arm::of(engine), metres) {
        (Arm::Spacing, _) => Some(between * geometry.spacing * bore),
        // All cylinders in one plane are so in any unit.
        (Arm::Metre, _) if between == 0.0 => Some(0.0),
        (Arm::Metre, metres) => metres.map(|metres| between / metres),
    };
    Some(Envelope {
        length: length.map(|length| length + geometry.ends * bore),
        breadth: right - left,
        height: high - low,
        metres,
    })
}
