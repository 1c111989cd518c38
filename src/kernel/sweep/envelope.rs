//! What does an engine fit into? Length, breadth and height from a simple geometry, all of whose numbers are stated.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::engine::{Engine, GearedCrank};
use crate::exact::Term;
use crate::loads::Arm;
use crate::proof::Sense;

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

/// The box round an engine; none for one with cylinders of different strokes, with links, whose tops lie elsewhere, and with crankshafts
/// of which the layout does not say where they are.
pub fn envelope(engine: &Engine, geometry: &Geometry) -> Option<Envelope> {
    let one = BigRational::from_integer(1.into());
    if engine.cylinders().iter().any(|cylinder| cylinder.crank_radius != one) {
        return None;
    }
    let bore = geometry.bore;
    let half = geometry.half_width * bore;
    let axes = axes(engine)?;
    let mut corners = Vec::new();
    for axis in &axes {
        let radius = geometry.crankcase;
        corners.extend([Complex::new(radius, radius), Complex::new(-radius, -radius)].map(|corner| axis + corner));
    }
    for cylinder in engine.cylinders() {
        let (ratio, offset) = match &cylinder.mechanism {
            None => (geometry.rod_ratio, 0.0),
            Some(mechanism) => {
                let rod = mechanism.rod()?;
                (rod.ratio.to_f64()?, rod.offset.to_f64()?)
            }
        };
        if ratio <= 0.0 {
            return None;
        }
        let length = 1.0 / ratio;
        // The rod of a crank that turns the other way is that of the equivalent crank, which lies on the other side.
        let side = if engine.sense_of(cylinder) == Sense::Direct { 1.0 } else { -1.0 };
        let aside = offset * length * side;
        let pin = ((1.0 + length).powi(2) - aside * aside).max(0.0).sqrt();
        let top = pin + geometry.above_pin * bore;
        let shaft = axes.get(cylinder.crank)?;
        let along = Complex::cis(std::f64::consts::TAU * cylinder.bank.turns().to_f64()?);
        let bank = [(top, half), (top, -half), (0.0, half), (0.0, -half)];
        corners.extend(bank.map(|(up, across)| shaft + along * Complex::new(up, aside + across)));
    }
    // The reference direction is the real one.
    let side = |part: fn(&Complex<f64>) -> f64| {
        let parts = || corners.iter().map(part);
        parts().fold(f64::NEG_INFINITY, f64::max) - parts().fold(f64::INFINITY, f64::min)
    };
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
        breadth: side(|corner| corner.im),
        height: side(|corner| corner.re),
        metres,
    })
}

/// Where the axes of the crankshafts are, in crank radii: one in the middle where there is one; none where the layout omits it.
fn axes(engine: &Engine) -> Option<Vec<Complex<f64>>> {
    let at = |term: &Term| {
        let direction = Complex::cis(std::f64::consts::TAU * term.angle.turns().to_f64()?);
        Some(direction * term.weight.to_f64()?)
    };
    let axis = |crank: &GearedCrank| match crank.left_out {
        Some(_) => None,
        None => crank.axis.iter().map(at).sum(),
    };
    let axes: Option<Vec<Complex<f64>>> = engine.geared_cranks().iter().map(axis).collect();
    axes.map(|axes| if axes.is_empty() { vec![Complex::default()] } else { axes })
}
