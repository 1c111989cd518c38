//! Workbooks and Parquet files: do they hold what CSV holds, and is what a class hands in as a workbook read?
//!
//! They need the features `xlsx` and `parquet`: `cargo test --features xlsx,parquet --test tables`. The two that are ignored need openpyxl and
//! DuckDB for Python, which `.ci/run` installs.

#![allow(clippy::disallowed_types)]

#[path = "suite/support"]
#[allow(dead_code)]
mod support {
    pub mod class;
    pub mod program;
}

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crankstar::claim::Judged;
use crankstar::classroom::{Exercise, Outcome, Scheme, Vary, mark_class, students};
use crankstar::report::Compared;
use crankstar::table::{Format, Table};
use crankstar::text::Untrusted;
use crankstar::{BigRational, data, file};

use support::class::{bytes, class_file, draw, sheet};
use support::program::{call, program, scratch};

/// A layout with numbers, bearings and gas, and with names that spreadsheets would reckon with.
const LAYOUT: &str = include_str!("../reports/examples/v8-gas/layout.toml");

/// What is asked, and of how many cells there are at least.
const QUESTIONS: [(&[&str], usize); 7] = [
    (&["classify", "LAYOUT", "--torque"], 100),
    (&["loads", "LAYOUT"], 1000),
    (&["bearings", "LAYOUT"], 5000),
    (&["compare", "LAYOUT", "I4", "V6-60-even"], 100),
    (&["search", "--cylinders", "6", "--cycle", "four-stroke", "--torsion"], 20),
    (&["sweep", "LAYOUT", "--bank-angle", "0..180:20/3", "--firing-orders", "1,2"], 1000),
    (&["sweep", "LAYOUT", "--speed", "1000..4000:500"], 200),
];

/// A fresh folder with the layout in it.
fn with_layout(name: &str) -> PathBuf {
    let folder = scratch(name);
    let text = LAYOUT.replace("title = \"Cross-plane V8 with gas\"", "title = '=cmd|\" /C calc\"!A0, \u{202e}V8'");
    assert_ne!(text, LAYOUT);
    fs::write(folder.join("=layout.toml"), text).expect("a layout");
    folder
}

fn write(folder: &Path, asked: &[&str], format: &str, output: &str) {
    let layout = folder.join("=layout.toml");
    let layout = layout.to_str().expect("UTF-8");
    let arguments = asked.iter().map(|word| if *word == "LAYOUT" { layout } else { word });
    let output = folder.join(output);
    let done = program().args(arguments).args(["--format", format, "--output"]).arg(&output).output();
    let done = done.expect("the program starts");
    assert!(done.status.success(), "{asked:?} as {format}: {}", String::from_utf8_lossy(&done.stderr));
}

/// How many cells agree.
fn compared(folder: &Path, question: &str, others: [&str; 2]) -> usize {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tables/compare.py");
    let read = Command::new("python3").current_dir(folder).args([script, "csv", question]).args(others).output();
    let read = read.expect("Python starts");
    let told = String::from_utf8_lossy(&read.stdout);
    assert!(read.status.success(), "{question}: {told}{}", String::from_utf8_lossy(&read.stderr));
    told.trim().parse().expect("a number")
}

#[test]
#[ignore = "needs openpyxl for Python"]
fn a_workbook_holds_for_openpyxl_what_csv_holds_and_no_formula() {
    for (index, (asked, least)) in QUESTIONS.into_iter().enumerate() {
        let folder = with_layout(&format!("data-xlsx-{index}"));
        write(&folder, asked, "csv", "csv");
        write(&folder, asked, "xlsx", "book.xlsx");
        let cells = compared(&folder, asked[0], ["book.xlsx", "-"]);
        assert!(cells >= least, "{asked:?}: {cells} cells");
    }
}

#[test]
#[ignore = "needs DuckDB for Python"]
fn parquet_holds_for_duckdb_what_csv_holds_with_its_types() {
    for (index, (asked, least)) in QUESTIONS.into_iter().enumerate() {
        let folder = with_layout(&format!("data-parquet-{index}"));
        write(&folder, asked, "csv", "csv");
        write(&folder, asked, "parquet", "parquet");
        let cells = compared(&folder, asked[0], ["-", "parquet"]);
        assert!(cells >= least, "{asked:?}: {cells} cells");
    }
}

/// The orders of two engines, as a table.
fn table() -> Vec<Table> {
    let engine = file::find("V6-60-even").expect("a name of the catalogue").engine().expect("it reads");
    data::compare(&["=one", "two"].map(|name| Compared::new(Untrusted::new(name), &engine, &[1, 2]).expect("orders")))
}

#[test]
fn a_workbook_is_the_same_whenever_it_is_written() {
    let tables = table();
    let write = || Format::Xlsx.one_file(&tables).expect("a workbook");
    let first = write();
    // Longer than the seconds in which a file's time is counted.
    std::thread::sleep(std::time::Duration::from_millis(2100));
    assert!(first == write());
    assert!(first.starts_with(b"PK"));
}

#[test]
fn every_format_is_built_and_needs_a_file_where_it_is_no_text() {
    for format in [Format::Xlsx, Format::Parquet, Format::Csv] {
        assert!(format.is_built().is_ok() && format.one_file(&table()[..1]).is_ok(), "{format:?}");
    }
    for format in ["xlsx", "parquet"] {
        let output = call(&["search", "--cylinders", "12", "--cycle", "four-stroke", "--format", format]);
        let told = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{told}");
        assert!(told.contains(&format!("name a file: --output search.{format}")), "{told}");
    }
}

#[test]
fn a_file_to_write_says_by_its_ending_that_it_is_a_workbook_or_parquet() {
    let folder = with_layout("tables-endings");
    for (name, sign) in [("x.xlsx", &b"PK"[..]), ("x.parquet", b"PAR1")] {
        let path = folder.join(name);
        let output =
            call(&["loads".as_ref(), folder.join("=layout.toml").as_os_str(), "--output".as_ref(), path.as_os_str()]);
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(fs::read(&path).expect("a file").starts_with(sign), "{name}");
    }
}

#[test]
fn a_workbook_is_read_and_a_damaged_one_is_refused() {
    let exercise = draw("V6-60-even", "Ada\nJosé Müller", &[1, 2]);
    let results = mark_class(&exercise, vec![bytes("all.xlsx", workbook(&class_file(&exercise)))], &Scheme::default());
    assert_eq!(results.len(), 2, "{results:?}");
    for student in 0..2 {
        assert_eq!(sheet(&results, student).part(), BigRational::from_integer(1.into()), "{results:?}");
    }
    for damaged in [b"PK".to_vec(), Vec::new(), workbook(&[]), workbook(&["a,b".to_owned()])] {
        let results = mark_class(&exercise, vec![bytes("ada.xlsx", damaged)], &Scheme::default());
        assert!(matches!(results[0].outcome, Outcome::Unreadable(_)), "{results:?}");
    }
}

/// What a spreadsheet keeps of these rows: numbers as numbers, a header of its own, an empty row, a cell calculated.
fn workbook(lines: &[String]) -> Vec<u8> {
    let mut workbook = rust_xlsxwriter::Workbook::new();
    let sheet = workbook.add_worksheet();
    for (row, line) in (2..).zip(lines) {
        for (column, cell) in (1..).zip(line.split(',')) {
            let cell = cell.replace("direct", "Direct (deg)").replace("reverse", "Reverse");
            let cell = if row == 2 { cell } else { cell.replace("Direct (deg)", "direct") };
            let written = match cell.parse::<f64>() {
                Ok(number) => sheet.write_number(row, column, number),
                Err(_) => sheet.write_string(row, column, cell),
            };
            written.expect("a cell");
        }
    }
    // In the last corner stands nothing but a format.
    sheet.write_blank(1_048_575, 16_383, &rust_xlsxwriter::Format::new().set_bold()).expect("a cell");
    workbook.save_to_buffer().expect("a workbook")
}

/// A length calculated in a cell has digits that are none of its value, and a fraction may have become a date.
#[test]
fn numbers_of_cells_count_to_twelve_digits_and_dates_are_not_readable() {
    let engine = file::parse("layout.toml", "inline.throws = [0, 60]").expect("it reads");
    let list = students("Ada").expect("a list");
    let exercise = Exercise::draw(&engine, &[1], &list, 1, Vary::NOTHING).expect("an engine");
    let mut book = rust_xlsxwriter::Workbook::new();
    let sheet_of = book.add_worksheet();
    let header = ["student", "order", "row", "direct", "reverse"];
    for (column, name) in (0..).zip(header) {
        sheet_of.write_string(0, column, name).expect("a cell");
    }
    for (row, name) in [(1, "sum of forces"), (2, "cylinder 1")] {
        sheet_of.write_string(row, 0, "Ada").expect("a cell");
        sheet_of.write_number(row, 1, 1).expect("a cell");
        sheet_of.write_string(row, 2, name).expect("a cell");
    }
    // Some units of the last place beside √3.
    sheet_of.write_number(1, 3, 3_f64.sqrt() * (1.0 + 4.0 * f64::EPSILON)).expect("a cell");
    let date = rust_xlsxwriter::ExcelDateTime::from_ymd(2026, 7, 1).expect("a date");
    let format = rust_xlsxwriter::Format::new().set_num_format("d/m");
    sheet_of.write_datetime_with_format(2, 3, &date, &format).expect("a cell");
    let files = vec![bytes("ada.xlsx", book.save_to_buffer().expect("a workbook"))];
    let results = mark_class(&exercise, files, &Scheme::default());
    let entries = &sheet(&results, 0).tables[0].entries;
    let judged: Vec<Judged> =
        entries.iter().filter(|entry| entry.written.is_some()).map(|entry| entry.judged).collect();
    assert_eq!(judged, [Judged::Unreadable, Judged::Right]);
}
