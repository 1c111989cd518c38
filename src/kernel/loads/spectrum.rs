//! What is every order of force, moment and torque up to one, and what can those above it add?

use super::order_loads::{OrderLoads, TorqueOrder, harmonic, turning_orders};
use super::{Missing, Motion, Swing, Tails, Waveform};
use crate::engine::Engine;
use crate::proof::{Planar, Quantity};

/// All orders of an engine that exist, up to one that can be raised.
pub struct Spectrum<'a> {
    engine: &'a Engine,
    motion: Motion,
    tails: Tails,
    highest: u32,
    orders: Vec<OrderLoads>,
    torque: Vec<TorqueOrder>,
}

impl<'a> Spectrum<'a> {
    /// No order yet.
    ///
    /// # Errors
    /// What the layout lacks for numbers.
    pub fn new(engine: &'a Engine) -> Result<Self, Missing> {
        let motion = Motion::new(engine)?;
        Ok(Spectrum { engine, tails: Tails::of(&motion), motion, highest: 0, orders: Vec::new(), torque: Vec::new() })
    }

    /// The same with tighter bounds.
    pub fn with_tails(self, tails: Tails) -> Self {
        Spectrum { tails, ..self }
    }

    /// Adds the orders up to this one.
    pub fn raise(&mut self, highest: u32, with_torque: bool) {
        let (engine, motion) = (self.engine, &self.motion);
        let turning = turning_orders(engine);
        for order in self.highest + 1..=highest {
            if engine.pistons_have_order(Quantity::FORCE, order) || turning.contains(&order) {
                self.orders.push(OrderLoads::new(engine, motion, order));
            }
            if with_torque && engine.pistons_have_order(Quantity::TORQUE, order) {
                self.torque.push(TorqueOrder::new(engine, motion, order));
            }
        }
        self.highest = self.highest.max(highest);
    }

    fn swings(&self, quantity: Planar) -> impl Iterator<Item = (u32, &Swing)> {
        self.orders.iter().map(move |order| (order.order, order.swing(quantity)))
    }

    /// Each order that does not vanish, with its largest length and how much of that may be missing.
    pub fn lengths(&self, quantity: Quantity) -> Vec<(u32, f64)> {
        match quantity {
            Quantity::Planar(planar) => {
                let left = self.swings(planar).filter(|(_, swing)| !swing.vanishes());
                left.map(|(order, swing)| (order, swing.largest() + swing.doubt())).collect()
            }
            Quantity::Axial(_) => {
                let left = self.torque.iter().filter(|order| !order.vector.vanishes());
                left.map(|order| (order.order, order.vector.value.norm() + order.vector.doubt())).collect()
            }
        }
    }

    /// The sum of the orders.
    pub fn waveform(&self, quantity: Quantity) -> Waveform {
        match quantity {
            Quantity::Planar(planar) => Waveform::new(self.swings(planar).map(|(order, swing)| harmonic(order, swing))),
            Quantity::Axial(_) => Waveform::new(self.torque.iter().map(TorqueOrder::harmonic)),
        }
    }

    /// How much of the sum is not known: vectors that are not decided, and roundings of its floats.
    pub fn doubt(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Planar(planar) => {
                self.swings(planar).map(|(_, swing)| swing.doubt() + ROUNDING * swing.largest()).sum()
            }
            Quantity::Axial(_) => {
                let doubts = self.torque.iter().map(|order| &order.vector);
                doubts.map(|vector| vector.doubt() + ROUNDING * vector.value.norm()).sum()
            }
        }
    }

    /// The orders above the highest add at most this.
    pub fn rest(&self, quantity: Quantity) -> f64 {
        self.rest_above(quantity, self.highest)
    }

    /// What the orders above any one add at most.
    pub fn rest_above(&self, quantity: Quantity, order: u32) -> f64 {
        self.tails.above(self.engine, quantity, order.max(2))
    }

    /// No sum of the terms of the pistons' load is larger: its roundings are in the last place of this.
    pub fn largest_sum(&self, quantity: Quantity) -> f64 {
        self.tails.largest_sum(self.engine, quantity)
    }
}

/// Each vector is known to the accuracy of a float, and a peak of their sum to a few roundings more.
const ROUNDING: f64 = 1e-12;
