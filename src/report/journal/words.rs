//! What is said of the complete loads: first, and at the end?

use super::super::bearings::{beam_assumptions, called};
use super::super::torque::{angle, assumptions as of_the_gas, names, quantity};
use crate::engine::Engine;
use crate::journal::{self, CycleBearings, CycleLoads};
use crate::page::{Piece, Text, Unit, number};
use crate::report::texts::journal as text;

pub(super) fn newtons(value: f64) -> Text {
    quantity(value, Unit::NEWTON)
}

/// The lines of the box.
pub(super) fn answer(engine: &Engine, loads: &CycleLoads, [continuous, determinate]: &[CycleBearings; 2]) -> Vec<Text> {
    let mut lines: Vec<Text> = largest(continuous).into_iter().chain(others(continuous, determinate)).collect();
    lines.extend(pins(engine, loads));
    lines.extend(shared_pins(engine, loads));
    lines.extend(knuckles(engine, loads));
    lines.extend(rods(engine, loads));
    lines.push(text::signs());
    lines
}

/// What the bearings with the largest load are called, and that load.
fn worst(bearings: &CycleBearings) -> Option<(Text, f64)> {
    let names: Vec<String> = bearings.worst.iter().map(|index| bearings.bearings[*index].name.clone()).collect();
    let peak = bearings.bearings[*bearings.worst.first()?].peak.value;
    Some((called(&names), peak))
}

fn largest(bearings: &CycleBearings) -> Option<Text> {
    let (names, size) = worst(bearings)?;
    let peaks = bearings.worst.iter().map(|index| &bearings.bearings[*index].peak);
    let mut at: Vec<Text> = peaks.clone().map(|peak| angle(peak.angle)).collect();
    at.dedup_by_key(|angle| angle.plain());
    let at = Text::joined(at, ", ");
    let gas = peaks.clone().next()?.gas_along();
    // What rounding leaves where the masses load no bearing is no load.
    let is_gas_alone = journal::worst(bearings.bearings.iter().map(|bearing| bearing.inertia.value)).is_empty();
    let of_masses = if is_gas_alone { 0.0 } else { size - gas };
    Some(if gas < 0.0 {
        text::of_masses_less_gas(newtons(size), names, at, newtons(-gas))
    } else if of_masses < 0.0 {
        text::of_gas_less_masses(newtons(size), names, at, newtons(gas), newtons(-of_masses))
    } else {
        text::of_both(newtons(size), names, at, newtons(gas), newtons(of_masses))
    })
}

/// The masses alone, and the other way to share the loads.
fn others(continuous: &CycleBearings, determinate: &CycleBearings) -> Option<Text> {
    let sizes = continuous.bearings.iter().map(|bearing| bearing.inertia.value);
    let alone = journal::worst(sizes.clone());
    let names: Vec<String> = alone.iter().map(|index| continuous.bearings[*index].name.clone()).collect();
    let (determinate, load) = worst(determinate)?;
    if alone.is_empty() {
        return Some(text::no_loads_of_masses(newtons(load), determinate));
    }
    Some(text::other_loads(newtons(sizes.fold(0.0, f64::max)), called(&names), newtons(load), determinate))
}

/// The first of those with the largest of some size.
fn first<T>(all: impl IntoIterator<Item = T> + Clone, size: impl Fn(&T) -> f64) -> Option<T> {
    let most = all.clone().into_iter().map(|one| size(&one)).fold(f64::NEG_INFINITY, f64::max);
    all.into_iter().find(|one| size(one) >= most - 1e-9 * most.abs())
}

fn pins(engine: &Engine, loads: &CycleLoads) -> Option<Text> {
    // A link is on a knuckle pin; what the master rod and its links do to the crankpin together is told beside it.
    if engine.only_rods().is_err() {
        return None;
    }
    let worst = journal::worst(loads.cylinders.iter().map(|cylinder| cylinder.peaks.pin.value));
    let peak = &loads.cylinders[*worst.first()?].peaks.pin;
    let (names, load, angle) = (names(engine, &worst), newtons(peak.value), angle(peak.angle));
    let rods = !engine.has_yokes_alone();
    Some(match worst.len() {
        1 => text::worst_crankpin(rods, names, load, angle),
        _ => text::worst_crankpins(rods, names, load, angle),
    })
}

fn shared_pins(engine: &Engine, loads: &CycleLoads) -> Option<Text> {
    let worst = journal::worst(loads.shared_pins.iter().map(|pin| pin.peak.value));
    let pin = &loads.shared_pins[*worst.first()?];
    let (load, angle) = (newtons(pin.peak.value), angle(pin.peak.angle));
    let pins = worst.iter().map(|index| (loads.shared_pins[*index].throw + 1).to_string());
    Some(match worst.len() {
        1 => text::worst_shared_pin(pin.throw + 1, names(engine, &pin.cylinders), load, angle),
        _ => text::worst_shared_pins(number::listed(pins), load, angle),
    })
}

fn knuckles(engine: &Engine, loads: &CycleLoads) -> Option<Text> {
    let knuckle = first(&loads.knuckles, |knuckle| knuckle.peak.value)?;
    let [link, master] = [knuckle.cylinder, knuckle.master].map(|cylinder| names(engine, &[cylinder]));
    Some(text::worst_knuckle_pin(link, master, newtons(knuckle.peak.value), angle(knuckle.peak.angle)))
}

fn rods(engine: &Engine, loads: &CycleLoads) -> Option<Text> {
    if engine.has_yokes_alone() {
        return None;
    }
    let rod = |index: usize| &loads.cylinders[index].peaks.rod;
    let pressed = first(0..loads.cylinders.len(), |index| rod(*index)[0].value)?;
    let pulled = first(0..loads.cylinders.len(), |index| -rod(*index)[1].value)?;
    let name = |index: usize| names(engine, &[index]);
    let [most, least] = [rod(pressed)[0].value, rod(pulled)[1].value];
    Some(match least < 0.0 {
        true if pressed == pulled => text::one_rod(name(pressed), newtons(most), newtons(-least)),
        true => text::two_rods(name(pressed), newtons(most), name(pulled), newtons(-least)),
        false => text::no_tension(name(pressed), newtons(most)),
    })
}

/// How well the orders tell the loads.
pub(super) fn missed(loads: &CycleLoads, bearings: &CycleBearings) -> Text {
    text::missed(crate::torque::HIGHEST, Piece::AtMost(loads.missed(bearings), Unit::NEWTON))
}

/// What the numbers rest on.
pub(super) fn assumptions(engine: &Engine) -> Vec<Text> {
    let [shaft, _, pistons, determinate] = beam_assumptions(engine);
    let mut list = vec![shaft, text::loads(), pistons, determinate];
    list.extend(of_the_gas(engine));
    list
}
