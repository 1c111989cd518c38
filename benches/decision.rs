//! What does a verdict cost, what does its certificate add, and does the denominator matter?
//!
//! `cargo bench -p benches --bench decision`. The 28 sums are those of the cross-plane V8: orders 1, 2, 4, 6, 8, 10, 12; force and
//! moment; direct and reverse. Each line times all 28: divide by 28 for one decision.

#[path = "../tests/suite/support/oracle.rs"]
mod oracle;

use crankstar::engine::Engine;
use crankstar::exact::{PhasorSum, Term, vanishes};
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const ORDERS: [u32; 7] = [1, 2, 4, 6, 8, 10, 12];

fn cross_plane_v8() -> Engine {
    crankstar::file::find("V8-crossplane").expect("in the catalogue").engine().expect("reads")
}

fn sums() -> Vec<PhasorSum> {
    let v8 = cross_plane_v8();
    let senses = [Some(Sense::Direct), Some(Sense::Reverse)];
    let quantities = [Quantity::FORCE, Quantity::MOMENT];
    let choices = ORDERS.iter().flat_map(|&order| quantities.map(|quantity| (order, quantity)));
    choices.flat_map(|(order, quantity)| senses.map(|sense| order::star(&v8, quantity, order, sense))).collect()
}

/// All eight terms as whole exponents over the conductor 8 with whole weights, not collected.
fn exponents(sum: &PhasorSum) -> Vec<(u64, i64)> {
    let whole = |term: &Term| {
        let exponent = (term.angle.turns() * num_rational::BigRational::from_integer(8.into())).to_integer();
        let weight = (&term.weight * num_rational::BigRational::from_integer(2.into())).to_integer();
        (u64::try_from(exponent).expect("small"), i64::try_from(weight).expect("small"))
    };
    sum.terms().iter().map(whole).collect()
}

#[divan::bench]
fn a_verdict_from_exponents(bencher: Bencher) {
    let sums: Vec<_> = sums().iter().map(exponents).collect();
    bencher.bench_local(|| sums.iter().filter(|terms| vanishes(black_box(&8_u64), black_box(terms))).count());
}

#[divan::bench]
fn b_oracle_reduction_modulo_cyclotomic_polynomial(bencher: Bencher) {
    let sums: Vec<_> = sums().iter().map(exponents).collect();
    let cyclotomic = oracle::cyclotomic(8);
    bencher.bench_local(|| {
        sums.iter().filter(|terms| oracle::vanishes(black_box(8), &cyclotomic, black_box(terms))).count()
    });
}

#[divan::bench]
fn c_verdict_from_rational_angles(bencher: Bencher) {
    let sums = sums();
    bencher.bench_local(|| sums.iter().filter(|sum| black_box(*sum).vanishes()).count());
}

#[divan::bench]
fn d_verdict_and_certificate(bencher: Bencher) {
    let sums = sums();
    bencher.bench_local(|| sums.iter().filter(|sum| black_box(*sum).certificate().claims_zero()).count());
}

/// A vanishing sum of eight terms: a square, and a square turned by one part of the denominator.
#[divan::bench(args = [360, 1_000_000_007])]
fn e_two_squares_over_denominator(bencher: Bencher, denominator: u64) {
    let conductor = if denominator.is_multiple_of(4) { denominator } else { 4 * denominator };
    let corner = |j: u64| j * conductor / 4;
    let turn = conductor / denominator;
    let terms: Vec<(u64, i64)> = (0..4).flat_map(|j| [(corner(j), 3), (corner(j) + turn, 5)]).collect();
    assert!(vanishes(&conductor, &terms));
    bencher.bench_local(|| vanishes(black_box(&conductor), black_box(&terms)));
}

/// A sum of eight terms at scattered angles, which is not zero.
#[divan::bench(args = [360, 1_000_000_007])]
fn f_scattered_over_denominator(bencher: Bencher, denominator: u64) {
    let terms: Vec<(u64, i64)> = (0..8).map(|j| ((j * j * denominator / 53) % denominator, 1)).collect();
    assert!(!vanishes(&denominator, &terms));
    bencher.bench_local(|| vanishes(black_box(&denominator), black_box(&terms)));
}

/// The two squares over 360 by the oracle: dense reduction grows with the conductor, and needs its polynomial.
#[divan::bench]
fn g_oracle_two_squares_over_360(bencher: Bencher) {
    let terms: Vec<(u64, i64)> = (0..4).flat_map(|j| [(90 * j, 3), (90 * j + 1, 5)]).collect();
    let cyclotomic = oracle::cyclotomic(360);
    bencher.bench_local(|| oracle::vanishes(black_box(360), &cyclotomic, black_box(&terms)));
}
