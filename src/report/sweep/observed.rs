//! What becomes of values of other questions along a sweep? From where to where each runs, and a table of all points.

use super::amounts::{place, place_cells, place_headings};
use super::findings::listed;
use crate::page::{Table, Text};
use crate::report::texts::sweep as text;
use crate::report::values::{cell, heading, with_unit};
use crate::sweep::{Observed, ObservedSweep, Sweep, SweptEngine};
use crate::table::{Single, Value};

/// A point with the value there.
type At<'a> = (&'a SweptEngine, &'a Single);

/// A sentence of each value, and one of the points that lack it.
pub(super) fn sentences(sweep: &Sweep) -> Vec<Text> {
    let values = |observed: &ObservedSweep| -> Vec<Text> {
        let names = observed.names.iter().enumerate();
        names.flat_map(|(index, name)| of_value(sweep, &observed.points, name, index)).collect()
    };
    sweep.observed.as_ref().map(values).unwrap_or_default()
}

fn of_value(sweep: &Sweep, values: &[Observed], name: &str, index: usize) -> Vec<Text> {
    let name = || Text::code(name);
    let points = sweep.points.iter().zip(values);
    let known = points.filter_map(|(point, values)| Some((point, values.get(index)?.as_ref().ok()?)));
    // A closed form, say, may be absent where the rest of its row is not.
    let all: Vec<At> = known.filter(|(_, value)| value.value().is_some()).collect();
    if all.is_empty() {
        return vec![text::never_given(name())];
    }
    let missing = sweep.points.len() - all.len();
    let lacking = (missing > 0).then(|| text::lacking(name(), missing, sweep.points.len()));
    let told = all.first().map(|(_, first)| {
        if missing == 0 && all.iter().all(|(_, other)| other.value() == first.value()) {
            return text::everywhere(name(), with_unit(first));
        }
        match extremes(&all) {
            Some([(least, low), (greatest, high)]) => {
                let at = |points: Vec<&SweptEngine>| listed(points.into_iter().map(|at| place(sweep, at)).collect());
                let [least, greatest] = [least, greatest].map(with_unit);
                text::from_to(name(), least, at(low), greatest, at(high))
            }
            None => {
                let mut different: Vec<&Single> = Vec::new();
                for (_, value) in &all {
                    if !different.iter().any(|known| known.value() == value.value()) {
                        different.push(value);
                    }
                }
                text::different_values(name(), listed(different.into_iter().map(with_unit).collect()))
            }
        }
    });
    told.into_iter().chain(lacking).collect()
}

/// The least and the greatest of numbers, with the points where they are; none of words.
fn extremes<'a>(all: &[At<'a>]) -> Option<[(&'a Single, Vec<&'a SweptEngine>); 2]> {
    let numbers: Vec<(f64, At)> = all.iter().filter_map(|at| Some((number(at.1)?, *at))).collect();
    let reached = |extreme: f64| {
        let mut at = numbers.iter().filter(move |(number, _)| *number == extreme).map(|(_, at)| *at);
        let (first, value) = at.next()?;
        Some((value, [first].into_iter().chain(at.map(|(point, _)| point)).collect()))
    };
    let least = numbers.iter().map(|(number, _)| *number).reduce(f64::min)?;
    let greatest = numbers.iter().map(|(number, _)| *number).reduce(f64::max)?;
    Some([reached(least)?, reached(greatest)?])
}

fn number(value: &Single) -> Option<f64> {
    match value.value()? {
        Value::Decimal(decimal) => Some(decimal),
        Value::Integer(whole) => Some(whole as f64),
        Value::Words(_) | Value::Person(_) | Value::Exact(_) | Value::Truth(_) => None,
    }
}

/// The values at every point; none where none are asked for.
pub(super) fn table(sweep: &Sweep) -> Option<Table> {
    let observed = sweep.observed.as_ref()?;
    let names = observed.names.iter().zip(&observed.first).map(|(name, first)| heading(name, first.unit));
    let mut table = Table::new(place_headings(sweep).chain(names));
    for (point, values) in sweep.points.iter().zip(&observed.points) {
        table.push(
            place_cells(point)
                .chain(values.iter().zip(&observed.first).map(|(value, like)| cell(value, Some(like))))
                .collect(),
        );
    }
    Some(table)
}
