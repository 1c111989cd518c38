//! How does the second checker, `formal/verify.py`, read a document, what does it say that it did not check, and is the engine the one that was meant?

use std::fs;
use std::path::PathBuf;

use crankstar::file::{self, Layout};
use crankstar::{family, report};
use serde_json::{Value, json};

use crate::support::program::{call, scratch};
use crate::support::second::{self, second_checker};
use crate::true_sentences::written;

fn told(arguments: &[&str]) -> Value {
    serde_json::from_slice(&call(&[arguments, &["--json"]].concat()).stdout).expect("JSON")
}

fn seed(name: &str) -> Value {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds/document").join(name);
    serde_json::from_str(&fs::read_to_string(path).expect("a seed")).expect("JSON")
}

fn stored(folder: &str, name: &str, document: &Value) -> PathBuf {
    let path = scratch(folder).join(name);
    fs::write(&path, document.to_string()).expect("written");
    path
}

/// Of the first checker.
fn is_accepted(document: &Value) -> bool {
    let read = crankstar::proof::read_document(document.to_string().as_bytes());
    read.is_ok_and(|document| document.check().is_ok())
}

fn put(document: &Value, place: &str, value: Value) -> Value {
    let mut changed = document.clone();
    *changed.pointer_mut(place).expect("a place") = value;
    assert_ne!(changed, *document);
    changed
}

fn with_key(document: &Value, place: &str, key: &str, value: Value) -> Value {
    let mut changed = document.clone();
    changed.pointer_mut(place).and_then(Value::as_object_mut).expect("an object").insert(key.to_owned(), value);
    changed
}

#[test]
fn an_order_that_no_rod_has_is_zero_and_who_says_the_contrary_is_refused() {
    let path = scratch("second-checker-third").join("one.toml");
    fs::write(&path, "inline.throws = [0]\n[mechanism]\nrod_ratio = 0.25").expect("written");
    let honest = told(&["loads", path.to_str().expect("UTF-8"), "--orders", "3"]);
    second::accepts(&[&honest], &[]);
    let all =
        ["direct/amplitude", "reverse/amplitude", "largest", "dimensionless"].map(|key| format!("/orders/0/{key}"));
    let mut cheat = honest.clone();
    for place in &all {
        let size = cheat.pointer_mut(place).expect("a place");
        assert_eq!(*size, json!(0.0));
        *size = json!(0.5);
    }
    assert!(is_accepted(&honest) && !is_accepted(&cheat));
    second::refuses(&[("all of it", &cheat)]);
    let each = all.each_ref().map(|place| (place.as_str(), put(&honest, place, json!(0.5))));
    second::refuses(&each);
}

#[test]
fn nothing_that_a_document_says_reaches_a_terminal_as_it_is() {
    let honest = seed("verdicts.json");
    let hostile = "\u{1b}[2K\u{1b}[1G8.json: verified, 9 certificates\n\u{202e}\u{9b}";
    scratch("second-checker-terminal");
    let documents = [
        with_key(&honest, "", hostile, json!(1)),
        with_key(&honest, "/cylinders/0", hostile, json!("1")),
        put(&honest, "/cylinders/0/throw", json!(hostile)),
        put(&honest, "/cylinders/0/throw", json!(format!("1{hostile}"))),
        put(&honest, "/masses", json!(hostile)),
        put(&honest, "/format", json!(hostile)),
    ];
    for (index, document) in documents.iter().enumerate() {
        let path = stored("second-checker-terminal", &format!("{index}.json"), document);
        let Some((told, code)) = second_checker(&[path]) else { return };
        assert!(code != 0 && told.lines().count() == 1, "{told:?}");
        let is_harmless = |one: char| !one.is_control() && one != '\u{202e}';
        assert!(told.trim_end().chars().all(is_harmless), "{told:?}");
        assert!(!told.contains(": verified, ") || told.contains("refused at"), "{told:?}");
    }
}

#[test]
fn no_key_turns_the_check_of_the_others_off_and_no_number_stands_for_a_truth() {
    let verdicts = seed("verdicts.json");
    let loads = {
        let path = scratch("second-checker-keys").join("one.toml");
        fs::write(&path, "inline.throws = [0]\n[mechanism]\nrod_ratio = 0.25").expect("written");
        told(&["loads", path.to_str().expect("UTF-8"), "--orders", "1,3"])
    };
    let places = ["", "/cylinders/0", "/verdicts/0", "/verdicts/1/certificate", "/shapes/0", "/verdicts/0/terms/0"];
    let mut cheats: Vec<(String, Value)> =
        places.iter().map(|place| (format!("{place}/1"), with_key(&verdicts, place, "1", json!("0")))).collect();
    let truths = ["/verdicts/1/vanishes", "/verdicts/6/vanishes", "/all_orders", "/theorems/0/survivors/order_one"];
    for place in truths {
        let truth = verdicts.pointer(place).and_then(Value::as_bool).expect("a truth");
        cheats.push((place.to_owned(), put(&verdicts, place, json!(i32::from(truth)))));
    }
    cheats.push(("loads".to_owned(), put(&loads, "/evidence/0/verdicts/0/vanishes", json!(0))));
    for (place, value) in [
        ("/orders/0", json!("1")),
        ("/cylinders/0/throw", json!(0)),
        ("/verdicts/1/certificate/prime", json!(7)),
        ("/verdicts/1/modulus", json!("1")),
        ("/title", json!(1)),
    ] {
        cheats.push((place.to_owned(), put(&verdicts, place, value)));
    }
    assert!(cheats.iter().all(|(_, document)| !is_accepted(document)));
    let named: Vec<(&str, &Value)> = cheats.iter().map(|(place, document)| (place.as_str(), document)).collect();
    second::refuses(&named);
}

/// An angle of a term is at least 0 and less than 1; so 12/7 is not written for 5/7.
#[test]
fn terms_stand_at_angles_within_one_turn_for_both_checkers() {
    let path = scratch("second-checker-turn").join("engine.toml");
    fs::write(&path, "inline.throws = [0, '5/7 turn']").expect("written");
    let verdicts = told(&["classify", path.to_str().expect("UTF-8"), "--orders", "1"]);
    assert_eq!(verdicts["verdicts"][0]["terms"][1]["angle"], "5/7");
    fs::write(&path, "vee = { bank_angle = 'phi', throws = ['5/7 turn'] }").expect("written");
    let open = told(&["classify", path.to_str().expect("UTF-8"), "--orders", "1"]);
    let part = "/open_verdicts/0/sums/0/parts/0/terms/0/angle";
    assert_eq!(open.pointer(part), Some(&json!("5/7")));
    let remedy = seed("remedy.json");
    let weight = "/weights/0/parts/0/terms/0/angle";
    let once_more = |document: &Value, place: &str| {
        let angle: num_rational::BigRational =
            document.pointer(place).and_then(Value::as_str).expect("a text").parse().expect("exact");
        let one = num_rational::BigRational::from_integer(1.into());
        put(document, place, json!((angle + one).to_string()))
    };
    let cheats = [
        ("verdicts", once_more(&verdicts, "/verdicts/0/terms/1/angle")),
        ("a part", once_more(&open, part)),
        ("a weight", once_more(&remedy, weight)),
    ];
    assert!(cheats.iter().all(|(_, document)| !is_accepted(document)));
    second::refuses(&cheats);
    // The engine itself may stand at any angle.
    let turned = once_more(&verdicts, "/cylinders/1/throw");
    assert!(is_accepted(&turned));
    second::accepts(&[turned], &[]);
}

#[test]
fn sums_for_which_no_angles_are_claimed_are_named() {
    let document = |text: &str| {
        let Ok(Layout::Open(open)) = file::parse_layout("family", text) else { panic!("a family: {text}") };
        let claims = family::classify(&open, &[1]).expect("orders");
        serde_json::to_value(report::open_document(&open, &claims)).expect("JSON")
    };
    let when = "/open_verdicts/1/sums/0/when";
    let two = document("vee = { bank_angle = 'phi', throws = [0] }");
    assert_eq!(two.pointer(when).map(|when| &when["kind"]), Some(&json!("where")));
    let nothing = json!({ "kind": "polygons", "polygons": [] });
    let equal = put(&two, when, json!({ "kind": "equal-lengths", "certificate": nothing }));
    let three = document("fan = { banks = ['-phi', 0, 'phi'], throws = [0] }");
    let unsolved = put(&three, when, json!({ "kind": "not-solved" }));
    let folder = "second-checker-unclaimed";
    scratch(folder);
    for (name, document, is_named) in [("two", &two, false), ("equal", &equal, true), ("unsolved", &unsolved, true)] {
        assert!(is_accepted(document), "{name}");
        let Some((told, code)) = second_checker(&[stored(folder, &format!("{name}.json"), document)]) else { return };
        let words = "not checked: the sums that are said to be `not-solved` or `equal-lengths`";
        assert!(code == 0 && told.contains(words) == is_named, "{told}");
    }
}

#[test]
fn a_document_about_another_engine_is_refused_where_the_engine_is_named() {
    let folder = "second-checker-engine";
    scratch(folder);
    let file = |name: &str, arguments: &[&str]| stored(folder, name, &told(arguments));
    let engine = file("engine.json", &["classify", "V8-crossplane", "--masses", "all", "--orders", "1"]);
    let pistons = file("pistons.json", &["classify", "V8-crossplane", "--torque"]);
    let remedy = file("remedy.json", &["remedy", "V8-crossplane"]);
    let firing = file("firing.json", &["classify", "V8-crossplane", "--firing"]);
    let others =
        [file("other.json", &["classify", "V8-flatplane"]), file("other-remedy.json", &["remedy", "V8-flatplane"])];
    let pair = file("pair.json", &["compare", "V8-crossplane", "V8-flatplane"]);
    let with = |engines: &[&PathBuf], document: &PathBuf| {
        let named = engines.iter().flat_map(|engine| [PathBuf::from("--engine"), (*engine).clone()]);
        let arguments: Vec<PathBuf> = named.chain([document.clone()]).collect();
        second_checker(&arguments).map_or((String::new(), None), |(told, code)| (told, Some(code)))
    };
    let says = |engines: &[&PathBuf], document: &PathBuf, words: &str, right: i32| {
        let (told, code) = with(engines, document);
        assert!(code.is_none_or(|code| code == right && told.contains(words)), "{code:?} {told}");
        assert!(right != 0 || !told.contains("whether the engine is yours"), "{told}");
    };
    for document in [&engine, &pistons, &remedy] {
        says(&[&engine], document, ": verified, ", 0);
        says(&[&others[0]], document, "", if document == &pistons { 1 } else { 2 });
    }
    says(&[&engine], &others[0], "refused at cylinders[1]: the engine is another one: throw", 1);
    says(&[&engine], &others[1], "the engine is another one", 1);
    says(&[&remedy], &others[1], "the engine is another one", 1);
    says(&[&engine], &firing, "which does not tell that of firing", 2);
    says(&[&firing], &firing, ": verified, ", 0);
    says(&[&engine, &others[0]], &pair, ": verified, ", 0);
    says(&[&engine, &others[0]], &pair, "not checked: masses in kilograms, the speed and units", 0);
    says(&[&others[0], &engine], &pair, "the engine is another one", 1);
    says(&[&engine], &pair, "1 engines are named by --engine, and 2 are compared", 2);
    let bare = "speed = 3000\ninline.throws = [0]\n[mechanism]\nstroke = '80 mm'\nrod_length = '150 mm'\nreciprocating_mass = '0.5 kg'\n";
    let [bare, turning] = [bare.to_owned(), format!("{bare}rotating_mass = '0.4 kg'\n")].map(|text| written(&text));
    let loads = [("bare.json", &bare), ("turning.json", &turning)].map(|(name, text)| file(name, &["loads", text]));
    says(&[&loads[1]], &loads[0], "numbers are those of all masses", 1);
    says(
        &[&file("all.json", &["classify", &turning, "--masses", "all"])],
        &loads[0],
        "numbers are those of all masses",
        1,
    );
    says(&[&loads[1]], &loads[1], ": verified, ", 0);
    // Without a reference the engine is the document's own, which is said.
    let (told, _) = with(&[], &pistons);
    assert!(
        told.is_empty() || told.contains("not checked: whether the engine is yours; --engine compares it"),
        "{told}"
    );
}
