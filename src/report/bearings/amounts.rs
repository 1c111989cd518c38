//! How is the force on a bearing written? Like every force: a decimal, 0 where it is proved.

use super::super::calculation::Unit;
use crate::loads::{BearingLoads, Peak};
use crate::page::{Text, phrase};

pub(super) use super::super::calculation::{largest, vector};

/// What forces are counted in.
pub(super) fn unit_of(loads: &BearingLoads) -> Unit {
    Unit::of_force(loads.scale.as_ref())
}

/// The size of a peak: a decimal, or 0.
pub(super) fn size(peak: &Peak, unit: Unit) -> Text {
    let size = peak.value * unit.factor;
    if size == 0.0 { Text::zero() } else { Text::measured(size, unit.unit) }
}

/// The crank angle of a peak; none of a load of 0, as all are at rest.
pub(super) fn angle(peak: &Peak, unit: Unit) -> Text {
    match peak.angle {
        _ if peak.value * unit.factor == 0.0 => "–".into(),
        Some(angle) => phrase!("≈ {}°", Text::figures(angle)),
        None => "every θ".into(),
    }
}

/// The orders that are shown, but for the constant force.
pub(in crate::report) fn orders_of(loads: &BearingLoads) -> Vec<u32> {
    let orders = loads.bearings.first().map_or(&[][..], |bearing| &bearing.orders);
    orders.iter().map(|order| order.order).filter(|order| *order > 0).collect()
}
