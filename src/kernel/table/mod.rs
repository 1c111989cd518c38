//! What is a table of data made of, and how is it written for a spreadsheet or a notebook? Columns with a type, a name, a unit and a meaning.
//!
//! A table knows nothing of pages: it is filled once (`report::data`), and every writer here writes the same values.

mod column;
mod csv;
mod inch;
mod json;
mod legible;
mod named;
#[cfg(feature = "parquet")]
mod parquet;
mod stream;
mod unit;
mod unwritable;
mod workbook;
mod write;
#[cfg(feature = "xlsx")]
mod xlsx;

pub use column::{Column, Kind, Values, filled};
pub use csv::{csv, from_rows, rows};
pub use json::Named;
pub use named::{NotNamed, Single, Value};
pub use stream::Stream;
pub use unit::Unit;
pub use unwritable::Unwritable;
pub use workbook::rows as workbook_rows;
pub use write::{DataFile, Format};

/// A table: columns of equal length.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    name: &'static str,
    about: &'static str,
    rows: usize,
    keys: usize,
    columns: Vec<Column>,
}

impl Table {
    /// A table without columns, of this many rows; `about` says what a row is.
    pub fn new(name: &'static str, about: &'static str, rows: usize) -> Self {
        Table { name, about, rows, keys: 1, columns: Vec::new() }
    }

    /// The same whose rows are named by their first `keys` columns; by none where it has one row.
    pub fn keyed(self, keys: usize) -> Self {
        Table { keys, ..self }
    }

    /// How many of its first columns name a row.
    pub fn keys(&self) -> usize {
        self.keys
    }

    /// The same with one more column.
    pub fn with(mut self, column: Column) -> Self {
        self.push(column);
        self
    }

    /// Adds a column; a name that is there already gets a number.
    pub fn push(&mut self, column: Column) {
        let is_there = |name: &str| self.columns.iter().any(|column| column.name() == name);
        let name = column.name().to_owned();
        let numbered = (2_u32..).map(|number| format!("{name}_{number}"));
        let free = [name.clone()].into_iter().chain(numbered).find(|name| !is_there(name));
        let column = column.called(free.unwrap_or(name));
        if column.values().len() != self.rows {
            unreachable!("column {} of {} has a value per row", column.name(), self.name);
        }
        self.columns.push(column);
    }

    /// What it is called among the tables of its question: `orders`.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What a row is.
    pub fn about(&self) -> &'static str {
        self.about
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The columns, from left to right.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Whether both have the same columns, as far as names and types go.
    pub fn has_the_columns_of(&self, other: &Table) -> bool {
        let shape = |table: &Table| -> Vec<(String, Kind)> {
            table.columns().iter().map(|column| (column.name().to_owned(), column.values().kind())).collect()
        };
        shape(self) == shape(other)
    }

    /// The column of this name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name() == name)
    }

    /// The same with its decimals rounded to this many digits: for a file that is to be the same on every machine.
    pub fn rounded(self, digits: usize) -> Self {
        let columns = self.columns.into_iter().map(|column| column.rounded(digits)).collect();
        Table { columns, ..self }
    }
}
