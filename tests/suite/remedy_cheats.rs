//! Does the checker of remedies refuse what does not hold, whatever is changed?

use crankstar::file::parse;
use crankstar::proof::{
    Certificate, Format, Masses, RemedyDocument, RodStatement, Sense, Vector, check_remedy_document,
};
use crankstar::remedy::{Request, remedy};
use crankstar::report::remedy_document;

use crate::support::written::fraction;

const I3: &str = include_str!("../../reports/examples/thesis-i3/layout.toml");
const OFFSET: &str = include_str!("../../reports/examples/i6-offset/layout.toml");

fn document_of(text: &str, orders: &[u32]) -> RemedyDocument {
    let layout = parse("layout.toml", text).expect("a layout");
    let request = Request { orders: orders.to_vec(), ..Request::default() };
    let json = serde_json::to_string(&remedy_document(&remedy(&layout, &request).expect("a remedy"))).expect("JSON");
    serde_json::from_str(&json).expect("the document reads")
}

fn document() -> RemedyDocument {
    document_of(I3, &[1, 2])
}

#[track_caller]
fn assert_refused(cheat: impl Fn(&mut RemedyDocument), words: &str) {
    let mut cheated = document();
    cheat(&mut cheated);
    assert_ne!(cheated, document(), "nothing was changed");
    let fault = check_remedy_document(&cheated).expect_err("the cheat is seen").to_string();
    assert!(words.split('|').any(|words| fault.contains(words)), "{fault}");
}

#[test]
fn what_is_honest_holds() {
    let counted = |document: &RemedyDocument| {
        check_remedy_document(document).map(|checked| checked.counts.certificates()).map_err(|fault| fault.to_string())
    };
    assert_eq!(counted(&document()), Ok(8));
    let offset = document_of(OFFSET, &[1, 2, 3, 6]);
    assert!(counted(&offset).is_ok_and(|count| count > 12));
    let lone = "[inline]\nthrows = [0, 100]\n[mechanism]\nrod_ratio = 0.3\noffset_ratio = [0.1, -0.1]\nreciprocating_mass = [1, 2]";
    assert!(check_remedy_document(&document_of(lone, &[1, 2, 3])).is_ok());
}

#[test]
fn a_changed_engine_is_refused() {
    let words = "collect|not those of the engine|omitted|another sum";
    assert_refused(|d| d.cylinders[0].throw = fraction(1, 7), words);
    assert_refused(|d| d.cylinders[0].bank = fraction(1, 7), words);
    assert_refused(|d| d.cylinders[1].position = fraction(1, 7), words);
    assert_refused(|d| d.cylinders[2].weight = fraction(2, 1), words);
    assert_refused(|d| d.reference_plane = fraction(1, 1), words);
    assert_refused(|d| d.turning_masses[0].angle = fraction(1, 7), words);
    assert_refused(|d| d.turning_masses[0].mass_radius = fraction(0, 1), words);
    assert_refused(|d| d.turning_masses[0].sense = Sense::Reverse, words);
    assert_refused(|d| drop(d.turning_masses.pop()), words);
    assert_refused(|d| drop(d.cylinders.pop()), words);
    assert_refused(|d| d.cylinders[0].rod = RodStatement::Unknown, "all are, or none");
}

#[test]
fn a_changed_weight_is_refused() {
    let words = "collect|not those of the engine|omitted|another sum";
    assert_refused(|d| d.weights[0].position = fraction(1, 7), words);
    assert_refused(|d| d.weights[0].order = 3, "not asked for");
    assert_refused(|d| d.weights[0].sense = Sense::Reverse, words);
    assert_refused(|d| d.weights[0].parts[0].terms[0].weight += fraction(1, 1_000_000_000), "does not fit");
    assert_refused(|d| d.weights[0].parts[0].terms[0].angle += fraction(1, 1_000_000_007), "does not fit");
    assert_refused(|d| d.weights[0].parts[0].modulus *= 1.000_000_000_001, "`modulus` does not fit");
    assert_refused(|d| d.weights[0].parts[0].angle_deg += 1e-9, "`angle_deg` does not fit");
    assert_refused(|d| drop(d.weights.pop()), words);
}

#[test]
fn a_sum_that_is_left_out_or_stands_twice_is_refused() {
    assert_refused(|d| drop(d.sums.pop()), "omitted");
    assert_refused(|d| d.sums.clear(), "omitted");
    assert_refused(|d| d.orders.push(4), "omitted");
    assert_refused(|d| d.sums.push(d.sums[0].clone()), "more than the orders have");
    assert_refused(|d| d.sums.insert(1, d.sums[0].clone()), "another sum");
}

#[test]
fn a_remedy_without_an_engine_or_without_sums_proves_nothing() {
    assert_refused(
        |d| {
            d.cylinders.clear();
            d.turning_masses.clear();
            d.weights.clear();
            d.sums.clear();
        },
        "an engine has one at least",
    );
    assert_refused(|d| d.quantities.truncate(1), "both");
    assert_refused(|d| d.masses = Masses::Reciprocating, "all masses");
    assert_refused(|d| d.format = Format::Classify, "crankstar remedy 2");
}

#[test]
fn a_sum_that_is_not_zero_is_refused_whatever_its_evidence() {
    let nothing = || Certificate::Polygons { polygons: Vec::new() };
    // Both the weight and the sum are changed alike: the terms agree, but they are not zero.
    let bare = |d: &mut RemedyDocument| {
        d.weights.clear();
        let engine = document_of(&I3.replace("title", "# title"), &[1, 2]);
        for (sum, own) in d.sums.iter_mut().zip(&engine.sums) {
            sum.terms = own.terms.iter().take(own.terms.len()).cloned().collect();
            sum.certificate = nothing();
        }
    };
    let mut cheated = document();
    bare(&mut cheated);
    assert!(check_remedy_document(&cheated).is_err());
    assert_refused(|d| d.sums[0].certificate = nothing(), "sums[0]");
    let more = || Vector { angle: fraction(0, 1), weight: fraction(1, 1_000_000) };
    assert_refused(|d| d.sums[2].terms.push(more()), "sums[2]");
}

#[test]
fn an_engine_without_orders_claims_nothing() {
    let mut empty = document();
    empty.orders.clear();
    empty.sums.clear();
    assert!(check_remedy_document(&empty).is_err(), "there is nothing to check");
}
