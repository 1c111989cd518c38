//! In what is a decimal counted? In SI units, or in those of the inch where a reader asks for them.

use num_rational::BigRational;
use num_traits::ToPrimitive;

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

/// The units that a page counts in; documents of data stay in those of the SI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Units {
    /// Newtons, metres, kilograms.
    #[default]
    Si,
    /// Pounds, inches, feet, horsepower.
    Inch,
}

impl Units {
    /// A value with its unit, in these units.
    pub fn of(self, value: f64, unit: Unit) -> (f64, Unit) {
        match self {
            Units::Si => (value, unit),
            Units::Inch => match unit.inch() {
                Some((inch, size)) => (value / size.to_f64().unwrap_or(f64::NAN), inch),
                None => (value, unit),
            },
        }
    }

    /// An exact value with its unit, in these units.
    pub fn of_exact(self, value: &BigRational, unit: Unit) -> (BigRational, Unit) {
        match self {
            Units::Si => (value.clone(), unit),
            Units::Inch => match unit.inch() {
                Some((inch, size)) => (value / size, inch),
                None => (value.clone(), unit),
            },
        }
    }
}

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

    /// Newtons times the spacing of the cylinders.
    pub const NEWTON_SPACING: Unit = Unit { name: "N·a", tex: "N\\,a" };
    /// Cubic centimetres.
    pub const CUBIC_CENTIMETRE: Unit = Unit { name: "cm³", tex: "cm^3" };
    /// Pounds-force.
    pub const POUND_FORCE: Unit = Unit { name: "lbf", tex: "lbf" };
    /// Pounds-force times feet, of a moment.
    pub const POUND_FORCE_FOOT: Unit = Unit { name: "lbf·ft", tex: "lbf\\,ft" };
    /// Pounds-force times the spacing of the cylinders.
    pub const POUND_FORCE_SPACING: Unit = Unit { name: "lbf·a", tex: "lbf\\,a" };
    /// Pounds.
    pub const POUND: Unit = Unit { name: "lb", tex: "lb" };
    /// Ounces times inches, of a mass at a radius.
    pub const OUNCE_INCH: Unit = Unit { name: "oz·in", tex: "oz\\,in" };
    /// Pounds times square feet, of a moment of inertia.
    pub const POUND_SQUARE_FOOT: Unit = Unit { name: "lb·ft²", tex: "lb\\,ft^2" };
    /// Inches.
    pub const INCH: Unit = Unit { name: "in", tex: "in" };
    /// Cubic inches.
    pub const CUBIC_INCH: Unit = Unit { name: "in³", tex: "in^3" };
    /// Feet times pounds-force, of work.
    pub const FOOT_POUND: Unit = Unit { name: "ft·lbf", tex: "ft\\,lbf" };
    /// Horsepower of 550 feet times pounds-force a second.
    pub const HORSEPOWER: Unit = Unit { name: "hp", tex: "hp" };
    /// Pounds-force on a square inch.
    pub const PSI: Unit = Unit { name: "psi", tex: "psi" };
    /// Feet a second.
    pub const FOOT_PER_SECOND: Unit = Unit { name: "ft/s", tex: "ft/s" };
    /// Feet a second, each second.
    pub const FOOT_PER_SQUARE_SECOND: Unit = Unit { name: "ft/s²", tex: "ft/s^2" };
    /// Newton metres a radian, of a shaft that twists.
    pub const NEWTON_METRE_PER_RADIAN: Unit = Unit { name: "N·m/rad", tex: "N\\,m/rad" };
    /// Pounds-force times feet a radian.
    pub const POUND_FORCE_FOOT_PER_RADIAN: Unit = Unit { name: "lbf·ft/rad", tex: "lbf\\,ft/rad" };
    /// Moments in multiples of m r ω² at an arm of one metre.
    pub const MULTIPLE_METRE: Unit = Unit { name: "m r ω²·1 m", tex: "m\\,r\\,\\omega^2\\,m" };
    /// The same at an arm of one inch.
    pub const MULTIPLE_INCH: Unit = Unit { name: "m r ω²·1 in", tex: "m\\,r\\,\\omega^2\\,in" };

    /// What stands in its place where inches are asked for, and how much of this unit that is, exactly; none for what both
    /// systems share.
    pub fn inch(self) -> Option<(Unit, BigRational)> {
        // An inch is 25.4 mm, a pound 0.45359237 kg, a pound-force 4.4482216152605 N.
        const POUND_FORCE: i64 = 44_482_216_152_605;
        const POUND: i64 = 45_359_237;
        let known: [(Unit, Unit, (i64, i64)); 17] = [
            (Unit::NEWTON, Unit::POUND_FORCE, (POUND_FORCE, 10_000_000_000_000)),
            (Unit::NEWTON_METRE, Unit::POUND_FORCE_FOOT, (13_558_179_483_314_004, 10_000_000_000_000_000)),
            (Unit::NEWTON_SPACING, Unit::POUND_FORCE_SPACING, (POUND_FORCE, 10_000_000_000_000)),
            (Unit::KILOGRAM, Unit::POUND, (POUND, 100_000_000)),
            (Unit::KILOGRAM_METRE, Unit::OUNCE_INCH, (POUND * 254, 16_000_000_000_000)),
            (Unit::KILOGRAM_MILLIMETRE, Unit::OUNCE_INCH, (POUND * 254, 16_000_000_000)),
            (Unit::METRE, Unit::INCH, (254, 10_000)),
            (Unit::MULTIPLE_METRE, Unit::MULTIPLE_INCH, (254, 10_000)),
            (Unit::METRE_PER_SECOND, Unit::FOOT_PER_SECOND, (3048, 10_000)),
            (Unit::METRE_PER_SQUARE_SECOND, Unit::FOOT_PER_SQUARE_SECOND, (3048, 10_000)),
            (
                Unit::NEWTON_METRE_PER_RADIAN,
                Unit::POUND_FORCE_FOOT_PER_RADIAN,
                (13_558_179_483_314_004, 10_000_000_000_000_000),
            ),
            (Unit::MILLIMETRE, Unit::INCH, (254, 10)),
            (Unit::CUBIC_CENTIMETRE, Unit::CUBIC_INCH, (16_387_064, 1_000_000)),
            (Unit::JOULE, Unit::FOOT_POUND, (13_558_179_483_314_004, 10_000_000_000_000_000)),
            (Unit::KILOWATT, Unit::HORSEPOWER, (74_569_987_158_227_022, 100_000_000_000_000_000)),
            (Unit::BAR, Unit::PSI, (POUND_FORCE, 645_160_000_000_000)),
            (Unit::KILOGRAM_SQUARE_METRE, Unit::POUND_SQUARE_FOOT, (POUND * 9_290_304, 10_000_000_000_000_000)),
        ];
        let found = known.into_iter().find(|(unit, ..)| unit.name == self.name);
        found.map(|(_, inch, (above, below))| (inch, BigRational::new(above.into(), below.into())))
    }

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
