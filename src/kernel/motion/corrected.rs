//! How does a link move its piston whose knuckle pin is elsewhere than at the angle of its cylinder?
//!
//! The pin stands, seen from the crankpin, at `γ = Δ + ε` from the master rod. With `κ = a/l`, `z = 1 − κ cos ε e^{iΔ}` and
//! `f = √(1 − λ² sin²)` of the master rod the piston is at
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

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::ball::Ball;
use super::circle::cosine_and_sine;
use super::enclosure::{Coefficient, Enclosure};

/// Bits behind the point that the strip is measured with.
const STRIP_BITS: u32 = 128;
/// Bits that a part of h_k which may be zero is enclosed to, beyond the bound of its order.
const FLOOR_BITS: u32 = 256;
/// Y, as far as its bound tells, and λ stay below this many hundredths: nearer to 1 an enclosure takes too many points.
const MOST_HUNDREDTHS: i64 = 99;
/// Points are counted in such numbers, so that orders have them in common.
const POINTS: u64 = 32;
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
    pub(super) ratio: BigRational,
    /// κ = a/l.
    pub(super) knuckle: BigRational,
    /// λ = r/l.
    pub(super) master: BigRational,
    /// Δ in turns.
    pub(super) angle: BigRational,
    /// ε in turns.
    pub(super) correction: BigRational,
    /// C of the widest strip.
    pub(super) cosh: BigRational,
    /// The roots at points of a turn, by their number and their bits.
    known: RefCell<BTreeMap<(u64, u32), Rc<Samples>>>,
}

/// The root at points of a turn, with cosine and sine of each.
#[derive(Debug)]
struct Samples {
    points: Vec<[Ball; 2]>,
    roots: Vec<Ball>,
}

impl CorrectedLinkage {
    /// From r/L, κ and λ, and Δ and ε in turns. None where the crank cannot turn round, or comes so near to that that the bounds do not tell;
    /// κ and λ are positive, and ε is less than a quarter turn.
    pub fn new([ratio, knuckle, master]: [&BigRational; 3], [angle, correction]: [&BigRational; 2]) -> Option<Self> {
        let correction = correction - correction.round();
        let is_right = !ratio.is_negative() && knuckle.is_positive() && master.is_positive();
        if !is_right || correction.abs() >= BigRational::new(1.into(), 4.into()) {
            return None;
        }
        let hundredths = BigRational::new(MOST_HUNDREDTHS.into(), 100.into());
        let least = Ball::rational(&hundredths, STRIP_BITS).low();
        let reach = Reach::new([ratio, knuckle, master], [angle, &correction]);
        if *master > hundredths || reach.at(&BigRational::one()).high() > least {
            return None;
        }
        Some(CorrectedLinkage {
            ratio: ratio.clone(),
            knuckle: knuckle.clone(),
            master: master.clone(),
            angle: angle.clone(),
            correction,
            cosh: reach.widest(),
            known: RefCell::default(),
        })
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

    /// Bits that a harmonic falls by from order to order, about.
    fn decay(&self) -> f64 {
        let cosh = self.cosh.to_f64().unwrap_or(1.0);
        (cosh + ((cosh - 1.0) * (cosh + 1.0)).sqrt()).log2()
    }

    /// The real or the imaginary part of the mean of `√(1−Y²) e^{−ikψ}`; none if the bits are too few.
    fn mean(&self, order: u32, component: Component, bits: u32) -> Option<Ball> {
        // The number of points decides the cost; what they miss is computed below.
        let enough = u64::from(order) + (f64::from(bits) / self.decay()).ceil() as u64 + 1;
        let count = enough.next_multiple_of(POINTS);
        let samples = self.samples(count, bits)?;
        let mut sum = Ball::integer(0, bits);
        for (j, root) in (0_u64..).zip(&samples.roots) {
            let place = u128::from(order) * u128::from(j) % u128::from(count);
            let [cos, sin] = samples.points.get(usize::try_from(place).ok()?)?;
            sum = match component {
                Component::Real => &sum + &root.times(cos),
                Component::Imaginary => &sum - &root.times(sin),
            };
        }
        // q is what C leaves of the root of C² − 1.
        let square = &self.cosh * &self.cosh - BigRational::one();
        let q = &Ball::rational(&self.cosh, bits) - &Ball::rational(&square, bits).sqrt();
        let count = u32::try_from(count).ok()?;
        let is_enough = &q.power(count).times_integer(2) - &Ball::integer(1, bits);
        if is_enough.high().is_positive() {
            return None;
        }
        let missed = q.power(count - order).times_integer(8);
        Some(sum.over_integer(count.into()).widened(missed.high().max(BigInt::zero())))
    }

    /// The roots at this many points; none if the bits are too few.
    fn samples(&self, count: u64, bits: u32) -> Option<Rc<Samples>> {
        if let Some(known) = self.known.borrow().get(&(count, bits)) {
            return Some(known.clone());
        }
        let ball = |number: &BigRational| Ball::rational(number, bits);
        let [along, across] = cosine_and_sine(&self.correction, bits);
        let [ahead, aside] = cosine_and_sine(&self.angle, bits);
        let (along, across) = (ball(&self.knuckle).times(&along), ball(&(&self.knuckle / &self.master)).times(&across));
        let (master, ratio, one) = (ball(&self.master), ball(&self.ratio), Ball::integer(1, bits));
        let points = circle(count, bits);
        let root = |[cos, sin]: &[Ball; 2]| {
            // sin(ψ + Δ).
            let turned = &sin.times(&ahead) + &cos.times(&aside);
            let slant = master.times(&turned);
            let rod = (&one - &slant.times(&slant)).sqrt();
            let off = &(sin - &along.times(&turned)) + &across.times(&rod);
            let y = ratio.times(&off);
            let rest = &one - &y.times(&y);
            rest.low().is_positive().then(|| rest.sqrt())
        };
        let roots = points.iter().map(root).collect::<Option<Vec<Ball>>>()?;
        let found = Rc::new(Samples { points, roots });
        self.known.borrow_mut().insert((count, bits), found.clone());
        Some(found)
    }
}

/// The bound of |Y| in strips.
struct Reach {
    /// |z|.
    length: Ball,
    /// (κ/λ) |sin ε|.
    across: Ball,
    ratio: BigRational,
    master: BigRational,
}

impl Reach {
    fn new([ratio, knuckle, master]: [&BigRational; 3], [angle, correction]: [&BigRational; 2]) -> Self {
        let ball = |number: &BigRational| Ball::rational(number, STRIP_BITS);
        let [cos, sin] = cosine_and_sine(&correction.abs(), STRIP_BITS);
        let along = ball(knuckle).times(&cos);
        let twice = along.times_integer(2).times(&cosine_and_sine(angle, STRIP_BITS)[0]);
        let length = (&(&Ball::integer(1, STRIP_BITS) + &along.times(&along)) - &twice).sqrt();
        let across = ball(&(knuckle / master)).times(&sin);
        Reach { length, across, ratio: ratio.clone(), master: master.clone() }
    }

    /// In the strip of this C, where `λ C ≤ 1`.
    fn at(&self, cosh: &BigRational) -> Ball {
        let ball = |number: &BigRational| Ball::rational(number, STRIP_BITS);
        let slant = &self.master * cosh;
        let root = ball(&(BigRational::one() - &slant * &slant)).sqrt();
        let off = self.across.times(&(&Ball::integer(2, STRIP_BITS) - &root));
        (&self.length.times(&ball(cosh)) + &off).times(&ball(&self.ratio))
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
            if self.at(&middle).high() <= one { low = middle } else { high = middle }
        }
        low
    }
}

/// Cosine and sine at this many points of a turn: each is the one before, turned.
fn circle(count: u64, bits: u32) -> Vec<[Ball; 2]> {
    let step = BigRational::new(1.into(), count.into());
    let [along, across] = cosine_and_sine(&step, bits);
    let first = [Ball::integer(1, bits), Ball::integer(0, bits)];
    let next = |[cos, sin]: &[Ball; 2]| {
        let turned = [&cos.times(&along) - &sin.times(&across), &sin.times(&along) + &cos.times(&across)];
        Some(turned)
    };
    std::iter::successors(Some(first), next).take(count as usize).collect()
}
