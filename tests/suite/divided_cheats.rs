//! Is every way to cheat caught where a sum is divided by what has no zero on the circle, by both checkers?

use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::proof::{
    ArcClaim, Certificate, CircleClaim, DividedClaim, OpenDocument, Vector, WhenClaim, check_open_document,
};
use crankstar::report;

use crate::support::second;
use crate::support::written::fraction;

/// The force of order 1, reverse, is (x² − x/2 + 1)(x + 2) with x = e^{iφ}: 0 where cos φ = 1/4.
const DIVIDED: &str = "
    cylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
                { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 1 }]";
/// It is (x² − x/2 + 1)² = x⁴ − x³ + 9/4 x² − x + 1.
const SQUARE: &str = "
    cylinder = [{ throw = 0, bank = 0, position = 0 }, { throw = 180, bank = 'phi/2', position = 0 },
                { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '9/4' },
                { throw = 180, bank = '3/2 phi', position = 0 }, { throw = 0, bank = '2 phi', position = 1 }]";

const REVERSE: usize = 1;

fn document(text: &str) -> OpenDocument {
    let Ok(Layout::Open(family)) = file::parse_layout("test", text) else { panic!("not a family: {text}") };
    report::open_document(&family, &family::classify(&family, &[1]).expect("orders"))
}

fn circle_of(document: &mut OpenDocument) -> &mut CircleClaim {
    let WhenClaim::Circle(claim) = &mut document.open_verdicts[REVERSE].sums[0].when else { panic!("no circle") };
    claim
}

fn of_circle(text: &str, change: impl FnOnce(&mut CircleClaim)) -> String {
    let mut document = document(text);
    check_open_document(&document).expect("it holds");
    second::accepts(&[&document], &["when a sum vanishes", "open"]);
    change(circle_of(&mut document));
    let reason = check_open_document(&document).expect_err("a forged document").reason.to_string();
    second::refuses(&[(reason.as_str(), &document)]);
    reason
}

fn refused(text: &str, change: impl FnOnce(&mut DividedClaim)) -> String {
    of_circle(text, |circle| change(circle.divided.as_mut().expect("divided")))
}

fn number(numerator: i64, denominator: i64) -> Vec<Vector> {
    vec![Vector { angle: fraction(0, 1), weight: fraction(numerator, denominator) }]
}

fn has(reason: &str, words: &str) {
    assert!(reason.contains(words), "{reason}");
}

#[test]
fn a_square_of_an_irrational_zero_is_the_second_power() {
    let mut document = document(SQUARE);
    let divided = circle_of(&mut document).divided.clone().expect("divided");
    assert_eq!(divided.powers.iter().map(Vec::len).collect::<Vec<_>>(), [1, 3]);
    assert_eq!((divided.without, divided.equalities.len()), (vec![number(1, 1)], 5));
    second::accepts(&[&document], &["when a sum vanishes", "open"]);
}

#[test]
fn a_factor_with_zeros_is_not_told_as_one_without() {
    // All of the sum is said to have no zeros but x + 2, whose arcs are free.
    let hidden = refused(DIVIDED, |claim| {
        claim.without.clone_from(&claim.powers[0]);
        claim.powers = vec![vec![number(2, 1), number(1, 1)]];
        claim.coprime.scale = 2.into();
    });
    has(&hidden, "is not 1 modulo the prime");
    let twice = refused(DIVIDED, |claim| claim.powers[0][1] = number(-3, 2));
    has(&twice, "of the product");
}

#[test]
fn a_product_that_is_not_the_sum_is_refused() {
    has(&refused(DIVIDED, |claim| claim.without[0] = number(3, 1)), "modulo the prime");
    has(&refused(DIVIDED, |claim| claim.powers[0][0] = number(2, 1)), "coefficient 0 of the product");
    has(&refused(DIVIDED, |claim| claim.powers[0][1] = Vec::new()), "coefficient 1 of the product");
    has(&refused(DIVIDED, |claim| drop(claim.equalities.pop())), "3 certificates for 4 coefficients");
    has(&refused(DIVIDED, |claim| claim.equalities.clear()), "0 certificates for 4 coefficients");
    let residue = refused(DIVIDED, |claim| claim.equalities[0] = Certificate::Splitting { steps: Vec::new() });
    has(&residue, "coefficient 0 of the product");
    let polygons = refused(DIVIDED, |claim| {
        let corner = crankstar::proof::Polygon { sides: 2, rotation: fraction(0, 1), weight: fraction(1, 1) };
        claim.equalities[0] = Certificate::Polygons { polygons: vec![corner] };
    });
    has(&polygons, "coefficient 0 of the product");
}

#[test]
fn factors_of_another_degree_are_refused() {
    has(&refused(DIVIDED, |claim| claim.powers.clear()), "the last factor has a degree");
    has(&refused(DIVIDED, |claim| claim.powers.push(vec![number(1, 1)])), "the last factor has a degree");
    has(&refused(DIVIDED, |claim| claim.powers.insert(0, vec![number(1, 1)])), "do not have the degree of the sum");
    has(&refused(SQUARE, |claim| drop(claim.powers.remove(0))), "do not have the degree of the sum");
    has(&refused(DIVIDED, |claim| drop(claim.without.pop())), "do not have the degree of the sum");
    has(&refused(DIVIDED, |claim| claim.without.clear()), "do not have the degree of the sum");
    has(&refused(DIVIDED, |claim| claim.powers[0].insert(0, Vec::new())), "do not have the degree of the sum");
}

#[test]
fn a_factor_that_does_not_begin_with_1_or_is_not_collected_is_refused() {
    has(&refused(DIVIDED, |claim| claim.powers[0][2] = number(2, 1)), "the leading coefficient of a factor is not 1");
    has(&refused(DIVIDED, |claim| claim.powers[0][2].clear()), "the leading coefficient of a factor is not 1");
    has(&refused(DIVIDED, |claim| claim.powers[0].clear()), "the leading coefficient of a factor is not 1");
    let split = check_open_document(&{
        let mut document = document(DIVIDED);
        let claim = circle_of(&mut document).divided.as_mut().expect("divided");
        claim.powers[0][0] = [number(1, 2), number(1, 2)].concat();
        document
    });
    has(&split.expect_err("terms apart").reason.to_string(), "not collected");
}

#[test]
fn an_identity_of_another_factor_or_unknown_is_refused() {
    has(&refused(DIVIDED, |claim| claim.coprime.phi = fraction(2, 1)), "not one in the same unknown");
    has(&refused(DIVIDED, |claim| claim.coprime.delta = fraction(1, 1)), "not one in the same unknown");
    has(&refused(DIVIDED, |claim| claim.coprime.u.clear()), "is not 1 modulo the prime");
    has(&refused(DIVIDED, |claim| claim.coprime.prime += 1), "is not prime");
    has(&refused(DIVIDED, |claim| claim.coprime.root += 1), "does not have the order");
    has(&refused(SQUARE, |claim| claim.coprime.v[0] += 1), "is not 1 modulo the prime");
}

#[test]
fn arcs_of_the_factor_do_not_hold_for_the_sum_nor_those_of_another_factor() {
    let of_sum = of_circle(DIVIDED, |circle| circle.divided = None);
    assert!(of_sum.contains("collect to") || of_sum.contains("mirror image"), "{of_sum}");
    let missing = of_circle(SQUARE, |circle| {
        let crossing = |arc: &ArcClaim| matches!(arc, ArcClaim::Crossing { .. });
        let at = circle.arcs.iter().position(crossing).expect("a crossing");
        circle.arcs[at] = ArcClaim::Monotone { to: circle.arcs[at].to().clone() };
    });
    has(&missing, "the ends are on both sides of 0");
}
