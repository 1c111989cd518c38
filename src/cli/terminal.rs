//! How do the verdicts look on a terminal? In colour there, in plain text elsewhere.

use comfy_table::presets::UTF8_HORIZONTAL_ONLY;
use comfy_table::{Cell, Color, Table};
use crankstar::engine::Engine;
use crankstar::remedy::Remedy;
use crankstar::report::{self, AccuracyCase};
use crankstar::text::Format;

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
