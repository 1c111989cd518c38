//! How large is one order of the force, the moment and the torque?

use num_complex::Complex;

use super::{Harmonic, Motion, Swing, Vector, Waveform};
use crate::engine::Engine;
use crate::motion::Coefficient;
use crate::order::{self, Contribution, OrderSum};
use crate::proof::{Planar, Quantity, Sense};

/// One order of force and moment, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct OrderLoads {
    /// The order k.
    pub order: u32,
    /// Coefficient c_k; none where the rods differ, where it is zero, or where nothing is left of the order that calls for it.
    pub coefficient: Option<Coefficient>,
    /// The shaking force.
    pub force: Swing,
    /// Its moment about the reference plane.
    pub moment: Swing,
}

impl OrderLoads {
    pub(super) fn new(engine: &Engine, motion: &Motion, order: u32) -> Self {
        let [force, moment] = swings(engine, motion, order, |_| true);
        OrderLoads { order, coefficient: motion.common(order), force, moment }
    }

    /// The force or the moment.
    pub fn swing(&self, quantity: Planar) -> &Swing {
        quantity.choose(&self.force, &self.moment)
    }

    /// Whether there is something to judge: a piston has the order, or a shaft turns so, or a crankshaft with masses.
    pub fn exists(&self, engine: &Engine) -> bool {
        engine.pistons_have_order(Quantity::FORCE, self.order) || turning_orders(engine).contains(&self.order)
    }
}

/// The inertia torque, in multiples of m r² ω²: the real part of its waveform.
#[derive(Clone, Debug)]
pub struct Torque {
    /// Its orders.
    pub orders: Vec<TorqueOrder>,
    /// All of them together.
    pub waveform: Waveform,
}

impl Torque {
    /// That of these orders.
    pub(super) fn new(orders: Vec<TorqueOrder>) -> Self {
        Torque { waveform: Waveform::new(orders.iter().map(TorqueOrder::harmonic)), orders }
    }
}

/// One order of the inertia torque: `Re(vector · e^{ikθ})`.
#[derive(Clone, Debug)]
pub struct TorqueOrder {
    /// The order k.
    pub order: u32,
    /// The coefficient of the motion; none where the rods differ.
    pub coefficient: Option<Coefficient>,
    /// Coefficient times sum.
    pub vector: Vector,
}

impl TorqueOrder {
    pub(super) fn new(engine: &Engine, motion: &Motion, order: u32) -> Self {
        let sum = order::torque(engine, order);
        let pairs: Vec<_> = sum.parts().iter().map(|(factor, sum)| (motion.coefficient(factor, order), sum)).collect();
        let coefficient = match (motion.mechanisms.len(), pairs.as_slice()) {
            (1, _) if motion.has_faster => None,
            (1, [(coefficient, _)]) => Some(coefficient.clone()),
            _ => None,
        };
        // No coefficient of an order that exists is zero.
        TorqueOrder { order, coefficient, vector: Vector::of(&pairs, true) }
    }

    pub(super) fn harmonic(&self) -> Harmonic {
        Harmonic { order: self.order, direct: self.vector.value, reverse: Complex::new(0.0, 0.0) }
    }
}

/// Force and moment of an order, of the contributions that are meant.
pub(super) fn swings(
    engine: &Engine,
    motion: &Motion,
    order: u32,
    is_meant: impl Fn(&Contribution) -> bool,
) -> [Swing; 2] {
    let contributions = Sense::BOTH.map(|sense| order::contributions(engine, order, sense));
    Planar::BOTH.map(|quantity| {
        let sums = contributions.each_ref().map(|of_sense| {
            let meant = of_sense.iter().filter(|one| is_meant(one));
            OrderSum::new(meant.map(|one| one.weighed(|position| order::lever(engine, quantity, position))))
        });
        motion.swing(sums, order)
    })
}

/// The orders of the balancer shafts, and of the crankshafts that turn faster than the reference.
pub(super) fn turning_orders(engine: &Engine) -> Vec<u32> {
    let shafts = engine.crankshaft().balancers.iter().map(|shaft| shaft.order);
    let faster = engine.geared_cranks().iter().map(|crank| crank.speed).filter(|speed| *speed != 1);
    shafts.chain(faster).collect()
}

pub(super) fn harmonic(order: u32, swing: &Swing) -> Harmonic {
    let [direct, reverse] = swing.amplitudes();
    match order {
        0 => Harmonic { order, direct: direct + reverse, reverse: Complex::new(0.0, 0.0) },
        _ => Harmonic { order, direct, reverse },
    }
}
