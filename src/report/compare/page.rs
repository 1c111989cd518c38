//! What stands on the page of a comparison? The table, and small multiples of the vector stars.

use serde::Serialize;

use super::super::dialect::Dialect;
use super::super::folder::File;
use super::super::multiples::{self, Column};
use super::super::{render, residual, svg};
use super::{Compared, compare_lines, compare_rows, orders_of};
use crate::text::Format;
use crate::verdict::OrderBalance;

#[derive(Serialize)]
struct Page {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
    lines: Vec<String>,
    stars: Vec<Drawing>,
}

#[derive(Serialize)]
struct Drawing {
    order: u32,
    file: String,
    caption: String,
}

/// `compare.md` and the stars of each order, an SVG file per order.
pub fn compare_page(engines: &[Compared]) -> Vec<File> {
    let dialect = Dialect::GithubMarkdown;
    let table = compare_rows(engines);
    let (mut drawings, mut files) = (Vec::new(), Vec::new());
    for order in orders_of(engines) {
        let columns: Vec<Column> = engines.iter().flat_map(|engine| columns(engine, order)).collect();
        let drawing = Drawing { order, file: format!("stars-order-{order}.svg"), caption: caption(order) };
        files.push(File { name: drawing.file.clone(), text: svg(&multiples::multiples(&columns), &drawing.caption) });
        drawings.push(drawing);
    }
    // All cells may hold names and titles, which are a person's.
    let quoted = |cells: Vec<String>| cells.iter().map(|cell| dialect.literal(cell)).collect::<Vec<_>>();
    let page = Page {
        header: quoted(table.header),
        rows: table.rows.into_iter().map(quoted).collect(),
        lines: compare_lines(engines).iter().map(|line| dialect.literal(line)).collect(),
        stars: drawings,
    };
    files.insert(0, File { name: "compare.md".into(), text: render::compare(&page) });
    files
}

fn columns<'a>(engine: &'a Compared, order: u32) -> impl Iterator<Item = Column<'a>> {
    let name = move |judged: &OrderBalance| match &judged.class {
        None => engine.name.escaped(Format::Plain),
        Some(class) => format!("{}, {}", engine.name.escaped(Format::Plain), residual::class_sources(class)),
    };
    let parts = engine.at(order).into_iter().flat_map(|judged| &judged.parts);
    parts.map(move |judged| Column { name: name(judged), engine: engine.engine, order: judged })
}

fn caption(order: u32) -> String {
    format!(
        "Vector stars of order {order}: force above moment, each to one scale where units are the same; blue, orange and green polygons sum to zero, a red arrow is what is left"
    )
}
