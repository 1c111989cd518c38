//! At which rational turns does the sum vanish? Decimals propose, exact sums decide.
//!
//! The theory names finitely many candidates, multiples of 1/L. Near minima of the length, found by Newton's method, the nearest is
//! tried; what decimals overlook is found by the arcs, which end only where such a candidate is tried.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::polynomial::Polynomial;
use crate::exact::Turn;
use crate::numbers;

/// Points of the circle to a degree.
const POINTS: i64 = 8;
const NEWTON_STEPS: usize = 40;
/// In turns: a double zero is known to half of the digits.
const NEAR: f64 = 1e-6;
/// Of the sum of all weights.
const SMALL: f64 = 1e-6;

/// Zeros that are rational turns, with how many times each is one, and places near which a zero may be, in turns.
pub(super) struct Proposed {
    pub rational: BTreeMap<Turn, u32>,
    pub places: Vec<f64>,
}

/// Looks for zeros.
pub(super) fn propose(polynomial: &Polynomial) -> Proposed {
    let decimals = Decimals::of(polynomial);
    let places = decimals.places();
    let moduli: Vec<f64> = polynomial.moduli().iter().filter_map(BigInt::to_f64).collect();
    let mut rational = BTreeMap::new();
    for place in &places {
        for modulus in &moduli {
            let numerator = (place * modulus).round();
            if ((numerator / modulus) - place).abs() > NEAR {
                continue;
            }
            let Some((numerator, modulus)) = numerator.to_i64().zip(modulus.to_i64()) else { continue };
            let candidate = Turn::fraction(numerator, modulus);
            if rational.contains_key(&candidate) {
                continue;
            }
            if let Some(times) = multiplicity(polynomial, candidate.turns()) {
                rational.insert(candidate, times);
            }
        }
    }
    Proposed { rational, places }
}

/// How many times a rational turn is a zero; `None` where it is none.
pub(super) fn multiplicity(polynomial: &Polynomial, at: &BigRational) -> Option<u32> {
    // k terms vanish k − 1 times at most: their derivatives form a Vandermonde system.
    let times = (0..polynomial.sums.len() as u32).find(|&i| !polynomial.derivative(i, at).vanishes())?;
    (times > 0).then_some(times)
}

/// The polynomial in decimals, over the sum of all weights.
struct Decimals {
    terms: Vec<(f64, Complex<f64>)>,
    degree: i64,
}

impl Decimals {
    fn of(polynomial: &Polynomial) -> Self {
        let total = numbers::float(&polynomial.total());
        let exponents = polynomial.exponents.iter().map(|&exponent| exponent as f64);
        let terms = exponents.zip(polynomial.sums.iter().map(|sum| numbers::evaluate(sum) / total)).collect();
        Decimals { terms, degree: polynomial.degree() }
    }

    /// The value at a turn, and the derivative by turns.
    fn at(&self, turns: f64) -> (Complex<f64>, Complex<f64>) {
        let none = Complex::new(0.0, 0.0);
        self.terms.iter().fold((none, none), |(value, slope), (exponent, vector)| {
            let (sin, cos) = libm::sincos(TAU * (turns * exponent).fract());
            let turned = vector * Complex::new(cos, sin);
            (value + turned, slope + turned * Complex::new(0.0, TAU * exponent))
        })
    }

    /// Where Newton's method ends near 0.
    fn places(&self) -> Vec<f64> {
        let count = (POINTS * self.degree).max(64);
        let grid: Vec<f64> = (0..count).map(|at| at as f64 / count as f64).collect();
        let lengths: Vec<f64> = grid.iter().map(|at| self.at(*at).0.norm_sqr()).collect();
        let last = lengths.len() - 1;
        let is_least = |at: &usize| {
            let neighbours = [if *at == 0 { last } else { at - 1 }, if *at == last { 0 } else { at + 1 }];
            neighbours.iter().all(|other| lengths[*at] <= lengths[*other])
        };
        let mut found: Vec<f64> = Vec::new();
        for at in (0..=last).filter(is_least) {
            let ended = self.newton(grid[at]);
            let apart = |other: &f64| (other - ended).abs().min(1.0 - (other - ended).abs());
            if self.at(ended).0.norm() < SMALL && found.iter().all(|other| apart(other) > NEAR) {
                found.push(ended);
            }
        }
        found.sort_by(f64::total_cmp);
        found
    }

    fn newton(&self, start: f64) -> f64 {
        let mut at = start;
        for _ in 0..NEWTON_STEPS {
            let (value, slope) = self.at(at);
            let step = (value * slope.conj()).re / slope.norm_sqr();
            if !step.is_finite() || step.abs() < 1e-17 {
                break;
            }
            at -= step.clamp(-0.01, 0.01);
        }
        at.rem_euclid(1.0)
    }
}
