//! What do the views of an engine show, in words? Only what is in the picture.

use num_traits::Signed;

use super::super::{mechanism_words, typeset};
use super::linkage::{is_shortened, rows};
use super::rows::banks;
use crate::engine::{AxisLeftOut, Engine, Form, throws};
use crate::page::Text;
use crate::report::texts::views as text;

/// What stands under the view from the free end.
pub(in crate::report) fn end_view_caption(engine: &Engine) -> Text {
    let end = engine.convention().turns_anticlockwise_from();
    let mut words = vec![text::from_the_end(end), text::parts()];
    let rows = rows(engine).len();
    if rows > 0 {
        let named = (1..=rows).map(|row| match row % 3 {
            1 => text::blue_row(row),
            2 => text::orange_row(row),
            _ => text::green_row(row),
        });
        words.push(text::rows(Text::joined(named, ", ")));
    }
    words.push(mechanism_words::scale(engine, is_shortened(engine)));
    let left_out = engine.geared_cranks().iter().find_map(|crank| crank.left_out.as_ref());
    words.extend(left_out.map(|what| match what {
        AxisLeftOut::Distance(_) => text::no_distance(),
        AxisLeftOut::Place => text::no_position(),
    }));
    words.extend(engine.has_offset().then(text::offset));
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
    Some(text::split_pins(second.name.clone(), typeset::degrees(&ahead.abs()), ahead.is_negative(), first.name.clone()))
}

/// What stands under the view from the side.
pub(in crate::report) fn side_view_caption(engine: &Engine) -> Text {
    let end = engine.convention().turns_anticlockwise_from();
    let mut words = vec![text::from_the_side(), text::pins(end)];
    words.push(match (banks(engine).len(), throws(engine).len()) {
        (0, _) => text::all_banks_in_one_row(),
        (1, 1) => text::cylinder(),
        (1, _) => text::cylinders(),
        _ => text::row_for_each_bank(),
    });
    if !engine.crankshaft().counterweights.is_empty() {
        words.push(text::counterweights());
    }
    words.push(text::plane_of_moments());
    Text::joined(words, " ")
}
