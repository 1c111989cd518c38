//! Which unit of the inch stands for one of the SI, and how large is it? Exactly.

use num_rational::BigRational;

use super::Unit;

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
}
