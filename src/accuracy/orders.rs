//! What do the first orders of a load add up to, and how much is left to the others?

use super::tail::Tails;
use crate::layout::Layout;
use crate::loads::{self, Harmonic, Loads, Missing, Waveform};
use crate::proof::Quantity;

/// The orders of one load.
pub(super) struct Orders {
    quantity: Quantity,
    pub waveform: Waveform,
    /// By order: its largest length.
    largest: Vec<(u32, f64)>,
    /// Bound of all orders above those.
    rest: f64,
    /// No sum of the terms of the load is larger: its roundings are in the last place of this.
    pub largest_sum: f64,
}

impl Orders {
    pub fn new(layout: &Layout, quantity: Quantity, highest: u32) -> Result<Self, Missing> {
        let mut asked = layout.clone();
        asked.effects.torque = quantity == Quantity::Torque;
        let all: Vec<u32> = (1..=highest).collect();
        let Loads { orders, force, moment, torque, .. } = loads::loads(&asked, &all)?;
        let tails = Tails::new(layout, highest)?;
        let (rest, largest_sum) = (tails.above(layout, quantity, highest), tails.largest_sum(layout, quantity));
        let (waveform, largest) = match (quantity, torque) {
            (Quantity::Force, _) => (force, orders.iter().map(|o| (o.order, o.force.largest())).collect()),
            (Quantity::Moment, _) => (moment, orders.iter().map(|o| (o.order, o.moment.largest())).collect()),
            (Quantity::Torque, Some(torque)) => {
                let largest = torque.orders.iter().map(|order| (order.order, order.vector.value.norm()));
                (torque.waveform, largest.collect())
            }
            (Quantity::Torque, None) => (Waveform::default(), Vec::new()),
        };
        Ok(Orders { quantity, waveform, largest, rest, largest_sum })
    }

    /// The orders above this one add at most this.
    pub fn bound(&self, order: u32) -> f64 {
        let summed: f64 = self.largest.iter().filter(|(k, _)| *k > order).map(|(_, largest)| largest).sum();
        (summed + self.rest) * (1.0 + 1e-9)
    }

    /// Whether one rotating vector, or none, is all there is in the orders that were summed.
    pub fn steady(&self) -> bool {
        match self.waveform.harmonics() {
            [] => true,
            [only] => {
                self.quantity != Quantity::Torque && (only.direct.norm_sqr() == 0.0 || only.reverse.norm_sqr() == 0.0)
            }
            _ => false,
        }
    }

    pub fn up_to(&self, order: u32) -> Waveform {
        let kept = self.waveform.harmonics().iter().filter(|harmonic: &&Harmonic| harmonic.order <= order);
        Waveform::new(kept.copied())
    }

    /// Crank angle of the peak in degrees.
    pub fn angle(&self) -> f64 {
        let peak = match self.quantity {
            Quantity::Torque => self.waveform.real_peak(),
            Quantity::Force | Quantity::Moment => self.waveform.peak(),
        };
        peak.angle.unwrap_or(0.0)
    }

    pub fn peak(&self, waveform: &Waveform) -> f64 {
        match self.quantity {
            Quantity::Torque => waveform.real_peak().value,
            Quantity::Force | Quantity::Moment => waveform.peak().value,
        }
    }
}
