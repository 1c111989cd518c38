//! How are the masses on the crankshaft written? `[crankshaft]`, `[[counterweight]]`.

use std::collections::BTreeMap;
use std::ops::Range;

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::balancer_keys;
use super::error::LayoutError;
use super::layout::built;
use super::quantities::{self, factor, mass, metres, misread, positive_metres};
use super::written::{Column, Table, Text, Values, place};
use crate::engine::{Counterweight, Crankshaft, Draft, Engine, LengthUnit, Throw, Web, throws};
use crate::exact::Turn;

/// `[crankshaft]`: each mass key holds one value for all throws, or a list with one per throw.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    length: Option<Text>,
    pin_mass: Option<Column>,
    web_mass: Option<Column>,
    web_radius: Option<Column>,
    balance_factor: Option<Column>,
    counterweight_radius: Option<Column>,
    web_offset: Option<Column>,
}

/// `[[counterweight]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CounterweightKeys {
    throw: Option<Text>,
    angle: Option<Text>,
    mass: Text,
    radius: Text,
    position: Option<Text>,
}

/// The tables of a file that speak of what turns, and what they refer to.
pub(super) struct Tables<'a> {
    pub crankshaft: Option<(&'a Keys, Range<usize>)>,
    pub counterweights: &'a Option<Spanned<Vec<Spanned<Table<CounterweightKeys>>>>>,
    pub balancers: &'a Option<Spanned<Vec<Spanned<Table<balancer_keys::Keys>>>>>,
    pub values: &'a BTreeMap<String, BigRational>,
}

impl Tables<'_> {
    /// The place of the first of them, if there is any.
    pub fn place(&self) -> Option<Range<usize>> {
        let crankshaft = self.crankshaft.as_ref().map(|(_, span)| span.clone());
        crankshaft.or(self.counterweights.as_ref().map(Spanned::span)).or(self.balancers.as_ref().map(Spanned::span))
    }

    /// The engine with what the tables add to it, which may make it one in metres.
    pub fn read(&self, engine: Engine) -> Result<Engine, LayoutError> {
        let throws = throws(&engine);
        let mut unit = engine.length_unit();
        // Balance factors are about what turns without counterweights.
        let bare = match &self.crankshaft {
            None => engine,
            Some((keys, _)) => {
                let crankshaft = self.masses(keys, &engine, &throws, &mut unit)?;
                built(Draft { crankshaft, ..engine.into_draft() }.build())?
            }
        };
        let mut crankshaft = bare.crankshaft().clone();
        let asked = self.crankshaft.as_ref().and_then(|(keys, _)| keys.balance_factor.as_ref());
        match (asked, self.counterweights) {
            (Some(_), Some(list)) => {
                let message = "both a balance factor and counterweights are given";
                return Err(LayoutError::new(message, "a balance factor makes the counterweights itself", place(list)));
            }
            (Some(factors), None) => {
                let (weights, factors) = self.make_counterweights(factors, &bare, &throws, &mut unit)?;
                crankshaft.counterweights = weights;
                crankshaft.balance_factors = factors;
            }
            (None, Some(list)) => {
                let weights = list.get_ref().iter().map(|table| self.counterweight(table, &bare, &throws, &mut unit));
                crankshaft.counterweights = weights.collect::<Result<_, _>>()?;
            }
            (None, None) => {}
        }
        for table in self.balancers.iter().flat_map(|list| list.get_ref()) {
            let shaft = balancer_keys::read(table, |text| self.along(text, &bare, &mut unit))?;
            crankshaft.balancers.push(shaft);
        }
        built(Draft { crankshaft, length_unit: unit, ..bare.into_draft() }.build())
    }

    /// Length, pins and webs.
    fn masses(
        &self,
        keys: &Keys,
        engine: &Engine,
        throws: &[Throw],
        unit: &mut LengthUnit,
    ) -> Result<Crankshaft, LayoutError> {
        let mut crankshaft = Crankshaft::default();
        if let Some(text) = &keys.length {
            let length = self.along(text, engine, unit)?;
            if !length.is_positive() {
                return Err(misread("length", &text.get_ref().0, "a length above 0".to_owned(), text));
            }
            crankshaft.length = Some(length);
        }
        if let Some(list) = &keys.pin_mass {
            crankshaft.pins = each(list, throws, mass)?;
        }
        crankshaft.webs = match (&keys.web_mass, &keys.web_radius) {
            (Some(masses), Some(radii)) => {
                let pairs = each(masses, throws, mass)?.into_iter().zip(each(radii, throws, metres)?);
                pairs.map(|(mass, radius)| Web { mass, radius }).collect()
            }
            (Some(list), None) => {
                let right = "add web_radius, the distance of their centre of gravity from the axis";
                return Err(LayoutError::new("a web mass without its radius", right, place(list)));
            }
            (None, Some(list)) => {
                let right = "add web_mass, that of both webs of a throw";
                return Err(LayoutError::new("a web radius without a mass", right, place(list)));
            }
            (None, None) => Vec::new(),
        };
        if let (None, Some(list)) =
            (&keys.balance_factor, keys.counterweight_radius.as_ref().or(keys.web_offset.as_ref()))
        {
            let right = "they place the counterweights that a balance_factor makes: add it";
            return Err(LayoutError::new("counterweights without their size", right, place(list)));
        }
        Ok(crankshaft)
    }

    /// Counterweights opposite to each throw, sized by its balance factor: two beside it, or one in its plane; and the factors.
    fn make_counterweights(
        &self,
        list: &Column,
        engine: &Engine,
        throws: &[Throw],
        unit: &mut LengthUnit,
    ) -> Result<(Vec<Counterweight>, Vec<BigRational>), LayoutError> {
        let keys = self.crankshaft.as_ref().map(|(keys, _)| keys);
        let Some((keys, radii)) = keys.and_then(|keys| Some((keys, keys.counterweight_radius.as_ref()?))) else {
            let right = "add counterweight_radius, the distance of their centres of gravity from the axis";
            return Err(LayoutError::new(
                "a balance factor without the radius of the counterweights",
                right,
                place(list),
            ));
        };
        let radii = each(radii, throws, positive_metres)?;
        let factors = each(list, throws, factor)?;
        let offsets = match &keys.web_offset {
            Some(list) => Some(each(list, throws, |text| self.along(text, engine, unit))?),
            None => None,
        };
        let two = BigRational::from_integer(2.into());
        let Some(wholes) = engine.throw_mass_radii() else {
            let right = "below [mechanism], give reciprocating_mass or piston_mass, and stroke or crank_radius";
            return Err(LayoutError::new("a balance factor in an engine without masses", right, place(list)));
        };
        let mut weights = Vec::new();
        for (index, throw) in throws.iter().enumerate() {
            let mass = &wholes[index] * &factors[index] / &radii[index];
            let weight = |mass: BigRational, position: BigRational| Counterweight {
                throw: Some(index),
                angle: throw.angle.opposite(),
                mass,
                radius: radii[index].clone(),
                position,
                crank: throw.crank,
            };
            match offsets.as_ref().map(|offsets| &offsets[index]).filter(|offset| !offset.is_zero()) {
                Some(offset) => {
                    for position in [&throw.position + offset, &throw.position - offset] {
                        on_the_shaft(engine, &position, keys.web_offset.as_ref().and_then(place))?;
                        weights.push(weight(&mass / &two, position));
                    }
                }
                None => weights.push(weight(mass, throw.position.clone())),
            }
        }
        Ok((weights, factors))
    }

    fn counterweight(
        &self,
        table: &Spanned<Table<CounterweightKeys>>,
        engine: &Engine,
        throws: &[Throw],
        unit: &mut LengthUnit,
    ) -> Result<Counterweight, LayoutError> {
        let keys = &table.get_ref().0;
        let throw = keys.throw.as_ref().map(|text| number_of_throw(text, throws.len())).transpose()?;
        let angle = match (&keys.angle, throw) {
            (Some(text), None) => Turn::new(quantities::known_angle(text)?),
            (Some(text), Some(throw)) => &throws[throw].angle + &Turn::new(quantities::known_angle(text)?),
            (None, Some(throw)) => throws[throw].angle.opposite(),
            (None, None) => {
                let right = "add its angle, and its throw if the angle counts from one";
                return Err(LayoutError::new("a counterweight without a direction", right, place(table)));
            }
        };
        let position = match (&keys.position, throw) {
            (Some(text), _) => self.along(text, engine, unit)?,
            (None, Some(throw)) => throws[throw].position.clone(),
            (None, None) => {
                let right = "add its position along the crankshaft, or the throw that it belongs to";
                return Err(LayoutError::new("a counterweight without a position", right, place(table)));
            }
        };
        on_the_shaft(engine, &position, keys.position.as_ref().and_then(place).or(place(table)))?;
        let crank = throw.map_or(0, |throw| throws[throw].crank);
        let (mass, radius) = (mass(&keys.mass)?, positive_metres(&keys.radius)?);
        Ok(Counterweight { throw, angle, mass, radius, position, crank })
    }

    /// A length along the crankshaft, in the unit of the positions.
    fn along(&self, text: &Text, engine: &Engine, unit: &mut LengthUnit) -> Result<BigRational, LayoutError> {
        let mut own = LengthUnit::Spacing;
        let length = quantities::length(text, &mut own)?.with(self.values);
        let Some(known) = length.as_known() else {
            return Err(misread("length", &text.get_ref().0, "a length whose symbols have values".to_owned(), text));
        };
        if own == LengthUnit::Metre && !engine.positions_given() {
            let right = "give the engine its spacing or positions, or count in spacings here too";
            return Err(LayoutError::new(
                "a length in an engine whose cylinders stand one spacing apart",
                right,
                place(text),
            ));
        }
        if own == LengthUnit::Metre {
            *unit = own;
        }
        Ok(known.clone())
    }
}

/// One value per throw.
fn each(
    list: &Column,
    throws: &[Throw],
    mut read: impl FnMut(&Text) -> Result<BigRational, LayoutError>,
) -> Result<Vec<BigRational>, LayoutError> {
    match list.get_ref() {
        Values::One(text) => Ok(vec![read(&Text::new(list.span(), text.clone()))?; throws.len()]),
        Values::Each(texts) if texts.len() == throws.len() => texts.iter().map(read).collect(),
        Values::Each(texts) => {
            let message = format!("{} values for {} throws", texts.len(), throws.len());
            Err(LayoutError::new(message, "one value for all, or a list with one per throw", place(list)))
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
        LayoutError::new(
            format!("there is no throw `{}`", written.chars().take(40).collect::<String>()),
            right,
            place(text),
        )
    })
}

/// A counterweight has to stand on the crankshaft.
fn on_the_shaft(engine: &Engine, position: &BigRational, span: Option<Range<usize>>) -> Result<(), LayoutError> {
    match engine.shaft_ends() {
        Some([low, high]) if *position < low || *position > high => {
            let message = format!("a counterweight at {position} is beyond the crankshaft");
            Err(LayoutError::new(message, format!("the shaft reaches from {low} to {high}"), span))
        }
        _ => Ok(()),
    }
}
