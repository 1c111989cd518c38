//! How does LaTeX write a unit?

use crate::table::Unit;

/// A unit by the commands of siunitx; none of what is no unit, such as `m r ω²`.
pub(super) fn siunitx(unit: &Unit) -> Option<&'static str> {
    let known = [
        (Unit::NEWTON, "\\newton"),
        (Unit::NEWTON_METRE, "\\newton\\metre"),
        (Unit::KILONEWTON, "\\kilo\\newton"),
        (Unit::MEGANEWTON, "\\mega\\newton"),
        (Unit::KILONEWTON_METRE, "\\kilo\\newton\\metre"),
        (Unit::MEGANEWTON_METRE, "\\mega\\newton\\metre"),
        (Unit::KILOGRAM, "\\kilogram"),
        (Unit::KILOGRAM_METRE, "\\kilogram\\metre"),
        (Unit::KILOGRAM_MILLIMETRE, "\\kilogram\\milli\\metre"),
        (Unit::JOULE, "\\joule"),
        (Unit::KILOWATT, "\\kilo\\watt"),
        (Unit::BAR, "\\bar"),
        (Unit::KILOGRAM_SQUARE_METRE, "\\kilogram\\metre\\squared"),
        (Unit::METRE, "\\metre"),
        (Unit::MILLIMETRE, "\\milli\\metre"),
        (Unit::METRE_PER_SECOND, "\\metre\\per\\second"),
        (Unit::METRE_PER_SQUARE_SECOND, "\\metre\\per\\second\\squared"),
        (Unit::MILLIMETRE_PER_SECOND, "\\milli\\metre\\per\\second"),
        (Unit::NEWTON_PER_METRE, "\\newton\\per\\metre"),
        (Unit::NEWTON_SECOND_PER_METRE, "\\newton\\second\\per\\metre"),
        (Unit::MILLIRADIAN, "\\milli\\radian"),
        (Unit::DEGREE, "\\degree"),
        (Unit::HERTZ, "\\hertz"),
        (Unit::PER_MINUTE, "\\per\\minute"),
        (Unit::PERCENT, "\\percent"),
    ];
    known.into_iter().find(|(known, _)| known.name == unit.name).map(|(_, commands)| commands)
}
