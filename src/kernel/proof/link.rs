//! Which terms does a link on a master rod have, and what number are they multiplied by?
//!
//! With Δ the angle from the master's cylinder to that of the link, `κ = a/l` and `z = 1 − κ e^{iΔ}`, order k > 1 of a link is
//! `κ e^{ikΔ} c_k(λ) + z^k g_k`: the first before the c_k of the master rod, the second before the real number
//! `g_k = |z|^{1−k} c_k(r|z|/L)`, which Δ and −Δ have in common.
//!
//! With `X = (r|z|/L)²` and k = 2m it is `(r/L)^{k−1} d_m (1 + Σ_{i>0} Π (j² − ¼)/((j+1)² − m²) X^i)`, the product over j from m to
//! m + i − 1, and `d_m = 2k² C(½,m) 4^{−m}`: the series of c_k in λ, divided by a power. Its terms have one sign, so that g_k is not zero.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::{Deserialize, Serialize};

use super::audit::{Audit, steps_of};
use super::ball::Ball;
use super::collected::turn;
use super::enclosure::Circle;
use super::fraction;
use super::knuckle::{KnuckleClaim, Part};
use super::refusal::Refusal;
use super::rod::{MOST_BITS, RodClaim};
use super::vector::Vector;

/// Bits that tell whether a link lets the crank turn round.
const BITS_OF_REACH: u32 = 128;
/// Bits that tell how small g_k is.
const BITS_OF_SIZE: u32 = 64;
/// Bits beyond those that are answered for.
const GUARD: u32 = 64;

/// A link on a master rod without offset, whose knuckle pin is at the angle of its cylinder, or by a correction ahead of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinkClaim {
    /// λ = r/l of the master rod.
    #[serde(with = "fraction")]
    pub master: BigRational,
    /// κ = a/l, the knuckle radius in lengths of the master rod.
    #[serde(with = "fraction")]
    pub knuckle: BigRational,
    /// Δ in turns: from the axis of the master's cylinder to that of the link.
    #[serde(with = "fraction")]
    pub angle: BigRational,
    /// ε in turns: by how much its knuckle pin is ahead of its cylinder, seen from the crankpin; omitted where it is 0.
    #[serde(with = "fraction", default = "BigRational::zero", skip_serializing_if = "BigRational::is_zero")]
    pub correction: BigRational,
    /// r/L, L the length of the link.
    #[serde(with = "fraction")]
    pub ratio: BigRational,
}

/// What of a link tells its number g_k.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinkageClaim {
    /// r/L.
    #[serde(with = "fraction")]
    pub ratio: BigRational,
    /// κ = a/l.
    #[serde(with = "fraction")]
    pub knuckle: BigRational,
    /// Δ or −Δ, in turns: the one up to ½.
    #[serde(with = "fraction")]
    pub apart: BigRational,
}

impl LinkClaim {
    pub(super) fn master_rod(&self) -> RodClaim {
        RodClaim { ratio: self.master.clone(), offset: BigRational::zero() }
    }

    pub(super) fn linkage(&self) -> LinkageClaim {
        LinkageClaim { ratio: self.ratio.clone(), knuckle: self.knuckle.clone(), apart: unsigned(&self.angle) }
    }

    /// Whether the knuckle pin is elsewhere than at the angle of its cylinder.
    pub(super) fn is_corrected(&self) -> bool {
        !self.correction.is_integer()
    }

    /// Whether the crank is known to turn round.
    pub(super) fn turns_round(&self) -> bool {
        let one = BigRational::one();
        let is_right = !self.master.is_negative() && self.master < one && !self.ratio.is_negative();
        if !is_right || !self.knuckle.is_positive() {
            return false;
        }
        if self.is_corrected() {
            return self.corrected(Part::Real).turns_round();
        }
        let reach = self.linkage().reach(&Circle::new(BITS_OF_REACH), BITS_OF_REACH);
        &reach.middle + &reach.doubt < BigInt::one() << BITS_OF_REACH
    }

    /// The steps that the terms of an order cost.
    pub(super) fn steps(&self, order: u32) -> u64 {
        let powers = steps_of_power(&self.knuckle, order).saturating_add(steps_of(&self.angle));
        powers.saturating_mul(u64::from(order) + 1)
    }

    /// What the vector of its piston before the master's c_k is multiplied by.
    pub(super) fn with_the_master(&self, order: u32) -> Vec<Vector> {
        let angle = &self.angle * BigRational::from_integer(order.into());
        vec![Vector { angle, weight: self.knuckle.clone() }]
    }

    /// The same before g_k: z^k, one term for each power of Δ, rising.
    pub(super) fn on_its_own(&self, order: u32) -> Vec<Vector> {
        let (mut binomial, mut power) = (BigInt::one(), BigRational::one());
        let mut vectors = Vec::new();
        for u in 0..=order {
            let weight = &power * BigRational::from_integer(binomial.clone());
            vectors.push(Vector { angle: &self.angle * BigRational::from_integer(u.into()), weight });
            binomial = binomial * (order - u) / (u + 1);
            power *= -&self.knuckle;
        }
        vectors
    }
}

impl LinkClaim {
    /// What tells a part of its h_k.
    pub(super) fn corrected(&self, part: Part) -> KnuckleClaim {
        KnuckleClaim {
            ratio: self.ratio.clone(),
            knuckle: self.knuckle.clone(),
            master: self.master.clone(),
            apart: unsigned(&self.angle),
            correction: unsigned(&self.correction),
            part,
        }
    }

    /// What the vector of its piston in order 1 is multiplied by before 1.
    pub(super) fn beside_its_own(&self) -> Vec<Vector> {
        let half = &self.knuckle / BigRational::from_integer(2.into());
        vec![
            Vector { angle: BigRational::from_integer(0.into()), weight: BigRational::one() },
            Vector { angle: &self.angle - &self.correction, weight: half.clone() },
            Vector { angle: &self.angle + &self.correction, weight: -half },
        ]
    }

    /// The same of an even order before c_k of the master rod.
    pub(super) fn swung_with_the_master(&self, order: u32) -> Vec<Vector> {
        let angle = &self.angle * BigRational::from_integer(order.into());
        let half = &self.knuckle / BigRational::from_integer(2.into());
        [&angle + &self.correction, angle - &self.correction].map(|angle| Vector { angle, weight: half.clone() }).into()
    }

    /// The same before a part of h_k: ±1, or ± a quarter turn.
    pub(super) fn turned_into(&self, part: Part, order: u32) -> Vector {
        let has_sign = |angle: &BigRational| unsigned(angle) != turn(angle);
        let [angle, correction] = [&self.angle, &self.correction].map(has_sign);
        let one = BigRational::one();
        let weight = if angle != correction && order % 2 == 1 { -one } else { one };
        let quarter = BigRational::new(if angle { (-1).into() } else { 1.into() }, 4.into());
        let angle = match part {
            Part::Real => BigRational::from_integer(0.into()),
            Part::Imaginary => quarter,
        };
        Vector { angle, weight }
    }
}

/// The angle or its opposite, in turns: the one up to ½.
pub(super) fn unsigned(angle: &BigRational) -> BigRational {
    let part = turn(angle);
    if &part + &part > BigRational::one() { BigRational::one() - part } else { part }
}

/// Steps of a number to this power.
fn steps_of_power(number: &BigRational, power: u32) -> u64 {
    let words = u64::from(power).saturating_mul(number.numer().bits() + number.denom().bits() + 1) / 64 + 1;
    words.saturating_mul(words)
}

impl LinkageClaim {
    /// Whether g_k is zero.
    pub(super) fn lacks(&self, order: u32) -> bool {
        order == 0 || order % 2 == 1 || self.ratio.is_zero()
    }

    /// X, in units of `2^−bits`.
    fn reach(&self, circle: &Circle, bits: u32) -> Ball {
        let cos = circle.direction(&self.apart).re;
        let twice = &self.knuckle * BigRational::from_integer(2.into());
        let squares = BigRational::one() + &self.knuckle * &self.knuckle;
        let ratio = &self.ratio * &self.ratio;
        Ball::rational(&squares, bits).minus(&cos.scaled(&twice)).scaled(&ratio)
    }

    /// `(r/L)^{k−1} d_m`, which g_k begins with: `C(½,m) = −(−1)^m C(2m,m) / (4^m (2m−1))`.
    fn first(&self, order: u32, audit: &Audit) -> Result<BigRational, Refusal> {
        audit.spend(steps_of_power(&self.ratio, order).saturating_add(u64::from(order).pow(2) / 64))?;
        let m = order / 2;
        let central = (1..=m).fold(BigInt::one(), |central, j| central * (4 * j - 2) / j);
        let signed = if m % 2 == 1 { central } else { -central };
        let of_series = BigRational::new(signed * order * order * 2, (BigInt::one() << (4 * m)) * (order - 1));
        Ok(of_series * num_traits::pow(self.ratio.clone(), order as usize - 1))
    }

    /// The sum in brackets, in units of `2^−bits`.
    fn brackets(&self, order: u32, bits: u32, audit: &Audit) -> Result<Ball, Refusal> {
        audit.spend(steps_of_power(&self.ratio, 4).saturating_add(steps_of_power(&self.knuckle, 4)))?;
        let (one, m) = (BigInt::one() << bits, BigInt::from(order / 2));
        let words = u64::from(bits / 64 + 1);
        let reach = self.reach(&audit.circle(bits), bits);
        let most = BigRational::new(&reach.middle + &reach.doubt, one.clone());
        let (mut sum, mut term) = (Ball::exact(one.clone()), Ball::exact(one));
        let mut j = m.clone();
        loop {
            audit.spend(2 * words * words)?;
            let next = &j + 1;
            let growth = BigRational::new(&j * &j * 4 - 1, (&next * &next - &m * &m) * 4);
            // It falls while it is above 1, and stays below 1 afterwards.
            let falls_by = growth.clone().max(BigRational::one()) * &most;
            term = term.times(&reach, bits).scaled(&growth);
            let size = term.middle.abs() + &term.doubt;
            if falls_by < BigRational::one() && size <= BigInt::from(1_u64 << (GUARD / 2)) {
                // What is left is a geometric series at most, this term its first.
                let rest = BigRational::from_integer(size) / (BigRational::one() - falls_by);
                sum.doubt += rest.ceil().to_integer();
                return Ok(sum);
            }
            sum = sum.plus(&term);
            j = next;
        }
    }

    /// How many bits below 1 the bound of g_k stands.
    pub(super) fn smallness(&self, order: u32, audit: &Audit) -> Result<u64, Refusal> {
        if self.lacks(order) {
            return Ok(0);
        }
        let brackets = self.brackets(order, BITS_OF_SIZE, audit)?;
        let first = self.first(order, audit)?.abs();
        let most = (brackets.middle + brackets.doubt).bits() + first.numer().bits() + 1;
        Ok((first.denom().bits() + u64::from(BITS_OF_SIZE)).saturating_sub(most))
    }

    /// g_k, in units of `2^−bits`.
    pub(super) fn number(&self, order: u32, bits: u32, audit: &Audit) -> Result<Ball, Refusal> {
        if self.lacks(order) {
            return Ok(Ball::exact(BigInt::zero()));
        }
        let first = self.first(order, audit)?;
        let fine = u64::from(bits) + u64::from(GUARD) + first.ceil().to_integer().bits();
        let fine = u32::try_from(fine).ok().filter(|_| fine <= MOST_BITS).ok_or(Refusal::TooManySteps)?;
        Ok(self.brackets(order, fine, audit)?.scaled(&first).rounded(fine - bits))
    }
}
