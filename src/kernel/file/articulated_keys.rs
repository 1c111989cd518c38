//! How are articulated rods written? `[articulated]`: who is a master, and how the links hang on its rod.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::{LayoutError, built};
use super::knuckle_keys;
use super::quantities::{cylinder, for_each, texts, twice};
use super::written::{Column, Table, Text, Values, place};
use crate::engine::{Cylinder, Draft, Engine, Given, Link, Measure, Mechanism};
use crate::exact::Turn;
use crate::text::Untrusted;

/// `[articulated]`: every cylinder on the crankpin of a master hangs on its rod, but the master itself.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    master: Column,
    knuckle_radius: Option<Column>,
    knuckle_ratio: Option<Column>,
    link_length: Option<Column>,
    link_ratio: Option<Column>,
    knuckle_angle: Option<Column>,
    knuckle_correction: Option<Column>,
    knuckle_mass: Option<Column>,
}

type Articulated = Spanned<Table<Keys>>;

/// The engine with the links that the table names.
pub(super) fn read(table: &Articulated, engine: Engine) -> Result<Engine, LayoutError> {
    let keys = &table.get_ref().0;
    let masters = keys.masters(&engine)?;
    let on_pin = |pin: usize| masters.iter().copied().find(|&master| engine.cylinders()[master].pin == pin);
    let cylinders = engine.cylinders().iter().enumerate();
    let links: Vec<(usize, usize)> = cylinders
        .filter(|(index, _)| !masters.contains(index))
        .filter_map(|(index, cylinder)| Some((index, on_pin(cylinder.pin)?)))
        .collect();
    if links.is_empty() {
        let right = "a master shares its crankpin with other cylinders, whose links are on its rod";
        return Err(LayoutError::new("no cylinder has a link", right, place(&keys.master)));
    }
    let lone = masters.iter().find(|master| !links.iter().any(|(_, own)| own == *master));
    if let Some(master) = lone {
        let name = &engine.cylinders()[*master].name;
        let message = format!("no link is on the rod of cylinder {name}: no other cylinder is on its crankpin");
        return Err(LayoutError::new(message, "leave it out", place(&keys.master)));
    }
    let mut changed = engine.cylinders().to_vec();
    let rows = Rows { keys, engine: &engine, count: links.len(), table };
    for (row, &(index, master)) in links.iter().enumerate() {
        let (mechanism, knuckle_mass) = rows.link(row, index, master)?;
        changed[index].mechanism = Some(mechanism);
        changed[index].knuckle_mass = knuckle_mass;
    }
    let given = keys.given(&links)?;
    let mut draft = Draft { cylinders: changed, ..engine.into_draft() };
    draft.dimensions.given.extend(given);
    built(draft.build())
}

/// The error of a layout whose angles or lengths are open.
pub(super) fn of_open_layout(table: &Articulated) -> LayoutError {
    let message = "articulated rods in an engine with unknown angles or positions";
    LayoutError::new(message, "write the angles and positions as numbers", place(table))
}

impl Keys {
    /// Of knuckle pins and of links: the length, and the ratio that may stand for it.
    fn lengths(&self) -> [[Key<'_>; 2]; 2] {
        use Measure::*;
        let key = |name, measure, column| Key { name, measure, column: Option::as_ref(column) };
        [
            [
                key("knuckle_radius", KnuckleRadius, &self.knuckle_radius),
                key("knuckle_ratio", KnuckleRatio, &self.knuckle_ratio),
            ],
            [key("link_length", LinkLength, &self.link_length), key("link_ratio", LinkRatio, &self.link_ratio)],
        ]
    }

    /// What is said of the links, cylinders by their index, as written.
    fn given(&self, links: &[(usize, usize)]) -> Result<Vec<Given>, LayoutError> {
        let lengths = self.lengths().concat();
        let columns = lengths.into_iter().filter_map(|key| Some((key.measure, key.column?)));
        let masses = self.knuckle_mass.iter().map(|column| (Measure::KnuckleMass, column));
        let mut given = Vec::new();
        for (quantity, column) in columns.chain(masses) {
            let of_all = matches!(column.get_ref(), Values::One(_));
            for ((index, _), text) in links.iter().zip(texts(column)) {
                let cylinder = (!of_all).then_some(*index);
                let written = Untrusted::new(text.get_ref().0.as_str());
                given.push(Given { quantity, cylinder, value: quantity.read(&text)?, written });
            }
        }
        Ok(given)
    }

    /// The masters by their index, at most one on each crankpin.
    fn masters(&self, engine: &Engine) -> Result<Vec<usize>, LayoutError> {
        let mut masters: Vec<usize> = Vec::new();
        for text in &texts(&self.master) {
            let name = &text.get_ref().0;
            let Some(index) = cylinder(text, engine.cylinders()) else {
                let shown: String = name.chars().take(40).collect();
                let [first, last] = [0, engine.cylinders().len() - 1].map(|index| &engine.cylinders()[index].name);
                let right = format!(
                    "the name of a cylinder, {first} to {last}; a list of them where there are several crankpins"
                );
                return Err(LayoutError::new(format!("there is no cylinder `{shown}`"), right, place(text)));
            };
            let pin = engine.cylinders()[index].pin;
            if let Some(&other) = masters.iter().find(|&&other| engine.cylinders()[other].pin == pin) {
                let message = format!("cylinders {} and {name} share a crankpin", engine.cylinders()[other].name);
                return Err(LayoutError::new(message, "one of them is the master of this pin", place(text)));
            }
            masters.push(index);
        }
        Ok(masters)
    }
}

/// A key of links as it was written, if it was, and what its values measure.
#[derive(Clone, Copy)]
struct Key<'a> {
    name: &'static str,
    measure: Measure,
    column: Option<&'a Column>,
}

/// The values of the links, by their place among them.
struct Rows<'a> {
    keys: &'a Keys,
    engine: &'a Engine,
    count: usize,
    table: &'a Articulated,
}

impl Rows<'_> {
    /// The link of a cylinder on the rod of its master, and the mass at its knuckle pin in multiples of m.
    fn link(&self, row: usize, index: usize, master: usize) -> Result<(Mechanism, BigRational), LayoutError> {
        let (cylinder, master) = (&self.engine.cylinders()[index], &self.engine.cylinders()[master]);
        self.check(cylinder, master)?;
        let fault = |message: String, right: &str| LayoutError::new(message, right, place(self.table));
        let Some(rod) = master.rod().filter(|rod| rod.offset.is_zero() && rod.ratio.is_positive()) else {
            let message = format!("the rod of master {} is not known, endless, or has an offset", master.name);
            return Err(fault(
                message,
                "below [mechanism], give its rod_ratio, or its rod_length with the stroke; no offset",
            ));
        };
        let one = BigRational::one();
        let [radii, lengths] = self.keys.lengths();
        let knuckle = match self.one_of(radii, row)? {
            Some(Measured::Length(radius, text)) => radius / self.rod_length(master, &rod.ratio, &text)?,
            Some(Measured::Ratio(ratio)) => ratio,
            None => {
                let right =
                    "the distance of the knuckle pins from the crankpin: knuckle_radius, or knuckle_ratio = a/l";
                return Err(fault("no knuckle radius".to_owned(), right));
            }
        };
        let ratio = match self.one_of(lengths, row)? {
            Some(Measured::Length(length, text)) => &rod.ratio * self.rod_length(master, &rod.ratio, &text)? / length,
            Some(Measured::Ratio(ratio)) => ratio,
            None if knuckle < one => &rod.ratio / (&one - &knuckle),
            None => {
                let message = "the knuckle pins are farther out than the master rod is long".to_owned();
                return Err(fault(message, "give the link_length, which is l − a by default"));
            }
        };
        let angle = &cylinder.bank - &master.bank;
        let pins = knuckle_keys::Keys {
            angle: self.keys.knuckle_angle.as_ref(),
            correction: self.keys.knuckle_correction.as_ref(),
        };
        let correction = pins.correction((&cylinder.name, &angle), |list| self.value(list, row))?;
        let nearly = if correction == Turn::zero() { "" } else { ", or within a hundredth of that" };
        let link = Mechanism::Link(Link { master: rod.ratio.clone(), knuckle, angle, correction, ratio });
        if !link.turns_round() {
            let name = &cylinder.name;
            let message = format!("the link of cylinder {name} is too short for its crank to turn round{nearly}");
            return Err(fault(
                message,
                "it has to be longer than its knuckle pin swings across the axis of the cylinder",
            ));
        }
        Ok((link, self.mass(row)?))
    }

    /// What a cylinder with a link and its master have in common, and what the link has not.
    fn check(&self, cylinder: &Cylinder, master: &Cylinder) -> Result<(), LayoutError> {
        let differ = |what: &str, right: &str| {
            let message = format!("cylinder {} and its master {} differ in {what}", cylinder.name, master.name);
            Err(LayoutError::new(message, right, place(self.table)))
        };
        let place_of = |at: &Cylinder| (at.throw.clone(), at.position.clone());
        if place_of(cylinder) != place_of(master) {
            return differ("throw or position", "a link works on the crankpin of its master, in the same plane");
        }
        if cylinder.crank_radius != master.crank_radius || cylinder.mechanism != master.mechanism {
            return differ("crank or rod", "below [mechanism] is the master rod; links have link_length or link_ratio");
        }
        match cylinder.rotating_mass.is_zero() {
            true => Ok(()),
            false => {
                let message = format!("cylinder {} has a link and yet a rotating mass on the crankpin", cylinder.name);
                let right = "list rotating_mass, or rod_mass, by cylinder, 0 for links: big end of a link and knuckle pin are its knuckle_mass, and its small end counts in piston_mass or reciprocating_mass";
                Err(LayoutError::new(message, right, place(self.table)))
            }
        }
    }

    /// A length, or a ratio, or none.
    fn one_of(&self, [length, ratio]: [Key<'_>; 2], row: usize) -> Result<Option<Measured>, LayoutError> {
        match (length.column, ratio.column) {
            (Some(_), Some(list)) => Err(twice(length.name, ratio.name, list)),
            (Some(list), None) => {
                let text = self.value(list, row)?;
                Ok(Some(Measured::Length(length.measure.read(&text)?, text)))
            }
            (None, Some(list)) => Ok(Some(Measured::Ratio(ratio.measure.read(&self.value(list, row)?)?))),
            (None, None) => Ok(None),
        }
    }

    /// The length of the master rod in metres, beside a length of the table.
    fn rod_length(&self, master: &Cylinder, ratio: &BigRational, text: &Text) -> Result<BigRational, LayoutError> {
        match &self.engine.dimensions().crank_radius {
            Some(radius) => Ok(radius * &master.crank_radius / ratio),
            None => {
                let right =
                    "below [mechanism], give stroke or crank_radius; or write knuckle_ratio = a/l and link_ratio = r/L";
                Err(LayoutError::new("a length of links without a crank radius", right, place(text)))
            }
        }
    }

    fn mass(&self, row: usize) -> Result<BigRational, LayoutError> {
        let Some(list) = &self.keys.knuckle_mass else { return Ok(BigRational::zero()) };
        let text = self.value(list, row)?;
        let mass = Measure::KnuckleMass.read(&text)?;
        match self.engine.dimensions().mass.as_ref().filter(|unit| unit.is_positive()) {
            Some(unit) => Ok(mass / unit),
            None if mass.is_zero() => Ok(mass),
            None => {
                let right = "below [mechanism], give reciprocating_mass";
                Err(LayoutError::new(
                    "a knuckle mass beside reciprocating masses that are not known",
                    right,
                    place(&text),
                ))
            }
        }
    }

    /// The value of a link: that of all, or its own.
    fn value(&self, list: &Column, row: usize) -> Result<Text, LayoutError> {
        let right = "one value for all, or a list with one per link, in the order of their cylinders";
        Ok(for_each(list, self.count, "link", right)?.swap_remove(row))
    }
}

/// A measure of a link.
enum Measured {
    /// In metres, as written.
    Length(BigRational, Text),
    Ratio(BigRational),
}
