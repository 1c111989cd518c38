//! How do people describe an engine? In-line, vee, flat, boxer, radial, fan: each becomes cylinders.
//!
//! Pin 1 and row 1 are at the free end (+z). Bank angles are measured from the bisector of the banks.

use std::ops::Range;

use num_rational::BigRational;
use num_traits::Signed;
use serde::Deserialize;

use super::error::LayoutError;
use super::geared_keys::Geared;
use super::numbering::{self, Along};
use super::quantities::{
    List, angle, angles, half, integer, length, lengths, misread, misread_as, not_too_many, optional_angle,
    optional_length, whole,
};
use super::shared_keys::{SharedKeys, Throws};
use super::written::{Column, Text, Values, Written, place};
use crate::engine::{Cylinder, Form, LengthUnit, Linear, MOST_CYLINDERS};
use crate::text::counted;

/// What every form comes to.
pub(super) struct Expanded {
    pub form: Form,
    pub cylinders: Vec<Cylinder<Linear, Linear>>,
    pub length_unit: LengthUnit,
    /// Whether the positions are those of the file; else the cylinders are one spacing apart.
    pub positions_given: bool,
    /// Where the throws of the cylinders come from.
    pub throws: Throws,
    /// How far the axis of each cylinder passes the crankshaft, where the form says so: read with crank and rods.
    pub pin_offsets: Option<Column>,
    /// The crankshafts, where several are geared together.
    pub geared: Vec<Geared>,
}

/// `[inline]`: all cylinder axes at angle 0.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Inline {
    throws: Option<List>,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// `[vee]`: bank 1 at −φ/2, bank 2 at +φ/2; the pin of bank 2 stands `pin_split` ahead of that of bank 1; `pin_offset` one a bank.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Vee {
    bank_angle: Text,
    throws: Option<List>,
    pin_split: Option<Text>,
    pub bank_offset: Option<Text>,
    pin_offset: Option<List>,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// `[flat]`: a vee of 180° on shared pins.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Flat {
    throws: Option<List>,
    pub bank_offset: Option<Text>,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// `[boxer]`: a vee of 180° whose opposed pins stand 180° apart, `stagger` apart along the crankshaft.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Boxer {
    throws: Option<List>,
    stagger: Text,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// `[fan]`: any number of banks on common pins: W and X engines.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Fan {
    banks: List,
    throws: Option<List>,
    pin_splits: Option<List>,
    pub bank_offsets: Option<List>,
    pin_offsets: Option<List>,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// `[radial]`: rows of cylinders evenly round one throw per row, all rods on the pin itself.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Radial {
    cylinders: Text,
    rows: Option<Text>,
    row_rotation: Option<Text>,
    row_throw: Option<Text>,
    row_spacing: Option<Text>,
    numbering: Option<Column>,
}

/// One bank of a fan: axis, pin split, axial offset, and how far its axes pass the crankshaft where the form says so.
pub(super) struct Bank {
    pub angle: Linear,
    pub split: Linear,
    pub offset: Linear,
    pub pin_offset: Option<Text>,
}

/// The pins along the crankshaft: throw and position.
pub(super) struct Pins {
    pub pins: Vec<(Linear, Linear)>,
    pub positions_given: bool,
}

impl Inline {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let (throws, place) = above.throws(&self.throws, 1, table)?;
        let pins = pins(throws, place, &self.spacing, &self.positions, unit_length(), &mut unit)?;
        let bank =
            Bank { angle: Linear::default(), split: Linear::default(), offset: Linear::default(), pin_offset: None };
        fan(Form::Inline, &[bank], &pins, self.numbering.as_ref(), unit, Throws::of(&self.throws, false))
    }
}

impl Vee {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let angle = angle(&self.bank_angle)?;
        if angle.as_known().is_some_and(|angle| angle.abs() >= integer(1)) {
            let right = "the angle between the banks, below 360 degrees; below 0 where bank 1 is the other bank";
            return Err(misread(&self.bank_angle, "bank angle", right));
        }
        let split = optional_angle(&self.pin_split)?;
        let offset = optional_length(&self.bank_offset, Linear::default(), &mut unit)?;
        let (throws, place) = above.throws(&self.throws, 2, table)?;
        let pins = pins(throws, place, &self.spacing, &self.positions, unit_length(), &mut unit)?;
        let throws = Throws::of(&self.throws, self.pin_split.is_some());
        let mut banks = two_banks(&angle, split, &offset);
        set_pin_offsets(&mut banks, self.pin_offset.as_ref())?;
        fan(Form::Vee, &banks, &pins, self.numbering.as_ref(), unit, throws)
    }
}

impl Flat {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let offset = optional_length(&self.bank_offset, Linear::default(), &mut unit)?;
        let (throws, place) = above.throws(&self.throws, 2, table)?;
        let pins = pins(throws, place, &self.spacing, &self.positions, unit_length(), &mut unit)?;
        fan(
            Form::Flat,
            &two_banks(&Linear::constant(half()), Linear::default(), &offset),
            &pins,
            self.numbering.as_ref(),
            unit,
            Throws::of(&self.throws, true),
        )
    }
}

impl Boxer {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let stagger = length(&self.stagger, &mut unit)?;
        let between_pairs = stagger.scaled(&integer(2));
        let (throws, place) = above.throws(&self.throws, 2, table)?;
        let pins = pins(throws, place, &self.spacing, &self.positions, between_pairs, &mut unit)?;
        let banks = two_banks(&Linear::constant(half()), Linear::constant(half()), &stagger);
        fan(Form::Boxer, &banks, &pins, self.numbering.as_ref(), unit, Throws::of(&self.throws, true))
    }
}

impl Fan {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let axes = angles(&self.banks)?;
        let splits = match &self.pin_splits {
            Some(list) => angles(list)?,
            None => vec![Linear::default(); axes.len()],
        };
        let offsets = match &self.bank_offsets {
            Some(list) => lengths(list, &mut unit)?,
            None => vec![Linear::default(); axes.len()],
        };
        for (count, list) in [(splits.len(), &self.pin_splits), (offsets.len(), &self.bank_offsets)] {
            if count != axes.len() {
                let message = format!("{} for {}", counted(count, "value"), counted(axes.len(), "bank"));
                return Err(LayoutError::new(
                    message,
                    "one per bank, in the order of `banks`",
                    list.as_ref().and_then(place),
                ));
            }
        }
        if axes.is_empty() {
            return Err(LayoutError::new("a fan without banks", "the angles of its banks", place(&self.banks)));
        }
        let (throws, place) = above.throws(&self.throws, axes.len(), table)?;
        let pins = pins(throws, place, &self.spacing, &self.positions, unit_length(), &mut unit)?;
        let banks = axes.into_iter().zip(splits).zip(offsets);
        let banks = banks.map(|((angle, split), offset)| Bank { angle, split, offset, pin_offset: None });
        let mut banks: Vec<Bank> = banks.collect();
        set_pin_offsets(&mut banks, self.pin_offsets.as_ref())?;
        let throws = Throws::of(&self.throws, self.pin_splits.is_some());
        fan(Form::Fan, &banks, &pins, self.numbering.as_ref(), unit, throws)
    }
}

impl Radial {
    pub fn expand(&self, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let count = whole(&self.cylinders, "cylinders of a row")?;
        let rows = self.rows.as_ref().map_or(Ok(1), |rows| whole(rows, "number of rows"))?;
        if count * rows > MOST_CYLINDERS as i64 {
            let right = format!("up to {MOST_CYLINDERS} cylinders are read");
            return Err(misread_as(&(count * rows).to_string(), &self.cylinders, "number of cylinders", right));
        }
        let of_rows =
            [("row_rotation", &self.row_rotation), ("row_throw", &self.row_throw), ("row_spacing", &self.row_spacing)];
        if let Some((key, Some(text))) = of_rows.into_iter().find(|(_, text)| rows == 1 && text.is_some()) {
            let right = "write rows = 2, or how many there are, or leave it out";
            return Err(LayoutError::new(format!("`{key}` is of several rows"), right, place(text)));
        }
        let missing = |key: &str| {
            let message = format!("the key `{key}` is missing");
            LayoutError::new(message, "say by which angle each row follows the one before", place(&self.cylinders))
        };
        let (rotation, throw) = match (&self.row_rotation, &self.row_throw) {
            (Some(rotation), Some(throw)) => (angle(rotation)?, angle(throw)?),
            (None, None) if rows == 1 => (Linear::default(), Linear::default()),
            (Some(rotation), None) if above.firing_place().is_some() => (angle(rotation)?, Linear::default()),
            (None, _) => return Err(missing("row_rotation")),
            (_, None) => return Err(missing("row_throw")),
        };
        let follows = rows > 1 && self.row_throw.is_none();
        let throws = if follows { Throws::Follow { splits_given: true, splays: Vec::new() } } else { Throws::Listed };
        // The cylinders of a row follow each other in the sense of rotation, however the engine is drawn.
        let turn = above.convention.in_the_sense_of_rotation(integer(1));
        let spacing = optional_length(&self.row_spacing, unit_length(), &mut unit)?;
        let cylinders = (0..rows).flat_map(|row| {
            let (rotation, throw) = (rotation.scaled(&integer(row)), throw.scaled(&integer(row)));
            let position = spacing.scaled(&BigRational::new((rows - 1 - 2 * row).into(), 2.into()));
            let turn = turn.clone();
            (0..count).map(move |i| {
                Cylinder::new(
                    throw.clone(),
                    Linear::constant(BigRational::new(i.into(), count.into()) * &turn).plus(&rotation),
                    position.clone(),
                    row as usize,
                )
            })
        });
        let positions_given = rows == 1 || self.row_spacing.is_some();
        let cylinders = numbering::name(cylinders.collect(), self.numbering.as_ref())?;
        let cylinders = numbering::in_order(&cylinders).into_iter().map(|index| cylinders[index].clone()).collect();
        let geared = Vec::new();
        Ok(Expanded {
            form: Form::Radial,
            cylinders,
            length_unit: unit,
            positions_given,
            throws,
            pin_offsets: None,
            geared,
        })
    }
}

/// Two banks φ apart about the bisector; the first stands half the offset towards the free end.
fn two_banks(bank_angle: &Linear, split: Linear, offset: &Linear) -> [Bank; 2] {
    let minus_half = -half();
    [
        Bank {
            angle: bank_angle.scaled(&minus_half),
            split: Linear::default(),
            offset: offset.scaled(&half()),
            pin_offset: None,
        },
        Bank { angle: bank_angle.scaled(&half()), split, offset: offset.scaled(&minus_half), pin_offset: None },
    ]
}

/// How far the axes of each bank pass the crankshaft: one value a bank.
fn set_pin_offsets(banks: &mut [Bank], list: Option<&List>) -> Result<(), LayoutError> {
    let Some(list) = list else { return Ok(()) };
    if list.get_ref().len() != banks.len() {
        let message = format!("{} for {}", counted(list.get_ref().len(), "pin offset"), counted(banks.len(), "bank"));
        let right = "one per bank; above 0 where the axis passes on the side to which the pin goes after dead centre";
        return Err(LayoutError::new(message, right, place(list)));
    }
    banks.iter_mut().zip(list.get_ref()).for_each(|(bank, text)| bank.pin_offset = Some(text.clone()));
    Ok(())
}

/// One offset a cylinder, where any is given.
pub(super) fn offsets_of(texts: Vec<Option<Text>>) -> Option<Column> {
    let span = texts.iter().flatten().next()?.span();
    let zero = || Text::new(span.clone(), Written("0".to_owned()));
    let texts = texts.into_iter().map(|text| text.unwrap_or_else(zero)).collect();
    Some(Column::new(span.clone(), Values::Each(texts)))
}

fn fan(
    form: Form,
    banks: &[Bank],
    pins: &Pins,
    numbering: Option<&Column>,
    unit: LengthUnit,
    throws: Throws,
) -> Result<Expanded, LayoutError> {
    not_too_many(banks.len() * pins.pins.len(), "cylinders")?;
    let numbers = || 0..pins.pins.len();
    let pairs: Vec<(&Bank, usize)> = match numbering::along(numbering)? {
        Along::Banks => banks.iter().flat_map(|bank| numbers().map(move |pin| (bank, pin))).collect(),
        Along::Pins => numbers().flat_map(|pin| banks.iter().map(move |bank| (bank, pin))).collect(),
    };
    let cylinders = pairs.iter().map(|(bank, pin)| {
        let (throw, position) = &pins.pins[*pin];
        Cylinder::new(throw.plus(&bank.split), bank.angle.clone(), position.plus(&bank.offset), *pin)
    });
    let positions_given = pins.positions_given;
    let cylinders = numbering::name(cylinders.collect(), numbering)?;
    let order = numbering::in_order(&cylinders);
    let pin_offsets = offsets_of(order.iter().map(|&index| pairs[index].0.pin_offset.clone()).collect());
    let cylinders = order.iter().map(|&index| cylinders[index].clone()).collect();
    let geared = Vec::new();
    Ok(Expanded { form, cylinders, length_unit: unit, positions_given, throws, pin_offsets, geared })
}

/// Throws with positions: as listed, or evenly spaced about 0 with pin 1 at the free end.
pub(super) fn pins(
    throws: Vec<Linear>,
    throws_place: Range<usize>,
    spacing: &Option<Text>,
    positions: &Option<List>,
    usual_spacing: Linear,
    unit: &mut LengthUnit,
) -> Result<Pins, LayoutError> {
    if throws.is_empty() || throws.len() > MOST_CYLINDERS {
        let right = format!("between 1 and {MOST_CYLINDERS} throws, such as [0, 180, 180, 0]");
        return Err(LayoutError::new(format!("a crankshaft with {} throws", throws.len()), right, Some(throws_place)));
    }
    let positions_given =
        spacing.is_some() || positions.is_some() || throws.len() == 1 || usual_spacing != unit_length();
    let positions = match (spacing, positions) {
        (Some(_), Some(list)) => {
            let message = "both a spacing and positions are given";
            return Err(LayoutError::new(message, "one of them is enough", place(list)));
        }
        (_, Some(list)) if list.get_ref().len() != throws.len() => {
            let message =
                format!("{} for {}", counted(list.get_ref().len(), "position"), counted(throws.len(), "throw"));
            return Err(LayoutError::new(message, "one position per throw", place(list)));
        }
        (_, Some(list)) => lengths(list, unit)?,
        (spacing, None) => {
            let spacing = optional_length(spacing, usual_spacing, unit)?;
            let last = throws.len() as i64 - 1;
            (0..=last).map(|i| spacing.scaled(&BigRational::new((last - 2 * i).into(), 2.into()))).collect()
        }
    };
    Ok(Pins { pins: throws.into_iter().zip(positions).collect(), positions_given })
}

pub(super) fn unit_length() -> Linear {
    Linear::constant(integer(1))
}
