//! Do both checkers, `crankstar verify` and `formal/verify.py`, say the same of a document, genuine or changed anywhere?

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use crankstar::file::{self, Layout};
use crankstar::proof::{Reason, read_document};
use crankstar::{family, report};
use serde::Serialize;
use serde_json::Value;

use crate::support::dice::Dice;
use crate::support::mutations::{Step, at, changes, walk, written};
use crate::support::program::{call, scratch};
use crate::support::second::second_checker;
use crate::support::trust::{grouped, renew};
use crate::support::two_angles;
use crate::support::verdicts::{self, judged};

/// What a checker says of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Answer {
    /// It holds; whether it says itself that nothing is claimed of some angles, and whether that something is left out.
    Holds {
        leaves_open: bool,
        leaves_out: bool,
    },
    Refused(String),
    /// It would take more steps than the first checker makes; the second one counts none.
    TooCostly,
}

fn first_checker(bytes: &[u8]) -> Answer {
    let document = match read_document(bytes) {
        Ok(document) => document,
        Err(error) => return Answer::Refused(error.to_string()),
    };
    match document.check() {
        Ok(checked) => {
            let says = |words: &str| checked.not_covered.iter().any(|what| what.contains(words));
            Answer::Holds { leaves_open: says("`not-solved`"), leaves_out: says("`left_out`") }
        }
        Err(fault) if fault.reason == Reason::TooManySteps => Answer::TooCostly,
        Err(fault) => Answer::Refused(fault.to_string()),
    }
}

/// The answers of the second checker, file by file; none where there is no Python.
fn second_checkers(files: &[PathBuf]) -> Option<Vec<Answer>> {
    let (told, _) = second_checker(files)?;
    let mut answers: Vec<Answer> = Vec::new();
    for line in told.lines() {
        match (line.strip_prefix("  not checked: "), answers.last_mut()) {
            (Some(what), Some(Answer::Holds { leaves_open, leaves_out })) => {
                *leaves_open |= what.contains("`not-solved`") || what.contains("nothing is claimed");
                *leaves_out |= what.contains("`left_out`");
            }
            (Some(what), _) => panic!("nothing holds of which this is not checked: {what}"),
            (None, _) if line.contains(": verified, ") => {
                answers.push(Answer::Holds { leaves_open: false, leaves_out: false });
            }
            (None, _) => answers.push(Answer::Refused(line.to_owned())),
        }
    }
    assert_eq!(answers.len(), files.len());
    Some(answers)
}

/// Fails where both do not say the same of each; returns how many hold and how many are refused.
#[track_caller]
fn agree(name: &str, documents: &[(String, String)]) -> [usize; 2] {
    let folder = scratch(name);
    let file = |(index, (_, text)): (usize, &(String, String))| {
        let path = folder.join(format!("{index}.json"));
        fs::write(&path, text).expect("written");
        path
    };
    let files: Vec<PathBuf> = documents.iter().enumerate().map(file).collect();
    let Some(second) = second_checkers(&files) else { return [0, 0] };
    let (mut counts, mut costly, mut differing) = ([0, 0], 0, Vec::new());
    for (((what, text), file), second) in documents.iter().zip(&files).zip(second) {
        let first = first_checker(text.as_bytes());
        match (&first, &second) {
            (Answer::Refused(_), Answer::Refused(_)) => counts[1] += 1,
            (Answer::TooCostly, _) => costly += 1,
            _ if first == second => counts[0] += 1,
            _ => differing
                .push(format!("{what}\n  {}\n  the first: {first:?}\n  the second: {second:?}", file.display())),
        }
    }
    assert!(differing.is_empty(), "{} of {} differ:\n{}", differing.len(), documents.len(), differing.join("\n"));
    assert!(costly * 100 <= documents.len(), "{costly} of {} take too many steps", documents.len());
    counts
}

/// What the program prints for a layout.
fn printed(folder: &str, layout: &str, arguments: &[&str]) -> Value {
    let path = scratch(folder).join("engine.toml");
    fs::write(&path, layout).expect("written");
    told(&[&[arguments[0], path.to_str().expect("UTF-8")], &arguments[1..]].concat())
}

fn told(arguments: &[&str]) -> Value {
    let output = call(&[arguments, &["--json"]].concat());
    let why = String::from_utf8_lossy(&output.stderr);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{arguments:?}: {error}: {why}"))
}

fn value(document: &impl Serialize) -> Value {
    serde_json::to_value(document).expect("JSON")
}

/// Documents of every kind, with every kind of certificate and of evidence, and some that leave something open or out.
fn genuine() -> Vec<(&'static str, Vec<Value>)> {
    let classify = |layout: &str, more: &[&str]| printed("both-checkers", layout, &[&["classify"], more].concat());
    let rods = "[mechanism]\nrod_ratio = 0.25";
    let offsets = format!("{rods}\noffset_ratio = [0.1, '-0.1', 0.1]\nreciprocating_mass = [1, 2, 1]");
    let lengths = "[mechanism]\nrod_ratio = [0.25, 0.3, 0.25]\nreciprocating_mass = [1, 2, 1]";
    let link = format!(
        "radial.cylinders = 3\n{rods}\nreciprocating_mass = [2, 1, 1]\n[articulated]\nmaster = 1\nknuckle_ratio = '1/5'"
    );
    let weight = "position = 0\nangle = 90\nmass_radius = '1/4 m r'";
    let weights = format!("[[counterweight]]\n{weight}\n[[balancer]]\norder = 2\nsense = 'against'\n{weight}");
    let inline = "inline.throws = [0, 180, 80]\n";
    let splitting = file::parse("engine", "inline = { throws = [0, '1/1000003 turn', 90] }").expect("a layout");
    let balance = vec![
        classify("vee = { bank_angle = 60, throws = [0, 180] }", &["--orders", "1,2"]),
        value(&verdicts::document(&splitting, &judged(&splitting, &[2], false), false, None)),
        classify("inline.throws = [0, 120, 240]", &["--orders", "1,2,3"]),
        classify(&format!("{inline}{rods}"), &["--orders", "2,3"]),
        classify(&format!("inline.throws = [0, 180]\n{rods}\n{weights}"), &["--orders", "1,2", "--masses", "all"]),
    ];
    let torque = vec![
        classify("vee = { bank_angle = 90, throws = [0, 90] }", &["--orders", "1,2", "--torque"]),
        classify(&format!("{inline}{lengths}"), &["--orders", "1,2", "--torque"]),
        classify(
            &format!("u = {{ sense = 'against', phase = 0, distance = '3/2', throws = [0, 180] }}\n{rods}"),
            &["--orders", "1,2", "--torque"],
        ),
    ];
    let wholes = vec![
        classify(&format!("{inline}{offsets}"), &["--orders", "1,2,3"]),
        classify(&format!("{inline}{lengths}"), &["--orders", "2,3"]),
        classify(&format!("{link}\nknuckle_mass = '1/3'"), &["--orders", "1,2"]),
        classify(&format!("{link}\nknuckle_correction = [3, -3]"), &["--orders", "1,2"]),
    ];
    let every_order = vec![
        classify("inline.throws = [0, 180]", &["--orders", "1", "--all-orders"]),
        classify(&format!("vee = {{ bank_angle = 90, throws = [0] }}\n{rods}"), &["--orders", "2", "--all-orders"]),
    ];
    let classes = vec![
        classify(&format!("inline.throws = [0, 180, 80]\n{offsets}"), &["--orders", "1", "--all-orders"]),
        classify(
            &format!("vee = {{ bank_angle = 180, throws = [0, 180] }}\n{rods}\noffset_ratio = 0.1"),
            &["--orders", "2", "--all-orders"],
        ),
    ];
    let firing = vec![
        told(&["classify", "I4", "--firing"]),
        told(&["classify", "V2-90", "--firing", "--all-orders"]),
        classify(
            &format!("cycle = 'two-stroke'\nfiring_order = [1, 3, 2]\ninline.throws = [0, 120, 240]\n{lengths}"),
            &["--firing"],
        ),
    ];
    let family = |text: &str| {
        let Ok(Layout::Open(open)) = file::parse_layout("family", text) else { panic!("a family: {text}") };
        value(&report::open_document(&open, &family::classify(&open, &[1, 2]).expect("orders")))
    };
    let one_angle = vec![
        family("vee = { bank_angle = 'phi', throws = [0, 90] }"),
        family("fan = { banks = ['-phi', 0, 'phi'], throws = [0], positions = ['a'], bank_offsets = ['b', 0, '-b'] }"),
        family("[fan]\nbanks = ['-phi', 0, 'phi']\nthrows = [0, 90, 200]\n[mechanism]\nreciprocating_mass = [1, 2, 1, 1, 2, 3, 1, 2, 1]"),
        family("cylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
            { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 0 }]"),
    ];
    let two_angles: Vec<Value> = two_angles::documents().iter().map(value).collect();
    let quadratics: Vec<Value> = two_angles::quadratic_documents().iter().map(value).collect();
    let boxes: Vec<Value> = two_angles::torus_documents().iter().map(value).collect();
    let loads = |layout: &str, orders: &str| printed("both-checkers", layout, &["loads", "--orders", orders]);
    let numbers = vec![
        loads(&format!("inline.throws = [0]\n{rods}"), "1,2,3"),
        loads(&format!("{inline}{lengths}"), "1,2"),
        told(&["compare", "I2-180", "I3", "--orders", "1,2"]),
    ];
    let remedy = |layout: &str| printed("both-checkers", layout, &["remedy", "--orders", "1,2"]);
    let remedies = vec![
        remedy("inline.throws = [0, 120, 240]"),
        remedy(&format!("{inline}{offsets}")),
        remedy(&format!("inline.throws = [0, 180, 180, 0]\n{rods}\nreciprocating_mass = [1, 1, 1, '1.0000003']")),
        remedy(&format!("{link}\nknuckle_mass = '1/3'")),
    ];
    vec![
        ("verdicts", balance),
        ("torque", torque),
        ("several sums", wholes),
        ("every order", every_order),
        ("class by class", classes),
        ("firing stars", firing),
        ("one open angle", one_angle),
        ("two open angles", two_angles),
        ("three classes", quadratics),
        ("boxes", boxes),
        ("numbers", numbers),
        ("remedies", remedies),
    ]
}

/// Places by what stands there, so that the many coefficients of certificates do not crowd out all else.
fn places(document: &Value) -> Vec<Vec<(Vec<Step>, Value)>> {
    let mut all = Vec::new();
    walk(document, &mut Vec::new(), &mut all);
    let mut alike: BTreeMap<String, Vec<(Vec<Step>, Value)>> = BTreeMap::new();
    for (path, value) in all {
        alike.entry(written(&path)).or_default().push((path, value));
    }
    alike.into_values().collect()
}

fn drawn<'a, T>(dice: &mut Dice, list: &'a [T]) -> &'a T {
    &list[dice.below(list.len() as u64) as usize]
}

/// Changes as many documents as are asked for, of every kind equally many, each in one place; gives a page that tells of it.
#[track_caller]
fn changed_documents_agree(count: usize, seed: u64) -> String {
    let genuine = genuine();
    let unchanged: Vec<(String, String)> = genuine
        .iter()
        .flat_map(|(kind, documents)| documents.iter().map(|document| ((*kind).to_owned(), document.to_string())))
        .collect();
    let [hold, _] = agree("both-checkers-genuine", &unchanged);
    let places: Vec<Vec<_>> =
        genuine.iter().map(|(_, documents)| documents.iter().map(places).collect::<Vec<_>>()).collect();
    let mut dice = Dice::new(seed);
    let mut changed = Vec::new();
    while changed.len() < count {
        let kind = changed.len() % genuine.len();
        let which = dice.below(genuine[kind].1.len() as u64) as usize;
        let alike = drawn(&mut dice, &places[kind][which]);
        let (path, before) = drawn(&mut dice, alike).clone();
        let all = changes(&before);
        let after = drawn(&mut dice, &all).clone();
        if after == before {
            continue;
        }
        let mut document = genuine[kind].1[which].clone();
        *at(&mut document, &path) = after.clone();
        let what = format!("{} {which}: {}: {before} became {after}", genuine[kind].0, written(&path));
        let what: String = what.chars().take(300).collect();
        changed.push((what, document.to_string()));
    }
    let [still_hold, refused] = agree(&format!("both-checkers-{count}"), &changed);
    if hold > 0 {
        assert_eq!(hold, unchanged.len());
        assert!(refused > 5 * still_hold, "{refused} refused, {still_hold} hold");
    }
    let kinds: Vec<String> = genuine.iter().map(|(kind, documents)| format!("{kind} ({})", documents.len())).collect();
    format!(
        "# Changed documents\n\n\
         {} documents, each changed in one place, pseudo-random and the same every time, of these kinds, with the number of genuine documents of \
         each: {}. A change is another number, sign, truth, word or spelling, a key or an entry taken away, added or exchanged. `crankstar verify` and \
         `formal/verify.py`, which share no code, say the same of each, of the genuine ones too: none differs.\n\n\
         | Answer of both | Documents |\n| --- | --- |\n| refused | {} |\n| hold: what was changed is not claimed, or is still true | {} |\n\n\
         `CRANKSTAR_RENEW=1 cargo test --test suite -- --ignored two_thousand_changed` writes this page anew.\n",
        grouped(count),
        kinds.join(", "),
        grouped(refused),
        grouped(still_hold),
    )
}

#[test]
fn two_hundred_changed_documents_of_every_kind_are_answered_alike() {
    changed_documents_agree(200, 1);
}

/// Run it by `cargo test --test suite -- --ignored changed_documents`.
#[test]
#[ignore = "it takes minutes"]
fn two_thousand_changed_documents_of_every_kind_are_answered_alike() {
    renew("checkers.md", &changed_documents_agree(2000, 2));
}
