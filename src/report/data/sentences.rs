//! What does a row of a table tell, and each column? `columns.txt` says it, a line each.
//!
//! A table begins with `[question.table]` and what a row of it is. A line `name: what it tells` is about a column, by its name with the holes in it,
//! or by the name as it is filled where several columns have one pattern. `as question.table` stands for the lines of another table that it lacks.

use std::sync::LazyLock;

use crate::table::{Unit, filled};

const COLUMNS: &str = include_str!("columns.txt");

/// The questions that have tables, each with the names of all tables that its answer may have, the main one first.
pub static TABLES: LazyLock<Vec<(&str, Vec<&str>)>> = LazyLock::new(|| {
    let mut questions: Vec<(&str, Vec<&str>)> = Vec::new();
    for (question, table) in sections().filter_map(|(path, _)| path.split_once('.')) {
        match questions.last_mut() {
            Some((last, tables)) if *last == question => tables.push(table),
            _ => questions.push((question, vec![table])),
        }
    }
    questions
});

/// What a row of a table is.
pub(super) fn of_row(table: &str) -> &'static str {
    section(table).map_or("", |(about, _)| about)
}

/// What a column of a table tells.
pub(super) fn of_column(table: &str, pattern: &str, holes: &[&str], unit: Unit) -> &'static str {
    let name = filled(pattern, holes, unit);
    line(table, &name).or_else(|| line(table, pattern)).unwrap_or_default()
}

/// The first line and the others of a table.
fn section(table: &str) -> Option<(&'static str, &'static str)> {
    let (_, section) = sections().find(|(path, _)| *path == table)?;
    Some(section.split_once('\n').unwrap_or((section, "")))
}

/// The paths of all tables, each with the lines below it.
fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    COLUMNS.split("\n\n").filter_map(|section| section.strip_prefix('[')?.split_once("] "))
}

fn line(table: &str, name: &str) -> Option<&'static str> {
    let (_, lines) = section(table)?;
    let own = lines.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "));
    own.or_else(|| lines.lines().filter_map(|line| line.strip_prefix("as ")).find_map(|other| line(other, name)))
}
