//! How large are the forces, moments and torques of an engine, in newtons?
//!
//! The exact sums of a layout times the coefficients of its motion. Only what the layout file asks for is computed.

mod always;
mod bearing;
mod coefficients;
mod hung_rod;
mod missing;
mod needed;
mod needed_bearings;
mod order_loads;
mod peak_method;
mod pin;
mod roll;
mod scale;
mod shares;
mod spectrum;
mod swing;
mod tails;
mod vector;
mod waveform;

pub use always::{speeds, sums_of_alike, vanishes_at_every_order};
pub use bearing::{BearingLoad, BearingLoads, bearing_loads};
use coefficients::Motion;
pub use hung_rod::{HungRod, KnuckleLoad, LinkLoads, MasterLoad, link_loads};
pub use missing::Missing;
use needed::usual_torque_orders;
pub use needed::{Bound, LeftOut, Needed, left_out, needed_orders, usual_orders};
pub use needed_bearings::{bearing_orders, left_out_of_bearings, left_out_of_pins, usual_bearing_orders};
pub use order_loads::{OrderLoads, Torque, TorqueOrder};
use order_loads::{harmonic, swings};
pub use peak_method::PeakMethod;
pub use pin::{LoadOrder, PinLoad, PinLoads, pin_loads};
pub use roll::roll_moments;
pub use scale::{Arm, Scale, scale, unit};
pub use shares::{Method, Shares};
pub use spectrum::Spectrum;
pub use swing::Swing;
pub use tails::Tails;
pub use vector::{Outcome, Vector};
pub use waveform::{Circle, Harmonic, Peak, Waveform};

use crate::engine::{self, Engine};
use crate::order::{self, MassGroup, MissingArm};
use crate::proof::Axial;

/// Forces, moments and torque of an engine, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct Loads {
    /// The orders, rising, each with what is left of it.
    pub orders: Vec<OrderLoads>,
    /// The groups of masses that are in the scene.
    pub groups: Vec<GroupLoads>,
    /// The force of all orders, in multiples of m r ω².
    pub force: Waveform,
    /// The moment of all orders about the reference plane, in multiples of m r ω² times the unit of the positions.
    pub moment: Waveform,
    /// The inertia torque, where the file asks for it.
    pub torque: Option<Torque>,
    /// What the main bearings feel, as a continuous beam and by the determinate approximation, at these orders and those that
    /// they need besides; none where the file gives no bearings.
    pub bearings: Option<[BearingLoads; 2]>,
    /// The roll moment on the frame, where it is not the torque alone turned round and the file asks for the
    /// torque.
    pub roll: Option<Torque>,
    /// What keeps the roll moment from being given, where the file asks for the torque.
    pub roll_lacks: Option<MissingArm>,
    /// What turns multiples into newtons; none where mass, crank radius or speed is missing.
    pub scale: Option<Scale>,
    /// How many values of the motion's coefficients were computed: the cost of the scene.
    pub coefficients: usize,
}

impl Loads {
    /// Which of the two rolls the frame: the roll moment, or the inertia torque turned round where that is all of it; neither where the roll
    /// moment hangs on a length that the layout omits.
    pub fn rolling(&self) -> Option<Axial> {
        match (&self.roll, self.roll_lacks) {
            (Some(_), _) => Some(Axial::Roll),
            (None, Some(_)) => None,
            (None, None) => Some(Axial::Torque),
        }
    }
}

/// What one group of masses adds.
#[derive(Clone, Debug)]
pub struct GroupLoads {
    /// The group.
    pub group: MassGroup,
    /// Its force, in multiples of m r ω².
    pub force: Waveform,
    /// Its moment.
    pub moment: Waveform,
}

/// Computes the loads of an engine at these orders, and the torque at those that it needs besides.
///
/// # Errors
/// What the layout lacks.
pub fn loads(engine: &Engine, orders: &[u32]) -> Result<Loads, Missing> {
    let torque = if engine.effects().torque { usual_torque_orders(engine, orders)? } else { Vec::new() };
    loads_at(engine, orders, &torque)
}

/// Computes the loads of an engine at these orders, and the torque, where the file asks for it, at orders of its own.
///
/// # Errors
/// What the layout lacks, and orders that are none.
pub fn loads_at(engine: &Engine, orders: &[u32], torque_orders: &[u32]) -> Result<Loads, Missing> {
    engine::are_orders(orders)?;
    engine::are_orders(torque_orders)?;
    let motion = Motion::new(engine)?;
    let total: Vec<OrderLoads> = orders.iter().map(|&order| OrderLoads::new(engine, &motion, order)).collect();
    let waveform =
        |swing: fn(&OrderLoads) -> &Swing| Waveform::new(total.iter().map(|loads| harmonic(loads.order, swing(loads))));
    let (force, moment) = (waveform(|loads| &loads.force), waveform(|loads| &loads.moment));
    let groups = match order::groups_of(engine).as_slice() {
        &[group] => vec![GroupLoads { group, force: force.clone(), moment: moment.clone() }],
        several => several.iter().map(|&group| GroupLoads::new(engine, &motion, group, orders)).collect(),
    };
    let bearings = match engine.bearings().is_empty() {
        true => None,
        false => {
            let orders = bearing_orders(engine, orders);
            let solve = |method| bearing_loads(engine, &orders, method);
            Some([solve(Method::Continuous)?, solve(Method::Determinate)?])
        }
    };
    let torque = engine
        .effects()
        .torque
        .then(|| Torque::new(torque_orders.iter().map(|&order| TorqueOrder::new(engine, &motion, order)).collect()));
    let has_arms =
        !engine.crankshaft().balancers.is_empty() || engine.has_offset() || !engine.geared_cranks().is_empty();
    let asks = engine.effects().torque && has_arms;
    let roll_lacks = if asks { order::roll_lacks(engine) } else { None };
    let roll = (asks && roll_lacks.is_none()).then(|| roll::roll(engine, &motion, torque_orders));
    Ok(Loads {
        groups,
        force,
        moment,
        torque,
        bearings,
        roll,
        roll_lacks,
        scale: scale(engine),
        orders: total,
        coefficients: motion.computed(),
    })
}

impl GroupLoads {
    fn new(engine: &Engine, motion: &Motion, group: MassGroup, orders: &[u32]) -> Self {
        let of_order = |&order: &u32| (order, swings(engine, motion, order, |one| one.source.group() == group));
        let by_order: Vec<(u32, [Swing; 2])> = orders.iter().map(of_order).collect();
        let waveform =
            |place: usize| Waveform::new(by_order.iter().map(|(order, swings)| harmonic(*order, &swings[place])));
        GroupLoads { group, force: waveform(0), moment: waveform(1) }
    }
}
