//! Is every document read as what it says it is, once, and without taking long?

use crankstar::file;
use crankstar::proof::{LARGEST_DOCUMENT, Reason, Unreadable, read_document};

use serde_json::{Value, json};

use crate::support::verdicts::{document, judged};

fn genuine() -> Value {
    let layout = file::parse("engine", "vee = { bank_angle = 60, throws = [0, 180] }").expect("a layout");
    let orders = judged(&layout, &[1, 2], false);
    serde_json::to_value(document(&layout, &orders, false, None)).expect("JSON")
}

fn error(text: &str) -> String {
    read_document(text.as_bytes()).expect_err("no document").to_string()
}

#[test]
fn the_format_alone_says_what_a_document_is() {
    let mut document = genuine();
    document["open_verdicts"] = json!([]);
    assert!(error(&document.to_string()).contains("unknown field `open_verdicts`"));
    let mut renamed = genuine();
    for name in ["crankstar remedy 2", "crankstar family 2"] {
        renamed["format"] = json!(name);
        assert!(matches!(read_document(renamed.to_string().as_bytes()), Err(Unreadable::Malformed(_))), "{name}");
    }
    for name in [json!("crankstar classify 1"), json!("crankstar classify 3"), json!(2), Value::Null] {
        renamed["format"] = name.clone();
        assert_eq!(error(&renamed.to_string()).split(" is not known").next(), Some(&*format!("the format {name}")));
    }
    renamed.as_object_mut().expect("an object").remove("format");
    assert!(error(&renamed.to_string()).starts_with("it names no format"));
    assert!(error("[]").starts_with("it names no format"));
}

#[test]
fn a_key_that_stands_twice_is_refused_wherever_it_stands() {
    let text = genuine().to_string();
    for key in ["title", "name", "order", "kind", "angle", "sides"] {
        let place = text.find(&format!("\"{key}\":")).expect("the key");
        let doubled = format!("{}\"{key}\":null,{}", &text[..place], &text[place..]);
        assert!(error(&doubled).contains(&format!("the key `{key}` is given twice")), "{}", error(&doubled));
    }
    let family = r#"{"format":"crankstar family 2","reference_plane":{"1":"0","a":"1","a":"2"}}"#;
    assert!(error(family).contains("the key `a` is given twice"));
}

#[test]
fn keys_that_mean_nothing_are_refused_also_beside_a_kind() {
    let family = |when: Value| {
        json!({ "format": "crankstar family 2", "title": "", "masses": "reciprocating", "orders": [1], "quantities": ["force"],
            "reference_plane": { "1": "0" }, "cylinders": [],
            "open_verdicts": [{ "quantity": "force", "order": 1, "sense": "direct",
                "sums": [{ "symbol": null, "parts": [], "when": when }] }] })
    };
    assert!(read_document(family(json!({ "kind": "always" })).to_string().as_bytes()).is_ok());
    let more = error(&family(json!({ "kind": "always", "alternatives": [] })).to_string());
    assert!(more.contains("alternatives"), "{more}");
}

#[test]
fn numbers_are_written_in_one_way() {
    let mut document = genuine();
    document["reference_plane"] = json!("2/4");
    assert_eq!(error(&document.to_string()), "reference_plane: \"2/4\" is written \"1/2\"");
    // 2 and 2.0 are the same decimal, whoever has written it.
    let mut whole = genuine();
    let verdict = whole["verdicts"].as_array_mut().expect("a list");
    let whole_modulus = verdict.iter_mut().find(|verdict| verdict["modulus"].as_f64() == Some(0.0)).expect("a zero");
    whole_modulus["modulus"] = json!(0);
    assert!(read_document(whole.to_string().as_bytes()).expect("it reads").check().is_ok());
}

#[test]
fn what_is_too_large_is_refused_before_it_is_read() {
    let large = vec![b' '; LARGEST_DOCUMENT + 1];
    assert_eq!(read_document(&large), Err(Unreadable::TooLarge(LARGEST_DOCUMENT + 1)));
    let mut document = genuine();
    document["reference_plane"] = json!("1".repeat(1_000_000));
    assert_eq!(read_document(document.to_string().as_bytes()), Err(Unreadable::TooManyDigits(1_000_000)));
    assert!(error(&"[".repeat(100_000)).contains("recursion limit"));
}

/// The first verdict of an engine with these throws, its evidence as given.
fn one_verdict(throws: &[String], vanishes: bool, certificate: Value) -> Value {
    let cylinder = |(index, throw): (usize, &String)| {
        json!({ "name": index.to_string(), "throw": throw, "bank": "0", "position": "0", "reciprocating_mass": "1",
                "crank_radius": "1", "rod": "unknown" })
    };
    let terms: Vec<Value> = throws.iter().map(|throw| json!({ "angle": throw, "weight": "1" })).collect();
    let cylinders: Vec<Value> = throws.iter().enumerate().map(cylinder).collect();
    json!({ "format": "crankstar classify 2", "title": "", "masses": "reciprocating", "orders": [1], "quantities": ["force"],
        "all_orders": false, "reference_plane": "0", "cylinders": cylinders, "turning_masses": [], "wholes": [], "shapes": [], "theorems": [],
        "verdicts": [{ "quantity": "force", "order": 1, "sense": "direct", "vanishes": vanishes, "terms": terms,
            "modulus": 1.0, "angle_deg": 1.0, "certificate": certificate }] })
}

fn reason(document: &Value) -> Reason {
    read_document(document.to_string().as_bytes()).expect("it reads").check().expect_err("it is refused").reason
}

#[test]
fn a_splitting_of_a_thousand_large_denominators_is_given_up_after_the_same_steps_everywhere() {
    let throws: Vec<String> =
        (0..4000_u64).map(|index| format!("1/{}", 1_000_000_007_u64 * 1_000_003 + 2 * index)).collect();
    let step = json!({ "class": { "angle": "0", "modulus": "1" } });
    let document = one_verdict(&throws, false, json!({ "kind": "splitting", "steps": vec![step; 1000] }));
    assert_eq!(reason(&document), Reason::TooManySteps);
}

#[test]
fn polygons_beyond_number_are_given_up() {
    let polygon = json!({ "sides": 99_991, "rotation": format!("1/{}", "9".repeat(2000)), "weight": "1" });
    let document = one_verdict(&["0".to_owned()], true, json!({ "kind": "polygons", "polygons": [polygon] }));
    assert_eq!(reason(&document), Reason::TooManySteps);
}

#[test]
fn a_conductor_that_takes_long_to_factorise_is_refused() {
    let residue = json!({ "kind": "residue", "conductor": "999999999989", "prime": "18446744073709551557", "root": "2",
        "scale": "1", "residue": "1" });
    let document = one_verdict(&["0".to_owned()], false, residue);
    assert!(reason(&document).to_string().contains("the conductor 999999999989 is not in 1..=1000000"));
}

/// Three tenths or nearly, in this many digits and as many again.
fn three_tenths(digits: usize) -> Value {
    json!(format!("3{}/1{}1", "0".repeat(digits - 1), "0".repeat(digits - 1)))
}

#[test]
fn long_masses_are_paid_for_where_they_add_nothing() {
    let none = json!({ "kind": "polygons", "polygons": [] });
    let cylinder = json!({ "name": "", "throw": "0", "bank": "0", "position": "0", "reciprocating_mass": three_tenths(2400),
        "crank_radius": "1", "rod": "unknown" });
    let cylinders: Vec<Value> = (0..200).map(|name| with(&cylinder, "name", json!(name.to_string()))).collect();
    let terms = vec![json!({ "angle": "0", "weight": "0" }); cylinders.len()];
    let verdict = |sense: &str| {
        json!({ "quantity": "moment", "order": 1, "sense": sense, "vanishes": true, "terms": terms, "modulus": 0.0,
            "angle_deg": null, "certificate": none })
    };
    let document = json!({ "format": "crankstar classify 2", "title": "", "masses": "reciprocating", "orders": [1],
        "quantities": ["moment"], "all_orders": false, "reference_plane": "0", "cylinders": cylinders, "turning_masses": [], "wholes": [],
        "shapes": [{ "quantity": "moment", "order": 1, "shape": "balanced" }], "theorems": [],
        "verdicts": [verdict("direct"), verdict("reverse")] });
    assert_eq!(reason(&document), Reason::TooManySteps);

    let cylinder =
        json!({ "throw": "0", "bank": "0", "position": "0", "weight": three_tenths(2400), "rod": "unknown" });
    let sum = |quantity: &str, sense: &str| json!({ "quantity": quantity, "order": 3, "sense": sense, "coefficient": "one", "terms": [], "certificate": none });
    let of_quantity = |quantity| [sum(quantity, "direct"), sum(quantity, "reverse")];
    let sums = [of_quantity("force"), of_quantity("moment")].concat();
    let remedy = |cylinders: usize| {
        json!({ "format": "crankstar remedy 2", "title": "", "masses": "all", "orders": [3], "quantities": ["force", "moment"],
            "reference_plane": "0", "cylinders": vec![cylinder.clone(); cylinders], "turning_masses": [], "weights": [],
            "sums": sums })
    };
    assert_eq!(reason(&remedy(200)), Reason::TooManySteps);
    assert!(read_document(remedy(1).to_string().as_bytes()).expect("it reads").check().is_ok());
}

fn with(value: &Value, key: &str, to: Value) -> Value {
    let mut value = value.clone();
    value[key] = to;
    value
}

#[test]
fn long_lengths_of_rods_and_links_are_paid_for_at_every_point() {
    let rods = "inline = { throws = [0, 0] }\nmechanism = { rod_ratio = [0.25, 0.3] }";
    let link = "vee = { bank_angle = 60, throws = [0] }\nmechanism = { rod_ratio = 0.25 }\n\
        articulated = { master = 1, knuckle_ratio = 0.25, link_ratio = 0.3 }";
    for (layout, order, place) in [(rods, 200, "/known/ratio"), (link, 100, "/link/ratio")] {
        let layout = file::parse("engine", layout).expect("a layout");
        let orders = judged(&layout, &[order], false);
        let mut document = serde_json::to_value(document(&layout, &orders, false, None)).expect("JSON");
        assert!(read_document(document.to_string().as_bytes()).expect("it reads").check().is_ok(), "{place}");
        let cylinders = document["cylinders"].as_array_mut().expect("a list");
        let rods = cylinders.iter_mut().map(|cylinder| &mut cylinder["rod"]);
        let ratio = rods.filter_map(|rod| rod.pointer_mut(place)).next_back().expect("a ratio");
        *ratio = three_tenths(2400);
        assert_eq!(reason(&document), Reason::TooManySteps, "{place}");
    }
}
