//! How is a table filled? From rows of what is known, a column at a time; `columns.txt` says what each column tells.

use super::cells::{decimals, truths, whole};
use super::sentences;
use crate::table::{Column, Table, Unit, Values};
use crate::text::Untrusted;

/// A table, and the rows that its columns are read from.
pub struct Filling<R> {
    rows: Vec<R>,
    path: &'static str,
    table: Table,
}

/// The pattern of a name with what fills its holes.
pub struct Name(&'static str, Vec<String>);

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

impl<G: ToString, H: ToString> From<(&'static str, G, H)> for Name {
    fn from((pattern, first, second): (&'static str, G, H)) -> Self {
        Name(pattern, vec![first.to_string(), second.to_string()])
    }
}

impl<R> Filling<R> {
    /// A table by its place in `columns.txt`: the question, a point, its name.
    pub fn new(path: &'static str, rows: impl IntoIterator<Item = R>) -> Self {
        let name = path.split_once('.').map_or(path, |(_, name)| name);
        let rows: Vec<R> = rows.into_iter().collect();
        let table = Table::new(name, sentences::of_row(path), rows.len());
        Filling { rows, path, table }
    }

    /// The same whose rows are named by their first `keys` columns; by none where it has one row.
    pub fn keyed(self, keys: usize) -> Self {
        Filling { table: self.table.keyed(keys), ..self }
    }

    /// The table.
    pub fn done(self) -> Table {
        self.table
    }

    /// The table; none where it has no rows.
    pub fn done_if_any(self) -> Option<Table> {
        (!self.rows.is_empty()).then_some(self.table)
    }

    fn add(&mut self, name: impl Into<Name>, unit: Unit, values: Values) {
        let Name(pattern, holes) = name.into();
        let holes: Vec<&str> = holes.iter().map(String::as_str).collect();
        self.table.push(Column::named(
            pattern,
            &holes,
            unit,
            sentences::of_column(self.path, pattern, &holes, unit),
            values,
        ));
    }

    /// A column of decimals.
    pub fn decimal(&mut self, name: impl Into<Name>, unit: Unit, of: impl Fn(&R) -> Option<f64>) {
        self.add(name, unit, decimals(self.rows.iter().map(of)));
    }

    /// A column of whole numbers.
    pub fn whole(&mut self, name: impl Into<Name>, of: impl Fn(&R) -> usize) {
        self.add(name, Unit::NONE, whole(self.rows.iter().map(of)));
    }

    /// A column of whole numbers that some rows lack.
    pub fn maybe_whole(&mut self, name: impl Into<Name>, of: impl Fn(&R) -> Option<usize>) {
        let values = self.rows.iter().map(|row| of(row).and_then(|number| number.try_into().ok()));
        self.add(name, Unit::NONE, Values::Integer(values.collect()));
    }

    /// A column of true and false.
    pub fn truth(&mut self, name: impl Into<Name>, of: impl Fn(&R) -> Option<bool>) {
        self.add(name, Unit::NONE, truths(self.rows.iter().map(of)));
    }

    /// A column of words.
    pub fn words(&mut self, name: impl Into<Name>, of: impl Fn(&R) -> Option<String>) {
        self.add(name, Unit::NONE, Values::Words(self.rows.iter().map(of).collect()));
    }

    /// A column of exact numbers, as text.
    pub fn exact(&mut self, name: impl Into<Name>, unit: Unit, of: impl Fn(&R) -> Option<String>) {
        self.add(name, unit, Values::Exact(self.rows.iter().map(of).collect()));
    }

    /// A column of what a person wrote.
    pub fn person(&mut self, name: impl Into<Name>, of: impl Fn(&R) -> Option<Untrusted>) {
        self.add(name, Unit::NONE, Values::Person(self.rows.iter().map(of).collect()));
    }
}
