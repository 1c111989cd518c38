//! What do angles, signs and units mean, and what do the verdicts rest on?

use super::super::convention::{differs, seen};
use super::super::{residual, table};
use crate::engine::{Cylinder, Engine, LengthUnit};
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

/// What rows count in that name more than orders and cylinders, for those that the engine has.
pub(super) fn rows(engine: &Engine) -> Vec<&'static str> {
    let of_engine = || engine.cylinders().iter().filter_map(Cylinder::link);
    let plain = of_engine().any(|link| !link.is_corrected()).then_some(LINKS);
    let offsets = (engine.has_offset() && engine.mechanisms().len() > 1).then_some(OFFSETS);
    plain.into_iter().chain(engine.has_corrected_links().then_some(CORRECTED)).chain(offsets).collect()
}

const LARGEST: &str =
    "the number is the largest value through a revolution, $\\tfrac12(\\lvert P^{+}\\rvert + \\lvert P^{-}\\rvert)$;";
const SIGNS: &str = "**0** is exact and proved; a number after ≈ is a decimal, all others are exact. A couple is the same about every plane; a moment is taken about the reference plane.";

const LINKS: &str = "Rows that name Δ belong to links on a master rod: their unit has $g_k$ in place of $c_k$.";

const CORRECTED: &str = "Rows that name ε are about links with a corrected knuckle angle: they count in the real part (Re) or the imaginary part (Im) of $h_k$ where others count in $c_k$, and rows of order 1 without it in m r ω².";

const OFFSETS: &str = "With unequal rods order 1 is multiplied by 1 and, with a pin offset, by the imaginary part of $c_1$, whose real part is 1 for every rod: rows of order 1 that name it (Im) count in m r ω² Im $c_1$, the others in m r ω².";

/// What the verdicts rest on.
fn assumed(engine: &Engine) -> Text {
    if engine.has_links() {
        return Text::from(ARTICULATED).and(" ").and(if engine.is_centric() {
            CENTRIC_ORDERS
        } else {
            ORDERS_OF_CORRECTED
        });
    }
    let unequal = engine.mechanisms().len() > 1;
    let orders = match (engine.faster_crank().is_some(), engine.has_offset()) {
        (true, true) => EVERY_OWN_ORDER,
        (true, false) => CENTRIC_OWN_ORDERS,
        (false, true) => EVERY_ORDER,
        (false, false) if unequal => CENTRIC_ORDERS,
        (false, false) => return ASSUMED.into(),
    };
    Text::from(RIGID).and(if unequal { RODS_DIFFER } else { "" }).and(" ").and(orders)
}

const RIGID: &str = "Assumed: a rigid crankshaft at constant speed, rods in the plane of their cylinder; in a radial all rods on the crankpin itself.";
const ARTICULATED: &str = "Assumed: a rigid crankshaft at constant speed, rods in the plane of their cylinder, each rod as two masses, links on the master rod as the layout file says.";
const RODS_DIFFER: &str = " The rods or their offsets differ: cylinders in which both are equal are decided together, since only they have the same coefficient $c_k$.";
const EVERY_ORDER: &str = "The cylinder axes miss the crankshaft, so that every order exists.";
const EVERY_OWN_ORDER: &str =
    "The cylinder axes miss the crankshaft, so that every order of each crankshaft exists, multiplied by its speed.";
const CENTRIC_OWN_ORDERS: &str =
    "Orders of centric cranks are 1 and the even ones, multiplied by the speed of their crankshaft.";
const ORDERS_OF_CORRECTED: &str = "Knuckle angles are corrected, so that every order may exist.";
const CENTRIC_ORDERS: &str = "Orders of a centric engine are 1 and the even ones.";

/// Where crankpins and cylinders stand.
pub(in crate::report) fn centres(engine: &Engine) -> &'static str {
    if engine.has_offset() { ALIGNED } else { CENTRES }
}

const ALIGNED: &str = "Crankpin j is at θ + β, the axis of cylinder j points to α; they are in line where θ + β = α. An offset e moves the top dead centre to arcsin(e/(r + l)) after that.";
const CENTRES: &str =
    "Crankpin j is at θ + β, the axis of cylinder j points to α; its piston is at top dead centre where θ + β = α.";
pub(in crate::report) const FIRES: &str = "A cylinder that fires later has a lagging throw: β − α is smaller by the firing angle. (Books where it increases draw the mirror image: verdicts and lengths are the same, directions have the opposite sign.) The pin of the second bank of a V is at the throw plus the pin split.";
pub(in crate::report) const ASSUMED: &str = "Assumed: a rigid crankshaft at constant speed, equal rods and no pin offset, rods in the plane of their cylinder; in a radial all rods on the crankpin itself. Orders of a centric engine are 1 and the even ones.";
