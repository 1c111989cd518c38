//! Does what a terminal shows fit its columns, and does one table tell size, cure and residual where masses and speed are given?

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

use crankstar::report::questions;

use crate::support::program::call;

fn printed(arguments: &[&str]) -> Option<String> {
    let output = call(arguments);
    output.status.success().then(|| String::from_utf8(output.stdout).expect("a text"))
}

/// The columns that a line takes: a combining mark takes none, a letter of East Asia two.
fn width(line: &str) -> usize {
    let columns = |letter: char| match letter as u32 {
        0x300..=0x36f | 0x200b..=0x200f => 0,
        0x1100..=0x115f | 0x2e80..=0xa4cf | 0xac00..=0xd7a3 | 0xff00..=0xff60 => 2,
        _ => 1,
    };
    line.chars().map(columns).sum()
}

#[test]
fn a_line_is_measured_in_columns() {
    assert_eq!(["P\u{302}⁺", "m r ω²", "直列", "½(|P⁺|)"].map(width), [2, 6, 4, 7]);
}

/// The layouts of a folder, one each.
fn layouts(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).expect("a folder");
    let files = entries.map(|entry| entry.expect("an entry").path().join("layout.toml"));
    let mut files: Vec<PathBuf> = files.filter(|path| path.is_file()).collect();
    files.sort();
    files
}

/// What is asked of an engine without numbers.
const OF_NAMES: [&[&str]; 7] = [
    &["classify"],
    &["classify", "--all"],
    &["classify", "--torque"],
    &["classify", "--orders", "1,2,3,4,5,6,12"],
    &["classify", "--firing"],
    &["remedy"],
    &["stars"],
];

#[test]
fn every_answer_fits_eighty_columns() {
    let catalogue: Vec<String> =
        crankstar::file::catalogue().expect("the catalogue").iter().map(|(entry, _)| entry.name.to_owned()).collect();
    let examples = layouts("reports/examples");
    let mut calls: Vec<Vec<String>> = Vec::new();
    let mut ask = |layout: &str, command: &[&str], index: usize| {
        let [name, options @ ..] = command else { unreachable!("a command has a name") };
        let language = ["--lang", if index.is_multiple_of(2) { "en" } else { "de" }];
        let call = [*name, layout].into_iter().chain(options.iter().copied()).chain(language);
        calls.push(call.map(str::to_owned).collect());
    };
    for (index, (name, command)) in catalogue.iter().zip(OF_NAMES.iter().cycle()).enumerate() {
        ask(name, command, index);
    }
    // Of a layout file that lacks what an answer needs there is none.
    let of_files: Vec<&str> = std::iter::once("classify").chain(questions()).collect();
    let of_files = examples.iter().flat_map(|path| [path; 5]).zip(of_files.iter().cycle());
    for (index, (path, command)) in of_files.enumerate() {
        ask(path.to_str().expect("UTF-8"), &[command], index);
    }
    for alone in
        [&["list"][..], &["compare", "I4", "V8-crossplane", "boxer-6"], &["values", "I4", "I6", "--value", "force:2"]]
    {
        calls.push(alone.iter().map(|word| (*word).to_owned()).collect());
    }
    let answered = Mutex::new(BTreeSet::new());
    let lines = |calls: &[Vec<String>]| -> usize {
        let answers = calls.iter().filter_map(|call| {
            let arguments: Vec<&str> = call.iter().map(String::as_str).collect();
            let answer = printed(&arguments)?;
            answered.lock().expect("no other panic").insert(call[0].clone());
            for line in answer.lines() {
                assert!(width(line) <= 80, "{} columns, {call:?}:\n{line}", width(line));
            }
            Some(answer.lines().count())
        });
        answers.sum()
    };
    let (one, other) = calls.split_at(calls.len() / 2);
    let counted = thread::scope(|scope| {
        let other = scope.spawn(|| lines(other));
        lines(one) + other.join().expect("the other half")
    });
    assert!(counted > 800, "only {counted} lines");
    let answered = answered.into_inner().expect("no panic");
    assert!(questions().all(|question| answered.contains(question)), "only {answered:?}");
}

/// Words that are longer than half a line, in the head and beside it.
#[test]
fn tables_of_values_fit_eighty_columns_though_names_are_long() {
    let mut names = Vec::new();
    for order in [1, 2, 4, 6, 8, 10] {
        names.extend(["force", "moment", "force_direct_zero_to_peak"].map(|it| format!("loads.orders.{order}.{it}")));
    }
    let asked = ["reports/examples/v8-gas/layout.toml", "I4"].into_iter();
    let asked = asked.chain(names.iter().flat_map(|name| ["--value", name]));
    for command in ["values", "compare"] {
        let answer = printed(&[command].into_iter().chain(asked.clone()).collect::<Vec<_>>()).expect("an answer");
        for line in answer.lines() {
            assert!(width(line) <= 80, "{} columns: {line}", width(line));
        }
    }
}

/// The cells of the row that begins with this name and order.
fn row(answer: &str, name: &str, order: &str) -> Vec<String> {
    let cells = |line: &str| -> Vec<String> {
        line.split("  ").map(|cell| cell.trim().to_owned()).filter(|cell| !cell.is_empty()).collect()
    };
    let mut rows = answer.lines().map(cells);
    rows.find(|cells| cells.len() > 2 && cells[0] == name && cells[1] == order).unwrap_or_else(|| panic!("{answer}"))
}

/// m r ω² = 0.55 · 0.043 · (200 π)² N, times 4 c₂ with λ = 43/146: 11.25 kN.
#[test]
fn one_table_tells_what_shakes_at_which_speed_what_cures_it_and_what_that_leaves() {
    let answer = printed(&["classify", "examples/four.toml"]).expect("an answer");
    let rules = answer.lines().filter(|line| line.starts_with('─')).count();
    assert_eq!(rules, 1, "one table: {answer}");
    let head = answer.lines().nth(2).expect("a head");
    for word in ["At 6000 rpm", "Order", "Size", "Cure", "Leaves"] {
        assert!(head.contains(word), "{head}");
    }
    let lambda: f64 = 43.0 / 146.0;
    let c2 = lambda + lambda.powi(3) / 4.0 + 15.0 * lambda.powi(5) / 128.0;
    let force = 4.0 * c2 * 0.55 * 0.043 * (200.0 * std::f64::consts::PI).powi(2) / 1000.0;
    let second = row(&answer, "Vertical force", "2");
    assert_eq!(second[2], format!("{force:.2}\u{202f}kN"));
    assert_eq!(second.last().map(String::as_str), Some("0"), "a pair of shafts leaves nothing");
    assert_eq!(row(&answer, "Moment", "1, 2, 4, 6")[2], "0");
    // Exact numbers follow where all is asked for.
    let all = printed(&["classify", "examples/four.toml", "--all"]).expect("an answer");
    assert!(all.contains("4, planar") && !answer.contains("planar"), "{all}");
}

/// Counterweights on a three remove the half of the couple that turns with the crank, and what turns besides: the other half of 2000 N·m is left.
#[test]
fn what_a_step_of_a_cure_leaves_has_its_size() {
    let answer = printed(&["classify", "reports/examples/thesis-i3/layout.toml"]).expect("an answer");
    let first = row(&answer, "Pitching and yawing", "1");
    assert_eq!((first[2].as_str(), first.last().map(String::as_str)), ("3539\u{202f}N·m", Some("1000\u{202f}N·m")));
    assert!(answer.contains("a shaft against"), "{answer}");
}
