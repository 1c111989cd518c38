//! What do the views of an engine show, in words? Only what is in the picture.

use super::linkage::{is_shortened, rows};
use super::rows::banks;
use crate::engine::{Engine, throws};

/// What stands under the view from the free end.
pub(in crate::report) fn end_view_caption(engine: &Engine) -> String {
    let mut words = vec![
        "Seen from the free end at θ = 0, angle 0 upwards, angles anticlockwise, the crank turning with the arrow. Throws, \
         crankpins and rods are coloured, pistons grey, each at its height; the numbers at a pin and beside a cylinder name the \
         cylinders that it belongs to."
            .to_owned(),
    ];
    let rows = rows(engine).len();
    if rows > 0 {
        let colours = ["blue with solid rods", "orange with dashed rods", "green with dash-dotted rods"];
        let named: Vec<String> =
            (0..rows).map(|row| format!("row {} {}", row + 1, colours[row % colours.len()])).collect();
        words.push(format!("From the free end: {}.", named.join(", ")));
    }
    words.push(
        match (engine.rods().next().is_some(), is_shortened(engine)) {
            (true, false) => "Crank radius, rod length and offset are to scale.",
            (true, true) => "Rods longer than six crank radii are drawn shorter.",
            (false, _) => "The layout gives no rods: they are drawn 3.5 crank radii long.",
        }
        .to_owned(),
    );
    if engine.has_offset() {
        words.push(
            "The dash-dotted cylinder axes miss the shaft by the offset e, drawn in red: a positive one lies to the left of a cylinder \
             that points up."
                .to_owned(),
        );
    }
    words.join(" ")
}

/// What stands under the view from the side.
pub(in crate::report) fn side_view_caption(engine: &Engine) -> String {
    let mut words = vec![
        "From the side, the free end at the left, angle 0 upwards, positions to scale; below each pin its throw angle. A filled \
         pin stands towards the reader (angles between 180° and 360°), a hollow dashed one away, a grey one in the plane of the page."
            .to_owned(),
    ];
    words.push(match (banks(engine).len(), throws(engine).len()) {
        (0, _) => "Above them the cylinders by their positions, all banks in one row.".to_owned(),
        (1, 1) => "Above it the cylinder.".to_owned(),
        (1, _) => "Above them the cylinders.".to_owned(),
        _ => "Above them the cylinders, a row for each bank with its angle at the left.".to_owned(),
    });
    if !engine.crankshaft().counterweights.is_empty() {
        words.push("Counterweights are black and filled, grey or hollow likewise.".to_owned());
    }
    words.push("The red dashed line is the plane that moments are taken about.".to_owned());
    words.join(" ")
}
