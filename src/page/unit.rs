//! In what is a decimal counted? In SI units, or in those of the inch where a reader asks for them.

use num_rational::BigRational;

use crate::numbers::float;
use crate::table::Unit;

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
    /// A value with its unit, in these units.
    pub fn of(self, value: f64, unit: Unit) -> (f64, Unit) {
        match self {
            Units::Si => (value, unit),
            Units::Inch => match unit.inch() {
                Some((inch, size)) => (value / float(&size), inch),
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
