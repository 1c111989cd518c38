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
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        for file in &files {
            fs::write(folder().join(&file.name), &file.text).expect("a file");
        }
    }
    let stored = fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    for name in stored.map(|name| name.to_string_lossy().into_owned()) {
        assert!(name.ends_with(".toml") || files.iter().any(|file| file.name == name), "{name} is stale");
    }
    for file in &files {
        let stored = fs::read_to_string(folder().join(&file.name)).expect("a stored file");
        let first = stored.lines().zip(file.text.lines()).position(|(old, new)| old != new);
        assert!(stored == file.text, "{} differs, first in line {:?}", file.name, first.map(|line| line + 1));
    }
}

#[test]
fn exactly_the_statements_that_the_pages_correct_have_checks_that_fail() {
    let study = read();
    let failing = study.statements.iter().filter(|said| said.checks.iter().any(|check| !check.holds));
    let failing: Vec<&str> = failing.map(|said| said.text.split_whitespace().next().expect("a word")).collect();
    assert_eq!(failing.len(), 8, "{failing:?}");
    for said in &study.statements {
        let corrected = said.checks.iter().any(|check| !check.holds);
        let plain = ["Confirmed.", "Confirmed, and nowhere else.", "Confirmed. At"];
        assert!(!corrected || !plain.iter().any(|words| said.conclusion == *words), "{}", said.text);
    }
}

#[test]
fn every_list_of_angles_is_proved_to_be_complete() {
    for check in read().statements.iter().flat_map(|said| &said.checks) {
        if let Found::Values { everywhere, complete, .. } = &check.found {
            assert!(*everywhere || *complete, "{}", check.claim);
        }
    }
}
