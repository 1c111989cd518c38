//! Does a sum keep away from 0 on a box, or vanish once on it? Whole numbers decide, every rounding counted.
//!
//! About a point the sum `Σ C_j e^{iπ(m_j s + n_j t)}` stays within `½ Σ (|m_j| S + |n_j| T)² |C_j|` of `p + i(a σ + b τ)`, `|σ| ≤ S`,
//! `|τ| ≤ T`, with S and T the half-widths times π: a parallelogram, which the normal of a side, or p itself, keeps away from 0.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::spot::{BITS, ONE, Spot, length};
use super::torus::Torus;
use crate::exact::{PhasorSum, Term, Turn};

/// Boxes are halved this many times at most on each side.
pub(super) const FINEST: u32 = 16;

/// The sum over that of its weights, its exponents doubled and as large either way.
pub(super) struct Evaluator {
    terms: Vec<Vector>,
    /// `e^{2πi 2^−k}`, k from 0 on.
    halves: Vec<Spot>,
    /// A power of two above the exponents.
    shift: u32,
}

struct Vector {
    times: [i64; 2],
    vector: Spot,
    most: i128,
}

/// The value at a point, the derivatives by πs and πt, and the sizes of the vectors.
struct Jet {
    at: Spot,
    by: [Spot; 2],
}

impl Evaluator {
    pub fn new(torus: &Torus) -> Self {
        let total: BigRational = torus.sums.iter().flat_map(PhasorSum::terms).map(|term| term.weight.abs()).sum();
        let degrees = torus.degrees();
        let each = torus.exponents.iter().zip(&torus.sums).map(|(times, sum)| {
            let vector = Spot::of(&sum.scaled(&total.recip()));
            let times = [0, 1].map(|axis: usize| 2 * times[axis] - degrees[axis]);
            Vector { times, vector, most: vector.most() }
        });
        let halves = (0..=FINEST + 2).map(|k| unit(BigRational::new(BigInt::one(), BigInt::one() << k)));
        let shift = 64 - degrees[0].max(degrees[1]).leading_zeros();
        Evaluator { terms: each.collect(), halves: halves.collect(), shift }
    }

    /// `e^{2πi a / 2^(FINEST + 2)}`.
    fn turned(&self, numerator: i64) -> Spot {
        let finest = FINEST + 2;
        let digits = (0..finest).filter(|digit| (numerator >> digit) & 1 == 1);
        digits.fold(Spot::UNIT, |product, digit| product.times(self.halves[(finest - digit) as usize]))
    }

    fn jet(&self, turned: impl Fn([i64; 2]) -> Spot) -> Jet {
        let mut jet = Jet { at: Spot::ZERO, by: [Spot::ZERO; 2] };
        for Vector { times, vector, .. } in &self.terms {
            let vector = vector.times(turned(*times));
            jet.at = jet.at.plus(vector);
            for (by, times) in jet.by.iter_mut().zip(times) {
                *by = by.plus(vector.turned().times_whole(*times));
            }
        }
        jet
    }

    /// `Σ w_j (|m_j| S + |n_j| T) |C_j|`, w_j what else a term counts; `None` beyond some hundred.
    fn beyond(&self, [s, t]: [i128; 2], weight: impl Fn(i128, &Vector) -> i128) -> Option<i128> {
        let each = self.terms.iter().map(|vector| {
            let [m, n] = vector.times.map(|times| i128::from(times.abs()));
            let reach = m * s + n * t;
            (reach < 128 * ONE).then(|| (((((reach * vector.most) >> BITS) + 1) * weight(reach, vector)) >> BITS) + 1)
        });
        each.sum()
    }

    /// Whether the sum keeps away from 0 on the box about a middle, in units of `2^−(FINEST + 1)` of a turn, with half-widths
    /// `2^−h` of a turn.
    pub fn is_free(&self, middle: [i64; 2], halves: [u32; 2]) -> bool {
        // π < 355/113.
        let reach = halves.map(|half| ((ONE * 355 / 113) >> half) + 1);
        let Some(bend) = self.beyond(reach, |reach, _| reach).map(|double| double / 2 + 1) else { return false };
        if bend > ONE {
            return false;
        }
        let jet = self.jet(|[m, n]| self.turned(m * middle[0] + n * middle[1]));
        [jet.at, jet.by[0].turned(), jet.by[1].turned()].into_iter().any(|direction| {
            let [x, y] = direction.direction();
            let ahead = |spot: Spot| (spot.re * x + spot.im * y, (x.abs() + y.abs()) * spot.doubt);
            let (at, doubt) = ahead(jet.at);
            let sides: i128 = jet
                .by
                .iter()
                .zip(reach)
                .map(|(by, reach)| {
                    let (along, doubt) = ahead(*by);
                    (((along.abs() + doubt) * reach) >> BITS) + 1
                })
                .sum();
            at.abs() > spared(doubt + length(x, y) * bend + sides)
        })
    }

    /// Whether the box with this half-width about a point holds one zero alone: Krawczyk's test, multiplied by the determinant.
    ///
    /// `is_zero`: whether the middle is known to be a zero.
    pub fn holds_one(&self, middle: &[BigRational; 2], half: u32, is_zero: bool) -> bool {
        let jet = self.jet(|[m, n]| {
            let [m, n] = [m, n].map(|times| BigRational::new(times.into(), 2.into()));
            unit(&middle[0] * m + &middle[1] * n)
        });
        let at = if is_zero { Spot::ZERO } else { jet.at };
        let [a, b] = jet.by.map(|by| by.over(self.shift));
        // 333/106 < π < 355/113; what the derivatives lost by the shift the half-widths gain.
        let [least, most] = [ONE * 333 / 106 - 1, ONE * 355 / 113 + 1].map(|pi| (pi << self.shift) >> half);
        let reach = ((ONE * 355 / 113) >> half) + 1;
        let deviations = [(0, a), (1, b)].map(|(axis, by): (usize, Spot)| {
            let bend = self.beyond([reach; 2], |_, vector| i128::from(vector.times[axis].abs()) * ONE)?;
            Some((bend >> self.shift) + 1 + 2 * by.doubt)
        });
        let [Some(by_a), Some(by_b)] = deviations else { return false };
        let determinant = (a.re * b.im - a.im * b.re).abs();
        [[b.im, -b.re], [-a.im, a.re]].into_iter().all(|[x, y]| {
            let off = (x * at.re + y * at.im).abs() + (x.abs() + y.abs()) * at.doubt;
            let spread = ((length(x, y) * (by_a + by_b)) >> BITS) + 1;
            spared(off + spread * (most + 1)) < (determinant >> BITS) * least
        })
    }
}

/// Somewhat more: another enclosure shows the same, however it is rounded.
fn spared(bound: i128) -> i128 {
    bound + (bound >> 6)
}

/// `e^{2πi turn}`.
fn unit(turn: BigRational) -> Spot {
    Spot::of(&PhasorSum::new(vec![Term { angle: Turn::new(turn), weight: BigRational::one() }]))
}

/// The rational number next to a decimal, with few digits.
pub(super) fn dyadic(turns: f64) -> BigRational {
    let (units, turn) = ((1_i64 << 44) as f64, BigInt::one() << 44);
    let numerator = BigInt::from((turns * units).round().to_i64().unwrap_or(0));
    BigRational::new(numerator.mod_floor(&turn), turn)
}
