//! How many crank stars are judged in a second and core, and what does the bound save?
//!
//! `cargo bench --bench search`. All lines find the exact front of orders 1 and 2 of in-line two-stroke engines on one core. The
//! rates count all stars with cylinder 1 at 0, whether judged one by one or left out by symmetry and bound. The baseline, in
//! the same run, is the plain loop over all permutations: each star a sum of rotating vectors, squared, and compared with a front
//! by the decision procedure, called star by star.

#![allow(clippy::disallowed_types)]

use std::cmp::Ordering;

use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::layout::Cycle;
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

/// The plain loop, with decimals first and the decision procedure where they are close.
#[divan::bench(args = [6, 7, 8], sample_count = 3)]
fn c_plain_loop_with_decimals_first(bencher: Bencher, cylinders: u32) {
    bencher.counter(stars(cylinders)).bench_local(|| plain_front(black_box(cylinders as usize), true));
}

/// The plain loop, every comparison by the decision procedure.
#[divan::bench(args = [6, 7], sample_count = 3)]
fn d_plain_loop_decided_star_by_star(bencher: Bencher, cylinders: u32) {
    bencher.counter(stars(cylinders)).bench_local(|| plain_front(black_box(cylinders as usize), false));
}

struct Square {
    exact: PhasorSum,
    decimal: f64,
}

impl Square {
    fn new(throws: &[usize], order: i64) -> Self {
        let count = throws.len() as i64;
        let term = |(place, &throw): (usize, &usize)| Term {
            angle: Turn::fraction(order * throw as i64, count),
            weight: BigRational::new((count - 1 - 2 * place as i64).into(), 2.into()),
        };
        let exact = PhasorSum::new(throws.iter().enumerate().map(term).collect()).squared_modulus();
        let turn = |term: &Term| std::f64::consts::TAU * to_float(term.angle.turns());
        let decimal = exact.terms().iter().map(|term| to_float(&term.weight) * turn(term).cos()).sum();
        Square { exact, decimal }
    }

    fn compare(&self, other: &Square, decimals_first: bool) -> Ordering {
        if decimals_first && (self.decimal - other.decimal).abs() > 1e-6 {
            return self.decimal.total_cmp(&other.decimal);
        }
        let difference = self.exact.minus(&other.exact);
        if difference.vanishes() { Ordering::Equal } else { numbers::evaluate(&difference).re.total_cmp(&0.0) }
    }
}

fn to_float(number: &BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(number).unwrap_or(f64::NAN)
}

/// Number of distinct values on the front.
fn plain_front(cylinders: usize, decimals_first: bool) -> usize {
    let mut front: Vec<[Square; 2]> = Vec::new();
    let mut throws: Vec<usize> = (0..cylinders).collect();
    permute(&mut throws, 1, &mut |throws| {
        let star = [Square::new(throws, 1), Square::new(throws, 2)];
        let sign = |other: &[Square; 2]| {
            let signs = [0, 1].map(|at| other[at].compare(&star[at], decimals_first));
            (signs.iter().all(|sign| sign.is_le()), signs.iter().all(|sign| sign.is_ge()))
        };
        let signs: Vec<(bool, bool)> = front.iter().map(sign).collect();
        if signs.iter().any(|(no_worse, _)| *no_worse) {
            return;
        }
        let mut kept = signs.iter().map(|(_, beaten)| !beaten);
        front.retain(|_| kept.next().unwrap_or(true));
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
