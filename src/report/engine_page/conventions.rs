//! What do angles, signs and units mean, and what do the verdicts rest on?

use super::super::convention::{differs, seen};
use super::super::mechanism_words::{assumed, centres, rows};
use super::super::{residual, table};
use crate::engine::{Engine, LengthUnit};
use crate::page::{Block, Text, phrase};

/// The conventions of a report.
pub(super) fn section(engine: &Engine) -> Vec<Block> {
    let mut lines = vec![seen(engine.convention())];
    lines.extend(differs(engine.convention()));
    lines.extend([centres(engine).into(), FIRES.into(), reference_plane(engine), assumed(engine)]);
    vec![Block::Heading(1, "Conventions".into()), Block::List(lines)]
}

/// About which plane moments are taken.
pub(in crate::report) fn reference_plane(engine: &Engine) -> Text {
    let plane = table::place(engine, engine.reference_plane());
    match engine.reference_plane_given() {
        true => phrase!("Moments are taken about the plane z = {}, as the layout file says.", plane),
        false => phrase!("Moments are taken about the plane z = {}, the middle of the cylinders.", plane),
    }
}

/// What the exact tables count in.
pub(super) fn units(engine: &Engine) -> Text {
    let forces: Text = match engine.has_unit_masses() {
        true => "Forces are counted in m r ω² $c_k$:".into(),
        false => {
            "Forces are counted in m r ω² $c_k$, m being the reciprocating mass of the first cylinder that has one:"
                .into()
        }
    };
    let moments: Text = match engine.length_unit() {
        LengthUnit::Metre => "moments in that times metres.".into(),
        LengthUnit::Spacing => "moments in that times a, the unit of the positions (the cylinder spacing).".into(),
    };
    let signs = forces.and(" ").and(LARGEST).and(" ").and(moments).and(" ").and(SIGNS);
    let speeds = engine.faster_crank().map(|_| residual::SPEED_LEGEND);
    rows(engine).into_iter().chain(speeds).fold(signs, |signs, words| signs.and(" ").and(words))
}

const LARGEST: &str =
    "the number is the largest value through a revolution, $\\tfrac12(\\lvert P^{+}\\rvert + \\lvert P^{-}\\rvert)$;";
const SIGNS: &str = "**0** is exact and proved; a number after ≈ is a decimal, all others are exact. A couple is the same about every plane; a moment is taken about the reference plane.";

pub(in crate::report) const FIRES: &str = "A cylinder that fires later has a lagging throw: β − α is smaller by the firing angle. (Books where it increases draw the mirror image: verdicts and lengths are the same, directions have the opposite sign.) The pin of the second bank of a V is at the throw plus the pin split.";
