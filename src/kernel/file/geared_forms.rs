//! How do people describe engines with several crankshafts? Opposed pistons, H, U, square four, delta: each becomes cylinders.
//!
//! A phase is how far the pistons of a crankshaft are ahead of those of the first one, each in the sense that it turns in; what
//! is in a [`Cylinder`] is the equivalent crank that turns with the reference (theory, section 14). Phases count with the crank, and are
//! the same however the engine is drawn; what this file makes is still as drawn.

use num_rational::BigRational;
use serde::Deserialize;

use super::error::LayoutError;
use super::forms::{Expanded, pins};
use super::geared_keys::{Axis, Distance, Geared, sense};
use super::quantities::{List, angles, choice, integer, misread, not_too_many, optional_angle};
use super::shared_keys::Throws;
use super::written::{Text, place};
use crate::engine::{Convention, Cylinder, Form, LengthUnit, Linear, Shared};
use crate::exact::Turn;
use crate::proof::Sense;

/// `[opposed_piston]`: two pistons in each cylinder, on a crankshaft below and one above.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OpposedPiston {
    throws: List,
    lead: Text,
    leading: Option<Text>,
    sense: Option<Text>,
    distance: Option<Text>,
    spacing: Option<Text>,
    positions: Option<List>,
}

/// `[u]`: two engines in line side by side; `[h]`: two flat engines on shared pins, one above the other.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Pair {
    throws: List,
    sense: Text,
    phase: Option<Text>,
    distance: Text,
    spacing: Option<Text>,
    positions: Option<List>,
}

/// `[square_four]`: a U of two cylinders in each row, whose throws stand 180° apart.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SquareFour {
    in_phase: Text,
    sense: Text,
    distance: Text,
    spacing: Option<Text>,
}

/// `[delta]`: rows of three cylinders with two pistons each, on crankshafts in the corners of a triangle.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Delta {
    rows: List,
    against: Option<List>,
    circumradius: Text,
    spacing: Option<Text>,
    positions: Option<List>,
}

/// One bank of pistons on one of the crankshafts.
struct Bank {
    crank: usize,
    axis: Linear,
    /// By how much the throw of the equivalent crank is ahead of that of the list.
    ahead: Linear,
    /// What is behind the number in its cylinders' names.
    suffix: &'static str,
    /// Where its crankshaft is in a list of all throws.
    listed: usize,
    /// Which cylinder of a row its piston shares with another, and whether it is the second there; none where it has one of its own.
    within: Option<(usize, bool)>,
}

impl Bank {
    fn new(crank: usize, axis: i64, ahead: Linear) -> Self {
        Bank { crank, axis: degrees(axis), ahead, suffix: "", listed: crank, within: None }
    }
}

impl OpposedPiston {
    pub fn expand(&self, convention: Convention) -> Result<Expanded, LayoutError> {
        let lead = as_drawn(&optional_angle(&Some(self.lead.clone()))?, convention);
        // The lower throws stand as they are written.
        let words = [("upper", 1), ("lower", -1)];
        let right = "\"upper\" or \"lower\": the crankshaft whose pistons open the exhaust";
        let sign = |text| choice(text, "leading crankshaft", right, &words);
        let of_upper = lead.scaled(&integer(self.leading.as_ref().map_or(Ok(1), sign)?));
        let upper = self.sense.as_ref().map_or(Ok(Sense::Direct), sense)?;
        let banks = [
            Bank { suffix: "a", within: Some((0, false)), ..Bank::new(0, 0, Linear::default()) },
            Bank { suffix: "b", within: Some((0, true)), ..Bank::new(1, 180, degrees(180).plus(&of_upper)) },
        ];
        let cranks = above_each_other(["lower", "upper"], upper, self.distance.as_ref());
        expand(Form::OpposedPiston, &self.throws, (&self.spacing, &self.positions), &banks, cranks)
    }
}

impl Pair {
    pub fn side_by_side(&self, convention: Convention) -> Result<Expanded, LayoutError> {
        let phase = as_drawn(&optional_angle(&self.phase)?, convention);
        let banks = [Bank::new(0, 0, Linear::default()), Bank::new(1, 0, phase)];
        let cranks = side_by_side(sense(&self.sense)?, &self.distance);
        expand(Form::U, &self.throws, (&self.spacing, &self.positions), &banks, cranks)
    }

    pub fn flat(&self, convention: Convention) -> Result<Expanded, LayoutError> {
        let phase = as_drawn(&optional_angle(&self.phase)?, convention);
        let banks = [
            Bank::new(0, -90, Linear::default()),
            Bank::new(0, 90, Linear::default()),
            Bank::new(1, -90, phase.clone()),
            Bank::new(1, 90, phase),
        ];
        let of_lower = sense(&self.sense)?;
        let cranks = above_each_other(["upper", "lower"], of_lower, Some(&self.distance));
        expand(Form::H, &self.throws, (&self.spacing, &self.positions), &banks, cranks)
    }
}

impl SquareFour {
    pub fn expand(&self) -> Result<Expanded, LayoutError> {
        let right = "\"diagonals\" or \"sides\": which pistons move alike";
        let phase = degrees(choice(&self.in_phase, "choice", right, &[("diagonals", 180), ("sides", 0)])?);
        let banks = [Bank::new(0, 0, Linear::default()), Bank::new(1, 0, phase)];
        let cranks = side_by_side(sense(&self.sense)?, &self.distance);
        let place = place(&self.in_phase).unwrap_or_default();
        of_throws(Form::U, vec![degrees(0), degrees(180)], place, (&self.spacing, &None), &banks, cranks)
    }
}

impl Delta {
    /// At a corner the cylinder of the exhaust piston points to the next corner, that of the inlet piston to the one before, 60° apart;
    /// round the triangle the leads of the exhaust come to `60° (s_1 + s_2 + s_3)`, a third of it each. The corners follow each other in the
    /// sense of rotation, so that the exhaust leads however the engine is drawn.
    pub fn expand(&self, convention: Convention) -> Result<Expanded, LayoutError> {
        const CORNERS: [(&str, i64); 3] = [("A", 180), ("B", 300), ("C", 60)];
        let mut senses = [Sense::Direct; 3];
        match &self.against {
            None => senses[0] = Sense::Reverse,
            Some(list) => {
                for text in list.get_ref() {
                    let written = text.get_ref().0.as_str();
                    let Some(corner) = CORNERS.iter().position(|(name, _)| *name == written) else {
                        return Err(misread(text, "corner", "\"A\", the corner below, \"B\" or \"C\""));
                    };
                    if senses[corner] == Sense::Reverse {
                        let message = format!("the corner `{written}` is named before");
                        return Err(LayoutError::new(message, "name each corner once", place(text)));
                    }
                    senses[corner] = Sense::Reverse;
                }
            }
        }
        // The first crankshaft of an engine is the one that angles are counted with.
        let Some(first) = senses.iter().position(|sense| *sense == Sense::Direct) else {
            let place = self.against.as_ref().and_then(place);
            return Err(LayoutError::new("all crankshafts turn against each other", "leave one corner out", place));
        };
        let sign = |corner: usize| if senses[corner] == Sense::Direct { 1 } else { -1 };
        let lead = 20 * (0..3).map(sign).sum::<i64>();
        let (mut banks, mut cranks) = (Vec::new(), Vec::new());
        let mut ahead = 0;
        for index in 0..3 {
            let corner = (first + index) % 3;
            let (name, stands_at) = CORNERS[corner];
            if index > 0 {
                ahead += 60 * sign(corner) - lead;
            }
            let (exhaust, inlet) = (stands_at + 150, stands_at + 330);
            let mut bank = |next: usize, axis, ahead, suffix| {
                let ahead = as_drawn(&degrees(ahead + axis), convention);
                let (crank, listed) = ((index + next) % 3, (corner + next) % 3);
                let axis = as_drawn(&degrees(axis), convention);
                banks.push(Bank { crank, axis, ahead, suffix, listed, within: Some((corner, next == 1)) });
            };
            bank(0, exhaust, ahead, EXHAUST[corner]);
            bank(1, inlet, ahead - lead, INLET[corner]);
            let (distance, towards) = (Distance::of(integer(1), &self.circumradius), Turn::fraction(stands_at, 360));
            let axis = Axis::Towards(distance, convention.as_written(&towards));
            cranks.push(Geared::new(name, senses[corner], axis));
        }
        // Corner after corner, and at each the exhaust pistons before those of the inlet.
        banks.sort_by_key(|bank| (bank.listed, INLET.contains(&bank.suffix)));
        let rows = angles(&self.rows)?.iter().map(|row| as_drawn(row, convention)).collect();
        of_throws(Form::Delta, rows, self.rows.span(), (&self.spacing, &self.positions), &banks, cranks)
    }
}

/// The exhaust pistons between corners A and B, B and C, C and A.
const EXHAUST: [&str; 3] = ["ABe", "BCe", "CAe"];
const INLET: [&str; 3] = ["ABi", "BCi", "CAi"];

fn above_each_other(names: [&str; 2], of_second: Sense, distance: Option<&Text>) -> Vec<Geared> {
    let of_first = if names[0] == "upper" { 1 } else { -1 };
    let axis = |half: BigRational| match distance {
        Some(distance) => Axis::Across(Distance::of(half, distance), Distance::none()),
        None => Axis::Above(half),
    };
    let crank = |name: &str, sense, sign: i64| Geared::new(name, sense, axis(BigRational::new(sign.into(), 2.into())));
    vec![crank(names[0], Sense::Direct, of_first), crank(names[1], of_second, -of_first)]
}

fn side_by_side(of_right: Sense, distance: &Text) -> Vec<Geared> {
    let offset = |sign: i64| Distance::of(BigRational::new(sign.into(), 2.into()), distance);
    let crank = |name: &str, sense, sign| Geared::new(name, sense, Axis::Across(Distance::none(), offset(sign)));
    vec![crank("left", Sense::Direct, 1), crank("right", of_right, -1)]
}

fn expand(
    form: Form,
    throws: &List,
    places: (&Option<Text>, &Option<List>),
    banks: &[Bank],
    cranks: Vec<Geared>,
) -> Result<Expanded, LayoutError> {
    of_throws(form, angles(throws)?, throws.span(), places, banks, cranks)
}

fn of_throws(
    form: Form,
    throws: Vec<Linear>,
    place: std::ops::Range<usize>,
    (spacing, positions): (&Option<Text>, &Option<List>),
    banks: &[Bank],
    geared: Vec<Geared>,
) -> Result<Expanded, LayoutError> {
    let mut length_unit = LengthUnit::Spacing;
    let pins = pins(throws, place, spacing, positions, super::forms::unit_length(), &mut length_unit)?;
    let count = pins.pins.len();
    not_too_many(banks.len() * count, "pistons")?;
    let cylinders = banks.iter().flat_map(|bank| {
        pins.pins.iter().enumerate().map(move |(pin, (throw, position))| {
            let on = bank.listed * count + pin;
            let mut cylinder = Cylinder::new(throw.plus(&bank.ahead), bank.axis.clone(), position.clone(), on);
            cylinder.crank = bank.crank;
            cylinder.shared = bank.within.map(|(of_row, is_second)| Shared { number: of_row * count + pin, is_second });
            if !bank.suffix.is_empty() {
                cylinder.name = format!("{}{}", pin + 1, bank.suffix);
            }
            cylinder
        })
    });
    let cylinders = cylinders.collect();
    let positions_given = pins.positions_given;
    let throws = Throws::Listed;
    Ok(Expanded { form, cylinders, length_unit, positions_given, throws, pin_offsets: None, geared })
}

/// An angle that counts with the crank, as one of the drawing.
fn as_drawn(angle: &Linear, convention: Convention) -> Linear {
    angle.scaled(&convention.in_the_sense_of_rotation(integer(1)))
}

fn degrees(angle: i64) -> Linear {
    Linear::constant(BigRational::new(angle.into(), 360.into()))
}
