//! What stands on a page about accuracy? Per load a table of methods and a plot of error against time, or errors alone.

use num_traits::{ToPrimitive, Zero};
use serde::Serialize;

use super::accuracy_words::{self, AccuracyCase, HEADER};
use super::dialect::Dialect;
use super::figure::Ink;
use super::folder::File;
use super::old::Table;
use super::plot::{Axis, Curve, Plot, PointMark};
use super::{render, svg};
use crate::accuracy::{Method, Row, Study};
use crate::engine::Engine;
use crate::text::Format;

/// Errors smaller than this stand at the lower edge of a plot.
const LEAST: f64 = 1e-18;

/// What the methods are and what the columns mean, for a report that shows no times.
const EXPLAINED: &str = "Each method looks for the same peak. Orders are summed in doubles; what the higher orders can add is bounded \
by their exact sums and, above order 60, by the sum of all coefficients; roundings are left out of that bound. The closed form is the acceleration of each piston without any series, at equal \
steps of the crank angle. Intervals enclose load and slope over spans of the crank angle and cut the highest span in two; they are stopped at 4000 spans. \
Intervals of fractions carry some fifty digits, fewer where the load is nearly constant; narrowed by whatever else is guaranteed, they are the reference of the others, and an error that is smaller than its own is said to be below it; the searches in intervals miss their aim there, and their bound says by how much. Errors are parts of the peak.";

/// A part of a report: the errors of all methods, by load and rod ratio; no times, so that it is the same on every machine.
#[derive(Clone, Debug, Serialize)]
pub struct AccuracySection {
    /// What the methods are.
    pub introduction: String,
    /// Two tables a load: what was measured, and what is guaranteed.
    pub tables: Vec<AccuracyTable>,
    /// Loads that vanish, in words.
    pub vanishing: Vec<String>,
}

/// A table with its caption, in finished strings of the dialect.
#[derive(Clone, Debug, Serialize)]
pub struct AccuracyTable {
    /// What it shows.
    pub caption: String,
    /// Methods × rod ratios.
    pub table: Table,
}

/// The section on the errors of the methods for the loads of an engine at some rod ratios.
pub fn accuracy_section(dialect: Dialect, cases: &[AccuracyCase]) -> AccuracySection {
    let (mut tables, mut vanishing) = (Vec::new(), Vec::new());
    let count = cases.iter().map(|case| case.studies.len()).min().unwrap_or(0);
    for place in 0..count {
        let studies: Vec<&Study> = cases.iter().map(|case| &case.studies[place]).collect();
        let name = accuracy_words::quantity(studies[0].quantity);
        if let Some(study) = studies.iter().find(|study| study.rows.is_empty()) {
            vanishing.push(dialect.prose(&vanishing_words(study)));
            continue;
        }
        let guarantees = |row: &Row| row.bound.is_some();
        let measures = |row: &Row| row.method != Method::Fractions;
        let columns: Vec<String> = cases.iter().map(AccuracyCase::label).collect();
        let mut add = |caption: String, kept: &dyn Fn(&Row) -> bool, cell: &dyn Fn(&Study, &Row) -> String| {
            let header: Vec<&str> = ["Method"].into_iter().chain(columns.iter().map(String::as_str)).collect();
            let kept = studies[0].rows.iter().enumerate().filter(|(_, row)| kept(row));
            let rows = kept.map(|(index, row)| {
                let cells =
                    studies.iter().map(|study| study.rows.get(index).map_or_else(String::new, |row| cell(study, row)));
                [accuracy_words::method(row.method)].into_iter().chain(cells).collect()
            });
            let table = Table::new(dialect, &header, rows.collect());
            tables.push(AccuracyTable { caption: dialect.prose(&caption), table });
        };
        add(format!("Measured error of the peak {name}"), &measures, &accuracy_words::measured);
        add(
            format!("Guaranteed bound of that error, roundings of the orders' sums apart ({name})"),
            &guarantees,
            &|_, row| guaranteed(row),
        );
    }
    AccuracySection { introduction: dialect.prose(EXPLAINED), tables, vanishing }
}

/// A bound in two digits; one of the fractions only as a power of ten, for their last digits follow the start of a search.
fn guaranteed(row: &Row) -> String {
    match (row.method, row.bound) {
        (_, None) => String::new(),
        (Method::Fractions, Some(bound)) if bound > 0.0 => {
            format!("below {}", accuracy_words::power_of_ten(bound.log10().ceil() as i64))
        }
        (_, Some(bound)) => accuracy_words::power(bound),
    }
}

fn vanishing_words(study: &Study) -> String {
    if study.peak.high.is_zero() {
        let name = accuracy_words::quantity(study.quantity);
        return format!("The {name} vanishes at every order, proved: there is no peak to compare.");
    }
    let bound = study.peak.high.to_f64().unwrap_or(f64::INFINITY);
    format!(
        "The {} vanishes at every order looked at, and the others add less than {} {}: there is no peak to compare.",
        accuracy_words::quantity(study.quantity),
        accuracy_words::power(bound),
        multiple(study)
    )
}

/// A line above the table of a load: which, its sure digits, or that it vanishes.
pub fn accuracy_heading(case: &AccuracyCase, study: &Study) -> String {
    let words = if study.rows.is_empty() { Some(vanishing_words(study)) } else { sure_words(study) };
    let words = words.map_or_else(String::new, |words| format!(". {words}"));
    format!("Peak {}, {}{words}", accuracy_words::quantity(study.quantity), case.label())
}

fn sure_words(study: &Study) -> Option<String> {
    let digits = accuracy_words::sure_digits(study)?;
    Some(format!("Sure digits in multiples of {}: {digits}…", multiple(study)))
}

#[derive(Serialize)]
struct Page {
    title: String,
    introduction: String,
    sections: Vec<PageSection>,
}

#[derive(Serialize)]
struct PageSection {
    heading: String,
    words: Vec<String>,
    figures: Vec<PageFigure>,
    tables: Vec<AccuracyTable>,
}

#[derive(Serialize)]
struct PageFigure {
    file: String,
    caption: String,
}

/// The page of one engine with errors and times, and a plot a load and rod ratio; made for this machine at this hour.
pub fn accuracy_page(engine: &Engine, cases: &[AccuracyCase]) -> Vec<File> {
    let dialect = Dialect::GithubMarkdown;
    let (mut sections, mut drawings) = (Vec::new(), Vec::new());
    for (number, case) in cases.iter().enumerate() {
        for study in &case.studies {
            let name = accuracy_words::quantity(study.quantity);
            let heading = format!("Peak {name}, {}", case.label());
            if study.rows.is_empty() {
                let words = vec![vanishing_words(study)];
                sections.push(PageSection { heading, words, figures: Vec::new(), tables: Vec::new() });
                continue;
            }
            let file = format!("{}-{}.svg", name.replace(' ', "-"), number + 1);
            let plot = cost_plot(&heading, study);
            drawings.push(File { name: file.clone(), text: svg(&plot.figure(), &heading) });
            let rows = accuracy_words::accuracy_rows(engine, study).into_iter().map(Vec::from).collect();
            let caption = "Error and guaranteed bound as parts of the peak; ● marks the Pareto front: no method is both faster and more accurate";
            let table = AccuracyTable { caption: caption.into(), table: Table::new(dialect, &HEADER, rows) };
            let figures = vec![PageFigure { file, caption: heading.clone() }];
            sections.push(PageSection {
                heading,
                words: sure_words(study).into_iter().collect(),
                figures,
                tables: vec![table],
            });
        }
    }
    let introduction = format!(
        "{EXPLAINED} A time is the median of seven evaluations of the peak on the machine that wrote this page, with all numbers of the engine at hand."
    );
    let page = Page {
        title: format!("What accuracy costs: {}", dialect.quoted(engine.title())),
        introduction: dialect.prose(&introduction),
        sections,
    };
    let mut files = vec![File { name: "accuracy.md".into(), text: render::accuracy(&page) }];
    files.extend(drawings);
    files
}

fn multiple(study: &Study) -> &'static str {
    match study.quantity {
        crate::proof::Quantity::Force => "m r ω²",
        crate::proof::Quantity::Moment => "m r ω² times the unit of the positions",
        crate::proof::Quantity::Torque => "m r² ω²",
    }
}

/// Error against time on logarithmic axes, the Pareto front as stairs.
fn cost_plot(title: &str, study: &Study) -> Plot {
    let x = Axis::log("Time of one evaluation in s");
    let mut plot = Plot::new(title, x, Axis::log("Error or guaranteed bound, part of the peak"));
    let at = |row: &Row| {
        let time = row.time.map_or(f64::NAN, |time| time.as_secs_f64());
        (time, accuracy_words::shown_error(study, row).max(LEAST))
    };
    let front: Vec<(f64, f64)> = accuracy_words::front(study).into_iter().map(|place| at(&study.rows[place])).collect();
    plot.curves.push(Curve { ink: Ink::Grey, ..Curve::new(0, "Pareto front", front).stepped() });
    for row in &study.rows {
        let (label, series, ink, filled) = match row.method {
            Method::Orders(order) => (order.to_string(), "orders up to", Ink::Blue, true),
            Method::Doubles(steps) => (steps.to_string(), "angles, 64 bits", Ink::Orange, true),
            Method::Singles(steps) => (steps.to_string(), "angles, 32 bits", Ink::Orange, false),
            Method::Intervals(digits) => {
                (accuracy_words::power_of_ten(-i64::from(digits)), "intervals to", Ink::Green, true)
            }
            Method::Fractions => (guaranteed(row), "fractions", Ink::Red, true),
        };
        plot.marks.push(PointMark { ink, filled, ..PointMark::dot(at(row), label).of(series) });
    }
    plot
}

/// The page of errors alone, of several engines at several rod ratios: the same on every machine.
pub fn accuracy_errors_page(engines: &[(Engine, Vec<AccuracyCase>)]) -> Vec<File> {
    let dialect = Dialect::GithubMarkdown;
    let (mut sections, mut drawings) = (Vec::new(), Vec::new());
    for (number, (engine, cases)) in engines.iter().enumerate() {
        let AccuracySection { tables, vanishing, .. } = accuracy_section(dialect, cases);
        let mut figures = Vec::new();
        let count = cases.iter().map(|case| case.studies.len()).min().unwrap_or(0);
        for place in 0..count {
            let studies: Vec<(String, &Study)> =
                cases.iter().map(|case| (case.label(), &case.studies[place])).collect();
            if studies.iter().any(|(_, study)| study.rows.is_empty()) {
                continue;
            }
            let name = accuracy_words::quantity(studies[0].1.quantity);
            let file = format!("engine-{}-{}.svg", number + 1, name.replace(' ', "-"));
            let title = engine.title().escaped(Format::Plain);
            let caption = format!("{title}: what the orders leave of the peak {name}");
            drawings.push(File { name: file.clone(), text: svg(&orders_plot(&caption, &studies).figure(), &caption) });
            figures.push(PageFigure { file, caption });
        }
        let heading = dialect.quoted(engine.title());
        sections.push(PageSection { heading, words: vanishing, figures, tables });
    }
    let introduction = format!(
        "{EXPLAINED} Below the last place of doubles errors differ between machines; there only a bound is shown. `crankstar accuracy LAYOUT --rod-ratio 0.1,0.3` adds the times."
    );
    let page = Page { title: "What accuracy costs".into(), introduction: dialect.prose(&introduction), sections };
    let mut files = vec![File { name: "README.md".into(), text: render::accuracy(&page) }];
    files.extend(drawings);
    files
}

/// Guaranteed bound over the highest order kept, a curve a rod ratio; what was measured as dots upon it.
fn orders_plot(title: &str, studies: &[(String, &Study)]) -> Plot {
    let x = Axis::linear("Highest order kept");
    let x =
        Axis { ticks: Some([0, 4, 8, 12, 16, 20, 24, 28, 32].map(f64::from).to_vec()), range: Some((0.0, 33.0)), ..x };
    let mut plot = Plot::new(title, x, Axis::log("Part of the peak").within(1e-16, 10.0));
    for (number, (label, study)) in studies.iter().enumerate() {
        let orders = study.rows.iter().filter_map(|row| match row.method {
            Method::Orders(order) => Some((f64::from(order), row)),
            _ => None,
        });
        let orders: Vec<(f64, &Row)> = orders.collect();
        let bounds = orders.iter().filter_map(|(order, row)| Some((*order, two_digits(row.bound?).max(LEAST))));
        let curve = Curve::new(number, format!("bound, {label}"), bounds.collect());
        let ink = curve.ink;
        plot.curves.push(curve);
        for (order, row) in orders.iter().filter(|(_, row)| row.error >= study.rounding) {
            let mark = PointMark { ink, ..PointMark::dot((*order, two_digits(row.error)), "") };
            plot.marks.push(if number == 0 { mark.of("measured") } else { mark });
        }
    }
    plot
}

/// What the tables show of an error, so that a drawing does not tell machines apart either.
fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
