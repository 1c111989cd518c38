//! In what is a number counted: on a page, in TeX, in the name of a column?

/// A unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// As a person writes it: `N·m`.
    pub name: &'static str,
    /// Inside `\mathrm{}`.
    pub tex: &'static str,
    /// In the name of a column: letters, digits and `_`; empty where there is none.
    pub suffix: &'static str,
}

impl Unit {
    /// Newtons.
    pub const NEWTON: Unit = Unit { name: "N", tex: "N", suffix: "N" };
    /// Newton metres.
    pub const NEWTON_METRE: Unit = Unit { name: "N·m", tex: "N\\,m", suffix: "N_m" };
    /// Kilonewtons.
    pub const KILONEWTON: Unit = Unit { name: "kN", tex: "kN", suffix: "kN" };
    /// Meganewtons.
    pub const MEGANEWTON: Unit = Unit { name: "MN", tex: "MN", suffix: "MN" };
    /// Kilonewton metres.
    pub const KILONEWTON_METRE: Unit = Unit { name: "kN·m", tex: "kN\\,m", suffix: "kN_m" };
    /// Meganewton metres, of large engines.
    pub const MEGANEWTON_METRE: Unit = Unit { name: "MN·m", tex: "MN\\,m", suffix: "MN_m" };
    /// Kilograms.
    pub const KILOGRAM: Unit = Unit { name: "kg", tex: "kg", suffix: "kg" };
    /// Kilogram metres, of a mass at a radius.
    pub const KILOGRAM_METRE: Unit = Unit { name: "kg·m", tex: "kg\\,m", suffix: "kg_m" };
    /// Kilogram millimetres, of a mass at a radius.
    pub const KILOGRAM_MILLIMETRE: Unit = Unit { name: "kg·mm", tex: "kg\\,mm", suffix: "kg_mm" };
    /// Metres.
    pub const METRE: Unit = Unit { name: "m", tex: "m", suffix: "m" };
    /// Millimetres.
    pub const MILLIMETRE: Unit = Unit { name: "mm", tex: "mm", suffix: "mm" };
    /// Metres a second.
    pub const METRE_PER_SECOND: Unit = Unit { name: "m/s", tex: "m/s", suffix: "m_per_s" };
    /// Metres a second, each second.
    pub const METRE_PER_SQUARE_SECOND: Unit = Unit { name: "m/s²", tex: "m/s^2", suffix: "m_per_s2" };
    /// Joules.
    pub const JOULE: Unit = Unit { name: "J", tex: "J", suffix: "J" };
    /// Kilowatts.
    pub const KILOWATT: Unit = Unit { name: "kW", tex: "kW", suffix: "kW" };
    /// Bars.
    pub const BAR: Unit = Unit { name: "bar", tex: "bar", suffix: "bar" };
    /// Kilograms times square metres, of a moment of inertia.
    pub const KILOGRAM_SQUARE_METRE: Unit = Unit { name: "kg·m²", tex: "kg\\,m^2", suffix: "kg_m2" };
    /// Degrees of crank angle.
    pub const DEGREE: Unit = Unit { name: "°", tex: "^\\circ", suffix: "deg" };
    /// Oscillations a second.
    pub const HERTZ: Unit = Unit { name: "Hz", tex: "Hz", suffix: "Hz" };
    /// Revolutions a minute.
    pub const PER_MINUTE: Unit = Unit { name: "rpm", tex: "\\mathrm{rpm}", suffix: "rpm" };
    /// Parts of a hundred.
    pub const PERCENT: Unit = Unit { name: "%", tex: "\\%", suffix: "percent" };
    /// Newtons times the spacing of the cylinders.
    pub const NEWTON_SPACING: Unit = Unit { name: "N·a", tex: "N\\,a", suffix: "N_a" };
    /// Cubic centimetres.
    pub const CUBIC_CENTIMETRE: Unit = Unit { name: "cm³", tex: "cm^3", suffix: "cm3" };
    /// Pounds-force.
    pub const POUND_FORCE: Unit = Unit { name: "lbf", tex: "lbf", suffix: "lbf" };
    /// Pounds-force times feet, of a moment.
    pub const POUND_FORCE_FOOT: Unit = Unit { name: "lbf·ft", tex: "lbf\\,ft", suffix: "lbf_ft" };
    /// Pounds-force times the spacing of the cylinders.
    pub const POUND_FORCE_SPACING: Unit = Unit { name: "lbf·a", tex: "lbf\\,a", suffix: "lbf_a" };
    /// Pounds.
    pub const POUND: Unit = Unit { name: "lb", tex: "lb", suffix: "lb" };
    /// Ounces times inches, of a mass at a radius.
    pub const OUNCE_INCH: Unit = Unit { name: "oz·in", tex: "oz\\,in", suffix: "oz_in" };
    /// Pounds times square feet, of a moment of inertia.
    pub const POUND_SQUARE_FOOT: Unit = Unit { name: "lb·ft²", tex: "lb\\,ft^2", suffix: "lb_ft2" };
    /// Inches.
    pub const INCH: Unit = Unit { name: "in", tex: "in", suffix: "in" };
    /// Cubic inches.
    pub const CUBIC_INCH: Unit = Unit { name: "in³", tex: "in^3", suffix: "in3" };
    /// Feet times pounds-force, of work.
    pub const FOOT_POUND: Unit = Unit { name: "ft·lbf", tex: "ft\\,lbf", suffix: "ft_lbf" };
    /// Horsepower of 550 feet times pounds-force a second.
    pub const HORSEPOWER: Unit = Unit { name: "hp", tex: "hp", suffix: "hp" };
    /// Pounds-force on a square inch.
    pub const PSI: Unit = Unit { name: "psi", tex: "psi", suffix: "psi" };
    /// Feet a second.
    pub const FOOT_PER_SECOND: Unit = Unit { name: "ft/s", tex: "ft/s", suffix: "ft_per_s" };
    /// Feet a second, each second.
    pub const FOOT_PER_SQUARE_SECOND: Unit = Unit { name: "ft/s²", tex: "ft/s^2", suffix: "ft_per_s2" };
    /// Thousandths of a radian.
    pub const MILLIRADIAN: Unit = Unit { name: "mrad", tex: "mrad", suffix: "mrad" };
    /// Millimetres a second.
    pub const MILLIMETRE_PER_SECOND: Unit = Unit { name: "mm/s", tex: "mm/s", suffix: "mm_per_s" };
    /// Inches a second.
    pub const INCH_PER_SECOND: Unit = Unit { name: "in/s", tex: "in/s", suffix: "in_per_s" };
    /// Newtons a metre, of a spring.
    pub const NEWTON_PER_METRE: Unit = Unit { name: "N/m", tex: "N/m", suffix: "N_per_m" };
    /// Pounds-force an inch, of a spring.
    pub const POUND_FORCE_PER_INCH: Unit = Unit { name: "lbf/in", tex: "lbf/in", suffix: "lbf_per_in" };
    /// Newton seconds a metre, of a damper.
    pub const NEWTON_SECOND_PER_METRE: Unit = Unit { name: "N·s/m", tex: "N\\,s/m", suffix: "N_s_per_m" };
    /// Pound-force seconds an inch, of a damper.
    pub const POUND_FORCE_SECOND_PER_INCH: Unit = Unit { name: "lbf·s/in", tex: "lbf\\,s/in", suffix: "lbf_s_per_in" };
    /// Newton metres a radian, of a shaft that twists.
    pub const NEWTON_METRE_PER_RADIAN: Unit = Unit { name: "N·m/rad", tex: "N\\,m/rad", suffix: "N_m_per_rad" };
    /// Pounds-force times feet a radian.
    pub const POUND_FORCE_FOOT_PER_RADIAN: Unit =
        Unit { name: "lbf·ft/rad", tex: "lbf\\,ft/rad", suffix: "lbf_ft_per_rad" };
    /// Newton metres times seconds a radian, of a damping.
    pub const NEWTON_METRE_SECOND: Unit = Unit { name: "N·m·s/rad", tex: "N\\,m\\,s/rad", suffix: "N_m_s_per_rad" };
    /// Pounds-force times feet times seconds a radian.
    pub const POUND_FORCE_FOOT_SECOND: Unit =
        Unit { name: "lbf·ft·s/rad", tex: "lbf\\,ft\\,s/rad", suffix: "lbf_ft_s_per_rad" };
    /// Megapascals, of a stress.
    pub const MEGAPASCAL: Unit = Unit { name: "MPa", tex: "MPa", suffix: "MPa" };
    /// Moments in multiples of m r ω² at an arm of one metre.
    pub const MULTIPLE_METRE: Unit = Unit { name: "m r ω²·1 m", tex: "m\\,r\\,\\omega^2\\,m", suffix: "mrw2_m" };
    /// The same at an arm of one inch.
    pub const MULTIPLE_INCH: Unit = Unit { name: "m r ω²·1 in", tex: "m\\,r\\,\\omega^2\\,in", suffix: "mrw2_in" };
    /// A count, a word, a truth.
    pub const NONE: Unit = Unit { name: "", tex: "", suffix: "" };
    /// The spacing a of the cylinders.
    pub const SPACING: Unit = Unit { name: "a", tex: "a", suffix: "a" };
    /// Crank radii.
    pub const CRANK_RADIUS: Unit = Unit { name: "r", tex: "r", suffix: "r" };
    /// Mass times crank radius.
    pub const MASS_RADIUS: Unit = Unit { name: "m r", tex: "m\\,r", suffix: "m_r" };
    /// That times an arm in metres.
    pub const MASS_RADIUS_METRE: Unit = Unit { name: "m r · 1 m", tex: "m\\,r\\,m", suffix: "m_r_m" };
    /// That times an arm in spacings.
    pub const MASS_RADIUS_SPACING: Unit = Unit { name: "m r a", tex: "m\\,r\\,a", suffix: "m_r_a" };
    /// Mass times the square of the crank radius.
    pub const MASS_RADIUS_SQUARED: Unit = Unit { name: "m r²", tex: "m\\,r^2", suffix: "m_r2" };
    /// Forces without a scale.
    pub const MULTIPLE: Unit = Unit { name: "m r ω²", tex: "m\\,r\\,\\omega^2", suffix: "mrw2" };
    /// Their moments, with arms in spacings.
    pub const MULTIPLE_SPACING: Unit = Unit { name: "m r ω² a", tex: "m\\,r\\,\\omega^2\\,a", suffix: "mrw2_a" };
    /// Forces where no rod is given.
    pub const OPEN: Unit = Unit { name: "m r ω² c_k", tex: "m\\,r\\,\\omega^2 c_k", suffix: "mrw2_ck" };
    /// Their moments, with arms in spacings.
    pub const OPEN_SPACING: Unit =
        Unit { name: "m r ω² c_k a", tex: "m\\,r\\,\\omega^2 c_k\\,a", suffix: "mrw2_ck_a" };
    /// Their moments, with arms in metres.
    pub const OPEN_METRE: Unit =
        Unit { name: "m r ω² c_k · 1 m", tex: "m\\,r\\,\\omega^2 c_k\\,m", suffix: "mrw2_ck_m" };
    /// Torques without a scale.
    pub const TORQUE_MULTIPLE: Unit = Unit { name: "m r² ω²", tex: "m\\,r^2\\,\\omega^2", suffix: "mr2w2" };
    /// Seconds.
    pub const SECOND: Unit = Unit { name: "s", tex: "s", suffix: "s" };
    /// Watts.
    pub const WATT: Unit = Unit { name: "W", tex: "W", suffix: "W" };
    /// Pascals.
    pub const PASCAL: Unit = Unit { name: "Pa", tex: "Pa", suffix: "Pa" };
}
