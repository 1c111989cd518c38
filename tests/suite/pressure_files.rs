//! Is a file of pressures read as the instrument or the spreadsheet meant it, in whatever dialect?

use crankstar::engine::{Engine, PressureLaw};
use crankstar::file::{FileResolver, parse_beside};
use crankstar::text::decoded;
use num_rational::BigRational;
use proptest::prelude::*;

use crate::support::program::{call, scratch};

const LAYOUT: &str = "cycle = 'four-stroke'\nfiring_order = '1-3-4-2'\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n\
    [inline]\nthrows = [0, 180, 180, 0]\n[gas]\nbore = '86 mm'\ntable = 'a.csv'\n";

fn read(layout: &str, bytes: &[u8]) -> Result<Engine, String> {
    let text = decoded(bytes);
    parse_beside("layout.toml", layout, FileResolver::new(&|_| Ok(text.clone()))).map_err(|error| error.to_string())
}

/// The pressures in pascals of each cylinder at the first rows, a list a cylinder.
fn pressures(engine: &Engine, rows: usize) -> Vec<Vec<BigRational>> {
    let gas = engine.gas().expect("gas");
    let of = |law: usize| match &gas.laws[law] {
        PressureLaw::Table(table) => table.rows().iter().take(rows).map(|row| row.1.clone()).collect(),
        other => panic!("{other:?}"),
    };
    gas.chambers.iter().map(|chamber| of(chamber.law)).collect()
}

fn pascals(hundredths_of_bar: i64) -> BigRational {
    BigRational::from_integer((hundredths_of_bar * 1000).into())
}

/// Hundredths of a bar at −360°, −350°, …, 350°, in cylinder 1.
fn course(row: i64, cylinder: i64) -> i64 {
    100 + (row - 36).pow(2) % 97 + 10 * cylinder
}

/// A file of such rows: what stands between cells, the sign of decimals, the columns, what stands above and behind.
struct Dialect<'a> {
    head: &'a str,
    separator: &'a str,
    decimal: &'a str,
    end: &'a str,
    columns: i64,
    last: i64,
}

fn file(dialect: &Dialect) -> String {
    let number = |hundredths: i64| format!("{}{}{:02}", hundredths / 100, dialect.decimal, hundredths % 100);
    let row = |row: i64| {
        let cells = (0..dialect.columns).map(|column| number(course(row % 72, column)));
        let angle = format!("{}{}0", 10 * (row - 36), dialect.decimal);
        let cells: Vec<String> = std::iter::once(angle).chain(cells).collect();
        cells.join(dialect.separator) + dialect.end
    };
    dialect.head.to_owned() + &(0..=dialect.last).map(row).collect::<String>()
}

#[track_caller]
fn assert_read(dialect: &Dialect, layout: &str) {
    let text = file(dialect);
    let engine =
        read(layout, text.as_bytes()).unwrap_or_else(|error| panic!("{}\n{error}", &text[..200.min(text.len())]));
    for (cylinder, found) in pressures(&engine, 72).into_iter().enumerate() {
        let column = if dialect.columns == 1 { 0 } else { cylinder as i64 };
        let wanted: Vec<BigRational> = (0..72).map(|row| pascals(course(row, column))).collect();
        assert_eq!(found, wanted, "cylinder {cylinder} of {}", &text[..120]);
    }
}

#[test]
fn separators_decimal_commas_headers_and_units_are_found() {
    let in_bar = format!("{LAYOUT}unit = 'bar'\n");
    for (separator, decimal) in
        [(";", ","), (";", "."), ("\t", ","), ("\t", "."), (",", "."), (", ", "."), ("  ", ","), (" ", ".")]
    {
        for end in ["\n", "\r\n"] {
            let plain = Dialect { head: "", separator, decimal, end, columns: 1, last: 71 };
            assert_read(&plain, &in_bar);
            // A last row at 360° repeats the first.
            assert_read(&Dialect { last: 72, ..plain }, &in_bar);
        }
    }
    for head in
        ["Winkel;Druck\n", "# measured\nangle;pressure\n\n", "\u{feff}Winkel;Druck\n", "Datum 1. 2.\nWinkel;Druck\n"]
    {
        assert_read(&Dialect { head, separator: ";", decimal: ",", end: "\n", columns: 1, last: 71 }, &in_bar);
    }
    // The header knows the unit, beside the name or in a line of its own.
    for head in [
        "Winkel [°KW];Druck [bar]\n",
        "Winkel;Druck in bar\n",
        "Winkel;Druck\n°;bar\n",
        "\"Winkel (deg)\";\"p / bar\"\n",
    ] {
        assert_read(&Dialect { head, separator: ";", decimal: ",", end: "\n", columns: 1, last: 71 }, LAYOUT);
        assert_read(&Dialect { head, separator: ";", decimal: ",", end: ";\n", columns: 1, last: 71 }, &in_bar);
    }
}

#[test]
fn every_encoding_is_read() {
    let text = file(&Dialect {
        head: "Winkel [°];Druck [bar]\n",
        separator: ";",
        decimal: ",",
        end: "\r\n",
        columns: 1,
        last: 71,
    });
    let wanted = pressures(&read(LAYOUT, text.as_bytes()).expect("UTF-8"), 72);
    let latin: Vec<u8> = text.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect();
    let wide: Vec<u8> = [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let folder = scratch("encoded-pressures");
    std::fs::write(folder.join("layout.toml"), LAYOUT).expect("a file");
    for bytes in [text.as_bytes().to_vec(), latin, wide] {
        assert_eq!(pressures(&read(LAYOUT, &bytes).expect("a table"), 72), wanted);
        // The program decodes what stands beside a layout.
        std::fs::write(folder.join("a.csv"), bytes).expect("a file");
        let output = call(&["torque", folder.join("layout.toml").to_str().expect("a path")]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn a_column_of_each_cylinder_is_that_of_its_name_or_its_place() {
    let in_order = Dialect {
        head: "angle,a,b,c,d\ndeg,bar,bar,bar,bar\n",
        separator: ",",
        decimal: ".",
        end: "\n",
        columns: 4,
        last: 72,
    };
    assert_read(&in_order, LAYOUT);
    assert_read(&Dialect { head: "angle,p1 bar,p2 bar,p3 bar,p4 bar\n", ..in_order }, LAYOUT);
    // Columns may stand in another order, and others beside them.
    let text = file(&Dialect {
        head: "angle;Zyl 4 [bar];Zyl 3 [bar];Zyl 2 [bar];Zyl 1 [bar];mean [bar]\n",
        separator: ";",
        decimal: ",",
        end: "\n",
        columns: 5,
        last: 71,
    });
    let engine = read(LAYOUT, text.as_bytes()).expect("columns by their names");
    for (cylinder, found) in pressures(&engine, 72).into_iter().enumerate() {
        let wanted: Vec<BigRational> = (0..72).map(|row| pascals(course(row, 3 - cylinder as i64))).collect();
        assert_eq!(found, wanted, "cylinder {cylinder}");
    }
    let three = file(&Dialect { head: "angle,a,b,c\n", separator: ",", decimal: ".", end: "\n", columns: 3, last: 71 });
    let error = read(&format!("{LAYOUT}unit = 'bar'\n"), three.as_bytes()).expect_err("three columns for four");
    assert!(error.contains("3 columns of pressures for 4 cylinders") && error.contains("a.csv:2"), "{error}");
}

#[test]
fn a_header_that_names_some_cylinders_names_each_once() {
    let read_below = |head: &str| {
        let text = file(&Dialect { head, separator: ",", decimal: ".", end: "\n", columns: 4, last: 71 });
        read(&format!("{LAYOUT}unit = 'bar'\n"), text.as_bytes())
    };
    for (head, words) in [
        ("angle,p4 [bar],p3 [bar],p2 [bar],p9 [bar]\n", "`p9 bar` is none"),
        ("angle,p4,p3,p2\n", "not one for each column"),
        ("# measured\nangle,p4,p3,p2,p4\n", "not one for each column"),
        ("angle,p1,p2,p3,sum\n", "`sum` is none"),
    ] {
        let error = read_below(head).expect_err(head);
        let line = if head.starts_with('#') { "a.csv:2:" } else { "a.csv:1:" };
        assert!(error.contains(words) && error.contains(line) && error.contains("1, 2, 3, 4"), "{head}: {error}");
    }
    // In their order: where no cylinder is named, or what is said of all is like a name; where each has its own name beside other words.
    for head in
        ["angle,p5,p6,p7,p8\n", "angle,a (1 bar),b (1 bar),c (1 bar),d (1 bar)\n", "angle,p1,p2,p3,p4 (less 1 bar)\n"]
    {
        let engine = read_below(head).unwrap_or_else(|error| panic!("{head}: {error}"));
        for (cylinder, found) in pressures(&engine, 72).into_iter().enumerate() {
            let wanted: Vec<BigRational> = (0..72).map(|row| pascals(course(row, cylinder as i64))).collect();
            assert_eq!(found, wanted, "{head}");
        }
    }
}

#[test]
fn what_a_file_of_pressures_cannot_mean_is_told() {
    let good = |head: &str| file(&Dialect { head, separator: ";", decimal: ",", end: "\n", columns: 1, last: 71 });
    for (text, words) in [
        (good("Winkel [rad];Druck [bar]\n"), "angles in radians"),
        (good("Winkel;Druck [kPa]\n"), "the header of the table says kPa"),
        ("PK\u{3}\u{4}\u{0}".to_owned(), "a workbook"),
        ("angle;pressure\n".to_owned(), "no line of the table begins with an angle"),
        (good("").replacen("-320,0;", "-320,0;1.0", 1), "cannot read the pressure"),
        (good("").replacen("-320,0;", "", 1), "a line of 1 cell"),
    ] {
        let error = read(&format!("{LAYOUT}unit = 'bar'\n"), text.as_bytes()).expect_err(words);
        assert!(error.contains(words), "{words}: {error}");
    }
    let without = read(LAYOUT, good("Winkel;Druck\n").as_bytes()).expect_err("no unit");
    assert!(without.contains("a pressure needs its unit"), "{without}");
}

proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let _ = read(LAYOUT, &bytes);
    }

    #[test]
    fn no_cells_make_the_reader_panic(text in "([-0-9.,;\t \"°a-z\\[\\]]{0,12}\r?\n){0,20}") {
        let _ = read(LAYOUT, text.as_bytes());
    }
}

#[cfg(feature = "optimise")]
#[test]
fn the_best_counterweights_are_found_and_written_beside_a_table_of_pressures() {
    let folder = scratch("optimise-table");
    let layout = "title = 'three'\ncycle = 'four-stroke'\nfiring_order = '1-3-2'\nspeed = 3000\neffects = ['gas']\n\
        bearings = ['-135 mm', '-45 mm', '45 mm', '135 mm']\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n\
        reciprocating_mass = '0.5 kg'\nrotating_mass = '0.5 kg'\n[inline]\nthrows = [0, 240, 120]\nspacing = '90 mm'\n\
        [crankshaft]\ncounterweights = { rotating = 1, reciprocating = 0.5 }\ncounterweight_radius = '45 mm'\n\
        [gas]\nbore = '86 mm'\ntable = 'a.csv'\n";
    std::fs::write(folder.join("layout.toml"), layout).expect("a file");
    let dialect =
        Dialect { head: "Winkel [°];Druck [bar]\n", separator: ";", decimal: ",", end: "\n", columns: 1, last: 72 };
    std::fs::write(folder.join("a.csv"), file(&dialect)).expect("a file");
    let [layout, output] = ["layout.toml", "best"].map(|name| folder.join(name).display().to_string());
    let answer = call(&["optimise", &layout, "--points", "1", "--output", &output]);
    assert!(answer.status.success(), "{}", String::from_utf8_lossy(&answer.stderr));
    // What was written is read where it stands.
    let read_back = call(&["torque", &format!("{output}/point-1.toml")]);
    assert!(read_back.status.success(), "{}", String::from_utf8_lossy(&read_back.stderr));
}
