//! Which values have these engines? A row an engine, a column a value, and why one has none.

use super::data::{Filling, fitting, value_columns};
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

/// A value below a heading with the unit of `like`.
pub(in crate::report) fn cell(value: &Result<Single, String>, like: Option<&Single>) -> Text {
    fitting(value, like).map_or_else(|_| NO_VALUE.into(), |single| shown(single, Text::measured))
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
        let units = (0..self.names.len()).map(|place| self.like(place).map_or(Unit::NONE, |like| like.unit));
        let headings = self.names.iter().zip(units).map(|(name, unit)| heading(&name.to_string(), unit));
        let mut table = Shown::new([Text::from("Engine")].into_iter().chain(headings));
        for (title, values) in &self.rows {
            let cells = values.iter().enumerate().map(|(place, value)| cell(value, self.like(place)));
            table.push([Text::from(title)].into_iter().chain(cells).collect());
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
            value_columns(&name.column(), self.like(place), &all).into_iter().for_each(|column| table.push(column));
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

    /// The first value of a name, whose unit the others have to have; none where no engine has it.
    fn like(&self, place: usize) -> Option<&Single> {
        self.rows.iter().find_map(|(_, values)| values.get(place)?.as_ref().ok())
    }

    /// Why values are missing, each reason of an engine once.
    fn missing(&self) -> Vec<Text> {
        let mut reasons = Vec::new();
        for (title, values) in &self.rows {
            let mut missing: Vec<(String, Vec<&ValueName>)> = Vec::new();
            for (place, (name, value)) in self.names.iter().zip(values).enumerate() {
                let Err(why) = fitting(value, self.like(place)) else { continue };
                match missing.iter_mut().find(|(other, _)| *other == why) {
                    Some((_, names)) => names.push(name),
                    None => missing.push((why, vec![name])),
                }
            }
            for (why, names) in missing {
                let names = Text::joined(names.into_iter().map(|name| Text::code(name.to_string())), ", ");
                reasons.push(phrase!("{} has no {}: {}.", title, names, Text::label(why)));
            }
        }
        reasons
    }
}

question!(ValuesStudy, "values", |_| None, ValuesStudy::named, ValuesStudy::document, ValuesStudy::document, {});
