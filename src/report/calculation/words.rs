//! What was assumed, what do the symbols mean, and where do the numbers end? Generated from what the file holds.

use super::super::mechanism_words;
use super::super::residual::{group_words, orders_in_words};
use super::inputs;
use crate::engine::{Engine, Measure};
use crate::loads::{Arm, Loads};
use crate::order::MassGroup;
use crate::page::{Table, Text};
use crate::proof::Quantity;
use crate::report::texts::loads as text;
use crate::{firing, verdict};

/// What every number rests on.
pub(super) fn assumptions(engine: &Engine, loads: &Loads) -> Vec<Text> {
    let is_yoke = engine.has_yokes_alone();
    let mut lines = vec![text::rigid(is_yoke), text::neglected()];
    let has_rod_mass = engine.dimensions().given.iter().any(|given| given.quantity == Measure::RodMass);
    lines.push(if has_rod_mass { text::rod_as_masses() } else { text::masses_given(is_yoke) });
    if loads.groups.len() == 1 {
        lines.push(text::no_rotating_masses());
    }
    if !engine.has_offset() {
        lines.push(text::no_offset());
    }
    let common_axis = engine.form() == crate::engine::Form::Radial && engine.only_rods().is_ok();
    if common_axis {
        lines.push(text::no_articulated_rods());
    }
    if Arm::of(engine) == Arm::Spacing {
        lines.push(text::no_spacing());
    }
    lines
}

/// Symbols with their meaning and unit.
pub(super) fn nomenclature(engine: &Engine, loads: &Loads) -> Table {
    fn row(symbol: &str, meaning: impl Into<Text>, unit: &'static str) -> Vec<Text> {
        vec![Text::formula(symbol), meaning.into(), unit.into()]
    }
    let mut rows = vec![
        row("\\theta", "crank angle of the reference throw", "°"),
        row("\\alpha,\\ \\beta", text::axis_and_throw(), "°"),
        row("\\psi = \\theta + \\beta - \\alpha", mechanism_words::counted_from(engine), "°"),
    ];
    let mut seen: Vec<Measure> = Vec::new();
    for given in &engine.dimensions().given {
        if !seen.contains(&given.quantity) {
            seen.push(given.quantity);
            let (meaning, symbol, unit) = inputs::words(given.quantity);
            rows.push(row(symbol, meaning, if unit.is_empty() { "–" } else { unit }));
        }
    }
    let has = |measure: Measure| seen.contains(&measure);
    if !has(Measure::CrankRadius) && engine.dimensions().crank_radius.is_some() {
        rows.push(row("r", "crank radius", "m"));
    }
    if !engine.has_yokes_alone() {
        if !has(Measure::RodLength) {
            rows.push(row("l", "rod length between centres", "m"));
        }
        if !has(Measure::RodRatio) {
            rows.push(row("\\lambda", "rod ratio r/l", "–"));
        }
    }
    if !has(Measure::ReciprocatingMass) && engine.dimensions().mass.is_some() {
        rows.push(row("m", "reciprocating mass per cylinder", "kg"));
    }
    if engine.has_offset() && !has(Measure::OffsetRatio) {
        rows.push(row("\\delta", "offset ratio e/l", "–"));
    }
    if loads.scale.is_some() {
        rows.push(row("\\omega", "angular speed", "rad/s"));
    }
    rows.push(row("K = m r \\omega^2", "unit of the forces", "N"));
    rows.push(row("s(\\psi)", text::position(), "m"));
    rows.push(row("[k=1]", "1 at order 1, else 0", "–"));
    rows.push(row("c_k", text::coefficient(), "–"));
    rows.push(row("P_k^{\\pm},\\ C_k^{\\pm}", text::stars(), "–; m"));
    rows.push(row("V_k^{\\pm},\\ W_k^{\\pm}", text::vectors(), "–; m"));
    rows.push(row("\\hat F_k,\\ \\check F_k", text::extremes(), "N"));
    rows.push(row("\\hat M_k,\\ \\check M_k", "the same of the moment", "N m"));
    rows.push(row("F_\\parallel,\\ F_\\perp", text::components(), "N"));
    if [&loads.force, &loads.moment].into_iter().any(|waveform| waveform.harmonics().len() > 1) {
        rows.push(row("\\theta^{*}", "crank angle of the largest value", "°"));
        rows.push(row("F_{k\\parallel},\\ \\varepsilon_{k\\parallel}", text::phase(), "N, °"));
    }
    if loads.torque.is_some() {
        rows.push(row("t_k,\\ Q_k", text::coefficient_of_torque(), "–"));
        rows.push(row("\\hat T_k", text::amplitude_of_torque(), "N m"));
    }
    Table { rows, ..Table::new(["Symbol", "Meaning", "Unit"]) }
}

/// A row of the table of effects.
pub(super) struct EffectRow {
    /// What it is about.
    pub name: &'static str,
    /// Whether the file asks for it.
    pub inside: bool,
    /// Why, or why not.
    pub why: Text,
    /// The group of masses that its shares are those of, if any.
    pub group: Option<MassGroup>,
}

/// What is in the scene and what is not, and why.
pub(super) fn effects(engine: &Engine, loads: &Loads, page: Sections) -> Vec<EffectRow> {
    let orders = loads.orders.iter().map(|order| order.order);
    let of_pistons: Vec<u32> =
        orders.clone().filter(|order| engine.pistons_have_order(Quantity::FORCE, *order)).collect();
    let is_odd = |order: u32| order > 1 && !order.is_multiple_of(2);
    let has_odd = orders.clone().any(is_odd) || engine.faster_crank().is_some();
    let masses = MassGroup::ALL.into_iter().map(|group| {
        let inside = loads.groups.iter().any(|loads| loads.group == group);
        let why = match (group, inside) {
            (MassGroup::Reciprocating, _) => orders_in_words(&of_pistons),
            (_, true) => "given in the file".into(),
            (_, false) => "none given".into(),
        };
        EffectRow { name: group_words(group), inside, why, group: Some(group) }
    });
    let row = |name, inside: bool, yes: Text, no: Text| EffectRow {
        name,
        inside,
        why: if inside { yes } else { no },
        group: None,
    };
    let is_decided = verdict::quantities(engine, false).contains(&Quantity::TORQUE);
    let turn_alike = engine.cylinders().windows(2).all(|pair| pair[0].rotating_mass == pair[1].rotating_mass);
    let unequal = engine.mechanisms().len() > 1 || !engine.has_unit_masses() || !turn_alike;
    let others = [
        row(
            "pin offset",
            engine.has_offset(),
            if engine.has_odd_orders() { "given: odd orders appear" } else { "given: no odd orders but 1" }.into(),
            if engine.is_centric() && !has_odd { "none: no odd orders but 1" } else { "none" }.into(),
        ),
        row("unequal cylinders", unequal, "masses, radii, rods or offsets differ".into(), "all are alike".into()),
        row(
            "inertia torque",
            loads.torque.is_some(),
            "asked for".into(),
            if is_decided { text::decided() } else { "not asked for".into() },
        ),
    ];
    let given = |name, why: Text| row(name, true, why, Text::default());
    let speeds = engine.faster_crank().map(|_| given("crankshafts of several speeds", text::several_speeds()));
    let corrected = engine.has_corrected_links();
    let corrected = corrected.then(|| given("corrected knuckle angles", "given: odd orders appear".into()));
    let sections = match page {
        Sections::None => Vec::new(),
        Sections::OfReport { has_torque } => sections(engine, has_torque),
    };
    masses.chain(others).chain(speeds).chain(corrected).chain(sections).collect()
}

/// Which sections of their own a page has beside the numbers of the masses.
#[derive(Clone, Copy)]
pub(super) enum Sections {
    /// None: the page is on the masses alone.
    None,
    /// Those of a report, which has the torque of the gas or says what it lacks.
    OfReport { has_torque: bool },
}

/// What has a section of its own in a report, if it has numbers.
fn sections(engine: &Engine, has_torque: bool) -> Vec<EffectRow> {
    let effects = engine.effects();
    let asked = |name, asked: bool, given: bool, has_numbers: bool| {
        let (inside, why) = match (asked, given) {
            (true, true) if has_numbers => (true, text::own_section()),
            (true, true) => (false, text::own_section_says_why()),
            (true, false) => (false, "asked for, and not given".into()),
            (false, true) => (false, "given, and not asked for".into()),
            (false, false) => (false, "not given".into()),
        };
        EffectRow { name, inside, why, group: None }
    };
    let has_bearings = !engine.bearings().is_empty();
    let positions = if has_bearings { "positions given" } else { "no positions given" };
    vec![
        EffectRow { name: "main bearings", inside: has_bearings, why: positions.into(), group: None },
        asked("gas", effects.gas, engine.gas().is_some(), has_torque),
        asked(
            "torsion of the crankshaft",
            effects.torsion,
            engine.torsion().is_some(),
            firing::firing_of(engine).is_ok(),
        ),
    ]
}

/// Where the numbers end.
pub(super) fn limits(engine: &Engine, loads: &Loads) -> Vec<Text> {
    let orders: Vec<String> = loads.orders.iter().map(|order| order.order.to_string()).collect();
    let mut lines =
        vec![text::only_orders(orders_in_words(&orders)), text::masses_alone(), text::peak_to_peak(), text::left_out()];
    if engine.dimensions().given.iter().any(|given| given.quantity == Measure::RodMass) {
        lines.push(text::moment_of_inertia());
    }
    lines
}
