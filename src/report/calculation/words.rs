//! What was assumed, what do the symbols mean, and where do the numbers end? Generated from what the file holds.

use super::super::mechanism_words;
use super::super::residual::{group_words, orders_in_words};
use super::inputs;
use crate::engine::{Engine, Measure};
use crate::loads::{Arm, Loads};
use crate::order::MassGroup;
use crate::page::{Table, Text, phrase};
use crate::proof::Quantity;
use crate::verdict;

/// What every number rests on.
pub(super) fn assumptions(engine: &Engine, loads: &Loads) -> Vec<Text> {
    let mut lines = vec![
        "The crankshaft is rigid and turns at constant speed; rods, pistons and crankcase are rigid.".into(),
        "All clearances are zero, and gravity and friction are neglected.".into(),
    ];
    let given = |measure: Measure| engine.dimensions().given.iter().any(|given| given.quantity == measure);
    if given(Measure::RodMass) {
        lines.push(
            "The rod is two masses, at its big and its small end, with its mass and its centre of gravity; they do not have exactly its moment of inertia.".into(),
        );
    } else {
        lines.push(
            "The masses are given as reciprocating and rotating ones; how the rod is divided between them is the choice of the layout.".into(),
        );
    }
    if loads.groups.len() == 1 {
        lines.push("No rotating masses are given: they are taken as balanced on the crankshaft, or as zero.".into());
    }
    if !engine.has_offset() {
        lines.push("The cylinder axes meet the axis of the crankshaft: no pin offset.".into());
    }
    let common_axis = engine.form() == crate::engine::Form::Radial && !engine.has_links();
    if common_axis {
        lines.push("All rods of a row work on the crankpin itself: no articulated rods.".into());
    }
    if Arm::of(engine) == Arm::Spacing {
        lines.push("The file gives no cylinder spacing: moments are in newtons times that spacing a.".into());
    }
    lines
}

/// Symbols with their meaning and unit.
pub(super) fn nomenclature(engine: &Engine, loads: &Loads) -> Table {
    let row = |symbol: &str, meaning: &'static str, unit: &'static str| -> Vec<Text> {
        vec![Text::formula(symbol), meaning.into(), unit.into()]
    };
    let mut rows = vec![
        row("\\theta", "crank angle of the reference throw", "°"),
        row("\\alpha,\\ \\beta", "angle of a cylinder axis; of its throw", "°"),
        vec![Text::formula("\\psi = \\theta + \\beta - \\alpha"), mechanism_words::counted_from(engine), "°".into()],
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
    if !has(Measure::RodRatio) {
        rows.push(row("\\lambda", "rod ratio r/l", "–"));
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
    rows.push(row("s(\\psi)", "position of a piston; a prime is its derivative by ψ", "m"));
    rows.push(row("[k=1]", "1 at order 1, else 0", "–"));
    rows.push(row("c_k", "coefficient of order k of the piston acceleration", "–"));
    rows.push(row("P_k^{\\pm},\\ C_k^{\\pm}", "vector stars of force and moment, as in the proofs", "–; m"));
    rows.push(row("V_k^{\\pm},\\ W_k^{\\pm}", "rotating vectors of force and moment with their coefficients", "–; m"));
    rows.push(row("\\hat F_k,\\ \\check F_k", "largest and smallest force of order k in a revolution", "N"));
    rows.push(row("\\hat M_k,\\ \\check M_k", "the same of the moment", "N m"));
    rows.push(row("F_\\parallel,\\ F_\\perp", "force along and across the reference direction; so for M", "N"));
    if [&loads.force, &loads.moment].into_iter().any(|waveform| waveform.harmonics().len() > 1) {
        rows.push(row("\\theta^{*}", "crank angle of the largest value", "°"));
        let meaning = "amplitude and phase of order k of a component; so for M";
        rows.push(row("F_{k\\parallel},\\ \\varepsilon_{k\\parallel}", meaning, "N, °"));
    }
    if loads.torque.is_some() {
        rows.push(row("t_k,\\ Q_k", "coefficient and star of the inertia torque", "–"));
        rows.push(row("\\hat T_k", "amplitude of order k of the inertia torque", "N m"));
    }
    Table { rows, ..Table::new(["Symbol", "Meaning", "Unit"]) }
}

const CORRECTED: &str = "corrected knuckle angles";
const DECIDED: &str = "decided order by order; its size is not asked for";

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
pub(super) fn effects(engine: &Engine, loads: &Loads) -> Vec<EffectRow> {
    let orders: Vec<String> = loads.orders.iter().map(|order| order.order.to_string()).collect();
    let masses = MassGroup::ALL.into_iter().map(|group| {
        let inside = loads.groups.iter().any(|loads| loads.group == group);
        let why = match (group, inside) {
            (MassGroup::Reciprocating, _) => phrase!("orders {}", orders.join(", ")),
            (_, true) => "given in the file".into(),
            (_, false) => "none given".into(),
        };
        EffectRow { name: group_words(group), inside, why, group: Some(group) }
    });
    let row = |name, inside: bool, yes: &'static str, no: &'static str| EffectRow {
        name,
        inside,
        why: if inside { yes } else { no }.into(),
        group: None,
    };
    let is_decided = verdict::quantities(engine, false).contains(&Quantity::TORQUE);
    let unequal = engine.mechanisms().len() > 1 || !engine.has_unit_masses();
    let others = [
        row(
            "pin offset",
            engine.has_offset(),
            if engine.has_odd_orders() { "given: odd orders appear" } else { "given: no odd orders but 1" },
            if engine.is_centric() { "none: no odd orders but 1" } else { "none" },
        ),
        row("unequal cylinders", unequal, "masses, radii, rods or offsets differ", "all are alike"),
        row("inertia torque", loads.torque.is_some(), "asked for", if is_decided { DECIDED } else { "not asked for" }),
        row("main bearings", !engine.bearings().is_empty(), "positions given", "no positions given"),
    ];
    let faster = engine.faster_crank();
    let speeds = faster
        .map(|_| row("crankshafts of several speeds", true, "given: each has the orders that its speed divides", ""));
    let corrected = engine.has_corrected_links();
    let others = others.into_iter().chain(corrected.then(|| row(CORRECTED, true, "given: odd orders appear", "none")));
    let effects = engine.effects();
    let asked = |name, asked: bool, given: bool| EffectRow {
        name,
        inside: asked && given,
        why: match (asked, given) {
            (true, true) => "asked for, in a section of its own",
            (true, false) => "asked for, and not given",
            (false, true) => "given, and not asked for",
            (false, false) => "not given",
        }
        .into(),
        group: None,
    };
    let sections = [
        asked("gas", effects.gas, engine.gas().is_some()),
        asked("torsion of the crankshaft", effects.torsion, engine.torsion().is_some()),
    ];
    masses.chain(others).chain(speeds).chain(sections).collect()
}

/// Where the numbers end.
pub(super) fn limits(engine: &Engine, loads: &Loads) -> Vec<Text> {
    let orders: Vec<String> = loads.orders.iter().map(|order| order.order.to_string()).collect();
    let mut lines = vec![
        phrase!("Tables and curves of force and moment contain only {}; the largest values contain all orders.", orders_in_words(&orders)),
        "They are those of masses alone: gas forces act inside the engine and leave no force on its mounts; their torque on the mounts is that of the section on torque, where the gas is asked for.".into(),
        "Amplitudes are zero-to-peak; a peak-to-peak value of a single order is twice as large.".into(),
        "Torsion and bending of the crankshaft, and speed that varies within a revolution, are not in the numbers.".into(),
    ];
    if engine.dimensions().given.iter().any(|given| given.quantity == Measure::RodMass) {
        lines.push("The inertia torque of a real rod differs from that of its two masses by the error of their moment of inertia.".into());
    }
    lines
}
