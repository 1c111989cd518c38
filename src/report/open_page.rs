//! What stands on the report of a family? For which angles and lengths each order vanishes, and why.

use serde::Serialize;

use super::dialect::Dialect;
use super::open_table;
use super::open_words;
use super::table::Table;
use crate::engine::{Family, PHI};
use crate::family::{self, OpenOrder, OpenVerdict};

/// Everything that the template of a family's report places.
#[derive(Clone, Debug, Serialize)]
pub(super) struct OpenPage {
    title: String,
    source: Option<String>,
    unknowns: String,
    summary: Table,
    legend: String,
    even_firing: Option<String>,
    cylinders: Table,
    conventions: Vec<String>,
    orders: Vec<OpenSection>,
}

/// One order.
#[derive(Clone, Debug, Serialize)]
pub(super) struct OpenSection {
    heading: String,
    table: Table,
    verdicts: Vec<OpenParagraph>,
}

/// One verdict with its argument.
#[derive(Clone, Debug, Serialize)]
pub(super) struct OpenParagraph {
    lead: String,
    sums: Vec<String>,
    left: Option<String>,
}

const LEGEND: &str = "**0** vanishes for all values of the unknowns, proved; a moment that vanishes does so for all lengths. Angles are those \
                      in (0°, 360°), exact and complete; ≡ is modulo 360°.";

impl OpenPage {
    /// Sets the report of a family in a dialect.
    pub fn new(family: &Family, orders: &[OpenOrder], dialect: Dialect) -> Self {
        let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
        let unknowns = unknowns.join(", ").replace(PHI, "φ").replace("delta", "δ");
        OpenPage {
            title: dialect.quoted(family.title()),
            source: family.source().map(|source| dialect.quoted(source)),
            unknowns: dialect.prose(&format!("Left open: {unknowns}.")),
            summary: open_table::summary(dialect, orders),
            legend: dialect.prose(LEGEND),
            even_firing: family::even_firing(family)
                .map(|angles| dialect.prose(&open_words::even_firing_words(&angles))),
            cylinders: open_table::cylinders(dialect, family),
            conventions: conventions(family).iter().map(|line| dialect.prose(line)).collect(),
            orders: orders.iter().map(|order| OpenSection::new(family, order, dialect)).collect(),
        }
    }
}

fn conventions(family: &Family) -> Vec<String> {
    vec![
        super::page::SEEN.to_owned(),
        super::page::FIRES.to_owned(),
        format!("Moments are taken about the plane z = {}.", open_words::open_length(family.reference_plane())),
        super::page::ASSUMED.to_owned(),
    ]
}

impl OpenSection {
    pub fn new(family: &Family, order: &OpenOrder, dialect: Dialect) -> Self {
        OpenSection {
            heading: format!("Order {}", order.order),
            table: open_table::phases(dialect, family, order.order),
            verdicts: order.force.iter().chain(&order.moment).map(|v| OpenParagraph::new(v, dialect)).collect(),
        }
    }
}

impl OpenParagraph {
    fn new(verdict: &OpenVerdict, dialect: Dialect) -> Self {
        let name = format!("**{}, {}:**", super::page::capital(verdict.quantity.name()), verdict.sense.name());
        let left = open_words::left_sentence(verdict).map(|text| dialect.prose(&text));
        let none = verdict.sums.is_empty().then(|| "Every weight is zero.".to_owned());
        let sums = verdict.sums.iter().map(open_words::argument).chain(none);
        OpenParagraph {
            lead: dialect.prose(&format!("{name} {}.", open_words::open_summary_prose(verdict))),
            sums: sums.map(|text| dialect.prose(&text)).collect(),
            left,
        }
    }
}
