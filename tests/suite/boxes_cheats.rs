//! Is every way to cheat the checker with the boxes of a torus caught?

use crankstar::proof::{BoxesClaim, Certificate, OpenDocument, WhenClaim, check_open_document, read_document};
use num_rational::BigRational;

use crate::plane_cheats::{Cheat, forged, half, tried};
use crate::support::second;
use crate::support::two_angles::torus_documents;

fn small() -> BigRational {
    BigRational::new(1.into(), 16.into())
}

/// Where some letter is replaced by another.
fn letters(claim: &mut BoxesClaim, from: char, to: &str) -> bool {
    let changed = claim.tree.replace(from, to);
    std::mem::replace(&mut claim.tree, changed.clone()) != changed
}

const CHEATS: [Cheat<BoxesClaim>; 24] = [
    ("another s", |claim| {
        claim.phi += half();
        true
    }),
    ("another t", |claim| {
        claim.delta += half();
        true
    }),
    ("s over half of the torus", |claim| {
        claim.phi *= half();
        true
    }),
    ("s taken backwards", |claim| {
        claim.phi = -&claim.phi;
        true
    }),
    ("t not taken", |claim| {
        claim.delta -= claim.delta.clone();
        true
    }),
    ("the box of a zero as free", |claim| letters(claim, '1', "0")),
    ("a free box as that of a zero", |claim| letters(claim, '0', "1")),
    ("an open box as free", |claim| letters(claim, '?', "0")),
    ("the torus as one free box", |claim| {
        claim.tree = "0".to_owned();
        claim.zeros.clear();
        true
    }),
    ("s for t", |claim| letters(claim, 's', "t")),
    ("a letter too few", |claim| claim.tree.pop().is_some()),
    ("a letter too many", |claim| {
        claim.tree.push('?');
        true
    }),
    ("not a letter", |claim| {
        claim.tree.clear();
        true
    }),
    ("another letter", |claim| letters(claim, '0', "2")),
    ("boxes without end", |claim| {
        claim.tree = format!("{}{}", "s".repeat(60), "?".repeat(61));
        true
    }),
    ("a zero that is omitted", |claim| claim.zeros.pop().is_some()),
    ("a zero twice", |claim| {
        claim.zeros.extend(claim.zeros.first().cloned());
        !claim.zeros.is_empty()
    }),
    ("a zero elsewhere", |claim| claim.zeros.first_mut().map(|zero| zero.s += small()).is_some()),
    ("a zero a turn on", |claim| claim.zeros.first_mut().map(|zero| zero.t += half() + half()).is_some()),
    ("a box that is too wide", |claim| claim.zeros.first_mut().map(|zero| zero.reach = half() * half()).is_some()),
    ("a box around the torus", |claim| claim.zeros.first_mut().map(|zero| zero.reach = half()).is_some()),
    ("a box without width", |claim| claim.zeros.first_mut().map(|zero| zero.reach -= zero.reach.clone()).is_some()),
    ("a middle that is not a zero as one", |claim| {
        let zero = claim.zeros.iter_mut().find(|zero| zero.certificate.is_none());
        zero.map(|zero| zero.certificate = Some(Certificate::Polygons { polygons: Vec::new() })).is_some()
    }),
    ("forged evidence of a zero", |claim| {
        let certificate = claim.zeros.iter_mut().find_map(|zero| zero.certificate.as_mut());
        certificate.map(|certificate| *certificate = forged(certificate)).is_some()
    }),
];

fn is_boxes(when: &WhenClaim) -> bool {
    matches!(when, WhenClaim::Boxes(_))
}

#[test]
fn every_cheat_with_boxes_is_caught() {
    let documents = torus_documents();
    for document in &documents {
        let json = serde_json::to_string(document).expect("JSON");
        let read: OpenDocument = serde_json::from_str(&json).expect("it reads");
        assert_eq!(&read, document);
        check_open_document(&read).expect("it holds");
    }
    second::accepts(&documents, &[]);
    for (name, cheat) in CHEATS {
        let change = |when: &mut WhenClaim| match when {
            WhenClaim::Boxes(claim) => cheat(claim),
            _ => false,
        };
        // Only the first has open boxes, of which there are many, and exact zeros.
        let (open, whole) = documents.split_at(1);
        let fitting = if ["an open box as free", "forged evidence of a zero"].contains(&name) { open } else { whole };
        assert!(tried(fitting, name, is_boxes, change) > 0, "never tried: {name}");
    }
    for other in [WhenClaim::Always, WhenClaim::Never] {
        let change = |when: &mut WhenClaim| {
            *when = other.clone();
            true
        };
        assert!(tried(&documents[1..], "another kind", is_boxes, change) > 0);
    }
}

#[test]
fn boxes_of_parts_in_one_unknown_are_not_accepted() {
    let documents = torus_documents();
    let boxes = documents.iter().flat_map(|document| &document.open_verdicts).flat_map(|verdict| &verdict.sums);
    let boxes = boxes.map(|sum| sum.when.clone()).find(is_boxes).expect("boxes");
    let text = "[[cylinder]]\nthrow = 'phi'\nbank = 0\nposition = 0\n[[cylinder]]\nthrow = '2phi'\nbank = 0\nposition = 0\n\
                [[cylinder]]\nthrow = '5phi'\nbank = 0\nposition = 0\n[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\n";
    let family = crate::support::two_angles::family(text);
    let orders = crankstar::family::classify(&family, &[1]).expect("orders");
    let mut document = crankstar::report::open_document(&family, &orders);
    document.open_verdicts[0].sums[0].when = boxes;
    let bytes = serde_json::to_vec(&document).expect("JSON");
    assert!(read_document(&bytes).expect("it reads").check().is_err());
}

#[test]
fn a_document_with_open_boxes_is_accepted_and_said_not_to_be_solved() {
    let documents = torus_documents();
    let is_open = |when: &WhenClaim| matches!(when, WhenClaim::Boxes(claim) if claim.tree.contains('?'));
    let with = |is_meant: &dyn Fn(&WhenClaim) -> bool| {
        let has = |document: &&OpenDocument| {
            document.open_verdicts.iter().flat_map(|verdict| &verdict.sums).any(|sum| is_meant(&sum.when))
        };
        documents.iter().find(has).expect("such a document").clone()
    };
    let said = |document: &OpenDocument| {
        let checked = check_open_document(document).expect("it holds");
        checked.not_covered.iter().any(|words| words.contains("boxes that are `open`"))
    };
    assert!(said(&with(&is_open)) && !said(&with(&|when| is_boxes(when) && !is_open(when))));
}
