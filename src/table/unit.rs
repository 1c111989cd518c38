//! What is a column counted in, and how does that stand in its name?

/// The unit of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// In the name of a column: letters, digits and `_`; empty where the name says it already, or there is none.
    pub suffix: &'static str,
    /// As a person writes it.
    pub shown: &'static str,
}

impl Unit {
    /// A count, a word, a truth.
    pub const NONE: Unit = Unit { suffix: "", shown: "" };
    /// Newtons.
    pub const NEWTON: Unit = Unit { suffix: "N", shown: "N" };
    /// Newton-metres.
    pub const NEWTON_METRE: Unit = Unit { suffix: "N_m", shown: "N·m" };
    /// Newtons times the spacing a of the cylinders.
    pub const NEWTON_SPACING: Unit = Unit { suffix: "N_a", shown: "N·a" };
    /// Degrees.
    pub const DEGREE: Unit = Unit { suffix: "deg", shown: "°" };
    /// Metres.
    pub const METRE: Unit = Unit { suffix: "m", shown: "m" };
    /// The spacing a of the cylinders.
    pub const SPACING: Unit = Unit { suffix: "a", shown: "a" };
    /// Revolutions a minute.
    pub const RPM: Unit = Unit { suffix: "rpm", shown: "1/min" };
    /// Kilograms.
    pub const KILOGRAM: Unit = Unit { suffix: "kg", shown: "kg" };
    /// Crank radii.
    pub const CRANK_RADIUS: Unit = Unit { suffix: "r", shown: "r" };
    /// Mass times crank radius.
    pub const MASS_RADIUS: Unit = Unit { suffix: "m_r", shown: "m r" };
    /// That times an arm in metres.
    pub const MASS_RADIUS_METRE: Unit = Unit { suffix: "m_r_m", shown: "m r · 1 m" };
    /// That times an arm in spacings.
    pub const MASS_RADIUS_SPACING: Unit = Unit { suffix: "m_r_a", shown: "m r a" };
    /// Mass times the square of the crank radius.
    pub const MASS_RADIUS_SQUARED: Unit = Unit { suffix: "m_r2", shown: "m r²" };
    /// Forces without a scale.
    pub const MULTIPLE: Unit = Unit { suffix: "mrw2", shown: "m r ω²" };
    /// Their moments, with arms in spacings.
    pub const MULTIPLE_SPACING: Unit = Unit { suffix: "mrw2_a", shown: "m r ω² a" };
    /// Their moments, with arms in metres.
    pub const MULTIPLE_METRE: Unit = Unit { suffix: "mrw2_m", shown: "m r ω² · 1 m" };
    /// Forces where no rod is given.
    pub const OPEN: Unit = Unit { suffix: "mrw2_ck", shown: "m r ω² c_k" };
    /// Their moments, with arms in spacings.
    pub const OPEN_SPACING: Unit = Unit { suffix: "mrw2_ck_a", shown: "m r ω² c_k a" };
    /// Their moments, with arms in metres.
    pub const OPEN_METRE: Unit = Unit { suffix: "mrw2_ck_m", shown: "m r ω² c_k · 1 m" };
    /// Torques without a scale.
    pub const TORQUE_MULTIPLE: Unit = Unit { suffix: "mr2w2", shown: "m r² ω²" };
}
