//! Does every document that the program makes verify, whatever the engine is?

use crankstar::engine::Engine;
use crankstar::file::{self, Layout};
use crankstar::proof::{AnyDocument, Checked, read_document};
use crankstar::remedy::{Wish, remedy};
use crankstar::{family, report, verdict};

use crate::support::dice::Dice;
use crate::support::every_form;

/// Engines of each kind of document; more where `CRANKSTAR_DOCUMENTS` says so.
fn count() -> usize {
    std::env::var("CRANKSTAR_DOCUMENTS").ok().and_then(|number| number.parse().ok()).unwrap_or(300)
}

#[track_caller]
fn verified(document: &impl serde::Serialize, text: &str) -> (AnyDocument, Checked) {
    let json = serde_json::to_string(document).expect("JSON");
    let read = read_document(json.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}\n{json}"));
    let checked = read.check().unwrap_or_else(|fault| panic!("{fault}\n{text}\n{json}"));
    assert!(checked.counts.certificates() > 0, "{text}");
    (read, checked)
}

/// The engines that are read, of so many files; most are.
fn engines(seed: u64, mut file: impl FnMut(&mut Dice) -> String) -> Vec<(String, Layout)> {
    let mut dice = Dice::new(seed);
    let files = (0..count()).map(|_| file(&mut dice));
    let read: Vec<_> =
        files.filter_map(|text| Some((text.clone(), file::parse_layout("engine", &text).ok()?))).collect();
    assert!(read.len() > count() / 2, "{} of {} are read", read.len(), count());
    read
}

fn known(seed: u64) -> impl Iterator<Item = (String, Engine)> {
    engines(seed, every_form::known).into_iter().filter_map(|(text, engine)| match engine {
        Layout::Known(layout, _) => Some((text, *layout)),
        Layout::Open(_) => None,
    })
}

#[test]
fn every_document_of_verdicts_verifies_with_and_without_torque_and_every_order() {
    for (index, (text, layout)) in known(1).enumerate() {
        let torque = index % 2 == 0;
        let orders = [&[1, 2][..], &[1, 2, 3, 4, 6], &[5], &[2, 12]][index % 4];
        let every = if index % 5 == 0 { verdict::theorem(&layout).ok() } else { None };
        let balances = verdict::classify(&layout, orders, torque);
        let document = report::document(&layout, &balances, &report::quantities(torque), every.as_ref());
        let (read, checked) = verified(&document, &text);
        assert_eq!(checked.theorems, if every.is_some() { 4 } else { 0 });
        assert_eq!(read, AnyDocument::Classify(document));
    }
}

#[test]
fn every_document_of_a_family_verifies() {
    let mut families = 0;
    for (text, engine) in engines(2, every_form::open) {
        let Layout::Open(open) = engine else { continue };
        families += 1;
        verified(&report::open_document(&open, &family::classify(&open, &[1, 2, 3])), &text);
    }
    assert!(families > count() / 2, "{families}");
}

#[test]
fn every_document_of_a_remedy_verifies() {
    let mut remedies = 0;
    for (index, (text, layout)) in known(3).enumerate() {
        let orders = [vec![1], vec![1, 2], vec![3], vec![1, 2, 4]][index % 4].clone();
        let Ok(found) = remedy(&layout, &Wish { orders, ..Wish::default() }) else { continue };
        remedies += 1;
        verified(&report::remedy_document(&found), &text);
    }
    assert!(remedies > count() / 3, "{remedies}");
}
