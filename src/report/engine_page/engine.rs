//! How does a report show the engine itself?

use super::super::typeset;
use super::super::views::{end_view, end_view_caption, side_view, side_view_caption};
use super::orders::StarOf;
use crate::engine::{Engine, Firing};
use crate::page::{Picture, Text};
use crate::report::texts::engine as text;

/// The engine from its free end, beside the first star that is left, or else the first of all.
pub(super) fn first_pictures(engine: &Engine, stars: &[StarOf]) -> Vec<Picture> {
    let end = Picture::new("end-view", end_view_caption(engine), end_view(engine));
    let left = stars.iter().find(|star| star.is_left()).or(stars.first());
    [end].into_iter().chain(left.and_then(|star| star.picture(engine))).collect()
}

/// The crankshaft from the side.
pub(super) fn seen_from_the_side(engine: &Engine) -> Picture {
    Picture::new("side-view", side_view_caption(engine), side_view(engine))
}

/// In which order and at which intervals it fires.
pub(super) fn fires(engine: &Engine, firing: &Firing) -> Text {
    let names: Vec<&str> = firing.shots.iter().map(|shot| engine.cylinders()[shot.cylinder].name.as_str()).collect();
    text::firing_order(names.join("–"), firing.cycle).and(" ").and(intervals(engine, firing))
}

/// Even or uneven, and which.
fn intervals(engine: &Engine, firing: &Firing) -> Text {
    let (intervals, in_line) = (firing.intervals(), engine.has_dead_centres_apart());
    match intervals.as_slice() {
        [first, ..] if firing.is_even() => text::fires_evenly(in_line, typeset::turns_in_decimals(first)),
        uneven => text::fires_unevenly(in_line, uneven.iter().map(typeset::turns).collect::<Vec<_>>().join(", ")),
    }
}
