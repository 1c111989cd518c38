//! How are several crankshafts written? `[[crankshaft]]`, and which of them a cylinder names.

use num_rational::BigRational;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde_spanned::Spanned;

use super::crankshaft_keys;
use super::error::LayoutError;
use super::quantities::{self, SENSES, choice, integer, misread};
use super::units;
use super::written::{Table, Text, place};
use crate::engine::{AxisLeftOut, Convention, Dimensions, GearedCrank, HIGHEST_ORDER, Linear, ORDERS};
use crate::exact::{Term, Turn};
use crate::proof::Sense;

/// What is below `crankshaft`: the masses of the only one, or a list of those that are geared together.
pub(super) enum Tables {
    /// `[crankshaft]`.
    Masses(Box<crankshaft_keys::Keys>),
    /// `[[crankshaft]]`.
    Geared(Vec<Spanned<Table<Keys>>>),
}

impl<'de> Deserialize<'de> for Tables {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrSeveral;
        impl<'de> Visitor<'de> for OneOrSeveral {
            type Value = Tables;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("the table [crankshaft], or one [[crankshaft]] for each of several")
            }
            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<Tables, A::Error> {
                crankshaft_keys::Keys::deserialize(MapAccessDeserializer::new(keys)).map(Box::new).map(Tables::Masses)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Tables, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(list)).map(Tables::Geared)
            }
        }
        deserializer.deserialize_any(OneOrSeveral)
    }
}

/// `[[crankshaft]]`: one of several that are geared together.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    name: Text,
    sense: Text,
    speed: Option<Text>,
    height: Option<Text>,
    offset: Option<Text>,
    distance: Option<Text>,
    angle: Option<Text>,
    phase: Option<Text>,
}

/// A crankshaft whose axis is still as it was written.
pub(super) struct Geared {
    pub name: String,
    pub sense: Sense,
    pub speed: u32,
    pub axis: Axis,
}

impl Geared {
    /// One that turns as fast as the others.
    pub fn new(name: &str, sense: Sense, axis: Axis) -> Self {
        Geared { name: name.to_owned(), sense, speed: 1, axis }
    }
}

/// Where an axis stands: lengths with a unit, or in crank radii.
pub(super) enum Axis {
    /// So high along the reference direction, and so far to its left.
    Across(Distance, Distance),
    /// So far in this direction.
    Towards(Distance, Turn),
    /// Above (+1/2) or below (−1/2) the middle, this many times a distance that is omitted.
    Above(BigRational),
    /// Nothing is said of it.
    LeftOut,
}

impl Axis {
    /// From a place in a drawing to one in angles in the sense of rotation: an offset to the left changes its sign.
    pub fn turn(&mut self, convention: Convention) {
        match self {
            Axis::Across(_, offset) => match offset {
                Distance::Times(factor, _) | Distance::Radii(factor) => {
                    *factor = convention.in_the_sense_of_rotation(factor.clone());
                }
            },
            Axis::Towards(_, angle) => {
                *angle = Turn::new(convention.in_the_sense_of_rotation(angle.turns().clone()));
            }
            Axis::Above(_) | Axis::LeftOut => {}
        }
    }
}

/// A length across the crankshaft: this many times what was written, or this many crank radii.
pub(super) enum Distance {
    Times(BigRational, Text),
    Radii(BigRational),
}

impl Distance {
    pub fn none() -> Self {
        Distance::Radii(integer(0))
    }

    pub fn of(times: BigRational, written: &Text) -> Self {
        Distance::Times(times, written.clone())
    }

    /// In crank radii.
    fn read(&self, crank_radius: Option<&BigRational>) -> Result<BigRational, LayoutError> {
        let (times, text) = match self {
            Distance::Radii(radii) => return Ok(radii.clone()),
            Distance::Times(times, text) => (times, text),
        };
        let written = &text.get_ref().0;
        let length = units::length(written).map_err(|right| misread(text, "length", right))?;
        match (length.has_unit, crank_radius) {
            (false, _) => Ok(times * length.value),
            (true, Some(radius)) => Ok(times * length.value / radius),
            (true, None) => Err(LayoutError::new(
                format!("`{written}` between crankshafts whose crank radius is not known"),
                "give stroke or crank_radius below [mechanism], or the distance in crank radii, without a unit",
                place(text),
            )),
        }
    }
}

/// The masses of the only crankshaft, with their place.
pub(super) fn masses(tables: &Spanned<Tables>) -> Option<(&crankshaft_keys::Keys, std::ops::Range<usize>)> {
    match tables.get_ref() {
        Tables::Masses(keys) => Some((keys, tables.span())),
        Tables::Geared(_) => None,
    }
}

/// The tables of several crankshafts; none where there is one.
pub(super) fn several(tables: Option<&Spanned<Tables>>) -> &[Spanned<Table<Keys>>] {
    match tables.map(Spanned::get_ref) {
        Some(Tables::Geared(tables)) => tables,
        Some(Tables::Masses(_)) | None => &[],
    }
}

/// The first phase that is written.
pub(super) fn first_phase(tables: &[Spanned<Table<Keys>>]) -> Option<&Text> {
    tables.iter().find_map(|table| table.get_ref().0.phase.as_ref())
}

/// Reads the tables of several crankshafts, and how far the throws of each are turned.
pub(super) fn read(tables: &[Spanned<Table<Keys>>]) -> Result<Vec<(Geared, BigRational)>, LayoutError> {
    let mut names: Vec<&str> = Vec::new();
    let one = |table: &Spanned<Table<Keys>>| {
        let keys = &table.get_ref().0;
        let axis = match (&keys.distance, &keys.angle) {
            (None, None) if keys.height.is_none() && keys.offset.is_none() => Axis::LeftOut,
            (None, None) => {
                let across = |text: &Option<Text>| match text {
                    Some(text) => Distance::of(integer(1), text),
                    None => Distance::none(),
                };
                Axis::Across(across(&keys.height), across(&keys.offset))
            }
            (Some(distance), Some(angle)) if keys.height.is_none() && keys.offset.is_none() => {
                let angle = Turn::new(quantities::known_angle(angle)?);
                Axis::Towards(Distance::of(integer(1), distance), angle)
            }
            _ => {
                let right = "height and offset, or distance and angle: one of the two pairs";
                return Err(LayoutError::new("the axis of a crankshaft is not given in one way", right, place(table)));
            }
        };
        let phase = keys.phase.as_ref().map_or(Ok(integer(0)), quantities::known_angle)?;
        let speed = keys.speed.as_ref().map_or(Ok(1), speed)?;
        Ok((Geared { name: keys.name.get_ref().0.clone(), sense: sense(&keys.sense)?, speed, axis }, phase))
    };
    for table in tables {
        let name = &table.get_ref().0.name;
        if names.contains(&name.get_ref().0.as_str()) {
            return Err(misread(name, "name of a second crankshaft", "a name of its own for each"));
        }
        names.push(&name.get_ref().0);
    }
    if let Some(first) =
        tables.first().map(|table| &table.get_ref().0.sense).filter(|sense| sense.get_ref().0 == "against")
    {
        let right = "\"with\": the first crankshaft is the one that angles are counted with";
        return Err(misread(first, "sense of the first crankshaft", right));
    }
    let of_first = tables.first().and_then(|table| table.get_ref().0.speed.as_ref());
    if let Some(text) = of_first.filter(|text| !is_once(text)) {
        let right = "1: the first crankshaft is the one that orders are counted with; take the slowest as the first, and give the others its multiples";
        return Err(misread(text, "speed of the first crankshaft", right));
    }
    for name in tables.iter().map(|table| &table.get_ref().0.name) {
        let written = &name.get_ref().0;
        if !(1..=12).contains(&written.len()) || !written.bytes().all(|byte| byte.is_ascii_alphanumeric()) {
            let right = "one to twelve letters or digits, such as \"left\"";
            return Err(misread(name, "name of a crankshaft", right));
        }
    }
    tables.iter().map(one).collect()
}

/// How many times a crankshaft turns while the reference turns once.
fn speed(text: &Text) -> Result<u32, LayoutError> {
    let whole = text.get_ref().0.parse::<u32>().ok().filter(|speed| ORDERS.contains(speed));
    whole.ok_or_else(|| {
        let right = format!(
            "a whole number from 1 to {HIGHEST_ORDER}, of the first crankshaft 1: take the slowest crankshaft as the first, and give the others its multiples"
        );
        misread(text, "speed of a crankshaft", right)
    })
}

fn is_once(text: &Text) -> bool {
    text.get_ref().0.parse() == Ok(1)
}

/// The speed of the first crankshaft that turns faster than the reference.
pub(super) fn faster(tables: &[Spanned<Table<Keys>>]) -> Option<&Text> {
    let mut speeds = tables.iter().filter_map(|table| table.get_ref().0.speed.as_ref());
    speeds.find(|text| !is_once(text))
}

/// With or against the reference.
pub(super) fn sense(text: &Text) -> Result<Sense, LayoutError> {
    choice(text, "sense of a crankshaft", "\"with\" the first crankshaft, or \"against\" it", &SENSES)
}

/// The crankshaft that a cylinder names; of several every cylinder names one.
pub(super) fn named(
    cranks: &[(Geared, BigRational)],
    name: Option<&Text>,
    cylinder: impl FnOnce() -> Option<std::ops::Range<usize>>,
) -> Result<usize, LayoutError> {
    let names = || cranks.iter().map(|(crank, _)| crank.name.as_str()).collect::<Vec<_>>().join(", ");
    match (name, cranks.is_empty()) {
        (None, true) => Ok(0),
        (Some(text), true) => {
            let right = "list the crankshafts in [[crankshaft]] tables, each with its name";
            Err(LayoutError::new(format!("no crankshaft is called {}", text.get_ref().0), right, place(text)))
        }
        (None, false) => {
            let right = format!("add crankshaft = \"…\", one of {}", names());
            Err(LayoutError::new("a cylinder does not say which crankshaft it works on", right, cylinder()))
        }
        (Some(text), false) => {
            let written = &text.get_ref().0;
            let found = cranks.iter().position(|(crank, _)| crank.name == *written);
            found.ok_or_else(|| misread(text, "crankshaft", format!("one of {}", names())))
        }
    }
}

/// The throw of the equivalent crank that turns with the reference: on one against it the mirror image in the cylinder's axis.
pub(super) fn equivalent(throw: &Linear, bank: &Linear, sense: Sense) -> Linear {
    match sense {
        Sense::Direct => throw.clone(),
        Sense::Reverse => bank.scaled(&integer(2)).minus(throw),
    }
}

/// The crankshafts with their axes in crank radii. The offsets of cylinders need nothing here: one counts with its own crank, and so
/// does that of the equivalent crank.
pub(super) fn placed(geared: &[Geared], dimensions: &Dimensions) -> Result<Vec<GearedCrank>, LayoutError> {
    let radius = dimensions.crank_radius.as_ref();
    let crank = |crank: &Geared| {
        let (name, sense) = (&crank.name, crank.sense);
        let placed = match &crank.axis {
            Axis::Across(height, offset) => GearedCrank::at(name, sense, height.read(radius)?, offset.read(radius)?),
            Axis::Towards(distance, angle) => GearedCrank::towards(name, sense, distance.read(radius)?, angle.clone()),
            Axis::Above(times) => {
                let term = Term { angle: Turn::zero(), weight: times.clone() };
                GearedCrank::without(name, sense, AxisLeftOut::Distance(term))
            }
            Axis::LeftOut => GearedCrank::without(name, sense, AxisLeftOut::Place),
        };
        Ok(placed.turning(crank.speed))
    };
    geared.iter().map(crank).collect()
}
