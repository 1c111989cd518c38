//! How are many sums of one engine decided fast? Its angles and weights as machine words over common denominators.
//!
//! Where all cylinders have one rod, or none is given, every sum of an order that no other mass enters has the exponents
//! `kβ − (k∓1)α` over one denominator. They are formed in words, and the room [`crate::exact`] decides on them as on any.

use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_complex::Complex;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::engine::Engine;
use crate::exact;
use crate::order;
use crate::proof::{Quantity, Sense};

/// A sum further from zero than this part of the sum of its weights is not zero: floats are off by far less, with as many
/// cylinders as are read.
const SURELY_NOT_ZERO: f64 = 1e-9;
/// Denominators and weights below this leave room for every product and sum.
const MOST: i64 = 1 << 40;

/// An engine in whole numbers.
pub(super) struct IntegerEngine {
    conductor: i64,
    throws: Vec<i64>,
    banks: Vec<i64>,
    /// Mass times crank radius, for the force; for the moment times the arm.
    weights: [Weights; 2],
    /// The orders that masses enter that turn.
    turning: Vec<u32>,
}

/// Whole weights, and what a unit of them is.
struct Weights {
    whole: Vec<i64>,
    unit: f64,
}

/// One order of the force or the moment: P⁺ and P̄⁻, and which of P⁺, P⁻, P⁺ + P̄⁻, P⁺ − P̄⁻ are zero.
pub(super) struct Pair {
    pub direct: Complex<f64>,
    pub mirrored: Complex<f64>,
    pub zeros: [bool; 4],
    /// The length of all terms of a sum end to end.
    pub total_length: f64,
}

impl IntegerEngine {
    /// The engine in words; none where it has no reciprocating masses, rods or the speeds of crankshafts differ, or a number is too long.
    pub fn new(engine: &Engine) -> Option<Self> {
        let weightless = engine.dimensions().mass.as_ref().is_some_and(Zero::is_zero);
        if weightless || engine.mechanisms().len() > 1 || engine.faster_crank().is_some() {
            return None;
        }
        let turning = order::turning_masses(engine).into_iter().map(|mass| mass.order).collect();
        let cylinders = engine.cylinders();
        let angles = cylinders.iter().flat_map(|cylinder| [cylinder.throw.turns(), cylinder.bank.turns()]);
        let conductor = common(angles)?;
        let exponent = |turns: &BigRational| Some(turns.numer().to_i64()? * (conductor / turns.denom().to_i64()?));
        let force: Vec<BigRational> = cylinders.iter().map(|cylinder| cylinder.weight()).collect();
        let moment: Vec<BigRational> =
            cylinders.iter().zip(&force).map(|(cylinder, weight)| weight * engine.arm(cylinder)).collect();
        Some(IntegerEngine {
            conductor,
            throws: cylinders.iter().map(|cylinder| exponent(cylinder.throw.turns())).collect::<Option<_>>()?,
            banks: cylinders.iter().map(|cylinder| exponent(cylinder.bank.turns())).collect::<Option<_>>()?,
            weights: [Weights::new(&force)?, Weights::new(&moment)?],
            turning,
        })
    }

    /// Whether these are all the masses of an order.
    pub fn knows(&self, order: u32) -> bool {
        !self.turning.contains(&order)
    }

    /// Top dead centres after that of the first cylinder, in `0..turn`, and the length of a turn.
    pub fn top_dead_centres(&self) -> (Vec<i64>, i64) {
        let own = self.banks.iter().zip(&self.throws).map(|(bank, throw)| bank - throw);
        let first = self.banks.first().zip(self.throws.first()).map_or(0, |(bank, throw)| bank - throw);
        (own.map(|centre| (centre - first).rem_euclid(self.conductor)).collect(), self.conductor)
    }

    /// The sums of one order, without its coefficient.
    pub fn pair(&self, quantity: Quantity, order: u32) -> Pair {
        let weights = &self.weights[usize::from(quantity == Quantity::Moment)];
        let n = i128::from(self.conductor);
        let [direct, reverse] = [Sense::Direct, Sense::Reverse].map(|sense| order::multiples(order, Some(sense)));
        let mirrored = reverse.map(|times| -times);
        let exponents: Vec<[u64; 2]> = self
            .throws
            .iter()
            .zip(&self.banks)
            .map(|(&throw, &bank)| {
                [direct, mirrored].map(|[of_throw, of_bank]| {
                    let exponent = i128::from(of_throw) * i128::from(throw) + i128::from(of_bank) * i128::from(bank);
                    exponent.rem_euclid(n) as u64
                })
            })
            .collect();
        let angle = |exponent: u64| TAU * (exponent as f64 / self.conductor as f64);
        let (mut direct, mut mirrored, mut whole) = (Complex::zero(), Complex::zero(), 0.0);
        for (&weight, &[one, other]) in weights.whole.iter().zip(&exponents) {
            let weight = weight as f64;
            whole += weight.abs();
            direct += Complex::from_polar(weight, angle(one));
            mirrored += Complex::from_polar(weight, angle(other));
        }
        let conductor = self.conductor as u64;
        let alone = |place: usize| {
            let terms: Vec<(u64, i64)> =
                exponents.iter().map(|pair| pair[place]).zip(weights.whole.iter().copied()).collect();
            exact::vanishes(&conductor, &terms)
        };
        let both = |sign: i64| {
            let pairs = exponents.iter().zip(&weights.whole);
            let terms: Vec<(u64, i64)> =
                pairs.flat_map(|(pair, &weight)| [(pair[0], weight), (pair[1], sign * weight)]).collect();
            exact::vanishes(&conductor, &terms)
        };
        let near = |value: Complex<f64>| value.norm() <= SURELY_NOT_ZERO * whole;
        let (plus, minus) = (near(direct) && alone(0), near(mirrored) && alone(1));
        let [along, across] = match (plus, minus) {
            (true, true) => [true, true],
            (false, false) => [near(direct + mirrored) && both(1), near(direct - mirrored) && both(-1)],
            _ => [false, false],
        };
        let unit = weights.unit;
        let zeros = [plus, minus, along, across];
        Pair { direct: direct * unit, mirrored: mirrored * unit, zeros, total_length: whole * unit }
    }
}

impl Weights {
    fn new(weights: &[BigRational]) -> Option<Self> {
        let scale = common(weights)?;
        let whole = |weight: &BigRational| {
            let scaled = weight.numer().to_i64()?.checked_mul(scale / weight.denom().to_i64()?)?;
            (scaled.abs() < MOST).then_some(scaled)
        };
        Some(Weights { whole: weights.iter().map(whole).collect::<Option<_>>()?, unit: 1.0 / scale as f64 })
    }
}

/// The common denominator, where it is short enough.
fn common<'a>(numbers: impl IntoIterator<Item = &'a BigRational>) -> Option<i64> {
    let mut all: i64 = 1;
    for number in numbers {
        let denominator = number.denom();
        debug_assert!(denominator.is_positive() && *denominator >= BigInt::one());
        let lcm = i128::from(all).lcm(&i128::from(denominator.to_i64()?));
        all = i64::try_from(lcm).ok().filter(|lcm| *lcm < MOST)?;
    }
    Some(all)
}
