//! What does one line of influence coefficients cost, and what does it save to eliminate once, in whole numbers?
//!
//! `cargo bench -p benches --bench beam`. Three beams: equal spans; spans of whole millimetres; spans with denominators up to 30, for
//! which all lengths are long whole numbers.

use crankstar::beam::Beam;
use divan::{Bencher, black_box};
use num_rational::BigRational;
use num_traits::{One, Zero};

fn main() {
    divan::main();
}

const BEAMS: [(&str, usize); 6] =
    [("equal", 4), ("millimetres", 4), ("fractions", 4), ("equal", 50), ("millimetres", 50), ("fractions", 50)];

fn ratio(numerator: usize, denominator: usize) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// Supports of one of these beams, and a load in its middle span.
fn supports((kind, spans): (&str, usize)) -> (Vec<BigRational>, BigRational) {
    let length = |k: usize| match kind {
        "equal" => ratio(1, 1),
        "millimetres" => ratio(90 + k * k * 7 % 41, 1),
        _ => ratio(90 + k * k * 7 % 41, 1 + k * 11 % 30),
    };
    let mut supports = vec![BigRational::zero()];
    for k in 0..spans {
        supports.push(&supports[k] + length(k));
    }
    let load = (&supports[spans / 2] * ratio(2, 1) + &supports[spans / 2 - 1]) / ratio(3, 1);
    (supports, load)
}

/// The three-moment equations by the algorithm of Thomas in fractions, anew for the load.
fn moments_in_fractions(supports: &[BigRational], load: &BigRational) -> Vec<BigRational> {
    let lengths: Vec<_> = supports.windows(2).map(|ends| &ends[1] - &ends[0]).collect();
    let (mut factors, mut sides) = (vec![BigRational::zero()], vec![BigRational::zero()]);
    for k in 1..lengths.len() {
        let (l, next) = (&lengths[k - 1], &lengths[k]);
        let side = if *load > supports[k - 1] && *load < supports[k] {
            let a = load - &supports[k - 1];
            -(&a * (l * l - &a * &a) / l)
        } else if *load > supports[k] && *load < supports[k + 1] {
            let b = &supports[k + 1] - load;
            -(&b * (next * next - &b * &b) / next)
        } else {
            BigRational::zero()
        };
        let pivot = (l + next) * ratio(2, 1) - l * &factors[k - 1];
        sides.push((side - l * &sides[k - 1]) / &pivot);
        factors.push(next / pivot);
    }
    let mut moments = vec![BigRational::zero()];
    for k in (1..lengths.len()).rev() {
        let moment = &sides[k] - &factors[k] * &moments[moments.len() - 1];
        moments.push(moment);
    }
    moments
}

#[divan::bench(args = BEAMS)]
fn a_parts_of_one_load(bencher: Bencher, beam: (&str, usize)) {
    let (supports, load) = supports(beam);
    let beam = Beam::new(supports).expect("a beam");
    assert!(beam.influence(&load).iter().sum::<BigRational>().is_one());
    bencher.bench_local(|| beam.influence(black_box(&load)));
}

#[divan::bench(args = BEAMS)]
fn b_beam_eliminated(bencher: Bencher, beam: (&str, usize)) {
    let (supports, _) = supports(beam);
    bencher.with_inputs(|| supports.clone()).bench_local_values(Beam::new);
}

#[divan::bench(args = BEAMS)]
fn c_moments_alone_in_fractions(bencher: Bencher, beam: (&str, usize)) {
    let (supports, load) = supports(beam);
    bencher.bench_local(|| moments_in_fractions(black_box(&supports), black_box(&load)));
}
