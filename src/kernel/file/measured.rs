//! How is a quantity of the mechanism read? One value for all cylinders or a list, in the unit of the quantity.

use num_rational::BigRational;
use num_traits::Signed;

use super::error::LayoutError;
use super::quantities::{for_each, misread};
use super::units;
use super::written::{self, Text, Values};
use crate::engine::{Given, Measure};
use crate::text::Untrusted;

/// One key, read: a value per cylinder, with the place of each.
pub(super) struct Column {
    pub values: Vec<BigRational>,
    pub places: Vec<Text>,
}

/// What has been read of the table.
pub(super) struct Reading {
    /// How many cylinders there are.
    pub count: usize,
    /// The values as they are written.
    pub given: Vec<Given>,
}

impl Reading {
    /// Nothing yet, for this many cylinders.
    pub fn new(count: usize) -> Self {
        Reading { count, given: Vec::new() }
    }

    /// A key, if it is there.
    pub fn column(&mut self, list: &Option<written::Column>, quantity: Measure) -> Result<Option<Column>, LayoutError> {
        let Some(list) = list else { return Ok(None) };
        let right = "one value for all, or a list with one per cylinder";
        let places = for_each(list, self.count, "cylinder", right)?;
        let values = places.iter().map(|text| quantity.read(text)).collect::<Result<Vec<_>, _>>()?;
        let of_all = matches!(list.get_ref(), Values::One(_));
        let told = if of_all { 1 } else { self.count };
        for (index, (value, text)) in values.iter().zip(&places).enumerate().take(told) {
            let written = text.get_ref().0.clone();
            let cylinder = (!of_all).then_some(index);
            self.given.push(Given { quantity, cylinder, value: value.clone(), written: Untrusted::new(written) });
        }
        Ok(Some(Column { values, places }))
    }
}

impl Measure {
    /// Reads a value in the unit of this quantity.
    pub(super) fn read(self, text: &Text) -> Result<BigRational, LayoutError> {
        let written = &text.get_ref().0;
        let pure = |text: &str| super::parse_number(text).map_err(|error| error.to_string());
        use Measure::*;
        let (name, value, smallest) = match self {
            Speed => ("speed", units::speed(written), "a speed is 0 or more"),
            Stroke => ("stroke", units::metres(written), "a length above 0"),
            CrankRadius => ("crank radius", units::metres(written), "a length above 0"),
            RodLength => ("rod length", units::metres(written), "a length above 0"),
            RodRatio => ("rod ratio", pure(written), "r/l, from 0 up to 1"),
            PinOffset => ("pin offset", units::metres(written), ""),
            OffsetRatio => ("offset ratio", pure(written), ""),
            KnuckleRadius => ("knuckle radius", units::metres(written), "a length above 0"),
            KnuckleRatio => ("knuckle ratio", pure(written), "a number above 0"),
            LinkLength => ("link length", units::metres(written), "a length above 0"),
            LinkRatio => ("link ratio", pure(written), "a number above 0"),
            ReciprocatingMass | PistonMass | PinMass | PistonRodMass | CrossheadMass | RodMass | RotatingMass
            | KnuckleMass => ("mass", units::mass(written), "a mass is 0 or more"),
            RodCentre => ("distance of the centre of gravity", units::metres(written), "a length of 0 or more"),
        };
        let value = value.map_err(|right| misread(text, name, right))?;
        let fits = match self {
            Stroke | CrankRadius | RodLength | KnuckleRadius | KnuckleRatio | LinkLength | LinkRatio => {
                value.is_positive()
            }
            PinOffset | OffsetRatio => true,
            Speed | RodRatio | ReciprocatingMass | PistonMass | PinMass | PistonRodMass | CrossheadMass | RodMass
            | RodCentre | RotatingMass | KnuckleMass => !value.is_negative(),
        };
        if fits { Ok(value) } else { Err(misread(text, name, smallest)) }
    }
}
