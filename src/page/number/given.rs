//! How does a number stand in a text, as it was given or as it is shown?

use num_rational::BigRational;

use super::super::text::{Piece, Text, phrase};
use super::amount::{Amount, Bearing, Number};
use super::digits::approximate;
use crate::table::Unit;

/// An exact number that is given, not found: its zero is no verdict, and stands as any other number does.
pub(crate) fn given(value: &BigRational) -> Text {
    match Number::exact(value) {
        Number::Zero => Number::Exact(value.clone()).into(),
        other @ (Number::Exact(_) | Number::Closed(..) | Number::Decimal(_)) => other.into(),
    }
}

/// The same in this unit, which is given elsewhere.
pub(crate) fn given_in(value: &BigRational, unit: Unit) -> Text {
    Piece::Shortly(value.clone(), unit).into()
}

/// The same with the unit behind it.
pub(crate) fn given_with(value: &BigRational, unit: Unit) -> Text {
    phrase!("{} {}", given_in(value, unit), unit)
}

impl Amount {
    /// As it is shown, in this unit, which is given elsewhere.
    pub(crate) fn counted_in(&self, unit: Unit) -> Text {
        match self.number() {
            Number::Zero => Text::zero(),
            Number::Exact(value) => given_in(&value, unit),
            Number::Closed(form, decimal) => Piece::Closed(form, decimal, unit).into(),
            Number::Decimal(decimal) => Text::measured(decimal, unit),
        }
    }

    /// Plain text: `4`, `√10 ≈ 3.162`, `≈ 0.1234`.
    pub fn plain(&self) -> String {
        Text::from(self.clone()).plain()
    }

    /// Prose with a formula: `$\\sqrt{10}$ ≈ 3.162`.
    pub fn prose(&self) -> String {
        match self.number() {
            Number::Closed(form, decimal) => format!("${}$ {}", form.tex(), approximate(decimal)),
            _ => self.plain(),
        }
    }
}

impl Bearing {
    /// Plain text: `−arctan(1/3) ≈ −18.43°`.
    pub fn plain(&self) -> String {
        Text::from(self.clone()).plain()
    }
}
