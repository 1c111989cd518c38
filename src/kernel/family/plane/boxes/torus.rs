//! Which polynomial in two unknowns are the parts of a sum, and does it vanish at rational turns?

use std::f64::consts::TAU;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::super::super::part::Part;
use crate::exact::{PhasorSum, Turn, fraction};
use crate::numbers;

/// s and t may enter this many times.
const HIGHEST_TIMES: i64 = 200;
/// Denominators of rational turns that decimals propose.
const LARGEST_DENOMINATOR: i64 = 20_000;
const NEWTON_STEPS: usize = 40;

/// `Σ_j S_j e^{i(m_j s + n_j t)}`, up to a factor on the circle.
pub(super) struct Torus {
    /// How many times φ enters s, and δ enters t.
    pub times: [BigRational; 2],
    /// `[m_j, n_j]`, the least of each 0.
    pub exponents: Vec<[i64; 2]>,
    /// `S_j`.
    pub sums: Vec<PhasorSum>,
    decimals: Vec<Complex<f64>>,
}

impl Torus {
    pub fn of(parts: &[&Part]) -> Option<Self> {
        let [(phi, m), (delta, n)] = [along(parts, 0)?, along(parts, 1)?];
        let sums: Vec<PhasorSum> = parts.iter().map(|part| part.sum.tidied()).collect();
        let total: BigRational = sums.iter().flat_map(PhasorSum::terms).map(|term| term.weight.abs()).sum();
        let decimals = sums.iter().map(|sum| numbers::evaluate(sum) / numbers::float(&total)).collect();
        let exponents = m.into_iter().zip(n).map(|(m, n)| [m, n]).collect();
        Some(Torus { times: [phi, delta], exponents, sums, decimals })
    }

    /// The highest exponents.
    pub fn degrees(&self) -> [i64; 2] {
        [0, 1].map(|axis| self.exponents.iter().map(|times| times[axis]).max().unwrap_or(0))
    }

    /// The sum at a point.
    pub fn at(&self, [s, t]: &[BigRational; 2]) -> PhasorSum {
        let turned = self.exponents.iter().zip(&self.sums).flat_map(|([m, n], sum)| {
            let [m, n] = [*m, *n].map(|times| BigRational::from_integer(times.into()));
            sum.turned(&Turn::new(s * m + t * n)).terms().to_vec()
        });
        PhasorSum::new(turned.collect()).tidied()
    }

    /// Where Newton's method ends from a point, in turns.
    pub fn newton(&self, [mut s, mut t]: [f64; 2]) -> Option<[f64; 2]> {
        for _ in 0..NEWTON_STEPS {
            let none = Complex::new(0.0, 0.0);
            let (mut value, mut by_s, mut by_t) = (none, none, none);
            for ([m, n], vector) in self.exponents.iter().zip(&self.decimals) {
                let [m, n] = [*m as f64, *n as f64];
                let (sin, cos) = libm::sincos(TAU * (m * s + n * t).fract());
                let turned = vector * Complex::new(cos, sin);
                value += turned;
                by_s += turned * Complex::new(0.0, TAU * m);
                by_t += turned * Complex::new(0.0, TAU * n);
            }
            let determinant = (by_s.conj() * by_t).im;
            let [ds, dt] = [(value.conj() * by_t).im / determinant, (by_s.conj() * value).im / determinant];
            if !(ds.is_finite() && dt.is_finite()) || ds.abs() + dt.abs() > 0.5 {
                return None;
            }
            (s, t) = (s - ds, t - dt);
            if ds.abs() + dt.abs() < 1e-15 {
                return Some([s, t]);
            }
        }
        None
    }

    /// A rational point next to a zero in decimals at which the sum vanishes exactly.
    pub fn rational(&self, near: [f64; 2]) -> Option<[BigRational; 2]> {
        let [s, t] = near.map(|turns| simplest(turns.rem_euclid(1.0)));
        let at = [s?, t?];
        self.at(&at).vanishes().then_some(at)
    }
}

/// The whole multiples of one axis' unit by which the parts are turned, and the unit.
fn along(parts: &[&Part], axis: usize) -> Option<(BigRational, Vec<i64>)> {
    let of = |part: &&Part| if axis == 0 { part.phi.clone() } else { part.delta.clone() };
    let least = parts.iter().map(of).min()?;
    let apart: Vec<BigRational> = parts.iter().map(|part| of(part) - &least).collect();
    let unit = fraction::common_unit(&apart);
    if unit.is_zero() {
        return None;
    }
    let whole = |times: &BigRational| (times / &unit).to_integer().to_i64().filter(|times| *times <= HIGHEST_TIMES);
    let exponents = apart.iter().map(whole).collect::<Option<_>>()?;
    Some((unit, exponents))
}

/// The simplest fraction within the digits of a decimal.
fn simplest(turns: f64) -> Option<BigRational> {
    let (mut rest, mut before, mut last) = (turns, [0, 1], [1, 0]);
    for _ in 0..20 {
        let whole = rest.floor();
        let next = [0, 1].map(|at: usize| (whole as i64).saturating_mul(last[at]).saturating_add(before[at]));
        (before, last) = (last, next);
        if last[1] > LARGEST_DENOMINATOR {
            return None;
        }
        if (last[0] as f64 / last[1] as f64 - turns).abs() < 1e-12 {
            let turns = BigRational::new(last[0].into(), last[1].into());
            return Some(&turns - turns.floor());
        }
        rest = (rest - whole).recip();
        if !rest.is_finite() || rest > 1e13 {
            return None;
        }
    }
    None
}
