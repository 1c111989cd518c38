//! How are pressures written down? Rows of angle and pressure, in the layout file or in a CSV file beside it.

use std::ops::Range;

use num_rational::BigRational;
use serde_spanned::Spanned;

use super::beside::Beside;
use super::error::LayoutError;
use super::quantities::misread;
use super::units::{self, PressureUnit};
use super::written::{Text, place};
use crate::engine::{At, Cycle, GasMistake, MOST_ROWS, PressureTable};

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

/// The rows that stand in the layout file.
pub(super) fn inline(list: &Rows, reading: &Reading, cycle: Cycle) -> Result<PressureTable, LayoutError> {
    let mut rows = Vec::new();
    for row in list.get_ref() {
        let [angle, pressure] = row.get_ref().as_slice() else {
            let message = format!("a row of {} values", row.get_ref().len());
            return Err(LayoutError::new(message, "two: the angle and the pressure", place(row)));
        };
        let cell = |what, text: &Text, read: Result<BigRational, String>| {
            read.map_err(|right| misread(what, &text.get_ref().0, right, text))
        };
        let turns = cell("angle", angle, units::angle(&angle.get_ref().0))?;
        rows.push((turns, cell("pressure", pressure, reading.pressure(&pressure.get_ref().0))?));
    }
    let places: Vec<Range<usize>> = list.get_ref().iter().map(Spanned::span).collect();
    PressureTable::new(rows, cycle).map_err(|mistake| told(mistake, &places, place(list)))
}

/// The rows of a file beside the layout.
pub(super) fn beside(
    path: &Text,
    beside: Beside<'_>,
    reading: &Reading,
    cycle: Cycle,
) -> Result<PressureTable, LayoutError> {
    let name = &path.get_ref().0;
    let text = beside.read(name).map_err(|right| {
        let shown: String = name.chars().take(60).collect();
        LayoutError::new(format!("cannot read the table `{shown}`"), right, place(path))
    })?;
    csv(&text, reading, cycle).map_err(|error| error.in_file(name, &text))
}

/// Lines of two cells between commas, semicolons, tabs or blanks; a first line of words and lines after `#` are passed over.
fn csv(text: &str, reading: &Reading, cycle: Cycle) -> Result<PressureTable, LayoutError> {
    let mut rows = Vec::new();
    let mut places = Vec::new();
    let mut start = 0;
    let mut may_be_head = true;
    for line in text.split_inclusive('\n') {
        let (from, cells) = (start, line.trim().trim_start_matches('\u{feff}'));
        start += line.len();
        if cells.is_empty() || cells.starts_with('#') {
            continue;
        }
        let span = from..from + line.trim_end().len();
        let separator = [';', '\t', ','].into_iter().find(|&sign| cells.contains(sign));
        let cells: Vec<&str> = match separator {
            Some(sign) => cells.split(sign).map(str::trim).collect(),
            None => cells.split_whitespace().collect(),
        };
        let is_head = std::mem::take(&mut may_be_head) && cells.iter().all(|cell| is_word(cell));
        if is_head {
            continue;
        }
        let [angle, pressure] = cells.as_slice() else {
            let message = format!("a line of {} cells", cells.len());
            let right = "two: the angle and the pressure, with decimal points";
            return Err(LayoutError::new(message, right, Some(span)));
        };
        if rows.len() >= MOST_ROWS {
            let message = format!("more than {MOST_ROWS} rows");
            return Err(LayoutError::new(message, "one cycle, averaged", Some(span)));
        }
        let cell = |what: &str, cell: &str, read: Result<BigRational, String>| {
            read.map_err(|right| {
                let shown: String = cell.chars().take(40).collect();
                let right = if cell.contains(',') { "a decimal point, no comma".to_owned() } else { right };
                LayoutError::new(format!("cannot read the {what} `{shown}`"), right, Some(span.clone()))
            })
        };
        rows.push((
            cell("angle", angle, units::angle(angle))?,
            cell("pressure", pressure, reading.pressure(pressure))?,
        ));
        places.push(span);
    }
    PressureTable::new(rows, cycle).map_err(|mistake| told(mistake, &places, places.first().cloned()))
}

/// Whether a cell names a column: it has no digit, or none before its letters.
fn is_word(cell: &str) -> bool {
    cell.starts_with(|letter: char| letter.is_alphabetic() || letter == '"') && units::angle(cell).is_err()
}

fn told(mistake: GasMistake, rows: &[Range<usize>], all: Option<Range<usize>>) -> LayoutError {
    let span = match mistake.at {
        At::Row(index) => rows.get(index).cloned().or(all),
        At::All | At::Setting(_) => all,
    };
    LayoutError::new(mistake.message, mistake.right, span)
}
