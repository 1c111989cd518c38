//! The tables of data that the program gives: of an engine, of a sweep, of a search.

use std::sync::atomic::AtomicBool;

use crankstar::data;
use crankstar::engine::{CycleOrder, Engine};
use crankstar::file::{Template, parse_diagram, parse_rotor};
use crankstar::proof::Quantity;
use crankstar::report::{self, Compared, FlywheelStudy, Question, RotorStudy, ValuesStudy};
use crankstar::search::{Front, Options, Problem, search, torsion};
use crankstar::sweep::{Geometry, Parameter, Stream, Sweep};
use crankstar::table::{Table, Values};
use crankstar::text::Untrusted;
use crankstar::verdict::{self, Judgement};
use serde_json::Value;

/// The tables that answer a question, and the JSON document that answers it.
pub struct Answered {
    pub question: &'static str,
    pub tables: Vec<Table>,
    pub document: Value,
}

impl Answered {
    #[track_caller]
    pub fn table(&self, name: &str) -> &Table {
        let found = self.tables.iter().find(|table| table.name() == name);
        found.unwrap_or_else(|| panic!("{} has no table {name}", self.question))
    }
}

fn json(document: &impl serde::Serialize) -> Value {
    serde_json::to_value(document).expect("JSON")
}

/// The document of an answer.
pub fn json_of(answer: &dyn Question) -> Value {
    serde_json::from_str(&answer.json().expect("JSON")).expect("JSON")
}

/// All questions that can be asked of an engine.
pub fn of_engine(engine: &Engine, orders: &[u32]) -> Vec<Answered> {
    let mut all = vec![classify(engine, orders), compare(engine, orders)];
    all.extend(report::questions().filter_map(|question| asked(question, engine, orders)));
    all
}

pub fn classify(engine: &Engine, orders: &[u32]) -> Answered {
    let quantities = match engine.has_links() {
        true => vec![Quantity::FORCE, Quantity::MOMENT],
        false => verdict::quantities(engine, true),
    };
    let judged = Judgement::new(engine, orders, &quantities).expect("orders");
    let document = report::document(engine, judged.masses, &judged.orders, &quantities, None);
    let tables = data::classify(engine, &judged, &document);
    Answered { question: "classify", tables, document: json(&document) }
}

pub fn compare(engine: &Engine, orders: &[u32]) -> Answered {
    let names = ["=one", "two"];
    let compared = names.map(|name| Compared::new(Untrusted::new(name), engine, orders).expect("orders"));
    Answered {
        question: "compare",
        tables: data::compare(&compared),
        document: json(&report::compare_document(&compared)),
    }
}

/// What a question answers; none where the layout lacks what it needs.
pub fn asked(question: &'static str, engine: &Engine, orders: &[u32]) -> Option<Answered> {
    let orders: Vec<CycleOrder> = orders.iter().filter_map(|order| CycleOrder::of_halves(2 * order)).collect();
    let answer = report::ask(question, engine, &orders).expect("a question").ok()?;
    let document = serde_json::from_str(&answer.json().expect("JSON")).expect("JSON");
    Some(Answered { question, tables: answer.tables(), document })
}

/// A value of an engine, by its name.
pub fn valued(engine: &Engine, name: &str) -> Answered {
    let names = vec![name.parse().expect("a name")];
    let row = (Untrusted::new("one"), report::values_of(engine, &names));
    let study = ValuesStudy { names, rows: vec![row] };
    let document = json_of(&study);
    Answered { question: "values", tables: study.tables(), document }
}

/// What balances masses on a shaft.
pub fn balanced(text: &str) -> Answered {
    let study = RotorStudy::new(parse_rotor("shaft.toml", text).expect("masses")).expect("it is solved");
    let document = json_of(&study);
    Answered { question: "rotor", tables: study.tables(), document }
}

/// What a turning-moment diagram tells.
pub fn fluctuating(text: &str) -> Answered {
    let study = FlywheelStudy::new(parse_diagram("diagram.toml", text).expect("a diagram")).expect("it fits");
    let document = json_of(&study);
    Answered { question: "flywheel", tables: study.tables(), document }
}

pub fn swept(text: &str, parameters: &[&str], orders: &[u32], firing: &[&str]) -> (Sweep, Answered) {
    let template = Template::new("layout.toml", text).expect("TOML");
    let parameters: Vec<Parameter> = parameters.iter().map(|text| Parameter::parse(text).expect("a range")).collect();
    let firing: Vec<CycleOrder> = firing.iter().map(|order| order.parse().expect("an order")).collect();
    let stream = Stream::new(&template, &parameters, orders, &firing, &Geometry::default()).expect("a sweep");
    let swept = stream.whole(&AtomicBool::new(false)).expect("points");
    let answered = Answered { question: "sweep", tables: swept.tables(), document: json_of(&swept) };
    (swept, answered)
}

pub fn searched(problem: &Problem, with_torsion: bool) -> (Front, Answered) {
    let front = search(problem, &Options::default()).expect("a front");
    let judged = with_torsion.then(|| torsion(&front, None).expect("in line"));
    let document = crankstar::search::document(&front);
    let document = match &judged {
        Some(torsion) => document.with_torsion(torsion),
        None => document,
    };
    let tables = data::search(&front, judged.as_ref());
    let answered = Answered { question: "search", tables, document: json(&document) };
    (front, answered)
}

/// A column of decimals.
#[track_caller]
pub fn decimals(table: &Table, name: &str) -> Vec<Option<f64>> {
    match values(table, name) {
        Values::Decimal(values) => values.clone(),
        other => panic!("{name} is {:?}", other.kind()),
    }
}

/// A column of true and false.
#[track_caller]
pub fn truths(table: &Table, name: &str) -> Vec<Option<bool>> {
    match values(table, name) {
        Values::Truth(values) => values.clone(),
        other => panic!("{name} is {:?}", other.kind()),
    }
}

/// A column of exact numbers, or of words.
#[track_caller]
pub fn texts(table: &Table, name: &str) -> Vec<Option<String>> {
    match values(table, name) {
        Values::Exact(values) | Values::Words(values) => values.clone(),
        other => panic!("{name} is {:?}", other.kind()),
    }
}

#[track_caller]
fn values<'a>(table: &'a Table, name: &str) -> &'a Values {
    let names: Vec<&str> = table.columns().iter().map(|column| column.name()).collect();
    table.column(name).unwrap_or_else(|| panic!("no column {name} among {names:?}")).values()
}
