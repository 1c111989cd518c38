//! Which keys of the gas hold for some cylinders: their own, or those of all?

use std::ops::Range;

use num_rational::BigRational;
use num_traits::Signed;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::gas_table::Rows;
use super::quantities::{misread, value};
use super::units;
use super::written::{Table, Text};

/// `[gas]` and `[[gas.cylinder]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    pub bore: Option<Text>,
    pub ambient: Option<Text>,
    pub crankcase: Option<Text>,
    pub dead_centre: Option<Text>,
    pub table: Option<Text>,
    pub pressure: Option<Rows>,
    pub unit: Option<Text>,
    pub reading: Option<Text>,
    pub below_table: Option<Text>,
    pub below_pressure: Option<Rows>,
    pub piston_rod: Option<Text>,
    pub process: Option<Text>,
    pub compression_ratio: Option<Text>,
    pub intake_pressure: Option<Text>,
    pub exhaust_pressure: Option<Text>,
    pub delivery_pressure: Option<Text>,
    pub clearance: Option<Text>,
    pub compression_exponent: Option<Text>,
    pub expansion_exponent: Option<Text>,
    pub heat: Option<Text>,
    pub peak_pressure: Option<Text>,
    pub mean_pressure: Option<Text>,
    pub wiebe_exponent: Option<Text>,
    pub intake_closes: Option<Text>,
    pub combustion_starts: Option<Text>,
    pub combustion_lasts: Option<Text>,
    pub exhaust_opens: Option<Text>,
    pub blowdown: Option<Text>,
    pub cylinder: Option<Spanned<Vec<Spanned<Table<Keys>>>>>,
    pub cylinders: Option<Spanned<Vec<Text>>>,
}

/// The keys that hold for some cylinders: their own before those of all.
pub(super) struct Layers<'a> {
    pub own: Option<&'a Keys>,
    pub all: &'a Keys,
    /// Where the table stands.
    pub span: Option<Range<usize>>,
}

impl<'a> Layers<'a> {
    /// A value.
    pub fn pick(&self, key: fn(&Keys) -> &Option<Text>) -> Option<&'a Text> {
        self.own.and_then(|own| key(own).as_ref()).or(key(self.all).as_ref())
    }

    /// The table that says one of several things which exclude each other.
    pub fn says(&self, says: fn(&Keys) -> bool) -> Option<&'a Keys> {
        self.own.filter(|own| says(own)).or(Some(self.all).filter(|all| says(all)))
    }

    /// A pressure with its unit, absolute.
    pub fn pressure(&self, key: fn(&Keys) -> &Option<Text>) -> Result<Option<BigRational>, LayoutError> {
        self.pick(key).map(absolute).transpose()
    }
}

/// An absolute pressure with its unit.
pub(super) fn absolute(text: &Text) -> Result<BigRational, LayoutError> {
    let value = value(text, "pressure", |text| units::pressure(text, None))?;
    let right = "above 0: an absolute pressure; gauge? add 1.013 bar";
    if value.is_positive() { Ok(value) } else { Err(misread(text, "pressure", right)) }
}
