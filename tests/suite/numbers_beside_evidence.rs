//! Does a document of loads or of a comparison say nothing that is not checked, but numbers? Every field outside of the evidence is
//! changed, and both checkers say the same of it.

use std::fs;
use std::path::PathBuf;

use crankstar::proof::read_document;
use serde_json::{Value, json};

use crate::document_mutations::{Step, at, changes, walk, written};
use crate::support::program::{call, scratch};
use crate::support::second::second_checker;

const LOADS: &str = "inline.throws = [0, 120, 240]\n[mechanism]\nrod_ratio = '1/4'\nrotating_mass = '1/3'\nreciprocating_mass = 1\ncrank_radius = '40 mm'\n\
                     [[counterweight]]\nangle = 20\nmass_radius = '1/5'\nposition = 1\n";

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

/// What may become another without a word: a number that says nothing of zero, and a label.
fn is_number(path: &str, before: &Value, after: &Value) -> bool {
    let is_told = |value: &Value| value.is_number() || value.is_null();
    let is_size =
        path.ends_with(".amplitude") || path.contains(".orders[].force.") || path.contains(".orders[].moment.");
    let zero = |value: &Value| value.as_f64() == Some(0.0);
    match (before, after) {
        (Value::Array(_), Value::Array(_)) => {
            [".coefficients", ".newtons", ".intervals_deg", ".bearings", ".effects", ".roll", ".dropped", ".kept"]
                .iter()
                .any(|key| path.ends_with(key))
                || path.ends_with("_kept")
                || path.ends_with("_dropped")
        }
        (Value::Array(_) | Value::Object(_), Value::Null) => [
            ".scale",
            ".newtons",
            ".firing",
            ".worst_bearings",
            ".left_out.force",
            ".left_out.moment",
            ".left_out.inertia_torque",
        ]
        .contains(&path.trim_start_matches(".engines[]")),
        (Value::Null, Value::Array(after)) => after.is_empty() && path.ends_with(".newtons"),
        (Value::Object(_), Value::Object(_)) => {
            [("below"), ("inertia_torque"), ("torque"), ("roll"), ("auto"), ("worst_bearing_with_gas")]
                .iter()
                .any(|key| before.get(key).is_some() && after.get(key).is_none())
        }
        (Value::String(_), Value::String(_)) => !path.ends_with(".title"),
        _ => {
            is_told(before)
                && is_told(after)
                && !(is_size && zero(before) != zero(after))
                && !path.ends_with("orders[].order")
        }
    }
}

fn assert_guarded(name: &str, genuine: &Value) {
    assert!(accepts(genuine), "the genuine one");
    let mut places = Vec::new();
    let mut outside = genuine.clone();
    outside.as_object_mut().expect("an object").remove("evidence");
    walk(&outside, &mut Vec::new(), &mut places);
    let folder = scratch(name);
    let (mut files, mut accepted) = (Vec::<PathBuf>::new(), Vec::new());
    let mut add = |tree: &Value, about: String| {
        let path = folder.join(format!("{}.json", files.len()));
        fs::write(&path, tree.to_string()).expect("written");
        files.push(path);
        accepted.push((accepts(tree), about));
    };
    for (path, before) in &places {
        let told = written(path);
        let mut others = if path.is_empty() { Vec::new() } else { changes(before) };
        if let Value::Object(map) = before {
            for key in ["vanishes", "exists", "shape", "remedy", "first_force_left", "even"] {
                let mut more = map.clone();
                more.insert(key.to_owned(), json!(true));
                others.push(json!(more));
            }
        }
        for after in others.into_iter().filter(|after| after != before) {
            let mut changed = genuine.clone();
            match path.is_empty() {
                true => {
                    let mut more = after.clone();
                    more["evidence"] = genuine["evidence"].clone();
                    changed = more;
                }
                false => *at(&mut changed, path) = after.clone(),
            }
            add(&changed, format!("{told}: {before} became {after}"));
            let excused = is_number(&told, before, &after);
            assert!(excused || !accepted_last(&changed), "{told}: {before} became {after} and is accepted");
        }
    }
    let refused = accepted.iter().filter(|(accepted, _)| !accepted).count();
    println!("{name}: {} changes, {refused} refused", accepted.len());
    assert!(refused > accepted.len() / 2, "{refused} of {} are refused", accepted.len());
    let Some((told, _)) = second_checker(&files) else { return };
    for (path, (accepted, about)) in files.iter().zip(&accepted) {
        let start = format!("{}: ", path.display());
        let line = told.lines().find(|line| line.starts_with(&start)).unwrap_or_default();
        assert_eq!(line.contains(": verified, "), *accepted, "{about}: {line}");
    }
}

fn accepted_last(tree: &Value) -> bool {
    accepts(tree)
}

#[test]
fn every_change_of_loads_but_of_their_numbers_is_refused_by_both_checkers() {
    let loads = document("loads-beside", LOADS, &["loads", "FILE", "--orders", "1,2,3", "--json"]);
    assert_guarded("loads-beside-changes", &loads);
}

#[test]
fn every_change_of_a_comparison_but_of_its_numbers_is_refused_by_both_checkers() {
    let compare = document("compare-beside", LOADS, &["compare", "FILE", "I3", "--orders", "1,3", "--json"]);
    assert_guarded("compare-beside-changes", &compare);
}

/// No word, and no truth, stands beside the evidence but titles, units and names of masses.
#[test]
fn documents_of_numbers_say_nothing_that_the_evidence_says() {
    let loads = document("loads-says", LOADS, &["loads", "FILE", "--json"]);
    let compare = document("compare-says", LOADS, &["compare", "FILE", "V8-crossplane", "--json"]);
    for tree in [loads, compare] {
        let mut outside = tree.clone();
        outside.as_object_mut().expect("an object").remove("evidence");
        let mut places = Vec::new();
        walk(&outside, &mut Vec::<Step>::new(), &mut places);
        for (path, value) in places {
            assert!(!value.is_boolean(), "{}", written(&path));
        }
    }
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
    fs::write(&layout, LOADS).expect("written");
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
