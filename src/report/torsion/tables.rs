//! Which tables tell of a shaft that twists? Its discs, its modes, its critical speeds.

use super::super::typeset;
use super::ForcedTwist;
use super::TorsionStudy;
use super::words::part;
use crate::page::{Number, Table, Text, Unit, number, phrase};

/// At most so many modes stand beside each other.
pub(super) const MOST_MODES: usize = 3;

/// One row per mode: frequency, the same in 1/min, nodes.
pub(super) fn modes(study: &TorsionStudy) -> Table {
    let mut table = Table::new(["Mode", "Frequency (Hz)", "Frequency (1/min)", "Nodes"]);
    for (index, speeds) in study.modes.iter().enumerate() {
        let hertz = speeds.mode.hertz();
        table.push(vec![
            (index + 1).into(),
            Number::Decimal(hertz).into(),
            Number::Decimal(60.0 * hertz).into(),
            speeds.mode.nodes().into(),
        ]);
    }
    table
}

/// One row per disc: inertia, stiffness to the next, crankpins, deflection in the first modes.
pub(super) fn discs(study: &TorsionStudy) -> Table {
    let mut header: Vec<Text> = vec![
        "Disc".into(),
        phrase!("Inertia ({})", Unit::KILOGRAM_SQUARE_METRE),
        phrase!("Stiffness to the next ({})", Unit::NEWTON_METRE_PER_RADIAN),
        "Crankpins".into(),
    ];
    let shown = || study.modes.iter().take(MOST_MODES).enumerate();
    header.extend(shown().map(|(index, _)| phrase!("Deflection, mode {}", index + 1)));
    let mut table = Table::new(header);
    for (disc, inertia) in study.torsion().inertias.iter().enumerate() {
        let stiffness = study.torsion().stiffnesses.get(disc);
        let on_disc = study.torsion().pins.iter().enumerate().filter(|(_, at)| **at == disc);
        let pins: Vec<String> = on_disc.map(|(pin, _)| (pin + 1).to_string()).collect();
        let mut cells: Vec<Text> = vec![
            (disc + 1).into(),
            number::given_in(inertia, Unit::KILOGRAM_SQUARE_METRE),
            stiffness.map_or_else(|| "–".into(), |value| number::given_in(value, Unit::NEWTON_METRE_PER_RADIAN)),
            if pins.is_empty() { "–".into() } else { pins.join(", ").into() },
        ];
        cells.extend(shown().map(|(_, speeds)| Text::label(typeset::approximate(speeds.mode.shape[disc]))));
        table.push(cells);
    }
    table
}

/// One row per order: how far it twists the shaft at the speed of the layout.
pub(super) fn forced(orders: &[ForcedTwist]) -> Table {
    let mut table = Table::new([
        "Order κ".into(),
        "Frequency (Hz)".into(),
        "Swing of the free end (°)".into(),
        phrase!("Torque in the shaft ({})", Unit::NEWTON_METRE),
        Text::from("Behind disc"),
    ]);
    for forced in orders {
        let mut cells: Vec<Text> = vec![forced.order.to_string().into(), Number::Decimal(forced.hertz).into()];
        cells.extend(match forced.near {
            Some(mode) => [phrase!("near mode {}", mode), "–".into(), "–".into()],
            None => {
                let torque = Text::measured(forced.shaft, Unit::NEWTON_METRE);
                [Number::Decimal(forced.free_end).into(), torque, forced.behind.into()]
            }
        });
        table.push(cells);
    }
    table
}

/// One row per order: the critical speed of each mode, and the star as a part of the longest.
pub(super) fn critical(study: &TorsionStudy) -> Table {
    let mut header: Vec<Text> = vec!["Order κ".into()];
    let shown = || study.modes.iter().take(MOST_MODES).enumerate();
    for (index, _) in shown() {
        header.push(phrase!("Mode {} at (1/min)", index + 1));
        header.push(phrase!("Star of mode {}", index + 1));
    }
    let mut table = Table::new(header);
    let orders = study.modes.first().map(|speeds| speeds.orders.as_slice()).unwrap_or_default();
    for (row, first) in orders.iter().enumerate() {
        let mut cells: Vec<Text> = vec![first.order.to_string().into()];
        for (_, speeds) in shown() {
            let critical = &speeds.orders[row];
            cells.push(Number::Decimal(critical.rpm).into());
            cells.push(part(critical.star.norm() / speeds.longest));
        }
        table.push(cells);
    }
    table
}
