//! Which ways to cheat does the checker see through?

use crate::support::second;
use crate::support::verdicts::{self, judged};
use crate::support::written::{ratio, sum, vectors};
use crankstar::exact::PhasorSum;
use crankstar::file;
use crankstar::numbers::evaluate;
use crankstar::proof::{
    Certificate, Document, Fault, Format, Masses, Polygon, Quantity, Refusal, Residue, RodClaim, RodStatement, Sense,
    Shape, ShapeEvidence, Step, VerdictClaim, check_certificate, check_document,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use proptest::collection::vec;
use proptest::prelude::*;

const TRIANGLE: &str = "1@0 1@1/3 1@2/3";
const TWO_AND_ONE: &str = "1@0 1/2@1/4";
const THREE_OVER_21: &str = "1@0 1@1/3 1@1/7";

fn whole(text: &str) -> BigInt {
    text.parse().expect("a whole number")
}

fn check(text: &str, certificate: &Certificate) -> Result<(), Refusal> {
    check_certificate(&vectors(&sum(text)), certificate.claims_zero(), certificate)
}

/// Polygons written as terms are: `"1@1/6"` with 3 sides.
fn polygons(list: &[(u64, &str)]) -> Certificate {
    let polygon = |(sides, text): &(u64, &str)| {
        let [vector] = &vectors(&sum(text))[..] else { panic!("one term a polygon") };
        Polygon { sides: *sides, rotation: vector.angle.clone(), weight: vector.weight.clone() }
    };
    Certificate::Polygons { polygons: list.iter().map(polygon).collect() }
}

/// 2 + 1 · 2 ≡ 4 (mod 5), where 2 has order 4: the proof for [`TWO_AND_ONE`], changed.
fn residue(change: impl FnOnce(&mut Residue)) -> Certificate {
    let [conductor, prime, root, scale, residue] = ["4", "5", "2", "2", "4"].map(whole);
    let mut claim = Residue { conductor, prime, root, scale, residue };
    change(&mut claim);
    Certificate::Residue(claim)
}

fn refused_residue(change: impl FnOnce(&mut Residue)) -> Refusal {
    check(TWO_AND_ONE, &residue(change)).expect_err("a cheat")
}

fn class(angle: &str, modulus: &str) -> Step {
    Step::Class { angle: ratio(angle), modulus: whole(modulus) }
}

fn compare(prime: u64, first: u64, second: u64) -> Step {
    Step::Compare { prime, first, second }
}

/// [`THREE_OVER_21`] keeps the class of 0 and 1/3 modulo 3; there the classes 0 and 2 differ.
fn splitting(steps: impl IntoIterator<Item = Step>) -> Result<(), Refusal> {
    check(THREE_OVER_21, &Certificate::Splitting { steps: steps.into_iter().collect() })
}

fn polygons_differ(angle: &str, terms: &str, polygons: &str) -> Result<(), Refusal> {
    Err(Refusal::PolygonsDiffer(Box::new([angle, terms, polygons].map(ratio))))
}

#[test]
fn the_honest_certificates_are_accepted() {
    assert_eq!(check(TRIANGLE, &polygons(&[(3, "1@0")])), Ok(()));
    assert_eq!(check(TWO_AND_ONE, &residue(|_| ())), Ok(()));
    assert_eq!(splitting([class("0", "3"), compare(3, 0, 2)]), Ok(()));
}

#[test]
fn a_certificate_of_the_other_kind_is_refused() {
    let wrong = |text: &str, vanishes: bool, certificate: Certificate| {
        check_certificate(&vectors(&sum(text)), vanishes, &certificate)
    };
    let steps = vec![class("0", "3"), compare(3, 0, 2)];
    assert_eq!(wrong(TRIANGLE, false, polygons(&[(3, "1@0")])), Err(Refusal::WrongKind));
    assert_eq!(wrong(TWO_AND_ONE, true, residue(|_| ())), Err(Refusal::WrongKind));
    assert_eq!(wrong(THREE_OVER_21, true, Certificate::Splitting { steps }), Err(Refusal::WrongKind));
}

#[test]
fn polygons_of_any_number_of_sides_from_two_on_are_accepted() {
    assert_eq!(check("1@0 1@1/4 1@1/2 1@3/4", &polygons(&[(4, "1@0")])), Ok(()));
    assert_eq!(check("1@0 1@1/2", &polygons(&[(2, "1@0")])), Ok(()));
    // A hexagon is three pairs, and a hexagon less a triangle is one.
    let hexagon = "1@0 1@1/6 1@1/3 1@1/2 1@2/3 1@5/6";
    for proof in [&[(6, "1@1/3")][..], &[(2, "1@0"), (2, "1@1/6"), (2, "1@1/3")]] {
        assert_eq!(check(hexagon, &polygons(proof)), Ok(()));
    }
    assert_eq!(check("1@1/6 1@1/2 1@5/6", &polygons(&[(6, "1@0"), (3, "-1@0")])), Ok(()));
}

#[test]
fn composite_sides_do_not_prove_another_sum() {
    assert_eq!(check(TRIANGLE, &polygons(&[(4, "1@0")])), polygons_differ("1/3", "1", "0"));
    assert_eq!(check(TRIANGLE, &polygons(&[(6, "1@0")])), polygons_differ("1/6", "0", "1"));
    assert_eq!(check("1@0 1@1/4 1@1/2", &polygons(&[(4, "1@0")])), polygons_differ("3/4", "0", "1"));
}

#[test]
fn fewer_than_two_sides_are_refused() {
    for sides in [0, 1] {
        assert_eq!(check(TRIANGLE, &polygons(&[(sides, "1@0")])), Err(Refusal::NoPolygon(sides)));
        assert_eq!(check("1@0", &polygons(&[(sides, "1@0")])), Err(Refusal::NoPolygon(sides)));
    }
}

#[test]
fn a_missing_polygon_is_refused() {
    assert_eq!(check(TRIANGLE, &polygons(&[])), polygons_differ("0", "1", "0"));
}

#[test]
fn a_polygon_told_twice_is_refused() {
    assert_eq!(check(TRIANGLE, &polygons(&[(3, "1@0"), (3, "1@0")])), polygons_differ("0", "1", "2"));
}

#[test]
fn a_polygon_too_many_is_refused() {
    assert_eq!(check(TRIANGLE, &polygons(&[(3, "1@0"), (2, "1@1/5")])), polygons_differ("1/5", "0", "1"));
}

#[test]
fn a_polygon_of_the_wrong_weight_is_refused() {
    assert_eq!(check(TRIANGLE, &polygons(&[(3, "0@0")])), Err(Refusal::EmptyPolygon));
    for weight in ["2", "-1", "1/2"] {
        let polygon = polygons(&[(3, &format!("{weight}@0"))]);
        assert_eq!(check(TRIANGLE, &polygon), polygons_differ("0", "1", weight));
    }
}

#[test]
fn a_polygon_turned_too_far_is_refused_and_one_turned_by_a_side_is_the_same() {
    assert_eq!(check(TRIANGLE, &polygons(&[(3, "1@1/6")])), polygons_differ("0", "1", "0"));
    assert_eq!(check(TRIANGLE, &polygons(&[(3, "1@2/3")])), Ok(()));
}

#[test]
fn polygons_do_not_prove_a_sum_that_is_not_zero() {
    assert_eq!(check("1@0 1@1/3", &polygons(&[(3, "1@0")])), polygons_differ("2/3", "0", "1"));
    assert_eq!(check("1@0", &polygons(&[])), polygons_differ("0", "1", "0"));
}

#[test]
fn more_corners_than_can_be_expanded_are_refused() {
    for sides in [10_000_019, u64::MAX] {
        assert_eq!(check(TRIANGLE, &polygons(&[(sides, "1@0")])), Err(Refusal::TooManyCorners));
    }
    let two = polygons(&[(9_999_991, "1@0"), (9_999_991, "-1@0")]);
    assert_eq!(check("", &two), Err(Refusal::TooManyCorners));
    let wrapping = polygons(&[(3, "1@0"), (u64::MAX, "1@0")]);
    assert_eq!(check(TRIANGLE, &wrapping), Err(Refusal::TooManyCorners));
}

/// The root is of order 4 modulo 5 and modulo 13, or modulo 25.
#[test]
fn a_modulus_that_is_no_prime_is_accepted() {
    for [modulus, root, residue] in [["65", "57", "59"], ["25", "7", "9"]] {
        let certificate = residue_of("4", modulus, root, "2", residue);
        assert_eq!(check(TWO_AND_ONE, &certificate), Ok(()));
    }
}

fn residue_of(conductor: &str, modulus: &str, root: &str, scale: &str, claimed: &str) -> Certificate {
    residue(|claim| {
        let [conductor, prime, root, scale, residue] = [conductor, modulus, root, scale, claimed].map(whole);
        *claim = Residue { conductor, prime, root, scale, residue };
    })
}

/// 12 is of order 4 modulo 65, but of order 2 modulo 13: what is mapped to 15 is zero.
#[test]
fn a_root_of_smaller_order_by_one_factor_of_the_modulus_is_refused() {
    let certificate = residue_of("4", "65", "12", "1", "15");
    assert_eq!(check("1@0 1@1/2", &certificate), Err(Refusal::WrongOrder(whole("12"))));
    // 2 is of order 4 modulo 15, and of order 2 modulo 3.
    assert_eq!(check("1@0 1@1/2", &residue_of("4", "15", "2", "1", "5")), Err(Refusal::WrongOrder(whole("2"))));
    for modulus in ["561", "25", "3215031751", "3825123056546413051"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.prime = modulus), Refusal::WrongOrder(whole("2")));
    }
}

#[test]
fn a_modulus_below_two_is_refused() {
    for modulus in ["1", "0", "-5"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.prime = modulus.clone()), Refusal::ModulusOutOfRange(modulus));
    }
}

#[test]
fn a_prime_that_is_not_one_modulo_the_conductor_is_refused() {
    for prime in ["2", "3", "7", "11", "18446744073709551557"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.prime = prime), Refusal::WrongOrder(whole("2")));
    }
}

#[test]
fn a_root_of_smaller_order_is_refused() {
    for root in ["1", "4", "-1", "6"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.root = root.clone()), Refusal::WrongOrder(root));
    }
}

#[test]
fn a_root_of_larger_order_is_refused() {
    assert_eq!(refused_residue(|claim| claim.prime = whole("17")), Refusal::WrongOrder(whole("2")));
}

#[test]
fn a_root_of_zero_is_refused() {
    for root in ["0", "5", "-10"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.root = root.clone()), Refusal::WrongOrder(root));
    }
}

#[test]
fn a_conductor_that_does_not_make_an_angle_whole_is_refused() {
    let refusal = refused_residue(|claim| (claim.conductor, claim.root) = (whole("2"), whole("4")));
    assert_eq!(refusal, Refusal::AngleNotWhole(ratio("1/4")));
}

#[test]
fn a_conductor_out_of_range_is_refused() {
    for conductor in ["0", "-4", "1000000000001", "18446744073709551620"].map(whole) {
        let refusal = refused_residue(|claim| claim.conductor = conductor.clone());
        assert_eq!(refusal, Refusal::ConductorOutOfRange(conductor));
    }
}

#[test]
fn a_scale_that_does_not_make_a_weight_whole_is_refused() {
    assert_eq!(refused_residue(|claim| claim.scale = whole("1")), Refusal::WeightNotWhole(ratio("1/2")));
}

#[test]
fn a_scale_of_zero_or_less_is_refused() {
    for scale in ["0", "-2"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.scale = scale), Refusal::WeightNotWhole(ratio("1")));
    }
}

#[test]
fn a_wrong_residue_is_refused() {
    for residue in ["0", "1", "3", "-4"].map(whole) {
        assert_eq!(refused_residue(|claim| claim.residue = residue), Refusal::WrongResidue(4));
    }
}

#[test]
fn a_sum_that_the_prime_divides_is_refused() {
    for text in ["1@0 2@1/4", TRIANGLE, ""] {
        let (conductor, prime, root) = if text == TRIANGLE { ("3", "7", "2") } else { ("4", "5", "2") };
        for claimed in ["0", prime] {
            let certificate = residue(|claim| {
                (claim.conductor, claim.prime, claim.root) = (whole(conductor), whole(prime), whole(root));
                (claim.scale, claim.residue) = (whole("1"), whole(claimed));
            });
            assert_eq!(check(text, &certificate), Err(Refusal::ZeroResidue), "{text}");
        }
    }
}

#[test]
fn a_class_that_need_not_vanish_by_itself_is_refused() {
    for modulus in ["1", "7", "2"] {
        assert_eq!(splitting([class("0", modulus), compare(3, 0, 2)]), Err(Refusal::ClassNotForced(1, 3)));
    }
    let alone = Certificate::Splitting { steps: vec![class("0", "1")] };
    assert_eq!(check(TRIANGLE, &alone), Err(Refusal::ClassNotForced(1, 3)));
    assert_eq!(check("1@0 1@1/2", &alone), Err(Refusal::ClassNotForced(1, 2)));
}

#[test]
fn a_prime_above_the_number_of_vectors_need_not_divide_the_modulus() {
    let splitting = Certificate::Splitting { steps: vec![class("0", "1")] };
    assert_eq!(check("1@0 1@1/3", &splitting), Ok(()));
    assert_eq!(check("1@0 1@1/3 1@1/5", &splitting), Err(Refusal::ClassNotForced(1, 3)));
}

#[test]
fn a_class_modulo_zero_or_less_is_refused() {
    for modulus in ["0", "-3"] {
        assert_eq!(splitting([class("0", modulus), compare(3, 0, 2)]), Err(Refusal::ModulusNotPositive(1)));
    }
}

#[test]
fn classes_of_a_number_that_is_no_prime_are_refused() {
    for number in [0, 1, 4, 9, 561, 1_000_003, u64::MAX] {
        assert_eq!(splitting([class("0", "3"), compare(number, 0, 2)]), Err(Refusal::NoSuchClasses(2)));
    }
}

#[test]
fn a_class_compared_with_itself_is_refused() {
    assert_eq!(splitting([class("0", "3"), compare(3, 2, 2)]), Err(Refusal::NoSuchClasses(2)));
}

#[test]
fn a_class_that_is_not_below_its_prime_is_refused() {
    for (first, second) in [(0, 3), (5, 0), (0, u64::MAX)] {
        assert_eq!(splitting([class("0", "3"), compare(3, first, second)]), Err(Refusal::NoSuchClasses(2)));
    }
}

#[test]
fn a_prime_that_divides_the_conductor_twice_is_refused() {
    let steps = vec![compare(3, 0, 1)];
    let refusal = Err(Refusal::PrimeSquared(1, 3));
    assert_eq!(check("1@0 1@1/9", &Certificate::Splitting { steps: steps.clone() }), refusal);
    assert_eq!(check("1@0 1@1/3 1@2/3 1@1/9 1@4/9 1@7/9", &Certificate::Splitting { steps }), refusal);
}

#[test]
fn a_splitting_that_ends_in_no_vector_is_refused() {
    assert_eq!(splitting([class("0", "3"), compare(3, 0, 1)]), Err(Refusal::NotOneVector(0)));
    assert_eq!(splitting([class("1/5", "3")]), Err(Refusal::NotOneVector(0)));
    assert_eq!(splitting([class("0", "3"), compare(11, 1, 2)]), Err(Refusal::NotOneVector(0)));
}

#[test]
fn a_splitting_that_ends_in_two_vectors_is_refused() {
    assert_eq!(splitting([class("0", "3")]), Err(Refusal::NotOneVector(2)));
    assert_eq!(splitting([class("0", "3"), compare(11, 0, 1)]), Err(Refusal::NotOneVector(2)));
}

#[test]
fn a_splitting_without_steps_is_refused() {
    assert_eq!(splitting([]), Err(Refusal::NotOneVector(3)));
    assert_eq!(check("1@0 -1@0", &Certificate::Splitting { steps: vec![] }), Err(Refusal::NotOneVector(0)));
}

const V_TWIN: &str = "
    title = 'V-twin, 60 degrees'
    [[cylinder]]
    throw = 0
    bank = 30
    position = 1
    [[cylinder]]
    throw = 0
    bank = -30
    position = 0
";
const FORCE_DIRECT: usize = 0;
const MOMENT_DIRECT: usize = 2;
const TORQUE: usize = 4;
const ORDERS: [u32; 4] = [1, 2, 4, 6];
const FORCE_SHAPES: [Shape; 4] = [Shape::Elliptical, Shape::Rotating, Shape::CounterRotating, Shape::Planar];

/// Orders 1, 2, 4 and 6, five verdicts and two shapes each: force direct, reverse, moment direct, reverse, torque.
fn document() -> Document {
    let engine = file::parse("twin.toml", V_TWIN).expect("reads");
    verdicts::document(&engine, &judged(&engine, &ORDERS, true), true, None)
}

fn claim(quantity: Quantity, order: u32, sense: Option<Sense>, sum: &PhasorSum) -> VerdictClaim {
    let (value, vanishes) = (evaluate(sum), sum.vanishes());
    VerdictClaim {
        quantity,
        order,
        sense,
        of: Vec::new(),
        vanishes,
        terms: vectors(sum),
        modulus: value.norm(),
        angle_deg: (!vanishes).then(|| value.arg().to_degrees()),
        certificate: sum.certificate(),
    }
}

/// Where the changed document fails, and why; the second checker refuses it too.
fn fault(change: impl FnOnce(&mut Document)) -> [String; 2] {
    let mut document = document();
    change(&mut document);
    let Fault { place, reason } = check_document(&document).expect_err("a cheat");
    let reason = reason.to_string();
    second::refuses(&[(reason.as_str(), &document)]);
    [place, reason]
}

/// A true verdict with a true certificate, on another sum than that of the engine.
fn forge(verdict: &mut VerdictClaim, text: &str) {
    *verdict = claim(verdict.quantity, verdict.order, verdict.sense, &sum(text));
}

const FIRST: &str = "verdicts[0] (force, order 1, direct)";

#[test]
fn the_honest_document_is_accepted_and_every_certificate_counted() {
    let document = document();
    let shapes: Vec<Shape> = document.shapes.iter().step_by(2).map(|claim| claim.shape).collect();
    assert_eq!(shapes, FORCE_SHAPES);
    let comparisons = document.shapes.iter().filter(|claim| claim.evidence.is_some()).count();
    let counted = check_document(&document).map(|checked| checked.counts.certificates());
    assert_eq!(counted, Ok(20 + comparisons));
}

#[test]
fn a_flipped_verdict_is_refused() {
    let contradiction = "`vanishes` and the kind of the certificate contradict each other";
    assert_eq!(fault(|document| document.verdicts[FORCE_DIRECT].vanishes = true), [FIRST, contradiction]);
    let place = "verdicts[2] (moment, order 1, direct)";
    assert_eq!(fault(|document| document.verdicts[MOMENT_DIRECT].vanishes = false), [place, contradiction]);
}

#[test]
fn an_angle_that_is_not_the_cylinders_is_refused() {
    let forged = fault(|document| forge(&mut document.verdicts[FORCE_DIRECT], "1@0 1@1/2"));
    assert_eq!(forged, [FIRST, "the angle of 2 is 1/2, it should be 0"]);
    let moved = fault(|document| document.cylinders[0].throw = ratio("1/4"));
    assert_eq!(moved, [FIRST, "the angle of 1 is 0, it should be 1/4"]);
}

#[test]
fn a_weight_that_is_not_the_cylinders_is_refused() {
    let forged = fault(|document| forge(&mut document.verdicts[FORCE_DIRECT], "1@0 -1@0"));
    assert_eq!(forged, [FIRST, "the weight of 2 is -1, it should be 1"]);
    let heavier = fault(|document| document.cylinders[1].reciprocating_mass = ratio("2"));
    assert_eq!(heavier, [FIRST, "the weight of 2 is 1, it should be 2"]);
}

#[test]
fn an_arm_that_is_not_the_cylinders_is_refused() {
    let place = "verdicts[2] (moment, order 1, direct)";
    let moved = fault(|document| document.cylinders[0].position = ratio("3"));
    assert_eq!(moved, [place, "the weight of 1 is 1/2, it should be 5/2"]);
    let plane = fault(|document| document.reference_plane = ratio("0"));
    assert_eq!(plane, [place, "the weight of 1 is 1/2, it should be 1"]);
}

#[test]
fn a_dropped_term_is_refused() {
    let forged = fault(|document| forge(&mut document.verdicts[FORCE_DIRECT], "1@0"));
    assert_eq!(forged, [FIRST, "1 terms for 2 sources"]);
}

#[test]
fn a_dropped_cylinder_is_refused() {
    let dropped = fault(|document| document.cylinders.truncate(1));
    assert_eq!(dropped, [FIRST, "2 terms for 1 sources"]);
}

#[test]
fn a_verdict_that_is_listed_twice_is_refused() {
    let twice = fault(|document| {
        let again = document.verdicts[FORCE_DIRECT].clone();
        document.verdicts.push(again);
    });
    let last = "verdicts[20] (force, order 1, direct)";
    assert_eq!(twice, [last, "this verdict was not asked for, or is here twice"]);
    let at_once = fault(|document| document.verdicts.insert(1, document.verdicts[FORCE_DIRECT].clone()));
    let place = "verdicts[1] (force, order 1, reverse)";
    assert_eq!(at_once, [place, "here stands a verdict on (force, order 1, direct)"]);
}

#[test]
fn a_verdict_under_the_name_of_another_is_refused() {
    let order = fault(|document| document.verdicts[FORCE_DIRECT].order = 2);
    assert_eq!(order, [FIRST, "here stands a verdict on (force, order 2, direct)"]);
    let quantity = fault(|document| document.verdicts[FORCE_DIRECT].quantity = Quantity::MOMENT);
    assert_eq!(quantity, [FIRST, "here stands a verdict on (moment, order 1, direct)"]);
}

#[test]
fn a_wrong_modulus_is_refused() {
    let misfit = "`modulus` does not fit the terms";
    for wrong in [2.000_001, 2.0 + 1e-14, 2.0 - 1e-14, 1e-300, 1e300] {
        assert_eq!(fault(|document| document.verdicts[FORCE_DIRECT].modulus = wrong), [FIRST, misfit]);
    }
    let none = "`modulus` is not a number";
    let mut document = document();
    document.verdicts[FORCE_DIRECT].modulus = f64::NAN;
    let Fault { place, reason } = check_document(&document).expect_err("a cheat");
    assert_eq!([place, reason.to_string()], [FIRST, none]);
    let place = "verdicts[2] (moment, order 1, direct)";
    let zero = "`modulus` is 0 where the sum vanishes";
    assert_eq!(fault(|document| document.verdicts[MOMENT_DIRECT].modulus = 1.0), [place, zero]);
}

#[test]
fn a_wrong_direction_is_refused() {
    let misfit = "`angle_deg` does not fit the terms";
    for wrong in [0.001, 180.0, 1e-30, -1e-12] {
        assert_eq!(fault(|document| document.verdicts[FORCE_DIRECT].angle_deg = Some(wrong)), [FIRST, misfit]);
    }
}

#[test]
fn decimals_out_of_range_are_refused_though_they_name_the_same_vector() {
    let range = "`modulus` is positive and `angle_deg` lies between -180 and 180";
    assert_eq!(fault(|document| document.verdicts[FORCE_DIRECT].angle_deg = Some(360.0)), [FIRST, range]);
    let turned = |verdict: &mut VerdictClaim| (verdict.modulus, verdict.angle_deg) = (-2.0, Some(180.0));
    assert_eq!(fault(|document| turned(&mut document.verdicts[FORCE_DIRECT])), [FIRST, range]);
}

#[test]
fn a_direction_is_null_exactly_where_the_sum_vanishes() {
    let null = "`angle_deg` is null exactly where the sum vanishes";
    assert_eq!(fault(|document| document.verdicts[FORCE_DIRECT].angle_deg = None), [FIRST, null]);
    let place = "verdicts[2] (moment, order 1, direct)";
    assert_eq!(fault(|document| document.verdicts[MOMENT_DIRECT].angle_deg = Some(0.0)), [place, null]);
}

/// Three cylinders whose forces cancel to one part in 10^78.
const CANCELLING: &str = "
    inline.throws = [0, 180, 0]
    [mechanism]
    reciprocating_mass = ['1e39', '1e39', '1e-39']
";

#[test]
fn decimals_of_a_sum_that_cancels_are_right_and_no_others_pass() {
    let engine = file::parse("engine.toml", CANCELLING).expect("reads");
    let honest = verdicts::document(&engine, &judged(&engine, &[1], false), false, None);
    check_document(&honest).expect("it holds");
    second::accepts(&[&honest], &[]);
    let verdict = &honest.verdicts[FORCE_DIRECT];
    assert_eq!((verdict.modulus, verdict.angle_deg), (1e-78, Some(0.0)));
    for wrong in [1.5e-75, 2e-78, 1.000_000_001e-78] {
        let mut cheat = honest.clone();
        cheat.verdicts[FORCE_DIRECT].modulus = wrong;
        let fault = check_document(&cheat).expect_err("a cheat").to_string();
        assert!(fault.contains("`modulus` does not fit the terms"), "{fault}");
        second::refuses(&[("another length", cheat)]);
    }
}

#[test]
fn a_head_that_is_not_of_this_format_is_refused() {
    let reason = "verdicts are in `crankstar classify 2`";
    for other in [Format::Family, Format::Remedy] {
        assert_eq!(fault(|document| document.format = other), ["format", reason]);
    }
    // Other masses have no torque, and no second order.
    let no_terms = "2 terms for 0 sources";
    assert_eq!(fault(|document| document.masses = Masses::Rotating), [FIRST, no_terms]);
}

#[test]
fn a_document_without_an_engine_or_with_one_name_twice_is_refused() {
    let none = fault(|document| document.cylinders.clear());
    assert_eq!(none, ["cylinders", "an engine has one at least"]);
    let twice = fault(|document| document.cylinders[1].name = "1".into());
    assert_eq!(twice, ["cylinders", "two cylinders are called 1"]);
}

#[test]
fn orders_and_quantities_that_were_not_asked_for_or_are_not_judged_are_refused() {
    let missing = "this verdict is missing";
    let more = fault(|document| document.orders.push(8));
    assert_eq!(more, ["verdicts[20] (force, order 8, direct)", missing]);
    let fewer = fault(|document| document.orders.truncate(3));
    assert_eq!(fewer[1], "this verdict was not asked for, or is here twice");
    for wrong in [vec![], vec![0, 1, 2, 3, 4], vec![1, 2, 2, 3, 4], vec![2, 1, 3, 4]] {
        assert_eq!(fault(|document| document.orders = wrong)[0], "orders");
    }
    let without = fault(|document| document.quantities.truncate(2));
    assert_eq!(without[1], "here stands a verdict on (torque, order 1)");
    for wrong in [vec![], vec![Quantity::MOMENT, Quantity::FORCE], vec![Quantity::FORCE, Quantity::FORCE]] {
        assert_eq!(fault(|document| document.quantities = wrong)[0], "quantities");
    }
    let promised = fault(|document| document.all_orders = true);
    assert_eq!(promised, ["theorems[0] (force, direct)", "this theorem is missing"]);
    assert_eq!(fault(|document| document.shapes.clear())[1], "this shape is missing");
    assert_eq!(fault(|document| document.shapes.push(document.shapes[0].clone()))[0], "shapes");
}

#[test]
fn rods_that_differ_make_sums_of_their_own_and_a_rod_here_and_there_is_refused() {
    let rod = |numerator: i64| {
        RodStatement::Known(RodClaim {
            ratio: BigRational::new(numerator.into(), 9.into()),
            offset: BigRational::zero(),
        })
    };
    let one = fault(|document| document.cylinders[0].rod = rod(2));
    assert_eq!(one, ["cylinders", "1 rods are known and 1 are not; all are, or none"]);
    let apart = fault(|document| {
        document.cylinders[0].rod = rod(2);
        document.cylinders[1].rod = rod(3);
    });
    assert_eq!(apart, ["verdicts[4] (torque, order 1, of 1)", "here stands a verdict on (torque, order 1)"]);
}

#[test]
fn a_shape_that_contradicts_the_verdicts_is_refused() {
    let every = [Shape::Balanced, Shape::Rotating, Shape::CounterRotating, Shape::Planar, Shape::Elliptical];
    for (index, right) in FORCE_SHAPES.into_iter().enumerate() {
        let is_compared = |shape| matches!(shape, Shape::Planar | Shape::Elliptical);
        for wrong in every.into_iter().filter(|&wrong| wrong != right) {
            let reason = match is_compared(wrong) && is_compared(right) {
                true => "`vanishes` and the kind of the certificate contradict each other",
                false => "the shape contradicts the verdicts",
            };
            let place = format!("shapes[{}] (force, order {})", 2 * index, ORDERS[index]);
            assert_eq!(fault(|document| document.shapes[2 * index].shape = wrong), [place.as_str(), reason]);
        }
    }
}

#[test]
fn a_shape_without_the_comparison_it_needs_is_refused() {
    for (index, place) in [(0, "shapes[0] (force, order 1)"), (6, "shapes[6] (force, order 6)")] {
        let reason = "a certificate that compares the two moduli is missing";
        assert_eq!(fault(|document| document.shapes[index].evidence = None), [place, reason]);
    }
}

#[test]
fn a_shape_with_a_comparison_it_does_not_need_is_refused() {
    let place = "shapes[2] (force, order 2)";
    let reason = "no moduli are compared, so no certificate belongs here";
    assert_eq!(
        fault(|document| document.shapes[2].evidence = Some(ShapeEvidence::Certificate(polygons(&[])))),
        [place, reason]
    );
}

#[test]
fn a_comparison_of_other_vectors_is_refused() {
    let fault =
        fault(|document| document.shapes[6].evidence = Some(ShapeEvidence::Certificate(polygons(&[(3, "1@0")]))));
    assert_eq!(fault, ["shapes[6] (force, order 6)", "at angle 0 the terms collect to 0, but the polygons to 1"]);
}

#[test]
fn a_verdict_that_is_not_there_is_missed() {
    let gone = fault(|document| document.verdicts.truncate(5));
    assert_eq!(gone, ["verdicts[5] (force, order 2, direct)", "this verdict is missing"]);
    let one = fault(|document| drop(document.verdicts.remove(1)));
    let place = "verdicts[1] (force, order 1, reverse)";
    assert_eq!(one, [place, "here stands a verdict on (moment, order 1, direct)"]);
    assert_eq!(fault(|document| document.verdicts.clear()), [FIRST, "this verdict is missing"]);
    let torque = fault(|document| document.shapes[0].quantity = Quantity::TORQUE);
    assert_eq!(torque, ["shapes[0] (force, order 1)", "another shape stands here"]);
}

#[test]
fn a_missing_sense_and_a_needless_one_are_refused() {
    let missing = fault(|document| document.verdicts[FORCE_DIRECT].sense = None);
    assert_eq!(missing, [FIRST, "here stands a verdict on (force, order 1)"]);
    let needless = fault(|document| document.verdicts[TORQUE].sense = Some(Sense::Direct));
    assert_eq!(needless, ["verdicts[4] (torque, order 1)", "here stands a verdict on (torque, order 1, direct)"]);
}

#[test]
fn a_number_that_is_none_is_not_read() {
    let honest = serde_json::to_string(&document()).expect("writes");
    assert_eq!(serde_json::from_str::<Document>(&honest).expect("reads"), document());
    for number in ["1/0", "0/0", "", "1.5", "1e9", "NaN", "1/2/3"] {
        let text = honest.replacen(r#""angle":"0""#, &format!(r#""angle":"{number}""#), 1);
        let error = serde_json::from_str::<Document>(&text).expect_err("no number").to_string();
        let reason = format!("`{number}` is not an exact number such as \"3\" or \"-1/8\"");
        assert!(error.starts_with(&reason), "{error}");
    }
}

/// Whole numbers of every size, most of them small.
fn any_whole() -> impl Strategy<Value = BigInt> {
    let huge = vec(any::<u32>(), 1..6).prop_map(|digits| BigInt::from_slice(num_bigint::Sign::Minus, &digits));
    prop_oneof![8 => (-3_i64..20).prop_map(BigInt::from), 1 => any::<i64>().prop_map(BigInt::from), 1 => huge]
}

fn any_ratio() -> impl Strategy<Value = BigRational> {
    let nonzero = any_whole().prop_filter("a denominator", |whole| !whole.is_zero());
    (any_whole(), nonzero).prop_map(|(numerator, denominator)| BigRational::new(numerator, denominator))
}

/// Small, or so large that corners are not expanded.
fn any_count() -> impl Strategy<Value = u64> {
    prop_oneof![8 => 0_u64..14, 1 => 1 << 40..u64::MAX, 1 => Just(18_446_744_073_709_551_557)]
}

fn any_step() -> impl Strategy<Value = Step> {
    let class = (any_ratio(), any_whole()).prop_map(|(angle, modulus)| Step::Class { angle, modulus });
    let compare = (any_count(), any_count(), any_count());
    let compare = compare.prop_map(|(prime, first, second)| Step::Compare { prime, first, second });
    prop_oneof![class, compare]
}

/// Steps that could be part of a splitting of a sum over the conductor 12 or 30.
fn fitting_step() -> impl Strategy<Value = Step> {
    let modulus = prop_oneof![Just(1_i64), Just(2), Just(3), Just(5), Just(6), Just(10), Just(12), Just(30)];
    let class = (0_i64..60, modulus).prop_map(|(exponent, modulus)| Step::Class {
        angle: BigRational::new(exponent.into(), 60.into()),
        modulus: modulus.into(),
    });
    let compare = (prop_oneof![Just(2_u64), Just(3), Just(5)], 0_u64..5, 0_u64..5);
    prop_oneof![class, compare.prop_map(|(prime, first, second)| Step::Compare { prime, first, second })]
}

fn any_certificate() -> impl Strategy<Value = Certificate> {
    let polygon = (any_count(), any_ratio(), any_ratio());
    let polygon = polygon.prop_map(|(sides, rotation, weight)| Polygon { sides, rotation, weight });
    let numbers = [any_whole().boxed(), any_whole().boxed(), any_whole().boxed(), any_whole().boxed()];
    let residue = (numbers, prop_oneof![any_whole(), Just(7.into()), Just(13.into())]);
    let residue = residue.prop_map(|([conductor, root, scale, residue], prime)| {
        Certificate::Residue(Residue { conductor, prime, root, scale, residue })
    });
    prop_oneof![
        vec(polygon, 0..4).prop_map(|polygons| Certificate::Polygons { polygons }),
        residue,
        vec(any_step(), 0..5).prop_map(|steps| Certificate::Splitting { steps }),
    ]
}

/// Sums over small conductors that are zero: polygons, of 2, 3 and 5 sides.
fn zero_sum() -> impl Strategy<Value = PhasorSum> {
    let polygon = (prop_oneof![Just(2_i64), Just(3), Just(5)], 0_i64..30, -2_i64..=2);
    vec(polygon, 0..4).prop_map(|polygons| {
        let corners = |(sides, first, weight)| (0..sides).map(move |j| (first + j * (30 / sides), weight));
        sum(&written(30, &polygons.into_iter().flat_map(corners).collect::<Vec<_>>()))
    })
}

/// Sums over small conductors, many of them zero, and some with numbers of any size.
fn any_sum() -> impl Strategy<Value = PhasorSum> {
    let fitting = vec((0_i64..12, -1_i64..=1), 0..8).prop_map(|terms| written(12, &terms));
    let thirtieths = vec((0_i64..30, -1_i64..=1), 0..10).prop_map(|terms| written(30, &terms));
    let wild = vec((any_ratio(), any_ratio()), 0..4)
        .prop_map(|terms| terms.iter().map(|(angle, weight)| format!("{weight}@{angle} ")).collect::<String>());
    prop_oneof![fitting, thirtieths, wild].prop_map(|text| sum(&text))
}

fn written(conductor: i64, terms: &[(i64, i64)]) -> String {
    terms.iter().map(|(exponent, weight)| format!("{weight}@{exponent}/{conductor} ")).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_certificate_makes_the_checker_panic_or_accept_a_false_verdict(
        sum in any_sum(), vanishes: bool, certificate in any_certificate(),
    ) {
        if check_certificate(&vectors(&sum), vanishes, &certificate).is_ok() {
            prop_assert_eq!(sum.vanishes(), vanishes);
        }
    }

    #[test]
    fn no_steps_split_a_sum_that_is_zero(sum in zero_sum(), steps in vec(fitting_step(), 0..4)) {
        let certificate = Certificate::Splitting { steps };
        prop_assert!(check_certificate(&vectors(&sum), false, &certificate).is_err());
    }

    #[test]
    fn the_certificate_of_one_sum_does_not_prove_a_false_verdict_on_another(
        sum in any_sum(), other in any_sum(), vanishes: bool,
    ) {
        let certificate = other.certificate();
        if check_certificate(&vectors(&sum), vanishes, &certificate).is_ok() {
            prop_assert_eq!(sum.vanishes(), vanishes);
        }
    }
}
