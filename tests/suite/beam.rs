//! Do the main bearings carry what a continuous beam's supports carry?

use crankstar::beam::{Beam, BeamError};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::support::dice::Dice;
use crate::support::stiffness;
use crate::support::written::fraction;

const TRILLION: i64 = 1_000_000_000_000;

fn whole(number: i64) -> BigRational {
    fraction(number, 1)
}

fn beam(supports: &[BigRational]) -> Beam {
    Beam::new(supports.to_vec()).expect("supports of a beam")
}

fn parts(beam: &Beam, position: &BigRational) -> Vec<BigRational> {
    beam.influence(position)
}

/// Supports at 0, 2, 4, …, so that mid-spans stand at 1, 3, 5, …
fn equal_spans(count: i64) -> Vec<BigRational> {
    (0..=count).map(|support| whole(2 * support)).collect()
}

/// What the supports carry of these loads, one a mid-span of as many equal spans.
fn at_mid_spans(loads: &[i64]) -> Vec<String> {
    let beam = beam(&equal_spans(loads.len() as i64));
    let mut sums = vec![BigRational::zero(); loads.len() + 1];
    for (span, &load) in loads.iter().enumerate() {
        for (sum, part) in sums.iter_mut().zip(parts(&beam, &whole(2 * span as i64 + 1))) {
            *sum += part * whole(load);
        }
    }
    sums.iter().map(ToString::to_string).collect()
}

fn force_and_moment(supports: &[BigRational], parts: &[BigRational]) -> (BigRational, BigRational) {
    (parts.iter().sum(), supports.iter().zip(parts).map(|(support, part)| support * part).sum())
}

/// Supports with spans of 1 to `most` over 1 to 30, ascending, from somewhere below or above 0.
fn random_supports(dice: &mut Dice, spans: usize, most: u64) -> Vec<BigRational> {
    let mut length = |most: u64| fraction(dice.below(most) as i64 + 1, dice.below(30) as i64 + 1);
    let mut supports = vec![length(100) - whole(50)];
    for _ in 0..spans {
        let next = length(most) + &supports[supports.len() - 1];
        supports.push(next);
    }
    supports
}

/// Somewhere in every span, on a support, and overhung at both ends.
fn random_positions(dice: &mut Dice, supports: &[BigRational]) -> Vec<BigRational> {
    let mut within = |ends: &[BigRational]| {
        let parts = dice.below(50) as i64 + 2;
        let part = fraction(1 + dice.below(parts as u64 - 1) as i64, parts);
        &ends[0] + (&ends[1] - &ends[0]) * part
    };
    let mut positions: Vec<_> = supports.windows(2).map(&mut within).collect();
    let (first, last) = (&supports[0], &supports[supports.len() - 1]);
    positions.push(within(&[first - whole(3), first.clone()]));
    positions.push(within(&[last.clone(), last + whole(3)]));
    positions.push(supports[dice.below(supports.len() as u64) as usize].clone());
    positions
}

/// Random beams with 1 to `most` spans, at every ratio of spans up to 10⁶, and loads on them.
fn random_cases(seed: u64, most: usize) -> Vec<(Vec<BigRational>, Vec<BigRational>)> {
    let mut dice = Dice::new(seed);
    let case = |spans: usize| {
        let supports = random_supports(&mut dice, spans, [10, 1000, 1_000_000][spans % 3]);
        let positions = random_positions(&mut dice, &supports);
        (supports, positions)
    };
    (1..=most).map(case).collect()
}

#[test]
fn loads_at_all_mid_spans_of_equal_spans_give_the_published_reactions() {
    // Tables of continuous beams, concentrated load P at the middle of every span (AISC Manual of Steel Construction).
    assert_eq!(at_mid_spans(&[1]), ["1/2", "1/2"]);
    assert_eq!(at_mid_spans(&[1, 1]), ["5/16", "11/8", "5/16"]);
    assert_eq!(at_mid_spans(&[1, 1, 1]), ["7/20", "23/20", "23/20", "7/20"]);
    assert_eq!(at_mid_spans(&[1, 1, 1, 1]), ["19/56", "17/14", "25/28", "17/14", "19/56"]);
}

#[test]
fn a_load_at_one_mid_span_lifts_the_far_support() {
    assert_eq!(at_mid_spans(&[1, 0]), ["13/32", "11/16", "-3/32"]);
    assert_eq!(at_mid_spans(&[1, 0, 0]), ["2/5", "29/40", "-3/20", "1/40"]);
}

#[test]
fn rotating_loads_of_the_flat_four_throw_crank_on_five_bearings() {
    // Throws at 0°, 180°, 180°, 0°: the middle bearing feels 43/28 loads, in the direction of the inner throws.
    assert_eq!(at_mid_spans(&[1, -1, -1, 1]), ["25/56", "9/28", "-43/28", "9/28", "25/56"]);
}

#[test]
fn one_span_is_the_lever_and_the_determinate_approximation_is_exact() {
    let one = beam(&[whole(-1), whole(4)]);
    for (position, expected) in [(0, ["4/5", "1/5"]), (4, ["0", "1"]), (6, ["-2/5", "7/5"]), (-2, ["6/5", "-1/5"])] {
        let found: Vec<_> = parts(&one, &whole(position)).iter().map(ToString::to_string).collect();
        assert_eq!(found, expected, "load at {position}");
        assert_eq!(one.determinate(&whole(position)), one.influence(&whole(position)));
    }
}

#[test]
fn an_overhung_load_bends_the_next_support_with_the_carry_over_of_one_quarter() {
    // Two spans l with an end moment M: M_1 = −M/4, so the outer support carries 1 + (5/4)d/l.
    let found = parts(&beam(&equal_spans(2)), &whole(5));
    assert_eq!(found, [fraction(1, 8), fraction(-3, 4), fraction(13, 8)]);
}

#[test]
fn the_determinate_approximation_loads_the_two_supports_beside_the_load() {
    let supports = [whole(0), whole(2), whole(3), whole(7)];
    let beam = beam(&supports);
    for (position, expected) in [
        (fraction(1, 2), [fraction(3, 4), fraction(1, 4), whole(0), whole(0)]),
        (fraction(9, 4), [whole(0), fraction(3, 4), fraction(1, 4), whole(0)]),
        (whole(3), [whole(0), whole(0), whole(1), whole(0)]),
        (whole(8), [whole(0), whole(0), fraction(-1, 4), fraction(5, 4)]),
        (whole(-2), [whole(2), whole(-1), whole(0), whole(0)]),
    ] {
        let found = beam.determinate(&position);
        assert_eq!(found, expected, "load at {position}");
        assert_eq!(force_and_moment(&supports, &found), (whole(1), position));
    }
}

#[test]
fn reactions_balance_the_force_and_the_moment_of_the_load() {
    for (supports, positions) in random_cases(1, 20) {
        let beam = beam(&supports);
        for position in positions {
            let found = parts(&beam, &position);
            assert_eq!(force_and_moment(&supports, &found), (BigRational::one(), position));
        }
    }
}

#[test]
fn a_load_on_a_support_is_carried_there_alone() {
    for (supports, _) in random_cases(2, 12) {
        let beam = beam(&supports);
        for (at, position) in supports.iter().enumerate() {
            let expected: Vec<_> = (0..supports.len()).map(|k| whole(i64::from(k == at))).collect();
            assert_eq!(parts(&beam, position), expected);
            assert_eq!(beam.determinate(position), expected);
        }
    }
}

#[test]
fn a_mirrored_shifted_and_scaled_beam_carries_the_same_parts() {
    for (supports, positions) in random_cases(3, 12) {
        // Mirrored, so that the supports come in descending order: the answers keep it.
        let moved = |position: &BigRational| fraction(22, 7) - position * fraction(254, 10_000);
        let (here, there) = (beam(&supports), beam(&supports.iter().map(moved).collect::<Vec<_>>()));
        for position in positions {
            assert_eq!(here.influence(&position), there.influence(&moved(&position)));
            assert_eq!(here.determinate(&position), there.determinate(&moved(&position)));
        }
    }
}

#[test]
fn the_order_in_which_supports_are_given_orders_the_answer() {
    let (sorted, mixed) = (beam(&[0, 1, 3, 7].map(whole)), beam(&[3, 0, 7, 1].map(whole)));
    let [a, b, c, d] = parts(&sorted, &whole(2)).try_into().expect("four parts");
    assert_eq!(parts(&mixed, &whole(2)), [c, a, d, b]);
}

#[test]
fn far_from_the_load_reactions_change_sign_and_fade_by_the_fixed_point_ratio() {
    // In equal spans without loads M_{k−1} + 4M_k + M_{k+1} = 0: three spans from the end the ratio is −(2 + √3) ≈ −3.732.
    let found = parts(&beam(&equal_spans(50)), &whole(1));
    for pair in found[2..48].windows(2) {
        let ratio_of_both = &pair[0] / &pair[1];
        assert!(ratio_of_both < fraction(-373, 100) && ratio_of_both > fraction(-374, 100), "{ratio_of_both}");
    }
}

#[test]
fn the_line_of_influence_is_that_of_a_support_that_sinks() {
    // Müller-Breslau: on each span a support's line of influence is the deflection of a beam, a cubic, straight beyond the
    // ends, with one slope and one curvature on both sides of each support and no curvature at the ends.
    let supports = [0, 2, 3, 7, 12].map(whole);
    let beam = beam(&supports);
    let line = |position: BigRational| parts(&beam, &position);
    // Value, slope and curvature at a support of the cubic through four points of the span on one side.
    let derivatives = |at: &BigRational, step: &BigRational, support: usize| {
        let y: Vec<_> = (0..4).map(|j| line(at + step * whole(j))[support].clone()).collect();
        let slope = (&y[1] * whole(18) - &y[0] * whole(11) - &y[2] * whole(9) + &y[3] * whole(2)) / (step * whole(6));
        let curvature = (&y[0] * whole(2) - &y[1] * whole(5) + &y[2] * whole(4) - &y[3]) / (step * step);
        (slope, curvature)
    };
    for support in 0..supports.len() {
        for (k, at) in supports.iter().enumerate() {
            let before = if k == 0 { whole(1) } else { at - &supports[k - 1] };
            let after = supports.get(k + 1).map_or(whole(1), |next| next - at);
            let (left, right) =
                (derivatives(at, &(-before / whole(3)), support), derivatives(at, &(after / whole(3)), support));
            assert_eq!(left, right, "support {support}, at {at}");
            assert_eq!(right.1.is_zero(), k == 0 || k == supports.len() - 1, "support {support}, at {at}");
        }
    }
}

#[test]
fn reactions_agree_with_the_direct_stiffness_method_to_twelve_digits_each() {
    let mut dice = Dice::new(4);
    // Spans of 1 and 10⁶ by turns, and random ones.
    let by_turns: Vec<_> = (0..10).map(|k| whole(k / 2 * 1_000_001 + k % 2)).collect();
    let positions = random_positions(&mut dice, &by_turns);
    for (supports, positions) in random_cases(5, 50).into_iter().chain([(by_turns, positions)]) {
        let beam = beam(&supports);
        // The overhung loads and the one on a support; within spans three, or all where there are fewer.
        let (within, special) = positions.split_at(supports.len() - 1);
        let first = dice.below(within.len() as u64) as usize;
        let some = within.iter().cycle().skip(first).step_by(within.len().div_ceil(3)).take(within.len().min(3));
        let chosen: Vec<_> = special.iter().chain(some).collect();
        let carried = stiffness::parts(&supports, &chosen);
        for (load, position) in chosen.into_iter().enumerate() {
            for (exact, others) in parts(&beam, position).iter().zip(&carried) {
                let (fixed, other) = (stiffness::fixed(exact), &others[load]);
                // A part that is zero has no digits: 10⁻¹⁰⁰ then.
                let most = if exact.is_zero() {
                    num_traits::pow(fraction(1, 10), 100)
                } else {
                    exact.abs() * fraction(1, TRILLION)
                };
                let difference = (fixed - other).abs();
                assert!(difference <= stiffness::fixed(&most), "{} spans, load at {position}: {exact}", within.len());
            }
        }
    }
}

#[test]
fn supports_and_loads_that_make_no_beam_are_told_with_what_would_be_right() {
    let message = |supports: Vec<BigRational>| Beam::new(supports).expect_err("no beam").to_string();
    assert_eq!(message(vec![]), "no support holds the beam: it needs two or more");
    assert_eq!(message(vec![whole(3)]), "1 support does not hold the beam: it needs two or more");
    let coinciding = vec![fraction(5, 2), whole(1), whole(0), fraction(10, 4)];
    assert_eq!(message(coinciding.clone()), "supports 1 and 4 are both at 5/2: each needs a position of its own");
    let mistake = BeamError::CoincidingSupports { first: 0, second: 3, at: fraction(5, 2) };
    assert_eq!(Beam::new(coinciding).expect_err("no beam"), mistake);
}
