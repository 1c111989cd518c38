//! How does a report show the engine itself?

use super::super::convention::differs;
use super::super::dead_centres;
use super::super::table;
use super::super::typeset;
use super::super::views::{end_view, end_view_caption, side_view, side_view_caption};
use super::geared;
use super::orders::StarOf;
use crate::engine::{Engine, Firing};
use crate::page::{Block, Picture, Text, phrase};

/// The engine from its free end, beside the first star that is left, or else the first of all.
pub(super) fn first_pictures(engine: &Engine, stars: &[StarOf]) -> Vec<Picture> {
    let end = Picture { name: "end-view".to_owned(), caption: end_view_caption(engine), figure: end_view(engine) };
    let left = stars.iter().find(|star| star.is_left()).or(stars.first());
    [end].into_iter().chain(left.and_then(|star| star.picture(engine))).collect()
}

/// The crankshaft from the side, the cylinders one by one, and how they fire.
pub(super) fn section(engine: &Engine) -> Vec<Block> {
    let side = Picture { name: "side-view".to_owned(), caption: side_view_caption(engine), figure: side_view(engine) };
    let mut blocks = vec![Block::Heading(1, "The engine".into())];
    blocks.extend(differs(engine.convention()).map(Block::Paragraph));
    blocks.extend([side.into(), table::cylinders(engine).into()]);
    blocks.extend(geared::section(engine));
    blocks.extend(engine.firing().map(|firing| Block::Paragraph(fires(engine, firing))));
    blocks.extend(dead_centres::counted(engine).map(Block::Paragraph));
    let source = engine.source().map(|source| phrase!("Source of the crank star: {}.", source));
    blocks.extend(source.map(Block::Paragraph));
    blocks
}

fn fires(engine: &Engine, firing: &Firing) -> Text {
    let names: Vec<&str> = firing.shots.iter().map(|shot| engine.cylinders()[shot.cylinder].name.as_str()).collect();
    let order = phrase!("Firing order {} ({two-stroke|four-stroke}).", names.join("–"), firing.cycle);
    order.and(" ").and(intervals(firing))
}

/// Even or uneven, and which.
fn intervals(firing: &Firing) -> Text {
    let intervals = firing.intervals();
    match intervals.as_slice() {
        [first, ..] if firing.is_even() => {
            phrase!("It fires evenly, every {} of crank angle.", typeset::turns_in_decimals(first))
        }
        uneven => {
            let list: Vec<String> = uneven.iter().map(typeset::turns).collect();
            phrase!("It fires unevenly, at intervals of {}.", list.join(", "))
        }
    }
}
