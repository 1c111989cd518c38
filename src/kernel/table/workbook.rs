//! Which rows has a workbook? Those of its first sheet, numbers to the digits that a spreadsheet shows.

/// A row: its number from 1, and its cells.
type Row = (usize, Vec<String>);

/// The rows of an XLSX file with something in them.
///
/// # Errors
/// Why it cannot be read.
#[cfg(not(feature = "xlsx"))]
pub fn rows(_: &[u8]) -> Result<Vec<Row>, String> {
    Err("this program is built without the feature `xlsx`, which reads workbooks; save the sheet as CSV".to_owned())
}

#[cfg(feature = "xlsx")]
pub use read::rows;

#[cfg(feature = "xlsx")]
mod read {
    use std::io::Cursor;

    use calamine::{DataRef, Reader, Xlsx};

    use super::Row;

    /// Cells beyond this row or column belong to no table of a class.
    const MOST_ROWS: u32 = 1_000_000;
    const MOST_COLUMNS: u32 = 100;
    /// Significant digits of a number: those behind them are roundings of who calculated it.
    const DIGITS: usize = 12;

    /// The rows of an XLSX file with something in them.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn rows(bytes: &[u8]) -> Result<Vec<Row>, String> {
        let fail = |error: calamine::XlsxError| format!("this is not a workbook that can be read: {error}");
        let mut workbook: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(fail)?;
        let first = workbook.sheet_names().into_iter().next().ok_or("the workbook has no sheet")?;
        let mut cells = workbook.worksheet_cells_reader(&first).map_err(fail)?;
        let mut rows: Vec<Row> = Vec::new();
        // Cell by cell: a sheet with something in its last corner has no room as a rectangle.
        while let Some(cell) = cells.next_cell().map_err(fail)? {
            let (row, column) = cell.get_position();
            let text = text(cell.get_value());
            if text.is_empty() {
                continue;
            }
            if row >= MOST_ROWS || column >= MOST_COLUMNS {
                return Err(format!("row {}, column {} is beyond any table of a class", row + 1, column + 1));
            }
            let (row, column) = (row as usize + 1, column as usize);
            if rows.last().is_none_or(|(number, _)| *number != row) {
                rows.push((row, Vec::new()));
            }
            if let Some((_, fields)) = rows.last_mut() {
                fields.resize(fields.len().max(column + 1), String::new());
                fields[column] = text;
            }
        }
        Ok(rows)
    }

    /// What a cell says. A date is none of the numbers that a table asks for, though `1/7` became one.
    fn text(value: &DataRef) -> String {
        match value {
            DataRef::Empty => String::new(),
            DataRef::String(text) => text.clone(),
            DataRef::SharedString(text) => (*text).to_owned(),
            DataRef::Int(number) => number.to_string(),
            DataRef::Float(number) => decimal(*number),
            DataRef::Bool(is) => if *is { "TRUE" } else { "FALSE" }.to_owned(),
            DataRef::DateTime(_) | DataRef::DateTimeIso(_) | DataRef::DurationIso(_) => "a date".to_owned(),
            DataRef::Error(error) => error.to_string(),
        }
    }

    /// A number as a spreadsheet keeps it, rounded to [`DIGITS`] significant digits.
    fn decimal(number: f64) -> String {
        let rounded: f64 = format!("{number:.*e}", DIGITS - 1).parse().unwrap_or(number);
        rounded.to_string()
    }
}
