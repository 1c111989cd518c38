//! What numbers are the terms of a link with a corrected knuckle angle multiplied by?
//!
//! Its knuckle pin stands, seen from the crankpin, at Δ + ε from the master rod, and so `K = e^{iψ} + κ (√(1−λ²S²)/λ − iS) e^{iε}` in crank
//! radii from the shaft, seen with its cylinder in direction 0, `S = sin(ψ+Δ)`. The piston is at `Re K + (L/r) √(1−Y²)`, `Y = (r/L) Im K`. Of
//! the first part order 1 has `1 + ½κ e^{i(Δ−ε)} − ½κ e^{i(Δ+ε)}`, and an even order `½κ (e^{i(kΔ+ε)} + e^{i(kΔ−ε)})` before c_k of the master rod.
//! The root is left: `h_k = 2k² (L/r) · mean(√(1−Y²) e^{−ikψ})`, a complex number.
//!
//! Where ψ, Δ and ε change their signs Y does, and where ε does and ψ goes on by half a turn. So h_k of −Δ and −ε is conjugate, and of −ε alone it
//! is `(−1)^k h_k`; both parts are named by Δ and ε without signs, and where Δ is 0 or ½ one of them is zero.
//!
//! In the strip `|Im ψ| ≤ η`, C = cosh η, the sines are at most C, `|√(1−λ²S²)| ≤ 2 − √(1−λ²C²)` and
//! `|Im K| ≤ |1 − κ cos ε e^{iΔ}| C + (κ/λ) |sin ε| (2 − √(1−λ²C²))`: there it is looked for a C where r/L times that is at most 1, so that the
//! radicand keeps to the right half plane, and the mean over points of a turn is as good as that of a rod ([`rod`](super::rod)).

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};
use serde::{Deserialize, Serialize};

use super::audit::{Audit, steps_of};
use super::ball::{Ball, Complex};
use super::enclosure::Circle;
use super::fraction;
use super::refusal::Refusal;
use super::rod::{Strip, finer, multiple};

/// Bits that a strip is measured with.
const BITS: u32 = 128;
/// How often the widest strip is looked for between two.
const HALVINGS: u32 = 16;
/// r/L times the bound of |Im K| on the axis, and λ, are at most 99/100: beyond, no number of points is enough.
const NEAREST: (i64, i64) = (99, 100);

/// Real or imaginary part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// The real part.
    Real,
    /// The imaginary part.
    Imaginary,
}

/// What tells a part of the number h_k of a link whose knuckle angle is corrected.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnuckleClaim {
    /// r/L.
    #[serde(with = "fraction")]
    pub ratio: BigRational,
    /// κ = a/l.
    #[serde(with = "fraction")]
    pub knuckle: BigRational,
    /// λ of the master rod.
    #[serde(with = "fraction")]
    pub master: BigRational,
    /// Δ or −Δ, in turns: the one up to ½.
    #[serde(with = "fraction")]
    pub apart: BigRational,
    /// ε or −ε, in turns: the one up to ½, less than ¼.
    #[serde(with = "fraction")]
    pub correction: BigRational,
    /// Which part of h_k.
    pub part: Part,
}

impl KnuckleClaim {
    /// Whether the part is zero by symmetry, or the link endless.
    pub(super) fn lacks(&self, order: u32) -> bool {
        let is_along = (&self.apart + &self.apart).is_integer();
        let is_even = order.is_multiple_of(2);
        let is_other = match self.part {
            Part::Real => !is_even,
            Part::Imaginary => is_even,
        };
        self.ratio == BigRational::from_integer(0.into()) || (is_along && is_other)
    }

    /// Whether the crank is known to turn round, with lengths and angles that are right.
    pub(super) fn turns_round(&self) -> bool {
        let nearest = BigRational::new(NEAREST.0.into(), NEAREST.1.into());
        let is_acute = self.correction < BigRational::new(1.into(), 4.into());
        if !is_acute || !self.master.is_positive() || self.master > nearest {
            return false;
        }
        let reach = self.reach(&BigRational::one(), &Circle::new(BITS));
        reach.is_some_and(|reach| reach.middle + reach.doubt <= (nearest * one()).ceil().to_integer())
    }

    /// r/L times the bound of |Im K| in the strip to C, in units of `2^−BITS`.
    fn reach(&self, cosh: &BigRational, circle: &Circle) -> Option<Ball> {
        let Complex { re: cos, im: sin } = circle.direction(&self.correction);
        let ahead = circle.direction(&self.apart).re;
        let unit = Ball::exact(BigInt::one() << BITS);
        let along = cos.scaled(&self.knuckle);
        let twice = along.times(&ahead, BITS).scaled(&BigRational::from_integer(2.into()));
        // It is 0 where the pin would stay on the axis, which an enclosure does not tell from so little: two units more do no harm.
        let square = unit.plus(&along.times(&along, BITS)).minus(&twice);
        let far = Ball { middle: square.middle + &square.doubt + 2, doubt: 1.into() }.root(BITS)?;
        let slant = &self.master * cosh;
        let rest = BigRational::one() - &slant * &slant;
        let root = if rest.is_positive() { Ball::rational(&rest, BITS) } else { Ball::exact(0.into()) };
        let root = if root.middle > root.doubt { root.root(BITS)? } else { Ball::exact(0.into()) };
        let rod = unit.plus(&unit).minus(&root);
        let off = rod.times(&sin, BITS).scaled(&(&self.knuckle / &self.master));
        Some(far.scaled(cosh).plus(&off).scaled(&self.ratio))
    }

    /// The widest strip, about, where the root is analytic.
    fn strip(&self, audit: &Audit) -> Result<Strip, Refusal> {
        let circle = audit.circle(BITS);
        audit.spend(u64::from(HALVINGS) * 2 * (circle.steps() + 64 + self.steps()))?;
        let (mut inside, mut outside) = (BigRational::one(), self.master.recip());
        let grain = BigRational::from_integer(BigInt::one() << (2 * HALVINGS));
        for _ in 0..HALVINGS {
            let half = (&inside + &outside) / BigRational::from_integer(2.into());
            let half = (half * &grain).floor() / &grain;
            let reach = self.reach(&half, &circle).ok_or(Refusal::TooManySteps)?;
            let is_inside = half > inside && reach.middle + reach.doubt <= BigInt::one() << BITS;
            if is_inside { inside = half } else { outside = half }
        }
        Strip::to(&inside)
    }

    /// Steps that its lengths take at a point.
    fn steps(&self) -> u64 {
        [&self.ratio, &self.knuckle, &self.master].into_iter().map(steps_of).sum()
    }

    /// `2k² L/r`.
    fn before_the_mean(&self, order: u32) -> BigRational {
        BigRational::from_integer(BigInt::from(order) * order * 2) / &self.ratio
    }

    /// How many bits below 1 the bound of the part stands.
    pub(super) fn smallness(&self, order: u32, audit: &Audit) -> Result<u64, Refusal> {
        if self.lacks(order) {
            return Ok(0);
        }
        // The root less 1 is at most 1 in the strip.
        let factor = self.before_the_mean(order).ceil().to_integer().bits();
        Ok(self.strip(audit)?.decay(order).saturating_sub(factor))
    }

    /// The part of h_k, in units of `2^−bits`.
    pub(super) fn number(&self, order: u32, bits: u32, audit: &Audit) -> Result<Ball, Refusal> {
        if self.lacks(order) {
            return Ok(Ball::exact(0.into()));
        }
        let (strip, factor) = (self.strip(audit)?, self.before_the_mean(order));
        let fine = finer(bits, &factor)?;
        let half = strip.half_of_points(order, fine);
        let (count, circle) = (2 * half, audit.circle(fine));
        let words = u64::from(fine / 64 + 1);
        audit.spend((half + 1).saturating_mul(circle.steps()))?;
        audit.spend(count.saturating_mul(2 * words * words + self.steps()))?;
        let place = |j: u64| circle.direction(&BigRational::new(j.into(), count.into()));
        let table: Vec<Complex> = (0..=half).map(place).collect();
        let Complex { re: ahead, im: aside } = circle.direction(&self.apart);
        let corrected = circle.direction(&self.correction);
        let along = corrected.re.scaled(&self.knuckle);
        let across = corrected.im.scaled(&(&self.knuckle / &self.master));
        let unit = Ball::exact(BigInt::one() << fine);
        let below = |square: &Ball| unit.minus(&square.times(square, fine)).root(fine).ok_or(Refusal::TooManySteps);
        let mut sum = Ball::exact(0.into());
        for j in 0..count {
            let Complex { re: cos, im: sin } = multiple(&table, 1, j, count)?;
            let of_master = sin.times(&ahead, fine).plus(&cos.times(&aside, fine));
            let rod = below(&of_master.scaled(&self.master))?;
            let pin = sin.minus(&along.times(&of_master, fine)).plus(&across.times(&rod, fine));
            let root = below(&pin.scaled(&self.ratio))?;
            let wave = multiple(&table, u64::from(order), j, count)?;
            let wave = match self.part {
                Part::Real => wave.re,
                Part::Imaginary => wave.im.negated(),
            };
            sum = sum.plus(&root.times(&wave, fine));
        }
        let mean = sum.scaled(&BigRational::new(1.into(), count.into()));
        let whole = Ball { doubt: mean.doubt + strip.missed(), ..mean };
        Ok(whole.scaled(&factor).rounded(fine - bits))
    }
}

/// 1 in units of `2^−BITS`.
fn one() -> BigRational {
    BigRational::from_integer(BigInt::one() << BITS)
}
