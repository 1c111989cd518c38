//! What is said of what moves the pistons: of rods, with and without an offset, and of links on a master rod?
//!
//! A new mechanism has its sentences in `templates/pages/mechanism.md` and its choices among them here; where they stand on a page is not
//! its matter.

use num_traits::Zero;

use crate::engine::{Cylinder, Engine, Rods};
use crate::page::Text;
use crate::report::texts::mechanism as text;

/// What the verdicts rest on.
pub(super) fn assumed(engine: &Engine) -> Text {
    if engine.has_links() {
        let orders = if engine.is_centric() { text::centric_orders() } else { text::corrected_orders() };
        return text::articulated().and(" ").and(orders);
    }
    let unequal = engine.mechanisms().len() > 1;
    let orders = match (engine.faster_crank().is_some(), engine.has_odd_orders()) {
        (true, true) => text::every_own_order(),
        (true, false) => text::centric_own_orders(),
        (false, true) => text::every_order(),
        (false, false) if engine.has_offset() => text::endless_offset_rods(),
        (false, false) if unequal => text::centric_orders(),
        (false, false) if engine.has_yokes_alone() => return text::yokes(),
        (false, false) => return text::equal_rods(),
    };
    text::rigid().and(if unequal { text::rods_differ() } else { Text::default() }).and(" ").and(orders)
}

/// What rows count in that name more than orders and cylinders, for those that the engine has.
pub(super) fn rows(engine: &Engine) -> Vec<Text> {
    let mut of_engine = engine.cylinders().iter().filter_map(Cylinder::link);
    let plain = of_engine.any(|link| !link.is_corrected()).then(text::rows_of_links);
    let corrected = engine.has_corrected_links().then(text::rows_of_corrected);
    let offsets = (engine.has_offset() && engine.mechanisms().len() > 1).then(text::rows_of_offsets);
    plain.into_iter().chain(corrected).chain(offsets).collect()
}

/// Why an order is made of several sums, in a plain sentence.
pub(super) fn why_several(engine: &Engine) -> Text {
    match (engine.has_links(), engine.has_offset(), engine.faster_crank().is_some()) {
        (true, ..) => text::links_differ(),
        (false, true, _) => text::offsets_differ(),
        (false, false, true) => text::speeds_differ(),
        (false, false, false) if engine.mechanisms().len() > 1 => text::coefficients_differ(),
        (false, false, false) => text::pistons_and_masses(),
    }
}

/// Where crankpins and cylinders stand.
pub(super) fn centres(engine: &Engine) -> Text {
    match (engine.only_rods(), engine.has_offset()) {
        (Err(_), _) => text::linked_dead_centre(),
        (Ok(()), true) => text::offset_dead_centre(),
        (Ok(()), false) => text::at_dead_centre(),
    }
}

/// Where the crank angle of a cylinder is 0.
pub(super) fn counted_from(engine: &Engine) -> Text {
    let is_apart = engine.has_offset() || engine.only_rods().is_err();
    if is_apart { text::from_alignment() } else { text::from_dead_centre() }
}

/// The formulas of the motion of a piston with what they say, in TeX.
pub(super) fn motion(engine: &Engine) -> Vec<(Text, String)> {
    let offset = engine.has_offset();
    let coefficients = match (offset, engine.has_yokes_alone()) {
        (true, _) => text::offset_coefficients(),
        (false, true) => text::yoke_coefficients(),
        (false, false) => text::centric_coefficients(),
    };
    let root = if offset { "(\\lambda\\sin\\psi - \\delta)^2" } else { "\\lambda^2\\,{\\sin}^2\\psi" };
    let rod = if engine.has_yokes_alone() { String::new() } else { format!(" + l\\sqrt{{1 - {root}}}") };
    vec![
        (
            text::position(),
            format!("s(\\psi) = r\\cos\\psi{rod}, \\qquad \\psi = \\theta + \\beta - \\alpha"),
        ),
        (
            text::inertia_force(),
            "-m\\,\\ddot s = m\\,r\\,\\omega^2\\, \\mathrm{Re} \\sum_{k\\ge1} c_k\\, e^{ik\\psi}".to_owned(),
        ),
        (
            coefficients,
            match offset {
                false if engine.has_yokes_alone() => "c_1 = 1, \\qquad c_2 = c_3 = \\dots = 0".to_owned(),
                true => "c_k = [k=1] + \\frac{k^2}{\\pi\\lambda} \\int_0^{2\\pi} \\sqrt{1 - (\\lambda\\sin\\psi - \\delta)^2}\\; e^{-ik\\psi}\\, d\\psi".to_owned(),
                false => "\\begin{aligned} c_1 &= 1, \\qquad c_3 = c_5 = \\dots = 0, \\\\ c_{2n} &= 8 n^2 (-1)^n \\sum_{j\\ge n} (-1)^j \\binom{1/2}{j} \\binom{2j}{j-n} \\frac{\\lambda^{2j-1}}{4^{j}} \\end{aligned}".to_owned(),
            },
        ),
    ]
}

/// What a page of the torque says of pistons that no rod on the crankpin moves.
pub(super) fn in_torque(engine: &Engine) -> Option<Text> {
    engine.has_links().then(text::links_in_torque)
}

/// The same of guide-force moments.
pub(super) fn in_guides(engine: &Engine) -> Option<Text> {
    engine.has_links().then(text::links_in_guides)
}

/// The same of what excites torsional vibration.
pub(super) fn in_torsion(engine: &Engine) -> Option<Text> {
    engine.has_links().then(text::links_in_torsion)
}

/// The same of values at a crank angle.
pub(super) fn at_angles(engine: &Engine) -> Option<Text> {
    engine.has_links().then(text::links_at_angles)
}

/// The pins that rods and links turn on, above a column of their loads.
pub(super) fn pin_loads(engine: &Engine) -> &'static str {
    if engine.has_links() { "Crankpin or knuckle pin in {}" } else { "Crankpin in {}" }
}

/// Whether cranks and rods are drawn to scale.
pub(super) fn scale(engine: &Engine, is_shortened: bool) -> Text {
    match engine.all_rods() {
        Rods::Unknown => text::no_rods(),
        Rods::Alike(rod) if rod.ratio.is_zero() => text::yokes_as_rods(),
        _ if is_shortened => text::rods_shortened(),
        _ if engine.has_offset() => text::offset_to_scale(),
        Rods::Alike(_) | Rods::Differ | Rods::Without(_) => text::rods_to_scale(),
    }
}
