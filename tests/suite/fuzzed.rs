//! Does any input of a reader end in an answer or a message? The seeds of the fuzz targets, and thousands of changes to them.
//!
//! `fuzz/run` drives the same functions by coverage; here they run wherever the tests do.

#[path = "../../fuzz/src/targets.rs"]
mod targets;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::dice::Dice;
use crate::support::verdicts::{self, judged, theorem};
use crankstar::file::{self, Layout};
use crankstar::remedy::{self, Request};
use crankstar::search::{Options, search};
use crankstar::{family, report};

/// Changed inputs of each target.
const CHANGED: u64 = 600;

/// What a change may put in: signs of the formats, and numbers at the edges of types.
const PIECES: &[&str] = &[
    "",
    "\n",
    " ",
    "[",
    "]",
    "{",
    "}",
    "\"",
    "'",
    ",",
    ".",
    "..",
    ":",
    "=",
    "-",
    "−",
    "/",
    "1/0",
    "0",
    "-1",
    "1e100",
    "1e-100",
    "1e101",
    "nan",
    "inf",
    "null",
    "true",
    "[]",
    "{}",
    "255",
    "65536",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "18446744073709551615",
    "340282366920938463463374607431768211456",
    "phi",
    "delta",
    "a",
    "mm",
    "°",
    "turn",
    "√",
    "\u{0}",
    "\u{feff}",
    "\\",
    "$",
    "orders = [1000]\n",
    "order = 0\n",
    "throws = []\n",
    "cylinders = 0\n",
    "[mechanism]\n",
    "[[cylinder]]\n",
];

fn seeds_folder(target: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds").join(target)
}

/// The seeds of a target, in the order of their names.
fn seeds(target: &str) -> Vec<Vec<u8>> {
    let entries = fs::read_dir(seeds_folder(target)).expect("seeds").map(|entry| entry.expect("a seed").path());
    let seeds: BTreeMap<PathBuf, Vec<u8>> =
        entries.map(|path| (path.clone(), fs::read(path).expect("a seed"))).collect();
    assert!(!seeds.is_empty(), "{target} has no seeds");
    seeds.into_values().collect()
}

/// A seed with one to four stretches replaced: by a piece, by nothing, by a stretch of another seed, by any byte.
fn changed(dice: &mut Dice, seeds: &[Vec<u8>]) -> Vec<u8> {
    let any = |dice: &mut Dice, count: usize| dice.below(count.max(1) as u64) as usize;
    let mut bytes = seeds[any(dice, seeds.len())].clone();
    for _ in 0..=dice.below(4) {
        let from = any(dice, bytes.len() + 1);
        let to = (from + any(dice, 12)).min(bytes.len());
        let put: Vec<u8> = match dice.below(4) {
            0 => vec![dice.below(256) as u8],
            1 => {
                let other = &seeds[any(dice, seeds.len())];
                let start = any(dice, other.len());
                other[start..(start + any(dice, 40)).min(other.len())].to_vec()
            }
            _ => PIECES[any(dice, PIECES.len())].as_bytes().to_vec(),
        };
        bytes.splice(from..to, put);
    }
    bytes
}

fn drive(target: &str, more: Vec<Vec<u8>>, function: fn(&[u8])) {
    let seeds = [seeds(target), more].concat();
    seeds.iter().for_each(|seed| function(seed));
    let mut dice = Dice::new(seeds.len() as u64);
    for number in 0..CHANGED {
        let input = changed(&mut dice, &seeds);
        let outcome = std::panic::catch_unwind(|| function(&input));
        assert!(outcome.is_ok(), "{target} fails on input {number}:\n{}", String::from_utf8_lossy(&input));
    }
}

fn catalogue() -> Vec<Vec<u8>> {
    file::catalogue().expect("a catalogue").into_iter().map(|(entry, _)| entry.text.into()).collect()
}

#[test]
fn any_layout_file_ends_in_an_engine_or_a_message() {
    drive("layout", catalogue(), targets::layout);
}

#[test]
fn any_claims_file_ends_in_answers_or_a_message() {
    drive("claims", Vec::new(), targets::claims);
}

#[test]
fn any_document_is_accepted_or_refused() {
    drive("document", Vec::new(), targets::document);
}

#[test]
fn any_state_of_a_search_is_resumed_or_refused() {
    drive("resume", Vec::new(), targets::resume);
}

#[test]
fn any_value_of_the_command_line_is_taken_or_refused() {
    drive("values", Vec::new(), targets::values);
}

#[test]
fn seeds_of_documents_and_states_are_what_the_program_writes_today() {
    let engine = |name: &str| file::find(name).expect("an engine").engine().expect("a layout");
    let twin = engine("V2-60");
    let theorem = theorem(&twin).expect("a theorem");
    let orders = judged(&twin, &[1, 2], true);
    let verdicts = verdicts::document(&twin, &orders, true, Some(&theorem));
    assert_golden("document", "verdicts.json", &json(&verdicts));
    let Ok(Layout::Open(family)) = file::parse_layout("v.toml", OPEN) else { panic!("a family") };
    assert_golden(
        "document",
        "family.json",
        &json(&report::open_document(&family, &family::classify(&family, &[2]).expect("orders"))),
    );
    let request = Request { orders: vec![1, 2], ..Request::default() };
    let remedy = remedy::remedy(&engine("I3"), &request).expect("a remedy");
    assert_golden("document", "remedy.json", &json(&report::remedy_document(&remedy)));
    let path = std::env::temp_dir().join(format!("crankstar-seed-{}.shard", std::process::id()));
    let options = Options { threads: 1, resume: Some(path.clone()), ..Options::default() };
    search(&targets::problem(), &options).expect("a front");
    assert_golden("resume", "state.shard", &fs::read_to_string(&path).expect("a state"));
    fs::remove_file(&path).expect("the file of this search");
}

const OPEN: &str = "[vee]\nbank_angle = \"phi\"\nthrows = [0, 120]\npositions = [\"a\", 0]";

fn json(document: &impl serde::Serialize) -> String {
    serde_json::to_string(document).expect("a document")
}

fn assert_golden(target: &str, name: &str, text: &str) {
    let path = seeds_folder(target).join(name);
    if std::env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::write(&path, text).expect("a seed");
    }
    assert_eq!(fs::read_to_string(&path).unwrap_or_default(), text, "{}", path.display());
}
