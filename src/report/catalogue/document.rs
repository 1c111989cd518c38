//! What does `list --json` say? The catalogue, an object per engine.

use serde::Serialize;

use super::{FirstOrderLeft, catalogue_families};
use crate::engine::{Cycle, Engine, Firing};
use crate::file::Entry;
use crate::text::Untrusted;

/// The JSON document of `list`.
#[derive(Serialize)]
pub struct CatalogueDocument<'a> {
    format: &'static str,
    engines: Vec<Listed<'a>>,
}

/// An engine by its name.
#[derive(Serialize)]
struct Listed<'a> {
    name: &'static str,
    title: &'a str,
    source: Option<&'a str>,
    cylinders: usize,
    cycle: Option<&'static str>,
    firing: Option<&'static str>,
    /// The lowest order that is left of the force.
    force: LowestOrder,
    /// The same of the moment.
    moment: LowestOrder,
}

#[derive(Serialize)]
#[serde(untagged)]
enum LowestOrder {
    Order(u32),
    Word(&'static str),
}

/// The catalogue as data, in the order of [`super::catalogue_answer`].
pub fn catalogue_document(engines: &[(Entry, Engine)]) -> CatalogueDocument<'_> {
    let families = catalogue_families(engines);
    let known = families.into_iter().flat_map(|family| family.engines);
    let listed = known.map(|known| {
        let lowest = |first: Option<FirstOrderLeft>| {
            first.map_or(LowestOrder::Word("none"), |first| LowestOrder::Order(first.order))
        };
        let [force, moment] = match known.first() {
            Some(first) => first.map(lowest),
            None => [LowestOrder::Word("not-stated"), LowestOrder::Word("not-stated")],
        };
        let engine: &Engine = known.engine;
        Listed {
            name: known.name,
            title: engine.title().written(),
            source: engine.source().map(Untrusted::written),
            cylinders: engine.cylinders().len(),
            cycle: engine.cycle().map(Cycle::word),
            firing: engine.firing().map(|firing: &Firing| if firing.is_even() { "even" } else { "uneven" }),
            force,
            moment,
        }
    });
    CatalogueDocument { format: "crankstar list 1", engines: listed.collect() }
}
