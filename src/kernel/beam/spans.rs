//! Which moments bend a continuous beam over its supports, and which forces do they leave there?
//!
//! Over supports 0 … n with spans `l_1 … l_n` between them the three-moment equations (Clapeyron; theory, section 8) are
//! `l_k M_{k−1} + 2(l_k + l_{k+1}) M_k + l_{k+1} M_{k+1} = r_k` for 0 < k < n, a tridiagonal system. It is eliminated from
//! both ends once for all loads (the algorithm of Thomas, without its divisions, so that whole numbers stay whole). The
//! diagonal is twice the sum of its neighbours in every row, so no pivot vanishes: `left_{k+1} > l_{k+1} left_k > 0`.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::load::Load;

/// The spans of a beam, whole numbers, with the elimination of its three-moment equations.
#[derive(Clone, Debug)]
pub(super) struct Spans {
    /// Span k joins the supports k and k + 1.
    lengths: Vec<BigInt>,
    /// Determinants of the equations at supports 1 … k − 1: 0, 1, `2(l_1 + l_2)`, …; the last is that of all.
    left: Vec<BigInt>,
    /// Determinants of the equations at supports k + 1 … n − 1: …, `2(l_{n−1} + l_n)`, 1, 0.
    right: Vec<BigInt>,
    /// The least common multiple of the lengths.
    multiple: BigInt,
}

/// The greatest length of which all these are whole multiples; not all are zero.
pub(super) fn common_unit(lengths: &[BigRational]) -> BigRational {
    let multiple = lengths.iter().fold(BigInt::one(), |all, length| all.lcm(length.denom()));
    let divisor = lengths.iter().fold(BigInt::zero(), |all, length| all.gcd(length.numer()));
    BigRational::new(divisor, multiple)
}

/// `D_0 = 0, D_1 = 1, D_{k+1} = 2(l_k + l_{k+1}) D_k − l_k² D_{k−1}`, one more than there are lengths.
fn determinants<'a>(lengths: impl Iterator<Item = &'a BigInt> + Clone) -> Vec<BigInt> {
    let mut all = vec![BigInt::zero(), BigInt::one()];
    for (length, next) in lengths.clone().zip(lengths.skip(1)) {
        let last = all.len() - 1;
        all.push((length + next) * 2 * &all[last] - length * length * &all[last - 1]);
    }
    all
}

impl Spans {
    /// Eliminates the equations of these spans, one or more, all positive.
    pub fn new(lengths: Vec<BigInt>) -> Self {
        let left = determinants(lengths.iter());
        let mut right = determinants(lengths.iter().rev());
        right.reverse();
        let multiple = lengths.iter().fold(BigInt::one(), |all, length| all.lcm(length));
        Spans { lengths, left, right, multiple }
    }

    fn determinant(&self) -> &BigInt {
        &self.right[0]
    }

    /// A multiple of the denominators of all reactions to a load.
    pub fn denominator(&self, load: &Load) -> BigInt {
        self.determinant() * &load.scale * &self.multiple
    }

    /// Moments over the supports, sagging positive, times the determinant and the load's scale.
    ///
    /// Beside the loaded span the equations have no right-hand side, so each moment is the next one towards the load,
    /// times `−l_{k+1} left_k / left_{k+1}`, and likewise on the other side.
    fn moments(&self, load: &Load) -> Vec<BigInt> {
        let (first, second, length) = (load.span, load.span + 1, &self.lengths[load.span]);
        let [at_first, at_second] = &load.right_sides;
        let mut moments = vec![BigInt::zero(); self.left.len()];
        let mut carried = &self.right[first] * at_first - length * &self.right[second] * at_second;
        for (k, determinant) in self.left.iter().enumerate().take(second).rev() {
            moments[k] = determinant * &carried;
            if k > 0 {
                carried *= -&self.lengths[k - 1];
            }
        }
        let mut carried = &self.left[second] * at_second - length * &self.left[first] * at_first;
        for (k, determinant) in self.right.iter().enumerate().skip(second) {
            moments[k] = determinant * &carried;
            if let Some(next) = self.lengths.get(k) {
                carried *= -next;
            }
        }
        for (support, moment) in [first, second].into_iter().zip(&load.end_moments) {
            moments[support] += moment * self.determinant();
        }
        moments
    }

    /// What each support carries of a unit load: its share, and the shear that the moments leave beside it.
    pub fn reactions(&self, load: &Load) -> Vec<BigRational> {
        let common = self.determinant() * &load.scale;
        let moments = self.moments(load);
        let mut shares = vec![BigInt::zero(); moments.len()];
        shares[load.span].clone_from(&load.shares[0]);
        shares[load.span + 1].clone_from(&load.shares[1]);
        let reaction = |(k, share): (usize, BigInt)| {
            let (mut numerator, mut denominator) = (share * self.determinant(), BigInt::one());
            for span in [k.checked_sub(1), Some(k)].into_iter().flatten() {
                let Some(length) = self.lengths.get(span) else { continue };
                let other = if span == k { k + 1 } else { span };
                numerator = numerator * length + (&moments[other] - &moments[k]) * &denominator;
                denominator *= length;
            }
            BigRational::new(numerator, denominator * &common)
        };
        shares.into_iter().enumerate().map(reaction).collect()
    }
}
