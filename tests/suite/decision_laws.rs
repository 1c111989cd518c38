//! Is every verdict right, whatever the conductor, the size of the numbers and the way the sum is written?

use crate::support::dice::{Dice, Terms, one_of_each, phasors, polygons, spoiled};
use crate::support::oracle;
use crate::support::written::{ratio, sum, vectors};
use crankstar::exact::{PhasorSum, Term, Turn, vanishes};
use crankstar::proof::{Certificate, check_certificate};
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

const CONDUCTORS: std::ops::RangeInclusive<u64> = 1..=300;
const PRIME: &str = "1/1000000007";

/// Tries `rounds` sums of every make over each conductor; returns how many were zero and how many not.
fn try_over(
    conductors: impl Iterator<Item = u64>,
    rounds: u64,
    mut law: impl FnMut(u64, &Terms, &mut Dice) -> bool,
) -> (usize, usize) {
    let (mut zero, mut other) = (0, 0);
    for conductor in conductors {
        let mut dice = Dice::new(conductor);
        for _ in 0..rounds {
            for terms in one_of_each(&mut dice, conductor) {
                *(if law(conductor, &terms, &mut dice) { &mut zero } else { &mut other }) += 1;
            }
        }
    }
    (zero, other)
}

fn big(terms: &[(u64, i64)]) -> Vec<(BigUint, BigInt)> {
    terms.iter().map(|&(exponent, weight)| (exponent.into(), weight.into())).collect()
}

/// The certificate is of the kind that the verdict and the conductor call for, and the checker accepts it.
fn assert_proved(sum: &PhasorSum, zero: bool) {
    assert_eq!(sum.vanishes(), zero, "{sum:?}");
    let certificate = sum.certificate();
    let conductor = sum.terms().iter().fold(BigInt::one(), |n, term| n.lcm(term.angle.denominator()));
    let kind = match &certificate {
        Certificate::Polygons { .. } => "polygons",
        Certificate::Residue(_) => "residue",
        Certificate::Splitting { .. } => "splitting",
    };
    let wanted = match zero {
        true => "polygons",
        false if conductor < 1_000_000.into() => "residue",
        false => "splitting",
    };
    assert_eq!(kind, wanted, "{sum:?}");
    assert_eq!(check_certificate(&vectors(sum), zero, &certificate), Ok(()), "{sum:?} {certificate:?}");
}

#[test]
fn the_verdict_agrees_with_the_oracle_over_every_conductor_up_to_300() {
    let mut known = (0, Vec::new());
    let (zero, other) = try_over(CONDUCTORS, 16, |conductor, terms, _| {
        let n = conductor as usize;
        if known.0 != n {
            known = (n, oracle::cyclotomic(n));
        }
        let verdict = vanishes(&conductor, terms);
        assert_eq!(verdict, oracle::vanishes(n, &known.1, terms), "{conductor} {terms:?}");
        verdict
    });
    assert!(zero > 10_000 && other > 20_000, "{zero} zero, {other} not");
}

#[test]
fn machine_words_and_big_integers_give_the_same_verdict() {
    let (zero, other) = try_over(CONDUCTORS, 2, |conductor, terms, _| {
        let verdict = vanishes(&conductor, terms);
        assert_eq!(verdict, vanishes(&BigUint::from(conductor), &big(terms)), "{conductor} {terms:?}");
        verdict
    });
    assert!(zero > 1_000 && other > 1_000, "{zero} zero, {other} not");
}

#[test]
fn turning_scaling_mirroring_and_reordering_change_no_verdict() {
    let (zero, other) = try_over(CONDUCTORS.step_by(7), 1, |conductor, terms, dice| {
        let sum = phasors(conductor, terms);
        let angle = Turn::fraction(dice.below(1_000) as i64, dice.below(1_000) as i64 + 1);
        let factor =
            ratio(["-1", "-7/3", "1/1000000007", "10000000000000000000000000000000000000001"][terms.len() % 4]);
        let verdict = sum.vanishes();
        let same = [sum.turned(&angle), sum.turned(&Turn::new(ratio(PRIME))), sum.scaled(&factor), sum.conjugate()];
        for (index, changed) in same.iter().chain([&shuffled(&sum, dice)]).enumerate() {
            assert_eq!(changed.vanishes(), verdict, "change {index} of {sum:?}, by {angle:?}, by {factor}");
        }
        verdict
    });
    assert!(zero > 100 && other > 200, "{zero} zero, {other} not");
}

fn shuffled(sum: &PhasorSum, dice: &mut Dice) -> PhasorSum {
    let mut terms = sum.terms().to_vec();
    for last in (1..terms.len()).rev() {
        terms.swap(last, dice.below(last as u64 + 1) as usize);
    }
    PhasorSum::new(terms)
}

#[test]
fn sums_are_equal_where_their_difference_vanishes_however_they_are_written() {
    let (zero, other) = try_over(CONDUCTORS.step_by(7), 1, |conductor, terms, dice| {
        let added = phasors(conductor, terms);
        let some = phasors(conductor, &one_of_each(dice, conductor)[0]);
        let (sum, empty) = (some.plus(&added), PhasorSum::new(Vec::new()));
        let collected = PhasorSum::new(sum.collected());
        let verdict = added.vanishes();
        assert_eq!(sum == some, verdict, "{some:?} and {added:?} added");
        assert_eq!(some == sum, verdict, "{some:?} and {added:?} added");
        assert_eq!(sum.minus(&some) == empty, verdict, "{some:?} and {added:?} added");
        for same in [shuffled(&sum, dice), collected, sum.plus(&empty), sum.minus(&added).plus(&added)] {
            assert_eq!(same, sum);
            assert_eq!(sum, same);
            assert_eq!(same == some, verdict, "{same:?} and {some:?}");
        }
        verdict
    });
    assert!(zero > 100 && other > 200, "{zero} zero, {other} not");
}

#[test]
fn equal_sums_may_have_no_direction_in_common() {
    assert_eq!(sum("1@0 1@1/3"), sum("1@1/6"));
    assert_eq!(sum("1/2@1/7 1/2@1/7 0@1/5"), sum("1@1/7"));
    assert_eq!(sum("1@1/5 1@4/5 1@2/5 1@3/5"), sum("-1@0"));
    assert_ne!(sum("1@0 1@1/3"), sum("1@1/6 1/1000000007@1/4"));
    assert_ne!(sum("1@0").terms(), sum("1/2@0 1/2@0").terms());
}

#[test]
fn every_verdict_has_a_certificate_that_the_checker_accepts() {
    let (zero, other) = try_over(CONDUCTORS.step_by(3), 1, |conductor, terms, _| {
        let verdict = vanishes(&conductor, terms);
        assert_proved(&phasors(conductor, terms), verdict);
        verdict
    });
    assert!(zero > 200 && other > 400, "{zero} zero, {other} not");
}

#[test]
fn a_squared_modulus_vanishes_with_its_sum() {
    for conductor in [1, 6, 7, 30, 36, 105] {
        for terms in one_of_each(&mut Dice::new(conductor), conductor) {
            let sum = phasors(conductor, &terms);
            assert_eq!(sum.squared_modulus().vanishes(), sum.vanishes(), "{sum:?}");
        }
    }
}

/// Polygons as `weight*sides@rotation`, in the order of the certificate.
fn shown(certificate: &Certificate) -> String {
    let Certificate::Polygons { polygons } = certificate else { return "none".into() };
    let words: Vec<String> = polygons.iter().map(|p| format!("{}*{}@{}", p.weight, p.sides, p.rotation)).collect();
    words.join(" ")
}

#[test]
fn known_sums_have_the_polygons_a_person_would_name() {
    let table = [
        ("", ""),
        ("0@1/5", ""),
        ("1@1/7 -1@1/7", ""),
        ("1@0", "none"),
        ("1@0 1@1/3", "none"),
        ("1@0 1@1/2", "1*2@0"),
        ("1@0 1@1/2 1@1/2 1@0", "2*2@0"),
        ("1@0 1@1/4 1@1/2 1@3/4", "1*2@0 1*2@1/4"),
        ("1@0 1@1/3 1@2/3", "1*3@0"),
        ("-5/7@1/12 -5/7@5/12 -5/7@3/4", "-5/7*3@1/12"),
        ("1@0 1@1/6 1@1/3 1@1/2 1@2/3 1@5/6", "1*3@0 1*3@1/6"),
        ("1@0 1@1/3 -1@1/6", "-1*2@1/6 1*3@0"),
        ("1@1/5 1@2/5 1@3/5 1@4/5 -1@1/3 -1@2/3", "-1*3@0 1*5@0"),
        ("1@0 2@1/3 2@2/3 1@1/2", "none"),
        ("3@0 2@1/3 2@2/3 1@1/2", "1*2@0 2*3@0"),
    ];
    for (text, polygons) in table {
        assert_eq!(shown(&sum(text).certificate()), polygons, "{text}");
    }
}

#[test]
fn fewest_polygons_are_preferred_to_positive_ones() {
    let pentagon_and_triangle = "1@0 1@1/5 1@2/5 1@3/5 1@4/5 1@1/2 1@5/6 1@1/6";
    assert_eq!(shown(&sum(pentagon_and_triangle).certificate()), "1*3@1/6 1*5@0");
    let triangle_and_pairs = "1@1/2 1@5/6 1@1/6 1@1/5 1@2/5 1@3/5 1@4/5 1@7/10 1@9/10 1@1/10 1@3/10";
    // Four pairs and the triangle are one polygon more.
    assert_eq!(shown(&sum(triangle_and_pairs).certificate()), "-1*2@0 1*3@1/6 1*5@0 1*5@1/10");
}

/// At least 500 terms over a conductor that many small primes divide, and the same with one term more.
fn five_hundred_terms(conductor: u64) -> [PhasorSum; 2] {
    let mut dice = Dice::new(conductor);
    let mut terms = polygons(&mut dice, conductor, 150, |dice| dice.below(7) as i64 - 3);
    assert!(terms.len() >= 500, "{}", terms.len());
    terms.rotate_left(250);
    let worse = spoiled(&mut dice, conductor, terms.clone());
    [phasors(conductor, &terms), phasors(conductor, &worse)]
}

#[test]
fn five_hundred_terms_are_decided_and_proved() {
    for conductor in [30_030, 360_360, 1_021_020, 9_699_690] {
        let [zero, other] = five_hundred_terms(conductor);
        assert_proved(&zero, true);
        assert_proved(&other, false);
    }
}

/// A triangle, a pentagon and a heptagon, with two-digit weights, and the same with one term more.
fn three_polygons() -> [PhasorSum; 2] {
    let mut terms: Vec<Term> = Vec::new();
    for (sides, weight) in [(3, "17"), (5, "-31/4"), (7, "12")] {
        terms.extend((0..sides).map(|j| Term { angle: Turn::fraction(j, sides), weight: ratio(weight) }));
    }
    let zero = PhasorSum::new(terms);
    let other = zero.plus(&sum("1/9@3/7"));
    [zero, other]
}

#[test]
fn polygons_turned_by_a_tiny_angle_are_decided_and_proved() {
    let angles = [
        PRIME,
        "1/999999999999999989",
        "999999999999999988/999999999999999989",
        "1/1000000000000000000",
        "1/1000000016000000063",
        "1/18446744073709551557",
    ];
    let [zero, other] = three_polygons();
    for angle in angles.map(ratio).map(Turn::new) {
        assert_proved(&zero.turned(&angle), true);
        assert_proved(&other.turned(&angle), false);
        assert_proved(&zero.plus(&zero.turned(&angle)), true);
        assert_proved(&zero.plus(&other.turned(&angle)), false);
        assert_proved(&other.minus(&other.turned(&angle)), false);
    }
}

#[test]
fn conductors_beyond_a_machine_word_are_decided_and_proved() {
    let [zero, other] = three_polygons();
    let angles = ["1/1000000007", "5/1000000009", "2/998244353", "-1/1000000000039"].map(ratio).map(Turn::new);
    let spread = |first: &PhasorSum| angles.iter().fold(first.clone(), |all, angle| all.plus(&zero.turned(angle)));
    assert_proved(&spread(&zero), true);
    assert_proved(&spread(&other), false);
}

#[test]
fn weights_of_forty_digits_are_decided_and_proved() {
    let factor = ratio("1234567890123456789012345678901234567891/9876543210987654321098765432109876543211");
    let one_more = sum("1/1000000000000000000000000000000000000000@1/3");
    for sums in [three_polygons(), five_hundred_terms(30_030)] {
        for (zero, sum) in [true, false].into_iter().zip(sums) {
            assert_proved(&sum.scaled(&factor), zero);
            assert_proved(&sum.scaled(&factor).turned(&Turn::new(ratio(PRIME))), zero);
            assert_proved(&sum.plus(&one_more), false);
        }
    }
}

#[test]
fn weights_that_fit_a_machine_word_while_their_differences_do_not_are_decided_and_proved() {
    let word = i64::MAX;
    assert_proved(&sum(&format!("{word}@0 {word}@1/3 -{word}@2/3 1@1/2")), false);
    assert_proved(&sum(&format!("{word}@0 {word}@1/3 {word}@2/3 -{word}@1/6 -{word}@1/2 -{word}@5/6")), true);
}

#[test]
fn a_sum_that_cancels_to_one_part_in_ten_to_the_forty_is_not_zero() {
    let one = "1000000000000000000000000000000000000000";
    let text = format!("{one}@0 {one}@1/3 1000000000000000000000000000000000000001@2/3");
    assert_proved(&sum(&text), false);
    assert_proved(&sum(&text).turned(&Turn::new(ratio(PRIME))), false);
}

#[test]
fn a_conductor_of_a_million_is_proved_by_a_splitting_and_a_lesser_one_by_a_residue() {
    let kind = |text: &str| sum(text).certificate();
    assert!(matches!(kind("1@0 1@1/999999"), Certificate::Residue(_)));
    assert!(matches!(kind("1@0 1@1/1000000"), Certificate::Splitting { .. }));
    for text in ["1@0 1@1/999999", "1@0 1@1/1000000", "1@0 1@1/999983", "1@0 1@1/1000003", "1@1/1000003"] {
        assert_proved(&sum(text), false);
    }
}

#[test]
fn a_tiny_angle_alone_keeps_vectors_from_cancelling() {
    assert_proved(&sum("1@0 -1@1/1000000007"), false);
    assert_proved(&sum("1@0 1@1/2 1@1/1000000007"), false);
    assert_proved(&sum("1@1/1000000007 -1@1/1000000007"), true);
    assert_proved(&sum("1@1/1000000007 1@1000000009/2000000014"), true);
}

#[test]
fn the_sides_of_a_polygon_may_be_many() {
    let sides = 499;
    let corners = (0..sides).map(|j| Term { angle: Turn::fraction(j, sides), weight: BigRational::one() });
    let polygon = PhasorSum::new(corners.collect());
    assert_eq!(shown(&polygon.certificate()), "1*499@0");
    assert_proved(&polygon.turned(&Turn::new(ratio(PRIME))), true);
    assert_proved(&PhasorSum::new(polygon.terms()[1..].to_vec()), false);
}
