//! In what is a decimal counted? In SI units, or in those of the inch where a reader asks for them.

use num_rational::BigRational;

use crate::numbers::float;
use crate::table::Unit;

/// The units that a page counts in; documents of data stay in those of the SI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
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
