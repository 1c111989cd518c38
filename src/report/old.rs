//! What do the pages need that are not made of blocks yet?

use serde::Serialize;

use super::dialect::Dialect;

/// Header and rows of plain text.
pub struct Rows {
    /// Headings.
    pub header: Vec<String>,
    /// Cells.
    pub rows: Vec<Vec<String>>,
}

/// A table: every row has as many cells as the header.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// Headings of the columns.
    pub header: Vec<String>,
    /// The cells.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Sets a table; the cells are prose.
    pub(super) fn new(dialect: Dialect, header: &[&str], rows: Vec<Vec<String>>) -> Self {
        let set = |cells: Vec<String>| cells.iter().map(|cell| dialect.prose(cell)).collect();
        Table {
            header: header.iter().map(|cell| dialect.prose(cell)).collect(),
            rows: rows.into_iter().map(set).collect(),
        }
    }
}

pub(super) fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
