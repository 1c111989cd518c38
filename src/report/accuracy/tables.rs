//! Which tables compare the methods? All of one load with their times, or the errors alone over several rod ratios.

use std::collections::BTreeSet;

use super::methods;
use super::{AccuracyCase, words};
use crate::accuracy::{Method, Row, Study};
use crate::engine::Engine;
use crate::page::{Block, Fold, Table, Text, phrase};
use crate::report::texts::accuracy as text;

/// A row a method: what it finds in newtons or multiples, its errors, its cost, and whether it is on the Pareto front.
pub(super) fn methods(engine: &Engine, study: &Study) -> Table {
    let (unit, factor) = methods::unit(engine, study.quantity);
    let front = methods::front(study);
    Table::of(study.rows.iter().enumerate())
        .column("Method", |(_, row)| methods::name_and_spans(row))
        .column(phrase!("Peak in {}", unit), |(_, row)| methods::to_nine_digits(row.value * factor, unit))
        .column("Error", |(_, row)| methods::measured(study, row))
        .column("Guaranteed", |(_, row)| row.bound.map_or_else(Text::default, |bound| methods::power(bound).into()))
        .column("Time", |(_, row)| row.time.map_or_else(Text::default, |time| methods::time(time).into()))
        .column("Unbeaten", |(place, _)| if front.contains(place) { "yes".into() } else { Text::default() })
        .done()
}

/// The errors of the methods for the loads of an engine at some rod ratios: measured ones, and folded what is guaranteed.
pub(super) fn errors(cases: &[AccuracyCase]) -> Vec<Block> {
    let mut blocks = Vec::new();
    let loads = cases.iter().map(|case| case.studies.len()).min().unwrap_or(0);
    for place in 0..loads {
        let studies: Vec<&Study> = cases.iter().map(|case| &case.studies[place]).collect();
        let Some(first) = studies.first() else { continue };
        if let Some(nothing) = studies.iter().find_map(|study| words::vanishing(study)) {
            blocks.push(Block::Paragraph(nothing));
            continue;
        }
        let measures = |row: &Row| row.method != Method::Fractions;
        let guarantees = |row: &Row| row.bound.is_some();
        blocks.push(text::measured_error(first.quantity).into());
        blocks.push(by_ratio(cases, &studies, &measures, &methods::measured).into());
        blocks.push(Block::Folded(Fold {
            summary: text::guaranteed_error(first.quantity),
            blocks: vec![by_ratio(cases, &studies, &guarantees, &|_, row| methods::guaranteed(row)).into()],
        }));
    }
    blocks
}

/// A row a method, a column a rod ratio.
fn by_ratio(
    cases: &[AccuracyCase],
    studies: &[&Study],
    kept: &dyn Fn(&Row) -> bool,
    cell: &dyn Fn(&Study, &Row) -> Text,
) -> Table {
    // All methods that one of the studies has, by kind.
    let rows = studies.iter().flat_map(|study| &study.rows).filter(|row| kept(row));
    let all: BTreeSet<Method> = rows.map(|row| row.method).collect();
    let mut table = Table::of(all).column("Method", |method| methods::name(*method));
    for (case, study) in cases.iter().zip(studies) {
        table = table.column(case.label(), |method| {
            let row = study.rows.iter().find(|row| row.method == *method);
            row.map_or_else(|| "omitted".into(), |row| cell(study, row))
        });
    }
    table.done()
}
