//! How does a file of pressures read? Lines of cells as spreadsheets and indicating systems write them: an angle, then a pressure or
//! several, below a header that may name columns and units.

use std::borrow::Cow;
use std::ops::Range;

use super::error::LayoutError;
use super::units::{self, PressureUnit};
use crate::engine::MOST_ROWS;
use crate::text::counted;

/// What stands between cells, the first that fits: a comma may be a decimal one beside the others. A blank stands for any number of them.
const SEPARATORS: [char; 4] = [';', '\t', ',', ' '];

/// The lines of a file.
pub(super) struct Sheet<'a> {
    /// What the header says of the columns after the angle, as far as it goes.
    pub columns: Vec<Heading>,
    /// Lines of numbers, of as many cells each.
    pub rows: Vec<Row<'a>>,
}

/// What stands over a column.
#[derive(Clone, Default)]
pub(super) struct Heading {
    /// All words over it.
    pub words: Vec<String>,
    /// The unit of pressure among them, by its name.
    pub unit: Option<(&'static str, PressureUnit)>,
    /// Where the first line of the header is that has this column.
    pub span: Option<Range<usize>>,
}

/// A line of numbers.
pub(super) struct Row<'a> {
    /// Where it stands.
    pub span: Range<usize>,
    /// Its cells, the angle first.
    pub cells: Vec<&'a str>,
}

/// Reads the lines of a file, two cells or more each; lines after `#` are passed over.
pub(super) fn read(text: &str) -> Result<Sheet<'_>, LayoutError> {
    let lines = || {
        let mut start = 0;
        text.split_inclusive('\n').filter_map(move |line| {
            let from = start;
            start += line.len();
            let is_said = !line.trim().is_empty() && !line.trim_start().starts_with('#');
            is_said.then(|| (from..from + line.trim_end().len(), line.trim_end_matches(['\r', '\n'])))
        })
    };
    let fits = |line: &str| SEPARATORS.into_iter().find(|&sign| is_of_numbers(&cells(line, sign)));
    let separator = lines().find_map(|(_, line)| fits(line)).unwrap_or(',');
    let mut sheet = Sheet { columns: Vec::new(), rows: Vec::new() };
    for (span, line) in lines() {
        let cells = cells(line, separator);
        let begins = cells.first().is_some_and(|cell| units::angle(&decimal(cell)).is_ok());
        if sheet.rows.is_empty() && !begins {
            sheet.head(&cells, &span)?;
            continue;
        }
        let width = sheet.rows.first().map_or(cells.len(), |row| row.cells.len());
        if cells.len() != width || width < 2 {
            let right = match width {
                0..=2 => "two: the angle and the pressure".to_owned(),
                _ => format!("{width}, as in the first line of numbers: the angle, and a pressure in each column"),
            };
            return Err(LayoutError::new(format!("a line of {}", counted(cells.len(), "cell")), right, Some(span)));
        }
        if sheet.rows.len() >= MOST_ROWS {
            let message = format!("more than {MOST_ROWS} rows");
            return Err(LayoutError::new(message, "one cycle, averaged", Some(span)));
        }
        sheet.rows.push(Row { span, cells });
    }
    match sheet.rows.is_empty() && lines().next().is_some() {
        true if text.starts_with("PK\u{3}\u{4}") => {
            Err(LayoutError::new("a workbook in place of a table", "save its sheet as CSV", None))
        }
        true => Err(LayoutError::new("no line of the table begins with an angle", "lines such as -360;1.05", None)),
        false => Ok(sheet),
    }
}

impl Sheet<'_> {
    /// Takes a line of the header: names, or units.
    fn head(&mut self, cells: &[&str], span: &Range<usize>) -> Result<(), LayoutError> {
        let words = |cell: &str| -> Vec<String> {
            cell.split(|letter: char| !letter.is_alphanumeric())
                .filter(|word| !word.is_empty())
                .map(str::to_owned)
                .collect()
        };
        if cells.len() > 1 && cells.first().is_some_and(|cell| words(cell).iter().any(|word| word == "rad")) {
            let right = "crank angles in degrees, or in turns with the unit behind each";
            return Err(LayoutError::new("angles in radians", right, Some(span.clone())));
        }
        for (place, cell) in cells.iter().skip(1).enumerate() {
            if self.columns.len() <= place {
                self.columns.resize(place + 1, Heading::default());
            }
            let heading = &mut self.columns[place];
            let words = words(cell);
            heading.unit = heading.unit.or_else(|| words.iter().find_map(|word| units::pressure_unit_named(word)));
            heading.words.extend(words);
            heading.span = Some(span.clone());
        }
        Ok(())
    }
}

/// The cells of a line, without quotes and without empty ones at its end.
fn cells(line: &str, separator: char) -> Vec<&str> {
    let mut is_quoted = false;
    let ends = |letter: char| {
        is_quoted ^= letter == '"';
        letter == separator && !is_quoted
    };
    let mut cells: Vec<&str> = match separator {
        ' ' => line.split_whitespace().collect(),
        _ => line.split(ends).map(str::trim).collect(),
    };
    while cells.len() > 1 && cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells.into_iter().map(|cell| cell.trim_matches('"').trim()).collect()
}

fn is_of_numbers(cells: &[&str]) -> bool {
    let is_pressure = |cell: &&str| units::pressure(&decimal(cell), Some((1, 1))).is_ok();
    let is_angle = cells.first().is_some_and(|cell| units::angle(&decimal(cell)).is_ok());
    is_angle && cells.len() > 1 && cells[1..].iter().all(is_pressure)
}

/// A number with a decimal comma as one with a point. Where commas stand between cells, none is left in them but within quotes.
pub(super) fn decimal(cell: &str) -> Cow<'_, str> {
    match cell.matches(',').count() == 1 && !cell.contains('.') {
        true => Cow::Owned(cell.replace(',', ".")),
        false => Cow::Borrowed(cell),
    }
}
