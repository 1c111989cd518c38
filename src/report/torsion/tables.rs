//! Which tables tell of a shaft that twists? Its discs, its modes, its critical speeds.

use super::super::typeset;
use super::ForcedTwist;
use super::amounts::{part, shaft};
use super::study::TorsionStudy;
use crate::engine::{CycleOrder, ElasticShaft};
use crate::page::{Number, Table, Text, Unit, number, phrase};

/// At most this many modes are beside each other.
pub(super) const MOST_MODES: usize = 3;
/// At most this many rows of a table stand on a terminal.
pub(super) const MOST_ROWS: usize = 8;

/// One row per mode, of the first this many: frequency, the same in rpm, nodes.
pub(super) fn modes(study: &TorsionStudy, most: usize) -> Table {
    Table::of(study.modes.iter().map(|speeds| &speeds.mode).take(most).enumerate())
        .column("Mode", |(index, _)| index + 1)
        .column("Frequency (Hz)", |(_, mode)| Number::Decimal(mode.hertz()))
        .column("Frequency (rpm)", |(_, mode)| Number::Decimal(60.0 * mode.hertz()))
        .column("Nodes", |(_, mode)| mode.nodes())
        .done()
}

/// One row per disc: inertia, stiffness to the next, crankpins, deflection in the first modes.
pub(super) fn discs(study: &TorsionStudy) -> Table {
    let torsion = study.torsion();
    let pins = |disc: usize| {
        let on_disc = (1_usize..).zip(&torsion.pins).filter(|(_, at)| **at == disc);
        let pins = typeset::listed(on_disc.map(|(pin, _)| pin));
        Text::or_dash(Some(pins).filter(|pins| !pins.is_empty()))
    };
    let stiffness = |shaft: &ElasticShaft| number::given_in(&shaft.stiffness, Unit::NEWTON_METRE_PER_RADIAN);
    let table = Table::of(torsion.inertias.iter().enumerate())
        .column("Disc", |(disc, _)| disc + 1)
        .column(phrase!("Inertia ({})", Unit::KILOGRAM_SQUARE_METRE), |(_, inertia)| {
            number::given_in(inertia, Unit::KILOGRAM_SQUARE_METRE)
        })
        .column(phrase!("Stiffness to the next ({})", Unit::NEWTON_METRE_PER_RADIAN), |(disc, _)| {
            Text::or_dash(study.shaft_behind(*disc).map(stiffness))
        })
        .column("Crankpins", |(disc, _)| pins(*disc));
    let shown = study.modes.iter().take(MOST_MODES).enumerate();
    let with_modes = shown.fold(table, |table, (index, speeds)| {
        table.column(phrase!("Deflection, mode {}", index + 1), |(disc, _)| {
            Text::label(typeset::approximate(speeds.mode.shape[*disc]))
        })
    });
    with_modes.done()
}

/// One row per order: how far it twists the shaft at the speed of the layout.
pub(super) fn forced(study: &TorsionStudy, orders: &[ForcedTwist]) -> Table {
    let far = |twist: &ForcedTwist, value: Text| if twist.near.is_some() { "–".into() } else { value };
    let table = Table::of(orders)
        .column("Order κ", |twist| twist.order.to_string())
        .column("Frequency (Hz)", |twist| Number::Decimal(twist.hertz))
        .column("Amplitude at the free end (°)", |twist| match twist.near {
            Some(mode) => phrase!("near mode {}", mode),
            None => study.twist_of(twist.order, twist.free_end),
        })
        .column(phrase!("Torque in the shaft ({})", Unit::NEWTON_METRE), |twist| {
            far(twist, study.torque_of(twist.order, twist.shaft))
        });
    let table = match study.is_row() {
        true => table.column("Behind disc", |twist| far(twist, study.behind(twist).into())),
        false => table.column("Shaft", |twist| far(twist, shaft(study, twist.shaft_number).into())),
    };
    table.done()
}

/// One row per order: the critical speed of each mode, and the star as a part of the longest.
pub(super) fn critical(study: &TorsionStudy) -> Table {
    critical_of(study, |_| true)
}

/// The same for the orders with the longest stars in the first mode, for a terminal; and of how many these are.
pub(super) fn strongest(study: &TorsionStudy) -> (Table, usize) {
    let Some(first) = study.modes.first() else { return (critical(study), 0) };
    let count = first.orders.len();
    if count <= MOST_ROWS {
        return (critical(study), count);
    }
    let strongest: Vec<CycleOrder> = study.strongest(first).into_iter().map(|one| one.order).take(MOST_ROWS).collect();
    (critical_of(study, |order| strongest.contains(&order)), count)
}

fn critical_of(study: &TorsionStudy, is_shown: impl Fn(CycleOrder) -> bool) -> Table {
    let orders = study.modes.first().map(|speeds| speeds.orders.as_slice()).unwrap_or_default();
    let rows = orders.iter().enumerate().filter(|(_, first)| is_shown(first.order));
    let table = Table::of(rows).column("Order κ", |(_, first)| first.order.to_string());
    let shown = study.modes.iter().take(MOST_MODES).enumerate();
    let with_modes = shown.fold(table, |table, (index, speeds)| {
        table
            .column(phrase!("Mode {} at (rpm)", index + 1), |(row, _)| Number::Decimal(speeds.orders[*row].rpm))
            .column(phrase!("Star of mode {}", index + 1), |(row, _)| {
                let critical = &speeds.orders[*row];
                if critical.vanishes { Text::zero() } else { part(speeds.part(critical)) }
            })
    });
    with_modes.done()
}
