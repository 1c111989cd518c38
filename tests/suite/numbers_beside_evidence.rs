//! Does a document of loads or of a comparison say nothing that is not checked, but what it names itself? Every field outside of the
//! evidence is changed, and both checkers say the same of it.

use std::fs;
use std::path::PathBuf;

use crankstar::proof::{COMPARE_NOT_CHECKED, LOADS_NOT_CHECKED, read_document};
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
const LISTS: [&str; 2] = ["intervals_deg", "bearings"];
/// Where there may be no number.
const NONE: [&str; 7] = ["theta_deg", "crank_angle_deg", "part", "firing", "worst_bearings", "force", "inertia_torque"];
/// The numbers that may be below 0; all others are sizes.
const SIGNED: [&str; 4] = ["theta_deg", "crank_angle_deg", "effects", "looked_at"];

/// Whether the document itself says that this is not checked.
fn is_named(path: &str) -> bool {
    let inside = |root: &str, names: &[&str]| names.iter().any(|name| path.starts_with(&format!("{root}.{name}")));
    inside("", &LOADS_NOT_CHECKED) || inside(".engines[]", &COMPARE_NOT_CHECKED)
}

/// Whether a change may be accepted: of what the document names as not checked, and of digits that no decimal has.
fn is_of_numbers(path: &str, before: &Value, after: &Value) -> bool {
    let key = path.trim_end_matches("[]").rsplit('.').next().expect("a key");
    let is_nothing = |value: &Value| value.as_f64() == Some(0.0);
    let is_left_out = path.starts_with(".left_out");
    let is_size = path.starts_with(".peaks") && key == "value";
    let may_be_null = NONE.contains(&key) && (key != "force" || is_left_out) || is_left_out && key == "moment";
    match (before, after) {
        (Value::Number(one), Value::Number(other)) if !is_named(path) => {
            let apart = one.as_f64().zip(other.as_f64()).map(|(one, other)| (one - other).abs());
            apart.is_some_and(|apart| apart < 1e-9) && one.is_f64()
        }
        (Value::Number(_), Value::Number(after_it)) => {
            !(is_size && is_nothing(before) != is_nothing(after))
                && (SIGNED.contains(&key) || after_it.as_f64().is_some_and(|size| size >= 0.0))
        }
        (_, Value::Null) | (Value::Null, Value::Number(_)) => is_named(path) && may_be_null && !is_size,
        // The evidence is about the orders of force and torque together: an order of one may be left out where the other has it.
        (Value::Array(before), Value::Array(after)) if [".orders", ".torque", ".coefficients"].contains(&path) => {
            after.len() < before.len()
        }
        (Value::Array(_), Value::Array(_)) => is_named(path) && LISTS.contains(&key) && !path.ends_with("[]"),
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
                || told == ".not_checked[]"
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

/// A rod with an offset, whose number has two parts; another mass of one piston; balancer shafts turn at order 2.
const OFFSET: &str = "speed = '3000 rpm'\neffects = ['torque']\nvee = { bank_angle = 60, throws = [0, 130], spacing = '0.1 m' }\n\
                      [mechanism]\nrod_ratio = 0.28\noffset_ratio = '-0.1'\nreciprocating_mass = ['1 kg', '1.1 kg', '1 kg', '1 kg']\ncrank_radius = '40 mm'\n";
const LINKS: &str = "radial.cylinders = 3\n[mechanism]\nrod_ratio = '1/4'\nreciprocating_mass = [2, 1, 1]\n\
                     [articulated]\nmaster = 1\nknuckle_ratio = '1/5'\nknuckle_mass = '1/3'\n";

#[test]
fn sizes_and_directions_are_those_of_the_sums_in_the_evidence() {
    for (name, text) in [("numbers-offset", OFFSET), ("numbers-links", LINKS), ("numbers-newtons", IN_NEWTONS)] {
        let genuine = document(name, text, &["loads", "FILE", "--orders", "1,2,3", "--json"]);
        let mut cheats = Vec::new();
        for list in ["orders", "torque", "roll", "coefficients"] {
            for index in 0..genuine[list].as_array().map_or(0, Vec::len) {
                for key in [
                    "direct/amplitude",
                    "direct/angle_deg",
                    "reverse/amplitude",
                    "reverse/angle_deg",
                    "largest",
                    "smallest",
                    "along",
                    "across",
                    "direction_deg",
                    "dimensionless",
                    "amplitude",
                    "phase_deg",
                    "re",
                    "im",
                ] {
                    let place = format!("/{list}/{index}/{key}");
                    let Some(number) = genuine.pointer(&place).and_then(Value::as_f64) else { continue };
                    cheats.push((place.clone(), json!(number * (1.0 + 1e-6) + 1e-6)));
                    cheats.push((place, Value::Null));
                }
            }
        }
        let cheats: Vec<(&str, [(&str, Value); 1])> =
            cheats.iter().map(|(place, value)| (place.as_str(), [(place.as_str(), value.clone())])).collect();
        let cheats: Vec<(&str, &[(&str, Value)])> =
            cheats.iter().map(|(name, changes)| (*name, &changes[..])).collect();
        assert!(cheats.len() > 40, "{}", cheats.len());
        assert_refused(&genuine, &cheats);
    }
}

/// Each number of a scale follows from the others, and the newtons from it.
#[test]
fn a_scale_of_another_engine_is_refused() {
    let compare = document("scale-compare", OFFSET, &["compare", "FILE", "I4", "--orders", "1,2", "--json"]);
    let loads = document("scale-loads", OFFSET, &["loads", "FILE", "--orders", "1,2", "--json"]);
    for (genuine, root) in [(&compare, "/engines/0/scale"), (&loads, "/scale")] {
        let keys = ["mass_kg", "crank_radius_m", "speed_rpm", "angular_speed_rad_s", "m_r_omega_squared_n"];
        let places = keys.map(|key| format!("{root}/{key}"));
        let twice = |place: &String| {
            (place.clone(), json!(2.0 * genuine.pointer(place).and_then(Value::as_f64).expect("a number")))
        };
        let changed = places.each_ref().map(twice);
        let mut cheats: Vec<[(&str, Value); 1]> = Vec::new();
        cheats.extend(changed.iter().map(|(place, value)| [(place.as_str(), value.clone())]));
        cheats.push([(root, Value::Null)]);
        let cheats: Vec<(&str, &[(&str, Value)])> = cheats.iter().map(|one| (one[0].0, &one[..])).collect();
        assert_refused(genuine, &cheats);
        // Twice the mass, and all that follows from it, but the newtons.
        let heavier = [&changed[0], &changed[4]].map(|(place, value)| (place.as_str(), value.clone()));
        assert_refused(genuine, &[("twice the mass", &heavier)]);
    }
    let places = ["orders/0/force/largest", "orders/1/moment/largest", "newtons/0/force", "newtons/1/moment"];
    let places = places.map(|place| format!("/engines/0/{place}"));
    let more = places.each_ref().map(|place| {
        let size = compare.pointer(place).and_then(Value::as_f64).expect("a size");
        [(place.as_str(), json!(size * (1.0 + 1e-6)))]
    });
    let cheats: Vec<(&str, &[(&str, Value)])> = more.iter().map(|one| (one[0].0, &one[..])).collect();
    assert_refused(&compare, &cheats);
}

/// High orders, whose numbers are small, endless rods, and rods that differ: what the program writes, both checkers take.
#[test]
fn decimals_of_every_kind_of_engine_are_accepted() {
    let row = |rods: &str| {
        format!("inline = {{ throws = [0, 90, 200], spacing = 1 }}\n[mechanism]\n{rods}\nreciprocating_mass = 1\n")
    };
    let texts = [
        (row("rod_ratio = 0.25"), "2,40,80"),
        (row("rod_ratio = '1/1000'"), "1,2,60"),
        (row("rod_ratio = 0"), "1,2"),
        (row("rod_ratio = [0.25, 0.3, 0.6]\noffset_ratio = [0, 0.1, '-0.1']"), "1,2,3,4"),
        ("radial.cylinders = 3\n[mechanism]\nrod_ratio = '1/4'\n[articulated]\nmaster = 1\nknuckle_ratio = '1/5'\nknuckle_correction = [3, -3]".to_owned(), "1,2,3"),
    ];
    let of = |(index, (text, orders)): (usize, &(String, &str))| {
        let name = format!("decimals-{index}");
        let loads = document(&name, text, &["loads", "FILE", "--orders", orders, "--json"]);
        [loads, document(&name, text, &["compare", "FILE", "I3", "--orders", orders, "--json"])]
    };
    let documents: Vec<Value> = texts.iter().enumerate().flat_map(of).collect();
    assert!(documents.iter().all(accepts));
    second::accepts(&documents, &[]);
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
    let other = |name: &str, from: &str, to: &str| {
        let path = folder.join(name);
        fs::write(&path, if from.is_empty() { IN_NEWTONS.to_owned() } else { IN_NEWTONS.replace(from, to) })
            .expect("written");
        path.to_str().expect("UTF-8").to_owned()
    };
    let newtons = other("newtons.toml", "", "");
    let heavier = other("heavier.toml", "0.6 kg", "0.7 kg");
    let faster = other("faster.toml", "6000 rpm", "6001 rpm");
    let of_none = other("none.toml", "speed = '6000 rpm'", "");
    let in_newtons = file("newtons.json", &["loads", &newtons, "--json"]);
    let compared = file("compared.json", &["compare", &newtons, "I4", "--json"]);
    // Numbers are those of all masses.
    let turning = other("turning.toml", "rod_ratio", "rotating_mass = '0.1 kg'\nrod_ratio");
    let differing = [
        (&heavier, "scale.m"),
        (&faster, "scale."),
        (&of_none, "it is null"),
        (&turning, "turning_masses[0] is nothing"),
    ];
    for (other, words) in differing {
        let loads = call(&["verify", &in_newtons, "--engine", other]);
        let compare = call(&["verify", &compared, "--engine", other, "--engine", "I4"]);
        for output in [loads, compare] {
            let error = String::from_utf8_lossy(&output.stderr);
            assert!(
                !output.status.success() && error.contains("the engine is not that of") && error.contains(words),
                "{error}"
            );
        }
    }
    let holds: [&[&str]; 4] = [
        &["verify", &in_newtons, "--engine", &newtons],
        &["verify", &compared, "--engine", &newtons, "--engine", "I4"],
        &["verify", &loads, "--engine", layout],
        &["verify", &compare, "--engine", "I4", "--engine", "V8-crossplane"],
    ];
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
