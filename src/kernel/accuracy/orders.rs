//! What do the first orders of a load add up to, and how much is left to the others?

use num_rational::BigRational;

use crate::engine::Engine;
use crate::loads::{Harmonic, Missing, Spectrum, Tails, Waveform};
use crate::motion::Enclosure;
use crate::proof::Quantity;

/// The orders of one load.
pub(super) struct Orders {
    quantity: Quantity,
    pub waveform: Waveform,
    /// By order: its largest length.
    largest: Vec<(u32, f64)>,
    /// Bound of all orders above those.
    rest: f64,
    /// How much of the sum of the orders is not known.
    doubt: f64,
    /// No sum of the terms of the load is larger: its roundings are in the last place of this.
    pub largest_sum: f64,
}

impl Orders {
    pub fn new(engine: &Engine, quantity: Quantity, highest: u32) -> Result<Self, Missing> {
        let mut spectrum = Spectrum::new(engine)?.with_tails(Tails::with_coefficients(engine, highest)?);
        spectrum.raise(highest, quantity == Quantity::TORQUE);
        Ok(Orders {
            quantity,
            waveform: spectrum.waveform(quantity),
            largest: spectrum.lengths(quantity),
            rest: spectrum.rest(quantity),
            doubt: spectrum.doubt(quantity),
            largest_sum: spectrum.largest_sum(quantity),
        })
    }

    /// What all orders together peak at, by the sum of those that are known.
    pub fn enclosure(&self) -> Option<Enclosure> {
        let (peak, error) = (self.peak(&self.waveform), self.rest + self.doubt);
        let end = |float: f64| BigRational::from_float(float);
        Some(Enclosure {
            low: end((peak - error).max(0.0).next_down().max(0.0))?,
            high: end((peak + error).next_up())?,
        })
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
                self.quantity != Quantity::TORQUE && (only.direct.norm_sqr() == 0.0 || only.reverse.norm_sqr() == 0.0)
            }
            _ => false,
        }
    }

    /// The first of these orders, and each that adds something to the one before it.
    pub fn worth_keeping(&self, orders: &[u32]) -> Vec<u32> {
        let mut kept: Vec<u32> = Vec::new();
        for order in orders {
            let adds =
                |before: &u32| self.waveform.harmonics().iter().any(|more| (before + 1..=*order).contains(&more.order));
            if kept.last().is_none_or(adds) {
                kept.push(*order);
            }
        }
        kept
    }

    pub fn up_to(&self, order: u32) -> Waveform {
        let kept = self.waveform.harmonics().iter().filter(|harmonic: &&Harmonic| harmonic.order <= order);
        Waveform::new(kept.copied())
    }

    /// Crank angle of the peak in degrees.
    pub fn angle(&self) -> f64 {
        self.waveform.peak_of(self.quantity).angle.unwrap_or(0.0)
    }

    pub fn peak(&self, waveform: &Waveform) -> f64 {
        waveform.peak_of(self.quantity).value
    }
}
