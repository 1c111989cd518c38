//! Which forces load the crankpins, order by order and through a revolution?
//!
//! What a rod hands on to its pin: the inertia of the piston along the rod, so with its side force, and the rotating part of the
//! rod (theory, section 8). The pin of a V carries two or more of them.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use super::{Missing, Motion, Peak, Scale, Swing, Waveform};
use crate::engine::{self, Engine};
use crate::numbers;
use crate::order::{self, OrderSum, Source};
use crate::proof::Sense;

/// What the rods load the crankpins with, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct PinLoads {
    /// A load per cylinder, in the order of the layout.
    pub pins: Vec<PinLoad>,
    /// What turns multiples into newtons; none where mass, crank radius or speed is missing.
    pub scale: Option<Scale>,
}

/// What the rod of one cylinder loads its crankpin with.
#[derive(Clone, Debug)]
pub struct PinLoad {
    /// Where it stands, in the unit of the layout's positions.
    pub position: BigRational,
    /// The orders, rising; from 0, a constant force, where there is one.
    pub orders: Vec<LoadOrder>,
    /// All of them together, seen from the engine.
    pub waveform: Waveform,
    /// The same seen from the crank: the real part is outward along the throw, the imaginary part in the sense of rotation.
    pub on_the_crank: Waveform,
    /// The largest force in a revolution.
    pub peak: Peak,
    /// The largest size of its component along the throw.
    pub along: Peak,
    /// The largest size of that across it.
    pub across: Peak,
}

/// One order of what a pin or a main bearing feels, seen from the engine.
#[derive(Clone, Debug)]
pub struct LoadOrder {
    /// The order k; 0 is a constant force.
    pub order: u32,
    /// P⁺ and P⁻ as exact sums, in multiples of m r.
    pub sums: [OrderSum; 2],
    /// The two vectors, in multiples of m r ω².
    pub swing: Swing,
}

/// Computes what the rods load the crankpins with at these orders, and the constant force of pistons with an offset.
///
/// # Errors
/// What the layout lacks.
pub fn pin_loads(engine: &Engine, orders: &[u32]) -> Result<PinLoads, Missing> {
    engine::are_orders(orders)?;
    let motion = Motion::new(engine)?;
    let mut by_pin: Vec<Vec<LoadOrder>> = engine.cylinders().iter().map(|_| Vec::new()).collect();
    for order in with_constant(engine, orders) {
        let cranks = 0..engine.crankshafts();
        let contributions = Sense::BOTH.map(|sense| {
            let all = cranks.clone().flat_map(|crank| order::pin_contributions(engine, crank, order, sense));
            all.collect::<Vec<_>>()
        });
        for (index, loads) in by_pin.iter_mut().enumerate() {
            let sums = contributions.each_ref().map(|of_sense| {
                let own = of_sense.iter().filter(|one| is_of(one.source, index));
                OrderSum::new(own.map(|one| one.weighed(|_| BigRational::one())))
            });
            let swing = motion.swing(sums.clone(), order);
            loads.push(LoadOrder { order, sums, swing });
        }
    }
    let pins = engine.cylinders().iter().zip(by_pin).map(|(cylinder, orders)| {
        let waveform = Waveform::new(orders.iter().map(|order| super::harmonic(order.order, &order.swing)));
        let turns = engine.sense_of(cylinder).signed(i64::from(engine.speed_of(cylinder)));
        let on_the_crank = waveform.seen_from_the_crank(numbers::direction(&engine.pin_angle(cylinder)), turns);
        let [along, across] = [1.0.into(), Complex::i()].map(|direction| on_the_crank.component_peak(direction));
        PinLoad {
            position: cylinder.position.clone(),
            peak: waveform.peak(),
            along,
            across,
            on_the_crank,
            waveform,
            orders,
        }
    });
    Ok(PinLoads { pins: pins.collect(), scale: super::scale(engine) })
}

/// These orders, after the order 0 of engines that have it.
pub(super) fn with_constant(engine: &Engine, orders: &[u32]) -> Vec<u32> {
    let constant = order::has_constant_pin_loads(engine).then_some(0);
    constant.into_iter().chain(orders.iter().copied()).collect()
}

/// Whether the rod of a cylinder hands on the force of this source.
fn is_of(source: Source, cylinder: usize) -> bool {
    matches!(source, Source::Piston(index) | Source::BigEnd(index) | Source::Knuckle(index) if index == cylinder)
}

impl Waveform {
    /// The vectors in a frame that turns with a throw, which is in this direction at θ = 0 and turns this many times while the reference
    /// turns once, below 0 against it.
    pub fn seen_from_the_crank(&self, throw: Complex<f64>, turns: i64) -> Self {
        self.turned(throw.conj()).orders_back(turns)
    }
}
