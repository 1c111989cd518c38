//! In what is a decimal counted?

/// A unit: its name on a page, and in TeX.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// As plain text: `N·m`.
    pub name: &'static str,
    /// Inside `\mathrm{}`.
    pub tex: &'static str,
}

/// Newton metres from which on kilonewton metres are read more easily.
const LARGE: f64 = 100_000.0;

impl Unit {
    /// Newtons.
    pub const NEWTON: Unit = Unit { name: "N", tex: "N" };
    /// Newton metres.
    pub const NEWTON_METRE: Unit = Unit { name: "N·m", tex: "N\\,m" };
    /// Kilonewton metres, of the torque of large engines.
    pub const KILONEWTON_METRE: Unit = Unit { name: "kN·m", tex: "kN\\,m" };
    /// Kilograms.
    pub const KILOGRAM: Unit = Unit { name: "kg", tex: "kg" };
    /// Kilogram metres, of a mass at a radius.
    pub const KILOGRAM_METRE: Unit = Unit { name: "kg·m", tex: "kg\\,m" };
    /// Kilogram millimetres, of a mass at a radius.
    pub const KILOGRAM_MILLIMETRE: Unit = Unit { name: "kg·mm", tex: "kg\\,mm" };
    /// Metres.
    pub const METRE: Unit = Unit { name: "m", tex: "m" };
    /// Millimetres.
    pub const MILLIMETRE: Unit = Unit { name: "mm", tex: "mm" };
    /// Metres a second.
    pub const METRE_PER_SECOND: Unit = Unit { name: "m/s", tex: "m/s" };
    /// Metres a second, each second.
    pub const METRE_PER_SQUARE_SECOND: Unit = Unit { name: "m/s²", tex: "m/s^2" };
    /// Joules.
    pub const JOULE: Unit = Unit { name: "J", tex: "J" };
    /// Kilowatts.
    pub const KILOWATT: Unit = Unit { name: "kW", tex: "kW" };
    /// Bars.
    pub const BAR: Unit = Unit { name: "bar", tex: "bar" };
    /// Kilograms times square metres, of a moment of inertia.
    pub const KILOGRAM_SQUARE_METRE: Unit = Unit { name: "kg·m²", tex: "kg\\,m^2" };
    /// Degrees of crank angle.
    pub const DEGREE: Unit = Unit { name: "°", tex: "^\\circ" };
    /// Oscillations a second.
    pub const HERTZ: Unit = Unit { name: "Hz", tex: "Hz" };
    /// Revolutions a minute.
    pub const PER_MINUTE: Unit = Unit { name: "1/min", tex: "min^{-1}" };
    /// Parts of a hundred.
    pub const PERCENT: Unit = Unit { name: "%", tex: "\\%" };

    /// A value in this unit as it is read best: from 100000 N·m on in kN·m.
    pub fn at_sight(self, value: f64) -> (f64, Unit) {
        match self == Unit::NEWTON_METRE && value.abs() >= LARGE {
            true => (value / 1000.0, Unit::KILONEWTON_METRE),
            false => (value, self),
        }
    }

    /// By the commands of siunitx; none of what is no unit, such as `m r ω²`.
    pub fn siunitx(&self) -> Option<&'static str> {
        let known = [
            (Unit::NEWTON, "\\newton"),
            (Unit::NEWTON_METRE, "\\newton\\metre"),
            (Unit::KILONEWTON_METRE, "\\kilo\\newton\\metre"),
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
            (Unit::DEGREE, "\\degree"),
            (Unit::HERTZ, "\\hertz"),
            (Unit::PER_MINUTE, "\\per\\minute"),
            (Unit::PERCENT, "\\percent"),
        ];
        known.into_iter().find(|(unit, _)| unit.name == self.name).map(|(_, commands)| commands)
    }
}
