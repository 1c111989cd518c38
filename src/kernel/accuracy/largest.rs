//! What is the largest force, moment and inertia torque of the exact motion, and how sure is that?
//!
//! The orders are summed until a bound of those above them is small beside the peak: what cancels between the cylinders cancels
//! exactly there, so that the smallest of peaks is found. Where the orders fall slowly, λ + |δ| near 1, nothing cancels for long, and the closed
//! form of the motion is searched in intervals.

use super::branch::Search;
use super::interval::Interval;
use crate::engine::Engine;
use crate::loads::{self, Missing, Spectrum};
use crate::order::{TurningMass, turning_masses};
use crate::proof::Quantity;

/// The orders that are summed, step by step.
const SUMMED: [u32; 6] = [8, 16, 32, 64, 128, 256];
/// Where this many orders do not do, the closed form is searched.
const ENOUGH: u32 = 64;
/// A largest value is known to this part of itself, unless its error says otherwise.
pub const SURE: f64 = 5e-4;
/// Spans that a search may look at.
const MOST_SPANS: usize = 4000;

/// The largest value of a load in a revolution, over all orders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Largest {
    /// Zero at every order, proved.
    Zero,
    /// Known, in multiples of m r ω², that times the unit of the positions, or m r² ω².
    Known {
        /// Zero to peak.
        value: f64,
        /// Crank angle in degrees where it is; none where the length never changes.
        angle: Option<f64>,
        /// Guaranteed: the value is off by at most this.
        error: f64,
    },
    /// Not known, and not proved to be zero, but no more than this.
    Below(f64),
}

impl Largest {
    /// Whether it is as sure as it should be.
    fn is_sure(&self) -> bool {
        match self {
            Largest::Zero => true,
            Largest::Known { value, error, .. } => *error <= SURE * value,
            Largest::Below(_) => false,
        }
    }

    fn at_most(&self) -> f64 {
        match self {
            Largest::Zero => 0.0,
            Largest::Known { value, error, .. } => value + error,
            Largest::Below(bound) => *bound,
        }
    }

    fn of(value: f64, angle: Option<f64>, error: f64) -> Self {
        if value > error { Largest::Known { value, angle, error } } else { Largest::Below((value + error).next_up()) }
    }

    /// The surer of two.
    fn or(self, other: Largest) -> Largest {
        let doubt = |largest: &Largest| match largest {
            Largest::Zero => 0.0,
            Largest::Known { error, .. } => *error,
            Largest::Below(bound) => *bound,
        };
        if doubt(&other) < doubt(&self) { other } else { self }
    }
}

/// The largest values of an engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestLoads {
    /// The shaking force.
    pub force: Largest,
    /// Its moment about the reference plane.
    pub moment: Largest,
    /// The inertia torque, where the file asks for it.
    pub torque: Option<Largest>,
}

impl LargestLoads {
    /// Of force and moment, and of the inertia torque where the file asks for it.
    ///
    /// # Errors
    /// What the engine lacks for numbers.
    pub fn new(engine: &Engine) -> Result<Self, Missing> {
        Ok(LargestLoads {
            force: largest(engine, Quantity::FORCE)?,
            moment: largest(engine, Quantity::MOMENT)?,
            torque: engine.effects().torque.then(|| largest(engine, Quantity::TORQUE)).transpose()?,
        })
    }
}

/// The largest value of a load of the exact motion, within [`SURE`] of itself or as near as it was found.
///
/// # Errors
/// What the engine lacks for numbers.
pub fn largest(engine: &Engine, quantity: Quantity) -> Result<Largest, Missing> {
    let mut spectrum = Spectrum::new(engine)?;
    if loads::vanishes_at_every_order(engine, quantity) {
        return Ok(Largest::Zero);
    }
    let (mut best, mut searched) = (Largest::Below(f64::INFINITY), false);
    for highest in SUMMED {
        spectrum.raise(highest, quantity == Quantity::TORQUE);
        best = best.or(of_orders(&spectrum, quantity));
        // Where the orders fall slowly it is searched at once, before many of them are computed.
        let slow = spectrum.rest_above(quantity, ENOUGH) > SURE * best.at_most() && best.at_most().is_finite();
        if (slow || highest == ENOUGH) && !searched && !best.is_sure() && turns_as_one(engine) {
            best = best.or(of_motion(engine, quantity));
            searched = true;
        }
        if best.is_sure() {
            break;
        }
    }
    Ok(best)
}

/// Whether all that moves does so by the angle of one crank, which the closed form knows.
fn turns_as_one(engine: &Engine) -> bool {
    engine.crankshaft().balancers.is_empty()
        && engine.faster_crank().is_none()
        && turning_masses(engine).iter().all(TurningMass::turns_with_the_crank)
}

fn of_orders(spectrum: &Spectrum, quantity: Quantity) -> Largest {
    let peak = spectrum.waveform(quantity).peak_of(quantity);
    Largest::of(peak.value, peak.angle, spectrum.rest(quantity) + spectrum.doubt(quantity))
}

/// By intervals over the closed form.
fn of_motion(engine: &Engine, quantity: Quantity) -> Largest {
    let found = Search::new(engine, quantity).run(SURE, MOST_SPANS);
    let ends = Interval { low: found.low.sqrt().next_down(), high: found.high.sqrt().next_up() };
    let highest = found.spans.iter().max_by(|a, b| a.bound.total_cmp(&b.bound));
    let angle = highest.map(|span| (span.from + (span.to - span.from) / 2.0) * 360.0);
    Largest::of(f64::midpoint(ends.low, ends.high), angle, (ends.high - ends.low) / 2.0)
}
