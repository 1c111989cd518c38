//! Does every document that the program makes verify, whatever the engine is?

use crankstar::engine::Engine;
use crankstar::file::{self, Layout};
use crankstar::proof::{AnyDocument, Checked, Document, Vector, VerdictClaim, read_document};
use crankstar::remedy::{Request, remedy};
use crankstar::report::{self, Compared, Numbers};
use crankstar::text::Untrusted;
use crankstar::{family, order, verdict};

use crate::support::dice::Dice;
use crate::support::verdicts::{self, judged, theorem};
use crate::support::{every_form, whole_documents};

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

/// The engines that are read, of this many files; most are.
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
        let every = if index % 5 == 0 { theorem(&layout).ok() } else { None };
        let balances = judged(&layout, orders, torque);
        let document = verdicts::document(&layout, &balances, torque, every.as_ref());
        let (read, checked) = verified(&document, &text);
        assert_eq!(checked.theorems, if every.is_some() { 4 } else { 0 });
        assert_eq!(read, AnyDocument::Classify(document));
    }
}

const ALL_MASSES: [order::Masses; 4] =
    [order::Masses::All, order::Masses::Reciprocating, order::Masses::Rotating, order::Masses::Counterweights];

/// What the program says of all masses, and what a producer of the tests says that shares nothing with it.
#[test]
fn every_document_on_all_masses_verifies_and_is_that_of_another_producer() {
    let (mut several, mut turning) = (0, 0);
    for (index, (text, layout)) in known(4).enumerate() {
        let quantities = verdicts::quantities(index % 2 == 0);
        let orders = [&[1, 2][..], &[1, 2, 3, 4, 6], &[5], &[2, 12]][index % 4];
        let masses = ALL_MASSES[index / 4 % 4];
        let judged = verdict::classify(&layout, orders, masses, &quantities).expect("orders");
        let theorem = (index % 5 == 0).then(|| verdict::every_order(&layout, masses).ok()).flatten();
        let document = report::document(&layout, masses, &judged, &quantities, theorem.as_ref());
        let (_, checked) = verified(&document, &text);
        let mut other =
            Document { theorems: Vec::new(), recurrences: Vec::new(), all_orders: false, ..document.clone() };
        whole_documents::fill(&mut other);
        verified(&other, &text);
        let said = |document: &Document| -> Vec<(Vec<String>, Vec<Vector>, bool)> {
            let of = |verdict: &VerdictClaim| (verdict.of.clone(), verdict.terms.clone(), verdict.vanishes);
            document.verdicts.iter().map(of).collect()
        };
        assert_eq!(said(&document), said(&other), "{text}");
        let outcomes = |document: &Document| document.wholes.iter().map(|one| one.outcome).collect::<Vec<_>>();
        assert_eq!(outcomes(&document), outcomes(&other), "{text}");
        several += checked.wholes;
        turning += usize::from(!document.turning_masses.is_empty());
    }
    assert!(several > count() / 2 && turning > count() / 8, "{several} wholes, {turning} with rotating masses");
}

/// Newtons carry the verdicts that their zeros are.
#[test]
fn every_document_of_loads_and_of_a_comparison_verifies() {
    let mut loads = 0;
    let known: Vec<(String, Engine)> = known(5).take(count() / 3).collect();
    for (text, layout) in &known {
        let Ok(numbers) = Numbers::new(layout, &[1, 2, 3, 4], None) else { continue };
        loads += 1;
        verified(&report::loads_document(layout, &numbers, None), text);
    }
    assert!(loads > count() / 12, "{loads}");
    for pair in known.chunks_exact(2) {
        let compared: Vec<Compared> = pair
            .iter()
            .map(|(_, layout)| Compared::new(Untrusted::new("engine"), layout, &[1, 2, 3]).expect("orders"))
            .collect();
        verified(&report::compare_document(&compared), &pair[0].0);
    }
}

#[test]
fn every_document_of_a_family_verifies() {
    let mut families = 0;
    for (text, engine) in engines(2, every_form::open) {
        let Layout::Open(open) = engine else { continue };
        families += 1;
        verified(&report::open_document(&open, &family::classify(&open, &[1, 2, 3]).expect("orders")), &text);
    }
    assert!(families > count() / 2, "{families}");
}

#[test]
fn every_document_of_a_remedy_verifies() {
    let mut remedies = 0;
    for (index, (text, layout)) in known(3).enumerate() {
        let orders = [vec![1], vec![1, 2], vec![3], vec![1, 2, 4]][index % 4].clone();
        let Ok(found) = remedy(&layout, &Request { orders, ..Request::default() }) else { continue };
        remedies += 1;
        verified(&report::remedy_document(&found), &text);
    }
    assert!(remedies > count() / 3, "{remedies}");
}
