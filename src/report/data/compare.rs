//! Which columns hold a comparison? A row an engine and order, and a row an engine.

use super::super::compare::document::{CompareDocument, EngineEntry, Firing, Newtons, Order};
use super::super::compare::{Compared, compare_document};
use super::filling::Filling;
use super::verdicts::{of_orders, units};
use crate::table::{Table, Unit};
use crate::text::Untrusted;

/// An order of an engine.
struct Row<'a> {
    name: &'a Untrusted,
    entry: &'a EngineEntry,
    order: &'a Order,
    moment: Unit,
}

/// The tables of a comparison: the orders of each engine, and the engines.
pub fn compare(engines: &[Compared]) -> Vec<Table> {
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
    let mut table = Filling::new("orders", "an order k of an engine as it is built", &rows);
    table.person("engine", ENGINE, |row| Some(row.name.clone()));
    of_orders(&mut table, |row| row.order, &moments, |row| row.moment);
    if document.engines.iter().any(|entry| entry.newtons.is_some()) {
        let newtons = |row: &Row, of: fn(&Newtons) -> f64| {
            row.entry.newtons.as_ref()?.iter().find(|newtons| newtons.order == row.order.order).map(of)
        };
        let about = "largest length in a revolution; empty where the layout lacks numbers";
        table.decimal(("{quantity}_zero_to_peak_{unit}", "force"), Unit::NEWTON, about, |row| {
            newtons(row, |newtons| newtons.force)
        });
        table.decimal(("{quantity}_zero_to_peak_{unit}", "moment"), Unit::NEWTON_METRE, about, |row| {
            newtons(row, |newtons| newtons.moment)
        });
    }
    table.done()
}

const ENGINE: &str = "what the engine is called in the comparison";

fn of_engines(engines: &[Compared], document: &CompareDocument) -> Table {
    let rows: Vec<(&Compared, &EngineEntry)> = engines.iter().zip(&document.engines).collect();
    let mut table = Filling::new("engines", "an engine", &rows);
    table.person("engine", ENGINE, |(compared, _)| Some(compared.name.clone()));
    table.person("title", "its title", |(compared, _)| Some(compared.engine.title().clone()));
    table.whole("cylinders", "how many cylinders it has", |(_, entry)| entry.cylinders);
    table.truth(
        "fires_evenly",
        "whether all firing intervals are equal; empty where the layout does not say",
        |(_, entry)| entry.firing.as_ref().map(|firing| firing.even),
    );
    let interval = |entry: &EngineEntry, best: fn(f64, f64) -> f64| {
        let Firing { intervals_deg, .. } = entry.firing.as_ref()?;
        intervals_deg.iter().copied().reduce(best)
    };
    table.decimal("longest_firing_interval_{unit}", Unit::DEGREE, "longest interval between firings", |(_, entry)| {
        interval(entry, f64::max)
    });
    table.decimal(
        "shortest_firing_interval_{unit}",
        Unit::DEGREE,
        "shortest interval between firings",
        |(_, entry)| interval(entry, f64::min),
    );
    let first = "the lowest order of all that is left, with its shape; none; or why it is not stated";
    table.words("first_force_left", first, |(_, entry)| Some(entry.first_force_left.clone()));
    table.words("first_moment_left", first, |(_, entry)| Some(entry.first_moment_left.clone()));
    table.words("remedy", "what takes away the orders compared", |(_, entry)| Some(entry.remedy.clone()));
    let has = |of: fn(&EngineEntry) -> bool| rows.iter().any(|(_, entry)| of(entry));
    if has(|entry| entry.worst_bearings.is_some()) {
        table.words("worst_bearings", "the main bearings with the largest load of the masses, from 1", |(_, entry)| {
            entry.worst_bearings.as_ref().map(|worst| numbers(&worst.bearings))
        });
        let about = "that load, zero to peak; empty where it is counted in the other unit, or not known";
        for unit in [Unit::NEWTON, Unit::MULTIPLE] {
            if rows.iter().any(|(_, entry)| entry.worst_bearings.as_ref().is_some_and(|worst| worst.unit == unit.name))
            {
                table.decimal("worst_bearing_zero_to_peak_{unit}", unit, about, |(_, entry)| {
                    entry.worst_bearings.as_ref().filter(|worst| worst.unit == unit.name).map(|worst| worst.peak)
                });
            }
        }
    }
    if has(|entry| entry.worst_bearing_with_gas.is_some()) {
        table.words("worst_bearing_with_gas", "the one with the largest load of gas and masses", |(_, entry)| {
            entry.worst_bearing_with_gas.as_ref().map(|worst| numbers(&worst.bearings))
        });
        table.decimal("worst_bearing_with_gas_zero_to_peak_{unit}", Unit::NEWTON, "that load", |(_, entry)| {
            entry.worst_bearing_with_gas.as_ref().map(|worst| worst.peak)
        });
    }
    table.done()
}

fn numbers(bearings: &[usize]) -> String {
    bearings.iter().map(usize::to_string).collect::<Vec<_>>().join(" ")
}
