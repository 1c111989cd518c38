//! What must hold for any bytes at all? One function for each reader: an answer or a message, and never a panic.
//!
//! libFuzzer drives them (`fuzz/run`), and so does the suite, with the seeds and some thousands of changes to them. Engines are
//! kept small, since what is sought is a fault and not a long calculation.

#![allow(clippy::disallowed_types)]

use std::fs;
use std::ops::ControlFlow;
use std::sync::LazyLock;

use crankstar::claim::{parse_claims, parse_statement};
use crankstar::engine::{Cycle, Engine, Family};
use crankstar::family;
use crankstar::file::{self, Key, Layout, Template};
use crankstar::page::{self, Format};
use crankstar::proof::{Quantity, read_document};
use crankstar::report;
use crankstar::search::{self, Front, Options, Problem, search};
use crankstar::sweep::{Geometry, Parameter, Range, sweep};
use crankstar::verdict::Judgement;

/// Longer texts only take longer.
const LONGEST: usize = 16 << 10;
/// Larger engines are read, and not judged.
const MOST_CYLINDERS: usize = 12;
/// Reports are made of engines up to this size.
const MOST_REPORTED: usize = 3;
/// Ranges of more points are read, and not swept.
const MOST_POINTS: usize = 4;

fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok().filter(|text| text.len() <= LONGEST)
}

/// A layout file: read, judged, its document checked, its loads and its report made.
pub fn layout(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match file::parse_layout("layout.toml", text) {
        Ok(Layout::Known(layout, _)) => known(&layout),
        Ok(Layout::Open(family)) => open(&family),
        Err(error) => assert!(!error.message().is_empty() && !error.to_string().is_empty()),
    }
}

fn known(layout: &Engine) {
    if layout.cylinders().len() > MOST_CYLINDERS {
        return;
    }
    let orders: Vec<u32> = layout.orders().iter().copied().take(2).collect();
    let judged = Judgement::new(layout, &orders, &Quantity::ALL).expect("orders");
    let document = report::document(layout, judged.masses, &judged.orders, &Quantity::ALL, None);
    assert_written(serde_json::to_string(&document));
    if let Ok(numbers) = report::Numbers::new(layout, &orders, None) {
        assert_written(serde_json::to_string(&report::loads_document(layout, &numbers, None)));
    }
    if layout.cylinders().len() <= MOST_REPORTED {
        let judged = Judgement::new(layout, &orders, &Quantity::PLANAR).expect("orders");
        let subject = report::Contents {
            engine: layout,
            judged: &judged,
            family: None,
            needed: None,
            in_motion: false,
            accuracy: None,
            weighing: report::Weighing::usual(),
        };
        let page = report::engine_page(subject);
        for format in [Format::GITHUB, Format::Latex, Format::Html, Format::PLAIN] {
            assert!(!page::write(&page, format, &page::Options::default()).is_empty());
        }
    }
}

/// Every document is written, but for one with a length that no decimal tells.
fn assert_written(document: serde_json::Result<String>) {
    if let Err(error) = document {
        assert!(error.to_string().contains("beyond the range of decimals"), "{error}");
    }
}

fn open(family: &Family) {
    if family.cylinders().len() > MOST_CYLINDERS {
        return;
    }
    let orders: Vec<u32> = family.orders().iter().copied().take(2).collect();
    let verdicts = family::classify(family, &orders).expect("orders");
    assert!(serde_json::to_string(&report::open_document(family, &verdicts)).is_ok());
    if family.cylinders().len() <= MOST_REPORTED {
        let page = report::family_page(family, &verdicts, false);
        assert!(!page::write(&page, Format::Latex, &page::Options::default()).is_empty());
    }
}

/// A claims file: read, its first claims answered, in words.
pub fn claims(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let find = |name: &str| match file::find(name) {
        Some(entry) => entry.engine().map_err(|error| error.to_string()),
        None => Err(format!("there is no engine `{name}`")),
    };
    let claims = match parse_claims("claims.toml", text, &find) {
        Ok(claims) => claims,
        Err(error) => return assert!(!error.message().is_empty() && !error.to_string().is_empty()),
    };
    for claim in claims.statements.iter().flat_map(|statement| &statement.claims).take(2) {
        let answer = claim.answer();
        assert!(!report::claim_status(&answer).is_empty());
        assert!(!report::claim_finding(&claim.statement, &answer).is_empty());
    }
    for (table, verdict) in claims.tables.iter().zip(claims.judged_tables()).take(2) {
        assert!(!report::table_finding(table, &verdict).is_empty());
    }
}

/// A document for `verify`, of any kind.
pub fn document(bytes: &[u8]) {
    match read_document(bytes) {
        Ok(document) => {
            if let Err(fault) = document.check() {
                assert!(!fault.to_string().is_empty());
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// The search whose state the seeds are.
pub fn problem() -> Problem {
    Problem::inline(5, Cycle::TwoStroke, &[1, 2])
}

/// The state of a search, as a file that is resumed: it is refused, or changes nothing in the answer.
pub fn resume(bytes: &[u8]) {
    let thread = format!("{:?}", std::thread::current().id()).replace(['(', ')'], "");
    let path = std::env::temp_dir().join(format!("crankstar-{}-{thread}.json", std::process::id()));
    fs::write(&path, bytes).expect("a folder for passing files");
    // The first piece that the state lacks ends the search.
    let options =
        Options { threads: 1, resume: Some(path.clone()), progress: &|_| ControlFlow::Break(()), ..Options::default() };
    match search(&problem(), &options) {
        Ok(front) => assert_eq!(answer(&front), *AFRESH),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
    fs::remove_file(&path).expect("the file of this search");
}

/// What the search answers without any state.
static AFRESH: LazyLock<String> = LazyLock::new(|| match search(&problem(), &Options::default()) {
    Ok(front) => answer(&front),
    Err(error) => panic!("{error}"),
});

fn answer(front: &Front) -> String {
    serde_json::to_string(&search::document(front)).expect("a document")
}

/// Values of the command line: numbers, angles, lengths, keys, ranges, statements, and a small sweep.
pub fn values(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let refused = [
        file::parse_number(text).err().map(|error| error.to_string()),
        file::parse_angle(text).err(),
        file::parse_length(text).err(),
        Key::parse(text).err(),
        parse_statement(text).err().map(|mistake| mistake.message),
        Range::parse(text).err().map(|error| error.to_string()),
    ];
    assert!(refused.into_iter().flatten().all(|message| !message.is_empty()));
    if let Ok(range) = Range::parse(text) {
        assert!(range.count() > 0 && range.finer(2).last() == range.last());
    }
    let Ok(parameter) = Parameter::parse(text) else { return };
    assert!(!parameter.column().is_empty());
    let template = Template::new("v.toml", V_TWIN).expect("a layout file");
    if parameter.range.count() <= MOST_POINTS
        && let Ok(swept) = sweep(&template, &[parameter], &[1], &Geometry::default())
    {
        assert!(!report::sweep_csv(&swept).text.is_empty());
    }
}

/// What values are swept in.
const V_TWIN: &str = "\
speed = 3000
[vee]
bank_angle = 60
throws = [0, 180]
pin_split = 0
spacing = \"100 mm\"
[mechanism]
crank_radius = 0.05
rod_ratio = 0.25
reciprocating_mass = 0.5
rotating_mass = 0.4
[crankshaft]
balance_factor = 0.5
counterweight_radius = 0.05
";
