//! How many crank stars are judged in a second and core, and what does the bound save?
//!
//! `cargo bench -p benches --bench search`. All lines find the front of orders 1 and 2 of in-line two-stroke engines on one core. The
//! rates count all stars with cylinder 1 at 0, whether judged one by one or left out by symmetry and bound. The baselines, in the
//! same run: the plain loop over all permutations in floats, with a tolerance, which proves nothing; and the same loop with the
//! decision procedure called star by star.

#![allow(clippy::disallowed_types)]

use std::cmp::Ordering;

use crankstar::engine::Cycle;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::numbers;
use crankstar::search::{Options, Problem, every_value, search};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use num_rational::BigRational;

fn main() {
    divan::main();
}

fn problem(cylinders: u32) -> Problem {
    Problem::inline(cylinders, Cycle::TwoStroke, &[1, 2])
}

fn stars(cylinders: u32) -> ItemsCount {
    ItemsCount::new((1..u64::from(cylinders)).product::<u64>())
}

/// The search with its bound.
#[divan::bench(args = [6, 7, 8, 9, 10, 11, 12], sample_count = 10)]
fn a_search(bencher: Bencher, cylinders: u32) {
    let options = || Options { threads: 1, ..Options::default() };
    bencher.counter(stars(cylinders)).bench_local(|| search(black_box(&problem(cylinders)), &options()));
}

/// Every star up to symmetry, each value found and kept, ties decided.
#[divan::bench(args = [6, 7, 8], sample_count = 10)]
fn b_every_value(bencher: Bencher, cylinders: u32) {
    bencher.counter(stars(cylinders)).bench_local(|| every_value(black_box(&problem(cylinders))));
}

/// The plain loop in floats: two sums a star, compared with a tolerance.
#[divan::bench(args = [7, 8, 9, 10], sample_count = 10)]
fn c_plain_loop_in_floats(bencher: Bencher, cylinders: u32) {
    let count = cylinders as usize;
    let vectors: Vec<(f64, f64)> = (0..count)
        .map(|throw| {
            let angle = std::f64::consts::TAU * throw as f64 / count as f64;
            (angle.cos(), angle.sin())
        })
        .collect();
    let square = |throws: &[usize], order: usize| {
        let (mut x, mut y) = (0.0, 0.0);
        for (place, throw) in throws.iter().enumerate() {
            let (cos, sin) = vectors[order * throw % count];
            let arm = (count - 1) as f64 / 2.0 - place as f64;
            (x, y) = (x + arm * cos, y + arm * sin);
        }
        x * x + y * y
    };
    let compare = |a: &f64, b: &f64| if (a - b).abs() < 1e-9 { Ordering::Equal } else { a.total_cmp(b) };
    bencher
        .counter(stars(cylinders))
        .bench_local(|| plain_front(black_box(count), |throws| [1, 2].map(|order| square(throws, order)), compare));
}

/// The plain loop, every value exact and every comparison decided.
#[divan::bench(args = [6, 7], sample_count = 3)]
fn d_plain_loop_decided_star_by_star(bencher: Bencher, cylinders: u32) {
    let compare = |one: &PhasorSum, other: &PhasorSum| {
        let difference = one.minus(other);
        if difference.vanishes() { Ordering::Equal } else { numbers::evaluate(&difference).re.total_cmp(&0.0) }
    };
    bencher.counter(stars(cylinders)).bench_local(|| {
        plain_front(black_box(cylinders as usize), |throws| [1, 2].map(|order| exact_square(throws, order)), compare)
    });
}

fn exact_square(throws: &[usize], order: i64) -> PhasorSum {
    let count = throws.len() as i64;
    let term = |(place, &throw): (usize, &usize)| Term {
        angle: Turn::fraction(order * throw as i64, count),
        weight: BigRational::new((count - 1 - 2 * place as i64).into(), 2.into()),
    };
    PhasorSum::new(throws.iter().enumerate().map(term).collect()).squared_modulus()
}

/// Number of distinct values on the front.
fn plain_front<T>(
    cylinders: usize,
    squares: impl Fn(&[usize]) -> [T; 2],
    compare: impl Fn(&T, &T) -> Ordering,
) -> usize {
    let mut front: Vec<[T; 2]> = Vec::new();
    let mut throws: Vec<usize> = (0..cylinders).collect();
    permute(&mut throws, 1, &mut |throws| {
        let star = squares(throws);
        let signs = |other: &[T; 2]| [0, 1].map(|at| compare(&other[at], &star[at]));
        if front.iter().any(|other| signs(other).iter().all(|sign| sign.is_le())) {
            return;
        }
        front.retain(|other| !signs(other).iter().all(|sign| sign.is_ge()));
        front.push(star);
    });
    front.len()
}

fn permute(throws: &mut Vec<usize>, from: usize, visit: &mut impl FnMut(&[usize])) {
    if from == throws.len() {
        return visit(throws);
    }
    for other in from..throws.len() {
        throws.swap(from, other);
        permute(throws, from + 1, visit);
        throws.swap(from, other);
    }
}
