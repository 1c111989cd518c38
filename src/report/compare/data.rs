//! Which columns hold a comparison? A row an engine and order, and a row an engine.

use crate::report::compare::document::{CompareDocument, EngineEntry, Firing, Newtons};
use crate::report::compare::{Compared, compare_document};
use crate::report::data::Filling;
use crate::report::data::{of_orders, units};
use crate::report::remaining::RemainingOrder;
use crate::table::{Table, Unit};
use crate::text::Untrusted;

/// An order of an engine.
struct Row<'a> {
    name: &'a Untrusted,
    entry: &'a EngineEntry,
    order: &'a RemainingOrder,
    moment: Unit,
}

/// The tables of a comparison: the orders of each engine, and the engines.
pub fn tables(engines: &[Compared]) -> Vec<Table> {
    let document = compare_document(engines);
    vec![orders(engines, &document), of_engines(engines, &document)]
}

fn orders(engines: &[Compared], document: &CompareDocument) -> Table {
    let rows = engines.iter().zip(&document.engines).flat_map(|(compared, entry)| {
        let [_, moment] = units(&compared.engine);
        entry.orders.iter().map(move |order| Row { name: &compared.name, entry, order, moment })
    });
    let rows: Vec<Row> = rows.collect();
    let used = |unit: &Unit| rows.iter().any(|row| row.moment == *unit);
    let moments: Vec<Unit> = [Unit::OPEN_SPACING, Unit::OPEN_METRE].into_iter().filter(used).collect();
    let mut table = Filling::new("compare.orders", &rows);
    table.person("engine", |row| Some(row.name.clone()));
    table.whole("order", |row| row.order.order as usize);
    of_orders(&mut table, |row| row.order, &moments, |row| row.moment);
    if document.engines.iter().any(|entry| entry.newtons.is_some()) {
        let newtons = |row: &Row, of: fn(&Newtons) -> f64| {
            row.entry.newtons.as_ref()?.iter().find(|newtons| newtons.order == row.order.order).map(of)
        };
        table.decimal(("{quantity}_zero_to_peak_{unit}", "force"), Unit::NEWTON, |row| {
            newtons(row, |newtons| newtons.force)
        });
        for (moment, unit) in [(Unit::OPEN_SPACING, Unit::NEWTON_SPACING), (Unit::OPEN_METRE, Unit::NEWTON_METRE)] {
            let of = |row: &&Row| newtons(row, |newtons| newtons.moment).filter(|_| row.moment == moment);
            if rows.iter().any(|row| of(&row).is_some()) {
                table.decimal(("{quantity}_zero_to_peak_{unit}", "moment"), unit, of);
            }
        }
    }
    table.done()
}

fn of_engines(engines: &[Compared], document: &CompareDocument) -> Table {
    let rows: Vec<(&Compared, &EngineEntry)> = engines.iter().zip(&document.engines).collect();
    let mut table = Filling::new("compare.engines", &rows);
    table.person("engine", |(compared, _)| Some(compared.name.clone()));
    table.person("title", |(compared, _)| Some(compared.engine.title().clone()));
    table.whole("cylinders", |(_, entry)| entry.cylinders);
    table.truth("fires_evenly", |(_, entry)| entry.firing.as_ref().map(|firing| firing.even));
    let interval = |entry: &EngineEntry, best: fn(f64, f64) -> f64| {
        let Firing { intervals_deg, .. } = entry.firing.as_ref()?;
        intervals_deg.iter().copied().reduce(best)
    };
    table.decimal("longest_firing_interval_{unit}", Unit::DEGREE, |(_, entry)| interval(entry, f64::max));
    table.decimal("shortest_firing_interval_{unit}", Unit::DEGREE, |(_, entry)| interval(entry, f64::min));
    table.words("first_force_residual", |(_, entry)| Some(entry.first_force_left.clone()));
    table.words("first_moment_residual", |(_, entry)| Some(entry.first_moment_left.clone()));
    table.words("remedy", |(_, entry)| Some(entry.remedy.clone()));
    let has = |of: fn(&EngineEntry) -> bool| rows.iter().any(|(_, entry)| of(entry));
    if has(|entry| entry.worst_bearings.is_some()) {
        table.words("worst_bearings", |(_, entry)| entry.worst_bearings.as_ref().map(|worst| numbers(&worst.bearings)));
        for unit in [Unit::NEWTON, Unit::MULTIPLE] {
            if rows.iter().any(|(_, entry)| entry.worst_bearings.as_ref().is_some_and(|worst| worst.unit == unit.name))
            {
                table.decimal("worst_bearing_zero_to_peak_{unit}", unit, |(_, entry)| {
                    entry.worst_bearings.as_ref().filter(|worst| worst.unit == unit.name).map(|worst| worst.peak)
                });
            }
        }
    }
    if has(|entry| entry.worst_bearing_with_gas.is_some()) {
        table.words("worst_bearing_with_gas", |(_, entry)| {
            entry.worst_bearing_with_gas.as_ref().map(|worst| numbers(&worst.bearings))
        });
        table.decimal("worst_bearing_with_gas_zero_to_peak_{unit}", Unit::NEWTON, |(_, entry)| {
            entry.worst_bearing_with_gas.as_ref().map(|worst| worst.peak)
        });
    }
    table.done()
}

fn numbers(bearings: &[usize]) -> String {
    bearings.iter().map(usize::to_string).collect::<Vec<_>>().join(" ")
}
