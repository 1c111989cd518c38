//! What is said of an engine on its mounts in words?

use super::super::{residual, typeset};
use super::{MountsStudy, OrderMotion, Place, SOFTEST, largest};
use crate::engine::CycleOrder;
use crate::page::{Piece, Text, Unit, phrase};
use crate::report::texts::mounts as text;

pub(super) fn rpm(value: f64) -> Text {
    Piece::Quantity(value, Unit::PER_MINUTE).into()
}

pub(super) fn place(of: Place) -> Text {
    match of {
        Place::Centre => "centre of gravity".into(),
        Place::Point => "point of the file".into(),
        Place::Mount(mount) => phrase!("mount {}", mount + 1),
    }
}

/// The short answer: what is passed on and what moves, which orders do not, where the natural frequencies are.
pub(super) fn answer(study: &MountsStudy) -> Vec<Text> {
    let moving: Vec<&OrderMotion> = study.moving().map(|(_, one)| one).collect();
    let mut lines: Vec<Text> = resonance(study).into_iter().chain(force(study)).chain(velocity(study)).collect();
    lines.push(match (typeset::listed(study.still()), moving.is_empty()) {
        (none, _) if none.is_empty() => text::every_order_moves(),
        (_, true) => text::no_order_moves(),
        (still, false) => text::still_orders(still),
    });
    let roll_alone = moving
        .iter()
        .filter(|one| one.excitation.still.force && one.excitation.still.moment)
        .map(|one| one.excitation.order);
    let roll_alone: Vec<CycleOrder> = roll_alone.collect();
    if !roll_alone.is_empty() {
        lines.push(text::roll_alone(residual::orders_in_words(&roll_alone)));
    }
    lines.push(frequencies(study));
    lines
}

/// The largest force along one axis that a mount passes on, its mount and its order.
pub(super) fn passed_on(study: &MountsStudy) -> Option<(f64, usize, CycleOrder)> {
    let moving = study.moving().filter_map(|(_, one)| Some((one.excitation.order, one.motion.as_ref()?)));
    let of_mounts = moving.flat_map(|(order, motion)| {
        let mounts = 0..study.body.mounts();
        mounts.map(move |mount| (largest(&study.body.mount_force(mount, motion)), mount, order))
    });
    of_mounts.max_by(|one, other| one.0.total_cmp(&other.0))
}

fn resonance(study: &MountsStudy) -> Option<Text> {
    let orders =
        typeset::listed(study.moving().filter(|(_, one)| one.motion.is_none()).map(|(_, one)| one.excitation.order));
    (!orders.is_empty()).then(|| text::resonance(rpm(study.speed), orders))
}

fn force(study: &MountsStudy) -> Option<Text> {
    let (force, mount, order) = passed_on(study)?;
    Some(text::transmitted(rpm(study.speed), Piece::Quantity(force, Unit::NEWTON), mount + 1, order.to_string()))
}

fn velocity(study: &MountsStudy) -> Option<Text> {
    let moving = study.moving().filter_map(|(_, one)| Some((study.velocity(one.motion.as_ref()?), one)));
    let (speed, fastest) = moving.max_by(|one, other| one.0.total_cmp(&other.0))?;
    Some(text::largest_velocity(
        place(study.watched()),
        Piece::Quantity(speed * 1e3, Unit::MILLIMETRE_PER_SECOND),
        fastest.excitation.order.to_string(),
    ))
}

/// All natural frequencies, and the highest speed at which an order that moves the engine meets one.
fn frequencies(study: &MountsStudy) -> Text {
    let all = study.modes.iter().map(|mode| Piece::Quantity(mode.hertz(), Unit::HERTZ).into());
    let all = Text::joined(all, ", ");
    let lowest = study.moving().map(|(_, one)| one.excitation.order).next();
    match (lowest, study.modes.last()) {
        (Some(order), Some(highest)) => text::highest_met(all, order.to_string(), rpm(order.rpm(highest.hertz()))),
        _ => text::natural_frequencies(all),
    }
}

/// The torque-roll axis.
pub(super) fn axis(study: &MountsStudy) -> Option<Text> {
    let axis = study.axis.as_ref()?;
    let direction = axis.direction.map(|part| Text::measured(part, Unit::NONE));
    Some(text::axis(
        Piece::Quantity(axis.from_crankshaft, Unit::DEGREE),
        Text::joined(direction, "; "),
        Piece::Quantity(axis.hertz, Unit::HERTZ),
        Piece::Quantity(100.0 * axis.coupling, Unit::PERCENT),
    ))
}

/// What a reader has to know of the file.
pub(super) fn notes(study: &MountsStudy) -> Vec<Text> {
    let mut notes = Vec::new();
    if study.modes.iter().all(|mode| mode.hertz() < SOFTEST) {
        notes.push(text::soft_mounts(Piece::Quantity(SOFTEST, Unit::HERTZ)));
    }
    if !study.has_gas {
        notes.push(text::no_gas());
    }
    if study.body.is_undamped() {
        notes.push(text::undamped());
    }
    notes
}

/// The planes of symmetry of body and mounts.
pub(super) fn mirrors(study: &MountsStudy) -> Vec<Text> {
    let [x, y, z] = study.mounting().mirrors();
    let mut told = Vec::new();
    if z {
        told.push(text::symmetric_across());
    }
    for (_, is_across) in [(y, true), (x, false)].into_iter().filter(|(is_mirror, _)| *is_mirror) {
        told.push(text::symmetric_along(is_across));
    }
    told
}
