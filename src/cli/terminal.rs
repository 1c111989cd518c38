//! How do the verdicts look on a terminal? In colour there, in plain text elsewhere.

use comfy_table::presets::UTF8_HORIZONTAL_ONLY;
use comfy_table::{Cell, Color, ContentArrangement, Table};
use crankstar::report::{self, Compared};

/// Engines side by side: one column per engine.
pub fn compare(engines: &[Compared]) -> String {
    let mut rows = report::compare_rows(engines);
    // One part of a remedy a line: columns stay narrow.
    rows.rows.iter_mut().flatten().for_each(|text| *text = text.replace("; ", ";\n"));
    let mut table = coloured(rows);
    // On a terminal the cells are wrapped to its width.
    table.set_content_arrangement(ContentArrangement::Dynamic);
    format!("{table}\n{}\n", report::compare_lines(engines).join("\n"))
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
