//! How are cylinders written one by one? `[[cylinder]]`.

use std::collections::BTreeMap;

use num_rational::BigRational;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::forms::Expanded;
use super::geared_keys;
use super::numbering::cylinder_name;
use super::quantities::{self, misread};
use super::shared_keys::{SharedKeys, Throws};
use super::written::{Table, Text, place};
use crate::engine::{Cylinder, Form, LengthUnit, Linear, MOST_CYLINDERS, Shared};

/// `[[cylinder]]`: one of the tables.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    name: Option<Text>,
    throw: Option<Text>,
    bank: Text,
    position: Text,
    pub reciprocating_mass: Option<Text>,
    pin: Option<Text>,
    crankshaft: Option<Text>,
    opposed_to: Option<Text>,
}

/// The cylinders of the tables, on the crankshafts that they name.
pub(super) fn expand(
    list: &Spanned<Vec<Spanned<Table<Keys>>>>,
    several: &[Spanned<Table<geared_keys::Keys>>],
    above: &SharedKeys<'_>,
) -> Result<Expanded, LayoutError> {
    let tables = list.get_ref();
    if tables.is_empty() || tables.len() > MOST_CYLINDERS {
        let message = format!("{} cylinders", tables.len());
        return Err(LayoutError::new(message, format!("between 1 and {MOST_CYLINDERS} are read"), place(list)));
    }
    let without = tables.iter().find(|table| table.get_ref().0.throw.is_none());
    let throws = match without {
        None => Throws::Listed,
        Some(_) if tables.iter().all(|table| table.get_ref().0.throw.is_none()) && above.firing_place().is_some() => {
            Throws::Follow { splits_given: false, splays: Vec::new() }
        }
        Some(table) => {
            let right =
                "every cylinder needs it; or omit all of them, with a firing_order and its cycle above the tables";
            return Err(LayoutError::new("the key `throw` is missing", right, place(table)));
        }
    };
    let mut length_unit = LengthUnit::Spacing;
    let cranks = geared_keys::read(several)?;
    if let (Throws::Follow { .. }, Some(text)) = (&throws, geared_keys::first_phase(several)) {
        let right = "leave it out: throws that follow from the firing order have it in them";
        return Err(LayoutError::new("the phase of a crankshaft whose throws are not written", right, place(text)));
    }
    let cylinders = tables.iter().enumerate().map(|(index, spanned)| {
        let table = &spanned.get_ref().0;
        let pin = table.pin.as_ref().map_or(Ok(0), |pin| quantities::whole(pin, "number of the pin"))? as usize;
        let position = quantities::length(&table.position, &mut length_unit)?;
        let (throw, bank) = (quantities::optional_angle(&table.throw)?, quantities::angle(&table.bank)?);
        let crank = geared_keys::named(&cranks, table.crankshaft.as_ref(), || place(spanned))?;
        let throw = match cranks.get(crank) {
            Some((geared, phase)) => {
                geared_keys::equivalent(&throw.plus(&Linear::constant(phase.clone())), &bank, geared.sense)
            }
            None => throw,
        };
        let cylinder = Cylinder::new(throw, bank, position, pin);
        Ok(Cylinder {
            crank,
            name: table.name.as_ref().map_or(Ok((index + 1).to_string()), cylinder_name)?,
            reciprocating_mass: table
                .reciprocating_mass
                .as_ref()
                .map_or(Ok(BigRational::from_integer(1.into())), quantities::mass)?,
            ..cylinder
        })
    });
    let mut cylinders = cylinders.collect::<Result<Vec<_>, LayoutError>>()?;
    number_pins(&mut cylinders);
    check_names(&cylinders, tables)?;
    for (index, table) in tables.iter().enumerate() {
        if let Some(text) = &table.get_ref().0.opposed_to {
            if matches!(throws, Throws::Follow { .. }) {
                let right = "write the throw of each cylinder: two pistons in one do not follow from a firing order";
                return Err(LayoutError::new("opposed pistons without throws", right, place(text)));
            }
            face(&mut cylinders, index, text)?;
        }
    }
    let geared = cranks.into_iter().map(|(geared, _)| geared).collect();
    let pin_offsets = None;
    Ok(Expanded { form: Form::General, cylinders, length_unit, positions_given: true, throws, pin_offsets, geared })
}

/// Cylinders that name no pin, which a file numbers from 1, share one where they are at the same position of a crankshaft; then the pins
/// are numbered from 0 without gaps.
fn number_pins(cylinders: &mut [Cylinder<Linear, Linear>]) {
    let mut pins: BTreeMap<(usize, Linear), usize> = BTreeMap::new();
    for (index, cylinder) in cylinders.iter_mut().enumerate().filter(|(_, cylinder)| cylinder.pin == 0) {
        let place = (cylinder.crank, cylinder.position.clone());
        cylinder.pin = *pins.entry(place).or_insert(MOST_CYLINDERS + 1 + index);
    }
    let mut numbers: Vec<usize> = cylinders.iter().map(|cylinder| cylinder.pin).collect();
    numbers.sort_unstable();
    numbers.dedup();
    for cylinder in cylinders {
        cylinder.pin = numbers.partition_point(|&number| number < cylinder.pin);
    }
}

/// Two pistons face each other in one cylinder; the one that the other names stands for it.
fn face(cylinders: &mut [Cylinder<Linear, Linear>], index: usize, text: &Text) -> Result<(), LayoutError> {
    let Some(first) = quantities::cylinder(text, cylinders).filter(|first| *first != index) else {
        return Err(misread(text, "opposed piston", "the name of another cylinder"));
    };
    let [one, other] = [first, index].map(|piston| &cylinders[piston]);
    let half = Linear::constant(BigRational::new(1.into(), 2.into()));
    let turned = one.bank.minus(&other.bank).plus(&half);
    let faces = turned.as_known().is_some_and(BigRational::is_integer) && one.position == other.position;
    if !faces || one.shared.is_some() || other.shared.is_some() {
        let message = format!("piston {} cannot share a cylinder with {}", other.name, one.name);
        let right = "two pistons at one position whose banks are 180° apart, named by one of them";
        return Err(LayoutError::new(message, right, place(text)));
    }
    for (piston, is_second) in [(first, false), (index, true)] {
        cylinders[piston].shared = Some(Shared { number: first, is_second });
    }
    Ok(())
}

fn check_names(cylinders: &[Cylinder<Linear, Linear>], tables: &[Spanned<Table<Keys>>]) -> Result<(), LayoutError> {
    let mut seen = BTreeMap::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        if let Some(first) = seen.insert(&cylinder.name, index) {
            let message = format!("cylinders {} and {} have the same name `{}`", first + 1, index + 1, cylinder.name);
            return Err(LayoutError::new(message, "every cylinder needs a name of its own", place(&tables[index])));
        }
    }
    Ok(())
}
