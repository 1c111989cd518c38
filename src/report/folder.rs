//! Which files make up a report, and the index of all of them?

use serde::Serialize;

use super::calculation::{self, Numbers};
use super::dialect::Dialect;
use super::open_page::OpenPage;
use super::page::{Contents, NamedFigure, Page, figures, intervals, torque_stars, torque_verdicts};
use super::remedy::alone_picture;
use super::{render, residual};
use crate::engine::{Engine, Family};
use crate::family::OpenOrder;
use crate::file::Entry;
pub use crate::page::File;
use crate::verdict::OrderVerdict;

/// A report with its diagrams: `report.md` with SVG files, or `report.tex`, which holds its own.
pub fn report(subject: Contents, dialect: Dialect) -> Vec<File> {
    let numbers = subject.numbers();
    let text = render::report(&Page::new(subject, numbers.as_ref(), dialect), dialect);
    if dialect == Dialect::Latex {
        return vec![File { name: "report.tex".into(), text }];
    }
    let mut drawn = figures(subject.engine, subject.judged);
    if let Some(Ok(remedy)) = subject.remedy() {
        let picture = alone_picture(&remedy);
        drawn.extend(picture.map(|picture| NamedFigure {
            name: picture.name,
            caption: "Partial balance".into(),
            figure: picture.figure,
        }));
    }
    let torque = torque_verdicts(subject.engine, subject.judged, numbers.as_ref());
    drawn.extend((!torque.is_empty()).then(|| torque_stars(subject.engine, &torque)));
    if let Some(Ok(Numbers { loads, .. })) = &numbers {
        drawn.extend(calculation::figures(subject.engine, loads));
    }
    [File { name: "report.md".into(), text }].into_iter().chain(drawn.into_iter().map(NamedFigure::into_svg)).collect()
}

/// The report of a family: one file, without diagrams, for its angles are open.
pub fn open_report(family: &Family, orders: &[OpenOrder], dialect: Dialect) -> Vec<File> {
    let name = if dialect == Dialect::Latex { "report.tex" } else { "report.md" };
    let text = render::open_report(&OpenPage::new(family, orders, dialect), dialect);
    vec![File { name: name.into(), text }]
}

/// What the template of the index places.
#[derive(Serialize)]
struct Index {
    orders: Vec<u32>,
    engines: Vec<Line>,
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

/// The orders of the index: those that every engine is judged at.
fn common_orders(engines: &[(Entry, Engine, Vec<OrderVerdict>)]) -> Vec<u32> {
    let judged = |engine: &(Entry, Engine, Vec<OrderVerdict>), order: u32| engine.2.iter().any(|o| o.order == order);
    let first = engines.first().map_or(&[][..], |(_, _, orders)| orders);
    first.iter().map(|order| order.order).filter(|&order| engines.iter().all(|engine| judged(engine, order))).collect()
}

/// The index page over the reports of the catalogue: one line per engine, at the orders that all are judged at.
pub fn index(engines: &[(Entry, Engine, Vec<OrderVerdict>)]) -> File {
    let dialect = Dialect::GithubMarkdown;
    let columns = common_orders(engines);
    let cells = |orders: &[OrderVerdict], cell: usize| {
        orders
            .iter()
            .filter(|order| columns.contains(&order.order))
            .map(|order| residual::whole_summary(order)[cell].clone())
            .collect()
    };
    let line = |(entry, engine, orders): &(Entry, Engine, Vec<OrderVerdict>)| Line {
        name: entry.name,
        title: dialect.quoted(engine.title()),
        firing: engine.firing().map_or_else(String::new, intervals),
        forces: cells(orders, 0),
        moments: cells(orders, 1),
    };
    let page = Index { orders: columns.clone(), engines: engines.iter().map(line).collect() };
    File { name: "README.md".into(), text: render::index(&page) }
}
