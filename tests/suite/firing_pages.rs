//! Do the pages in `reports/firing` still say what the program writes, and are claims about firing orders answered rightly?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite firing_pages` writes them anew.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{env, fs};

use crankstar::claim::{Claims, Status, answer, parse_claims, parse_statement};
use crankstar::engine::Cycle;
use crankstar::file;
use crankstar::firing::Weights;
use crankstar::page::{Document, Format, Language};
use crankstar::proof::check_certificate;
use crankstar::report::{self, FiringStudy};
use num_rational::BigRational;

use crate::support::figure_texts::FigureTexts;
use crate::support::german::phrases;
use crate::support::golden;
use crate::support::pages::text;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/firing")
}

fn assert_stored(name: &str, page: &Document) {
    let (path, page) = (folder().join(name), golden::linked("firing", &text(page, Format::GITHUB)));
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::write(&path, &page).expect("the page");
    }
    assert!(fs::read_to_string(&path).expect("the page") == page, "{} differs", path.display());
}

#[test]
fn the_pages_of_both_cycles_are_as_stored() {
    let engines = file::catalogue().expect("the catalogue reads");
    assert_stored("four-stroke.md", &report::firing_catalogue_page(&engines, Cycle::FourStroke));
    // An engine whose orders are several stars has no strongest one of those that it leaves.
    let page = text(&report::firing_catalogue_answer(&engines, Cycle::FourStroke), Format::GITHUB);
    let row = page.lines().find(|line| line.contains("[radial-9-master]")).expect("its row");
    assert!(row.ends_with("| several stars |"), "{row}");
    assert_stored("two-stroke.md", &report::firing_catalogue_page(&engines, Cycle::TwoStroke));
}

fn claims() -> Claims {
    let text = fs::read_to_string(folder().join("claims.toml")).expect("the claims");
    let find = |name: &str| match file::find(name) {
        Some(entry) => entry.engine().map_err(|error| error.to_string()),
        None => {
            let text = fs::read_to_string(folder().join(name)).map_err(|error| error.to_string())?;
            file::parse(name, &text).map_err(|error| error.to_string())
        }
    };
    parse_claims("claims.toml", &text, &find).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_page_of_claims_is_as_stored() {
    assert_stored("claims.md", &report::claims_page(&claims()));
}

#[test]
fn every_answer_is_decided_and_its_certificates_hold() {
    let claims = claims();
    for claim in claims.statements.iter().flat_map(|statement| &statement.claims) {
        let answer = claim.answer();
        assert_ne!(answer.status, Status::NotDecided, "{}", claim.says.written());
        assert!(!answer.evidence.is_empty(), "{}", claim.says.written());
        for evidence in &answer.evidence {
            check_certificate(&evidence.sum().vectors(), evidence.vanishes(), evidence.certificate())
                .expect("it holds");
        }
    }
}

/// The values are those of the theory's tables, which [`super::firing`] holds the stars to.
#[test]
fn claims_about_the_gas_torque_are_answered() {
    for (engine, says, right) in [
        ("I4", "the half order vanishes", Status::True),
        ("I4", "The half order does not vanish.", Status::False),
        ("I4", "order 2 of the gas torque vanishes", Status::False),
        ("I4", "orders 1/2, 1 and 1½ of the gas torque vanish", Status::True),
        ("I4", "orders 1/2, 1 and 2 of the gas torque vanish", Status::False),
        ("I4", "orders 1/2, 1 and 2 of the gas torque do not vanish", Status::False),
        ("I4", "order 1/2 is the strongest minor order", Status::False),
        ("I6", "order 3/2 is the strongest minor order in the mode 6, 5, 4, 3, 2, 1", Status::True),
        // The same star an integer number of periods on, and its mirror image.
        ("I6", "order 15/2 is the strongest minor order in the mode 6, 5, 4, 3, 2, 1", Status::True),
        ("I6", "orders 1/2 and 3/2 are the strongest minor orders in the mode 6, 5, 4, 3, 2, 1", Status::False),
        ("I2-180", "orders 1/2 and 3/2 are the strongest minor orders", Status::True),
        // It does not say when it fires.
        ("V6-60-shared", "the half order vanishes", Status::NotDecided),
    ] {
        let layout = file::find(engine).expect("known").engine().expect("reads");
        let statement = parse_statement(says).unwrap_or_else(|error| panic!("{says}: {error:?}"));
        assert_eq!(answer(&layout, &statement, None).status, right, "{engine}: {says}");
    }
}

#[test]
fn what_is_no_claim_about_the_gas_torque_is_refused_with_a_word_on_it() {
    for (says, words) in [
        ("order 1/3 of the gas torque vanishes", "1/3"),
        ("orders of the gas torque vanish", "names no order"),
        ("every order of the gas torque vanishes", "names no order"),
        ("order 3/2 is the strongest minor order in the mode 6, five", "five"),
    ] {
        let error = parse_statement(says).expect_err("no claim");
        assert!(error.message.contains(words), "{says}: {}", error.message);
    }
}

/// The pages of engines of every kind, and of claims.
fn pages() -> Vec<Document> {
    let engines = file::catalogue().expect("the catalogue reads");
    let mut pages = vec![report::claims_page(&claims())];
    for cycle in [Cycle::FourStroke, Cycle::TwoStroke] {
        pages.push(report::firing_catalogue_page(&engines, cycle));
        pages.push(report::firing_catalogue_answer(&engines, cycle));
        for (_, engine) in &engines {
            let Ok(engine) = report::run_in_cycle(engine, cycle) else { continue };
            // A single cylinder is deflected too.
            let from = usize::from(engine.cylinders().len() == 1);
            let shape = (from..from + engine.cylinders().len()).map(|value| BigRational::from_integer(value.into()));
            let shape = shape.collect();
            for weights in [Weights::Rigid, Weights::ModeShape(shape)] {
                let study = FiringStudy::new(&engine, &[], weights).expect("stars");
                pages.extend([report::firing_page(&study), report::firing_answer(&study)]);
            }
        }
    }
    pages
}

#[test]
fn the_pages_have_german_for_every_phrase() {
    let pages = pages();
    let phrases = pages.iter().flat_map(phrases);
    let has_words = |words: &str| words.chars().filter(|letter| letter.is_alphabetic()).count() > 1;
    let missing: BTreeSet<&str> = phrases.filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

#[test]
fn no_text_of_firing_stars_lies_on_another() {
    for page in pages() {
        for picture in page.pictures() {
            assert!(picture.figure.overlaps().is_empty(), "{:?}", picture.figure.overlaps());
        }
    }
}
