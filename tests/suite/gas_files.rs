//! Is every mistake in a gas, a table or a flywheel told, with its place and what would be right?

use crankstar::engine::{DeadCentre, PressureLaw, Setting};
use crankstar::file::{FileResolver, parse, parse_layout_beside};
use num_rational::BigRational;

use crate::gas::engine;

/// Above every text: four lines of an engine of two cylinders, the second of which has its own name.
const BEFORE: &str = "cycle = 'four-stroke'\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n";
const AFTER: &str = "\n[[cylinder]]\nname = 'L1'\nthrow = 0\nbank = 0\nposition = 0\n[[cylinder]]\nname = 'L2'\nthrow = 0\nbank = 0\nposition = 1\n";

#[track_caller]
fn assert_told(text: &str, line: usize, words: &[&str]) {
    let error = parse("layout.toml", text).err().unwrap_or_else(|| panic!("accepted:\n{text}")).to_string();
    for words in words {
        assert!(error.contains(words), "no {words:?} for\n{text}\n{error}");
    }
    let pointed = error.split_once("layout.toml:").and_then(|(_, place)| place.split(':').next()?.parse().ok());
    assert_eq!(pointed.unwrap_or(0), line, "{text}\n{error}");
}

/// A cycle of two lines, from line 5 on.
const SPARK: &str = "[gas]\nbore = '86 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 10\nheat = '1100 J'\n";

/// Mistakes of a cycle, from line 10 on.
#[rustfmt::skip]
const CYCLES: &[(&str, usize, &[&str])] = &[
    ("compression_ration = 10",                  10, &["unknown key `compression_ration`"]),
    ("ambient = 1",                              10, &["a pressure needs its unit"]),
    ("ambient = '0 bar'",                        10, &["above 0", "gauge? add 1.013 bar"]),
    ("crankcase = '-0.1 bar'",                   10, &["gauge? add 1.013 bar"]),
    ("intake_pressure = '0.9'",                  10, &["a pressure needs its unit"]),
    ("intake_pressure = '0.9 Bar'",              10, &["`Bar` is none of mbar, bar, MPa, kPa, Pa, psi"]),
    ("intake_pressure = inf",                    10, &["not a number"]),
    ("intake_pressure = 'nan bar'",              10, &["not a number"]),
    ("exhaust_pressure = '1e6 MPa'",            10, &["no engine has more than a million bar"]),
    ("exhaust_pressure = '0 Pa'",                10, &["above 0"]),
    ("compression_exponent = 1",                 10, &["compression_exponent is 1", "above 1 and at most 2"]),
    ("expansion_exponent = 13",                  10, &["above 1 and at most 2"]),
    ("wiebe_exponent = -1",                      10, &["Wiebe exponent of -1", "2 is usual for a spark"]),
    ("combustion_lasts = 0",                     10, &["0.1° or more"]),
    ("combustion_lasts = 200",                   10, &["opens at 130°, before the charge is burnt, at 180°"]),
    ("exhaust_opens = 39",                       10, &["opens at 39°, before the charge is burnt, at 40°"]),
    ("combustion_starts = -190",                 10, &["burns before the intake closes at -180°"]),
    ("intake_closes = 5",                        10, &["not after it, at 5°"]),
    ("intake_closes = -350",                     10, &["before it opens"]),
    ("exhaust_opens = 320",                      10, &["after the burnt gas has to be out, at 360°"]),
    ("delivery_pressure = '7 bar'",              10, &["delivery_pressure in a combustion engine"]),
    ("clearance = 0.05",                         10, &["clearance in a combustion engine"]),
    ("unit = 'bar'",                             10, &["unit beside a process"]),
    ("reading = 'gauge'",                        10, &["reading beside a process"]),
    ("peak_pressure = '70 bar'",                 10, &["what is burnt is given twice"]),
    ("mean_pressure = '7 bar'",                  10, &["what is burnt is given twice"]),
    ("pressure = [[0, '1 bar']]",                10, &["the pressure is given twice"]),
    ("table = 'indicator.csv'",                  10, &["the pressure is given twice"]),
    ("dead_centre = 'top'",                      10, &["\"crank\" or \"piston\""]),
    ("cylinders = ['L2']",                       10, &["cylinders are named in [gas]"]),
    ("[[gas.cylinder]]\nheat = 0",               10, &["add cylinders ="]),
    ("[[gas.cylinder]]\ncylinders = [2]",        11, &["cannot read the cylinder `2`", "one of L1, L2"]),
    ("[[gas.cylinder]]\ncylinders = ['L2', 'L2']", 11, &["two tables of cylinder L2"]),
    ("[[gas.cylinder]]\ncylinders = ['L2']\nheat = '-1 J'", 12, &["a heat of -1 J", "0, where it does not fire"]),
    ("[[gas.cylinder]]\ncylinders = ['L2']\nprocess = 'otto'", 12, &["\"spark-ignition\", \"diesel\" or \"compressor\""]),
    ("[flywheel]\ninertia = 0",                  11, &["above 0"]),
    ("[flywheel]\ninertia = '1 kg m'",           11, &["none of kg m²"]),
    ("[flywheel]\nirregularity = 0",             11, &["\"1/50\"", "±1 %"]),
    ("[flywheel]\nirregularity = 50",            11, &["\"1/50\"", "±1 %"]),
    ("[flywheel]\nmass = 50",                    11, &["unknown key `mass`"]),
];

#[test]
fn mistakes_in_a_cycle_are_told() {
    for (text, line, words) in CYCLES {
        assert_told(&format!("{BEFORE}{SPARK}{text}{AFTER}"), *line, words);
    }
    let instead = |from: &str, to: &str| format!("{BEFORE}{}{AFTER}", SPARK.replace(from, to));
    assert_told(&instead("heat = '1100 J'", ""), 5, &["does not say what it burns"]);
    assert_told(&instead("heat = '1100 J'", "heat = -1"), 9, &["a heat of -1 J"]);
    assert_told(&instead("heat = '1100 J'", "heat = '1 cal'"), 9, &["none of MJ, kJ, J"]);
    assert_told(&instead("compression_ratio = 10\n", ""), 5, &["without a compression ratio"]);
    assert_told(&instead("ratio = 10", "ratio = 1"), 8, &["a compression ratio of 1", "above 1"]);
    assert_told(&instead("bore = '86 mm'\n", ""), 5, &["without a bore"]);
    assert_told(&instead("'86 mm'", "'-86 mm'"), 6, &["a length above 0"]);
    assert_told(&instead("process = 'spark-ignition'\n", ""), 5, &["gas without a pressure"]);
    let two_stroke = |more: &str| format!("{BEFORE}{SPARK}{more}{AFTER}").replace("four-stroke", "two-stroke");
    assert_told(&two_stroke(""), 5, &["a two-stroke without its intake pressure"]);
    let charged = two_stroke("intake_pressure = '1.2 bar'\nexhaust_pressure = '1 bar'");
    assert_told(&charged, 11, &["an exhaust pressure in a two-stroke"]);
    let no_cycle = format!("{BEFORE}{SPARK}{AFTER}").replace("cycle = 'four-stroke'\n", "");
    assert_told(&no_cycle, 4, &["the cycle, which is missing"]);
    let offset = format!("{BEFORE}pin_offset = '1 mm'\n{SPARK}{AFTER}");
    assert_told(&offset, 6, &["dead centres of their own", "\"piston\""]);
    let effects = format!("effects = ['gass']\n{BEFORE}{SPARK}{AFTER}");
    assert_told(&effects, 1, &["\"torque\", \"remedy\", \"gas\", \"firing\" or \"torsion\""]);
}

#[test]
fn mistakes_in_a_compressor_are_told() {
    let stage = "[gas]\nbore = '86 mm'\nprocess = 'compressor'\nintake_pressure = '1 bar'\ndelivery_pressure = '7 bar'\nclearance = 0.05\n";
    let before = BEFORE.replace("four-stroke", "two-stroke");
    assert!(parse("layout.toml", &format!("{before}{stage}{AFTER}")).is_ok());
    assert_told(&format!("{BEFORE}{stage}{AFTER}"), 5, &["a compressor in a four-stroke cycle"]);
    let instead = |from: &str, to: &str| format!("{before}{}{AFTER}", stage.replace(from, to));
    assert_told(&instead("clearance = 0.05", "heat = 1"), 10, &["heat in a compressor"]);
    assert_told(&instead("clearance = 0.05", ""), 7, &["a compressor without clearance"]);
    assert_told(&instead("0.05", "0"), 10, &["clearance is 0"]);
    assert_told(&instead("'7 bar'", "'1 bar'"), 9, &["not above the suction"]);
}

/// Rows of a table through 720°, 20° apart.
fn rows(change: impl Fn(usize) -> Option<String>) -> String {
    let row = |index: usize| change(index).unwrap_or_else(|| format!("[{}, {}]", 20 * index, 1 + index % 3));
    format!("pressure = [\n{}\n]", (0..36).map(row).collect::<Vec<_>>().join(",\n"))
}

#[test]
fn mistakes_in_a_table_name_the_row() {
    let text = |rows: &str| format!("{BEFORE}[gas]\nbore = '86 mm'\nunit = 'bar'\n{rows}{AFTER}");
    assert!(parse("layout.toml", &text(&rows(|_| None))).is_ok());
    let changed = |at: usize, row: &'static str| {
        let rows = rows(|index| (index == at).then(|| row.to_owned()));
        text(&rows)
    };
    // The rows begin in line 9.
    assert_told(&changed(7, "[120, 1]"), 16, &["row 8: the angle does not rise"]);
    assert_told(&changed(7, "[100, 1]"), 16, &["row 8: the angle does not rise"]);
    assert_told(&changed(3, "[60, 0]"), 12, &["row 4: an absolute pressure of 0 Pa", "reading = \"gauge\""]);
    assert_told(&changed(3, "[60, -0.4]"), 12, &["row 4: an absolute pressure of -40000 Pa"]);
    assert_told(&changed(3, "[60]"), 12, &["a row of 1 value\n"]);
    assert_told(&changed(3, "[60, nan]"), 12, &["not a number"]);
    assert_told(&changed(3, "[60, inf]"), 12, &["not a number"]);
    assert_told(&changed(3, "['60 mm', 1]"), 12, &["cannot read the angle"]);
    assert_told(&changed(35, "[721, 1]"), 44, &["row 36: the rows span more than the cycle of 720°"]);
    assert_told(&changed(35, "[720, 1.5]"), 44, &["repeats the first", "leave the last row out"]);
    assert!(parse("layout.toml", &changed(35, "[720, 1]")).is_ok());
    let half = rows(|index| Some(format!("[{}, 1]", 10 * index)));
    assert_told(&text(&half), 8, &["span 350° of a cycle of 720°", "two revolutions"]);
    let whole_revolution = rows(|index| {
        Some(format!("[{}, {}]", 360.0 * index as f64 / 35.0, if index == 35 { 1 } else { 1 + index % 2 }))
    });
    assert_told(&text(&whole_revolution), 8, &["of a cycle of 720°"]);
    let hole = rows(|index| Some(format!("[{}, 1]", 19 * index)));
    assert_told(&text(&hole), 8, &["span 665°"]);
    assert_told(&text("pressure = [[0, 1], [360, 2]]"), 8, &["the rows span 360° of a cycle of 720°"]);
    assert_told(&text("pressure = [[0, 1]]"), 8, &["a table of 1 row"]);
    let bare = text(&rows(|_| None)).replace("unit = 'bar'\n", "");
    assert_told(&bare, 8, &["a pressure needs its unit"]);
    assert_told(&text(&rows(|_| None)).replace("'bar'", "'Bar'"), 7, &["one of mbar, bar"]);
    assert_told(&text("reading = 'relative'\npressure = []"), 8, &["\"absolute\" or \"gauge\""]);
    assert_told(&text(&format!("{}\nheat = 1", rows(|_| None))), 46, &["heat beside a table"]);
    assert_told(&text("table = 'a.csv'"), 8, &["cannot read the table `a.csv`", "write its rows into it"]);
    for path in ["/etc/passwd", "../a.csv", "a/../../b.csv", "c:\\a.csv", ""] {
        assert_told(&text(&format!("table = '{path}'")), 8, &["cannot read the table", "beside the layout file"]);
    }
}

#[test]
fn mistakes_in_a_csv_file_name_its_line() {
    let text = format!("{BEFORE}[gas]\nbore = '86 mm'\nunit = 'bar'\ntable = 'a.csv'\n{AFTER}");
    let told = |csv: &str| {
        let read = |_: &str| Ok(csv.to_owned());
        parse_layout_beside("layout.toml", &text, FileResolver::new(&read)).expect_err("a mistake").to_string()
    };
    let good: Vec<String> = (0..36).map(|index| format!("{},{}", 20 * index, 1 + index % 3)).collect();
    let with = |line: usize, row: &str| {
        let mut lines = good.clone();
        lines[line] = row.to_owned();
        told(&format!("angle,pressure\n{}", lines.join("\n")))
    };
    for (row, words) in [
        ("60,-1", "row 4: an absolute pressure"),
        ("60", "a line of 1 cell"),
        ("60;1,5", "cannot read the angle `60;1`"),
        ("60,1,5", "a line of 3 cells"),
        ("60,one", "cannot read the pressure `one`"),
        ("x,1", "cannot read the angle `x`"),
        ("30,1", "row 4: the angle does not rise"),
    ] {
        let error = with(3, row);
        assert!(error.contains(words) && error.contains("a.csv:5"), "{row}: {error}");
    }
    assert!(told("").contains("a table of 0 rows"));
    let none = |_: &str| Err("no such file".to_owned());
    let error = parse_layout_beside("layout.toml", &text, FileResolver::new(&none)).expect_err("no file").to_string();
    assert!(error.contains("no such file") && error.contains("layout.toml:8"), "{error}");
}

#[test]
fn units_are_exact_and_gauge_pressures_count_from_ambient() {
    let text =
        |rest: &str| format!("{BEFORE}[gas]\nbore = '86 mm'\ncrankcase = '1 bar'\n{rest}\n{}{AFTER}", rows(|_| None));
    let first = |rest: &str| {
        let engine = engine(&text(rest));
        match &engine.gas().expect("gas").laws[0] {
            PressureLaw::Table(table) => table.rows()[0].1.clone(),
            other => panic!("{other:?}"),
        }
    };
    let whole = |pascals: i64| BigRational::from_integer(pascals.into());
    assert_eq!(first("unit = 'bar'"), whole(100_000));
    assert_eq!(first("unit = 'kPa'\nreading = 'absolute'"), whole(1000));
    assert_eq!(first("unit = 'bar'\nreading = 'gauge'"), whole(201_325));
    assert_eq!(first("unit = 'bar'\nreading = 'gauge'\nambient = '0.95 bar'"), whole(195_000));
    assert_eq!(first("unit = 'psi'"), BigRational::new(44_482_216_152_605_i64.into(), 6_451_600_000_i64.into()));
}

#[test]
fn what_is_left_out_is_assumed_and_said_to_be() {
    let assumed = |text: &str| match &engine(&format!("{BEFORE}{text}{AFTER}")).gas().expect("gas").laws[0] {
        PressureLaw::Cycle(ideal) => ideal.assumed.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(assumed(SPARK).len(), 10);
    let given = format!("{SPARK}intake_pressure = '0.9 bar'\nblowdown = 50\n");
    assert!(!assumed(&given).contains(&Setting::IntakePressure) && !assumed(&given).contains(&Setting::Blowdown));
    assert_eq!(assumed(&given).len(), 8);
    let gas = engine(&format!("{BEFORE}{SPARK}{AFTER}")).gas().cloned().expect("gas");
    assert!(gas.chambers.iter().all(|chamber| chamber.crankcase_assumed && chamber.zero == DeadCentre::Crank));
    let unlike = format!("{BEFORE}{SPARK}[[gas.cylinder]]\ncylinders = ['L2']\nmean_pressure = '5 bar'\n{AFTER}");
    let gas = engine(&unlike).gas().cloned().expect("gas");
    assert_eq!((gas.laws.len(), gas.chambers[0].law, gas.chambers[1].law), (2, 0, 1));
}
