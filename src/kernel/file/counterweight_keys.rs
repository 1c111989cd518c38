//! How are counterweights written? `[[counterweight]]`, or for all throws by the part of the masses that they hold in balance.

use std::ops::Range;

use num_rational::BigRational;
use num_traits::Zero;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::quantities::{self, each, factor, mass, mass_radius, positive_metres, shown_position};
use super::written::{Column, Table, Text, place};
use crate::engine::{Counterweight, Engine, Throw};
use crate::exact::Turn;

/// `[[counterweight]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CounterweightKeys {
    throw: Option<Text>,
    angle: Option<Text>,
    mass: Option<Text>,
    radius: Option<Text>,
    mass_radius: Option<Text>,
    position: Option<Text>,
}

/// `counterweights = { rotating = 1, reciprocating = 0.6 }`: which parts of the masses of a throw they hold in balance.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Shares {
    rotating: Option<Column>,
    reciprocating: Option<Column>,
    rotating_and_half_reciprocating: Option<Column>,
}

/// What makes the counterweights of all throws.
pub(super) enum Made<'a> {
    /// This factor of all that turns and half of the reciprocating mass.
    Factor(&'a Column),
    /// These parts of what turns, and of the reciprocating mass.
    Parts(&'a Column, &'a Column),
}

impl<'a> Made<'a> {
    /// Those that the parts of the masses make.
    pub fn shares(shares: &'a Spanned<Table<Shares>>) -> Result<Self, LayoutError> {
        let keys = &shares.get_ref().0;
        match (&keys.rotating, &keys.reciprocating, &keys.rotating_and_half_reciprocating) {
            (None, None, Some(factor)) => Ok(Made::Factor(factor)),
            (Some(rotating), Some(reciprocating), None) => Ok(Made::Parts(rotating, reciprocating)),
            (_, _, Some(both)) => {
                let right = "rotating and reciprocating, or rotating_and_half_reciprocating alone";
                Err(LayoutError::new("the counterweights are sized twice", right, place(both)))
            }
            (_, _, None) => {
                let right = "{ rotating = 1, reciprocating = 0.6 } balances all rotating masses and 60 % of the reciprocating ones; 0 for none";
                Err(LayoutError::new("counterweights whose part of some masses is missing", right, place(shares)))
            }
        }
    }

    /// Where it is in the file.
    pub fn place(&self) -> Option<Range<usize>> {
        match self {
            Made::Factor(list) | Made::Parts(list, _) => place(list),
        }
    }

    /// `Σ m_cw r_cw` of each throw in kilogram-metres, and its balance factor in the sense of the theory (section 7): U over
    /// `m_rot r + ½ Σ m_rec r`; 0 for a throw without mass.
    pub fn sizes(
        &self,
        parts: &[[BigRational; 2]],
        throws: &[Throw],
    ) -> Result<(Vec<BigRational>, Vec<BigRational>), LayoutError> {
        let two = BigRational::from_integer(2.into());
        let whole = |[rotating, reciprocating]: &[BigRational; 2]| rotating + reciprocating / &two;
        match self {
            Made::Factor(list) => {
                let factors = each(list, throws, factor)?;
                Ok((parts.iter().zip(&factors).map(|(parts, factor)| whole(parts) * factor).collect(), factors))
            }
            Made::Parts(rotating, reciprocating) => {
                let shares = each(rotating, throws, factor)?.into_iter().zip(each(reciprocating, throws, factor)?);
                let sizes = parts
                    .iter()
                    .zip(shares)
                    .map(|([turns, goes], (rotating, reciprocating))| turns * rotating + goes * reciprocating);
                let sizes: Vec<BigRational> = sizes.collect();
                let factor = |(size, parts): (&BigRational, &[BigRational; 2])| match whole(parts) {
                    whole if whole.is_zero() => BigRational::zero(),
                    whole => size / whole,
                };
                let factors = sizes.iter().zip(parts).map(factor).collect();
                Ok((sizes, factors))
            }
        }
    }
}

/// Reads one table, and whether its weight is written in multiples of m r; `along` reads a length along the crankshaft.
pub(super) fn read(
    table: &Spanned<Table<CounterweightKeys>>,
    engine: &Engine,
    throws: &[Throw],
    along: impl FnOnce(&Text) -> Result<BigRational, LayoutError>,
) -> Result<(Counterweight, bool), LayoutError> {
    let keys = &table.get_ref().0;
    let throw = keys.throw.as_ref().map(|text| number_of_throw(text, throws.len())).transpose()?;
    // As drawn, in the sense of rotation.
    let direction = |text: &Text| -> Result<Turn, LayoutError> {
        Ok(Turn::new(engine.convention().in_the_sense_of_rotation(quantities::known_angle(text)?)))
    };
    let angle = match (&keys.angle, throw) {
        (Some(text), None) => direction(text)?,
        (Some(text), Some(throw)) => &throws[throw].angle + &direction(text)?,
        (None, Some(throw)) => throws[throw].angle.opposite(),
        (None, None) => {
            let right = "add its angle, and its throw if the angle counts from one";
            return Err(LayoutError::new("a counterweight without a direction", right, place(table)));
        }
    };
    let position = match (&keys.position, throw) {
        (Some(text), _) => along(text)?,
        (None, Some(throw)) => throws[throw].position.clone(),
        (None, None) => {
            let right = "add its position along the crankshaft, or the throw that it belongs to";
            return Err(LayoutError::new("a counterweight without a position", right, place(table)));
        }
    };
    on_the_shaft(engine, &position, keys.position.as_ref().and_then(place).or(place(table)))?;
    let (mass, radius, in_multiples) = weight(table, engine)?;
    let crank = throw.map_or(0, |throw| throws[throw].crank);
    Ok((Counterweight { throw, angle, mass, radius, position, crank }, in_multiples))
}

/// Mass and radius of a counterweight, and whether they are multiples of m r.
fn weight(
    table: &Spanned<Table<CounterweightKeys>>,
    engine: &Engine,
) -> Result<(BigRational, BigRational, bool), LayoutError> {
    let keys = &table.get_ref().0;
    let missing = |key: &str, right: &'static str| {
        Err(LayoutError::new(format!("the key `{key}` is missing"), right, place(table)))
    };
    match (&keys.mass, &keys.radius, &keys.mass_radius) {
        (Some(text), Some(radius), None) => Ok((mass(text)?, positive_metres(radius)?, false)),
        (None, None, Some(text)) => {
            // A mass at the crank radius, and where that is not known, at one metre.
            let radius = engine.unit_radius();
            let (value, in_multiples) = mass_radius(text, &(engine.unit_mass() * &radius))?;
            Ok((value / &radius, radius, in_multiples))
        }
        (Some(_), None, None) => missing("radius", "the distance of its centre of gravity from the axis"),
        (None, _, None) => missing("mass", "its mass and radius, or mass_radius such as \"0.01 kg m\" or \"1/4 m r\""),
        (_, _, Some(text)) => {
            let right = "mass and radius, or mass_radius: one of them is enough";
            Err(LayoutError::new("the weight of a counterweight is given twice", right, place(text)))
        }
    }
}

fn number_of_throw(text: &Text, count: usize) -> Result<usize, LayoutError> {
    let written = &text.get_ref().0;
    let number = written.parse::<usize>().ok().filter(|number| (1..=count).contains(number));
    number.map(|number| number - 1).ok_or_else(|| {
        let right = match count {
            1 => "the crankshaft has one throw: 1".to_owned(),
            _ => format!("the crankshaft has the throws 1 to {count}, in the order of its pins"),
        };
        let message = format!("there is no throw `{}`", written.chars().take(40).collect::<String>());
        LayoutError::new(message, right, place(text))
    })
}

/// A counterweight has to be on the crankshaft.
pub(super) fn on_the_shaft(
    engine: &Engine,
    position: &BigRational,
    span: Option<Range<usize>>,
) -> Result<(), LayoutError> {
    match engine.shaft_ends() {
        Some([low, high]) if *position < low || *position > high => {
            let [at, low, high] = [position, &low, &high].map(|at| shown_position(at, engine.length_unit()));
            let message = format!("a counterweight at {at} is beyond the crankshaft");
            Err(LayoutError::new(message, format!("the shaft reaches from {low} to {high}"), span))
        }
        _ => Ok(()),
    }
}
