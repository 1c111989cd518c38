//! Which files make up a report, and the index of all of them?

use serde::Serialize;

use super::dialect::Dialect;
use super::page::{Page, figures, intervals};
use super::{left, render, svg};
use crate::layout::{Entry, Layout};
use crate::verdict::OrderBalance;

/// A file to be written: its name inside the folder, and its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Name inside the folder.
    pub name: String,
    /// What it holds.
    pub text: String,
}

/// The text of a report alone.
pub fn text(layout: &Layout, orders: &[OrderBalance], dialect: Dialect) -> String {
    render::report(&Page::new(layout, orders, dialect), dialect)
}

/// A report with its diagrams: `report.md` with SVG files, or `report.tex`, which holds its own.
pub fn report(layout: &Layout, orders: &[OrderBalance], dialect: Dialect) -> Vec<File> {
    let text = text(layout, orders, dialect);
    if dialect == Dialect::Latex {
        return vec![File { name: "report.tex".into(), text }];
    }
    let mut files = vec![File { name: "report.md".into(), text }];
    files.extend(
        figures(layout, orders)
            .into_iter()
            .map(|named| File { text: svg::svg(&named.figure, &named.caption), name: format!("{}.svg", named.name) }),
    );
    files
}

/// One line of the index.
#[derive(Serialize)]
struct Line {
    name: &'static str,
    title: String,
    firing: String,
    forces: Vec<String>,
    moments: Vec<String>,
}

/// The index page over the reports of the catalogue: one line an engine.
pub fn index(engines: &[(Entry, Layout, Vec<OrderBalance>)]) -> File {
    let dialect = Dialect::GithubMarkdown;
    let line = |(entry, layout, orders): &(Entry, Layout, Vec<OrderBalance>)| Line {
        name: entry.name,
        title: dialect.quoted(&layout.title),
        firing: layout.firing.as_ref().map_or_else(String::new, intervals),
        forces: orders.iter().map(left::force_summary).collect(),
        moments: orders.iter().map(left::moment_summary).collect(),
    };
    #[derive(Serialize)]
    struct Index {
        orders: Vec<u32>,
        engines: Vec<Line>,
    }
    let orders = engines.first().map_or_else(Vec::new, |(_, layout, _)| layout.orders.clone());
    let page = Index { orders, engines: engines.iter().map(line).collect() };
    File { name: "README.md".into(), text: render::index(&page) }
}
