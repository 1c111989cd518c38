//! Which slider-crank is it, and what are its harmonics?

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::ball::Ball;
use super::enclosure::{Coefficient, Enclosure, float};
use super::error::NoFullTurn;
use super::{centric, offset, side, small, torque};

/// A slider-crank that can make a full turn: its rod ratio `λ = r/l` and its pin offset `δ = e/l`, exact.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::motion::SliderCrank;
/// use num_rational::BigRational;
///
/// let crank = SliderCrank::new(BigRational::new(3.into(), 10.into()), BigRational::from_integer(0.into())).unwrap();
/// let second = crank.coefficient(2).re;
/// assert_eq!(second.to_float(), 0.307_050_659_062_165_75);
/// assert!(!second.contains_zero());
/// ```
#[derive(Clone, Debug)]
pub struct SliderCrank {
    ratio: BigRational,
    offset: BigRational,
    pub(super) floats: Floats,
}

impl PartialEq for SliderCrank {
    fn eq(&self, other: &Self) -> bool {
        self.ratio == other.ratio && self.offset == other.offset
    }
}

impl Eq for SliderCrank {}

impl SliderCrank {
    /// A crank of rod ratio `λ ≥ 0` and offset δ of either sign.
    ///
    /// # Errors
    ///
    /// λ is negative, `λ + |δ|` is not below 1, or, with an offset, above 0.999999.
    pub fn new(ratio: BigRational, offset: BigRational) -> Result<Self, NoFullTurn> {
        if ratio.is_negative() {
            return Err(NoFullTurn::NegativeRatio(ratio));
        }
        let sum = &ratio + offset.abs();
        if sum >= BigRational::one() {
            return Err(NoFullTurn::RodTooShort(sum));
        }
        if !offset.is_zero() && offset::is_too_near(&sum) {
            return Err(NoFullTurn::TooNearOne(sum));
        }
        let floats = Floats::new(&ratio, &offset);
        Ok(SliderCrank { ratio, offset, floats })
    }

    /// The rod ratio `λ = r/l`.
    pub fn ratio(&self) -> &BigRational {
        &self.ratio
    }

    /// The pin offset `δ = e/l`; for a positive one the cylinder axis lies on the side of the crankpin at ψ = 90°.
    pub fn offset(&self) -> &BigRational {
        &self.offset
    }

    /// The harmonic `c_k` of the shaking force, outward positive: `−m s̈ = m r ω² Re Σ c_k e^{ikψ}`.
    ///
    /// Each part is exactly zero, exactly 1 (the real part of `c_1`), or enclosed to a relative `2^−64`. For even k it is
    /// real; for odd k it is imaginary, but for the 1 of `c_1`. Without an offset `c_1 = 1` and the other odd ones are 0. With
    /// the infinitely long rod of `λ = 0` only `c_1 = 1 − iδ/√(1−δ²)` is left.
    pub fn coefficient(&self, order: u32) -> Coefficient {
        let rod = Coefficient::turned(&self.rod(order.into()), order);
        if order != 1 {
            return rod;
        }
        rod.plus(&Coefficient { re: Enclosure::point(BigRational::one()), im: Enclosure::zero() })
    }

    /// The harmonic `t_k` of the inertia torque, positive in the sense of rotation: `T = m r² ω² Re Σ t_k e^{ikψ}`.
    ///
    /// For a centric crank `t_k = −i b_k`, where `T = m r² ω² Σ b_k sin kψ`. A part that cannot cancel, hence every part
    /// without an offset, is enclosed to a relative `2^−64`; another to that or to `2^−256`.
    ///
    /// No order is zero if λ > 0: in `t_k = k(−i)^k (X − iY)` the numbers `g_{k−1}` and `g_{k+1}` of X have the same sign,
    /// so X is zero only for δ = 0 and even k; and then Y is `½ − κ'/(1+κ')² > 0`, `κ' = √(1−λ²)`, for k = 2 and
    /// `−κ' p^k/λ²` otherwise.
    pub fn torque_coefficient(&self, order: u32) -> Coefficient {
        if order == 0 {
            return Coefficient::zero();
        }
        if !self.ratio.is_zero() {
            return torque::harmonic(&self.ratio, &self.offset, order, |k| self.rod(k));
        }
        if order != 2 {
            return Coefficient::zero();
        }
        // s' = −sin ψ + τ cos ψ with the slope τ of the rod: T = τ cos 2ψ − ½ (1 − τ²) sin 2ψ.
        let square = &self.offset * &self.offset;
        let slope_squared = &square / (BigRational::one() - &square);
        let half = BigRational::new(1.into(), 2.into());
        let slope = self.rod(1);
        Coefficient { re: slope, im: Enclosure::point((BigRational::one() - slope_squared) * half) }
    }

    /// The harmonic `n_k` of the side force that the piston's inertia makes, on the crankpin away from ψ = 90°:
    /// `−m s̈ tan β = m r ω² Re Σ −i n_k e^{ikψ}`, β the angle of the rod; n_0 is that of a constant force.
    ///
    /// So the crankpin feels `½ (c_k − n_k)` with the crank and `½ (c_k + n_k)*` against it. Without an offset n_k is real:
    /// `c_k/k` for even k, `u_k` for odd ones ([`SliderCrank::side_part`]).
    pub fn side_coefficient(&self, order: u32) -> Coefficient {
        let part = self.side_part(order);
        if order == 0 {
            return part;
        }
        let over = self.rod(order.into()).times(&BigRational::new(1.into(), order.into()));
        Coefficient::turned(&over, order).plus(&part)
    }

    /// The part `u_k = n_k − (c_k − [k=1])/k` of the side force, which no order of the shaking force has: known to be zero, or
    /// not; exact or enclosed to a relative `2^−64`.
    pub fn side_part(&self, order: u32) -> Coefficient {
        let real = side::harmonic(&self.ratio, &self.offset, order);
        Coefficient::turned(&real.times(&BigRational::from_integer((-1).into())), order + 1)
    }

    /// The real number E of `u_k = i (−i)^k E` where it is rational: then it is a weight and no coefficient.
    pub fn rational_side_part(&self, order: u32) -> Option<BigRational> {
        side::rational(&self.ratio, &self.offset, order)
    }

    /// Whether `u_k` is not zero.
    pub fn has_side_part(&self, order: u32) -> bool {
        side::exists(&self.ratio, &self.offset, order)
    }

    /// The real number g of `c_k = [k=1] + (−i)^k g`: `2k²/λ` times the harmonic of the root. Known to be zero, or not.
    fn rod(&self, k: u64) -> Enclosure {
        let is_centric = self.offset.is_zero();
        if k == 0 || (is_centric && (!k.is_multiple_of(2) || self.ratio.is_zero())) {
            return Enclosure::zero();
        }
        if self.ratio.is_zero() {
            return if k == 1 { self.slope() } else { Enclosure::zero() };
        }
        let k_squared = BigRational::from_integer(BigInt::from(k) * k * 2);
        let factor = k_squared / &self.ratio;
        if is_centric {
            let sign = BigRational::from_integer(if k.is_multiple_of(4) { 1.into() } else { (-1).into() });
            if let Some(harmonic) = u32::try_from(k).ok().and_then(|k| small::harmonic(&self.ratio, k)) {
                return harmonic.times(&sign);
            }
            let factor = factor * sign;
            Enclosure::refine(&factor, None, |bits| centric::harmonic(&self.ratio, k / 2, bits))
        } else {
            Enclosure::refine(&factor, None, |bits| offset::harmonic(&self.ratio, &self.offset, k, bits))
        }
    }

    /// The slope `δ/√(1−δ²)` that an infinitely long rod keeps.
    fn slope(&self) -> Enclosure {
        let radicand = BigRational::one() - &self.offset * &self.offset;
        Enclosure::refine(&self.offset, None, |bits| Ball::rational(&radicand, bits).sqrt().reciprocal())
    }
}

/// The numbers of a crank as floats. The gaps `1 ± δ − λ` are rounded from exact ones: near the end of reach they decide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Floats {
    pub ratio: f64,
    pub offset: f64,
    pub gap_above: f64,
    pub gap_below: f64,
}

impl Floats {
    fn new(ratio: &BigRational, offset: &BigRational) -> Self {
        let one = BigRational::one();
        Floats {
            ratio: float(ratio),
            offset: float(offset),
            gap_above: float(&(&one + offset - ratio)),
            gap_below: float(&(&one - offset - ratio)),
        }
    }
}
