//! How much can the orders above the K-th of one piston add, at most?
//!
//! Let `c_k = [k=1] + (−i)^k g_k`. The g_k have one sign at the dead point where they all add up, so that
//! `Σ_{k≥1} |g_k| = s/√(1−s²)`, `s = λ + |δ|`, the acceleration of the rod there; what the first K leave of that bounds the rest.
//!
//! Besides, the k-th harmonic of the root is at most `t^k/(1−t²)`, `t = λ/(1−|δ| + √((1−|δ|)²−λ²))`, from `|h_j| ≤ t^j` (as in the
//! series of an offset crank, whose factor `½√((A+R)(B+S))` is at most 1), and `|g_k|` is `2k²/λ` times it. From one term to the next this
//! falls at least by `t ((K+2)/(K+1))²`: a geometric series, which is small where the difference drowns in its roundings.
//!
//! Torque: its n-th harmonic is `n (−i)^n (X − iY)`, where `|X| ≤ ½ (|g_{n−1}|/(n−1) + |g_{n+1}|/(n+1))`, and
//! `|Y| ≤ (R p^n + S q^n)/(2λ²)` for n > 2 with `R = √((1+δ)²−λ²)`, `p = λ/(1+δ+R)`, and S, q the same of −δ. The first part is
//! summed over the rest of the g_k, the second as a geometric series.
//!
//! Side force: its part `|u_k|` is at most `¼ (h_k(p, R) + h_k(q, S))`, `h_k(p, R) = p^{k−1} ((k+1) − (k−1) p²)/R`, for k > 1, whose
//! sum over k > K telescopes to `(p^K (K+2) + p^{K+1} (K+3) + 4 p^{K+2}/(1−p))/R`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::crank::SliderCrank;
use super::enclosure::{Coefficient, Enclosure, float};

/// Floats of a bound are enlarged by this part of it, far more than they are rounded by.
pub const SLACK: f64 = 1.0 + 1e-9;

/// Bounds of what the higher orders of a crank add, in multiples of m r ω² for the force, of m r² ω² for the torque.
#[derive(Clone, Debug)]
pub struct Tail {
    /// `Σ_{i>k} |g_i|` at most, at place k, by the difference.
    differences: Vec<f64>,
    ratio: f64,
    /// `1 ± δ` with its root: the gap `1 ± δ − λ` decides near the end of the reach.
    reaches: [Reach; 2],
}

#[derive(Clone, Copy, Debug)]
struct Reach {
    /// `A + R`.
    sum: f64,
    /// `R`.
    root: f64,
    /// `A − λ + R`.
    gap: f64,
}

impl Tail {
    /// Of a crank, from the sum of all coefficients and the geometric series alone.
    pub fn new(crank: &SliderCrank) -> Self {
        let one = BigRational::one();
        let reach = |sign: BigRational| {
            let reach = &one + sign * crank.offset();
            let root = float(&((&reach - crank.ratio()) * (&reach + crank.ratio()))).sqrt();
            Reach { sum: float(&reach) + root, root, gap: float(&(&reach - crank.ratio())) + root }
        };
        let whole = dead_point(&(crank.ratio() + crank.offset().abs()));
        Tail {
            differences: vec![rounded_up(&whole)],
            ratio: float(crank.ratio()),
            reaches: [reach(one.clone()), reach(-&one)],
        }
    }

    /// The same with the differences up to the highest order, from its coefficients.
    pub fn with_coefficients(crank: &SliderCrank, coefficients: &[Coefficient]) -> Self {
        let mut tail = Tail::new(crank);
        let mut rest = dead_point(&(crank.ratio() + crank.offset().abs()));
        for (c, order) in coefficients.iter().zip(1_u32..) {
            let one = if order == 1 { BigRational::one() } else { BigRational::zero() };
            let re = Enclosure { low: &c.re.low - &one, high: &c.re.high - &one };
            // One of both parts is zero.
            rest -= re.smallest().max(c.im.smallest());
            tail.differences.push(rounded_up(&rest));
        }
        tail
    }

    /// `Σ_{k>K} |c_k − [k=1]|` at most; 0 only where no order is above.
    pub fn force(&self, order: u32) -> f64 {
        if self.ratio == 0.0 && order > 0 {
            return 0.0;
        }
        let last = self.differences.len() - 1;
        let difference = self.differences[last.min(order as usize)];
        difference.min(self.geometric(order) * SLACK).max(f64::MIN_POSITIVE)
    }

    /// The amplitudes of all orders of the torque above this one, of at least 2, at most; 0 only where none is above.
    pub fn torque(&self, order: u32) -> f64 {
        if self.ratio == 0.0 {
            return 0.0;
        }
        let k = f64::from(order);
        let rod_part = (k + 1.0) / k * self.force(order - 1) + self.force(order + 1);
        let elementary = self.reaches.map(|reach| self.elementary(reach, order)).iter().sum::<f64>();
        ((rod_part / 2.0 + elementary) * SLACK).max(f64::MIN_POSITIVE)
    }

    /// What all orders of the load of a crankpin above this one, of at least 1, add at most: `Σ_{k>K} |c_k| + |u_k|`, where `½|c_k − n_k| +
    /// ½|c_k + n_k|` is no larger.
    pub fn pin(&self, order: u32) -> f64 {
        if self.ratio == 0.0 {
            return 0.0;
        }
        let side = self.reaches.map(|reach| self.side(reach, order)).iter().sum::<f64>();
        ((self.force(order) + side) * SLACK).max(f64::MIN_POSITIVE)
    }

    /// `¼ Σ_{k>K} h_k`.
    fn side(&self, Reach { sum, root, gap }: Reach, order: u32) -> f64 {
        let (k, p) = (f64::from(order), self.ratio / sum);
        // 1 − p without cancellation.
        let short = gap / sum;
        p.powf(k) * ((k + 2.0) + p * (k + 3.0) + 4.0 * p * p / short) / (4.0 * root)
    }

    /// By the geometric series; infinite where its terms may still grow.
    fn geometric(&self, order: u32) -> f64 {
        let k = f64::from(order);
        let sum = self.reaches[0].sum.min(self.reaches[1].sum);
        let gap = self.reaches[0].gap.min(self.reaches[1].gap);
        let (fall, short) = (self.ratio / sum, gap / sum);
        let growth = ((k + 2.0) / (k + 1.0)).powi(2);
        let quotient = fall * growth;
        if quotient >= 1.0 {
            return f64::INFINITY;
        }
        // 1 − t² = (1 − t)(1 + t), without cancellation; 2/λ t^{k+1} = 2 t^k/(A + R).
        let first = 2.0 * (k + 1.0).powi(2) / sum * fall.powf(k) / (short * (1.0 + fall));
        first / (1.0 - quotient)
    }

    /// `Σ_{n>K} n R p^n/(2λ²)`.
    fn elementary(&self, Reach { sum, root, gap }: Reach, order: u32) -> f64 {
        let (k, p) = (f64::from(order), self.ratio / sum);
        // 1 − p without cancellation.
        let short = gap / sum;
        root * p.powf(k - 1.0) * ((k + 1.0) - k * p) / (short * short) / (sum * sum) / 2.0
    }
}

/// The float at or above a number that is not negative.
fn rounded_up(number: &BigRational) -> f64 {
    float(number).next_up()
}

/// `s/√(1−s²)`, rounded up.
fn dead_point(reach: &BigRational) -> BigRational {
    let square = reach * reach;
    let quotient = &square / (BigRational::one() - &square);
    let bits = 256_u32;
    let root = ((quotient.numer() << (2 * bits)) / quotient.denom() + 1_u32).sqrt() + 1_u32;
    BigRational::new(root, BigInt::one() << bits)
}
