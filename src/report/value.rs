//! Which value of which question is meant by a name such as `torsion.modes.1.frequency`?
//!
//! Question, table, the keys of a row, column: [`super::data`] lists them, and the message on a wrong name lists what there is in its place.

use std::fmt;
use std::str::FromStr;

use super::data::tables_of;
use super::question::{ask, questions};
use crate::engine::Engine;
use crate::table::{Single, Table};
use crate::text::harmless;

/// The name of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueName {
    question: &'static str,
    table: &'static str,
    keys: Vec<String>,
    column: String,
}

impl FromStr for ValueName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut parts = text.split('.').map(str::trim);
        let (question, table) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
        let mut keys: Vec<String> = parts.map(str::to_owned).collect();
        let known: Vec<&'static str> = questions().collect();
        let question = *known.iter().find(|name| **name == question).ok_or_else(|| {
            format!("no question `{}` has values; there are {}", harmless(question), known.join(", "))
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

impl ValueName {
    /// As the name of a column.
    pub fn column(&self) -> String {
        self.to_string().replace(['.', '/', ' '], "_")
    }

    fn in_table(&self, table: Option<&Table>) -> Result<Single, String> {
        let table = table.ok_or_else(|| format!("this engine has no table {} of {}", self.table, self.question))?;
        let keys: Vec<&str> = self.keys.iter().map(String::as_str).collect();
        table.named(&keys, &self.column).map_err(|error| format!("{}.{}: {error}", self.question, self.table))
    }
}

/// The values of an engine, or why it has none. Each question is asked once, and just the tables that are named are made.
pub fn values_of(engine: &Engine, names: &[ValueName]) -> Vec<Result<Single, String>> {
    let mut answers = Vec::new();
    let mut tables = Vec::new();
    for question in questions().filter(|question| names.iter().any(|name| name.question == *question)) {
        match ask(question, engine, &[]) {
            Some(Ok(answer)) => {
                let wanted =
                    |table: &&&str| names.iter().any(|name| name.question == question && name.table == **table);
                let made =
                    tables_of(question).iter().filter(wanted).map(|table| ((question, *table), answer.table(table)));
                tables.extend(made);
            }
            Some(Err(why)) => answers.push((question, why.to_string())),
            None => {}
        }
    }
    let of = |name: &ValueName| {
        if let Some((_, why)) = answers.iter().find(|(question, _)| *question == name.question) {
            return Err(why.clone());
        }
        let made = tables.iter().find(|(key, _)| *key == (name.question, name.table));
        name.in_table(made.and_then(|(_, table)| table.as_ref()))
    };
    names.iter().map(of).collect()
}
