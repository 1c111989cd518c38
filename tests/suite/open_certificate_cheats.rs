//! Is every way to cheat the checker of a family's document caught?

use crankstar::family;
use crankstar::layout::{self, Engine};
use crankstar::proof::{Exact, OpenDocument, WhenClaim, check_open_document};
use crankstar::report;
use num_rational::BigRational;

const V_TWIN: &str = "vee = { bank_angle = 'phi', throws = [0] }";
const W: &str = "fan = { banks = ['-phi', 0, 'phi'], throws = [0], positions = ['a'], bank_offsets = ['b', 0, '-b'] }";
const UNEQUAL: &str = "
    cylinder = [{ throw = 0, bank = '-phi/2', position = 0 },
                { throw = 0, bank = 'phi/2', position = 1, reciprocating_mass = '3/2' }]";

fn document(text: &str) -> OpenDocument {
    let Ok(Engine::Open(family)) = layout::parse_engine("test", text) else { panic!("not a family: {text}") };
    report::open_document(&family, &family::classify(&family, &[1, 2, 4]))
}

/// The reason for which a changed document is refused.
fn refused(text: &str, change: impl FnOnce(&mut OpenDocument)) -> String {
    let mut document = document(text);
    assert!(check_open_document(&document).is_ok(), "{text}");
    change(&mut document);
    check_open_document(&document).expect_err("a forged document").reason
}

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// The force of order 1, reverse, of the V-twin: two parts that cancel where 2φ ≡ 180°.
const REVERSE: usize = 1;

#[test]
fn documents_of_families_hold_and_survive_json() {
    for text in [V_TWIN, W, UNEQUAL] {
        let document = document(text);
        let json = serde_json::to_string(&document).expect("JSON");
        let read: OpenDocument = serde_json::from_str(&json).expect("it reads");
        assert_eq!(read, document);
        assert!(check_open_document(&read).expect("it holds") > 10);
    }
}

#[test]
fn another_turn_is_refused() {
    let reason = refused(V_TWIN, |document| {
        let WhenClaim::Where { alternatives, .. } = &mut document.open_verdicts[REVERSE].sums[0].when else { panic!() };
        alternatives[0].conditions[0].turn = fraction(1, 3);
    });
    assert!(reason.contains("collect to"), "{reason}");
}

#[test]
fn a_condition_on_other_multiples_is_refused() {
    let reason = refused(V_TWIN, |document| {
        let WhenClaim::Where { alternatives, .. } = &mut document.open_verdicts[REVERSE].sums[0].when else { panic!() };
        alternatives[0].conditions[0].phi = fraction(4, 1);
    });
    assert_eq!(reason, "a condition is not about how its part is turned against the first");
}

#[test]
fn a_condition_too_few_or_an_alternative_too_many_is_refused() {
    let few = refused(V_TWIN, |document| {
        let WhenClaim::Where { alternatives, .. } = &mut document.open_verdicts[REVERSE].sums[0].when else { panic!() };
        alternatives[0].conditions.clear();
    });
    assert_eq!(few, "there is one condition a part after the first");
    let many = refused(V_TWIN, |document| {
        let WhenClaim::Where { alternatives, .. } = &mut document.open_verdicts[REVERSE].sums[0].when else { panic!() };
        alternatives.push(alternatives[0].clone());
    });
    assert_eq!(many, "two parts cancel at one turn, so there is one alternative");
}

#[test]
fn always_and_never_that_contradict_the_parts_are_refused() {
    for claim in [WhenClaim::Always, WhenClaim::Never, WhenClaim::NotSolved] {
        let reason = refused(V_TWIN, |document| document.open_verdicts[REVERSE].sums[0].when = claim);
        assert_eq!(reason, "2 parts do not vanish, which contradicts `when`");
    }
}

#[test]
fn equal_lengths_that_are_not_equal_are_refused() {
    let reason = refused(UNEQUAL, |document| {
        let sum = &mut document.open_verdicts[REVERSE].sums[0];
        let WhenClaim::UnequalLengths { certificate } = sum.when.clone() else { panic!() };
        sum.when = WhenClaim::EqualLengths { certificate };
    });
    assert!(reason.contains("contradict each other"), "{reason}");
}

#[test]
fn three_parts_need_both_orders_and_the_evidence_of_equal_lengths() {
    let find = |document: &mut OpenDocument, change: fn(&mut WhenClaim)| {
        let sums = document.open_verdicts.iter_mut().flat_map(|verdict| &mut verdict.sums);
        let claims = sums.map(|sum| &mut sum.when);
        let three =
            |when: &&mut WhenClaim| matches!(when, WhenClaim::Where { alternatives, .. } if alternatives.len() == 2);
        change(claims.into_iter().find(three).expect("three parts"));
    };
    let same = refused(W, |document| {
        find(document, |when| {
            let WhenClaim::Where { alternatives, .. } = when else { panic!() };
            alternatives[1] = alternatives[0].clone();
        });
    });
    assert_eq!(same, "the two alternatives are the same");
    let bare = refused(W, |document| {
        find(document, |when| {
            let WhenClaim::Where { equal_lengths, .. } = when else { panic!() };
            equal_lengths.pop();
        });
    });
    assert_eq!(bare, "three parts need two alternatives, and evidence that they are equally long");
}

#[test]
fn parts_that_are_not_those_of_the_cylinders_are_refused() {
    let other = "the parts are not those of the cylinders";
    assert_eq!(refused(V_TWIN, |document| drop(document.open_verdicts[0].sums.pop())), other);
    assert_eq!(refused(V_TWIN, |document| document.open_verdicts[REVERSE].order = 2), other);
    assert_eq!(
        refused(V_TWIN, |document| drop(document.cylinders[0].bank.insert("phi".into(), Exact(fraction(1, 3))))),
        other
    );
    assert_eq!(refused(W, |document| drop(document.reference_plane.insert("a".into(), Exact(fraction(9, 1))))), other);
}

#[test]
fn an_unknown_that_is_neither_phi_nor_delta_is_refused() {
    let reason =
        refused(V_TWIN, |document| drop(document.cylinders[0].throw.insert("psi".into(), Exact(fraction(1, 1)))));
    assert_eq!(reason, "an angle of cylinder 1 holds another unknown than phi and delta");
}

#[test]
fn a_part_listed_twice_and_an_empty_list_are_refused() {
    let twice = refused(V_TWIN, |document| {
        let again = document.open_verdicts[0].sums[0].clone();
        document.open_verdicts[0].sums.push(again);
    });
    assert_eq!(twice, "the same part is listed twice");
    assert!(refused(V_TWIN, |document| document.open_verdicts.clear()).contains("nothing to check"));
}
