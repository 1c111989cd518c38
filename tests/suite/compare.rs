//! Does a comparison say what each engine leaves, in which units, and with which remedy?

use std::path::PathBuf;

use std::fs;
use std::process::{Command, Output};

use serde_json::Value;

use crate::support::program::{call, scratch};

fn crankstar(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_crankstar"));
    command.arg("compare").args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("the program starts")
}

fn succeeds(arguments: &[&str]) -> String {
    let output = crankstar(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

fn fails(arguments: &[&str], status: i32) -> String {
    let output = crankstar(arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}");
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).expect("a text")
}

/// The row of the table that begins with this name, its cells drawn together where they are broken into lines.
fn line(text: &str, name: &str) -> String {
    let start = format!(" {name}  ");
    let mut lines = text.lines().skip_while(|line| !line.starts_with(&start)).map(|line| line.chars().collect());
    let first: Vec<char> = lines.next().unwrap_or_else(|| panic!("{name} in\n{text}"));
    let begins = |at: &usize| first[*at] != ' ' && (*at == 1 || first[at - 2..*at] == [' ', ' ']);
    let columns: Vec<usize> = (1..first.len()).filter(begins).collect();
    let goes_on = |line: &Vec<char>| line.len() > columns[1] && line[..columns[1]].iter().all(|letter| *letter == ' ');
    let more: Vec<Vec<char>> = lines.take_while(goes_on).collect();
    let cell = |(index, &from): (usize, &usize)| {
        let to = columns.get(index + 1).copied().unwrap_or(usize::MAX);
        let part = |line: &Vec<char>| line[from.min(line.len())..to.min(line.len())].iter().collect::<String>();
        words(&[&first].into_iter().chain(&more).map(|line| part(line) + " ").collect::<String>())
    };
    columns.iter().enumerate().map(cell).collect::<Vec<_>>().join(" | ")
}

/// A text with its spaces and ends of lines drawn together.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

const FOUR: &str = r#"title = "Four"
cycle = "four-stroke"
speed = 6000
bearings = [0.2, 0.1, 0.0, -0.1, -0.2]
[mechanism]
stroke = "86 mm"
rod_length = "143 mm"
reciprocating_mass = "0.5 kg"
[inline]
throws = [0, 180, 180, 0]
spacing = "100 mm"
"#;

/// The layout file of this text in a folder of its own.
fn layout(name: &str, text: &str) -> String {
    let folder = scratch("compare").join(name);
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("layout.toml"), text).expect("a file");
    folder.join("layout.toml").to_str().expect("a path").to_owned()
}

#[test]
fn engines_stand_side_by_side_with_remedy_and_first_order_left() {
    let text = succeeds(&["i4", "V8-crossplane", "boxer-4"]);
    assert_eq!(line(&text, "Firing"), "Firing | even, 180° | even, 90° | even, 180°");
    assert_eq!(line(&text, "Force 2"), "Force 2 | 4, planar | 0 | 0");
    assert_eq!(line(&text, "Moment 1"), "Moment 1 | 0 | couple √10 ≈ 3.162, rotating | 0");
    assert_eq!(line(&text, "Force from order"), "Force from order | 2, planar | 4, planar | none");
    assert_eq!(line(&text, "Force, order 2"), "Force, order 2 | 1.17 m r ω², planar | 0 | 0");
    assert_eq!(
        line(&text, "Cures"),
        "Cures | Lanchester pair ±2 | 2 counterweights (couple) | shafts ±2 (couple each)"
    );
    let all = line(&text, "All cures");
    assert!(all.contains("| Lanchester pair ±2; Lanchester pair ±4;"), "{text}");
    assert!(all.contains(" | 2 counterweights (couple); Lanchester pair ±4 | shafts ±2 (couple each);"), "{text}");
    assert!(text.contains("No free force or moment below order 4 but for what counterweights"));
    assert!(text.lines().all(|line| line.chars().count() <= 81), "{text}");
    assert!(text.contains("Positions have no unit"));
    assert!(!text.contains("in N ") && !text.contains("Worst main bearing"));
}

#[test]
fn orders_are_those_that_any_layout_file_asks_for() {
    let document: Value = serde_json::from_str(&succeeds(&["I4", "radial-9", "--json"])).expect("JSON");
    assert_eq!(document["orders"], serde_json::json!([1, 2, 4, 6, 8, 10]));
    assert_eq!(document["engines"][1]["orders"].as_array().map(Vec::len), Some(6));
}

#[test]
fn newtons_and_bearings_stand_where_all_have_numbers() {
    let four = layout("four", FOUR);
    let cross = layout("cross", &FOUR.replace("[0, 180, 180, 0]", "[0, 90, 270, 180]"));
    let text = succeeds(&[&four, &cross, "--orders", "1,2"]);
    // 4 m r ω² c_2 with λ = 43/143: c_2 = λ + λ³/4 + 15λ⁵/128 + … (theory, section 2).
    let (lambda, omega) = (43.0_f64 / 143.0, 6000.0_f64 / 60.0 * std::f64::consts::TAU);
    let c_2 = lambda + lambda.powi(3) / 4.0 + 15.0 * lambda.powi(5) / 128.0;
    let expected = 4.0 * 0.5 * 0.043 * omega * omega * c_2;
    let written = line(&text, "Force, order 2");
    let written = written.split(" | ").nth(1).and_then(|cell| cell.split_once(" kN, planar")).expect("kilonewtons");
    let written = 1000.0 * written.0.parse::<f64>().expect("a number");
    assert!((written - expected).abs() < 5e-3 * expected, "{written} {expected}");
    assert_eq!(line(&text, "Sizes"), "Sizes | at 6000 rpm | at 6000 rpm");
    assert!(line(&text, "Worst main bearing").contains("bearing 3 with ≈ "));
    assert!(text.contains("Positions are in metres."));
    // The folder names a layout.toml.
    assert!(text.lines().any(|header| words(header) == "four cross"), "{text}");
    let document: Value = serde_json::from_str(&succeeds(&[&four, &cross, "--json"])).expect("JSON");
    let newtons = document["engines"][0]["newtons"][1]["force"].as_f64().expect("a number");
    assert!((newtons - expected).abs() < 1e-3 * expected);
    assert_eq!(document["engines"][0]["worst_bearings"]["bearings"], serde_json::json!([3]));
}

/// The side forces of the pistons have odd orders that force and moment do not have.
#[test]
fn the_worst_bearing_is_that_of_the_bearings_whatever_is_compared() {
    let two = "title = 'two'\nspeed = 6000\nbearings = ['80 mm', '-80 mm']\n[vee]\nbank_angle = 90\nthrows = [0]\n[mechanism]\nstroke = '86 mm'\n\
               rod_length = '143 mm'\nreciprocating_mass = '0.5 kg'\nrotating_mass = '0.4 kg'\n";
    let (all, few) = (layout("two-all", two), layout("two-few", &format!("orders = [1, 2]\n{two}")));
    let peak = |file: &str| {
        let told = String::from_utf8(call(&["bearings", file, "--json"]).stdout).expect("a text");
        let told: Value = serde_json::from_str(&told).expect("JSON");
        told["bearings"][0]["force_zero_to_peak_N"].as_f64().unwrap_or_else(|| panic!("{told}"))
    };
    let right = [peak(&all), peak(&few)];
    assert!(right[0] > 1.005 * right[1], "{right:?}");
    for orders in [&[][..], &["--orders", "3"]] {
        let asked = |json| [&[all.as_str(), &few][..], orders, json].concat();
        let document: Value = serde_json::from_str(&succeeds(&asked(&["--json"]))).expect("JSON");
        let found =
            [0, 1].map(|place| document["engines"][place]["worst_bearings"]["peak"].as_f64().expect("a number"));
        assert_eq!(found, right, "{orders:?}");
        let others = line(&succeeds(&asked(&[])), "Its other orders");
        let percent =
            |cell: &str| cell.strip_prefix("at most ")?.strip_suffix(" % of the largest")?.parse::<f64>().ok();
        let parts: Vec<f64> = others.split(" | ").skip(1).filter_map(percent).collect();
        let left = 100.0 * (right[0] / right[1] - 1.0);
        assert!(matches!(parts[..], [all, few] if all < 0.01 && few > left && few < 4.0), "{others}");
    }
}

/// The gas of the four, and when it fires.
const GAS: &str = "firing_order = '1-3-4-2'\neffects = ['gas']\n";
const BORE: &str = "[gas]\nbore = '86 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 10\nheat = '1100 J'\nintake_pressure = '0.9 bar'\n";

#[test]
fn where_the_gas_is_asked_for_the_worst_bearing_is_that_of_the_complete_loads() {
    let with = format!("{}{BORE}", FOUR.replacen("speed", &format!("{GAS}speed"), 1));
    let (gas, without) = (layout("gas", &with), layout("masses", FOUR));
    let engine = crankstar::file::parse("gas.toml", &with).expect("an engine");
    let loads = crankstar::journal::cycle_loads(&engine).expect("loads");
    let [bearings, _] = loads.bearings.as_ref().expect("bearings");
    let text = succeeds(&[&gas, &without]);
    let numbers: Vec<usize> = bearings.worst.iter().map(|index| index + 1).collect();
    assert_eq!(numbers.len(), 2, "a four is its own mirror image");
    let worst = format!("bearings {}, {} with ≈", numbers[0], numbers[1]);
    assert!(words(&text).contains(&worst), "{worst} in {text}");
    assert!(words(&text).contains("no gas loads"), "{text}");
    let document: Value = serde_json::from_str(&succeeds(&[&gas, &without, "--json"])).expect("JSON");
    let told = &document["engines"][0]["worst_bearing_with_gas"];
    assert_eq!(told["peak"].as_f64(), Some(bearings.bearings[bearings.worst[0]].peak.value));
    assert_eq!(told["bearings"], serde_json::json!(numbers));
    assert!(document["engines"][1].get("worst_bearing_with_gas").is_none());
    // What lacks is told, and nothing of the gas stands where nobody asks for it.
    let lacks = layout("lacks", &with.replace("firing_order = '1-3-4-2'\n", ""));
    assert!(words(&succeeds(&[&lacks, &without])).contains("gas loads were asked for, but are missing"));
    assert!(!words(&succeeds(&[&without, "I4"])).contains("main bearing with"));
}

#[test]
fn different_units_and_missing_numbers_are_said() {
    let four = layout("metres", FOUR);
    let text = succeeds(&[&four, "I4"]);
    assert!(words(&text).contains(
        "different units, so that the moments cannot be compared: metres in metres, multiples of the spacing in I4"
    ));
    let force = line(&text, "Force, order 2");
    assert!(force.contains(" kN, planar | ") && force.ends_with(" m r ω², planar"), "{text}");
    assert!(line(&text, "Worst main bearing").ends_with("none given"));
}

#[test]
fn unequal_rods_are_judged_by_class_and_orders_without_coefficient_leave_nothing() {
    let text = succeeds(&["reports/examples/i6-two-rods/layout.toml", "I3", "--orders", "1,2,3"]);
    assert_eq!(line(&text, "Force 1"), "Force 1 | 0 | 0");
    assert!(line(&text, "Force 2").contains("not 0, planar (cylinders 1, 2, 5, 6: 2, planar;"));
    assert_eq!(line(&text, "Moment 2"), "Moment 2 | 0 | couple √3 ≈ 1.732, planar");
    assert_eq!(line(&text, "Force 3"), "Force 3 | does not exist | does not exist");
    assert_eq!(line(&text, "Force from order"), "Force from order | 2, planar | 6, planar");
    assert!(words(&text).contains("only equal rods have the same c_k"));
    let offset = succeeds(&["reports/examples/i6-offset/layout.toml", "I6", "--orders", "3"]);
    assert!(line(&offset, "Force 3").starts_with("Force 3 | 6, planar | does not exist"));
}

#[test]
fn the_page_has_small_multiples_of_the_stars_of_each_order() {
    let folder = scratch("compare-page").join("new");
    let engines = ["I3", "I4", "V6-60-even", "boxer-6", "I5-12453", "--orders", "1,2"];
    succeeds(&[&engines[..], &["--output", folder.to_str().expect("a path")]].concat());
    let page = fs::read_to_string(folder.join("compare.md")).expect("a page");
    for order in ["1", "2"] {
        // Three engines in the first picture, two in the second.
        let files = [format!("stars-order-{order}.svg"), format!("stars-order-{order}-2.svg")];
        assert!(files.iter().all(|file| page.contains(&format!("]({file})"))), "{page}");
        let drawings = files.each_ref().map(|file| fs::read_to_string(folder.join(file)).expect("a drawing"));
        let named = |name: &&str| drawings.iter().any(|drawing| drawing.contains(&format!(">{name}</text>")));
        assert!(engines[..5].iter().all(named), "{files:?}");
        assert_eq!(drawings.concat().matches(">Moment, reverse, order").count(), 5);
    }
    let rows: Vec<&str> = page.lines().filter(|line| line.starts_with('|')).collect();
    assert!(rows.iter().all(|row| row.matches(" | ").count() == rows[0].matches(" | ").count()), "{page}");
    // In engines in one line the reverse stars are mirror images, and are left out.
    let _ = fs::remove_dir_all(&folder);
    succeeds(&["I3", "I4", "--orders", "1", "--output", folder.to_str().expect("a path")]);
    let drawing = fs::read_to_string(folder.join("stars-order-1.svg")).expect("a drawing");
    assert!(!drawing.contains("reverse"));
}

#[test]
fn what_cannot_be_compared_is_answered_with_words() {
    assert!(fails(&["I4"], 2).contains("needs two or more engines"));
    assert!(fails(&["I4", "reports/families/v-twin/layout.toml"], 1).contains("has unknowns: phi"));
    assert!(fails(&["I4", "nothing"], 1).contains("neither an engine of the catalogue nor a file"));
    assert_eq!(crankstar(&[]).status.code(), Some(2));
    assert_eq!(crankstar(&["I4", "I6", "--orders", "0"]).status.code(), Some(2));
    assert_eq!(crankstar(&["I4", "I6", "--json", "--output", "x"]).status.code(), Some(2));
}

#[test]
fn an_engine_beside_itself_is_the_same_twice() {
    let text = succeeds(&["I3", "I3"]);
    assert_eq!(line(&text, "Moment 1"), "Moment 1 | couple √3 ≈ 1.732, planar | couple √3 ≈ 1.732, planar");
}

#[test]
fn any_number_of_engines_is_compared() {
    let many: Vec<&str> = ["I2-180", "I2-360", "I3"].into_iter().cycle().take(30).collect();
    let asked = [many.as_slice(), &["--orders", "1", "--format", "csv", "--table", "engines"]].concat();
    assert_eq!(succeeds(&asked).lines().count(), 31);
}

#[test]
fn no_line_of_a_comparison_is_longer_than_eighty_columns() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let layouts = |folder: &str| -> Vec<PathBuf> {
        let entries = fs::read_dir(root.join(folder)).expect("a folder").map(|entry| entry.expect("an entry").path());
        let files = entries.map(|path| if path.is_dir() { path.join("layout.toml") } else { path });
        let mut files: Vec<PathBuf> =
            files.filter(|path| path.extension().is_some_and(|it| it == "toml") && path.is_file()).collect();
        files.sort();
        files
    };
    let all = [layouts("src/kernel/file/catalogue"), layouts("reports/examples")].concat();
    let mut lines = 0;
    for (index, some) in all.chunks(5).filter(|some| some.len() > 1).enumerate() {
        let mut arguments: Vec<&str> = some.iter().map(|path| path.to_str().expect("UTF-8")).collect();
        arguments.extend(if index % 2 == 0 { ["--lang", "en"] } else { ["--lang", "de"] });
        let answer = succeeds(&arguments);
        for line in answer.lines() {
            assert!(line.chars().count() <= 80, "{} columns, {arguments:?}:\n{line}", line.chars().count());
            lines += 1;
        }
    }
    assert!(lines > 300, "only {lines} lines");
}

#[test]
fn values_of_any_question_are_beside_a_comparison_and_columns_of_its_engines() {
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples/v8-gas/layout.toml");
    let asked = ["compare", layout, "I4", "--value", "bearings.worst.force", "--value", "torque.cycle.mean"];
    let run = |more: &[&str]| {
        let output = call(&[&asked[..], more].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("a text")
    };
    let told = run(&[]).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("bearings.worst.force in N") && told.contains("I4 has no bearings.worst.force"), "{told}");
    let csv = run(&["--format", "csv", "--table", "engines"]);
    assert!(csv.lines().next().is_some_and(|header| header.contains("bearings_worst_force_N,")), "{csv}");
}

#[test]
fn a_comparison_of_layouts_with_gas_says_how_to_get_what_the_gas_adds() {
    let folder = scratch("compare-gas");
    let text = include_str!("../../reports/examples/v8-gas/layout.toml");
    let path = |name: &str, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).expect("a file");
        path.to_str().expect("a path").to_owned()
    };
    let silent: String =
        text.lines().filter(|line| !line.starts_with("effects")).map(|line| format!("{line}\n")).collect();
    let paths = [path("silent.toml", &silent), path("asking.toml", &format!("effects = ['gas']\n{silent}"))];
    let told = |one: &str, other: &str| {
        let output = call(&["compare", one, other]);
        let text = String::from_utf8(output.stdout).expect("a text");
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let note = "need effects = [\"gas\"] above the first table";
    assert!(told(&paths[0], &paths[1]).contains(&format!("{note}: silent.")));
    assert!(!told("I4", "I4").contains(note));
}

#[test]
fn a_cure_names_the_counterweights_of_a_faster_crankshaft_and_the_shaft_that_is_taken_away() {
    let folder = scratch("compare-cures");
    let mechanism = "[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\nreciprocating_mass = '1 kg'\n";
    let crankshafts = "crankshaft = [{ name = 'slow', sense = 'with' }, { name = 'fast', sense = 'with', speed = 2 }]\ncylinder = [{ crankshaft = 'slow', throw = 0, bank = 0, position = '0 m' }, { crankshaft = 'fast', throw = 0, bank = 0, position = '0 m' }]\n";
    let shaft = "[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '0.001 kg m'\nangle = 0\nposition = '0 m'\n";
    let four = "inline = { throws = [0, 180, 180, 0], spacing = '0.1 m' }\n";
    let path = |name: &str, text: String| {
        let path = folder.join(name);
        fs::write(&path, text).expect("a layout");
        path.to_string_lossy().into_owned()
    };
    let faster = path("faster.toml", format!("speed = 3000\n{crankshafts}{mechanism}"));
    let needless = path("needless.toml", format!("speed = 3000\n{four}{mechanism}{shaft}"));
    let cures = |one: &str, other: &str| line(&succeeds(&[one, other, "--orders", "1,2"]), "Cures");
    let row = cures(&faster, &needless);
    assert!(row.contains("on crankshaft fast") && row.contains("shaft −2"), "{row}");
    let row = cures(&needless, &faster);
    assert!(row.contains("Lanchester pair ±2; the engine's shaft −1 taken away"), "{row}");
    let weight = |throw: u32| format!("[[counterweight]]\nthrow = {throw}\nmass_radius = '10 kg mm'\n");
    let heavy = path("heavy.toml", format!("speed = 3000\n{four}{mechanism}{}{}", weight(1), weight(4)));
    let row = cures(&heavy, &faster);
    assert!(row.contains("Lanchester pair ±2; the engine's counterweights taken away"), "{row}");
}
