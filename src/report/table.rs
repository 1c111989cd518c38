//! Which tables does a report hold? Cells are finished strings of the dialect.

use num_rational::BigRational;
use serde::Serialize;

use super::dialect::Dialect;
use super::firmness;
use super::residual;
use super::typeset;
use crate::engine::{Cylinder, Engine, LengthUnit};
use crate::order::{self, Source, TurningMass};
use crate::page::Text;
use crate::proof::Sense;
use crate::verdict::{OrderBalance, OrderVerdict, Theorem, Verdict};

/// A table: every row has as many cells as the header.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// Headings of the columns.
    pub header: Vec<String>,
    /// The cells.
    pub rows: Vec<Vec<String>>,
    /// Size of the letters in LaTeX, so that the widest row fits the page.
    pub size: &'static str,
}

impl Table {
    /// Sets a table; the cells are prose.
    pub(super) fn new(dialect: Dialect, header: &[&str], rows: Vec<Vec<String>>) -> Self {
        let set = |cells: Vec<String>| cells.iter().map(|cell| dialect.prose(cell)).collect();
        Table {
            header: header.iter().map(|cell| dialect.prose(cell)).collect(),
            size: size(width(header, &rows)),
            rows: rows.into_iter().map(set).collect(),
        }
    }
}

/// Letters of a cell as it is set: bold marks, braces and dollars are not, a TeX command is about one letter.
pub(super) fn letters(cell: &str) -> usize {
    let mut count = 0;
    let mut in_command = false;
    for letter in cell.chars() {
        in_command = letter == '\\' || in_command && letter.is_ascii_alphabetic();
        count += usize::from(letter == '\\' || !in_command && !"{}$*".contains(letter));
    }
    count
}

/// Letters that the widest cells of all columns take beside each other, with the space between columns.
fn width(header: &[&str], rows: &[Vec<String>]) -> usize {
    let widest = |column: usize| rows.iter().map(|row| letters(&row[column])).chain([letters(header[column])]).max();
    (0..header.len()).filter_map(widest).map(|width| width + 3).sum()
}

/// The widest table that fits the page in the smallest letters used.
const WIDEST: usize = 108;

fn size(width: usize) -> &'static str {
    match width {
        0..=84 => "\\small",
        85..=94 => "\\footnotesize",
        _ => "\\scriptsize",
    }
}

/// Orders × (force, moment): what is left, whether the moment is a couple, how firm the zeros of the pistons are.
///
/// An order of several sums has a row for the whole, and one for each.
pub(super) fn summary(dialect: Dialect, engine: &Engine, orders: &[OrderVerdict], with_firmness: Firmness) -> Table {
    let bold = |text: String| if text == "0" { "**0**".to_owned() } else { text };
    let row = |name: String, [force, moment]: [String; 2], firm: String| {
        let firm = (with_firmness == Firmness::Shown).then_some(firm);
        [name, bold(force), bold(moment)].into_iter().chain(firm).collect::<Vec<_>>()
    };
    let part = |part: &OrderBalance| {
        let firm = if part.class.is_none() { firmness::summary(engine, part) } else { "–".to_owned() };
        row(residual::order_name(part), [residual::force_summary(part), residual::moment_summary(part)], firm)
    };
    let rows = orders.iter().flat_map(|order| {
        let whole = || row(order.order.to_string(), residual::whole_summary(order), "–".to_owned());
        let whole = (order.parts.len() > 1).then(whole);
        whole.into_iter().chain(order.parts.iter().map(part))
    });
    let mut header = vec!["Order", "Force", "Moment"];
    header.extend((with_firmness == Firmness::Shown).then_some("How firm"));
    Table::new(dialect, &header, rows.collect())
}

/// Whether a summary says how firm the zeros are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Firmness {
    /// It has a column of its own.
    Shown,
    /// The verdicts are not on the pistons alone.
    NotShown,
}

/// One row per cylinder: throw, bank, position, and mass where they differ from 1.
pub(super) fn cylinders(dialect: Dialect, engine: &Engine) -> Table {
    let unit = position_unit(engine);
    let mut header = vec!["Cylinder".to_owned(), "Throw β".into(), "Bank α".into(), format!("Position z{unit}")];
    if !engine.has_unit_masses() {
        header.push("Reciprocating mass".into());
    }
    let row = |cylinder: &Cylinder| {
        let mut cells = vec![
            cylinder.name.clone(),
            typeset::angle(&cylinder.throw),
            typeset::degrees(&typeset::signed_degrees(&cylinder.bank)),
            typeset::number(&cylinder.position),
        ];
        if !engine.has_unit_masses() {
            cells.push(typeset::number(&cylinder.reciprocating_mass));
        }
        cells
    };
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    Table::new(dialect, &header, engine.cylinders().iter().map(row).collect())
}

/// What stands over positions along the crankshaft.
pub(super) fn position_heading(engine: &Engine) -> Text {
    match engine.length_unit() {
        LengthUnit::Metre => "Position (m)".into(),
        LengthUnit::Spacing => "Position".into(),
    }
}

/// What stands over the positions of loads.
pub(super) fn load_heading(engine: &Engine) -> Text {
    match engine.length_unit() {
        LengthUnit::Metre => "Load at (m)".into(),
        LengthUnit::Spacing => "Load at".into(),
    }
}

/// ` (m)`, or nothing where positions are multiples of the spacing.
pub(super) fn position_unit(engine: &Engine) -> &'static str {
    match engine.length_unit() {
        LengthUnit::Metre => " (m)",
        LengthUnit::Spacing => "",
    }
}

/// One period of orders: 0 or not 0, direct and reverse.
pub(super) fn period(dialect: Dialect, theorem: &Theorem) -> Table {
    let header = ["Order", "Force, direct", "Force, reverse", "Moment, direct", "Moment, reverse"];
    let columns = [&theorem.force, &theorem.moment].map(|every| [&every.direct, &every.reverse]);
    let cell = |verdict: &Verdict| if verdict.vanishes() { "**0**".to_owned() } else { "not 0".to_owned() };
    let row = |index: usize| {
        let order = theorem.force.direct[index].order;
        let orders = if order == 1 { "1".to_owned() } else { format!("{order}, {}, …", order + theorem.period) };
        std::iter::once(orders).chain(columns.iter().flatten().map(|verdicts| cell(&verdicts[index]))).collect()
    };
    Table::new(dialect, &header, (0..theorem.force.direct.len()).map(row).collect())
}

/// The vector-star table of order k: how each phase comes about, where there is room for it, and the sums.
pub(super) fn vector_star(dialect: Dialect, engine: &Engine, order: &OrderBalance) -> Table {
    let (header, rows) = star_cells(engine, order, phase);
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    if width(&header, &rows) <= WIDEST {
        return Table::new(dialect, &header, rows);
    }
    Table::new(dialect, &header, star_cells(engine, order, reduced_phase).1)
}

/// Multiples of an angle in degrees whose sum is a phase.
type Parts<'a> = [(i64, &'a BigRational); 2];

fn star_cells(engine: &Engine, order: &OrderBalance, phase: fn(&Parts) -> String) -> (Vec<String>, Vec<Vec<String>>) {
    let k = i64::from(order.order);
    let has_banks = engine.cylinders().iter().any(|cylinder| cylinder.bank != crate::exact::Turn::zero());
    let pistons_alone = order.force.verdicts().iter().all(|verdict| verdict.sources.iter().all(is_piston));
    let with_mass = !(engine.has_unit_masses() && pistons_alone);
    let arm = format!("Arm z{}", position_unit(engine));
    let first = if pistons_alone { "Cylinder" } else { "Source" };
    let mut header = vec![first.to_owned(), "Throw β".into()];
    header.extend(has_banks.then(|| "Bank α".into()));
    header.push(arm);
    header.extend(with_mass.then(|| "Weight m r".into()));
    header.push(format!("Direct phase {}", phase_formula(k, Sense::Direct, has_banks)));
    header.push(format!("Reverse phase {}", phase_formula(k, Sense::Reverse, has_banks)));
    let row = |cylinder: &Cylinder| {
        let bank = typeset::signed_degrees(&cylinder.bank);
        let mut cells = vec![cylinder.name.clone(), typeset::angle(&cylinder.throw)];
        cells.extend(has_banks.then(|| typeset::degrees(&bank)));
        cells.push(typeset::number(&engine.arm(cylinder)));
        cells.extend(with_mass.then(|| typeset::number(&order::mass_radius(engine, cylinder))));
        let throw = cylinder.throw.degrees();
        cells.extend([Sense::Direct, Sense::Reverse].map(|sense| phase(&parts(order.order, sense, &throw, &bank))));
        cells
    };
    // What turns adds to one of the two sums, at the angle of its weight.
    let turning = |mass: &TurningMass| {
        let angle = |sense| if mass.sense == sense { typeset::angle(&mass.angle) } else { "–".to_owned() };
        let mut cells = vec![mass.source.label(engine), String::new()];
        cells.extend(has_banks.then(String::new));
        cells.push(typeset::number(&(&mass.position - engine.reference_plane())));
        cells.extend(with_mass.then(|| typeset::number(&mass.weight())));
        cells.extend([Sense::Direct, Sense::Reverse].map(angle));
        cells
    };
    let mut sources: Vec<Source> =
        [&order.force.direct, &order.force.reverse].map(|verdict| verdict.sources.clone()).concat();
    sources.sort_unstable();
    sources.dedup();
    let masses = order::turning_masses(engine);
    let cells = |source: &Source| match source {
        Source::Piston(index) => Some(row(&engine.cylinders()[*index])),
        other => masses.iter().find(|mass| mass.source == *other).map(turning),
    };
    let mut rows: Vec<Vec<String>> = sources.iter().filter_map(cells).collect();
    let blank = header.len() - 3;
    for (name, balance) in [("Σ force", &order.force), ("Σ moment", &order.moment)] {
        let mut add = |name: &str, cell: fn(&Verdict) -> String| {
            let cells = balance.verdicts().map(cell);
            rows.push([name.to_owned()].into_iter().chain(vec![String::new(); blank]).chain(cells).collect());
        };
        add(&format!("**{name}**"), length_cell);
        if !balance.is_balanced() {
            add("angle", angle_cell);
        }
    }
    (header, rows)
}

fn is_piston(source: &Source) -> bool {
    matches!(source, Source::Piston(_))
}

fn length_cell(verdict: &Verdict) -> String {
    if verdict.vanishes() { "**0**".to_owned() } else { residual::modulus(verdict).prose() }
}

fn angle_cell(verdict: &Verdict) -> String {
    if verdict.vanishes() { String::new() } else { residual::bearing(&verdict.sum).prose() }
}

/// `2β − α`, `−2β + 3α`; without the bank where all banks are at 0.
pub(super) fn phase_formula(k: i64, sense: Sense, has_banks: bool) -> String {
    let times = |factor: i64, symbol: &str| match factor {
        1 => symbol.to_owned(),
        _ => format!("{factor}{symbol}"),
    };
    let bank = |sign: &str, factor: i64| match factor {
        0 => String::new(),
        _ if !has_banks => String::new(),
        _ => format!(" {sign} {}", times(factor, "α")),
    };
    match sense {
        Sense::Direct => format!("{}{}", times(k, "β"), bank("−", k - 1)),
        Sense::Reverse => format!("−{}{}", times(k, "β"), bank("+", k + 1)),
    }
}

/// The phase of a cylinder in the star of order k, worked out.
pub(super) fn working(cylinder: &Cylinder, order: u32, sense: Sense) -> String {
    phase(&parts(order, sense, &cylinder.throw.degrees(), &typeset::signed_degrees(&cylinder.bank)))
}

/// How often throw and bank enter a phase, with their degrees.
fn parts<'a>(order: u32, sense: Sense, throw: &'a BigRational, bank: &'a BigRational) -> Parts<'a> {
    let [of_throw, of_bank] = order::multiples(order, Some(sense));
    [(of_throw, throw), (of_bank, bank)]
}

/// A phase worked out: `2·270° + 45° = 585° ≡ 225°`.
fn phase(parts: &Parts) -> String {
    let mut text = String::new();
    for (negative, product) in parts.iter().filter_map(|(factor, degrees)| typeset::multiple(*factor, degrees)) {
        text.push_str(match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        text.push_str(&product);
    }
    let sum = phase_sum(parts);
    let (value, reduced) = (typeset::degrees(&sum), reduced_phase(parts));
    let steps = [text, value, reduced.clone()];
    if steps.iter().any(|step| step.contains('≈')) || steps[0].is_empty() {
        return reduced;
    }
    let working = if steps[0] == steps[1] { steps[0].clone() } else { format!("{} = {}", steps[0], steps[1]) };
    if steps[1] == steps[2] { working } else { format!("{working} ≡ {reduced}") }
}

/// A phase in `[0°, 360°)`, without its working.
fn reduced_phase(parts: &Parts) -> String {
    typeset::angle(&crate::exact::Turn::from_degrees(&phase_sum(parts)))
}

fn phase_sum(parts: &Parts) -> BigRational {
    parts.iter().map(|(factor, degrees)| *degrees * BigRational::from_integer((*factor).into())).sum()
}
