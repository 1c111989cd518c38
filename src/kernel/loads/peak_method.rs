//! In which ways is a largest value found? By the first orders, at equal crank angles, by the law of the motion itself.

use crate::engine::CycleOrder;

/// A way to find a largest value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PeakMethod {
    /// The orders up to this one; where there is gas these are its orders, with the masses in their closed form.
    Orders(CycleOrder),
    /// The law itself (the closed form of the motion, the pressure at each angle) at this many equal steps of a revolution.
    Samples(u32),
    /// The law itself, its largest sample refined: the reference of the others.
    Refined,
}

impl PeakMethod {
    /// Orders of the gas are compared up to this one.
    pub const HIGHEST: usize = (MORE[MORE.len() - 1] / 2) as usize;

    /// The methods that are compared where there is gas: every order up to 6 that there is, some higher ones, and samples.
    pub fn of_gas(exists: impl Fn(CycleOrder) -> bool) -> Vec<Self> {
        let each = (1..=EACH).filter_map(CycleOrder::of_halves).filter(|order| exists(*order));
        let orders = each.chain(MORE.into_iter().filter_map(CycleOrder::of_halves));
        let samples = STEPS.into_iter().map(PeakMethod::Samples);
        orders.map(PeakMethod::Orders).chain(samples).chain([PeakMethod::Refined]).collect()
    }
}

/// Every order that there is up to this one is compared: 6.
const EACH: u32 = 12;
/// Above it the orders up to these, in halves: 8, 12, 24, 48.
const MORE: [u32; 4] = [16, 24, 48, 96];
/// Steps of a revolution.
const STEPS: [u32; 4] = [36, 72, 360, 3600];
