//! What do the rows of a spreadsheet say? One row of a student's table each, whoever the student is.

use super::convention::Convention;
use super::csv::Row;
use super::submission::{Answers, Owner, Record, Submission, not_asked_for};
use crate::claim::student::kept;
use crate::claim::{Filled, SUMS, WrittenAngle, WrittenLength};
use crate::engine::{Engine, HIGHEST_ORDER};
use crate::proof::{Planar, Sense};

/// The columns of a table in lines.
pub(super) const COLUMNS: [&str; 6] = ["sheet", "student", "order", "row", "direct", "reverse"];
/// What stands before the name of a cylinder, and before a key of the convention.
pub(super) const CYLINDER: &str = "cylinder ";
pub(super) const CONVENTION: &str = "convention ";
/// What a column of angles may have behind its name.
const DEGREES: [&str; 5] = ["", "deg", "degree", "degrees", "°"];

pub(super) fn sum_name(quantity: Planar) -> &'static str {
    quantity.choose("sum of forces", "sum of moments")
}

impl Record {
    /// Whether it has no entry: the convention is none.
    pub fn is_empty(&self) -> bool {
        !self.is_too_long && (self.row.starts_with(CONVENTION) || self.values.iter().all(String::is_empty))
    }
}

/// The tables in the rows of a spreadsheet, by whose they are, in the order of their first rows.
pub(super) fn in_rows(rows: Vec<Row>) -> Result<Vec<(Owner, Submission)>, String> {
    let mut rows = rows.into_iter();
    let (number, header) = rows.next().ok_or("the file is empty")?;
    let names = header.iter().map(|column| named(column)).collect::<Vec<_>>();
    let columns = COLUMNS.map(|name| names.iter().position(|(column, _)| column.eq_ignore_ascii_case(name)));
    let [sheet, student, order, row, direct, reverse] = columns;
    let (Some(order), Some(row), Some(direct), Some(reverse), true) =
        (order, row, direct, reverse, sheet.is_some() || student.is_some())
    else {
        return Err(format!("line {number}: the columns are to be {}", COLUMNS.join(", ")));
    };
    if let Some(column) = [direct, reverse].into_iter().find(|column| !DEGREES.contains(&names[*column].1.as_str())) {
        return Err(format!(
            "line {number}: cannot read the column `{}`; its angles are in degrees, or have their unit behind them",
            header[column]
        ));
    }
    let mut tables: Vec<(Owner, Vec<Record>)> = Vec::new();
    for (row_number, fields) in rows {
        let value = |column: usize| fields.get(column).cloned().unwrap_or_default();
        let words = |column: Option<usize>| column.map(value).filter(|words| !words.is_empty());
        let whose = Owner { sheet: words(sheet), student: words(student) };
        let values = [value(direct), value(reverse)];
        let surplus = fields.get(header.len()..).unwrap_or_default();
        let is_too_long = !surplus.is_empty() && values.iter().chain(surplus).any(|words| !words.is_empty());
        let record = Record { row_number, order: value(order), row: value(row), values, is_too_long };
        match tables.iter_mut().find(|(there, _)| *there == whose) {
            Some((_, records)) => records.push(record),
            None => tables.push((whose, vec![record])),
        }
    }
    Ok(tables.into_iter().map(|(whose, records)| (whose, Submission::Rows(records))).collect())
}

/// The name of a column, and the unit that is behind it: `Direct (deg)`, `direct [°]`.
fn named(column: &str) -> (String, String) {
    let (name, unit) = column.split_once(['(', '[']).unwrap_or((column, ""));
    (name.trim().to_owned(), unit.trim().trim_end_matches([')', ']']).trim().to_lowercase())
}

/// What is filled in, of these orders. A row that says nothing of their tables costs itself and no other.
pub(super) fn answers(records: &[Record], engine: &Engine, orders: &[u32]) -> Result<Answers, String> {
    let mut answers = Answers { convention: Convention::default(), tables: Vec::new(), not_read: Vec::new() };
    for Record { row_number, order, row, values, is_too_long } in records {
        let wrong = |message: String, right: &str| format!("line {row_number}: {message}; {right}");
        if *is_too_long {
            let message = "more cells than the first line has columns".to_owned();
            answers.not_read.push(wrong(message, "a decimal comma stands in quotes, as in \"6,32\""));
            continue;
        }
        if let Some(key) = row.strip_prefix(CONVENTION) {
            let declared = answers.convention.declare(key.trim(), &values[0], engine);
            declared.map_err(|right| wrong(format!("cannot read the {key} `{}`", values[0]), &right))?;
            continue;
        }
        let Some(number) = order.parse().ok().filter(|number| (1..=HIGHEST_ORDER).contains(number)) else {
            answers.not_read.push(wrong(format!("cannot read the order `{order}`"), "a whole number, such as 1"));
            continue;
        };
        if let Some((message, right)) = not_asked_for(number, orders) {
            answers.not_read.push(wrong(message, &right));
            continue;
        }
        let name = row.strip_prefix(CYLINDER).unwrap_or(row).trim();
        let index = engine.cylinders().iter().position(|cylinder| cylinder.name == name);
        let quantity = SUMS.into_iter().find(|quantity| sum_name(*quantity) == row);
        if quantity.is_none() && index.is_none() {
            let right = "cylinder and its name, sum of forces, or sum of moments";
            answers.not_read.push(wrong(format!("`{row}` is not a row of the table"), right));
            continue;
        }
        let place = answers.tables.iter().position(|(there, _)| *there == number);
        let place = place.unwrap_or_else(|| {
            answers.tables.push((number, Filled::default()));
            answers.tables.len() - 1
        });
        let table = &mut answers.tables[place].1;
        let is_there = match (quantity, index) {
            (Some(quantity), _) => table.sums.iter().any(|(there, ..)| *there == quantity),
            (None, Some(index)) => table.phases.iter().any(|(there, ..)| *there == index),
            (None, None) => false,
        };
        if is_there {
            return Err(wrong(format!("`{row}` of order {number} is repeated"), "one line per row"));
        }
        for (sense, words) in Sense::BOTH.into_iter().zip(values).filter(|(_, words)| !words.is_empty()) {
            match (quantity, index) {
                (Some(quantity), _) => table.sums.push((quantity, sense, kept(words, WrittenLength::read(words)))),
                (None, Some(index)) => table.phases.push((index, sense, kept(words, WrittenAngle::read(words)))),
                (None, None) => {}
            }
        }
    }
    Ok(answers)
}
