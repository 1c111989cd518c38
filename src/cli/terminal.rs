//! How do the verdicts look on a terminal? In colour there, in plain text elsewhere.

use comfy_table::presets::UTF8_HORIZONTAL_ONLY;
use comfy_table::{Cell, Color, Table};
use crankstar::engine::{Engine, Family};
use crankstar::family::{self, OpenOrder};
use crankstar::loads::Needed;
use crankstar::remedy::Remedy;
use crankstar::report::{self, AccuracyCase, Numbers};
use crankstar::text::Format;
use crankstar::verdict::{Judgement, OrderVerdict};

/// The title and a table, a row per order; a second one of the pistons alone where other masses turn.
pub fn summary(engine: &Engine, judged: &Judgement) -> String {
    let tables = match &judged.pistons {
        None => format!("{}\n", verdicts(&judged.orders)),
        Some(pistons) => {
            let [as_built, alone] = [report::AS_BUILT, report::PISTONS_ALONE];
            format!("{as_built}:\n{}\n{alone}:\n{}\n", verdicts(&judged.orders), verdicts(pistons))
        }
    };
    let missing =
        |order: &OrderVerdict| !order.exists() || order.torque.as_ref().is_some_and(|torque| !torque.exists());
    let why =
        if judged.orders.iter().any(missing) { format!("{}\n", report::why_not(judged.masses)) } else { String::new() };
    let unit = report::turning_unit(judged).map_or_else(String::new, |words| format!("{words}\n"));
    let whose = report::whose_masses(engine, judged).map_or_else(String::new, |words| format!("{words}\n"));
    format!("{}\n{tables}{}\n{unit}{why}{whose}", engine.title().escaped(Format::Plain), report::LEGEND)
}

/// A row per order, and one for each of its sums where there are several.
fn verdicts(orders: &[OrderVerdict]) -> Table {
    let with_torque = orders.iter().any(|order| order.torque.is_some());
    let mut table = ruled();
    let mut header = vec!["Order", "Force", "Moment"];
    header.extend(with_torque.then_some("Torque"));
    table.set_header(header);
    for order in orders {
        let [force, moment] = report::whole_summary(order);
        let mut row = vec![
            Cell::new(order.order),
            verdict_cell(force, order.force.is_balanced()),
            verdict_cell(moment, order.moment.is_balanced()),
        ];
        row.extend(
            order
                .torque
                .as_ref()
                .map(|torque| verdict_cell(report::torque_summary(torque), torque.outcome.vanishes() == Some(true))),
        );
        table.add_row(row);
        for part in order.parts.iter().filter(|part| part.class.is_some()) {
            let mut row = vec![
                Cell::new(report::order_name(part)),
                verdict_cell(report::force_summary(part), part.force.is_balanced()),
                verdict_cell(report::moment_summary(part), part.moment.is_balanced()),
            ];
            row.extend(with_torque.then(|| Cell::new("")));
            table.add_row(row);
        }
    }
    table
}

/// The title of a family and a table: for which angles each order vanishes.
pub fn open_summary(family: &Family, orders: &[OpenOrder]) -> String {
    let mut table = ruled();
    table.set_header(["Order", "Force, direct", "Force, reverse", "Moment, direct", "Moment, reverse"]);
    for order in orders {
        let cells = order.force.iter().chain(&order.moment);
        let cells = cells.map(|verdict| verdict_cell(report::open_summary(verdict), verdict.always()));
        table.add_row([Cell::new(order.order)].into_iter().chain(cells));
    }
    let evenly = family::even_firing(family).map(|angles| report::even_firing_words(&angles));
    let lines = evenly.map(|line| format!("{line}\n")).unwrap_or_default();
    format!(
        "{}\n{table}\n0 vanishes for all values of the unknowns, proved; angles are exact and complete in (0°, 360°).\n{lines}",
        family.title().escaped(Format::Plain)
    )
}

/// The title and a table of the largest values, one row per order, with the peaks of the sums.
pub fn loads(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> String {
    let table = coloured(report::loads_rows(engine, &numbers.loads));
    let lines = report::loads_lines(engine, numbers, needed).join("\n");
    format!("{}\n{table}\n{lines}\n", engine.title().escaped(Format::Plain))
}

/// One table per rod ratio and load, with one row per method.
pub fn accuracy(engine: &Engine, cases: &[AccuracyCase]) -> String {
    let mut out = format!("{}\n", engine.title().escaped(Format::Plain));
    for case in cases {
        for study in &case.studies {
            out.push_str(&format!("\n{}\n", report::accuracy_heading(case, study)));
            if study.rows.is_empty() {
                continue;
            }
            let mut table = ruled();
            table.set_header(report::ACCURACY_HEADER);
            for row in report::accuracy_rows(engine, study) {
                table.add_row(row);
            }
            out.push_str(&format!("{table}\n"));
        }
    }
    out.push_str("Errors are parts of the peak; ● no other method is both faster and more accurate.\n");
    out
}

/// The title and a table of weights, with what they come to.
pub fn remedy(engine: &Engine, remedy: &Remedy) -> String {
    let lines = report::remedy_lines(remedy).join("\n");
    let rows = report::remedy_rows(remedy);
    if rows.rows.is_empty() {
        return format!("{}\n{lines}\n", engine.title().escaped(Format::Plain));
    }
    let mut table = ruled();
    table.set_header(rows.header);
    for row in rows.rows {
        table.add_row(row);
    }
    format!("{}\n{table}\n{lines}\n", engine.title().escaped(Format::Plain))
}

/// The title, the front, and what uniform balance factors reach.
#[cfg(feature = "optimise")]
pub fn optimise(engine: &Engine, front: &crankstar::optimise::Front, couple: &crankstar::optimise::Couple) -> String {
    let points = coloured(report::optimise_rows(engine, front));
    let lines = report::optimise_lines(engine, front, couple).join("\n");
    let compared = match front.uniform.is_empty() {
        true => String::new(),
        false => format!("{}\n", coloured(report::optimise_compared(engine, front))),
    };
    format!("{}\n{points}\n{compared}{lines}\n", engine.title().escaped(Format::Plain))
}

/// A table whose zeros are coloured as what is proved.
fn coloured(rows: report::Rows) -> Table {
    let mut table = ruled();
    table.set_header(rows.header);
    for row in rows.rows {
        table.add_row(row.into_iter().map(|text| {
            let vanishes = text == "0";
            verdict_cell(text, vanishes)
        }));
    }
    table
}

/// An empty table with lines between its rows.
fn ruled() -> Table {
    let mut table = Table::new();
    table.load_style(UTF8_HORIZONTAL_ONLY);
    table
}

fn verdict_cell(text: String, vanishes: bool) -> Cell {
    let cell = Cell::new(text);
    if vanishes { cell.fg(Color::Green) } else { cell }
}
