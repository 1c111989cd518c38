//! How is a table filled? From rows of what is known, a column at a time.

use super::cells::{decimals, truths, whole};
use crate::table::{Column, Table, Unit, Values};
use crate::text::Untrusted;

/// A table, and the rows that its columns are read from.
pub(super) struct Filling<'a, R> {
    rows: &'a [R],
    table: Table,
}

/// The pattern of a name with what fills its holes.
pub(super) struct Name(&'static str, Vec<String>);

impl From<&'static str> for Name {
    fn from(pattern: &'static str) -> Self {
        Name(pattern, Vec::new())
    }
}

impl<H: ToString> From<(&'static str, H)> for Name {
    fn from((pattern, hole): (&'static str, H)) -> Self {
        Name(pattern, vec![hole.to_string()])
    }
}

impl<'a, R> Filling<'a, R> {
    /// A table of this name, in which `about` says what a row is.
    pub fn new(name: &'static str, about: &'static str, rows: &'a [R]) -> Self {
        Filling { rows, table: Table::new(name, about, rows.len()) }
    }

    /// The same whose rows are named by their first `keys` columns; by none where it has one row.
    pub fn keyed(self, keys: usize) -> Self {
        Filling { table: self.table.keyed(keys), ..self }
    }

    /// The table.
    pub fn done(self) -> Table {
        self.table
    }

    fn add(&mut self, name: impl Into<Name>, unit: Unit, about: &'static str, values: Values) {
        let Name(pattern, holes) = name.into();
        let holes: Vec<&str> = holes.iter().map(String::as_str).collect();
        self.table.push(Column::named(pattern, &holes, unit, about, values));
    }

    /// A column of decimals.
    pub fn decimal(&mut self, name: impl Into<Name>, unit: Unit, about: &'static str, of: impl Fn(&R) -> Option<f64>) {
        self.add(name, unit, about, decimals(self.rows.iter().map(of)));
    }

    /// A column of whole numbers.
    pub fn whole(&mut self, name: impl Into<Name>, about: &'static str, of: impl Fn(&R) -> usize) {
        self.add(name, Unit::NONE, about, whole(self.rows.iter().map(of)));
    }

    /// A column of whole numbers that some rows lack.
    pub fn maybe_whole(&mut self, name: impl Into<Name>, about: &'static str, of: impl Fn(&R) -> Option<usize>) {
        let values = self.rows.iter().map(|row| of(row).and_then(|number| number.try_into().ok()));
        self.add(name, Unit::NONE, about, Values::Integer(values.collect()));
    }

    /// A column of true and false.
    pub fn truth(&mut self, name: impl Into<Name>, about: &'static str, of: impl Fn(&R) -> Option<bool>) {
        self.add(name, Unit::NONE, about, truths(self.rows.iter().map(of)));
    }

    /// A column of words.
    pub fn words(&mut self, name: impl Into<Name>, about: &'static str, of: impl Fn(&R) -> Option<String>) {
        self.add(name, Unit::NONE, about, Values::Words(self.rows.iter().map(of).collect()));
    }

    /// A column of exact numbers, as text.
    pub fn exact(&mut self, name: impl Into<Name>, unit: Unit, about: &'static str, of: impl Fn(&R) -> Option<String>) {
        self.add(name, unit, about, Values::Exact(self.rows.iter().map(of).collect()));
    }

    /// A column of what a person wrote.
    pub fn person(&mut self, name: impl Into<Name>, about: &'static str, of: impl Fn(&R) -> Option<Untrusted>) {
        self.add(name, Unit::NONE, about, Values::Person(self.rows.iter().map(of).collect()));
    }
}
