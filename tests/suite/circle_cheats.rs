//! Is every way to cheat with the arcs of a circle, or with an identity modulo a prime, caught, by both checkers?

use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::proof::{ArcClaim, CircleClaim, CoprimeClaim, OpenDocument, WhenClaim, check_open_document};
use crankstar::report;
use num_rational::BigRational;

use crate::support::second;
use crate::support::written::fraction;

/// The force of order 1, reverse, is `5 + e^{2iφ} + e^{4iφ}`: never 0.
const NEVER: &str = "
    cylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 5 }, { throw = 0, bank = 'phi', position = 0 },
                { throw = 0, bank = '2phi', position = 1 }]";
/// It is `2 cos 2φ + 4 cos φ`: 0 where cos φ = (√3 − 1)/2.
const IRRATIONAL: &str = "
    cylinder = [{ throw = 0, bank = '-phi', position = 0 }, { throw = 0, bank = '-phi/2', position = 0, reciprocating_mass = 2 },
                { throw = 0, bank = 'phi/2', position = 1, reciprocating_mass = 2 }, { throw = 0, bank = 'phi', position = 3 }]";
/// It is `2 cos 2φ + 2 cos φ`: 0 at 60°, 180° and 300°.
const RATIONAL: &str = "
    cylinder = [{ throw = 0, bank = '-phi', position = 0 }, { throw = 0, bank = '-phi/2', position = 0 },
                { throw = 0, bank = 'phi/2', position = 1 }, { throw = 0, bank = 'phi', position = 3 }]";

const REVERSE: usize = 1;

fn document(text: &str) -> OpenDocument {
    let Ok(Layout::Open(family)) = file::parse_layout("test", text) else { panic!("not a family: {text}") };
    report::open_document(&family, &family::classify(&family, &[1]).expect("orders"))
}

/// The reason for which a changed document is refused.
fn refused(text: &str, change: impl FnOnce(&mut WhenClaim)) -> String {
    let mut document = document(text);
    check_open_document(&document).expect("it holds");
    second::accepts(&[&document], &["nothing is claimed"]);
    change(&mut document.open_verdicts[REVERSE].sums[0].when);
    let reason = check_open_document(&document).expect_err("a forged document").reason.to_string();
    second::refuses(&[(reason.as_str(), &document)]);
    reason
}

fn coprime(change: impl FnOnce(&mut CoprimeClaim)) -> String {
    refused(NEVER, |when| match when {
        WhenClaim::Coprime(claim) => change(claim),
        other => panic!("{other:?}"),
    })
}

fn circle(text: &str, change: impl FnOnce(&mut CircleClaim)) -> String {
    refused(text, |when| match when {
        WhenClaim::Circle(claim) => change(claim),
        other => panic!("{other:?}"),
    })
}

fn has(reason: &str, words: &str) {
    assert!(reason.contains(words), "{reason}");
}

#[test]
fn an_identity_that_is_not_one_is_refused() {
    has(&coprime(|claim| claim.u[0] = (claim.u[0] + 1) % claim.prime), "is not 1 modulo the prime");
    has(&coprime(|claim| claim.v.truncate(claim.v.len() - 1)), "is not 1 modulo the prime");
    has(&coprime(|claim| std::mem::swap(&mut claim.u, &mut claim.v)), "is not 1 modulo the prime");
    has(&coprime(|claim| claim.u[0] += claim.prime), "not below the prime");
    has(&coprime(|claim| claim.v.extend([0; 9])), "more coefficients than the sum");
    has(&coprime(|claim| (claim.u, claim.v) = (vec![1], Vec::new())), "is not 1 modulo the prime");
}

#[test]
fn an_identity_modulo_no_prime_or_with_a_wrong_root_is_refused() {
    has(&coprime(|claim| claim.prime += 1), "is not prime");
    has(&coprime(|claim| claim.prime = 1), "is not prime");
    has(&coprime(|claim| claim.conductor = 0), "the conductor is between");
    has(&coprime(|claim| claim.conductor *= 4), "does not have the order");
    has(&coprime(|claim| claim.root += 1), "does not have the order");
    has(&coprime(|claim| claim.root += claim.prime), "does not have the order");
    has(&coprime(|claim| claim.scale = 0.into()), "do not make every angle and every weight whole");
    has(&coprime(|claim| claim.scale *= claim.prime), "the leading coefficient is 0 modulo the prime");
}

#[test]
fn an_identity_about_another_unknown_is_refused() {
    has(&coprime(|claim| claim.phi = fraction(1, 1)), "without a common divisor");
    has(&coprime(|claim| claim.phi = fraction(4, 1)), "not turned by a whole multiple");
    has(&coprime(|claim| claim.phi = fraction(-2, 1)), "a positive number of times");
    has(&coprime(|claim| claim.delta = fraction(1, 1)), "not turned by a whole multiple");
}

#[test]
fn an_identity_for_a_sum_with_zeros_is_refused() {
    let WhenClaim::Coprime(claim) = document(NEVER).open_verdicts[REVERSE].sums[0].when.clone() else { panic!() };
    let reason = refused(RATIONAL, |when| {
        *when = WhenClaim::Coprime(Box::new(CoprimeClaim { phi: fraction(1, 1), ..*claim }));
    });
    has(&reason, "is not 1 modulo the prime");
}

#[test]
fn arcs_that_do_not_make_the_circle_are_refused() {
    has(&circle(IRRATIONAL, |claim| drop(claim.arcs.pop())), "the arcs do not make one turn");
    has(&circle(IRRATIONAL, |claim| claim.arcs.clear()), "no arc rests on the mirror image");
    let cleared = circle(IRRATIONAL, |claim| {
        claim.arcs.clear();
        claim.mirrored.clear();
    });
    has(&cleared, "the arcs do not make one turn");
    has(&circle(IRRATIONAL, |claim| claim.arcs.push(claim.arcs[0].clone())), "does not end behind its beginning");
    let twice = circle(IRRATIONAL, |claim| claim.arcs.push(ArcClaim::Free { to: &claim.from + fraction(2, 1) }));
    assert!(twice.contains("no line keeps it away") || twice.contains("one turn"), "{twice}");
    let moved = circle(IRRATIONAL, |claim| claim.from -= fraction(1, 64));
    assert!(moved.contains("one turn") || moved.contains("no line"), "{moved}");
}

#[test]
fn enclosures_of_too_few_or_too_many_bits_are_refused() {
    for bits in [0, 31, 513, u32::MAX] {
        assert_eq!(circle(RATIONAL, |claim| claim.bits = bits), "an enclosure has 32 to 512 bits");
    }
}

/// The place of the first arc of a kind.
fn place(claim: &CircleClaim, of: fn(&ArcClaim) -> bool) -> usize {
    claim.arcs.iter().position(of).expect("such an arc")
}

const IS_FREE: fn(&ArcClaim) -> bool = |arc| matches!(arc, ArcClaim::Free { .. });
const IS_CROSSING: fn(&ArcClaim) -> bool = |arc| matches!(arc, ArcClaim::Crossing { .. });
const IS_RATIONAL: fn(&ArcClaim) -> bool = |arc| matches!(arc, ArcClaim::Rational { .. });

#[test]
fn a_zero_that_is_left_out_is_refused() {
    let with = |text: &str, is: fn(&ArcClaim) -> bool, new: fn(BigRational) -> ArcClaim| {
        circle(text, |claim| {
            let at = place(claim, is);
            claim.arcs[at] = new(claim.arcs[at].to().clone());
            if !claim.arcs.iter().any(|arc| matches!(arc, ArcClaim::Monotone { .. }) || IS_CROSSING(arc)) {
                claim.mirrored.clear();
            }
        })
    };
    has(&with(IRRATIONAL, IS_CROSSING, |to| ArcClaim::Free { to }), "no line keeps it away from 0");
    has(&with(IRRATIONAL, IS_CROSSING, |to| ArcClaim::Monotone { to }), "the ends are on both sides of 0");
    has(&with(RATIONAL, IS_RATIONAL, |to| ArcClaim::Free { to }), "no line keeps it away from 0");
    let whole = circle(RATIONAL, |claim| {
        claim.mirrored.clear();
        claim.arcs = vec![ArcClaim::Free { to: &claim.from + fraction(1, 1) }];
    });
    has(&whole, "no line keeps it away from 0");
}

#[test]
fn a_zero_that_is_none_is_refused() {
    let crossing = circle(IRRATIONAL, |claim| {
        let at = place(claim, IS_FREE);
        claim.arcs[at] = ArcClaim::Crossing { to: claim.arcs[at].to().clone() };
    });
    assert!(crossing.contains("no line") || crossing.contains("one side of 0"), "{crossing}");
    let rational = circle(RATIONAL, |claim| {
        let at = place(claim, IS_RATIONAL);
        let ArcClaim::Rational { at, .. } = &mut claim.arcs[at] else { panic!() };
        *at += fraction(1, 1000);
    });
    has(&rational, "collect to");
    let elsewhere = circle(RATIONAL, |claim| {
        let at = place(claim, IS_RATIONAL);
        let ArcClaim::Rational { at, .. } = &mut claim.arcs[at] else { panic!() };
        *at += fraction(1, 1);
    });
    has(&elsewhere, "its zero is not on it");
}

#[test]
fn a_rational_zero_without_evidence_or_with_too_much_is_refused() {
    let with = |change: fn(&mut Vec<_>)| {
        circle(RATIONAL, |claim| {
            let at = place(claim, IS_RATIONAL);
            let ArcClaim::Rational { certificates, .. } = &mut claim.arcs[at] else { panic!() };
            change(certificates);
        })
    };
    has(&with(Vec::clear), "0 certificates for a zero of 4 parts");
    has(&with(|certificates| certificates.extend([certificates[0].clone()])), "collect to");
    has(&with(|certificates| certificates.resize(4, certificates[0].clone())), "4 certificates for a zero of 4 parts");
}

#[test]
fn a_crossing_that_may_be_a_rational_zero_is_refused() {
    // The zero at 60° of the other sum, told as an irrational one.
    let reason = circle(RATIONAL, |claim| {
        let at = place(claim, IS_RATIONAL);
        claim.arcs[at] = ArcClaim::Crossing { to: claim.arcs[at].to().clone() };
        let WhenClaim::Circle(other) = document(IRRATIONAL).open_verdicts[REVERSE].sums[0].when.clone() else {
            panic!()
        };
        claim.mirrored = other.mirrored;
    });
    has(&reason, "a rational turn in it may be the zero");
}

#[test]
fn arcs_on_a_line_need_the_evidence_that_there_is_one() {
    has(&circle(IRRATIONAL, |claim| claim.mirrored.clear()), "0 certificates for");
    has(&circle(IRRATIONAL, |claim| drop(claim.mirrored.pop())), "certificates for");
    let idle = circle(IRRATIONAL, |claim| claim.arcs = vec![ArcClaim::Open { to: &claim.from + fraction(1, 1) }]);
    has(&idle, "so that no evidence for it belongs here");
    // Of 5 + x + x² there is none.
    let other = refused(NEVER, |when| {
        let WhenClaim::Circle(mut claim) = document(IRRATIONAL).open_verdicts[REVERSE].sums[0].when.clone() else {
            panic!()
        };
        claim.phi = fraction(2, 1);
        *when = WhenClaim::Circle(claim);
    });
    assert!(other.contains("collect to") || other.contains("certificates for"), "{other}");
}

#[test]
fn arcs_about_another_unknown_are_refused() {
    has(&circle(IRRATIONAL, |claim| claim.phi = fraction(1, 2)), "without a common divisor");
    has(&circle(IRRATIONAL, |claim| claim.phi = fraction(-1, 1)), "a positive number of times");
    has(&circle(IRRATIONAL, |claim| claim.delta = fraction(3, 1)), "not turned by a whole multiple");
    let WhenClaim::Circle(claim) = document(IRRATIONAL).open_verdicts[REVERSE].sums[0].when.clone() else { panic!() };
    let reason = refused(NEVER, |when| *when = WhenClaim::Circle(claim));
    assert!(reason.contains("whole multiple") || reason.contains("common divisor"), "{reason}");
}

#[test]
fn an_arc_that_is_left_open_holds_and_is_told() {
    let mut document = document(IRRATIONAL);
    let WhenClaim::Circle(claim) = &mut document.open_verdicts[REVERSE].sums[0].when else { panic!() };
    claim.mirrored.clear();
    claim.arcs = vec![ArcClaim::Open { to: &claim.from + fraction(1, 1) }];
    let checked = check_open_document(&document).expect("nothing is claimed");
    assert!(checked.not_covered.iter().any(|words| words.contains("`open`")), "{:?}", checked.not_covered);
    second::accepts(&[&document], &["when a sum vanishes"]);
}
