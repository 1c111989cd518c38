//! How does a link move its piston whose knuckle pin stands elsewhere than at the angle of its cylinder?
//!
//! The pin stands, seen from the crankpin, at `γ = Δ + ε` from the master rod. With `κ = a/l`, `z = 1 − κ cos ε e^{iΔ}` and
//! `f = √(1 − λ² sin²)` of the master rod the piston stands at
//!
//! ```text
//! s/r = cos ψ + κ sin ε sin(ψ+Δ) + (κ/λ) cos ε f(ψ+Δ) + (L/r) √(1 − Y²)
//! Y = (r/L) (Im(z e^{iψ}) + (κ/λ) sin ε f(ψ+Δ))
//! ```
//!
//! so that `c_k = [k=1] (1 − iκ sin ε e^{iΔ}) + κ cos ε e^{ikΔ} c_k(λ) + h_k`, h_k the part of the last root: a complex number of every
//! order, without closed form.
//!
//! **Theorem.** `h_k(−Δ, −ε)` is the conjugate of `h_k(Δ, ε)`, and `h_k(Δ, −ε) = (−1)^k h_k(Δ, ε)`. For Δ = 0 and Δ = 180° it is real for even
//! and imaginary for odd k.
//!
//! *Proof.* f is even and repeats after half a turn. So Y changes its sign where ψ, Δ and ε do, and where ε does and ψ goes on by half a
//! turn; the root does not. ∎
//!
//! **Enclosure.** For complex ψ in the strip `|Im ψ| ≤ η`, C = cosh η, with `X = λ C ≤ 1`: `|1 − f| ≤ S(X) = 1 − √(1−X²)` and
//! `|Y| ≤ (r/L) (|z| C + (κ/λ) |sin ε| (1 + S(X)))`. Where that is at most 1 the root is analytic and at most √2, and less 1 at most S(|Y|):
//! `|h_k| ≤ (2k²L/r) S q^k`, `q = e^{−η}`, and the mean over N > k points is off from the harmonic by at most `8 q^{N−k}` where `q^N ≤ ½`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::ball::Ball;
use super::circle::{cosine, sine};
use super::enclosure::{Coefficient, Enclosure};

/// Bits behind the point that the strip is measured with.
const STRIP_BITS: u32 = 128;
/// Bits that a part of h_k which may be zero is enclosed to, beyond the bound of its order.
const FLOOR_BITS: u32 = 256;
/// Y, as far as its bound tells, and λ stay below so many hundredths: nearer to 1 an enclosure takes too many points.
const MOST_HUNDREDTHS: i64 = 99;
/// The strip is found to `2^−STEPS` of what is possible.
const STEPS: u32 = 24;

/// Real or imaginary part of a complex number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Component {
    /// The real part.
    Real,
    /// The imaginary part.
    Imaginary,
}

impl Component {
    /// Both.
    pub const ALL: [Component; 2] = [Component::Real, Component::Imaginary];
}

/// A link with a corrected knuckle angle that lets the crank turn round.
#[derive(Clone, Debug)]
pub struct CorrectedLinkage {
    /// r/L.
    ratio: BigRational,
    /// κ = a/l.
    knuckle: BigRational,
    /// λ = r/l.
    master: BigRational,
    /// Δ in turns.
    angle: BigRational,
    /// ε in turns.
    correction: BigRational,
    /// C of the widest strip.
    cosh: BigRational,
}

impl CorrectedLinkage {
    /// From r/L, κ and λ, and Δ and ε in turns. None where the crank cannot turn round, or comes so near to that that the bounds do not tell;
    /// κ and λ are positive, and ε is less than a quarter turn.
    pub fn new(
        [ratio, knuckle, master]: [&BigRational; 3],
        [angle, correction]: [&BigRational; 2],
    ) -> Option<Self> {
        let correction = correction - correction.round();
        let is_right = !ratio.is_negative() && knuckle.is_positive() && master.is_positive();
        if !is_right || correction.abs() >= BigRational::new(1.into(), 4.into()) {
            return None;
        }
        let (ratio, knuckle, master, angle) = (ratio.clone(), knuckle.clone(), master.clone(), angle.clone());
        let mut found =
            CorrectedLinkage { ratio, knuckle, master, angle, correction, cosh: BigRational::one() };
        let hundredths = BigRational::new(MOST_HUNDREDTHS.into(), 100.into());
        let least = Ball::rational(&hundredths, STRIP_BITS).low();
        if found.master > hundredths || found.reach(&found.cosh).high() > least {
            return None;
        }
        found.cosh = found.widest();
        Some(found)
    }

    /// h_k: both parts enclosed to a relative 2^−60, or to so little that it may well be zero.
    pub fn number(&self, order: u32) -> Coefficient {
        let [re, im] = Component::ALL.map(|component| self.component(order, component));
        Coefficient { re, im }
    }

    /// One part of h_k.
    pub fn component(&self, order: u32, component: Component) -> Enclosure {
        if self.ratio.is_zero() || order == 0 {
            return Enclosure::zero();
        }
        let factor = BigRational::from_integer(BigInt::from(order) * order * 2) / &self.ratio;
        let floor = FLOOR_BITS + (self.decay() * f64::from(order)).ceil() as u32;
        Enclosure::refine(&factor, Some(floor), |bits| self.mean(order, component, bits))
    }

    /// What the orders above one add at most.
    pub fn tail(&self) -> CorrectedTail {
        CorrectedTail::new(self)
    }

    /// A bound of |Y| in the strip of this C, where `λ C ≤ 1`.
    fn reach(&self, cosh: &BigRational) -> Ball {
        let ball = |number: &BigRational| Ball::rational(number, STRIP_BITS);
        let along = ball(&self.knuckle).times(&cosine(&self.correction, STRIP_BITS));
        let twice = along.times_integer(2).times(&cosine(&self.angle, STRIP_BITS));
        let length = (&(&ball(&BigRational::one()) + &along.times(&along)) - &twice).sqrt();
        let slant = &self.master * cosh;
        let root = ball(&(BigRational::one() - &slant * &slant)).sqrt();
        let across = ball(&(&self.knuckle / &self.master)).times(&sine(&self.correction.abs(), STRIP_BITS));
        let off = across.times(&(&Ball::integer(2, STRIP_BITS) - &root));
        (&length.times(&ball(cosh)) + &off).times(&ball(&self.ratio))
    }

    /// C of the widest strip in which the root is known to be analytic.
    fn widest(&self) -> BigRational {
        let one = Ball::integer(1, STRIP_BITS).low();
        let two = BigRational::from_integer(2.into());
        let (mut low, mut high) = (BigRational::one(), self.master.recip());
        for _ in 0..STEPS {
            let middle = (&low + &high) / &two;
            // Few digits are enough, rounded down.
            let scale = BigRational::from_integer(BigInt::one() << (2 * STEPS));
            let middle = ((middle * &scale).floor() / scale).max(low.clone());
            if self.reach(&middle).high() <= one { low = middle } else { high = middle }
        }
        low
    }

    /// Bits that a harmonic falls by from order to order, about.
    fn decay(&self) -> f64 {
        let cosh = self.cosh.to_f64().unwrap_or(1.0);
        (cosh + ((cosh - 1.0) * (cosh + 1.0)).sqrt()).log2()
    }

    /// The real or the imaginary part of the mean of `√(1−Y²) e^{−ikψ}`; none if the bits are too few.
    fn mean(&self, order: u32, component: Component, bits: u32) -> Option<Ball> {
        // The number of points decides the cost; what they miss is reckoned below.
        let count = u64::from(order) + (f64::from(bits) / self.decay()).ceil() as u64 + 1;
        let points = circle(count, bits);
        let ball = |number: &BigRational| Ball::rational(number, bits);
        let [along, across] = [cosine(&self.correction, bits), sine(&self.correction, bits)];
        let [ahead, aside] = [cosine(&self.angle, bits), sine(&self.angle, bits)];
        let (knuckle, master, ratio) = (ball(&self.knuckle), ball(&self.master), ball(&self.ratio));
        let along = knuckle.times(&along);
        let across = ball(&(&self.knuckle / &self.master)).times(&across);
        let one = Ball::integer(1, bits);
        let mut sum = Ball::integer(0, bits);
        for (j, [cos, sin]) in (0_u64..).zip(&points) {
            // sin(ψ + Δ).
            let turned = &sin.times(&ahead) + &cos.times(&aside);
            let slant = master.times(&turned);
            let rod = (&one - &slant.times(&slant)).sqrt();
            let off = &(sin - &along.times(&turned)) + &across.times(&rod);
            let y = ratio.times(&off);
            let rest = &one - &y.times(&y);
            if !rest.low().is_positive() {
                return None;
            }
            let [cos, sin] = points.get((u128::from(order) * u128::from(j) % u128::from(count)) as usize)?;
            let wave = match component {
                Component::Real => cos.clone(),
                Component::Imaginary => -sin.clone(),
            };
            sum = &sum + &rest.sqrt().times(&wave);
        }
        // q is what C leaves of the root of C² − 1.
        let square = &self.cosh * &self.cosh - BigRational::one();
        let q = &ball(&self.cosh) - &ball(&square).sqrt();
        let is_enough = &q.power(u32::try_from(count).ok()?).times_integer(2) - &one;
        if is_enough.high().is_positive() {
            return None;
        }
        let missed = q.power(u32::try_from(count).ok()? - order).times_integer(8);
        Some(sum.over_integer(count).widened(missed.high().max(BigInt::zero())))
    }
}

/// Cosine and sine at so many points of a turn: each is the one before, turned.
fn circle(count: u64, bits: u32) -> Vec<[Ball; 2]> {
    let step = BigRational::new(1.into(), count.into());
    let [along, across] = [cosine(&step, bits), sine(&step, bits)];
    let first = [Ball::integer(1, bits), Ball::integer(0, bits)];
    let next = |[cos, sin]: &[Ball; 2]| {
        let turned = [&cos.times(&along) - &sin.times(&across), &sin.times(&along) + &cos.times(&across)];
        Some(turned)
    };
    std::iter::successors(Some(first), next).take(count as usize).collect()
}

/// What the higher orders of h_k add at most, by the bounds of several strips.
#[derive(Clone, Debug)]
pub struct CorrectedTail {
    /// r/L; 0 of a link without an end.
    ratio: f64,
    /// κ |sin ε|, what order 1 has beside 1 and h_1.
    beside: f64,
    /// q and 1 − q of a strip, and S there.
    strips: Vec<[f64; 3]>,
}

/// Strips that are tried.
const STRIPS: u32 = 16;
/// Floats of a bound are enlarged by this part of it, far more than they are rounded by.
const SLACK: f64 = 1.0 + 1e-9;
/// What is put under a root near 1 is enlarged by this part of it before.
const NEAR: f64 = 1.0 + 1e-12;

impl CorrectedTail {
    fn new(linkage: &CorrectedLinkage) -> Self {
        let float = |number: &BigRational| number.to_f64().unwrap_or(f64::INFINITY);
        let [ratio, knuckle, master] = [&linkage.ratio, &linkage.knuckle, &linkage.master].map(float);
        let [angle, correction] =
            [&linkage.angle, &linkage.correction].map(|turns| float(turns) * std::f64::consts::TAU);
        let along = knuckle * correction.cos();
        let length = (1.0 + along * along - 2.0 * along * angle.cos()).max(0.0).sqrt() + 1e-14;
        let off = knuckle / master * correction.sin().abs();
        let lowered = |x: f64| 1.0 - (1.0 - (x * NEAR).min(1.0).powi(2)).max(0.0).sqrt();
        let widest = (float(&linkage.cosh) - 1.0) * (1.0 - 1e-9);
        let strip = |part: u32| {
            let beyond = widest * f64::from(part) / f64::from(STRIPS);
            let root = (beyond * (beyond + 2.0)).sqrt();
            let cosh = 1.0 + beyond;
            let reach = ratio * (length * cosh + off * (1.0 + lowered(master * cosh)));
            [cosh - root, root - beyond, lowered(reach)]
        };
        let beside = knuckle * correction.sin().abs();
        CorrectedTail { ratio, beside, strips: (1..=STRIPS).map(strip).collect() }
    }

    /// `Σ_{k>K} |c_k − [k=1] − κ cos ε e^{ikΔ} c_k(λ)|` at most; 0 only where no order is above.
    pub fn force(&self, order: u32) -> f64 {
        let beside = if order == 0 { self.beside * SLACK } else { 0.0 };
        if self.ratio == 0.0 {
            return beside;
        }
        let n = f64::from(order) + 1.0;
        let sum = |[q, short, lowered]: &[f64; 3]| {
            let terms = n * n / short + 2.0 * n * q / (short * short) + q * (1.0 + q) / (short * short * short);
            2.0 / self.ratio * lowered * q.powf(n) * terms
        };
        let least = self.strips.iter().map(sum).fold(f64::INFINITY, f64::min);
        (beside + least * SLACK).max(f64::MIN_POSITIVE)
    }
}
