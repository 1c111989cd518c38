//! How are balancer shafts written? `[[balancer]]`.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::number::parse_number;
use super::quantities::{self, SENSES, choice, cylinder, mass, mass_radius, metres, misread, positive_metres};
use super::written::{Table, Text, place};
use crate::engine::{Balancer, Engine, HIGHEST_ORDER, ShaftAxis};
use crate::exact::Turn;

/// `[[balancer]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    order: Text,
    sense: Text,
    mass: Option<Text>,
    radius: Option<Text>,
    mass_radius: Option<Text>,
    coefficient_of: Option<Text>,
    angle: Text,
    position: Option<Text>,
    height: Option<Text>,
    offset: Option<Text>,
}

/// Reads one table, and whether its weight is written in multiples of m r; `along` reads a length along the crankshaft.
pub(super) fn read(
    table: &Spanned<Table<Keys>>,
    engine: &Engine,
    along: impl FnOnce(&Text) -> Result<BigRational, LayoutError>,
) -> Result<(Balancer, bool), LayoutError> {
    let keys = &table.get_ref().0;
    let convention = engine.convention();
    let unit = engine.unit_mass() * engine.unit_radius();
    let (mass_radius, in_multiples) = match (&keys.mass, &keys.radius, &keys.mass_radius) {
        (Some(weight), Some(radius), None) => (mass(weight)? * positive_metres(radius)?, false),
        (None, None, Some(text)) => mass_radius(text, &unit)?,
        (None, None, None) => {
            let right = "add mass and radius, or mass_radius in kg m";
            return Err(LayoutError::new("a balancer shaft without a weight", right, place(table)));
        }
        (_, _, Some(text)) => {
            let right = "mass and radius, or mass_radius: one of them is enough";
            return Err(LayoutError::new("the weight of a balancer shaft is given twice", right, place(text)));
        }
        (Some(text), None, None) => {
            return Err(LayoutError::new("a mass without its radius", "add radius", place(text)));
        }
        (None, Some(text), None) => {
            return Err(LayoutError::new("a radius without its mass", "add mass", place(text)));
        }
    };
    let Some(position) = &keys.position else {
        let right = "[[balancer]] needs position: where its weight is along the crankshaft, such as position = 0";
        return Err(LayoutError::new("a balancer shaft without a position", right, place(table)));
    };
    let zero = |text: &Option<Text>| text.as_ref().map_or(Ok(BigRational::zero()), metres);
    let axis = match (&keys.height, &keys.offset) {
        (None, None) => None,
        (height, offset) => Some(ShaftAxis {
            height: zero(height)?,
            // To the left of the drawing: the side of angle 90 there.
            offset: convention.in_the_sense_of_rotation(zero(offset)?),
        }),
    };
    let named = |text: &Text| {
        let right = "the name of the cylinder whose piston motion the shaft answers";
        cylinder(text, engine.cylinders()).ok_or_else(|| misread(text, "cylinder", right))
    };
    let shaft = Balancer {
        order: speed_ratio(&keys.order)?,
        sense: choice(&keys.sense, "sense", "\"with\" or \"against\" the crank", &SENSES)?,
        mass_radius,
        coefficient_of: keys.coefficient_of.as_ref().map(named).transpose()?,
        angle: Turn::new(convention.in_the_sense_of_rotation(quantities::known_angle(&keys.angle)?)),
        position: along(position)?,
        axis,
    };
    Ok((shaft, in_multiples))
}

/// A whole multiple of the crank speed.
fn speed_ratio(text: &Text) -> Result<u32, LayoutError> {
    let written = &text.get_ref().0;
    if let Ok(order) = written.parse::<u32>()
        && (1..=HIGHEST_ORDER).contains(&order)
    {
        return Ok(order);
    }
    let half = BigRational::new(1.into(), 2.into());
    let right = match parse_number(written) {
        Ok(value) if value.abs() == half => {
            "a shaft at half crank speed turns once in two revolutions, and no inertia force of the cranks has order 1/2"
                .to_owned()
        }
        Ok(value) if !value.is_integer() => format!(
            "inertia forces repeat with every revolution: their orders are whole numbers, and so is that of a shaft, 1 to {HIGHEST_ORDER}"
        ),
        Ok(value) if value.is_negative() => "a whole number above 0; sense = \"against\" turns the other way".to_owned(),
        _ => format!("a whole number from 1 to {HIGHEST_ORDER}: how many times the shaft turns in a revolution"),
    };
    Err(misread(text, "order of a balancer shaft", right))
}
