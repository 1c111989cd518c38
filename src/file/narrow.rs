//! How is an engine with narrow banks written? `[vr]`, and two of those as `[w]`.
//!
//! In a narrow V each cylinder has a throw of its own, in turn one of bank 1 and one of bank 2. The axes pass the crankshaft on
//! their outer side, at `pin_offset`, and the pins are turned with their bank, `pin_splay` apart: even firing asks for
//! `φ + 2 arcsin(e/(r+l))`, which is rounded in practice.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Deserialize;

use super::above::Throws;
use super::error::LayoutError;
use super::forms::{Expanded, half, offsets_of, pins, unit_length};
use super::quantities::{List, angle, angles, misread, optional_angle, optional_length};
use super::written::{Text, Written};
use crate::engine::{Convention, Cylinder, Form, LengthUnit, Linear, MOST_CYLINDERS, Rotation};

/// `[vr]`: bank 1 at −φ/2, bank 2 at +φ/2, a throw for each cylinder, the first of bank 1.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Vr {
    bank_angle: Text,
    throws: List,
    pin_splay: Option<Text>,
    pin_offset: Option<Text>,
    spacing: Option<Text>,
    positions: Option<List>,
}

/// `[w]`: two narrow Vs at −Φ/2 and +Φ/2 on common throws; those of the second stand `pin_split` ahead of those of the first.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct W {
    bank_angle: Text,
    narrow_angle: Text,
    throws: List,
    pin_split: Option<Text>,
    pin_splay: Option<Text>,
    pin_offset: Option<Text>,
    bank_offset: Option<Text>,
    spacing: Option<Text>,
    positions: Option<List>,
}

/// One narrow V: its middle, how far its pins stand ahead of the throws, and where it stands along the crankshaft.
struct Middle {
    angle: Linear,
    split: Linear,
    offset: Linear,
}

/// What the two banks of a narrow V have in common.
struct Narrow<'a> {
    angle: &'a Text,
    splay: &'a Option<Text>,
    pin_offset: &'a Option<Text>,
    convention: Convention,
}

impl Vr {
    pub fn expand(&self, convention: Convention) -> Result<Expanded, LayoutError> {
        let middle = Middle { angle: Linear::default(), split: Linear::default(), offset: Linear::default() };
        let narrow =
            Narrow { angle: &self.bank_angle, splay: &self.pin_splay, pin_offset: &self.pin_offset, convention };
        narrow.expand(Form::Vr, &[middle], (&self.throws, &self.spacing, &self.positions), LengthUnit::Spacing)
    }
}

impl W {
    pub fn expand(&self, convention: Convention) -> Result<Expanded, LayoutError> {
        let mut unit = LengthUnit::Spacing;
        let wide = bank_angle(&self.bank_angle)?.scaled(&half());
        let offset = optional_length(&self.bank_offset, Linear::default(), &mut unit)?.scaled(&half());
        let minus = -BigRational::from_integer(1.into());
        let first = Middle { angle: wide.scaled(&minus), split: Linear::default(), offset: offset.clone() };
        let second = Middle { angle: wide, split: optional_angle(&self.pin_split)?, offset: offset.scaled(&minus) };
        let narrow =
            Narrow { angle: &self.narrow_angle, splay: &self.pin_splay, pin_offset: &self.pin_offset, convention };
        narrow.expand(Form::W, &[first, second], (&self.throws, &self.spacing, &self.positions), unit)
    }
}

impl Narrow<'_> {
    /// The cylinders of each V in the order of their throws, one V after the other.
    fn expand(
        &self,
        form: Form,
        middles: &[Middle],
        (throws, spacing, positions): (&List, &Option<Text>, &Option<List>),
        mut unit: LengthUnit,
    ) -> Result<Expanded, LayoutError> {
        let narrow = bank_angle(self.angle)?.scaled(&half());
        let splay = optional_angle(self.splay)?.scaled(&half());
        let pins = pins(angles(throws)?, throws.span(), spacing, positions, unit_length(), &mut unit)?;
        if middles.len() * pins.pins.len() > MOST_CYLINDERS {
            let message = format!("{} cylinders", middles.len() * pins.pins.len());
            return Err(LayoutError::new(message, format!("up to {MOST_CYLINDERS} are read"), None));
        }
        let (mut cylinders, mut pin_offsets) = (Vec::new(), Vec::new());
        for middle in middles {
            for (pin, (throw, position)) in pins.pins.iter().enumerate() {
                let is_first = pin % 2 == 0;
                let outwards = BigRational::from_integer(if is_first { -1 } else { 1 }.into());
                cylinders.push(Cylinder::new(
                    throw.plus(&middle.split).plus(&splay.scaled(&outwards)),
                    middle.angle.plus(&narrow.scaled(&outwards)),
                    position.plus(&middle.offset),
                    pin,
                ));
                // Outwards is against the rotation where the bank stands at an angle below 0 in the sense of rotation.
                let against = match self.convention.rotation {
                    Rotation::Anticlockwise => is_first,
                    Rotation::Clockwise => !is_first,
                };
                pin_offsets
                    .push(self.pin_offset.as_ref().map(|text| if against { negated(text) } else { text.clone() }));
            }
        }
        let positions_given = pins.positions_given;
        Ok(Expanded {
            form,
            cylinders,
            length_unit: unit,
            positions_given,
            throws: Throws::Listed,
            pin_offsets: offsets_of(pin_offsets),
            geared: Vec::new(),
        })
    }
}

/// An angle between banks; where it is known, above 0 and below 180°: which bank is the outer one depends on it.
fn bank_angle(text: &Text) -> Result<Linear, LayoutError> {
    let angle = angle(text)?;
    match angle.as_known() {
        Some(known) if known.is_negative() || known.is_zero() || *known >= half() => {
            let right = "the angle between the banks, above 0 and below 180 degrees".to_owned();
            Err(misread("bank angle", &text.get_ref().0, right, text))
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
