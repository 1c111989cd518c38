//! How large is an engine, seen from its end?

use crankstar::engine::Engine;
use crankstar::sweep::Geometry;
use num_traits::ToPrimitive;

/// Rays over which the section is summed.
const RAYS: u32 = 3600;

/// Area of the end view, of all banks and the crankcase together, in r²: times the length it is what the engine fills.
///
/// Every bank and the crankcase are seen whole from the shaft, so that the area is `½ ∫ ρ² dθ` over the farthest of them.
pub fn section(engine: &Engine, geometry: &Geometry) -> Option<f64> {
    if engine.has_links() {
        return None;
    }
    let half = geometry.half_width * geometry.bore;
    let mut banks = Vec::new();
    for cylinder in engine.cylinders() {
        let ratio = cylinder.rod().map_or(Some(geometry.rod_ratio), |rod| rod.ratio.to_f64())?;
        let bank = (cylinder.bank.turns().to_f64()?, 1.0 + 1.0 / ratio + geometry.above_pin * geometry.bore);
        if !banks.contains(&bank) {
            banks.push(bank);
        }
    }
    let step = std::f64::consts::TAU / f64::from(RAYS);
    let ray = |index: u32| {
        let direction = (f64::from(index) + 0.5) * step;
        let distance = |(bank, top): &(f64, f64)| {
            let (sin, cos) = (direction - std::f64::consts::TAU * bank).sin_cos();
            if cos <= 0.0 { 0.0 } else { (top / cos).min(half / sin.abs()) }
        };
        banks.iter().map(distance).fold(geometry.crankcase, f64::max)
    };
    Some((0..RAYS).map(|index| ray(index).powi(2)).sum::<f64>() * step / 2.0)
}
