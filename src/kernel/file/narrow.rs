//! How is an engine with narrow banks written? `[vr]`, and two of those as `[w]`.
//!
//! In a narrow V each cylinder has a throw of its own, in turn one of bank 1 and one of bank 2. The axes pass the crankshaft on
//! their outer side, at `pin_offset`, and the pins are turned with their bank, `pin_splay` apart: even firing asks for
//! `φ + 2 arcsin(e/(r+l))`, which is rounded in practice. So a firing order fixes the throws exactly, as −τ whatever the banks and
//! their offset are, and not the splay (theory of mechanisms, section 3).

use std::ops::Range;

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Deserialize;

use super::error::LayoutError;
use super::forms::{Expanded, offsets_of, pins, unit_length};
use super::numbering;
use super::quantities::{List, angle, half, integer, misread, not_too_many, optional_angle, optional_length};
use super::shared_keys::{SharedKeys, Splay, Throws};
use super::written::{Column, Text, Written, place};
use crate::engine::{Cylinder, Form, LengthUnit, Linear};

/// `[vr]`: bank 1 at −φ/2, bank 2 at +φ/2, a throw for each cylinder, the first of bank 1.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Vr {
    bank_angle: Text,
    throws: Option<List>,
    pin_splay: Option<Text>,
    pin_offset: Option<Text>,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// `[w]`: two narrow Vs at −Φ/2 and +Φ/2 on common throws; those of the second stand `pin_split` ahead of those of the first.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct W {
    bank_angle: Text,
    narrow_angle: Text,
    throws: Option<List>,
    pin_split: Option<Text>,
    pin_splay: Option<Text>,
    pin_offset: Option<Text>,
    pub bank_offset: Option<Text>,
    spacing: Option<Text>,
    positions: Option<List>,
    numbering: Option<Column>,
}

/// One narrow V: its middle, how far its pins are ahead of the throws, and where it is along the crankshaft.
struct Middle {
    angle: Linear,
    split: Linear,
    offset: Linear,
}

/// What all narrow Vs of an engine have in common.
struct Narrow<'a> {
    form: Form,
    angle: &'a Text,
    throws: &'a Option<List>,
    splay: &'a Option<Text>,
    pin_offset: &'a Option<Text>,
    spacing: &'a Option<Text>,
    positions: &'a Option<List>,
    numbering: Option<&'a Column>,
}

impl Vr {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let middle = Middle { angle: Linear::default(), split: Linear::default(), offset: Linear::default() };
        let narrow = Narrow {
            form: Form::Vr,
            angle: &self.bank_angle,
            throws: &self.throws,
            splay: &self.pin_splay,
            pin_offset: &self.pin_offset,
            spacing: &self.spacing,
            positions: &self.positions,
            numbering: self.numbering.as_ref(),
        };
        narrow.expand(&[middle], false, LengthUnit::Spacing, table, above)
    }
}

impl W {
    pub fn expand(&self, table: Range<usize>, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let wide = bank_angle(&self.bank_angle)?.scaled(&half());
        let offset = optional_length(&self.bank_offset, Linear::default(), &mut unit)?.scaled(&half());
        let minus = integer(-1);
        let first = Middle { angle: wide.scaled(&minus), split: Linear::default(), offset: offset.clone() };
        let second = Middle { angle: wide, split: optional_angle(&self.pin_split)?, offset: offset.scaled(&minus) };
        let narrow = Narrow {
            form: Form::W,
            angle: &self.narrow_angle,
            throws: &self.throws,
            splay: &self.pin_splay,
            pin_offset: &self.pin_offset,
            spacing: &self.spacing,
            positions: &self.positions,
            numbering: self.numbering.as_ref(),
        };
        narrow.expand(&[first, second], self.pin_split.is_some(), unit, table, above)
    }
}

/// A cylinder with what it brings beside itself, before it has its number.
struct Placed {
    cylinder: Cylinder<Linear, Linear>,
    pin_offset: Option<Text>,
    splay: Splay,
}

impl Narrow<'_> {
    /// The cylinders of each V in the order of their throws, one V after the other, unless they are numbered otherwise.
    fn expand(
        &self,
        middles: &[Middle],
        splits_given: bool,
        mut unit: LengthUnit,
        table: Range<usize>,
        above: &SharedKeys<'_>,
    ) -> Result<Expanded, LayoutError> {
        let narrow = bank_angle(self.angle)?;
        let splay = splay(self, &narrow, above)?;
        let (throws, place) = above.throws(self.throws, middles.len(), table)?;
        let pins = pins(throws, place, self.spacing, self.positions, unit_length(), &mut unit)?;
        not_too_many(middles.len() * pins.pins.len(), "cylinders")?;
        let place = |middle: &Middle, pin: usize| {
            let (throw, position) = &pins.pins[pin];
            let outwards = BigRational::new(if pin.is_multiple_of(2) { -1 } else { 1 }.into(), 2.into());
            // Outwards is against the rotation where the bank is at an angle below 0 in the sense of rotation.
            let turning = above.convention.in_the_sense_of_rotation(outwards.clone());
            let written = |text: &Text| if turning.is_negative() { negated(text) } else { text.clone() };
            Placed {
                cylinder: Cylinder::new(
                    throw.plus(&middle.split).plus(&splay.scaled(&outwards)),
                    middle.angle.plus(&narrow.scaled(&outwards)),
                    position.plus(&middle.offset),
                    pin,
                ),
                pin_offset: self.pin_offset.as_ref().map(written),
                splay: Splay { pin: splay.scaled(&turning), beyond: splay.minus(&narrow).scaled(&turning) },
            }
        };
        let count = pins.pins.len();
        let placed: Vec<Placed> = numbering::along_narrow(self.numbering, middles.len(), count)?
            .into_iter()
            .map(|(middle, pin)| place(&middles[middle], pin))
            .collect();
        let cylinders = placed.iter().map(|placed| placed.cylinder.clone()).collect();
        let cylinders = numbering::name(cylinders, self.numbering)?;
        let order = numbering::in_order(&cylinders);
        let splays = order.iter().map(|&index| placed[index].splay.clone()).collect();
        let throws = match (self.throws, above.angles) {
            (Some(_), _) => Throws::Listed,
            (None, None) => Throws::Follow { splits_given, splays },
            // The angles are those at which the pins are in line with their cylinders.
            (None, Some(_)) => Throws::Follow { splits_given, splays: Vec::new() },
        };
        Ok(Expanded {
            form: self.form,
            cylinders: order.iter().map(|&index| cylinders[index].clone()).collect(),
            length_unit: unit,
            positions_given: pins.positions_given,
            throws,
            pin_offsets: offsets_of(order.iter().map(|&index| placed[index].pin_offset.clone()).collect()),
            geared: Vec::new(),
        })
    }
}

/// The angle between the pins of both banks: as written; where it is omitted, 0 beside throws, and that of the banks where the throws follow.
fn splay(narrow: &Narrow<'_>, angle: &Linear, above: &SharedKeys<'_>) -> Result<Linear, LayoutError> {
    if narrow.throws.is_some() || above.firing_place().is_none() {
        return optional_angle(narrow.splay);
    }
    match (narrow.splay, narrow.pin_offset, above.angles) {
        (Some(text), _, Some(_)) => {
            let right = "leave it out: with firing angles each pin follows from its angle";
            Err(LayoutError::new("pin_splay beside firing_angles", right, place(text)))
        }
        (None, Some(text), None) => {
            let right = "add pin_splay, rounded as it is built: even firing asks for the angle between the banks + 2 arcsin(e/(r + l)), which is not a fraction of a turn";
            Err(LayoutError::new("throws that follow, with an offset and no pin_splay", right, place(text)))
        }
        (Some(text), None, None) => {
            let splay = self::angle(text)?;
            match splay == *angle {
                true => Ok(splay),
                false => {
                    let message = format!("`{}` for the splay of pins that follow from the firing", text.get_ref().0);
                    let right = "leave it out, or write the angle between the banks: axes that meet the crankshaft fire evenly with no other";
                    Err(LayoutError::new(message, right, place(text)))
                }
            }
        }
        (Some(text), Some(_), None) => self::angle(text),
        (None, None, None) | (None, _, Some(_)) => Ok(angle.clone()),
    }
}

/// An angle between banks; where it is known, above 0 and below 180°: which bank is the outer one depends on it.
fn bank_angle(text: &Text) -> Result<Linear, LayoutError> {
    let angle = angle(text)?;
    match angle.as_known() {
        Some(known) if known.is_negative() || known.is_zero() || *known >= half() => {
            Err(misread(text, "bank angle", "the angle between the banks, above 0 and below 180 degrees"))
        }
        _ => Ok(angle),
    }
}

/// The same length on the other side, as one would write it.
fn negated(text: &Text) -> Text {
    let written = text.get_ref().0.trim();
    let other = match written.strip_prefix(['-', '−']) {
        Some(size) => size.trim_start().to_owned(),
        None => format!("-{}", written.trim_start_matches('+')),
    };
    Text::new(text.span(), Written(other))
}
