//! How are pressures written down? Rows of angle and pressure, in the layout file or in a CSV file beside it.

use std::ops::Range;

use num_rational::BigRational;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::file_resolver::FileResolver;
use super::pressure_csv::{self, Heading, Sheet, decimal};
use super::quantities::misread;
use super::units::{self, PressureUnit};
use super::written::{Text, place};
use crate::engine::{At, Cycle, GasMistake, PressureTable};
use crate::text::counted;

/// Rows in the layout file.
pub(super) type Rows = Spanned<Vec<Spanned<Vec<Text>>>>;

/// How the pressures of a table are meant.
pub(super) struct Reading {
    /// The unit of those that have none.
    pub unit: Option<PressureUnit>,
    /// What is added to each: ambient pressure, where they are measured from it.
    pub added: BigRational,
}

impl Reading {
    fn pressure(&self, text: &str) -> Result<BigRational, String> {
        Ok(units::pressure(text, self.unit)? + &self.added)
    }
}

/// The rows that are in the layout file.
pub(super) fn inline(list: &Rows, reading: &Reading, cycle: Cycle) -> Result<PressureTable, LayoutError> {
    let mut rows = Vec::new();
    for row in list.get_ref() {
        let [angle, pressure] = row.get_ref().as_slice() else {
            let message = format!("a row of {}", counted(row.get_ref().len(), "value"));
            return Err(LayoutError::new(message, "two: the angle and the pressure", place(row)));
        };
        let cell =
            |what, text: &Text, read: Result<BigRational, String>| read.map_err(|right| misread(text, what, right));
        let turns = cell("angle", angle, units::angle(&angle.get_ref().0))?;
        rows.push((turns, cell("pressure", pressure, reading.pressure(&pressure.get_ref().0))?));
    }
    let places: Vec<Range<usize>> = list.get_ref().iter().map(Spanned::span).collect();
    PressureTable::new(rows, cycle).map_err(|mistake| told(mistake, &places, place(list)))
}

/// The tables of a file beside the layout: one of all cylinders, or as many as there are, in their order.
pub(super) fn beside(
    path: &Text,
    beside: FileResolver<'_>,
    reading: &Reading,
    (cycle, cylinders): (Cycle, &[String]),
) -> Result<Vec<PressureTable>, LayoutError> {
    let name = &path.get_ref().0;
    let text = beside.read(name).map_err(|right| {
        let shown: String = name.chars().take(60).collect();
        LayoutError::new(format!("cannot read the table `{shown}`"), right, place(path))
    })?;
    let tables = || -> Result<Vec<PressureTable>, LayoutError> {
        let sheet = pressure_csv::read(&text)?;
        let columns = columns(&sheet, cylinders)?;
        columns.into_iter().map(|column| of_column(&sheet, column, reading, cycle)).collect()
    };
    tables().map_err(|error| error.in_file(name, &text))
}

/// Which columns of pressures are meant, from 0 on: the only one, of all cylinders; or one of each, by its name in the header, or in their order
/// where it names none.
fn columns(sheet: &Sheet<'_>, cylinders: &[String]) -> Result<Vec<usize>, LayoutError> {
    let count = sheet.rows.first().map_or(1, |row| row.cells.len() - 1);
    if count == 1 {
        return Ok(vec![0]);
    }
    let is_of = |name: &String, heading: &Heading| {
        let is_name = |word: &String| word == name || word.trim_start_matches(char::is_alphabetic) == name;
        heading.words.iter().any(is_name)
    };
    let named = |name: &String| {
        let mut own =
            (0..count).filter(|&column| sheet.columns.get(column).is_some_and(|heading| is_of(name, heading)));
        own.next().filter(|_| own.next().is_none())
    };
    let by_name: Option<Vec<usize>> = cylinders.iter().map(named).collect();
    if let Some(columns) = by_name {
        return Ok(columns);
    }
    let span = || sheet.rows.first().map(|row| row.span.clone());
    if count != cylinders.len() {
        let message = format!("{count} columns of pressures for {} cylinders", cylinders.len());
        let right = format!("one column of all, one of each, or a header that names one of each: {}", list(cylinders));
        return Err(LayoutError::new(message, right, span()));
    }
    let headings: Vec<Heading> =
        (0..count).map(|column| sheet.columns.get(column).cloned().unwrap_or_default()).collect();
    // What stands over all columns tells none from another.
    let tells = |name: &&String| {
        let over = headings.iter().filter(|heading| is_of(name, heading)).count();
        over > 0 && over < count
    };
    let named: Vec<&String> = cylinders.iter().filter(tells).collect();
    let is_in_order = cylinders.iter().zip(&headings).all(|(name, heading)| is_of(name, heading));
    if named.is_empty() || is_in_order {
        return Ok((0..count).collect());
    }
    let stray = headings.iter().find(|heading| !named.iter().any(|name| is_of(name, heading)));
    let message = match stray {
        Some(heading) if !heading.words.is_empty() && !cylinders.iter().any(|name| is_of(name, heading)) => {
            let shown: String = heading.words.join(" ").chars().take(40).collect();
            format!("the header names some cylinders, and `{shown}` is none")
        }
        _ => "the names of cylinders in the header are not one for each column".to_owned(),
    };
    let right = format!("each name once: {}; or no names, for columns in this order", list(cylinders));
    Err(LayoutError::new(message, right, headings.into_iter().find_map(|heading| heading.span).or_else(span)))
}

/// Names of cylinders.
fn list(cylinders: &[String]) -> String {
    cylinders.iter().take(24).map(String::as_str).collect::<Vec<_>>().join(", ")
}

/// The pressures of one column, in the unit of the layout file or of the header.
fn of_column(sheet: &Sheet<'_>, column: usize, reading: &Reading, cycle: Cycle) -> Result<PressureTable, LayoutError> {
    let headed = sheet.columns.get(column).and_then(|heading| heading.unit);
    if let (Some(unit), Some((name, of_header))) = (reading.unit, headed)
        && unit != of_header
    {
        let message = format!("the header of the table says {name}, and the layout file another unit");
        return Err(LayoutError::new(message, "omit `unit` in the layout file, or correct it", None));
    }
    let reading = Reading { unit: reading.unit.or(headed.map(|(_, unit)| unit)), added: reading.added.clone() };
    let mut rows = Vec::new();
    for row in &sheet.rows {
        let cell = |what: &str, cell: &str, read: Result<BigRational, String>| {
            read.map_err(|right| {
                let shown: String = cell.chars().take(40).collect();
                let right = if cell.contains(';') {
                    "the sign of the lines before between its cells".to_owned()
                } else {
                    right
                };
                LayoutError::new(format!("cannot read the {what} `{shown}`"), right, Some(row.span.clone()))
            })
        };
        let (angle, pressure) = (row.cells[0], row.cells[column + 1]);
        rows.push((
            cell("angle", angle, units::angle(&decimal(angle)))?,
            cell("pressure", pressure, reading.pressure(&decimal(pressure)))?,
        ));
    }
    let places: Vec<Range<usize>> = sheet.rows.iter().map(|row| row.span.clone()).collect();
    PressureTable::new(rows, cycle).map_err(|mistake| told(mistake, &places, places.first().cloned()))
}

fn told(mistake: GasMistake, rows: &[Range<usize>], all: Option<Range<usize>>) -> LayoutError {
    let span = match mistake.at {
        At::Row(index) => rows.get(index).cloned().or(all),
        At::All | At::Setting(_) => all,
    };
    LayoutError::new(mistake.message, mistake.right, span)
}
