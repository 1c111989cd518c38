//! Is every change of a genuine document refused, in whatever field it is made?
//!
//! All fields that are found in the JSON are changed, one at a time: values altered, entries dropped, repeated and
//! exchanged, keys dropped and added. What is accepted has to be on one of the short lists below.

use crankstar::file::{self, Layout};
use crankstar::firing::Weights;
use crankstar::proof::{
    Cylinder, LinkClaim, Masses, RodStatement, Sense, check_document, check_firing_document, check_remedy_document,
    read_document,
};
use crankstar::remedy::{Request, remedy};
use crankstar::{family, report};
use num_rational::BigRational;
use serde_json::Value;

use crate::support::mutations::{at, changes, walk, written};
use crate::support::second;
use crate::support::verdicts::{self, judged, theorem};
use crate::support::whole_documents::{cylinder, document, turning};

/// Free text, as src/kernel/proof/README.md lists it.
const FREE_TEXT: [&str; 3] = [".title", ".cylinders[].name", ".turning_masses[].name"];

/// A whole turn more, or none less, is the same direction.
fn is_same_direction(path: &str, before: &Value, after: &Value) -> bool {
    let is_angle = ["angle", "correction", "throw", "bank", "rotation", "turn"]
        .iter()
        .any(|key| path.ends_with(&format!(".{key}")));
    let is_known_part = path.ends_with(".throw.1") || path.ends_with(".bank.1");
    let parsed = |value: &Value| value.as_str().and_then(|text| text.parse::<BigRational>().ok());
    let (Some(before), Some(after)) = (parsed(before), parsed(after)) else { return false };
    (is_angle || is_known_part) && (before - after).is_integer()
}

/// Why a change may be accepted; none where it may not.
fn excuse(format: &Value, path: &str, before: &Value, after: &Value) -> Option<&'static str> {
    if FREE_TEXT.contains(&path) {
        return Some("free text");
    }
    if is_same_direction(path, before, after) {
        return Some("the same direction");
    }
    // Where force and moment vanish about one plane, they vanish about every plane.
    if path == ".reference_plane" && format == "crankstar remedy 2" {
        return Some("any plane");
    }
    // A rod says which cylinders have a coefficient in common: where those stay, the verdicts hold for the other engine too.
    if path.contains(".cylinders[].rod.known") {
        return Some("another rod that none else has");
    }
    // The same of firing stars and a link's sizes; where it hangs is told by throws and banks.
    let is_size = ["ratio", "knuckle"].iter().any(|key| path.ends_with(&format!(".cylinders[].rod.link.{key}")));
    if is_size && format == "crankstar firing 1" {
        return Some("another link that none else has");
    }
    // Inside of a certificate a change that is accepted is another proof of the same statement: nothing else has changed.
    if path.contains(".certificate.")
        || path.contains(".certificates[].")
        || path.contains(".equal_lengths[]")
        || path.contains(".equalities[].")
    {
        return Some("another proof");
    }
    // Where nothing turns, the reciprocating masses are all.
    if path == ".masses" && format == "crankstar classify 2" && *after == "all" && *before == "reciprocating" {
        return Some("the same masses");
    }
    // More bits, or somewhat fewer, prove the same; so does another bound that holds.
    if path.ends_with(".bits") || path.ends_with(".below") {
        return Some("another enclosure");
    }
    // Sets, whose order says nothing.
    let sorted = |value: &Value| {
        let mut list: Vec<String> = value.as_array()?.iter().map(Value::to_string).collect();
        list.sort();
        Some(list)
    };
    let is_set = [".cylinders", ".weights", ".turning_masses", ".alternatives", ".factors"]
        .iter()
        .any(|key| path.ends_with(key));
    if is_set && sorted(before).is_some() && sorted(before) == sorted(after) {
        return Some("a set in another order");
    }
    None
}

/// Makes every change of a document; how many were refused, and how many accepted for a reason.
fn mutated(document: &impl serde::Serialize) -> (usize, usize) {
    mutated_where(document, |_| true)
}

fn mutated_where(document: &impl serde::Serialize, is_meant: impl Fn(&str) -> bool) -> (usize, usize) {
    let genuine = serde_json::to_value(document).expect("JSON");
    let accepts = |value: &Value| {
        let bytes = serde_json::to_vec(value).expect("JSON");
        read_document(&bytes).is_ok_and(|document| document.check().is_ok())
    };
    assert!(accepts(&genuine), "the genuine one");
    let mut places = Vec::new();
    walk(&genuine, &mut Vec::new(), &mut places);
    let mut changed = genuine.clone();
    let (mut refused, mut excused) = (0, 0);
    for (path, before) in places.into_iter().filter(|(path, _)| is_meant(&written(path))) {
        let mut tried = vec![before.clone()];
        for after in changes(&before) {
            // The last entry repeated, and the only one dropped, come about twice.
            if tried.contains(&after) {
                continue;
            }
            tried.push(after.clone());
            *at(&mut changed, &path) = after.clone();
            let is_accepted = accepts(&changed);
            *at(&mut changed, &path) = before.clone();
            if !is_accepted {
                refused += 1;
                continue;
            }
            let path = written(&path);
            assert!(
                excuse(&genuine["format"], &path, &before, &after).is_some(),
                "{path}: {before} became {after} and is accepted\n{genuine}"
            );
            excused += 1;
        }
    }
    (refused, excused)
}

#[track_caller]
fn assert_guarded(document: &impl serde::Serialize) {
    let (refused, excused) = mutated(document);
    assert!(refused > 10 * excused, "{refused} refused, {excused} accepted");
}

fn classify(text: &str, orders: &[u32], torque: bool, all_orders: bool) {
    let layout = file::parse("engine", text).expect("a layout");
    let every = all_orders.then(|| theorem(&layout).expect("a theorem"));
    let balances = judged(&layout, orders, torque);
    assert_guarded(&verdicts::document(&layout, &balances, torque, every.as_ref()));
}

#[test]
fn every_change_of_verdicts_is_refused() {
    classify("vee = { bank_angle = 60, throws = [0] }", &[1, 2], true, false);
    classify("inline = { throws = [0, '1/1000003 turn', 90] }", &[2], false, false);
    let masses = "inline.throws = [0, 180, 80]\n[mechanism]\nrod_ratio = 0.25\nreciprocating_mass = [1, 2, '3/7']";
    classify(masses, &[2, 3], false, false);
}

#[test]
fn every_change_of_whole_orders_is_refused() {
    let rod = |offset| Some(["1/4", offset]);
    let rods = || {
        let throws = [("1", "0", "0"), ("2", "1/3", "0"), ("3", "5/9", "1/10")];
        throws.map(|(name, throw, offset)| cylinder(name, [throw, "0", "1"], rod(offset))).to_vec()
    };
    let weight = || turning("weight", 1, Sense::Direct, ["1", "1/2", "1/3"]);
    let shaft = || turning("shaft", 2, Sense::Reverse, ["1/2", "1/7", "1/5"]);
    let reciprocating = document(Masses::Reciprocating, &[2], true, rods(), Vec::new());
    let all = document(Masses::All, &[1, 2], false, rods(), vec![weight(), shaft()]);
    let unknown = vec![cylinder("1", ["0", "0", "1"], None)];
    let open = document(Masses::All, &[2], false, unknown, vec![turning("shaft", 2, Sense::Direct, ["0", "0", "1"])]);
    for document in [reciprocating, all, open] {
        assert_guarded(&document);
    }
}

#[test]
fn every_change_of_links_on_a_master_rod_is_refused() {
    let row = "[mechanism]\nrod_ratio = '1/4'\nreciprocating_mass = [2, 1, 1]\n[articulated]\nmaster = 1\nknuckle_ratio = '1/5'";
    classify(&format!("radial.cylinders = 3\n{row}\nknuckle_mass = '1/3'"), &[1, 2], false, false);
    let engine =
        file::parse("engine", &format!("radial.cylinders = 3\n{row}\nknuckle_mass = '1/7'")).expect("a layout");
    let found = remedy(&engine, &Request { orders: vec![1, 2], ..Request::default() }).expect("a remedy");
    assert_guarded(&report::remedy_document(&found));
}

/// What hangs where is checked also where no vector comes of it.
#[test]
fn every_change_of_the_firing_stars_of_links_is_refused() {
    let text = "cycle = 'four-stroke'\nfiring_order = '1-3-2'\nradial.cylinders = 3\n[mechanism]\nrod_ratio = '1/4'\n[articulated]\nmaster = 1\nknuckle_ratio = '1/5'";
    let engine = file::parse("engine", text).expect("a layout");
    let stars = report::FiringStudy::new(&engine, &[], Weights::Rigid).expect("stars");
    let document = report::firing_document(&stars, false);
    assert_guarded(&document);
    let changes: [fn(&mut LinkClaim); 2] =
        [|link| link.angle = link.angle.recip(), |link| link.master = link.knuckle.clone()];
    for change in changes {
        let mut cheat = document.clone();
        for cylinder in &mut cheat.cylinders {
            if let RodStatement::Link(link) = &mut cylinder.rod {
                change(link);
            }
        }
        let fault = check_firing_document(&cheat).expect_err("a link without a master rod").to_string();
        assert!(fault.contains("master rod"), "{fault}");
        second::refuses(&[("a link without a master rod", cheat)]);
    }
    second::accepts(&[document], &[]);
}

/// Of two crankpins at one angle, and on none.
#[test]
fn a_link_in_another_plane_than_its_master_rod_is_refused() {
    let text = "[vee]\nbank_angle = 60\nthrows = [0, 0]\n[mechanism]\nrod_ratio = '1/4'\n[articulated]\nmaster = [1, 2]\nknuckle_ratio = '1/5'";
    let engine = file::parse("engine", text).expect("a layout");
    let found = remedy(&engine, &Request { orders: vec![1], ..Request::default() }).expect("a remedy");
    let verdicts = verdicts::document(&engine, &judged(&engine, &[1], false), false, None);
    let remedy = report::remedy_document(&found);
    let is_link = |rod: &RodStatement| matches!(rod, RodStatement::Link(_));
    let last = verdicts.cylinders.iter().rposition(|cylinder| is_link(&cylinder.rod)).expect("a link");
    for position in ["99", "0"].map(|position| position.parse::<BigRational>().expect("a number")) {
        let (mut one, mut other) = (verdicts.clone(), remedy.clone());
        one.cylinders[last].position = position.clone();
        other.cylinders[last].position = position;
        let faults = [check_document(&one).map(|_| ()), check_remedy_document(&other).map(|_| ())];
        for fault in faults {
            let fault = fault.expect_err("a link in another plane").to_string();
            assert!(fault.contains("master rod"), "{fault}");
        }
        second::refuses(&[("a link in another plane", one)]);
        second::refuses(&[("a link in another plane", other)]);
    }
    // On a crankshaft that turns faster there is no link, and so no master rod of one.
    let mut faster = verdicts.clone();
    for master in faster.cylinders.iter_mut().filter(|cylinder| !is_link(&cylinder.rod)) {
        master.speed = 2;
    }
    let fault = check_document(&faster).expect_err("a master rod on another crankshaft").to_string();
    assert!(fault.contains("master rod"), "{fault}");
    second::refuses(&[("a master rod on another crankshaft", faster)]);
    second::accepts(&[verdicts], &[]);
}

#[test]
fn masses_below_nothing_and_crank_radii_of_none_are_refused() {
    let engine = file::parse("engine", "inline.throws = [0, 180]").expect("a layout");
    let verdicts = verdicts::document(&engine, &judged(&engine, &[1], false), false, None);
    let changes: [fn(&mut Cylinder); 3] = [
        |one| one.reciprocating_mass = -&one.reciprocating_mass,
        |one| one.crank_radius = -&one.crank_radius,
        |one| one.crank_radius = BigRational::from_integer(0.into()),
    ];
    for change in changes {
        let mut cheat = verdicts.clone();
        cheat.cylinders.iter_mut().for_each(change);
        let fault = check_document(&cheat).expect_err("no size").to_string();
        assert!(fault.contains("less than nothing") || fault.contains("not above 0"), "{fault}");
        second::refuses(&[("no size", cheat)]);
    }
}

#[test]
fn every_change_of_links_with_corrected_knuckle_angles_is_refused() {
    let row = "radial.cylinders = 3\n[mechanism]\nrod_ratio = '1/4'\n[articulated]\nmaster = 1\nknuckle_ratio = '1/5'\nknuckle_correction = [3, -3]";
    classify(row, &[1], false, false);
}

#[test]
fn every_change_of_theorems_is_refused() {
    classify("inline.throws = [0, 180]\n[mechanism]\nrod_ratio = 0.25", &[2], false, true);
    classify("vee = { bank_angle = 90, throws = [0] }", &[1], false, true);
}

#[test]
fn every_change_of_statements_class_by_class_is_refused() {
    // An offset of either side, unequal masses; and banks that are alike.
    let rods = "[mechanism]\nrod_ratio = 0.25\noffset_ratio = [0.1, '-0.1']\nreciprocating_mass = [1, 2]";
    classify(&format!("inline.throws = [0, 180]\n{rods}"), &[1], false, true);
    let banks = "[mechanism]\nrod_ratio = 0.25\noffset_ratio = 0.1";
    classify(&format!("vee = {{ bank_angle = 180, throws = [0, 180] }}\n{banks}"), &[2], false, true);
}

#[test]
fn every_change_of_a_family_is_refused() {
    for text in [
        "vee = { bank_angle = 'phi', throws = [0, 90] }",
        "vee = { bank_angle = 'phi', pin_split = 'delta', throws = [0, 90], spacing = 'a' }",
        "fan = { banks = ['-phi', 0, 'phi'], throws = [0], positions = ['a'], bank_offsets = ['b', 0, '-b'] }",
    ] {
        let Ok(Layout::Open(open)) = file::parse_layout("family", text) else { panic!("a family: {text}") };
        assert_guarded(&report::open_document(&open, &family::classify(&open, &[1]).expect("orders")));
    }
}

#[test]
fn every_change_of_what_a_sum_is_divided_by_is_refused() {
    // (x² − x/2 + 1)(x + 2) and (x² − x/2 + 1)², x = e^{iφ}.
    for text in [
        "cylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
            { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 0 }]",
        "cylinder = [{ throw = 0, bank = 0, position = 0 }, { throw = 180, bank = 'phi/2', position = 0 },
            { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '9/4' },
            { throw = 180, bank = '3/2 phi', position = 0 }, { throw = 0, bank = '2 phi', position = 0 }]",
    ] {
        let Ok(Layout::Open(open)) = file::parse_layout("family", text) else { panic!("a family: {text}") };
        let document = report::open_document(&open, &family::classify(&open, &[1]).expect("orders"));
        let (refused, excused) = mutated_where(&document, |path| path.contains(".divided"));
        assert!(refused > 100 && refused > 10 * excused, "{refused} refused, {excused} accepted");
    }
}

#[test]
fn every_change_of_a_remedy_is_refused() {
    for text in [
        "inline.throws = [0, 120, 240]",
        "vee = { bank_angle = 60, throws = [0, 180] }\n[mechanism]\nrotating_mass = '1/3'\nreciprocating_mass = 1",
        "inline.throws = [0, 100]\n[mechanism]\nrod_ratio = 0.3\noffset_ratio = [0.1, -0.1]\nreciprocating_mass = [1, 2]",
    ] {
        let layout = file::parse("engine", text).expect("a layout");
        let found = remedy(&layout, &Request { orders: vec![1, 2], ..Request::default() }).expect("a remedy");
        assert_guarded(&report::remedy_document(&found));
    }
}
