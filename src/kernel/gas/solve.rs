//! How much heat does a cycle release that is described by a pressure?

use super::error::NoGas;
use super::geometry::Geometry;
use super::law::Law;
use crate::engine::{Cycle, Heat, IdealCycle};
use crate::motion::float;

/// A bar in pascals.
const BAR: f64 = 1e5;
/// Steps of Newton's method: each doubles the digits.
const STEPS: usize = 100;

/// The law of an ideal cycle, and the heat that it releases in joules.
pub(super) fn cycle(ideal: &IdealCycle, geometry: &Geometry, cycle: Cycle, zero: f64) -> Result<(Law, f64), NoGas> {
    let law = |heat: f64| Law::cycle(ideal, geometry, cycle, zero, heat);
    let heat = match &ideal.heat {
        Heat::Released(heat) => float(heat),
        Heat::MeanPressure(wanted) => {
            // Every pressure is linear in the heat, and so is the work.
            let mean = |heat: f64| law(heat).work(geometry) / geometry.swept();
            let unit = float(wanted) * geometry.swept();
            let (without, with) = (mean(0.0), mean(unit));
            let heat = (float(wanted) - without) / (with - without) * unit;
            if heat.is_nan() || heat < 0.0 {
                return Err(NoGas::Mean(float(wanted) / BAR, without / BAR));
            }
            heat
        }
        Heat::PeakPressure(wanted) => with_peak(float(wanted), geometry, law)?,
    };
    Ok((law(heat), heat))
}

/// The highest pressure is a convex function of the heat, for it is that of lines: Newton's method comes to it from above.
fn with_peak(wanted: f64, geometry: &Geometry, law: impl Fn(f64) -> Law) -> Result<f64, NoGas> {
    let cold = law(0.0);
    let (lowest, _) = cold.peak(geometry);
    if wanted <= lowest {
        return Err(NoGas::Peak(wanted / BAR, lowest / BAR));
    }
    let pressure = |law: &Law, psi: f64| {
        let (piece, psi) = law.at(psi);
        piece.pressure(geometry, psi)
    };
    let mut heat = wanted * geometry.swept() * 100.0;
    for _ in 0..STEPS {
        let hot = law(heat);
        let (peak, psi) = hot.peak(geometry);
        let slope = (peak - pressure(&cold, psi)) / heat;
        let next = heat - (peak - wanted) / slope;
        if !(next.is_finite() && next > 0.0) {
            return Err(NoGas::Peak(wanted / BAR, lowest / BAR));
        }
        let is_there = (next - heat).abs() <= 1e-14 * heat;
        heat = next;
        if is_there {
            break;
        }
    }
    Ok(heat)
}
