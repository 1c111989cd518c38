//! What accuracy costs: the errors alone of several engines at several rod ratios, the same on every machine. The page `reports/accuracy/README.md`.

use crankstar::accuracy::{BearingMethod, Method, Row, Study};
use crankstar::engine::Engine;
use crankstar::page::plot::{Axis, Curve, Plot, PointMark};
use crankstar::page::{Block, Document, Fold, Number, Picture, Table, Text};
use crankstar::proof::Quantity;
use crankstar::report::{self, AccuracyCase};

use super::phrase;

const NO_TIMES: &str = "Below the last place of doubles errors differ between machines; there only a bound is shown.";

/// The part of a peak that a designer may want to be sure of.
const USUAL: f64 = 1e-3;
/// Errors smaller than this are drawn as this.
const LEAST: f64 = 1e-18;

/// The page.
pub fn page(engines: &[(Engine, Vec<AccuracyCase>)]) -> Document {
    let mut page = Document::new("README", "What accuracy costs");
    let needed = engines.iter().flat_map(|(engine, cases)| {
        let loads = (0..cases[0].studies.len()).filter_map(|place| orders_needed(engine, cases, place));
        loads.chain(orders_of_bearings(engine, cases))
    });
    page.push(Block::Answer(needed.collect()));
    let mut methods = Vec::new();
    for (number, (engine, cases)) in engines.iter().enumerate() {
        page.push(Block::Heading(1, engine.title().into()));
        for place in 0..cases[0].studies.len() {
            let studies: Vec<(Text, &Study)> = cases.iter().map(|case| (label(case), &case.studies[place])).collect();
            if studies.iter().all(|(_, study)| !study.rows.is_empty()) {
                page.push(picture(number + 1, engine, &studies));
            }
        }
        // The section of a report: a heading, the errors of the loads, how the methods work, then the bearings.
        let mut section = report::accuracy_section(engine, cases).into_iter().skip(1);
        for block in section.by_ref() {
            match block {
                Block::List(words) => {
                    methods = words;
                    break;
                }
                block => page.push(block),
            }
        }
        page.blocks.extend(bearings(engine, cases));
    }
    page.push(Block::Heading(1, "How the methods work".into()));
    page.push(Block::List(methods.into_iter().chain([NO_TIMES.into()]).collect()));
    let command = Text::code("crankstar accuracy LAYOUT --rod-ratio 0.1,0.3");
    page.push(Block::Paragraph(phrase!("{} compares the methods for another engine, with their times.", command)));
    page
}

/// `λ = 0.3`.
fn label(case: &AccuracyCase) -> Text {
    phrase!("λ = {}", Number::exact(case.ratio.as_ref().expect("rods alike")))
}

/// Which orders are within a thousandth at each rod ratio.
fn needed(orders: impl Iterator<Item = (Text, Option<u32>)>) -> Text {
    let one = |(label, order): (Text, Option<u32>)| match order {
        Some(order) => phrase!("{} at {}", order, label),
        None => phrase!("more at {}", label),
    };
    Text::joined(orders.map(one), ", ")
}

fn orders_needed(engine: &Engine, cases: &[AccuracyCase], place: usize) -> Option<Text> {
    let enough = |row: &Row| match row.method {
        Method::Orders(order) => row.bound.filter(|bound| *bound <= USUAL).map(|_| order),
        _ => None,
    };
    let studies = cases.iter().map(|case| (label(case), &case.studies[place]));
    let studies = studies.filter(|(_, study)| !study.rows.is_empty());
    let needed = needed(studies.map(|(label, study)| (label, study.rows.iter().find_map(enough))));
    let words = match cases[0].studies[place].quantity {
        Quantity::FORCE => "{}: the peak force is within 0.1 %, guaranteed, with the orders up to {}.",
        Quantity::MOMENT => "{}: the peak moment is within 0.1 %, guaranteed, with the orders up to {}.",
        Quantity::Axial(_) => "{}: the peak inertia torque is within 0.1 %, guaranteed, with the orders up to {}.",
    };
    (!needed.is_empty()).then(|| phrase!(words, engine.title(), needed))
}

fn orders_of_bearings(engine: &Engine, cases: &[AccuracyCase]) -> Option<Text> {
    let orders = cases.iter().filter_map(|case| {
        let enough = case.bearings.as_ref()?.iter().find_map(|row| match row.method {
            BearingMethod::Orders(order) => row.bound.filter(|bound| *bound <= USUAL).map(|_| order),
            _ => None,
        });
        Some((label(case), enough))
    });
    let words = "{}: the largest bearing load of inertia is within 0.1 %, guaranteed, with the orders up to {}.";
    let needed = needed(orders);
    (!needed.is_empty()).then(|| phrase!(words, engine.title(), needed))
}

/// The errors of the largest bearing load at each rod ratio: measured ones, and folded what is guaranteed.
fn bearings(engine: &Engine, cases: &[AccuracyCase]) -> Vec<Block> {
    // The table of each case: method, peak, error, what is guaranteed; then what it means.
    let of_case = |case: &AccuracyCase| {
        case.bearings.as_ref()?;
        let section = report::accuracy_section(engine, std::slice::from_ref(case)).into_iter();
        let mut behind = section.skip_while(|block| !matches!(block, Block::List(_)));
        let table = behind.find_map(|block| if let Block::Table(table) = block { Some(table) } else { None })?;
        Some((label(case), table, behind.next()?))
    };
    let found: Vec<(Text, Table, Block)> = cases.iter().filter_map(of_case).collect();
    let Some((_, first, note)) = found.first() else { return Vec::new() };
    let by_ratio = |column: usize| {
        let columns = found.iter().map(|(label, ..)| label.clone());
        let mut table = Table::new([Text::from("Method")].into_iter().chain(columns));
        for (place, row) in first.rows.iter().enumerate().filter(|(_, row)| !row[column].is_empty()) {
            let cells = found.iter().map(|(_, table, _)| table.rows[place][column].clone());
            table.push([row[0].clone()].into_iter().chain(cells).collect());
        }
        Block::from(table)
    };
    vec![
        Block::Paragraph("Measured error of the largest bearing load of inertia:".into()),
        by_ratio(2),
        Block::Folded(Fold {
            summary: "Guaranteed bound of the error of the largest bearing load of inertia".into(),
            blocks: vec![by_ratio(3)],
        }),
        note.clone(),
    ]
}

/// Guaranteed bound over the highest order kept, a curve per rod ratio; what was measured as dots upon it.
fn picture(number: usize, engine: &Engine, studies: &[(Text, &Study)]) -> Picture {
    let (words, name) = match studies[0].1.quantity {
        Quantity::FORCE => ("{}: what the orders leave of the peak force", "force"),
        Quantity::MOMENT => ("{}: what the orders leave of the peak moment", "moment"),
        Quantity::Axial(_) => ("{}: what the orders leave of the peak inertia torque", "inertia-torque"),
    };
    let title = phrase!(words, engine.title());
    let x = Axis::linear("Highest order kept");
    let x =
        Axis { ticks: Some([0, 4, 8, 12, 16, 20, 24, 28, 32].map(f64::from).to_vec()), range: Some((0.0, 33.0)), ..x };
    let mut plot = Plot::new(title.plain(), x, Axis::log("Part of the peak").within(1e-16, 10.0));
    for (place, (label, study)) in studies.iter().enumerate() {
        let orders = study.rows.iter().filter_map(|row| match row.method {
            Method::Orders(order) => Some((f64::from(order), row)),
            _ => None,
        });
        let orders: Vec<(f64, &Row)> = orders.collect();
        let bounds = orders.iter().filter_map(|(order, row)| Some((*order, two_digits(row.bound?).max(LEAST))));
        let curve = Curve::new(place, format!("bound, {}", label.plain()), bounds.collect());
        let ink = curve.ink;
        plot.curves.push(curve);
        for (order, row) in orders.iter().filter(|(_, row)| row.error >= study.rounding) {
            let mark = PointMark { ink, ..PointMark::dot((*order, two_digits(row.error)), "") };
            plot.marks.push(if place == 0 { mark.of("measured") } else { mark });
        }
    }
    let caption =
        phrase!("{}, over the highest order kept: curves are guaranteed bounds, dots measured errors.", title);
    Picture { name: format!("engine-{number}-{name}"), caption, figure: plot.figure() }
}

/// What the tables show of an error, so that a drawing does not tell machines apart either.
fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
