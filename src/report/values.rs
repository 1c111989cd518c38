//! Which values have these engines? A row an engine, a column a value, and why one has none.

use super::data::{Filling, value_columns};
use super::question::question;
use super::value::{ValueName, values_of};
use crate::engine::Engine;
use crate::page::{Block, Document, Number, Piece, Table as Shown, Text, phrase};
use crate::table::{Single, Table, Unit, Value};
use crate::text::Untrusted;

/// Named values of several engines.
pub struct ValuesStudy {
    /// The names.
    pub names: Vec<ValueName>,
    /// What each layout is called, and its values or why it has none.
    pub rows: Vec<(Untrusted, Vec<Result<Single, String>>)>,
}

/// A value below a heading with its unit.
pub(in crate::report) fn cell(value: &Result<Single, String>) -> Text {
    value.as_ref().map_or_else(|_| NO_VALUE.into(), |single| shown(single, Text::measured))
}

/// A value in a sentence, with its unit.
pub(in crate::report) fn with_unit(value: &Single) -> Text {
    shown(value, |decimal, unit| Piece::Quantity(decimal, unit).into())
}

const NO_VALUE: &str = "–";

/// A value, a decimal with a unit as `measured` writes it.
fn shown(single: &Single, measured: impl Fn(f64, Unit) -> Text) -> Text {
    match single.value() {
        None => NO_VALUE.into(),
        Some(Value::Decimal(0.0)) => Text::label("0"),
        Some(Value::Decimal(decimal)) if single.unit == Unit::NONE => Number::Decimal(decimal).into(),
        Some(Value::Decimal(decimal)) => measured(decimal, single.unit),
        Some(Value::Person(text)) => Piece::Person(text.clone()).into(),
        Some(other) => Text::label(other.to_string()),
    }
}

/// The name of a value with the unit that its cells are in.
pub(in crate::report) fn heading(name: &str, unit: Unit) -> Text {
    let name = Text::code(name);
    if unit == Unit::NONE { name } else { phrase!("{} in {}", name, unit) }
}

impl ValuesStudy {
    /// Those of engines beside another answer; none where no values are asked for.
    pub fn beside<'a>(engines: impl IntoIterator<Item = (Untrusted, &'a Engine)>, names: &[ValueName]) -> Option<Self> {
        let rows = engines.into_iter().map(|(title, engine)| (title, values_of(engine, names)));
        (!names.is_empty()).then(|| ValuesStudy { names: names.to_vec(), rows: rows.collect() })
    }

    fn shown(&self) -> Shown {
        let headings = self.names.iter().map(|name| heading(&name.to_string(), self.unit(name)));
        let mut table = Shown::new([Text::from("Engine")].into_iter().chain(headings));
        for (title, values) in &self.rows {
            table.push([Text::from(title)].into_iter().chain(values.iter().map(cell)).collect());
        }
        table
    }

    /// The values, and why some are missing.
    pub(in crate::report) fn blocks(&self) -> impl Iterator<Item = Block> {
        [self.shown().into()].into_iter().chain(self.missing().into_iter().map(Block::Note))
    }

    /// The columns of the values, and beside each why an engine has none, behind those of a table with the same rows.
    pub(in crate::report) fn columns_into(&self, table: &mut Table) {
        for (place, name) in self.names.iter().enumerate() {
            let all: Vec<&Result<Single, String>> = self.rows.iter().map(|(_, values)| &values[place]).collect();
            let first = all.iter().find_map(|one| one.as_ref().ok());
            value_columns(&name.column(), first, &all).into_iter().for_each(|column| table.push(column));
        }
    }

    fn named(&self, name: &str) -> Option<Table> {
        (name == "values").then(|| self.data())
    }

    fn document(&self) -> Document {
        let mut document = Document::new("values", "Values");
        document.blocks.extend(self.blocks());
        document
    }

    fn data(&self) -> Table {
        let mut table = Filling::new("values.values", &self.rows);
        table.person("engine", |(name, _)| Some(name.clone()));
        let mut table = table.done();
        self.columns_into(&mut table);
        table
    }

    /// What a value is counted in, where some engine has it.
    fn unit(&self, name: &ValueName) -> Unit {
        let place = self.names.iter().position(|other| other == name);
        let of = |values: &Vec<Result<Single, String>>| values.get(place?)?.as_ref().ok().map(|one| one.unit);
        self.rows.iter().find_map(|(_, values)| of(values)).unwrap_or(Unit::NONE)
    }

    /// Why values are missing, each reason of an engine once.
    fn missing(&self) -> Vec<Text> {
        let mut reasons = Vec::new();
        for (title, values) in &self.rows {
            let missing =
                || self.names.iter().zip(values).filter_map(|(name, value)| Some((name, value.as_ref().err()?)));
            let of_all: Vec<&String> = missing().map(|(_, why)| why).collect();
            for (place, (_, why)) in missing().enumerate() {
                if !of_all[..place].contains(&why) {
                    let names = missing().filter(|(_, other)| *other == why);
                    let names = Text::joined(names.map(|(name, _)| Text::code(name.to_string())), ", ");
                    reasons.push(phrase!("{} has no {}: {}.", title, names, Text::label(why)));
                }
            }
        }
        reasons
    }
}

question!(ValuesStudy, "values", |_| None, ValuesStudy::named, ValuesStudy::document, ValuesStudy::document, {});
