//! Do the pages of the study in `reports/grigoryev` say what the program finds, and what the paper does?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test grigoryev` writes them anew.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::{env, fs};

use crankstar::claim::{Found, Study, study};
use crankstar::report;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/grigoryev")
}

fn read() -> &'static Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| {
        let file = |name: &str| fs::read_to_string(folder().join(name)).map_err(|error| format!("{name}: {error}"));
        study("study.toml", &file("study.toml").expect("the study"), &file).expect("it reads")
    })
}

#[test]
fn the_study_is_as_stored() {
    let files = report::study_page(read());
    let entries = fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    let names = entries.map(|name| name.to_string_lossy().into_owned());
    let stale = names.filter(|name| !name.ends_with(".toml") && files.iter().all(|file| file.name != *name));
    let stale: Vec<String> = stale.collect();
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        stale.iter().for_each(|name| fs::remove_file(folder().join(name)).expect("a stale file"));
        for file in &files {
            fs::write(folder().join(&file.name), &file.text).expect("a file");
        }
    } else {
        assert!(stale.is_empty(), "{stale:?}");
    }
    for file in &files {
        let stored = fs::read_to_string(folder().join(&file.name)).expect("a stored file");
        let first = stored.lines().zip(file.text.lines()).position(|(old, new)| old != new);
        assert!(stored == file.text, "{} differs, first in line {:?}", file.name, first.map(|line| line + 1));
    }
}

#[test]
fn exactly_these_checks_fail_and_each_is_corrected_in_its_conclusion() {
    let failing: Vec<(&str, &str)> = read()
        .statements
        .iter()
        .flat_map(|said| &said.checks)
        .filter(|check| !check.holds)
        .map(|check| (check.engine.written(), check.claim.written()))
        .collect();
    let right = [
        ("six-in-line.toml", "every order of the force vanishes"),
        ("six", "moment 2 vanishes nowhere"),
        ("six", "moment 2 is of constant length nowhere"),
        ("six", "the most uneven firing of the grid is that only at 180°"),
        ("eight-in-line.toml", "fourth-order force vanishes"),
        ("eight-flat", "force 2 vanishes nowhere"),
        ("four-in-line.toml", "second-order force vanishes"),
    ];
    assert_eq!(failing, right);
    let words = ["but", "not", "is left", "second resultant", "False"];
    for said in read().statements.iter().filter(|said| said.checks.iter().any(|check| !check.holds)) {
        assert!(words.iter().any(|word| said.conclusion.written().contains(word)), "{}", said.text.written());
    }
}

#[test]
fn every_list_of_angles_is_proved_to_be_complete() {
    for check in read().statements.iter().flat_map(|said| &said.checks) {
        if let Found::Values { everywhere, complete, .. } = &check.found {
            assert!(*everywhere || *complete, "{}", check.claim.written());
        }
    }
}
