//! How are the masses on the crankshaft written? `[crankshaft]`, `[[counterweight]]`.

use std::collections::BTreeMap;
use std::ops::Range;

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::balancer_keys;
use super::counterweight_keys::{self, CounterweightKeys, Made, Shares, on_the_shaft};
use super::error::{LayoutError, built};
use super::quantities::{self, each, mass, metres, misread, positive_metres};
use super::written::{Column, Table, Text, place};
use crate::engine::{Counterweight, Crankshaft, Draft, Engine, LengthUnit, Throw, Web, throws};

/// `[crankshaft]`: each mass key holds one value for all throws, or a list with one per throw.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    length: Option<Text>,
    pin_mass: Option<Column>,
    web_mass: Option<Column>,
    web_radius: Option<Column>,
    balance_factor: Option<Column>,
    counterweights: Option<Spanned<Table<Shares>>>,
    counterweight_radius: Option<Column>,
    web_offset: Option<Column>,
}

impl Keys {
    /// What makes the counterweights of the throws; none where nothing does.
    fn made(&self) -> Result<Option<Made<'_>>, LayoutError> {
        match (&self.balance_factor, &self.counterweights) {
            (Some(_), Some(shares)) => {
                let right = "which one is meant? balance_factor = BF makes BF × (rotating + ½ reciprocating), counterweights = { rotating = 1, reciprocating = b } makes rotating + b × reciprocating";
                Err(LayoutError::new("both balance_factor and counterweights are given", right, place(shares)))
            }
            (Some(factors), None) => Ok(Some(Made::Factor(factors))),
            (None, Some(shares)) => Made::shares(shares).map(Some),
            (None, None) => Ok(None),
        }
    }
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
        let mut in_multiples = true;
        let made = self.crankshaft.as_ref().map(|(keys, _)| keys.made()).transpose()?.flatten();
        match (made, self.counterweights) {
            (Some(_), Some(list)) => {
                let message = "both a balance factor and counterweights are given";
                return Err(LayoutError::new(message, "a balance factor makes the counterweights itself", place(list)));
            }
            (Some(made), None) => {
                let (weights, factors) = self.make_counterweights(made, &bare, &throws, &mut unit)?;
                crankshaft.counterweights = weights;
                crankshaft.balance_factors = factors;
                in_multiples = false;
            }
            (None, Some(list)) => {
                for table in list.get_ref() {
                    let along = |text: &Text| self.along(text, &bare, &mut unit);
                    let (weight, is_multiple) = counterweight_keys::read(table, &bare, &throws, along)?;
                    crankshaft.counterweights.push(weight);
                    in_multiples &= is_multiple;
                }
            }
            (None, None) => {}
        }
        for table in self.balancers.iter().flat_map(|list| list.get_ref()) {
            let (shaft, is_multiple) = balancer_keys::read(table, &bare, |text| self.along(text, &bare, &mut unit))?;
            crankshaft.balancers.push(shaft);
            in_multiples &= is_multiple;
        }
        crankshaft.in_multiples =
            in_multiples && !(crankshaft.counterweights.is_empty() && crankshaft.balancers.is_empty());
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
                return Err(misread(text, "length", "a length above 0"));
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
        if let (None, Some(list)) = (keys.made()?, keys.counterweight_radius.as_ref().or(keys.web_offset.as_ref())) {
            let right = "they place the counterweights that `counterweights` or a balance_factor makes: add it";
            return Err(LayoutError::new("counterweights without their size", right, place(list)));
        }
        Ok(crankshaft)
    }

    /// Counterweights opposite to each throw, sized by its balance factor: two beside it, or one in its plane; and the factors.
    fn make_counterweights(
        &self,
        made: Made<'_>,
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
                made.place(),
            ));
        };
        let radii = each(radii, throws, positive_metres)?;
        let offsets = match &keys.web_offset {
            Some(list) => Some(each(list, throws, |text| self.along(text, engine, unit))?),
            None => None,
        };
        let two = BigRational::from_integer(2.into());
        let Some(parts) = engine.throw_parts() else {
            let right = "below [mechanism], give reciprocating_mass or piston_mass, and stroke or crank_radius";
            return Err(LayoutError::new("a balance factor in an engine without masses", right, made.place()));
        };
        let (sizes, factors) = made.sizes(&parts, throws)?;
        let mut weights = Vec::new();
        for (index, throw) in throws.iter().enumerate() {
            let mass = &sizes[index] / &radii[index];
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
                None => {
                    on_the_shaft(engine, &throw.position, keys.length.as_ref().and_then(place))?;
                    weights.push(weight(mass, throw.position.clone()));
                }
            }
        }
        Ok((weights, factors))
    }

    /// A length along the crankshaft, in the unit of the positions.
    fn along(&self, text: &Text, engine: &Engine, unit: &mut LengthUnit) -> Result<BigRational, LayoutError> {
        let mut own = LengthUnit::Spacing;
        let length = quantities::length(text, &mut own)?.with(self.values);
        let Some(known) = length.as_known() else {
            return Err(misread(text, "length", "a length whose symbols have values"));
        };
        if own == LengthUnit::Metre && !engine.positions_given() {
            return Err(quantities::among_spacings(text));
        }
        if own == LengthUnit::Metre {
            *unit = own;
        }
        Ok(known.clone())
    }
}
