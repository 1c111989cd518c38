//! Is the motion of one piston right: its harmonics, their enclosures, their series, and the closed forms?

use crate::support::piston;
use crate::support::written::fraction;
use std::f64::consts::{FRAC_PI_2, TAU};

use crankstar::motion::{Enclosure, NoFullTurn, SliderCrank, coefficients_fast, series};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use piston::{CENTRIC, OFFSET, TORQUE, decimal};
use proptest::prelude::*;

fn crank(ratio: &str, offset: &str) -> SliderCrank {
    SliderCrank::new(decimal(ratio), decimal(offset)).expect("a crank that turns")
}

fn is_sure(enclosure: &Enclosure) -> bool {
    let largest = enclosure.low.abs().max(enclosure.high.abs());
    enclosure.width() * BigRational::from_integer(2.into()).pow(64) <= largest
}

fn is_exact(enclosure: &Enclosure, number: i64) -> bool {
    *enclosure == Enclosure::point(fraction(number, 1))
}

/// Does it hold the reference, surely and away from zero?
fn encloses(enclosure: &Enclosure, reference: &str) -> bool {
    let reference = decimal(reference);
    enclosure.contains(&reference) && is_sure(enclosure) && !enclosure.contains_zero()
}

/// Within one unit in the last place, subnormal or not.
fn is_next_to(float: f64, reference: f64) -> bool {
    (reference.next_down()..=reference.next_up()).contains(&float)
}

#[test]
fn enclosures_of_a_centric_crank_hold_the_references_for_every_rod_and_order() {
    for (ratio, order, reference) in CENTRIC {
        let coefficient = crank(ratio, "0").coefficient(order);
        assert!(encloses(&coefficient.re, reference), "λ = {ratio}, order {order}: {:?}", coefficient.re);
        assert!(is_exact(&coefficient.im, 0));
        let float = coefficient.re.to_float();
        assert!(is_next_to(float, reference.parse().unwrap()), "λ = {ratio}, order {order}: {float:e}, {reference}");
    }
}

#[test]
fn enclosures_with_an_offset_hold_the_references() {
    for (ratio, offset, order, reference) in OFFSET {
        let coefficient = crank(ratio, offset).coefficient(order);
        let (rod, other) =
            if order % 2 == 0 { (coefficient.re, coefficient.im) } else { (coefficient.im, coefficient.re) };
        assert!(encloses(&rod, reference), "λ = {ratio}, δ = {offset}, order {order}: {rod:?}");
        assert!(is_exact(&other, i64::from(order == 1)));
        assert!(is_next_to(rod.to_float(), reference.parse().unwrap()));
    }
}

/// These 30 digits belong to the float nearest 0.3, from which they were computed; at 3/10 they differ from the 17th place on.
#[test]
fn thirty_digits_of_the_theory_are_those_at_the_float_nearest_three_tenths() {
    let float = BigRational::from_float(0.3).unwrap();
    let crank = SliderCrank::new(float, BigRational::zero()).unwrap();
    for (order, digits) in [
        (2, "0.307050659062165738651338479921"),
        (4, "-0.00723769499682184001789487226973"),
        (6, "0.000191936746635921893230243291577"),
    ] {
        let doubt = (crank.coefficient(order).re.low / decimal(digits) - BigRational::one()).abs();
        assert!(doubt < decimal("1e-19"), "order {order}: {doubt}");
    }
}

#[test]
fn first_order_is_one_and_other_odd_orders_vanish_without_an_offset() {
    let crank = crank("0.3", "0");
    for order in [0, 1, 3, 5, 99] {
        let coefficient = crank.coefficient(order);
        assert!(is_exact(&coefficient.re, i64::from(order == 1)) && is_exact(&coefficient.im, 0));
    }
}

#[test]
fn every_order_is_there_with_an_offset_of_a_trillionth() {
    for offset in ["1e-12", "-1e-12"] {
        let crank = crank("0.25", offset);
        for order in 1..=12 {
            let coefficient = crank.coefficient(order);
            let rod = if order % 2 == 0 { coefficient.re } else { coefficient.im };
            assert!(!rod.contains_zero() && is_sure(&rod));
        }
    }
}

/// Of the number g in `c_k = (−i)^k g`: minus for even k, and for odd k the sign of the offset.
#[test]
fn signs_with_an_offset_are_those_of_the_theorem() {
    for (offset, odd_sign) in [("0.1", 1.0), ("-0.1", -1.0)] {
        for order in 1..=9_u32 {
            let coefficient = crank("0.4", offset).coefficient(order).to_complex();
            let rod = coefficient - if order == 1 { 1.0 } else { 0.0 };
            let g = (rod * Complex::new(0.0, 1.0).powu(order)).re;
            assert!(g * if order % 2 == 0 { -1.0 } else { odd_sign } > 0.0, "δ = {offset}, order {order}: {g}");
        }
    }
}

#[test]
fn an_infinitely_long_rod_leaves_the_first_order_of_the_force_and_the_second_of_the_torque() {
    let straight = crank("0", "0");
    assert!(is_exact(&straight.coefficient(1).re, 1) && is_exact(&straight.coefficient(1).im, 0));
    assert!(is_exact(&straight.coefficient(2).re, 0));
    assert_eq!(straight.torque_coefficient(2).im, Enclosure::point(fraction(1, 2)));
    // δ = 3/5: the rod keeps the slope 3/4.
    let slanted = crank("0", "0.6");
    assert!(slanted.coefficient(1).im.contains(&fraction(-3, 4)));
    let torque = slanted.torque_coefficient(2);
    assert!(torque.re.contains(&fraction(3, 4)) && torque.im == Enclosure::point(fraction(7, 32)));
    assert!((slanted.torque(0.4) - (0.75 * 0.8_f64.cos() - 7.0 / 32.0 * 0.8_f64.sin())).abs() < 1e-15);
}

#[test]
fn cranks_that_cannot_turn_are_refused_with_words() {
    let refusal = |ratio: &str, offset: &str| SliderCrank::new(decimal(ratio), decimal(offset)).unwrap_err();
    assert_eq!(refusal("-0.1", "0"), NoFullTurn::NegativeRatio(fraction(-1, 10)));
    assert_eq!(refusal("0.75", "-0.25"), NoFullTurn::RodTooShort(BigRational::one()));
    assert_eq!(refusal("0.9", "0.0999995"), NoFullTurn::TooNearOne(decimal("0.9999995")));
    assert_eq!(
        refusal("0.75", "0.5").to_string(),
        "r/l + |e|/l is 5/4, so the crank cannot make a full turn: it has to be less than 1"
    );
}

#[test]
fn a_crank_a_millionth_from_its_reach_is_enclosed() {
    let coefficient = crank("0.9", "0.099999").coefficient(3);
    assert!(is_sure(&coefficient.im));
}

#[test]
fn series_are_those_of_the_theory() {
    for (order, terms, text) in [
        (0, 4, "0"),
        (1, 4, "1"),
        (2, 1, "λ + …"),
        (2, 4, "λ + λ³/4 + 15λ⁵/128 + 35λ⁷/512 + …"),
        (3, 4, "0"),
        (4, 3, "−(λ³/4 + 3λ⁵/16 + 35λ⁷/256 + …)"),
        (6, 2, "9λ⁵/128 + 45λ⁷/512 + …"),
        (8, 2, "−(5λ⁷/256 + 35λ⁹/1024 + …)"),
    ] {
        assert_eq!(series(order, terms).to_string(), text);
    }
}

#[test]
fn a_partial_sum_and_its_tail_bracket_the_coefficient() {
    for (ratio, order, reference) in CENTRIC {
        for terms in [0, 1, 5] {
            // At high orders the terms grow for long when λ is near 1, and are added one by one.
            if order > 20 && ratio.starts_with("0.9") {
                continue;
            }
            let (series, ratio) = (series(order, terms), decimal(ratio));
            let (bracket, reference) = (series.enclosure(&ratio).unwrap(), decimal(reference));
            // At λ = 1e-8 six terms say more than the 50 digits of the reference.
            let doubt = reference.abs() * decimal("1e-49");
            let holds = bracket.low <= &reference + &doubt && &reference - doubt <= bracket.high;
            assert!(holds, "λ = {ratio}, order {order}, {terms} terms");
            assert_eq!(bracket.width(), series.tail(&ratio).unwrap());
        }
    }
    assert_eq!(series(2, 1).tail(&BigRational::one()), None);
    assert_eq!(series(3, 1).tail(&fraction(1, 2)), Some(BigRational::zero()));
}

/// With seven terms at λ = 0.3 the bound of what is cut off is nearly what is cut off.
#[test]
fn the_tail_is_not_far_above_what_is_cut_off() {
    let (series, ratio) = (series(2, 7), fraction(3, 10));
    let cut_off = crank("0.3", "0").coefficient(2).re.low - series.value(&ratio);
    let tail = series.tail(&ratio).unwrap();
    assert!(tail > cut_off && tail < cut_off * fraction(11, 10));
}

/// Re Σ x_k e^{ikψ}
fn sum(coefficients: &[Complex<f64>], psi: f64) -> f64 {
    coefficients.iter().enumerate().map(|(k, x)| (x * Complex::cis(k as f64 * psi)).re).sum()
}

#[test]
fn force_and_torque_are_the_sums_of_their_coefficients() {
    for (ratio, offset) in [("0.3", "0"), ("0.25", "0.02"), ("0.4", "-0.3"), ("1e-8", "0.1"), ("1e-8", "0")] {
        let crank = crank(ratio, offset);
        let force: Vec<_> = (0..60).map(|k| crank.coefficient(k).to_complex()).collect();
        let torque: Vec<_> = (0..60).map(|k| crank.torque_coefficient(k).to_complex()).collect();
        for psi in (0..48).map(|step| TAU * f64::from(step) / 48.0) {
            let place = format!("λ = {ratio}, δ = {offset}, ψ = {psi}");
            assert!((crank.acceleration(psi) + sum(&force, psi)).abs() < 4e-15, "{place}");
            assert!((crank.torque(psi) - sum(&torque, psi)).abs() < 4e-15, "{place}");
        }
    }
}

#[test]
fn velocity_is_the_derivative_of_position_and_acceleration_that_of_velocity() {
    let step = 1e-4;
    // Five points: the error of the quotient is about step⁴.
    let slope = |f: &dyn Fn(f64) -> f64, x: f64| {
        (f(x - 2.0 * step) - 8.0 * f(x - step) + 8.0 * f(x + step) - f(x + 2.0 * step)) / (12.0 * step)
    };
    for (ratio, offset) in [("0.3", "0"), ("0.25", "0.02"), ("0.5", "-0.3"), ("0", "0.2")] {
        let crank = crank(ratio, offset);
        assert_eq!(crank.position(0.0), 0.0);
        for psi in (0..24).map(|place| 0.1 + TAU * f64::from(place) / 24.0) {
            assert!((slope(&|x| crank.position(x), psi) - crank.velocity(psi)).abs() < 1e-10);
            assert!((slope(&|x| crank.velocity(x), psi) - crank.acceleration(psi)).abs() < 1e-10);
        }
    }
}

/// `s = cos ψ − λ sin²ψ/2 + O(λ³)`: at λ = 1e-8 the rest is below the last place.
#[test]
fn closed_forms_keep_every_digit_with_a_very_long_rod() {
    let (ratio, crank) = (1e-8, crank("1e-8", "0"));
    for psi in [0.1_f64, 0.7, 1.5, 1.57, 2.0, 3.0] {
        let (sin, cos) = psi.sin_cos();
        let close = |value: f64, expected: f64| (value - expected).abs() <= 1e-15 * expected.abs();
        assert!(close(crank.position(psi), -2.0 * (psi / 2.0).sin().powi(2) - 0.5 * ratio * sin * sin));
        assert!(close(crank.velocity(psi), -sin - ratio * sin * cos));
        assert!(close(crank.acceleration(psi), -cos - ratio * (cos * cos - sin * sin)));
    }
    // What the rod adds is itself right to every digit where the crank adds nothing.
    assert!((crank.acceleration(FRAC_PI_2) - (ratio - FRAC_PI_2.cos())).abs() < 1e-23);
}

/// At ψ = 90° the acceleration is `λ/√(1−λ²)`, which `1 − λ² sin²ψ` in floats gives to four places.
#[test]
fn closed_forms_keep_their_digits_near_the_end_of_reach() {
    let acceleration = crank("0.999999999999", "0").acceleration(FRAC_PI_2);
    let exact = 0.999_999_999_999 / (1e-12 * 1.999_999_999_999_f64).sqrt();
    assert!((acceleration / exact - 1.0).abs() < 1e-14, "{acceleration}, {exact}");
}

#[test]
fn enclosures_of_the_torque_hold_the_references() {
    for (ratio, offset, order, re, im) in TORQUE {
        let coefficient = crank(ratio, offset).torque_coefficient(order);
        for (part, reference) in [(coefficient.re, re), (coefficient.im, im)] {
            let holds = if reference == "0" { is_exact(&part, 0) } else { encloses(&part, reference) };
            assert!(holds, "λ = {ratio}, δ = {offset}, order {order}: {part:?}, {reference}");
        }
    }
}

/// `T = m r² ω² Σ b_k sin kψ`, `t_k = −i b_k`: λ/4, −1/2, −3λ/4, −λ²/4: the product of
/// `−(sin ψ + λ/2 sin 2ψ)` and `cos ψ + λ cos 2ψ`, and for the fourth the next power of λ.
#[test]
fn leading_terms_of_the_torque_are_those_found_by_hand() {
    let crank = crank("1e-8", "0");
    for (order, leading) in [(1, 0.25e-8), (2, -0.5), (3, -0.75e-8), (4, -0.25e-16)] {
        let coefficient = crank.torque_coefficient(order);
        assert!(is_exact(&coefficient.re, 0) && is_sure(&coefficient.im));
        assert!((-coefficient.im.to_float() / leading - 1.0).abs() < 1e-14);
    }
}

#[test]
fn no_order_of_the_torque_vanishes() {
    for (ratio, offset) in [("0.3", "0"), ("0.99", "0"), ("0.3", "0.02"), ("0.6", "-0.3"), ("1e-8", "0")] {
        for order in 1..=20 {
            let coefficient = crank(ratio, offset).torque_coefficient(order);
            assert!(!coefficient.re.contains_zero() || !coefficient.im.contains_zero());
        }
    }
}

/// A desaxe crank of one fiftieth: its third order is many times its sixth.
#[test]
fn an_offset_of_a_fiftieth_makes_a_third_order_over_ten_times_the_sixth() {
    for (ratio, third, sixth) in
        [("0.25", 1.495_034_893_5e-3, 7.493_566_556e-5), ("0.3", 2.212_955_957e-3, 1.934_166_905e-4)]
    {
        let crank = crank(ratio, "0.02");
        let size = |order| crank.coefficient(order).to_complex().norm();
        assert!((size(3) / third - 1.0).abs() < 1e-8 && (size(6) / sixth - 1.0).abs() < 1e-8);
        assert!(size(3) > 10.0 * size(6));
    }
}

#[test]
fn fast_coefficients_are_as_right_as_they_say() {
    let ratios = (1..40).map(|step| f64::from(step) / 40.0).chain([1e-8, 1e-3, 0.9989, 0.999, 0.9999, 0.999_999]);
    for ratio in ratios {
        let exact = SliderCrank::new(BigRational::from_float(ratio).unwrap(), BigRational::zero()).unwrap();
        for (highest, by_series, by_recurrence) in [(8, 4e-15, 2e-14), (20, 1e-14, 2e-13), (100, 5e-14, 5e-12)] {
            let error = if ratio < 0.99 { by_series } else { by_recurrence };
            let fast = coefficients_fast(ratio, highest);
            assert_eq!(fast.len(), highest as usize + 1);
            for order in [1, 2, 3, 4, 6, 8, 14, 20, 50, 100].into_iter().filter(|order| *order <= highest) {
                let (value, reference) = (fast[order as usize], exact.coefficient(order).re.to_float());
                // Below the normal floats there are fewer digits.
                let doubt = error * reference.abs() + f64::MIN_POSITIVE;
                assert!((value - reference).abs() <= doubt, "λ = {ratio}, order {order}: {value}, {reference}");
            }
        }
    }
}

#[test]
fn fast_coefficients_outside_their_domain_are_not_numbers() {
    for ratio in [-0.1, 1.0, f64::NAN, f64::INFINITY] {
        assert!(coefficients_fast(ratio, 4).iter().all(|value| value.is_nan()));
    }
    assert_eq!(coefficients_fast(0.0, 3), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(coefficients_fast(0.3, 0), [0.0]);
}

#[test]
fn enclosures_add_and_multiply_outward() {
    let enclosure = Enclosure { low: fraction(-1, 2), high: fraction(1, 3) };
    assert!(enclosure.contains_zero() && enclosure.contains(&fraction(1, 3)));
    assert_eq!(enclosure.times(&fraction(-2, 1)), Enclosure { low: fraction(-2, 3), high: BigRational::one() });
    assert_eq!(enclosure.plus(&Enclosure::point(BigRational::one())).low, fraction(1, 2));
    assert_eq!(enclosure.width(), fraction(5, 6));
}

/// The k-th harmonic of a function of period 2π from its samples, in the convention Re Σ.
fn sampled(f: impl Fn(f64) -> f64, order: u32) -> Complex<f64> {
    let count = 2048;
    let steps = (0..count).map(|step| TAU * f64::from(step) / f64::from(count));
    steps.map(|psi| f(psi) * Complex::cis(-f64::from(order) * psi)).sum::<Complex<f64>>() * (2.0 / f64::from(count))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn coefficients_are_those_of_the_sampled_motion(
        ratio in 1_i64..900, offset in -900_i64..900, order in 1_u32..30,
    ) {
        prop_assume!(ratio + offset.abs() < 970);
        let crank = SliderCrank::new(fraction(ratio, 1000), fraction(offset, 1000)).unwrap();
        let force = sampled(|psi| -crank.acceleration(psi), order);
        prop_assert!((force - crank.coefficient(order).to_complex()).norm() < 1e-12);
        let torque = sampled(|psi| crank.torque(psi), order);
        prop_assert!((torque - crank.torque_coefficient(order).to_complex()).norm() < 1e-12);
    }

    /// Two rigorous routes: the arithmetic-geometric mean, and the partial sum with its tail.
    #[test]
    fn means_and_series_overlap(numerator in 1_i64..800, half_order in 1_u32..12) {
        let ratio = fraction(numerator, 1000);
        let mean = SliderCrank::new(ratio.clone(), BigRational::zero()).unwrap().coefficient(2 * half_order).re;
        let series = series(2 * half_order, 60).enclosure(&ratio).unwrap();
        prop_assert!(mean.low <= series.high && series.low <= mean.high);
    }

    /// Two rigorous routes: without an offset, and with one so small that its square is below the last bit.
    #[test]
    fn an_offset_too_small_to_see_changes_no_even_order(numerator in 1_i64..990, half_order in 1_u32..12) {
        let ratio = fraction(numerator, 1000);
        let of = |offset: BigRational| SliderCrank::new(ratio.clone(), offset).unwrap().coefficient(2 * half_order).re;
        let (centric, offset) = (of(BigRational::zero()), of(decimal("1e-30")));
        prop_assert!(centric.low <= offset.high && offset.low <= centric.high);
        let float = offset.to_float();
        prop_assert!(is_next_to(float, centric.low.to_f64().unwrap()));
    }
}

#[test]
fn a_harmonic_of_a_very_long_rod_is_the_first_term_of_its_series_and_a_little_more() {
    for (exponent, order) in [(4, 2), (4, 40), (40, 2), (40, 1000)] {
        let ratio = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(exponent));
        let crank = SliderCrank::new(ratio.clone(), BigRational::from_integer(0.into())).expect("it turns");
        let found = crank.coefficient(order).re;
        let series = crankstar::motion::series(order, 2).enclosure(&ratio).expect("below 1");
        assert!(found.low <= series.high && series.low <= found.high, "order {order} of λ = 1e-{exponent}");
        assert!(!found.contains_zero());
        assert!(found.width() * BigRational::from_integer((1_u64 << 63).into()) < num_traits::abs(found.low.clone()));
    }
}
