//! How do numbers become text? In one place: exact ones bare, decimals after `≈`, what has a unit to sensible figures.

mod amount;
mod digits;
mod given;

pub use amount::{Amount, Bearing, Number};
pub use digits::{Figures, degrees, sensible, turns};
pub(crate) use digits::{
    angle, approximate, at_most, behind, decimal, grouped, in_ascii, in_decimals, is_long, is_rounded, listed, lowered,
    multiple, names, number, power_of_ten, raised, raised_to, short, signed_degrees, terminates, turns_in_decimals,
};
pub(crate) use given::{given, given_in, given_with};
