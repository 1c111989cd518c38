//! In what is a decimal counted? In SI units, or in those of the inch where a reader asks for them.

use num_rational::BigRational;

use crate::numbers::float;
use crate::table::Unit;

/// Newtons, newton metres and kilogram millimetres from which on thousands of them are read more easily, and millions.
const LARGE: f64 = 10_000.0;
const HUGE: f64 = 10_000_000.0;

/// The units that a page counts in; documents of data stay in those of the SI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Units {
    /// Newtons, metres, kilograms.
    #[default]
    Si,
    /// Pounds, inches, feet, horsepower.
    Inch,
}

impl Units {
    /// What these units have in place of another, and how much of that it is, exactly; none where it stays.
    pub(super) fn instead_of(self, unit: Unit) -> Option<(Unit, BigRational)> {
        match self {
            Units::Si => None,
            Units::Inch => unit.inch(),
        }
    }

    /// A value with its unit, in these units.
    pub fn of(self, value: f64, unit: Unit) -> (f64, Unit) {
        self.instead_of(unit).map_or((value, unit), |(inch, size)| (value / float(&size), inch))
    }

    /// An exact value with its unit, in these units.
    pub fn of_exact(self, value: &BigRational, unit: Unit) -> (BigRational, Unit) {
        self.instead_of(unit).map_or_else(|| (value.clone(), unit), |(inch, size)| (value / size, inch))
    }
}

impl Unit {
    /// What is in its place where inches are asked for, and how much of this unit that is, exactly; none for what both
    /// systems share.
    pub fn inch(self) -> Option<(Unit, BigRational)> {
        // An inch is 25.4 mm, a pound 0.45359237 kg, a pound-force 4.4482216152605 N.
        const POUND_FORCE: i64 = 44_482_216_152_605;
        const POUND: i64 = 45_359_237;
        const FOOT_POUND: (i64, i64) = (13_558_179_483_314_004, 10_000_000_000_000_000);
        let known: [(Unit, Unit, (i64, i64)); 23] = [
            (Unit::NEWTON, Unit::POUND_FORCE, (POUND_FORCE, 10_000_000_000_000)),
            (Unit::NEWTON_METRE, Unit::POUND_FORCE_FOOT, FOOT_POUND),
            (Unit::NEWTON_SPACING, Unit::POUND_FORCE_SPACING, (POUND_FORCE, 10_000_000_000_000)),
            (Unit::KILOGRAM, Unit::POUND, (POUND, 100_000_000)),
            (Unit::KILOGRAM_METRE, Unit::OUNCE_INCH, (POUND * 254, 16_000_000_000_000)),
            (Unit::KILOGRAM_MILLIMETRE, Unit::OUNCE_INCH, (POUND * 254, 16_000_000_000)),
            (Unit::METRE, Unit::INCH, (254, 10_000)),
            (Unit::MULTIPLE_METRE, Unit::MULTIPLE_INCH, (254, 10_000)),
            (Unit::METRE_PER_SECOND, Unit::FOOT_PER_SECOND, (3048, 10_000)),
            (Unit::METRE_PER_SQUARE_SECOND, Unit::FOOT_PER_SQUARE_SECOND, (3048, 10_000)),
            (Unit::NEWTON_METRE_PER_RADIAN, Unit::POUND_FORCE_FOOT_PER_RADIAN, FOOT_POUND),
            (Unit::NEWTON_METRE_SECOND, Unit::POUND_FORCE_FOOT_SECOND, FOOT_POUND),
            (Unit::MEGAPASCAL, Unit::PSI, (POUND_FORCE, 6_451_600_000_000_000)),
            (Unit::WATT, Unit::HORSEPOWER, (74_569_987_158_227_022, 100_000_000_000_000)),
            (Unit::MILLIMETRE, Unit::INCH, (254, 10)),
            (Unit::MILLIMETRE_PER_SECOND, Unit::INCH_PER_SECOND, (254, 10)),
            (Unit::NEWTON_PER_METRE, Unit::POUND_FORCE_PER_INCH, (POUND_FORCE, 254_000_000_000)),
            (Unit::NEWTON_SECOND_PER_METRE, Unit::POUND_FORCE_SECOND_PER_INCH, (POUND_FORCE, 254_000_000_000)),
            (Unit::CUBIC_CENTIMETRE, Unit::CUBIC_INCH, (16_387_064, 1_000_000)),
            (Unit::JOULE, Unit::FOOT_POUND, FOOT_POUND),
            (Unit::KILOWATT, Unit::HORSEPOWER, (74_569_987_158_227_022, 100_000_000_000_000_000)),
            (Unit::BAR, Unit::PSI, (POUND_FORCE, 645_160_000_000_000)),
            (Unit::KILOGRAM_SQUARE_METRE, Unit::POUND_SQUARE_FOOT, (POUND * 9_290_304, 10_000_000_000_000_000)),
        ];
        let (own, thousands) = match self {
            Unit::KILONEWTON => (Unit::NEWTON, 1_000),
            Unit::MEGANEWTON => (Unit::NEWTON, 1_000_000),
            Unit::KILONEWTON_METRE => (Unit::NEWTON_METRE, 1_000),
            Unit::MEGANEWTON_METRE => (Unit::NEWTON_METRE, 1_000_000),
            other => (other, 1),
        };
        let found = known.into_iter().find(|(unit, ..)| unit.name == own.name);
        let size = |(above, below): (i64, i64)| BigRational::new(above.into(), below.into());
        found.map(|(_, inch, parts)| (inch, size(parts) / BigRational::from_integer(thousands.into())))
    }

    /// A value in this unit as it is read best: from 10000 N on in kN, from ten millions on in MN, and so with N·m.
    pub fn at_sight(self, value: f64) -> (f64, Unit) {
        let (unit, size) = self.for_values_up_to(value);
        (value / size, unit)
    }

    /// The unit in which values in this unit are read best, the largest of which is this; and how much of this unit it is.
    pub fn for_values_up_to(self, largest: f64) -> (Unit, f64) {
        if self == Unit::KILOGRAM_MILLIMETRE && largest.abs() >= LARGE {
            return (Unit::KILOGRAM_METRE, 1e3);
        }
        let larger = match self {
            Unit::NEWTON => [Unit::KILONEWTON, Unit::MEGANEWTON],
            Unit::NEWTON_METRE => [Unit::KILONEWTON_METRE, Unit::MEGANEWTON_METRE],
            _ => return (self, 1.0),
        };
        match largest.abs() {
            size if size >= HUGE => (larger[1], 1e6),
            size if size >= LARGE => (larger[0], 1e3),
            _ => (self, 1.0),
        }
    }

    /// By the commands of siunitx; none of what is no unit, such as `m r ω²`.
    pub fn siunitx(&self) -> Option<&'static str> {
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
        known.into_iter().find(|(unit, _)| unit.name == self.name).map(|(_, commands)| commands)
    }
}
