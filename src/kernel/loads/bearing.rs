//! Which forces do the main bearings feel, order by order and through a revolution?
//!
//! A bearing carries a rational part of a force that acts at a position of the shaft ([`crate::beam`]), so each order of
//! each reaction is again an exact sum: that of the loads of the shaft, each term weighed by its part (theory, section 8). Those
//! are the loads of the crankpins ([`super::pin`]), whose sum is not the shaking force: the cylinder walls carry the side forces of
//! the pistons. Inertia alone: the room `journal` adds the gas; no weight; rigid collinear bearings without clearance.

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use super::pin::{LoadOrder, with_constant};
use super::shares::{Method, Shares, in_equilibrium};
use super::{Missing, Motion, Peak, Scale, Waveform};
use crate::engine::{self, Engine};
use crate::order::{self, Contribution, OrderSum};
use crate::proof::Sense;

/// The loads of all main bearings, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct BearingLoads {
    /// How loads are shared.
    pub method: Method,
    /// The bearings, in the order of the file; where several crankshafts are geared together those of each in turn.
    pub bearings: Vec<BearingLoad>,
    /// The part that each bearing carries of a unit load, by the load's position: exact.
    pub parts: BTreeMap<BigRational, Vec<BigRational>>,
    /// Indices of those with the largest peak; none where no bearing feels anything, as at rest.
    pub worst: Vec<usize>,
    /// What turns multiples into newtons; none where mass, crank radius or speed is missing.
    pub scale: Option<Scale>,
}

/// What one main bearing feels: the force in the direction of the load, not the one that it answers with.
#[derive(Clone, Debug)]
pub struct BearingLoad {
    /// What it is called: its number, beside the name of its crankshaft where there are several.
    pub name: String,
    /// Which crankshaft it carries, where several are geared together; else 0.
    pub crank: usize,
    /// Where it stands, in the unit of the layout's positions.
    pub position: BigRational,
    /// The orders, rising; from 0, a constant force, where there is one.
    pub orders: Vec<LoadOrder>,
    /// All of them together.
    pub waveform: Waveform,
    /// The largest force in a revolution.
    pub peak: Peak,
    /// The largest size of the component along direction 0, y.
    pub along: Peak,
    /// The largest size of the component across it, x; to the right it is the imaginary part with its sign changed.
    pub across: Peak,
}

/// Peaks closer than this part share the place of the worst: the roundings of their decimals could not tell them apart.
const EQUAL: f64 = 1e-12;

/// Computes what the main bearings of an engine feel at these orders.
///
/// Every order is checked, exactly, against the loads of crankpins and shaft and their moment: the reactions of a crankshaft sum to both.
/// Order 0, a constant force, stands before the others where pistons have an offset. Of several crankshafts each has bearings at the
/// positions that the engine gives.
///
/// # Errors
/// What the layout lacks.
pub fn bearing_loads(engine: &Engine, orders: &[u32], method: Method) -> Result<BearingLoads, Missing> {
    let shares = Shares::of(engine, method)?;
    engine::are_orders(orders)?;
    let motion = Motion::new(engine)?;
    let of_crank = |crank: usize| of_crankshaft(engine, &motion, &shares, (crank, orders));
    let bearings: Vec<BearingLoad> = (0..engine.crankshafts()).flat_map(of_crank).collect();
    let largest = bearings.iter().map(|bearing| bearing.peak.value).fold(0.0, f64::max);
    let scale = super::scale(engine);
    let is_loaded = largest > 0.0 && !scale.as_ref().is_some_and(Scale::is_at_rest);
    let is_worst = |&index: &usize| is_loaded && bearings[index].peak.value >= largest * (1.0 - EQUAL);
    let worst = (0..bearings.len()).filter(is_worst).collect();
    Ok(BearingLoads { method, bearings, parts: shares.into_known(), worst, scale })
}

fn of_crankshaft(
    engine: &Engine,
    motion: &Motion,
    shares: &Shares,
    (crank, orders): (usize, &[u32]),
) -> Vec<BearingLoad> {
    let mut by_bearing: Vec<Vec<LoadOrder>> = engine.bearings().iter().map(|_| Vec::new()).collect();
    for order in with_constant(engine, orders) {
        let [direct, reverse] = Sense::BOTH.map(|sense| {
            let forces = order::shaft_contributions(engine, crank, order, sense);
            let sum = |weighing: &dyn Fn(&BigRational) -> BigRational| {
                OrderSum::new(forces.iter().map(|force: &Contribution| force.weighed(weighing)))
            };
            let reactions: Vec<OrderSum> =
                (0..engine.bearings().len()).map(|bearing| sum(&|at| shares.part(bearing, at))).collect();
            let loads = [sum(&|_| BigRational::one()), sum(&Clone::clone)];
            if !in_equilibrium(engine.bearings(), &reactions, &loads) {
                unreachable!("the reactions of order {order} sum to the loads and their moment")
            }
            reactions
        });
        for ((loads, direct), reverse) in by_bearing.iter_mut().zip(direct).zip(reverse) {
            let swing = motion.swing([direct.clone(), reverse.clone()], order);
            loads.push(LoadOrder { order, sums: [direct, reverse], swing });
        }
    }
    let places = engine.bearings().iter().enumerate().zip(by_bearing);
    places
        .map(|((place, at), orders)| {
            let name = match engine.geared_cranks().get(crank) {
                Some(shaft) => format!("{} {}", shaft.name, place + 1),
                None => (place + 1).to_string(),
            };
            BearingLoad::new((name, crank), at.clone(), orders)
        })
        .collect()
}

impl BearingLoad {
    fn new((name, crank): (String, usize), position: BigRational, orders: Vec<LoadOrder>) -> Self {
        let waveform = Waveform::new(orders.iter().map(|order| super::harmonic(order.order, &order.swing)));
        let [along, across] = [1.0.into(), Complex::i()].map(|direction| waveform.component_peak(direction));
        BearingLoad { name, crank, position, orders, peak: waveform.peak(), along, across, waveform }
    }
}
