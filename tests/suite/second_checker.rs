//! Does the second checker, `formal/verify.py`, accept what the program writes, and nothing that is false?

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crankstar::file;
use serde_json::{Value, json};

use crate::support::dice::Dice;
use crate::support::every_form;
use crate::support::program::{call, scratch};
use crate::support::second::{self, second_checker};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// Random engines and families; the second checker is slow, and all documents together take it some seconds.
const RANDOM: u64 = 30;

#[track_caller]
fn verified(files: &[PathBuf]) {
    let Some((told, code)) = second_checker(files) else { return };
    let fails: Vec<&str> =
        told.lines().filter(|line| !line.starts_with(' ') && !line.contains(": verified, ")).collect();
    assert!(fails.is_empty() && code == 0, "{code} {fails:#?}");
    assert_eq!(told.lines().filter(|line| line.contains(": verified, ")).count(), files.len());
    assert!(!told.contains("verified, 0 certificates"), "{told}");
}

/// All documents with a `format` of this program below a folder.
fn stored(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            stored(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "json") {
            let text = fs::read_to_string(&path).expect("text");
            let format = serde_json::from_str::<Value>(&text).ok().and_then(|tree| tree.get("format").cloned());
            if format.is_some_and(|name| name.as_str().is_some_and(|name| name.starts_with("crankstar "))) {
                found.push(path);
            }
        }
    }
}

#[test]
fn every_stored_document_verifies() {
    let mut files = Vec::new();
    for folder in ["reports", "tests", "examples", "fuzz/seeds", "formal"] {
        stored(&Path::new(ROOT).join(folder), &mut files);
    }
    assert!(files.len() >= 3, "{files:?}");
    verified(&files);
}

/// Writes what a call prints; false where the program refuses the call.
fn write(folder: &Path, name: &str, arguments: &[&str], files: &mut Vec<PathBuf>) -> bool {
    let output = call(arguments);
    if output.status.success() {
        let path = folder.join(format!("{name}.json"));
        fs::write(&path, output.stdout).expect("written");
        files.push(path);
    }
    output.status.success()
}

#[test]
fn every_document_on_the_engines_of_the_catalogue_verifies() {
    let folder = scratch("second-checker-catalogue");
    let (mut files, mut theorems) = (Vec::new(), 0);
    for (entry, _) in file::catalogue().expect("the catalogue") {
        let name = entry.name;
        let told = write(&folder, &format!("{name}-every"), &["classify", name, "--json", "--all-orders"], &mut files);
        theorems += usize::from(told);
        assert!(told || write(&folder, name, &["classify", name, "--json"], &mut files), "{name}");
        write(&folder, &format!("{name}-firing"), &["classify", name, "--json", "--firing"], &mut files);
        write(&folder, &format!("{name}-remedy"), &["remedy", name, "--json"], &mut files);
    }
    let pair = ["compare", "I4", "V8-crossplane", "--json"];
    assert!(write(&folder, "compare", &pair, &mut files));
    assert!(theorems > 20, "{theorems}");
    verified(&files);
}

#[test]
fn every_document_on_random_engines_of_every_form_verifies() {
    let folder = scratch("second-checker-random");
    let (mut dice, mut files) = (Dice::new(16), Vec::new());
    let (mut verdicts, mut families, mut loads, mut remedies) = (0, 0, 0, 0);
    for index in 0..RANDOM {
        let layout = |kind: &str, text: String| {
            let path = folder.join(format!("{kind}-{index}.toml"));
            fs::write(&path, text).expect("written");
            path.to_str().expect("text").to_owned()
        };
        let known = layout("known", every_form::known(&mut dice));
        let open = layout("open", every_form::open(&mut dice));
        let mut made = |name: &str, arguments: &[&str]| {
            usize::from(write(&folder, &format!("{name}-{index}"), arguments, &mut files))
        };
        let masses = ["all", "reciprocating", "rotating", "all"][index as usize % 4];
        verdicts += made("classify", &["classify", &known, "--json", "--masses", masses, "--orders", "1,2,3,4,6"]);
        verdicts += made("torque", &["classify", &known, "--json", "--torque"]);
        families += made("family", &["classify", &open, "--json", "--orders", "1,2,3,4"]);
        remedies += made("remedy", &["remedy", &known, "--json"]);
        if index % 3 == 0 {
            loads += made("loads", &["loads", &known, "--json"]);
        }
    }
    let random = usize::try_from(RANDOM).expect("a small number");
    assert!(verdicts > random / 2, "{verdicts} documents of verdicts");
    assert!(families > random / 2, "{families} families");
    assert!(remedies > random / 4 && loads > 0, "{remedies} remedies, {loads} loads");
    verified(&files);
}

#[test]
fn two_files_of_it_that_are_short_decide_about_the_verdicts_on_an_engine() {
    let folder = scratch("second-checker-alone");
    // Of the others it takes what tells decimals alone.
    for file in ["verify.py", "reading.py", "enclosures.py"] {
        fs::copy(Path::new(ROOT).join("formal").join(file), folder.join(file)).expect("copied");
    }
    let mut files = Vec::new();
    for name in ["I4", "V8-crossplane", "radial-9"] {
        assert!(write(&folder, name, &["classify", name, "--json"], &mut files), "{name}");
    }
    let script = folder.join("verify.py");
    let Some((told, code)) = second::run(&script, &files) else { return };
    assert_eq!((code, told.matches(": verified, ").count()), (0, 3), "{told}");
    let lines = |file: &str| fs::read_to_string(folder.join(file)).expect("text").lines().count();
    let lines = lines("verify.py") + lines("reading.py");
    assert!(lines <= 500, "{lines} lines are no ten minutes of reading");
}

fn seed(name: &str) -> Value {
    let path = Path::new(ROOT).join("fuzz/seeds/document").join(name);
    serde_json::from_str(&fs::read_to_string(path).expect("a seed")).expect("JSON")
}

fn told(arguments: &[&str]) -> Value {
    serde_json::from_slice(&call(arguments).stdout).expect("JSON")
}

/// Documents that are changed in one place, each with what the second checker has to say of it.
#[derive(Default)]
struct Cheats(Vec<(Value, String)>);

impl Cheats {
    /// Puts a value into the place of another, or of none.
    #[track_caller]
    fn put(&mut self, document: &Value, place: &str, value: Value, says: &str) {
        self.change(document, place, |entry| *entry = value, says);
    }

    #[track_caller]
    fn drop(&mut self, document: &Value, list: &str, says: &str) {
        self.change(document, list, |entry| drop(entry.as_array_mut().expect("a list").remove(0)), says);
    }

    #[track_caller]
    fn twice(&mut self, document: &Value, list: &str, says: &str) {
        let again = |entry: &mut Value| {
            let list = entry.as_array_mut().expect("a list");
            list.push(list[0].clone());
        };
        self.change(document, list, again, says);
    }

    #[track_caller]
    fn change(&mut self, document: &Value, place: &str, change: impl FnOnce(&mut Value), says: &str) {
        let mut false_one = document.clone();
        change(false_one.pointer_mut(place).unwrap_or_else(|| panic!("{place}")));
        assert_ne!(false_one, *document, "{place}: nothing is changed");
        self.0.push((false_one, says.to_owned()));
    }

    #[track_caller]
    fn are_refused(self, name: &str) {
        let folder = scratch(name);
        let file = |(index, (document, _)): (usize, &(Value, String))| {
            let path = folder.join(format!("{index}.json"));
            fs::write(&path, document.to_string()).expect("written");
            path
        };
        let files: Vec<PathBuf> = self.0.iter().enumerate().map(file).collect();
        let Some((told, code)) = second_checker(&files) else { return };
        let mut passed = String::new();
        for (path, (_, says)) in files.iter().zip(&self.0) {
            let about = format!("{}: ", path.display());
            let line = told.lines().find(|line| line.starts_with(&about)).unwrap_or_default();
            if !line.contains(": refused at ") || !line.contains(says.as_str()) {
                writeln!(passed, "{says}: {line}").expect("text");
            }
        }
        assert!(passed.is_empty() && code == 1, "{code}\n{passed}");
    }
}

#[test]
fn false_verdicts_are_refused() {
    let honest = seed("verdicts.json");
    let mut cheats = Cheats::default();
    let zero = json!({ "kind": "polygons", "polygons": [] });
    // Force, order 2, reverse: an opposed pair. Force, order 1, reverse: not zero.
    cheats.put(&honest, "/verdicts/6/vanishes", json!(false), "contradict vanishes");
    cheats.put(&honest, "/verdicts/1/certificate", zero.clone(), "the contrary of the verdict");
    cheats.change(
        &honest,
        "/verdicts/1",
        |verdict| {
            (verdict["vanishes"], verdict["modulus"], verdict["angle_deg"]) = (json!(true), json!(0.0), Value::Null);
            verdict["certificate"] = zero;
        },
        "the polygons do not add up",
    );
    cheats.put(&honest, "/verdicts/1/terms/0/weight", json!("2"), "not those of the engine");
    cheats.put(&honest, "/verdicts/1/terms/0/angle", json!("2/3"), "not those of the engine");
    cheats.put(&honest, "/cylinders/0/bank", json!("1/2"), "not those of the engine");
    cheats.put(&honest, "/cylinders/0/reciprocating_mass", json!("2"), "not those of the engine");
    cheats.put(&honest, "/reference_plane", json!("1"), "not those of the engine");
    cheats.put(&honest, "/cylinders/1/name", json!("1"), "the same name");
    cheats.put(&honest, "/cylinders/0/rod", json!({ "known": { "ratio": "1/4", "offset": "0" } }), "some are not");
    for (key, value) in [("sides", json!(3)), ("rotation", json!("1/3")), ("weight", json!("2"))] {
        let place = format!("/verdicts/6/certificate/polygons/0/{key}");
        cheats.put(&honest, &place, value, "the polygons do not add up");
    }
    cheats.put(&honest, "/verdicts/6/certificate/polygons/0/sides", json!(1), "a polygon has from 2");
    cheats.twice(&honest, "/verdicts/6/certificate/polygons", "the polygons do not add up");
    let residue = "/verdicts/1/certificate";
    cheats.put(&honest, &format!("{residue}/prime"), json!("13"), "the root");
    cheats.put(&honest, &format!("{residue}/root"), json!("2"), "a smaller order");
    cheats.put(&honest, &format!("{residue}/residue"), json!("2"), "the sum is 1 modulo 7");
    cheats.put(&honest, &format!("{residue}/scale"), json!("0"), "out of range");
    cheats.put(&honest, &format!("{residue}/conductor"), json!("12"), "a smaller order");
    cheats.drop(&honest, "/verdicts", "9 verdicts where 10 are due");
    cheats.change(&honest, "/verdicts", |list| list.as_array_mut().expect("a list").swap(0, 1), "is due");
    cheats.twice(&honest, "/verdicts", "11 verdicts where 10 are due");
    cheats.put(&honest, "/orders", json!([1]), "10 verdicts where 5 are due");
    cheats.put(&honest, "/orders", json!([1, 2, 3]), "10 verdicts where 15 are due");
    cheats.put(&honest, "/quantities", json!(["moment", "force"]), "quantities are in the order");
    cheats.put(&honest, "/shapes/0/shape", json!("planar"), "the contrary");
    cheats.put(&honest, "/shapes/2/shape", json!("elliptical"), "rotating is due");
    cheats.drop(&honest, "/shapes", "3 shapes where 4 are due");
    cheats.put(&honest, "/theorems/0/survivors/residues", json!([0]), "the statement contradicts");
    cheats.put(&honest, "/theorems/0/survivors/order_one", json!(false), "the statement contradicts");
    cheats.put(
        &honest,
        "/theorems/0/survivors",
        json!({ "order_one": true, "modulus": 12, "residues": [0, 2, 6, 8] }),
        "a smaller modulus says the same",
    );
    cheats.put(&honest, "/theorems/0/period", json!("6"), "not whole");
    cheats.drop(&honest, "/theorems/0/verdicts", "not one verdict for each order");
    cheats.drop(&honest, "/theorems", "3 theorems where 4 are due");
    cheats.put(&honest, "/all_orders", json!(false), "nothing was asked of every order");
    cheats.change(&honest, "/cylinders/0", |one| one["tilt"] = json!("1"), "has no key tilt");
    cheats.change(&honest, "/cylinders/0", |one| one["position"] = json!("0/1"), "not in lowest terms");
    cheats.change(&honest, "", |all| drop(all.as_object_mut().expect("an object").remove("shapes")), "lacks shapes");
    cheats.are_refused("second-checker-verdicts");
}

#[test]
fn false_families_remedies_and_firing_stars_are_refused() {
    let mut cheats = Cheats::default();
    let family = seed("family.json");
    let sum = "/open_verdicts/0/sums/0";
    cheats.put(&family, &format!("{sum}/when/alternatives/0/conditions/0/turn"), json!("1/3"), "the polygons do not");
    cheats.put(&family, &format!("{sum}/when/alternatives/0/conditions/0/phi"), json!("2"), "about other parts");
    for kind in ["never", "always", "not-solved"] {
        cheats.put(&family, &format!("{sum}/when"), json!({ "kind": kind }), "contradicts");
    }
    cheats.twice(&family, &format!("{sum}/when/alternatives"), "alternatives");
    cheats.drop(&family, &format!("{sum}/parts"), "not those of the cylinders");
    cheats.put(&family, &format!("{sum}/parts/0/phi"), json!("-1"), "not those of the cylinders");
    cheats.drop(&family, "/open_verdicts", "3 open_verdicts where 4 are due");
    cheats.drop(&family, "/open_verdicts/2/sums", "not those of the lengths");
    cheats.put(&family, "/cylinders/0/bank/phi", json!("-1"), "not those of the cylinders");
    let remedy = seed("remedy.json");
    cheats.drop(&remedy, "/weights", "not those of the engine and the weights");
    cheats.put(&remedy, "/weights/0/parts/0/terms/0/weight", json!("-1/2"), "modulus does not fit");
    cheats.put(&remedy, "/weights/0/parts/0/terms/0/angle", json!("7"), "not collected");
    cheats.put(&remedy, "/weights/0/position", json!("7"), "not those of the engine and the weights");
    cheats.put(&remedy, "/weights/0/order", json!(3), "not asked for");
    cheats.drop(&remedy, "/sums", "7 sums where 8 are due");
    cheats.twice(&remedy, "/sums", "9 sums where 8 are due");
    cheats.put(&remedy, "/cylinders/0/weight", json!("2"), "not those of the engine and the weights");
    let firing = told(&["classify", "I4", "--json", "--firing"]);
    cheats.put(&firing, "/cylinders/1/firing_angle", json!("1/3"), "a dead centre of its own");
    cheats.put(&firing, "/cylinders/1/firing_angle", json!("1/2"), "not those of the star");
    cheats.drop(&firing, "/verdicts", "verdicts where");
    cheats.put(&firing, "/cylinders/1/deflection", json!("2"), "not those of the star");
    cheats.are_refused("second-checker-others");
}

#[test]
fn false_identities_that_show_a_sum_to_vanish_for_no_angle_are_refused() {
    let path = scratch("second-checker-coprime-layout").join("layout.toml");
    let masses = "[1, 2, 1, 1, 2, 3, 1, 2, 1]";
    let text = format!(
        "orders = [1]\n[fan]\nbanks = ['-phi', 0, 'phi']\nthrows = [0, 90, 200]\n[mechanism]\nreciprocating_mass = {masses}"
    );
    fs::write(&path, text).expect("written");
    let honest = told(&["classify", path.to_str().expect("UTF-8"), "--json"]);
    let is_coprime = |place: &String| honest.pointer(place) == Some(&json!("coprime"));
    let places = (0..4).map(|at| format!("/open_verdicts/{}/sums/0/when/kind", at));
    let kind = places.into_iter().find(is_coprime).expect("a sum that vanishes for no angle");
    let when = kind.strip_suffix("/kind").expect("its place");
    let mut cheats = Cheats::default();
    for (key, value, says) in [
        ("phi", json!("4"), "enters no whole times"),
        ("phi", json!("-2"), "has no direction"),
        ("delta", json!("1"), "turns otherwise"),
        ("conductor", json!(72), "another order"),
        ("prime", json!(10011), "out of range"),
        ("root", json!(1), "another order"),
        ("scale", json!("0"), "whole and positive"),
        ("scale", json!("2"), "is not 1 modulo the prime"),
        ("u", json!([1, 1]), "is not 1 modulo the prime"),
        ("v", json!([0]), "is not 1 modulo the prime"),
        ("v", json!([0, 0, 0, 0, 0, 0]), "too long"),
    ] {
        cheats.put(&honest, &format!("{when}/{key}"), value, says);
    }
    let terms = format!("{}/parts/0/terms/0/weight", when.strip_suffix("/when").expect("a sum"));
    cheats.put(&honest, &terms, json!("7"), "not those of the cylinders");
    cheats.are_refused("second-checker-coprime");
}

#[test]
fn numbers_that_contradict_their_evidence_are_refused() {
    let mut cheats = Cheats::default();
    let compare = told(&["compare", "I4", "V8-crossplane", "--json"]);
    cheats.put(&compare, "/engines/0/orders/0/force/largest", json!(7), "differs");
    cheats.put(&compare, "/evidence/1/verdicts/0/terms/0/weight", json!("7"), "evidence[1].verdicts");
    cheats.drop(&compare, "/evidence", "2 engines where 1 are due");
    cheats.are_refused("second-checker-numbers");
}

/// 17 is of order 6 modulo 7 and modulo 13, 3 is of order 3 modulo 13.
#[test]
fn a_composite_modulus_is_accepted_where_the_root_has_its_order_by_every_factor() {
    let place = "/verdicts/1/certificate";
    let residue = |root: &str, claimed: &str| json!({ "kind": "residue", "conductor": "6", "prime": "91", "root": root, "scale": "1", "residue": claimed });
    let mut honest = seed("verdicts.json");
    *honest.pointer_mut(place).expect("a certificate") = residue("17", "1");
    let path = scratch("second-checker-composite").join("composite.json");
    fs::write(&path, honest.to_string()).expect("written");
    let checked = crankstar::proof::read_document(honest.to_string().as_bytes()).expect("reads").check();
    checked.expect("the first checker accepts it too");
    verified(&[path]);
    let mut cheats = Cheats::default();
    cheats.put(&honest, place, residue("3", "64"), "a smaller order");
    cheats.are_refused("second-checker-composite-cheats");
}

#[test]
fn what_is_not_checked_is_named_and_what_is_no_document_is_told_apart() {
    let mut family = seed("family.json");
    family["open_verdicts"][0]["sums"][0]["when"] = json!({ "kind": "of-tomorrow", "arcs": [] });
    second::refuses(&[("a form that it does not know", family)]);
    let folder = scratch("second-checker-outside");
    let (verdicts, nothing, twice) =
        (folder.join("verdicts.json"), folder.join("nothing.json"), folder.join("twice.json"));
    fs::write(&verdicts, seed("verdicts.json").to_string()).expect("written");
    fs::write(&nothing, "{\"format\":\"crankstar torque 2\"}").expect("written");
    fs::write(&twice, "{\"format\":\"crankstar family 2\",\"format\":\"crankstar family 2\"}").expect("written");
    let Some((told, code)) = second_checker(&[verdicts]) else { return };
    assert!(told.contains("not checked: titles and names"), "{told}");
    assert_eq!(code, 0);
    for file in [nothing, twice, folder.join("is-not-there.json")] {
        let Some((told, code)) = second_checker(&[file]) else { return };
        assert_eq!(code, 2, "{told}");
    }
}
