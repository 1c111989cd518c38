//! What is said first of a shaft that twists, and what it rests on?

use super::super::torque::misfire;
use super::amounts::{given_rpm, part, range, rpm, shaft, torque};
use super::damped::LEAST_RATIO;
use super::study::TorsionStudy;
use super::tables::MOST_MODES;
use super::{barred, gears};
use crate::page::{Piece, Text, Unit, phrase};
use crate::report::mechanism_words;
use crate::report::texts::torsion as text;
use crate::torsion::{CriticalSpeeds, first_of_largest};

/// What the answer rests on.
pub(super) fn assumed(study: &TorsionStudy) -> Vec<Text> {
    let torsion = study.torsion();
    let mut lines = vec![
        if study.is_row() { text::row() } else { text::train() },
        if torsion.is_damped() { text::damped() } else { text::undamped() },
    ];
    if study.at_speed().is_some() {
        lines.push(if torsion.harmonics.is_empty() {
            text::pressures(super::excited::highest(&study.engine))
        } else {
            text::harmonics()
        });
    }
    lines.extend(text::always_assumed());
    lines.extend(mechanism_words::in_torsion(&study.engine));
    lines
}

/// How all of it is found.
pub(super) fn found(study: &TorsionStudy) -> Vec<Text> {
    let mut paragraphs = vec![text::equations()];
    if study.excited().is_some() && study.torsion().is_damped() {
        paragraphs.push(text::equations_damped());
        paragraphs.extend((!study.train.gears.is_empty()).then(text::equations_of_gears));
    }
    if (0..study.train.shafts).any(|shaft| study.limit(shaft).is_some()) {
        paragraphs.push(text::classification());
    }
    if !study.torsion().dampers.is_empty() {
        paragraphs.push(text::best_dampers());
    }
    paragraphs
}

/// What the table of forced twists says.
pub(super) fn forced(study: &TorsionStudy, speed: f64) -> Text {
    if study.torsion().is_damped() {
        return text::forced(given_rpm(speed));
    }
    text::forced_undamped(given_rpm(speed))
}

fn hertz(mode: &CriticalSpeeds) -> Text {
    Piece::Quantity(mode.mode.hertz(), Unit::HERTZ).into()
}

/// What shakes where the torque is known, the frequencies, and the strongest critical speed.
pub(super) fn answer(study: &TorsionStudy) -> Vec<Text> {
    let mut lines: Vec<Text> = misfire(&study.engine).into_iter().collect();
    lines.extend(study.engine.misfire().map(|_| text::of_a_misfire()));
    lines.extend(forced_answer(study));
    lines.extend(frequencies(study));
    lines.extend(at_rest(study));
    if !study.torsion().is_damped() && study.torsion().has_forced() {
        lines.push(text::infinite());
    }
    if study.torsion().is_damped() && study.excited().is_none() {
        lines.push(text::no_amplitudes());
    }
    lines
}

fn frequencies(study: &TorsionStudy) -> Vec<Text> {
    let mut lines = Vec::new();
    let Some(first) = study.modes.first() else { return lines };
    let nodes: Vec<usize> = study.modes.iter().take(2).map(|speeds| speeds.mode.nodes()).collect();
    lines.push(match (nodes.as_slice(), study.modes.get(1)) {
        ([1], None) if study.is_row() => text::first_frequency(hertz(first)),
        ([1, 2], Some(second)) if study.is_row() => text::two_frequencies(hertz(first), hertz(second)),
        _ => {
            let first = study.modes.iter().take(MOST_MODES).map(hertz);
            text::natural_frequencies(Text::joined(first, ", "))
        }
    });
    let mut equal: Vec<_> = study.modes.iter().map(|speeds| &speeds.mode.alike).filter(|one| one.len() > 1).collect();
    equal.dedup();
    if !equal.is_empty() {
        let groups = equal.iter().map(|alike| format!("{}–{}", alike.start + 1, alike.end).into());
        lines.push(text::equal_frequencies(Text::joined(groups, ", ")));
    }
    lines.push(match (study.strongest(first).first(), study.highest_speed()) {
        (None, Some(speed)) => text::none_excites_below(given_rpm(speed)),
        (None, None) => text::none_excites(),
        (Some(critical), Some(speed)) => text::strongest_order_below(
            given_rpm(speed),
            critical.order.to_string(),
            rpm(critical.rpm),
            part(first.part(critical)),
        ),
        (Some(critical), None) => {
            text::strongest_order(critical.order.to_string(), rpm(critical.rpm), part(first.part(critical)))
        }
    });
    lines
}

fn damping(value: f64) -> Text {
    Piece::Quantity(value, Unit::NEWTON_METRE_SECOND).into()
}

/// The forced vibration with damping: at the speed, over the range, stresses, dampers.
fn forced_answer(study: &TorsionStudy) -> Vec<Text> {
    if study.torsion().is_damped() && study.is_still() {
        return std::iter::once(text::still()).chain(gears::answer(study)).collect();
    }
    let mut lines = Vec::new();
    if let Some(vibration) = study.at_speed() {
        let torques = (0..study.train.shafts).map(|shaft| (shaft, vibration.torque(shaft)));
        let (most, value) = first_of_largest(torques, |one| one.1).unwrap_or_default();
        let swings: Text = Piece::Quantity(vibration.twist(0).to_degrees(), Unit::DEGREE).into();
        let where_it_is = shaft(study, most);
        lines.push(match study.stress(most, value) {
            // The train turns as a rigid body, as far as decimals tell.
            _ if value == 0.0 => text::rigid(given_rpm(vibration.speed), swings),
            None => text::twist(given_rpm(vibration.speed), swings, torque(value), where_it_is),
            Some(stress) => text::stressed_twist(
                given_rpm(vibration.speed),
                swings,
                torque(value),
                where_it_is,
                Piece::Quantity(1e-6 * stress, Unit::MEGAPASCAL),
            ),
        });
    }
    lines.extend(gears::answer(study));
    if let Some(most) = study.strongest_peak() {
        let (order, where_it_is) = (most.order.to_string(), shaft(study, most.shaft));
        lines.push(text::strongest_peak(order, rpm(most.rpm), torque(most.torque), where_it_is));
    }
    for excess in study.excesses() {
        let [from, to] = range(excess.speeds);
        lines.push(text::excess(shaft(study, excess.shaft), from, to));
    }
    for one in study.resonances() {
        if one.is_unbarred {
            lines.push(text::may_not_be_barred(rpm(one.rpm), one.order.to_string()));
        }
        lines.extend(one.barred.as_ref().map(|range| barred::said(study, one, range)));
    }
    for (damper, given) in study.dampers().iter().zip(&study.torsion().dampers) {
        match damper.in_mode.mass_ratio {
            0.0 => lines.push(text::damper_at_rest(given.disc + 1)),
            ratio if ratio < LEAST_RATIO => lines.push(text::light_damper(given.disc + 1)),
            _ => {}
        }
        if let Some(found) = &damper.found {
            let settings = [damper.setting, damper.in_mode.best, found.best];
            let [own, by_formula, by_search] = settings.map(|setting| damping(setting.damping));
            let (disc, order, with) = (given.disc + 1, found.order.to_string(), torque(found.peaks[1]));
            lines.push(match found.without {
                Some(without) => text::damper(disc, own, by_formula, by_search, order, with, torque(without)),
                None => text::damper_alone(disc, own, by_formula, by_search, order, with),
            });
        }
    }
    lines
}

/// Orders that leave a free shaft at rest as a whole, exactly, and twist it all the same.
fn at_rest(study: &TorsionStudy) -> Option<Text> {
    let torsion = study.torsion();
    let orders = &study.excited().filter(|_| torsion.is_damped())?.twist_alone;
    if orders.is_empty()
        || study.engine.misfire().is_some()
        || torsion.dampings.iter().any(num_traits::Signed::is_positive)
        || !torsion.gears.is_empty()
    {
        return None;
    }
    let named = Text::joined(orders.iter().map(|order| order.to_string().into()), ", ");
    let which = if orders.len() == 1 { phrase!("order {}", named) } else { phrase!("orders {}", named) };
    Some(text::no_rigid_motion(which))
}
