//! Which tables tell of a train with damping? Its shafts, discs, heat, resonances, dampers.

use super::amounts::{rpm, shaft};
use super::damped_data::megapascals;
use super::study::TorsionStudy;
use super::tables::{MOST_MODES, MOST_ROWS};
use super::{Barred, HeatPlace, ResonanceOrder, Vibration};
use crate::page::{Columns, Number, Table, Text, Unit, phrase};
use crate::torsion::Node;

/// A stress that is known in pascals.
fn stress(pascals: Option<f64>) -> Text {
    Text::or_dash(megapascals(pascals).map(|stress| Text::measured(stress, Unit::MEGAPASCAL)))
}

/// One row per shaft: torque and stress at the speed, the largest in the range, what is permitted there.
pub(super) fn shafts(study: &TorsionStudy, vibration: &Vibration) -> Table {
    let most = |index: usize| {
        let at = |one: &super::TwistAtSpeed| (one.torques[index], one.speed);
        study.over_range().iter().map(at).fold((0.0, 0.0), |most, one| if one.0 > most.0 { one } else { most })
    };
    let rows: Vec<_> = (0..study.train.shafts).map(|index| (index, vibration.torque(index), most(index))).collect();
    let has_stress = study.torsion().shafts.iter().any(|shaft| shaft.section.is_some());
    let (has_range, has_limit) =
        (!study.over_range().is_empty(), (0..study.train.shafts).any(|index| study.limit(index).is_some()));
    let torque = |torque: f64| Text::measured(torque, Unit::NEWTON_METRE);
    Table::of(rows)
        .column("Shaft", |(index, ..)| shaft(study, *index))
        .column(phrase!("Torque ({})", Unit::NEWTON_METRE), |(_, own, _)| torque(*own))
        .column_if(has_stress, phrase!("Stress ({})", Unit::MEGAPASCAL), |(index, own, _)| {
            stress(study.stress(*index, *own))
        })
        .column_if(has_range, phrase!("Largest torque ({})", Unit::NEWTON_METRE), |(.., most)| torque(most.0))
        .column_if(has_range, "At (rpm)", |(.., most)| {
            Text::or_dash(Some(Number::Decimal(most.1)).filter(|_| most.0 > 0.0))
        })
        .column_if(has_range && has_stress, phrase!("Its stress ({})", Unit::MEGAPASCAL), |(index, _, most)| {
            stress(study.stress(*index, most.0))
        })
        .column_if(has_limit, phrase!("Permitted there ({})", Unit::MEGAPASCAL), |(index, _, most)| {
            stress(study.permissible(*index, most.1))
        })
        .done()
}

/// A disc by its number from 1; the rings of dampers follow the discs of the layout.
fn disc_name(study: &TorsionStudy, disc: usize) -> Text {
    match disc.checked_sub(study.torsion().inertias.len()) {
        None => (disc + 1).into(),
        Some(damper) => phrase!("ring of damper {}", damper + 1),
    }
}

/// One row per disc: how far it swings.
pub(super) fn twists(study: &TorsionStudy, vibration: &Vibration) -> Table {
    Table::of(0..study.train.discs.len())
        .column("Disc", |disc| disc_name(study, *disc))
        .column("Amplitude (°)", |disc| Number::Decimal(vibration.twist(*disc).to_degrees()))
        .done()
}

/// One row per place: the power that becomes heat.
pub(super) fn heat(study: &TorsionStudy, vibration: &Vibration) -> Table {
    let place = |place: HeatPlace| match place {
        HeatPlace::Disc(disc) => phrase!("disc {}", disc + 1),
        HeatPlace::Shaft(index) => phrase!("shaft {}", shaft(study, index)),
        HeatPlace::Damper(damper) => phrase!("damper {}", damper + 1),
    };
    let places = study.heat_places(vibration).into_iter();
    let mut rows: Vec<(Text, f64)> = places.map(|(at, power)| (place(at), power)).collect();
    if rows.len() > 1 {
        rows.push(("together".into(), rows.iter().map(|(_, power)| power).sum()));
    }
    Table::of(rows)
        .column("Where", |(place, _)| place.clone())
        .column(phrase!("Heat ({})", Unit::WATT), |(_, power)| Text::measured(*power, Unit::WATT))
        .done()
}

/// One row per order and mode: the critical speed, the amplitude by both methods, the torque, the peak, the barred speeds.
pub(super) fn resonances(study: &TorsionStudy) -> Table {
    let rows = study.resonances();
    let table = first_columns(study, rows.iter())
        .column("By energy (°)", |one| Number::Decimal(one.at_first(one.energy.amplitude).to_degrees()));
    let table = with_peak(table);
    if rows.iter().all(|one| study.cure(one).is_none()) {
        return table.done();
    }
    // Why another range is no cure is told in words.
    let range = |Barred { speeds: [from, to], .. }: &Barred| phrase!("{} to {}", rpm(*from), rpm(*to));
    table.column("Barred", |one| Text::or_dash(study.cure(one).map(range))).done()
}

/// The strongest of them in short, for a terminal.
pub(super) fn strongest(study: &TorsionStudy) -> Table {
    let mut rows: Vec<&ResonanceOrder> = study.resonances().iter().collect();
    rows.sort_by(|one, other| other.largest.torque.total_cmp(&one.largest.torque));
    with_peak(first_columns(study, rows.into_iter().take(MOST_ROWS))).done()
}

fn with_peak(table: Columns<&ResonanceOrder>) -> Columns<&ResonanceOrder> {
    table
        .column("Peak at (rpm)", |one| Text::or_dash(one.peak.map(|peak| Number::Decimal(peak.0))))
        .column(phrase!("Peak ({})", Unit::NEWTON_METRE), |one| {
            Text::or_dash(one.peak.map(|peak| Text::measured(peak.1, Unit::NEWTON_METRE)))
        })
}

fn first_columns<'a>(
    study: &'a TorsionStudy,
    rows: impl Iterator<Item = &'a ResonanceOrder>,
) -> Columns<&'a ResonanceOrder> {
    Table::of(rows)
        .column("Mode", |one| one.mode + 1)
        .column("Order κ", |one| one.order.to_string())
        .column("Critical speed (rpm)", |one| Number::Decimal(one.rpm))
        .column("First disc (°)", |one| Number::Decimal(one.first.to_degrees()))
        .column(phrase!("Torque ({})", Unit::NEWTON_METRE), |one| Text::measured(one.torque, Unit::NEWTON_METRE))
        .column("Shaft", |one| shaft(study, one.shaft))
}

/// One row per node of the first modes: between which discs, and at which part of the way.
pub(super) fn nodes(study: &TorsionStudy) -> Table {
    let modes = (1..).zip(study.modes.iter().take(MOST_MODES));
    let rows = modes.flat_map(|(mode, speeds)| speeds.mode.nodes.iter().map(move |node| (mode, node)));
    let at = |node: &Node| node.ends(&study.train).map(|disc| disc_name(study, disc));
    Table::of(rows)
        .column("Mode", |(mode, _): &(usize, &Node)| *mode)
        .column("Node from disc", |(_, node)| at(node)[0].clone())
        .column("To disc", |(_, node)| at(node)[1].clone())
        .column("Fraction of the shaft's length", |(_, node)| {
            Text::or_dash(match node {
                Node::Shaft(_, part) => Some(Number::Decimal(*part)),
                Node::Disc(_) => None,
            })
        })
        .done()
}

/// One row per damper and setting: as written, by the formula, by the search.
pub(super) fn dampers(study: &TorsionStudy) -> Table {
    let mut rows = Vec::new();
    for (index, damper) in study.dampers().iter().enumerate() {
        let found = damper.found.as_ref();
        let peak = |at: usize| found.map(|found| found.peaks[at]);
        rows.push((index, Text::from("as in the layout"), damper.setting, peak(1)));
        rows.push((index, "by the formula".into(), damper.in_mode.best, None));
        if let Some(found) = found {
            rows.push((index, "by the search".into(), found.best, peak(0)));
        }
    }
    Table::of(rows)
        .column("Damper", |(index, ..)| index + 1)
        .column("Setting", |(_, words, ..)| words.clone())
        .column(phrase!("Stiffness ({})", Unit::NEWTON_METRE_PER_RADIAN), |(.., setting, _)| {
            // A viscous damper has no spring.
            let has_spring = setting.stiffness > 0.0;
            if has_spring { Text::measured(setting.stiffness, Unit::NEWTON_METRE_PER_RADIAN) } else { "none".into() }
        })
        .column(phrase!("Damping ({})", Unit::NEWTON_METRE_SECOND), |(.., setting, _)| {
            Text::measured(setting.damping, Unit::NEWTON_METRE_SECOND)
        })
        .column(phrase!("Largest torque ({})", Unit::NEWTON_METRE), |(.., peak)| {
            Text::or_dash(peak.map(|peak| Text::measured(peak, Unit::NEWTON_METRE)))
        })
        .done()
}
