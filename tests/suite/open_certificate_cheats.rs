//! Is every way to cheat the checker of a family's document caught?

use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::proof::{Exact, OpenDocument, Quantity, WhenClaim, check_open_document};
use crankstar::report;

use crate::support::written::fraction;

const V_TWIN: &str = "vee = { bank_angle = 'phi', throws = [0] }";
const W: &str = "fan = { banks = ['-phi', 0, 'phi'], throws = [0], positions = ['a'], bank_offsets = ['b', 0, '-b'] }";
const UNEQUAL: &str = "
    cylinder = [{ throw = 0, bank = '-phi/2', position = 0 },
                { throw = 0, bank = 'phi/2', position = 1, reciprocating_mass = '3/2' }]";

/// Two V-twins on pins in phase, and a single cylinder: reverse of order 1, `4 cos φ − 1`.
const V5: &str = "
    cylinder = [{ throw = 0, bank = '-phi/2', position = 1 }, { throw = 0, bank = 'phi/2', position = 1 },
                { throw = '180 - phi', bank = '-phi/2', position = 0 },
                { throw = 0, bank = '-phi/2', position = -1 }, { throw = 0, bank = 'phi/2', position = -1 }]";

fn document(text: &str) -> OpenDocument {
    let Ok(Layout::Open(family)) = file::parse_layout("test", text) else { panic!("not a family: {text}") };
    report::open_document(&family, &family::classify(&family, &[1, 2, 4]).expect("orders"))
}

/// The reason for which a changed document is refused.
fn refused(text: &str, change: impl FnOnce(&mut OpenDocument)) -> String {
    let mut document = document(text);
    assert!(check_open_document(&document).is_ok(), "{text}");
    change(&mut document);
    check_open_document(&document).expect_err("a forged document").reason.to_string()
}

/// The force of order 1, reverse, of the V-twin: two parts that cancel where 2φ ≡ 180°.
const REVERSE: usize = 1;

#[test]
fn documents_of_families_hold_and_survive_json() {
    for text in [V_TWIN, W, UNEQUAL, V5] {
        let document = document(text);
        let json = serde_json::to_string(&document).expect("JSON");
        let read: OpenDocument = serde_json::from_str(&json).expect("it reads");
        assert_eq!(read, document);
        assert!(check_open_document(&read).expect("it holds").counts.certificates() > 10);
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
    assert_eq!(refused(V_TWIN, |document| drop(document.open_verdicts[0].sums.pop())), "0 sums for 1 lengths");
    assert_eq!(
        refused(V_TWIN, |document| drop(document.cylinders[0].bank.insert("phi".into(), Exact(fraction(1, 3))))),
        other
    );
    let plane = refused(W, |document| drop(document.reference_plane.insert("a".into(), Exact(fraction(9, 1)))));
    assert!(plane.contains("lengths") || plane == other, "{plane}");
}

#[test]
fn a_sum_told_as_two_sums_of_one_length_is_refused() {
    // Each of the two would have one part, and never vanish.
    let reason = refused(V_TWIN, |document| {
        let sums = &mut document.open_verdicts[REVERSE].sums;
        let mut other = sums[0].clone();
        other.parts = vec![sums[0].parts.pop().expect("two parts")];
        (sums[0].when, other.when) = (WhenClaim::Never, WhenClaim::Never);
        sums.push(other);
    });
    assert_eq!(reason, "2 sums for 1 lengths");
}

#[test]
fn a_part_told_as_two_parts_is_refused() {
    let reason = refused(V_TWIN, |document| {
        let parts = &mut document.open_verdicts[0].sums[0].parts;
        parts.push(parts[0].clone());
    });
    assert!(reason.contains("parts in the sum of known lengths"), "{reason}");
}

#[test]
fn an_unknown_that_is_neither_phi_nor_delta_is_refused() {
    let reason =
        refused(V_TWIN, |document| drop(document.cylinders[0].throw.insert("psi".into(), Exact(fraction(1, 1)))));
    assert_eq!(reason, "an angle holds another unknown than phi and delta");
    let idle =
        refused(V_TWIN, |document| drop(document.cylinders[0].throw.insert("phi".into(), Exact(fraction(0, 1)))));
    assert_eq!(idle, "a symbol is taken 0 times");
}

#[test]
fn verdicts_that_are_missing_repeated_or_not_asked_for_are_refused() {
    assert_eq!(refused(V_TWIN, |document| document.open_verdicts.clear()), "this verdict is missing");
    let stands = "another verdict stands here";
    assert_eq!(refused(V_TWIN, |document| document.open_verdicts[REVERSE].order = 2), stands);
    assert_eq!(refused(V_TWIN, |document| document.open_verdicts[1] = document.open_verdicts[0].clone()), stands);
    let more = refused(V_TWIN, |document| document.open_verdicts.push(document.open_verdicts[0].clone()));
    assert_eq!(more, "there are more than were asked for");
    assert_eq!(refused(V_TWIN, |document| document.cylinders.clear()), "an engine has one at least");
}

#[test]
fn the_torque_of_a_family_is_not_checked_by_the_formula_of_the_force() {
    let renamed = refused(V_TWIN, |document| document.open_verdicts[0].quantity = Quantity::TORQUE);
    assert_eq!(renamed, "another verdict stands here");
    let asked = refused(V_TWIN, |document| document.quantities.push(Quantity::TORQUE));
    assert_eq!(asked, "this format knows force and moment, and not the torque of a family");
}

#[test]
fn evidence_that_is_not_needed_is_refused() {
    let reason = refused(V_TWIN, |document| {
        let WhenClaim::Where { alternatives, equal_lengths } = &mut document.open_verdicts[REVERSE].sums[0].when else {
            panic!()
        };
        equal_lengths.push(alternatives[0].certificate.clone());
    });
    assert_eq!(reason, "two parts that cancel are equally long, so that no evidence for it belongs here");
}

#[test]
fn a_cosine_that_its_parts_do_not_have_is_refused() {
    let with =
        |change: fn(&mut WhenClaim)| refused(V5, |document| change(&mut document.open_verdicts[REVERSE].sums[0].when));
    let other_value = with(|when| {
        let WhenClaim::Cosine(claim) = when else { panic!("{when:?}") };
        claim.cosine = fraction(1, 5);
    });
    assert!(other_value.contains("collect to"), "{other_value}");
    let turned = with(|when| {
        let WhenClaim::Cosine(claim) = when else { panic!("{when:?}") };
        claim.turn = fraction(1, 6);
    });
    assert!(turned.contains("collect to"), "{turned}");
    for value in [fraction(0, 1), fraction(1, 1), fraction(-7, 5)] {
        let reason = refused(V5, |document| {
            let when = &mut document.open_verdicts[REVERSE].sums[0].when;
            let WhenClaim::Cosine(claim) = when else { panic!("{when:?}") };
            claim.cosine = value;
        });
        assert_eq!(reason, "the cosine is not between -1 and 1, or is 0");
    }
    let doubled = with(|when| {
        let WhenClaim::Cosine(claim) = when else { panic!("{when:?}") };
        claim.phi = fraction(2, 1);
    });
    assert_eq!(doubled, "the parts do not turn against the middle one as the condition says");
    let middle = |index: usize| {
        refused(V5, |document| {
            let when = &mut document.open_verdicts[REVERSE].sums[0].when;
            let WhenClaim::Cosine(claim) = when else { panic!("{when:?}") };
            claim.middle = index;
        })
    };
    assert_eq!(middle(0), "the parts do not turn against the middle one as the condition says");
    assert_eq!(middle(3), "there are three parts, so that 0, 1 or 2 is the middle one");
}

#[test]
fn a_cosine_of_two_parts_is_refused() {
    let cosine = document(V5).open_verdicts[REVERSE].sums[0].when.clone();
    let reason = refused(V_TWIN, |document| document.open_verdicts[REVERSE].sums[0].when = cosine);
    assert_eq!(reason, "2 parts do not vanish, which contradicts `when`");
}
