//! How are the numbers of a sweep written?

pub(super) use super::super::data::exact_number as exact;
use crate::sweep::Parameter;

/// `bank angle in °`.
pub(super) fn axis(parameter: &Parameter, is_angle: bool) -> String {
    match parameter.range.unit() {
        "" | "°" | "deg" if is_angle => format!("{} in °", parameter.label),
        "" => parameter.label.clone(),
        unit => format!("{} in {unit}", parameter.label),
    }
}
