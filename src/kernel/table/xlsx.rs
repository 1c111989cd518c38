//! How are tables written as a workbook? A sheet a table, texts as texts, numbers as numbers, and a sheet that tells the columns.

use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format as Style, Workbook, Worksheet, XlsxError};

use super::unwritable::Unwritable;
use super::{Table, Values};
use crate::text;

/// The sheet that tells the columns of all others.
const COLUMNS: &str = "columns";
/// Width of a column of the sheets, in digits.
const WIDTH: f64 = 16.0;

/// The tables as a workbook: the same bytes whenever it is written.
pub(super) fn xlsx(tables: &[Table]) -> Result<Vec<u8>, Unwritable> {
    workbook(tables).map_err(|why| Unwritable::Refused(text::harmless(&why.to_string())))
}

fn workbook(tables: &[Table]) -> Result<Vec<u8>, XlsxError> {
    let mut workbook = Workbook::new();
    // A workbook has to say when it was made: the same for all.
    workbook.set_properties(&DocProperties::new().set_creation_datetime(&ExcelDateTime::from_ymd(2000, 1, 1)?));
    let heading = Style::new().set_bold();
    for table in tables {
        let sheet = workbook.add_worksheet();
        sheet.set_name(table.name())?.set_freeze_panes(1, 0)?;
        for (place, column) in (0_u16..).zip(table.columns()) {
            sheet.write_string_with_format(0, place, column.name(), &heading)?.set_column_width(place, WIDTH)?;
            for row in 0..table.rows() {
                cell(sheet, (u32::try_from(row + 1).unwrap_or(u32::MAX), place), column.values(), row)?;
            }
        }
    }
    columns(workbook.add_worksheet(), &heading, tables)?;
    workbook.save_to_buffer()
}

/// A value in its place; an empty cell where there is none.
fn cell(sheet: &mut Worksheet, (down, right): (u32, u16), values: &Values, row: usize) -> Result<(), XlsxError> {
    match values {
        Values::Words(values) | Values::Exact(values) => {
            if let Some(words) = &values[row] {
                sheet.write_string(down, right, words)?;
            }
        }
        // A cell of text is never a formula, whatever it begins with.
        Values::Person(values) => {
            if let Some(words) = &values[row] {
                sheet.write_string(down, right, words.escaped(text::Format::Plain))?;
            }
        }
        Values::Integer(values) => {
            if let Some(number) = values[row] {
                whole(sheet, (down, right), number)?;
            }
        }
        Values::Decimal(values) => {
            if let Some(number) = values[row].filter(|number| number.is_finite()) {
                sheet.write_number(down, right, number)?;
            }
        }
        Values::Truth(values) => {
            if let Some(truth) = values[row] {
                sheet.write_boolean(down, right, truth)?;
            }
        }
    }
    Ok(())
}

/// A spreadsheet counts in decimals of 53 bits: what is beyond stands as text.
fn whole(sheet: &mut Worksheet, (down, right): (u32, u16), number: i64) -> Result<(), XlsxError> {
    match number.unsigned_abs() <= 1 << 53 {
        true => sheet.write_number(down, right, number as f64)?,
        false => sheet.write_string(down, right, number.to_string())?,
    };
    Ok(())
}

fn columns(sheet: &mut Worksheet, heading: &Style, tables: &[Table]) -> Result<(), XlsxError> {
    sheet.set_name(COLUMNS)?.set_freeze_panes(1, 0)?;
    for (place, (name, width)) in
        (0..).zip([("sheet", WIDTH), ("column", 40.0), ("unit", WIDTH), ("type", WIDTH), ("meaning", 100.0)])
    {
        sheet.write_string_with_format(0, place, name, heading)?.set_column_width(place, width)?;
    }
    let all = tables.iter().flat_map(|table| table.columns().iter().map(move |column| (table, column)));
    for (row, (table, column)) in (1..).zip(all) {
        let told = [table.name(), column.name(), column.unit().name, column.values().kind().name(), column.about()];
        for (place, words) in (0..).zip(told) {
            sheet.write_string(row, place, words)?;
        }
    }
    Ok(())
}
