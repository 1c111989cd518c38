//! Has every value of a question a name, which means the same on the terminal, in tables and in documents?

use crankstar::engine::Engine;
use crankstar::file::{self, Layout};
use crankstar::report::{self, Question, ValueName, values_of};
use crankstar::table::{Single, Table, Value};

use crate::support::dice::Dice;
use crate::support::every_form;
use crate::support::program::{call, scratch};
use crate::support::written::assert_near;

const SHAFT: &str = include_str!("../../examples/shaft.toml");
const DIAGRAM: &str = include_str!("../../examples/turning-moment.toml");

const V8_GAS: &str = include_str!("../../reports/examples/v8-gas/layout.toml");

#[track_caller]
fn engine(text: &str) -> Engine {
    match file::parse_layout("layout.toml", text) {
        Ok(Layout::Known(engine, _)) => *engine,
        Ok(Layout::Open(_)) => panic!("the layout has unknowns"),
        Err(error) => panic!("{error}"),
    }
}

fn named(engine: &Engine, name: &str) -> Result<Single, String> {
    values_of(engine, &[name.parse::<ValueName>()?]).remove(0)
}

/// The names of all values of a table, each with its value.
fn every_name(question: &str, table: &Table) -> Vec<(String, Option<String>)> {
    let mut all = Vec::new();
    for row in 0..table.rows() {
        let keys: Vec<String> = table.columns()[..table.keys()]
            .iter()
            .map(|column| column.values().get(row).expect("a key").to_string())
            .collect();
        for column in &table.columns()[table.keys()..] {
            let path: Vec<&str> = [question, table.name()]
                .into_iter()
                .chain(keys.iter().map(String::as_str))
                .chain([column.name()])
                .collect();
            all.push((path.join("."), column.values().get(row).map(|value| value.to_string())));
        }
    }
    all
}

#[test]
fn every_cell_of_every_table_whose_keys_are_its_own_has_a_name() {
    let mut dice = Dice::new(271);
    let layouts = std::iter::repeat_with(|| every_form::known(&mut dice)).take(12);
    let random = layouts.filter_map(|text| match file::parse_layout("layout.toml", &text) {
        Ok(Layout::Known(engine, _)) => Some(*engine),
        Ok(Layout::Open(_)) | Err(_) => None,
    });
    let mut count = 0;
    for engine in random.chain([engine(V8_GAS)]) {
        for question in report::questions() {
            let Some(Ok(answer)) = report::ask(question, &engine, &[]) else { continue };
            // A term of a sum, a star of a class and a crank angle are no answers of their own.
            let tables = answer.tables().into_iter().filter(|table| {
                !["terms", "theta", "gas_theta"].contains(&table.name())
                    && (question, table.name()) != ("firing", "orders")
            });
            let all: Vec<(String, Option<String>)> = tables.flat_map(|table| every_name(question, &table)).collect();
            let names: Vec<ValueName> = all.iter().map(|(name, _)| name.parse().expect("a name")).collect();
            for ((name, told), found) in all.iter().zip(values_of(&engine, &names)) {
                let found = found.unwrap_or_else(|why| panic!("{name}: {why}"));
                assert_eq!(found.value().map(|value| value.to_string()), *told, "{name}");
                count += 1;
            }
        }
    }
    assert!(count > 5000, "{count}");
}

#[test]
fn a_value_is_named_with_its_unit_or_without() {
    let engine = engine(V8_GAS);
    let value = |name: &str| match named(&engine, name).expect("a value").value() {
        Some(Value::Decimal(value)) => value,
        other => panic!("{name} is {other:?}"),
    };
    assert_eq!(value("bearings.worst.force"), value("bearings.worst.force_zero_to_peak_N"));
    let exact = value("bearings.worst.force");
    assert_eq!(value("bearings.worst.force_zero_to_peak"), exact);
    // As a column it has its unit once, however it was named.
    for name in ["force", "force_zero_to_peak", "force_zero_to_peak_N"] {
        let name: ValueName = format!("bearings.worst.{name}").parse().expect("a name");
        let single = values_of(&engine, std::slice::from_ref(&name)).remove(0).expect("a value");
        let column = single.column(&name.column(), [Some(&single)]);
        assert_eq!(column.name().matches("_N").count(), 1, "{}", column.name());
    }
    assert_eq!(value("torque.orders.1/2.gas"), 0.0);
    assert!(value("torque.orders.4.gas") > 100.0 && value("torque.flywheel.inertia") > 0.0);
    let study = report::TorqueStudy::new(&engine).expect("gas");
    assert_eq!(value("torque.cycle.mean"), study.torque.mean);
    assert_eq!(study.command(), "torque");
}

#[test]
fn a_wrong_name_is_told_what_there_is() {
    let engine = engine(V8_GAS);
    let told = |name: &str| named(&engine, name).expect_err("no such value");
    assert!(told("weather.today.rain").contains("there are classify, loads, bearings"));
    assert!(told("torque.weather.rain").contains("there are orders, cycle, flywheel"));
    assert!(told("torque.cycle").contains("which column"));
    assert!(told("torque.cycle.rain").contains("there are mean"));
    // What is most like the name comes first.
    let alike = told("loads.orders.2.moment_smalest");
    assert!(alike.contains("there are moment_smallest, moment_"), "{alike}");
    assert!(told("torque.orders.99.gas").contains("no row `99`"));
    assert!(told("torque.orders.gas").contains("a row is named by order"));
    assert!(told("torque.cycle.1.mean").contains("one row"));
    assert!(told("torsion.modes.1.frequency").contains("[torsion]"));
}

#[track_caller]
fn decimal(single: Result<Single, String>) -> f64 {
    match single.unwrap_or_else(|why| panic!("{why}")).value() {
        Some(Value::Decimal(value)) => value,
        other => panic!("{other:?}"),
    }
}

#[test]
fn an_order_or_an_angle_that_a_question_does_not_tell_by_itself_is_asked_for() {
    let engine = engine(V8_GAS);
    let usual = report::ask("loads", &engine, &[]).expect("a question").expect("loads");
    let orders = usual.table("orders").expect("a table");
    assert!(!(0..orders.rows()).any(|row| orders.columns()[0].values().get(row) == Some(Value::Integer(12))));
    let twelve = report::LoadsStudy::new(&engine, &[12], None).expect("loads").table("orders").expect("a table");
    let expected = twelve.named(&["12"], "force").expect("a force");
    assert_eq!(named(&engine, "loads.orders.12.force").expect("a force"), expected);
    assert!(decimal(named(&engine, "firing.orders.8.length")) > 0.0);
    // The torque at 22.5°: between the values of the table, whose steps are whole degrees.
    let at = |angle: &str| decimal(named(&engine, &format!("angle.torque.{angle}.torque")));
    assert!((at("22") - at("22.5")) * (at("22.5") - at("23")) > 0.0);
    assert_near(
        decimal(named(&engine, "angle.pistons.22.5.1.torque")),
        decimal(named(&engine, "angle.pistons.45/2.1.torque")),
        0.0,
    );
    // What no order is, or no engine has, is told with what there is.
    let told = |name: &str| named(&engine, name).expect_err("no such value");
    assert!(
        told("loads.orders.3/2.force").contains("no row `3/2`; there are 1, 2"),
        "{}",
        told("loads.orders.3/2.force")
    );
    assert!(told("angle.pistons.22.5.99.rod").contains("there are 0, 10, 20"));
}

#[test]
fn the_verdicts_have_names() {
    let engine = engine(V8_GAS);
    let value =
        |name: &str| named(&engine, name).unwrap_or_else(|why| panic!("{why}")).value().map(|one| one.to_string());
    assert_eq!(value("classify.orders.2.force_vanishes").as_deref(), Some("true"));
    assert_eq!(value("classify.orders.2.masses").as_deref(), Some("all"));
    assert_eq!(value("classify.sums.1.direct.force_vanishes").as_deref(), Some("true"));
    assert_eq!(value("classify.orders.44.moment_shape").as_deref(), Some("balanced"));
    assert_eq!(value("classify.torque.4.torque_vanishes").as_deref(), Some("false"));
}

/// The stars of unlike rods are one row each: none of them tells of the order.
#[test]
fn parts_that_differ_have_no_one_value() {
    let engine = engine(
        "cycle = 'two-stroke'\nfiring_angles = [0, 90, 180, 200]\n[mechanism]\nrod_ratio = [0.25, 0.3, 0.25, 0.3]\n\
         [inline]\nthrows = [0, 270, 180, 160]\n",
    );
    for name in ["firing.orders.1.vanishes", "firing.orders.1.length", "classify.torque.1.torque_vanishes"] {
        let why = named(&engine, name).expect_err("two rods");
        assert!(why.contains("2 rows have these keys and differ"), "{name}: {why}");
    }
    assert_eq!(
        named(&engine, "firing.orders.1.major").expect("alike in both").value().map(|one| one.to_string()).as_deref(),
        Some("false")
    );
    let why = named(&engine, "classify.orders.2.force").expect_err("two rods");
    assert!(why.contains("it is told of each part alone: cylinders 1, 3; cylinders 2, 4"), "{why}");
    assert!(named(&engine, "classify.orders.2.force_vanishes").is_ok(), "the order has a verdict");
}

#[test]
fn shafts_and_diagrams_have_values_and_say_which_file_another_question_reads() {
    let folder = scratch("values-files");
    let path = |name: &str, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).expect("a file");
        path.to_str().expect("a path").to_owned()
    };
    let (shaft, diagram) = (path("shaft.toml", SHAFT), path("diagram.toml", DIAGRAM));
    let asked =
        ["values", &shaft, &diagram, "I4", "--value", "rotor.masses.1.X.mass", "--value", "flywheel.values.inertia"];
    let output = call(&asked.iter().copied().chain(["--format", "json"]).collect::<Vec<_>>());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let cell = |row: usize, column: &str| json["values"][row][column].clone();
    let kilograms = cell(0, "rotor_masses_1_X_mass_kg").as_f64().expect("a mass");
    // Rattan, Theory of Machines: the masses X and Y of the shaft with four masses; computed twice, 1e-14.
    assert_near(kilograms, 352.972_118_655, 1e-9);
    // The triangles of 200, 600, 3000 and 300 N m at 300 rpm and C_s 0.02: 244205π/192 J, I = ΔE/C_s ω².
    assert_near(cell(1, "flywheel_values_inertia_kg_m2").as_f64().expect("an inertia"), 202.429_338, 1e-6);
    let why = |row: usize, column: &str| cell(row, column).as_str().unwrap_or_default().to_owned();
    assert!(why(1, "rotor_masses_1_X_mass_missing").contains("masses on a shaft"));
    assert!(why(2, "rotor_masses_1_X_mass_missing").contains("masses on a shaft"));
    assert!(why(2, "flywheel_values_inertia_missing").contains("torque.flywheel.inertia"));
    let output = call(&["values", &shaft, "--value", "loads.largest.force", "--format", "csv"]);
    assert!(String::from_utf8_lossy(&output.stdout).contains("the layout of an engine"));
}

#[test]
fn a_file_that_cannot_be_read_has_a_row_with_its_reason_beside_those_of_the_others() {
    let wrong = scratch("values-wrong").join("wrong.toml");
    std::fs::write(&wrong, "[[mass]]\nmass = 'heavy'\n").expect("a file");
    let wrong = wrong.to_str().expect("a path");
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples/v8-gas/layout.toml");
    let values = ["--value", "loads.orders.2.force", "--value", "loads.orders.2.moment"];
    let run = |more: &[&str]| call(&[&["values", wrong, layout], &values[..], more].concat());
    let output = run(&["--format", "csv"]);
    assert_eq!(output.status.code(), Some(1));
    // The message has the place in the file.
    assert!(String::from_utf8_lossy(&output.stderr).contains("wrong.toml:2"));
    let csv = String::from_utf8(output.stdout).expect("a text");
    let lines: Vec<&str> = csv.lines().collect();
    assert!(
        lines.len() == 3 && lines[1].contains("the file cannot be read: ") && !lines[2].contains("cannot"),
        "{csv}"
    );
    let told = String::from_utf8(run(&[]).stdout).expect("a text");
    assert_eq!(told.matches("cannot be read").count(), 1, "{told}");
    let missing = call(&["values", "no-such.toml", layout, "--value", "loads.orders.2.force"]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&missing.stdout).contains("layout.toml"));
}

#[test]
fn the_command_tabulates_values_of_many_layouts_and_says_why_one_has_none() {
    let folder = scratch("values");
    let layout = folder.join("v8.toml");
    std::fs::write(&layout, V8_GAS).expect("a file");
    let layout = layout.to_str().expect("a path");
    let asked = ["values", layout, "I4", layout, "--value", "bearings.worst.force", "--value", "torque.cycle.mean"];
    let run = |more: &[&str]| {
        let output = call(&asked.iter().chain(more).copied().collect::<Vec<_>>());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("a text")
    };
    let csv = run(&["--format", "csv"]);
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 4);
    assert!(lines[0].starts_with("engine,bearings_worst_force_N,bearings_worst_force_missing,torque_cycle_mean_N_m,"));
    assert!(lines[2].starts_with("I4,,") && lines[2].contains("bearings"), "{}", lines[2]);
    assert_eq!(lines[1], lines[3]);
    let text = run(&[]);
    assert!(text.contains("I4 has no bearings.worst.force:"), "{text}");
    let json: serde_json::Value = serde_json::from_str(&run(&["--format", "json"])).expect("JSON");
    assert_eq!(json["values"][1]["bearings_worst_force_N"], serde_json::Value::Null);
}

/// Newtons and multiples of m r ω² are in no column together, and what its own table leaves empty has a reason too.
#[test]
fn a_value_in_another_unit_than_its_column_is_left_out_with_the_reason() {
    let folder = scratch("values-units");
    let heavy =
        "inline.throws = [0]\nmechanism = { stroke = '80 mm', rod_length = '150 mm', reciprocating_mass = '0.5 kg' }\n";
    let files =
        [("heavy.toml", format!("speed = 3000\n{heavy}")), ("light.toml", heavy.to_owned())].map(|(name, text)| {
            let path = folder.join(name);
            std::fs::write(&path, text).expect("a layout");
            path.to_str().expect("a path").to_owned()
        });
    let ask = |files: [&String; 2], more: &[&str]| {
        let output = call(&[&["values", files[0], files[1], "--value", "loads.orders.1.force"], more].concat());
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let [heavy, light] = &files;
    assert!(ask([heavy, light], &[]).contains("it is in m r ω², unlike the column"));
    assert!(ask([light, heavy], &[]).contains("it is in N, unlike the column"));
    assert!(
        ask([heavy, light], &["--format", "csv"]).ends_with("light.toml,,\"it is in m r ω², unlike the column\"\n")
    );
    let told = call(&[
        "values",
        "I4",
        heavy,
        "--value",
        "classify.sums.1.direct.moment_modulus_exact",
        "--value",
        "loads.orders.1.force",
    ]);
    assert!(String::from_utf8_lossy(&told.stdout).contains("the layout gives no rods"));
    let alone = ["compare", heavy, light, "--format", "csv", "--value", "loads.orders.1.force"];
    let told = |more: &[&str]| String::from_utf8(call(&[&alone[..], more].concat()).stderr).expect("UTF-8");
    assert!(
        told(&[]).contains("--value asks for is in the table `engines`, which is not written: add --table engines")
    );
    assert_eq!(told(&["--table", "engines"]), "");
}

#[test]
fn values_are_in_the_units_of_their_headings() {
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples/v8-gas/layout.toml");
    let newtons = decimal(named(&engine(V8_GAS), "bearings.worst.force"));
    let output = call(&["values", layout, "--value", "bearings.worst.force", "--units", "inch"]);
    let told = String::from_utf8(output.stdout).expect("a text");
    // A pound-force is 4.4482216152605 N.
    let pounds = format!("≈ {:.0}", newtons / 4.448_221_615_260_5);
    assert!(told.contains("in lbf") && told.contains(&pounds), "{told}");
}

#[test]
fn a_sweep_has_values_of_any_question_beside_its_points_in_every_way_to_compute_it() {
    let folder = scratch("values-sweep");
    let (layout, rows) = (folder.join("v8.toml"), folder.join("rows.csv"));
    std::fs::write(&layout, V8_GAS).expect("a file");
    let layout = layout.to_str().expect("a path");
    let sweep = ["sweep", layout, "--set", "speed=2000..4000:1000", "--value", "bearings.worst.force"];
    let run = |more: &[&str]| {
        let output = call(&sweep.iter().chain(more).copied().collect::<Vec<_>>());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("a text")
    };
    let streamed = run(&["--format", "csv"]);
    let header = streamed.lines().next().expect("a header");
    let place = header.split(',').position(|name| name == "bearings_worst_force_N").expect("the column");
    let forces: Vec<f64> = streamed
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(place).expect("a field").parse().expect("a number"))
        .collect();
    let expected: Vec<f64> = [2000, 3000, 4000]
        .iter()
        .map(|speed| {
            let text = V8_GAS.replace("speed = \"4000 rpm\"", &format!("speed = {speed}"));
            let engine = engine(&text);
            match named(&engine, "bearings.worst.force").expect("a value").value() {
                Some(Value::Decimal(force)) => force,
                other => panic!("{other:?}"),
            }
        })
        .collect();
    assert_eq!(forces, expected);
    // The answer tells the least and the greatest, the page every point, in the units of its reader.
    let told = |more: &[&str]| run(more).split_whitespace().collect::<Vec<_>>().join(" ");
    let answer = told(&[]);
    let about = |kilonewtons: f64| format!("{kilonewtons:.1} kN");
    let (least, most) = (about(forces[0].min(forces[2]) / 1e3), about(forces[0].max(forces[2]) / 1e3));
    assert!(answer.contains("bearings.worst.force: from "), "{answer}");
    assert!(answer.contains(&least) && answer.contains(&most), "{answer}");
    let page = told(&["--format", "text"]);
    assert!(page.contains("bearings.worst.force in N") && page.contains(&format!("≈ {:.0}", forces[1])), "{page}");
    assert!(told(&["--lang", "de"]).contains("bearings.worst.force: von 28,9 kN bei 4000 "));
    // A folder of tables, and two shards merged, hold the same rows.
    run(&["--format", "csv", "--output", folder.join("all").to_str().expect("a path")]);
    assert_eq!(std::fs::read_to_string(folder.join("all/sweep.csv")).expect("the points"), streamed);
    let shard = folder.join("one.shard");
    let shard = shard.to_str().expect("a path");
    run(&["--shard", "1/1", "--output", shard]);
    run(&["--merge", shard, "--format", "csv", "--output", rows.to_str().expect("a path")]);
    assert_eq!(std::fs::read_to_string(rows).expect("the rows"), streamed);
    let refused = call(&["sweep", "I4", "--bank-angle", "0..1:1", "--value", "torsion.modes.1.frequency"]);
    assert!(!refused.status.success());
}
