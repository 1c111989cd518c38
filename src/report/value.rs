//! Which value of which question is meant by a name such as `torsion.modes.1.frequency`?
//!
//! Question, table, the keys of a row, column: [`super::data`] lists them, and the message on a wrong name lists what there is in its place.

use std::fmt;
use std::str::FromStr;

use num_traits::ToPrimitive;

use super::asked::{ask, questions};
use super::data::{self, tables_of};
use super::question::{Question, Unanswered};
use super::{AngleStudy, AnglesAsked, FlywheelStudy, RotorStudy, document};
use crate::engine::{CycleOrder, Engine};
use crate::file::{Kind, parse_diagram, parse_number, parse_rotor};
use crate::loads::usual_orders;
use crate::sweep::Observer;
use crate::table::{NotNamed, Single, Table};
use crate::text::{Untrusted, harmless};
use crate::verdict::{self, Judgement};

/// The questions that are asked of files of their own.
const OF_FILES: [(&str, Kind); 2] = [("rotor", Kind::Shaft), ("flywheel", Kind::Diagram)];

/// The name of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueName {
    question: &'static str,
    table: &'static str,
    keys: Vec<String>,
    column: String,
}

/// The questions whose values have names.
fn known() -> impl Iterator<Item = &'static str> {
    ["classify"].into_iter().chain(questions()).chain(OF_FILES.map(|(name, _)| name))
}

impl FromStr for ValueName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut parts = text.split('.').map(str::trim);
        let (question, table) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
        let mut keys: Vec<String> = parts.map(str::to_owned).collect();
        let question = known().find(|name| *name == question).ok_or_else(|| {
            let all: Vec<&str> = known().collect();
            format!("no question `{}` has values; there are {}", harmless(question), all.join(", "))
        })?;
        let tables = tables_of(question);
        let table = *tables.iter().find(|name| **name == table).ok_or_else(|| {
            format!("`{question}` has no table `{}`; there are {}", harmless(table), tables.join(", "))
        })?;
        let column = keys.pop().filter(|column| !column.is_empty()).ok_or_else(|| {
            format!("which column of {question}.{table}? docs/data.md lists them; such as torsion.modes.1.frequency")
        })?;
        Ok(ValueName { question, table, keys, column })
    }
}

impl fmt::Display for ValueName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.question, self.table)?;
        self.keys.iter().chain([&self.column]).try_for_each(|part| write!(f, ".{part}"))
    }
}

/// A name of a value as that of a column.
pub(in crate::report) fn column_of(name: &str) -> String {
    name.replace(['.', '/', ' '], "_")
}

impl ValueName {
    /// As the name of a column.
    pub fn column(&self) -> String {
        column_of(&self.to_string())
    }

    /// The file that its question is asked of.
    fn kind(&self) -> Kind {
        OF_FILES.iter().find(|(question, _)| *question == self.question).map_or(Kind::Layout, |(_, kind)| *kind)
    }
}

/// What has values: an engine, or the answer to the question of another file.
#[non_exhaustive]
pub enum Valued<'a> {
    /// An engine.
    Engine(&'a Engine),
    /// What a shaft or a diagram was asked.
    File(Box<dyn Question>),
}

impl Valued<'_> {
    /// The question of a file that is no layout; none of a layout.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn of_file(name: &str, source: &str) -> Result<Option<Self>, Unanswered> {
        Ok(match Kind::of(source) {
            // A layout; what is none is told by its reader.
            Kind::Layout | Kind::Claims => None,
            Kind::Shaft => Some(Valued::File(Box::new(RotorStudy::new(parse_rotor(name, source)?)?))),
            Kind::Diagram => Some(Valued::File(Box::new(FlywheelStudy::new(parse_diagram(name, source)?)?))),
        })
    }

    /// What it is called.
    pub fn title(&self) -> Untrusted {
        match self {
            Valued::Engine(engine) => engine.title().clone(),
            Valued::File(question) => question.title().cloned().unwrap_or_else(|| Untrusted::new("")),
        }
    }

    /// The values of these names, or why there are none. Each question is asked once, and just the tables that are named are made.
    pub fn values(&self, names: &[ValueName]) -> Vec<Result<Single, String>> {
        let mut asking = Asking { of: self, answers: Vec::new(), tables: Vec::new() };
        names.iter().map(|name| asking.value(name)).collect()
    }
}

/// The values of an engine, or why it has none.
pub fn values_of(engine: &Engine, names: &[ValueName]) -> Vec<Result<Single, String>> {
    Valued::Engine(engine).values(names)
}

/// What looks for these values at each point of a sweep, where there are some.
pub fn observer(values: &[ValueName]) -> Option<Observer<'_>> {
    let find = Box::new(|engine: &Engine| values_of(engine, values));
    (!values.is_empty()).then(|| Observer { names: values.iter().map(ValueName::to_string).collect(), find })
}

/// What a name asks for that is not among what a question tells by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Besides {
    Nothing,
    Order(CycleOrder),
    Theta(f64),
}

/// An answer of which tables are taken.
enum Answered {
    Question(Box<dyn Question>),
    Tables(Vec<Table>),
}

/// A question, and what is asked besides.
type Asked = (&'static str, Besides);
/// A question, its table, and what is asked besides.
type AskedTable = (&'static str, &'static str, Besides);

/// Questions with what was answered.
struct Asking<'a> {
    of: &'a Valued<'a>,
    answers: Vec<(Asked, Result<Answered, String>)>,
    tables: Vec<(AskedTable, Option<Table>)>,
}

impl Asking<'_> {
    fn value(&mut self, name: &ValueName) -> Result<Single, String> {
        match self.named(name, Besides::Nothing)? {
            Ok(single) => Ok(single),
            Err(why) => {
                let besides = besides(name, &why);
                let again = besides.and_then(|besides| self.named(name, besides).ok()?.ok());
                again.ok_or_else(|| format!("{}.{}: {why}", name.question, name.table))
            }
        }
    }

    /// The value, or why the table has none; why there is no table.
    fn named(&mut self, name: &ValueName, besides: Besides) -> Result<Result<Single, NotNamed>, String> {
        let table = self.table(name, besides)?;
        let keys: Vec<&str> = name.keys.iter().map(String::as_str).collect();
        Ok(table.named(&keys, &name.column))
    }

    fn table(&mut self, name: &ValueName, besides: Besides) -> Result<&Table, String> {
        let key = (name.question, name.table, besides);
        let place = match self.tables.iter().position(|(made, _)| *made == key) {
            Some(place) => place,
            None => {
                let table = self.made(name, besides)?;
                self.tables.push((key, table));
                self.tables.len() - 1
            }
        };
        let table = self.tables.get(place).and_then(|(_, table)| table.as_ref());
        table.ok_or_else(|| match self.of {
            Valued::Engine(_) => format!("this engine has no table {} of {}", name.table, name.question),
            Valued::File(_) => format!("this file has no table {} of {}", name.table, name.question),
        })
    }

    fn made(&mut self, name: &ValueName, besides: Besides) -> Result<Option<Table>, String> {
        let engine = match (self.of, name.kind()) {
            (Valued::File(question), _) if question.command() == name.question => return Ok(question.table(name.table)),
            (Valued::Engine(engine), Kind::Layout) => *engine,
            (_, Kind::Layout | Kind::Claims) => {
                return Err(format!("`{}` is asked of the layout of an engine", name.question));
            }
            (_, Kind::Shaft) => return Err("`rotor` is asked of a file of masses on a shaft".to_owned()),
            (_, Kind::Diagram) => {
                let of_engine = "the flywheel of an engine is torque.flywheel.inertia";
                return Err(format!("`flywheel` is asked of a file with a turning-moment diagram; {of_engine}"));
            }
        };
        let key = (name.question, besides);
        if !self.answers.iter().any(|(asked, _)| *asked == key) {
            self.answers.push((key, answered(engine, name.question, besides).map_err(|why| why.to_string())));
        }
        match self.answers.iter().find(|(asked, _)| *asked == key) {
            Some((_, Ok(Answered::Question(question)))) => Ok(question.table(name.table)),
            Some((_, Ok(Answered::Tables(tables)))) => {
                Ok(tables.iter().find(|table| table.name() == name.table).cloned())
            }
            Some((_, Err(why))) => Err(why.clone()),
            None => Ok(None),
        }
    }
}

/// The order or the crank angle of a row that a table lacks.
fn besides(name: &ValueName, why: &NotNamed) -> Option<Besides> {
    let NotNamed::Row { key, asked, .. } = why else { return None };
    match key.as_str() {
        "order" => asked.parse().ok().map(Besides::Order),
        "theta" if name.question == "angle" => parse_number(asked).ok()?.to_f64().map(Besides::Theta),
        _ => None,
    }
}

fn answered(engine: &Engine, question: &str, besides: Besides) -> Result<Answered, Unanswered> {
    let orders = match besides {
        Besides::Order(order) => vec![order],
        Besides::Nothing => Vec::new(),
        Besides::Theta(theta) => {
            let asked = AnglesAsked { at: vec![theta], ..AnglesAsked::default() };
            return Ok(Answered::Question(Box::new(AngleStudy::new(engine, &asked)?)));
        }
    };
    if question == "classify" {
        let whole = |order: &CycleOrder| order.is_whole().then(|| order.halves() / 2);
        let orders = match orders.as_slice() {
            [] => usual_orders(engine),
            some => some.iter().filter_map(whole).collect(),
        };
        let quantities = verdict::quantities(engine, engine.has_judged_torque());
        let judged = Judgement::new(engine, &orders, &quantities)?;
        let document = document(engine, judged.masses, &judged.orders, &quantities, None);
        return Ok(Answered::Tables(data::classify(engine, &judged, &document)));
    }
    let answer = ask(question, engine, &orders).ok_or_else(|| format!("no question `{question}`"))?;
    answer.map(Answered::Question)
}
