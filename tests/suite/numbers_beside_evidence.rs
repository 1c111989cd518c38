//! Does a document of loads or of a comparison say nothing that is not checked, but numbers? Every field outside of the evidence is
//! changed, and both checkers say the same of it.

use std::fs;
use std::path::PathBuf;

use crankstar::proof::read_document;
use serde_json::{Value, json};

use crate::support::mutations::{Step, at, changes, walk, written};
use crate::support::program::{call, scratch};
use crate::support::second::{self, second_checker};

const COUNTERWEIGHT: &str = "inline.throws = [0, 120, 240]\n[mechanism]\nrod_ratio = '1/4'\nrotating_mass = '1/3'\nreciprocating_mass = 1\ncrank_radius = '40 mm'\n\
                             [[counterweight]]\nangle = 20\nmass_radius = '1/5'\nposition = 1\n";
const IN_NEWTONS: &str = "speed = '6000 rpm'\neffects = ['torque']\n[square_four]\nin_phase = 'sides'\nsense = 'with'\ndistance = '120 mm'\nspacing = '0.1 m'\n\
                          [mechanism]\nreciprocating_mass = '0.6 kg'\ncrank_radius = '40 mm'\nrod_ratio = 0.25\n";

fn document(folder: &str, text: &str, arguments: &[&str]) -> Value {
    let file = scratch(folder).join("engine.toml");
    fs::write(&file, text).expect("written");
    let arguments: Vec<&str> =
        arguments.iter().map(|one| if *one == "FILE" { file.to_str().expect("UTF-8") } else { one }).collect();
    let output = call(&arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn accepts(tree: &Value) -> bool {
    read_document(tree.to_string().as_bytes()).is_ok_and(|document| document.check().is_ok())
}

/// The parts that are numbers and no more: a part may be left out, and of a list any of them.
const PARTS: [&str; 3] = ["inertia_torque", "auto", "worst_bearing_with_gas"];
const LISTS: [&str; 3] = ["coefficients", "intervals_deg", "bearings"];
/// Where there may be no number.
const NONE: [&str; 12] = [
    "angle_deg",
    "direction_deg",
    "phase_deg",
    "theta_deg",
    "crank_angle_deg",
    "part",
    "below",
    "firing",
    "newtons",
    "worst_bearings",
    "force",
    "inertia_torque",
];
/// The numbers that may be below 0; all others are sizes.
const SIGNED: [&str; 9] =
    ["re", "im", "angle_deg", "direction_deg", "phase_deg", "theta_deg", "crank_angle_deg", "effects", "looked_at"];

/// Whether a change is one of numbers that say nothing of zero, of which nothing is checked.
fn is_of_numbers(path: &str, before: &Value, after: &Value) -> bool {
    let key = path.trim_end_matches("[]").rsplit('.').next().expect("a key");
    let is_nothing = |value: &Value| value.as_f64() == Some(0.0);
    let is_left_out = path.starts_with(".left_out");
    let is_of_an_order = path.starts_with(".orders[]")
        || path.starts_with(".torque[]")
        || path.starts_with(".roll[]")
        || path.starts_with(".engines[].orders[]")
        || path.starts_with(".engines[].newtons[]");
    let is_size = is_of_an_order && ["amplitude", "largest", "dimensionless", "force", "moment"].contains(&key)
        || path.starts_with(".scale")
        || path.starts_with(".peaks") && key == "value";
    let may_be_null = NONE.contains(&key) && (key != "force" || is_left_out) || is_left_out && key == "moment";
    match (before, after) {
        (_, Value::Null) => may_be_null && !is_size,
        (Value::Null, Value::Number(_)) => may_be_null && !is_size,
        (Value::Number(_), Value::Number(after_it)) => {
            !(is_size && is_nothing(before) != is_nothing(after))
                && (SIGNED.contains(&key) || after_it.as_f64().is_some_and(|size| size >= 0.0))
                && !(key == "order" && is_of_an_order)
                && path != ".orders[]"
        }
        // The evidence is about the orders of force and torque together: an order of one may be left out where the other has it.
        (Value::Array(before), Value::Array(after)) if [".orders", ".torque"].contains(&path) => {
            after.len() < before.len()
        }
        (Value::Array(_), Value::Array(_)) => LISTS.contains(&key) && !path.ends_with("[]"),
        (Value::Object(before), Value::Object(after)) => {
            before.keys().filter(|key| !after.contains_key(*key)).all(|key| PARTS.contains(&key.as_str()))
                && after.keys().all(|key| before.contains_key(key))
        }
        _ => false,
    }
}

/// Makes every change outside of the evidence: those that are accepted are of numbers, and both checkers say the same.
#[track_caller]
fn assert_guarded(name: &str, genuine: &Value) {
    assert!(
        accepts(genuine),
        "the genuine one: {:?}",
        read_document(genuine.to_string().as_bytes()).map(|one| one.check().err())
    );
    let mut outside = genuine.clone();
    outside.as_object_mut().expect("an object").remove("evidence");
    let mut places = Vec::new();
    walk(&outside, &mut Vec::new(), &mut places);
    let folder = scratch(name);
    let (mut files, mut tried) = (Vec::<PathBuf>::new(), Vec::new());
    for (path, before) in &places {
        let told = written(path);
        let mut others = changes(before);
        if let Value::Object(map) = before {
            for key in ["vanishes", "exists", "shape", "remedy", "first_force_left", "even"] {
                let mut more = map.clone();
                more.insert(key.to_owned(), json!(true));
                others.push(json!(more));
            }
        }
        for mut after in others.into_iter().filter(|after| after != before) {
            let about = format!("{told}: {before} became {after}");
            let may_hold = is_of_numbers(&told, before, &after);
            let mut changed = genuine.clone();
            if let (true, Some(root)) = (path.is_empty(), after.as_object_mut()) {
                root.insert("evidence".to_owned(), genuine["evidence"].clone());
            }
            *at(&mut changed, path) = after;
            let holds = accepts(&changed);
            assert!(may_hold || !holds, "{about} and is accepted");
            let file = folder.join(format!("{}.json", files.len()));
            fs::write(&file, changed.to_string()).expect("written");
            files.push(file);
            tried.push((holds, about));
        }
    }
    let refused = tried.iter().filter(|(holds, _)| !holds).count();
    println!("{name}: {} changes, {refused} refused", tried.len());
    assert!(refused > tried.len() / 2, "{refused} of {} are refused", tried.len());
    let Some((told, _)) = second_checker(&files) else { return };
    let answers: Vec<&str> = told.lines().filter(|line| !line.starts_with("  not checked: ")).collect();
    assert_eq!(answers.len(), files.len());
    for (line, (holds, about)) in answers.iter().zip(&tried) {
        assert_eq!(line.contains(": verified, "), *holds, "{about}: {line}");
    }
}

#[test]
fn every_change_of_loads_but_of_their_numbers_is_refused_by_both_checkers() {
    let arguments = ["loads", "FILE", "--orders", "1,2,3", "--json"];
    assert_guarded("loads-beside-changes", &document("loads-beside", COUNTERWEIGHT, &arguments));
    let arguments = ["loads", "FILE", "--orders", "1,2", "--json"];
    assert_guarded("newtons-beside-changes", &document("newtons-beside", IN_NEWTONS, &arguments));
}

#[test]
fn every_change_of_a_comparison_but_of_its_numbers_is_refused_by_both_checkers() {
    let arguments = ["compare", "FILE", "I3", "--orders", "1,3", "--json"];
    let compare = document("compare-beside", COUNTERWEIGHT, &arguments);
    assert_guarded("compare-beside-changes", &compare);
    let arguments = ["compare", "FILE", "I3", "--orders", "1,2", "--json"];
    let compare = document("compare-newtons", IN_NEWTONS, &arguments);
    assert!(compare["engines"][0]["newtons"].is_array());
    assert_guarded("compare-newtons-changes", &compare);
}

/// No truth stands beside the evidence, and no text but titles, units and names of masses.
#[test]
fn documents_of_numbers_say_nothing_that_the_evidence_says() {
    let loads = document("loads-says", COUNTERWEIGHT, &["loads", "FILE", "--json"]);
    let compare = document("compare-says", COUNTERWEIGHT, &["compare", "FILE", "V8-crossplane", "--json"]);
    for mut outside in [loads, compare] {
        outside.as_object_mut().expect("an object").remove("evidence");
        let mut places = Vec::new();
        walk(&outside, &mut Vec::<Step>::new(), &mut places);
        for (path, value) in places {
            let told = written(&path);
            assert!(!value.is_boolean(), "{told}");
            let is_label = ["format", "title", "amplitudes", "quantity", "unit", "position_unit"]
                .contains(&told.rsplit('.').next().expect("a key"))
                || told.starts_with(".units")
                || told.contains("effects[]");
            assert!(!value.is_string() || is_label, "{told}: {value}");
        }
    }
}

/// Rods that differ by 10⁻⁶⁰: a size is given, and 0, which nobody proved, is not.
#[test]
fn the_size_of_an_order_that_is_not_decided_may_be_any_but_0() {
    let less = format!("0.24{}", "9".repeat(58));
    let text = format!(
        "inline = {{ throws = [0, 0, 90, 90], spacing = 1 }}\n\
         mechanism = {{ rod_ratio = [0.25, 0.25, \"{less}\", \"{less}\"], reciprocating_mass = 1 }}"
    );
    let genuine = document("numbers-undecided", &text, &["loads", "FILE", "--orders", "2", "--json"]);
    assert_eq!(genuine["evidence"][0]["wholes"][0]["outcome"].as_object().expect("not decided").len(), 1);
    let with = |size: f64| {
        let mut changed = genuine.clone();
        changed["orders"][0]["direct"]["amplitude"] = json!(size);
        changed
    };
    let (other, none) = (with(1e-61), with(0.0));
    assert!(accepts(&genuine) && accepts(&other) && !accepts(&none));
    second::accepts(&[&genuine, &other], &[]);
    second::refuses(&[("0", &none)]);
}

/// Checks that a document is accepted and none in which other values stand at these places.
#[track_caller]
fn assert_refused(genuine: &Value, cheats: &[(&str, &[(&str, Value)])]) {
    assert!(accepts(genuine));
    let with = |changes: &[(&str, Value)]| {
        let mut changed = genuine.clone();
        for (place, value) in changes {
            *changed.pointer_mut(place).unwrap_or_else(|| panic!("no {place}")) = value.clone();
        }
        changed
    };
    let changed: Vec<(&str, Value)> = cheats.iter().map(|(name, changes)| (*name, with(changes))).collect();
    for (name, cheat) in &changed {
        assert!(cheat != genuine && !accepts(cheat), "{name}");
    }
    second::accepts(&[genuine], &[]);
    second::refuses(&changed);
}

#[test]
fn no_size_is_0_and_no_bound_or_direction_stands_where_the_evidence_says_otherwise() {
    let genuine = document("numbers-cheats", IN_NEWTONS, &["loads", "FILE", "--orders", "1,2", "--json"]);
    let is_zero = |order: &Value| order["largest"] == json!(0.0);
    let orders = genuine["orders"].as_array().expect("orders");
    let zero = orders.iter().position(is_zero).expect("an order that is zero");
    let angle = format!("/orders/{zero}/direct/angle_deg");
    let along = format!("/orders/{zero}/along");
    let below = format!("/orders/{}/direct/below", orders.iter().position(|one| !is_zero(one)).expect("another"));
    let mut at_rest = vec![
        ("/scale/m_r_omega_squared_n".to_owned(), json!(0.0)),
        ("/scale/angular_speed_rad_s".to_owned(), json!(0.0)),
    ];
    for (index, _) in orders.iter().enumerate() {
        let places = ["direct/amplitude", "reverse/amplitude", "largest"];
        at_rest.extend(places.map(|place| (format!("/orders/{index}/{place}"), json!(0.0))));
    }
    let at_rest: Vec<(&str, Value)> = at_rest.iter().map(|(place, value)| (place.as_str(), value.clone())).collect();
    assert_refused(
        &genuine,
        &[
            ("at rest, with a speed", &at_rest),
            ("no speed, and newtons", &[("/scale/speed_rpm", json!(0.0))]),
            ("no mass", &[("/scale/mass_kg", json!(0.0))]),
            ("newtons without a scale", &[("/scale", Value::Null)]),
            ("multiples with a scale", &[("/units/force", json!("m r ω²"))]),
            ("a direction of nothing", &[(&angle, json!(10.0))]),
            ("a bound of what is decided", &[(&below, json!(1.0))]),
            ("no peak", &[("/peaks/force/value", json!(0.0))]),
            ("a largest of 0", &[("/largest/force/value", json!(0.0))]),
            ("a peak below 0", &[("/peaks/moment/value", json!(-1.0))]),
            ("an effect twice", &[("/effects", json!(["reciprocating", "reciprocating"]))]),
            (
                "no effect",
                &[("/effects", json!([])), ("/peaks/force/effects", json!([])), ("/peaks/moment/effects", json!([]))],
            ),
            (
                "no orders, so that the largest is 0",
                &[
                    ("/orders", json!([])),
                    ("/coefficients", json!([])),
                    ("/peaks/force/value", json!(0.0)),
                    ("/peaks/moment/value", json!(0.0)),
                    ("/largest/force/value", json!(0.0)),
                    ("/largest/moment/value", json!(0.0)),
                ],
            ),
            ("a part of nothing", &[(&along, json!(5.0))]),
            ("another effect", &[("/effects", json!(["balancers"]))]),
            ("a coefficient of another order", &[("/coefficients/0/order", json!(7))]),
            ("the roll moment of another order", &[("/roll/0/order", json!(7))]),
            ("no roll moment", &[("/roll/1/amplitude", json!(0.0))]),
        ],
    );
}

#[test]
fn a_comparison_says_neither_more_nor_less_of_zero_than_its_evidence() {
    // Of rods that differ an order has several sums.
    let rods = "speed = '1000 rpm'\ninline = { throws = [0, 90], spacing = '0.1 m' }\n[mechanism]\nrod_ratio = [0.25, 0.3]\nreciprocating_mass = '1 kg'\ncrank_radius = '40 mm'";
    let genuine = document("numbers-compare", rods, &["compare", "FILE", "I4", "--orders", "1,2,3", "--json"]);
    assert_eq!(genuine["engines"][0]["orders"][1]["force"]["largest"], Value::Null);
    let newtons =
        |value: f64| move |(order, key): (usize, &str)| (format!("/engines/0/newtons/{order}/{key}"), json!(value));
    let one = newtons(0.0)((0, "force"));
    let two = newtons(3.0)((2, "force"));
    let newtons = genuine["engines"][0]["newtons"].as_array().expect("newtons").len();
    let at_rest: Vec<(String, Value)> = (0..newtons)
        .flat_map(|order| ["force", "moment"].map(|key| (format!("/engines/0/newtons/{order}/{key}"), json!(0.0))))
        .collect();
    let at_rest: Vec<(&str, Value)> = at_rest.iter().map(|(place, value)| (place.as_str(), value.clone())).collect();
    assert_refused(
        &genuine,
        &[
            ("no length of one sum", &[("/engines/0/orders/0/force/largest", Value::Null)]),
            ("a length of several", &[("/engines/0/orders/1/force/largest", json!(1.0))]),
            ("0 of several", &[("/engines/0/orders/1/force/largest", json!(0.0))]),
            ("a length below 0", &[("/engines/0/orders/0/force/largest", json!(-1.0))]),
            ("no newtons", &[(&one.0, one.1.clone())]),
            ("newtons of what is zero", &[(&two.0, two.1.clone())]),
            ("at rest, which has no newtons", &at_rest),
            ("an interval below 0", &[("/engines/1/firing/intervals_deg/0", json!(-180.0))]),
        ],
    );
}

#[test]
fn an_engine_at_rest_has_no_newtons_to_compare() {
    let still = "speed = 0\ninline = { throws = [0, 90], spacing = '0.1 m' }\n\
                 mechanism = { crank_radius = 0.05, rod_ratio = 0.25, reciprocating_mass = 1 }";
    let compare = document("compare-at-rest", still, &["compare", "FILE", "I4", "--orders", "1", "--json"]);
    assert_eq!(compare["engines"][0]["newtons"], Value::Null);
    assert!(accepts(&compare));
    second::accepts(&[compare], &[]);
}

/// The smallest sizes that are read.
#[test]
fn what_is_not_zero_is_not_0_however_small_it_is() {
    let text = "speed = '1e-40 rpm'\neffects = ['torque']\ninline = { throws = [0, 90], spacing = '0.1 m' }\n\
                mechanism = { crank_radius = '1e-40 m', rod_ratio = 0.25, reciprocating_mass = '1e-40 kg' }";
    let loads = document("numbers-small", text, &["loads", "FILE", "--orders", "1", "--json"]);
    let compare = document("numbers-small-compare", text, &["compare", "FILE", "FILE", "--orders", "1", "--json"]);
    assert!(accepts(&loads) && accepts(&compare));
    second::accepts(&[loads, compare], &[]);
}

/// At rest all is 0 in newtons, and the multiples tell what is zero.
#[test]
fn loads_of_an_engine_at_rest_are_0_in_newtons_alone() {
    let text = "speed = 0\neffects = ['torque']\ninline = { throws = [0, 90], spacing = '0.1 m' }\n\
                mechanism = { crank_radius = 0.05, rod_ratio = 0.25, reciprocating_mass = 1 }";
    let genuine = document("numbers-at-rest", text, &["loads", "FILE", "--orders", "1", "--json"]);
    assert_refused(
        &genuine,
        &[
            ("a force at rest", &[("/orders/0/direct/amplitude", json!(1.0))]),
            ("no multiple", &[("/orders/0/dimensionless", json!(0.0))]),
            ("no multiple of the torque", &[("/torque/0/dimensionless", json!(0.0))]),
            ("no rest", &[("/scale/m_r_omega_squared_n", json!(1.0))]),
            ("a peak at rest", &[("/peaks/force/value", json!(1.0))]),
            ("a largest at rest", &[("/largest/force/value", json!(1.0))]),
        ],
    );
}

#[test]
fn the_engine_of_a_document_of_numbers_is_compared_with_a_layout() {
    let folder = scratch("numbers-engine");
    let file = |name: &str, arguments: &[&str]| {
        let path = folder.join(name);
        fs::write(&path, call(arguments).stdout).expect("written");
        path.to_str().expect("UTF-8").to_owned()
    };
    let layout = folder.join("engine.toml");
    fs::write(&layout, COUNTERWEIGHT).expect("written");
    let layout = layout.to_str().expect("UTF-8");
    let loads = file("loads.json", &["loads", layout, "--json"]);
    let compare = file("compare.json", &["compare", "I4", "V8-crossplane", "--json"]);
    let holds: [&[&str]; 2] =
        [&["verify", &loads, "--engine", layout], &["verify", &compare, "--engine", "I4", "--engine", "V8-crossplane"]];
    for arguments in holds {
        let output = call(arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let refused: [(&[&str], &str); 4] = [
        (&["verify", &loads, "--engine", "I4"], "the engine is not that of I4"),
        (&["verify", &loads, "--engine", layout, "--engine", layout], "1 engine"),
        (
            &["verify", &compare, "--engine", "V8-crossplane", "--engine", "I4"],
            "the engine is not that of V8-crossplane",
        ),
        (&["verify", &compare, "--engine", "I4"], "2 engines"),
    ];
    for (arguments, words) in refused {
        let output = call(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && error.contains(words), "{error}");
    }
}
