//! How is the force on a bearing written? Like every force: six digits after ≈, 0 where it is proved.

use super::super::calculation::Unit;
use crate::loads::{BearingLoads, Peak};

pub(super) use super::super::calculation::{digits, largest, vector};

/// What forces are counted in.
pub(super) fn unit_of(loads: &BearingLoads) -> Unit {
    Unit::of_force(loads.scale.as_ref())
}

/// The size of a peak: `≈ 18733`, or 0.
pub(super) fn size(peak: &Peak, unit: Unit) -> String {
    if peak.value == 0.0 { "0".to_owned() } else { format!("≈ {}", digits(peak.value * unit.factor)) }
}

/// The crank angle of a peak.
pub(super) fn angle(peak: &Peak) -> String {
    match peak.angle {
        _ if peak.value == 0.0 => "–".to_owned(),
        Some(angle) => format!("≈ {}°", digits(angle)),
        None => "every θ".to_owned(),
    }
}
