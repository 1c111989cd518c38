//! What does the page of a study hold? Its statements with what was found, its families in curves and tables.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::Zero;
use serde::Serialize;

use super::super::calculation::plain;
use super::super::claims::{claim_finding, claim_status};
use super::super::dialect::Dialect;
use super::super::folder::File;
use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::super::{render, svg};
use super::csv::sweep_csv;
use super::page::{Drawing, Table, tables, zero_rows};
use super::plots::{Amplitude, amplitudes};
use super::words::{axis, exact, float, quantity_name, short_number, zeros_name};
use crate::claim::{Checked, Found, Provenance, Quote, Studied, Study};
use crate::loads::Arm;
use crate::proof::Quantity;
use crate::sweep::{Envelope, Sweep, SweptEngine, ZeroSet, Zeros};
use crate::text::{Format, Untrusted};

#[derive(Serialize)]
struct StudyPage {
    title: String,
    source: String,
    summary: String,
    statements: Vec<Statement>,
    zeros_header: Vec<&'static str>,
    families: Vec<Family>,
    assumptions: Vec<String>,
}

#[derive(Serialize)]
struct Statement {
    text: String,
    conclusion: String,
    /// What the paper says, with the place.
    claimed: Vec<[String; 5]>,
    /// What is reckoned beside it.
    own: Vec<[String; 4]>,
}

#[derive(Serialize)]
struct Family {
    heading: String,
    in_line: Option<String>,
    csv: String,
    zeros: Vec<Vec<String>>,
    drawings: Vec<Drawing>,
    tables: Vec<Table>,
}

/// The page of a study, `README.md`, with a table in CSV and drawings for each family.
pub fn study_page(study: &Study) -> Vec<File> {
    let dialect = Dialect::GithubMarkdown;
    let mut files = Vec::new();
    let families = study.families.iter().map(|family| {
        // The engine in line is the first row.
        let whole = with_in_line(family);
        let csv = format!("{}.csv", family.name);
        files.push(File { name: csv.clone(), text: sweep_csv(&whole).text });
        let kinds = [("forces", Quantity::Force), ("moments", Quantity::Moment)];
        let mut plots: Vec<(&str, Plot)> = kinds.map(|(name, quantity)| (name, unbalanced(family, quantity))).into();
        plots.retain(|(_, plot)| !plot.curves.is_empty());
        if family.in_line.is_some() {
            plots.push(("size", size(family, &whole)));
            plots.push(("mass", mass(family, &whole)));
        }
        let drawings = plots.into_iter().map(|(kind, plot)| {
            let file = format!("{}-{kind}.svg", family.name);
            files.push(File { name: file.clone(), text: svg(&plot.figure(), &plot.title) });
            Drawing { file, caption: dialect.literal(&plot.title) }
        });
        Family {
            heading: dialect.quoted(&family.sweep.title),
            in_line: family.in_line.as_ref().map(|(title, _)| dialect.quoted(title)),
            csv,
            drawings: drawings.collect(),
            zeros: zero_rows(family.sweep.zeros.as_deref().unwrap_or_default()),
            tables: tables(&whole),
        }
    });
    let families = families.collect();
    let checks = || study.statements.iter().flat_map(|said| &said.checks);
    let count = |claimed: bool, holds: bool| {
        checks().filter(|check| check.provenance.is_claimed() == claimed && check.holds == holds).count()
    };
    let summary = format!(
        "{} checks of what it says: {} hold, {} do not. Reckoned here, and not said there: {}, of which {} hold.",
        count(true, true) + count(true, false),
        count(true, true),
        count(true, false),
        count(false, true) + count(false, false),
        count(false, true)
    );
    let page = StudyPage {
        title: dialect.quoted(&study.title),
        source: dialect.quoted(&study.source),
        summary,
        statements: study
            .statements
            .iter()
            .map(|said| Statement {
                text: dialect.quoted(&said.text),
                conclusion: dialect.quoted(&said.conclusion),
                claimed: said.checks.iter().filter_map(|check| claimed(check, &study.source, dialect)).collect(),
                own: said
                    .checks
                    .iter()
                    .filter(|check| !check.provenance.is_claimed())
                    .map(|check| row(check, dialect))
                    .collect(),
            })
            .collect(),
        zeros_header: ["Order", "Quantity"].into_iter().chain(Zeros::ALL.map(zeros_name)).collect(),
        families,
        assumptions: crate::sweep::Geometry::default().words(),
    };
    files.insert(0, File { name: "README.md".into(), text: render::study(&page) });
    files
}

/// Where a claim is said, with its source where that is not the one that stands above; nothing of the file's own.
fn said(provenance: &Provenance, above: Option<&Untrusted>, dialect: Dialect) -> Option<String> {
    match provenance {
        Provenance::Quoted(Quote { source, place, words }) => {
            let [shown, place, words] = [source, place, words].map(|text| dialect.quoted(text));
            let source = if above == Some(source) { String::new() } else { format!("{shown}, ") };
            Some(format!("{source}{place}: “{words}”"))
        }
        Provenance::Folklore => Some("folklore: no source found".to_owned()),
        Provenance::Own => None,
    }
}

/// A row of what the paper says.
fn claimed(check: &Checked, above: &Untrusted, dialect: Dialect) -> Option<[String; 5]> {
    let said = said(&check.provenance, Some(above), dialect)?;
    let [engine, claim, answer, found] = row(check, dialect);
    Some([engine, said, claim, answer, found])
}

fn row(check: &Checked, dialect: Dialect) -> [String; 4] {
    let answer = match &check.found {
        Found::Claim(pair) => plain(claim_status(&pair.1)),
        _ if check.holds => "true".to_owned(),
        _ => "false".to_owned(),
    };
    let degrees =
        |values: &[BigRational]| values.iter().map(|at| format!("{}°", exact(at))).collect::<Vec<_>>().join(", ");
    let found = match &check.found {
        Found::Claim(pair) => plain(claim_finding(&pair.0, &pair.1)),
        Found::Values { everywhere: true, .. } => "At every angle.".to_owned(),
        Found::Values { at, complete, .. } => {
            let all = if *complete { ", and proved: nowhere else in the range" } else { ", and perhaps elsewhere" };
            let at = if at.is_empty() { "At no angle".to_owned() } else { format!("At {}", degrees(at)) };
            format!("{at}{all}.")
        }
        Found::Firing { difference, at } => {
            let place = if at.is_empty() { "Nowhere on the grid".to_owned() } else { format!("At {}", degrees(at)) };
            match difference {
                Some(turns) => {
                    let difference = exact(&(turns * BigRational::from_integer(360.into())));
                    format!("{place}: the longest and the shortest interval differ by {difference}°.")
                }
                None => format!("{place}."),
            }
        }
        Found::Counterweight(Some(form)) => format!("m_cw ρ b = {form} m r a, in closed form."),
        Found::Volume(part) => {
            format!("The largest is {} times that in line, in the geometry below.", short_number(*part))
        }
        Found::Counterweight(None) => "No closed form.".to_owned(),
    };
    [dialect.quoted(&check.engine), dialect.quoted(&check.claim), answer, found]
}

/// The sweep with the engine in line for the value 0.
fn with_in_line(family: &Studied) -> Sweep {
    let mut whole = family.sweep.clone();
    if let Some((_, point)) = &family.in_line {
        whole.points.insert(0, SweptEngine { values: vec![BigRational::zero()], ..point.clone() });
    }
    whole
}

/// Vertical and horizontal amplitudes of orders 1 and 2, and that of the rotating masses; what is zero is left out.
fn unbalanced(family: &Studied, quantity: Quantity) -> Plot {
    let sweep = &family.sweep;
    let mut plot = plot(sweep, &format!("unbalanced {}s", quantity_name(quantity)));
    let arm = match (quantity, sweep.arm) {
        (Quantity::Moment, Arm::Spacing) => " a",
        (Quantity::Moment, Arm::Metre) => " · m",
        _ => "",
    };
    plot.y = Axis::linear(format!("Amplitude in m r ω²{arm}, of order 2 times c₂"));
    let mut add = |name: String, of: &Sweep, place: usize, part: Amplitude| {
        let point =
            |point: &SweptEngine| Some((float(point.values.first()?), part(amplitudes(point, place, quantity)?)));
        let points: Vec<(f64, f64)> = of.curve.iter().filter_map(point).collect();
        if points.iter().any(|(_, value)| *value != 0.0) {
            plot.curves.push(Curve::new(plot.curves.len(), name, points));
        }
    };
    let turning = family.rotating.as_ref();
    if let Some((rotating, place)) = turning.and_then(|of| Some((of, of.orders.iter().position(|&order| order == 1)?)))
    {
        add("rotating masses".into(), rotating, place, |a| a.largest.value);
    }
    for (place, &order) in sweep.orders.iter().enumerate().filter(|(_, order)| **order < 3) {
        add(format!("order {order} vertical"), sweep, place, |a| a.along.value);
        add(format!("order {order} horizontal"), sweep, place, |a| a.across.value);
    }
    let shown =
        |set: &&ZeroSet| set.quantity == quantity && set.order < 3 && matches!(set.of, Zeros::Along | Zeros::Across);
    let at: BTreeSet<&BigRational> = sweep.zeros.iter().flatten().filter(shown).flat_map(|set| &set.at).collect();
    plot.marks = at
        .into_iter()
        .map(|at| PointMark::ring((float(at), 0.0), format!("{}°", exact(at))).of("exact zero of a part"))
        .collect();
    plot
}

fn plot(sweep: &Sweep, what: &str) -> Plot {
    let parameter = &sweep.parameters[0];
    let last = float(&parameter.range.last());
    let x = Axis::angle(axis(parameter, true), 0.0, last, 30);
    Plot::new(format!("{}: {what}", sweep.title.escaped(Format::Plain)), x, Axis::linear(""))
}

/// Values over the grid: those of the family as a curve, that of the engine in line as a dot.
fn add(plot: &mut Plot, name: &str, dot: &str, values: impl Iterator<Item = Option<(f64, f64)>>) {
    let mut points = values.flatten();
    let in_line = points.next();
    plot.curves.push(Curve::new(plot.curves.len(), name, points.collect()));
    plot.marks.extend(in_line.map(|at| PointMark::dot(at, dot).of("in line")));
}

/// One side of an envelope.
type Side = fn(&Envelope) -> Option<f64>;

/// Length, breadth and height against the length of the engine in line.
fn size(family: &Studied, whole: &Sweep) -> Plot {
    let mut plot = plot(&family.sweep, "size of the envelope");
    plot.y = Axis::linear("against the length of the engine in line");
    let Some(unit) = family.in_line.as_ref().and_then(|(_, point)| point.envelope?.length) else { return plot };
    let sides: [(&str, Side); 3] =
        [("length", |e| e.length), ("breadth", |e| Some(e.breadth)), ("height", |e| Some(e.height))];
    for (name, side) in sides {
        let value = |point: &SweptEngine| Some((float(point.values.first()?), side(point.envelope.as_ref()?)? / unit));
        add(&mut plot, name, name, whole.points.iter().map(value));
    }
    plot
}

/// What the paper's mass rests on: the volume, the counterweights, the firing.
fn mass(family: &Studied, whole: &Sweep) -> Plot {
    let mut plot = plot(&family.sweep, "what the mass follows");
    plot.y = Axis::linear("see the legend");
    let Some(unit) = family.volumes.first().copied().flatten() else { return plot };
    let at = |point: &SweptEngine| point.values.first().map(float);
    let volumes = whole.points.iter().zip(&family.volumes);
    add(&mut plot, "volume, in line 1", "volume", volumes.map(|(point, volume)| Some((at(point)?, (*volume)? / unit))));
    let weights = whole.points.iter().map(|point| Some((at(point)?, point.counterweight?.value)));
    add(&mut plot, "counterweight in m r", "", weights);
    let firing = whole.points.iter().map(|point| Some((at(point)?, float(&point.evenness.as_ref()?.unevenness()))));
    add(&mut plot, "longest less shortest firing interval, in turns", "", firing);
    plot
}
