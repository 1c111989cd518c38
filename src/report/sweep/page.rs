//! What does the page of a sweep hold? The exact zeros, the plots, the points, and what was assumed.

use serde::Serialize;

use super::super::dialect::Dialect;
use super::super::folder::File;
use super::super::{render, svg};
use super::plots::{Drawn, amplitudes, drawings};
use super::words::{exact, quantity_name, short, short_number, unit, value, zeros_name};
use crate::engine::DOES_NOT_EXIST;
use crate::proof::Quantity;
use crate::sweep::{Sweep, SweptEngine, ZeroSet, Zeros};

/// More points than this are left to the table in CSV.
const MOST_ROWS: usize = 200;

#[derive(Serialize)]
pub(super) struct SweepPage {
    title: String,
    swept: String,
    units: String,
    pub zeros: Vec<Vec<String>>,
    zeros_header: Vec<&'static str>,
    incomplete: bool,
    drawings: Vec<Drawing>,
    pub tables: Vec<Table>,
    left_out: Option<String>,
    assumptions: Vec<String>,
}

#[derive(Serialize)]
pub(super) struct Drawing {
    pub file: String,
    pub caption: String,
}

#[derive(Serialize)]
pub(super) struct Table {
    pub heading: String,
    pub header: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

/// The page `sweep.md` with its drawings.
pub fn sweep_page(sweep: &Sweep) -> Vec<File> {
    let drawn = drawings(sweep);
    let page = page(sweep, &drawn);
    let drawing = |drawn: Drawn| File { name: format!("{}.svg", drawn.name), text: svg(&drawn.figure, &drawn.caption) };
    let text = File { name: "sweep.md".into(), text: render::sweep(&page) };
    [text].into_iter().chain(drawn.into_iter().map(drawing)).collect()
}

fn page(sweep: &Sweep, drawn: &[Drawn]) -> SweepPage {
    let dialect = Dialect::GithubMarkdown;
    let ranges = sweep.parameters.iter().map(|parameter| {
        let range = &parameter.range;
        let show = |at: &_| value(parameter, at, sweep.zeros.is_some());
        format!(
            "`{}` from {} to {}, {} values",
            parameter.key,
            show(&range.value(0)),
            show(&range.last()),
            range.count()
        )
    });
    let drawings = drawn
        .iter()
        .map(|drawn| Drawing { file: format!("{}.svg", drawn.name), caption: dialect.literal(&drawn.caption) });
    let few = sweep.points.len() <= MOST_ROWS;
    let zeros = sweep.zeros.as_deref().unwrap_or_default();
    SweepPage {
        title: dialect.quoted(&sweep.title),
        swept: ranges.collect::<Vec<_>>().join("; "),
        units: format!("Forces in {}, moments in {}", unit(sweep, Quantity::Force), unit(sweep, Quantity::Moment)),
        zeros: zero_rows(zeros),
        zeros_header: ["Order", "Quantity"].into_iter().chain(Zeros::ALL.map(zeros_name)).collect(),
        incomplete: zeros.iter().any(|set| !set.complete),
        drawings: drawings.collect(),
        tables: if few { tables(sweep) } else { Vec::new() },
        left_out: (!few).then(|| format!("The {} points are in the table in CSV.", sweep.points.len())),
        assumptions: sweep.geometry.words(),
    }
}

/// A row for each order and quantity: where each vector vanishes.
pub(super) fn zero_rows(sets: &[ZeroSet]) -> Vec<Vec<String>> {
    let row = |of: &[ZeroSet]| {
        let first = &of[0];
        let cells = of.iter().map(zero_cell);
        [first.order.to_string(), quantity_name(first.quantity).to_owned()].into_iter().chain(cells).collect()
    };
    sets.chunk_by(|a, b| (a.order, a.quantity) == (b.order, b.quantity)).map(row).collect()
}

pub(super) fn zero_cell(set: &ZeroSet) -> String {
    let angles: Vec<String> = set.at.iter().map(|at| format!("{}°", exact(at).replace('-', "−"))).collect();
    if !set.exists {
        return DOES_NOT_EXIST.to_owned();
    }
    match (set.everywhere, set.complete, angles.is_empty()) {
        (true, ..) => "everywhere".into(),
        (_, true, true) => "never".into(),
        (_, true, false) => angles.join(", "),
        (_, false, true) => "not solved".into(),
        (_, false, false) => format!("{}, perhaps more", angles.join(", ")),
    }
}

/// The points: amplitudes that are not zero everywhere, then firing, counterweights and envelope.
pub(super) fn tables(sweep: &Sweep) -> Vec<Table> {
    let names = || sweep.parameters.iter().map(|parameter| super::words::axis(parameter, sweep.zeros.is_some()));
    let values = |point: &SweptEngine| {
        let pairs = sweep.parameters.iter().zip(&point.values);
        pairs.map(|(_, at)| exact(at).replace('-', "−")).collect::<Vec<_>>()
    };
    let mut tables = Vec::new();
    for quantity in [Quantity::Force, Quantity::Moment] {
        let kept: Vec<usize> = (0..sweep.orders.len())
            .filter(|&place| {
                sweep.points.iter().any(|point| amplitudes(point, place, quantity).is_some_and(|a| !a.largest.vanishes))
            })
            .collect();
        if kept.is_empty() {
            continue;
        }
        let columns = kept.iter().flat_map(|&place| {
            ["largest", "smallest", "along", "across"].map(|part| format!("{}: {part}", sweep.orders[place]))
        });
        let row = |point: &SweptEngine| {
            let cells = kept.iter().filter_map(|&place| amplitudes(point, place, quantity));
            let cells = cells.flat_map(|a| [a.largest, a.smallest, a.along, a.across].map(short));
            values(point).into_iter().chain(cells).collect()
        };
        let name = if quantity == Quantity::Force { "Force" } else { "Moment" };
        tables.push(Table {
            heading: format!("{name} by order, in {}", unit(sweep, quantity)),
            header: names().chain(columns).collect(),
            rows: sweep.points.iter().map(row).collect(),
        });
    }
    let columns = [
        "firing intervals, shortest to longest",
        "difference",
        "counterweight / m r",
        "length / r",
        "breadth / r",
        "height / r",
    ];
    let degrees = |turns: &num_rational::BigRational| {
        format!("{}°", exact(&(turns * num_rational::BigRational::from_integer(360.into()))))
    };
    let row = |point: &SweptEngine| {
        let dash = || "–".to_owned();
        let firing = point.evenness.as_ref();
        let envelope = point.envelope;
        let rest = [
            firing.map_or_else(dash, |e| format!("{} to {}", degrees(&e.shortest), degrees(&e.longest))),
            firing.map_or_else(dash, |e| degrees(&e.unevenness())),
            point.counterweight.map_or_else(dash, short),
            envelope.and_then(|envelope| envelope.length).map_or_else(dash, short_number),
            envelope.map_or_else(dash, |envelope| short_number(envelope.breadth)),
            envelope.map_or_else(dash, |envelope| short_number(envelope.height)),
        ];
        values(point).into_iter().chain(rest).collect()
    };
    tables.push(Table {
        heading: "Firing, counterweights, envelope".into(),
        header: names().chain(columns.map(str::to_owned)).collect(),
        rows: sweep.points.iter().map(row).collect(),
    });
    tables
}
