//! How is a statement on every order put into words?

use serde::Serialize;

use super::dialect::Dialect;
use super::table::{self, Table};
pub(super) use super::theorem_words::{first_survivors, no_theorem, statements, why};
use crate::engine::Engine;
use crate::verdict::{NoTheorem, Theorem};

/// Longer tables of one period are left out.
const MOST_ROWS: usize = 24;

/// The section on every order: the statements, why one period proves them, and the period.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Section {
    statements: Vec<String>,
    why: String,
    table: Option<Table>,
}

impl Section {
    /// Sets the section in a dialect.
    pub fn new(engine: &Engine, theorem: &Result<Theorem, NoTheorem>, dialect: Dialect) -> Self {
        let theorem = match theorem {
            Ok(theorem) => theorem,
            Err(reason) => {
                return Section { statements: Vec::new(), why: dialect.text(&no_theorem(reason)), table: None };
            }
        };
        let rows = theorem.force.direct.len();
        Section {
            statements: statements(engine, theorem).iter().map(|statement| dialect.text(statement)).collect(),
            why: dialect.text(&why(engine, theorem)),
            table: (rows <= MOST_ROWS).then(|| table::period(dialect, theorem)),
        }
    }
}
