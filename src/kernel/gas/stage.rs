//! How does the pressure of a compressor's stage go? Its valves open where the gas itself reaches their pressure.

use super::error::NoGas;
use super::geometry::Geometry;
use super::law::{Law, Piece, Shape, period};
use crate::engine::{CompressorStage, Cycle};
use crate::motion::{float, halving};

/// Halvings after which the angle at which a valve opens is known to its last digits.
const HALVINGS: u32 = 100;

/// The law of a stage, from the innermost place of the piston to the next.
pub(super) fn law(stage: &CompressorStage, geometry: &Geometry) -> Result<Law, NoGas> {
    let [suction, delivery] = [&stage.intake_pressure, &stage.delivery_pressure].map(float);
    let [compression, expansion] = [&stage.compression_exponent, &stage.expansion_exponent].map(float);
    let period = period(Cycle::TwoStroke);
    let (start, middle) = (geometry.innermost - period, geometry.outermost);
    let [largest, smallest] = [geometry.volume(start), geometry.volume(middle)];
    let delivers = largest * (suction / delivery).powf(1.0 / compression);
    let takes_in = smallest * (delivery / suction).powf(1.0 / expansion);
    if !(delivers > smallest && takes_in < largest) {
        return Err(NoGas::Delivery);
    }
    let opens = halving(start, middle, HALVINGS, |psi| geometry.volume(psi) > delivers);
    let sucks = halving(middle, start + period, HALVINGS, |psi| geometry.volume(psi) < takes_in);
    let piece = |from, to, shape| Piece { from, to, shape };
    Ok(Law {
        pieces: vec![
            piece(start, opens, Shape::Polytropic(compression, suction * largest.powf(compression))),
            piece(opens, middle, Shape::Line(delivery, delivery)),
            piece(middle, sucks, Shape::Polytropic(expansion, delivery * smallest.powf(expansion))),
            piece(sucks, start + period, Shape::Line(suction, suction)),
        ],
        period,
    })
}
