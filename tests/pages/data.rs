//! Do readers of others find in workbooks and Parquet files what stands in CSV?

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::run;

/// A layout with numbers, bearings and gas, and with names that spreadsheets would reckon with.
const LAYOUT: &str = include_str!("../../reports/examples/v8-gas/layout.toml");

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
fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
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
    let mut program = Command::new(env!("CARGO_BIN_EXE_crankstar"));
    program.args(arguments).args(["--format", format, "--output"]).arg(&output);
    let done = program.output().expect("the program starts");
    assert!(done.status.success(), "{asked:?} as {format}: {}", String::from_utf8_lossy(&done.stderr));
}

/// How many cells agree.
fn compared(folder: &Path, question: &str, others: [&str; 2]) -> usize {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pages/tables.py");
    let told = run(folder, "python3", &[script, "csv", question, others[0], others[1]], "");
    told.trim().parse().expect("a number")
}

#[cfg(feature = "xlsx")]
#[test]
#[ignore = "needs openpyxl for Python"]
fn a_workbook_holds_for_openpyxl_what_csv_holds_and_no_formula() {
    for (index, (asked, least)) in QUESTIONS.into_iter().enumerate() {
        let folder = scratch(&format!("data-xlsx-{index}"));
        write(&folder, asked, "csv", "csv");
        write(&folder, asked, "xlsx", "book.xlsx");
        let cells = compared(&folder, asked[0], ["book.xlsx", "-"]);
        assert!(cells >= least, "{asked:?}: {cells} cells");
    }
}

#[cfg(feature = "parquet")]
#[test]
#[ignore = "needs DuckDB for Python"]
fn parquet_holds_for_duckdb_what_csv_holds_with_its_types() {
    for (index, (asked, least)) in QUESTIONS.into_iter().enumerate() {
        let folder = scratch(&format!("data-parquet-{index}"));
        write(&folder, asked, "csv", "csv");
        write(&folder, asked, "parquet", "parquet");
        let cells = compared(&folder, asked[0], ["-", "parquet"]);
        assert!(cells >= least, "{asked:?}: {cells} cells");
    }
}
