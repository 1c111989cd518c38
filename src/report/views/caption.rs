//! What do the views of an engine show, in words? Only what is in the picture.

use num_traits::Signed;

use super::super::{mechanism_words, typeset};
use super::linkage::{is_shortened, rows};
use super::rows::banks;
use crate::engine::{AxisLeftOut, Engine, Form, throws};
use crate::page::{Text, phrase};

/// What stands under the view from the free end.
pub(in crate::report) fn end_view_caption(engine: &Engine) -> Text {
    let end = engine.convention().turns_anticlockwise_from();
    let mut words: Vec<Text> = vec![phrase!(FROM_THE_END, end), NUMBERS.into()];
    let rows = rows(engine).len();
    if rows > 0 {
        let named = (0..rows).map(|row| phrase!(ROWS[row % ROWS.len()], row + 1));
        words.push(phrase!("From the free end: {}.", Text::joined(named, ", ")));
    }
    words.push(mechanism_words::scale(engine, is_shortened(engine)));
    let left_out = engine.geared_cranks().iter().find_map(|crank| crank.left_out.as_ref());
    words.extend(left_out.map(|what| match what {
        AxisLeftOut::Distance(_) => APART.into(),
        AxisLeftOut::Place => NOWHERE.into(),
    }));
    words.extend(engine.has_offset().then(|| OFFSET.into()));
    words.extend(split(engine));
    Text::joined(words, " ")
}

/// How the parts of the first split pin of a V stand to each other.
fn split(engine: &Engine) -> Option<Text> {
    if engine.form() != Form::Vee {
        return None;
    }
    let first = engine.cylinders().first()?;
    let second = engine.cylinders().iter().find(|other| other.pin == first.pin && other.throw != first.throw)?;
    let ahead = typeset::signed_degrees(&(&second.throw - &first.throw));
    Some(phrase!(
        "Split pins: as the crank turns, the pin of {} is {} {behind|ahead of} the pin of {}.",
        second.name.clone(),
        typeset::degrees(&ahead.abs()),
        ahead.is_negative(),
        first.name.clone()
    ))
}

const FROM_THE_END: &str = "Seen from the {free end|flywheel} at θ = 0, angle 0 upwards, angles anticlockwise, the crank turning with the arrow.";
const NUMBERS: &str = "Throws, crankpins and rods are coloured, pistons grey, each at its height; the numbers at a pin and beside a cylinder are those of its cylinders.";
const ROWS: [&str; 3] =
    ["row {} blue with solid rods", "row {} orange with dashed rods", "row {} green with dash-dotted rods"];
const APART: &str = "The layout gives no distance between the crankshafts: they are drawn 11 crank radii apart.";
const NOWHERE: &str = "The layout gives no position of some crankshaft: it is drawn in the middle.";
const OFFSET: &str = "The dash-dotted cylinder axes miss the shaft by the offset e, drawn in red: a positive one lies on the side to which the pin \
                      goes after dead centre.";

/// What stands under the view from the side.
pub(in crate::report) fn side_view_caption(engine: &Engine) -> Text {
    let end = engine.convention().turns_anticlockwise_from();
    let mut words: Vec<Text> = vec![FROM_THE_SIDE.into(), phrase!(PINS, end)];
    words.push(match (banks(engine).len(), throws(engine).len()) {
        (0, _) => "Above them the cylinders by their positions, all banks in one row.".into(),
        (1, 1) => "Above it the cylinder.".into(),
        (1, _) => "Above them the cylinders.".into(),
        _ => "Above them the cylinders, a row for each bank with its angle at the left.".into(),
    });
    if !engine.crankshaft().counterweights.is_empty() {
        words.push("Counterweights are black and filled, grey or hollow likewise.".into());
    }
    words.push("The red dashed line is the plane that moments are taken about.".into());
    Text::joined(words, " ")
}

const FROM_THE_SIDE: &str =
    "From the side, the free end at the left, angle 0 upwards, positions to scale; below each pin its throw angle.";
const PINS: &str = "A filled pin points towards the reader (angles between {180° and 360°|0° and 180°}), a hollow dashed one away, a grey one in the plane of the page.";
