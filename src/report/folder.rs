//! Which files make up a report, and the index of all of them?

use serde::Serialize;

use super::dialect::Dialect;
use super::engine_page::intervals;
use super::{render, residual};
use crate::engine::Engine;
use crate::file::Entry;
pub use crate::page::File;
use crate::verdict::OrderVerdict;

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
        firing: engine
            .firing()
            .map_or_else(String::new, |firing| crate::page::text_in(&intervals(firing), crate::page::Format::GITHUB)),
        forces: cells(orders, 0),
        moments: cells(orders, 1),
    };
    let page = Index { orders: columns.clone(), engines: engines.iter().map(line).collect() };
    File { name: "README.md".into(), text: render::index(&page) }
}
