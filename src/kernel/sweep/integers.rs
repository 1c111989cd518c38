//! How are many sums of one engine decided fast? Its angles and weights as machine words over common denominators.
//!
//! Where all cylinders have one rod, or none is given, every sum of an order has the exponents `kβ − (k∓1)α` over one
//! denominator. Masses that turn enter order 1 of centric rods with the same number before them, 1, so that their terms stand
//! in the same sum. All are formed in words, and the room [`crate::exact`] decides on them as on any.

use std::cell::OnceCell;
use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_complex::Complex;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use smallvec::SmallVec;

use crate::engine::{Cylinder, Engine};
use crate::exact::{self, fraction};
use crate::numbers;
use crate::order::{self, Factor, TurningMass};
use crate::proof::Sense;

/// Denominators and weights below this leave room for every product and sum.
const MOST: i64 = 1 << 40;

/// An engine in whole numbers.
pub(super) struct IntegerEngine {
    conductor: i64,
    throws: Vec<i64>,
    banks: Vec<i64>,
    /// The masses that turn and are in words: where each is in a turn, and which way it goes.
    turning: Vec<(i64, Sense)>,
    /// Mass times crank radius, for the force; for the moment times the arm. Of the cylinders, then of the masses that turn.
    weights: [Weights; 2],
    /// The orders of masses that turn and are not in words.
    unknown: Vec<u32>,
    /// The sums of order 1, for which the counterweights ask again.
    first: OnceCell<[Pair; 2]>,
}

/// A vector of P⁺ and one of P̄⁻: its exponent over the conductor, and its direction.
type Vectors = [Option<(u64, Complex<f64>)>; 2];

/// The weights of the pistons of an engine, kept for the next one: most sweeps change angles alone.
#[derive(Default)]
pub(super) struct KnownWeights(Option<(Vec<[BigRational; 3]>, BigRational, [Weights; 2])>);

/// Whole weights, and what a unit of them is.
#[derive(Clone)]
struct Weights {
    whole: Vec<i64>,
    unit: f64,
}

/// One order of the force or the moment: P⁺ and P̄⁻, and which of P⁺, P⁻, P⁺ + P̄⁻, P⁺ − P̄⁻ are zero.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    pub direct: Complex<f64>,
    pub mirrored: Complex<f64>,
    pub zeros: [bool; 4],
    /// The length of all terms of a sum end to end.
    pub total_length: f64,
}

impl IntegerEngine {
    /// The engine in words; none where it has no reciprocating masses, rods or the speeds of crankshafts differ, a piston
    /// has several vectors, or a number is too long.
    pub fn new(engine: &Engine, known: &mut KnownWeights) -> Option<Self> {
        let weightless = engine.dimensions().mass.as_ref().is_some_and(Zero::is_zero);
        let differs = engine.mechanisms().len() > 1 || engine.faster_crank().is_some();
        if weightless || differs || !engine.has_one_vector_per_order() {
            return None;
        }
        let turning = order::turning_masses(engine);
        // They are multiplied by 1, and so is order 1 of the pistons.
        let is_plain = engine.is_centric();
        let beside = |mass: &TurningMass| is_plain && mass.order == 1 && mass.factor == Factor::One;
        let unknown = turning.iter().filter(|mass| !beside(mass)).map(|mass| mass.order).collect();
        let plain: Vec<TurningMass> = turning.iter().filter(|mass| beside(mass)).cloned().collect();
        if plain.is_empty() {
            return Self::with(engine, &[], unknown, known.of(engine)?);
        }
        Weights::of(engine, &plain).and_then(|weights| Self::with(engine, &plain, unknown, weights)).or_else(|| {
            let unknown = turning.iter().map(|mass| mass.order).collect();
            Self::with(engine, &[], unknown, Weights::of(engine, &[])?)
        })
    }

    fn with(engine: &Engine, turning: &[TurningMass], unknown: Vec<u32>, weights: [Weights; 2]) -> Option<Self> {
        let cylinders = engine.cylinders();
        let angles = cylinders.iter().flat_map(|cylinder| [cylinder.throw.turns(), cylinder.bank.turns()]);
        let conductor = common(angles.chain(turning.iter().map(|mass| mass.angle.turns())))?;
        let exponent = |turns: &BigRational| Some(turns.numer().to_i64()? * (conductor / turns.denom().to_i64()?));
        let turns = |mass: &TurningMass| Some((exponent(mass.angle.turns())?, mass.sense));
        Some(IntegerEngine {
            conductor,
            throws: cylinders.iter().map(|cylinder| exponent(cylinder.throw.turns())).collect::<Option<_>>()?,
            banks: cylinders.iter().map(|cylinder| exponent(cylinder.bank.turns())).collect::<Option<_>>()?,
            turning: turning.iter().map(turns).collect::<Option<_>>()?,
            weights,
            unknown,
            first: OnceCell::new(),
        })
    }

    /// Whether these are all the masses of an order.
    pub fn knows(&self, order: u32) -> bool {
        !self.unknown.contains(&order)
    }

    /// Top dead centres after that of the first cylinder, in `0..turn`, and the length of a turn.
    pub fn top_dead_centres(&self) -> (Vec<i64>, i64) {
        let own = self.banks.iter().zip(&self.throws).map(|(bank, throw)| bank - throw);
        let first = self.banks.first().zip(self.throws.first()).map_or(0, |(bank, throw)| bank - throw);
        (own.map(|centre| (centre - first).rem_euclid(self.conductor)).collect(), self.conductor)
    }

    /// The sums of one order of the force and the moment, without its coefficient.
    pub fn pairs(&self, order: u32) -> [Pair; 2] {
        match order {
            1 => *self.first.get_or_init(|| self.sums(1)),
            _ => self.sums(order),
        }
    }

    fn sums(&self, order: u32) -> [Pair; 2] {
        let star = self.star(order);
        self.weights.each_ref().map(|weights| self.pair(&star, weights))
    }

    /// Where each vector of an order points: the same for the force and the moment.
    fn star(&self, order: u32) -> SmallVec<[Vectors; 16]> {
        let [direct, reverse] = Sense::BOTH.map(|sense| order::multiples(order, Some(sense)));
        let mirrored = reverse.map(|times| -times);
        let vector = |multiple: i64| {
            let exponent = multiple.rem_euclid(self.conductor);
            Some((exponent as u64, Complex::cis(TAU * (exponent as f64 / self.conductor as f64))))
        };
        // Angles are below 2⁴⁰ and orders are at most 1000.
        let pistons = self.throws.iter().zip(&self.banks).map(|(&throw, &bank)| {
            [direct, mirrored].map(|[of_throw, of_bank]| vector(of_throw * throw + of_bank * bank))
        });
        // What turns is in one of both sums: with the crank in the direct one, against it, mirrored, in the other.
        let masses = self.turning.iter().filter(|_| order == 1).map(|&(at, sense)| match sense {
            Sense::Direct => [vector(at), None],
            Sense::Reverse => [None, vector(-at)],
        });
        pistons.chain(masses).collect()
    }

    fn pair(&self, star: &[Vectors], weights: &Weights) -> Pair {
        let (mut sums, mut whole) = ([Complex::zero(), Complex::zero()], 0.0);
        for (&weight, vectors) in weights.whole.iter().zip(star) {
            whole += (weight as f64).abs();
            for (sum, (_, direction)) in sums.iter_mut().zip(vectors).filter_map(|(sum, v)| Some((sum, (*v)?))) {
                *sum += direction * weight as f64;
            }
        }
        let [direct, mirrored] = sums;
        let decide = |signs: [i64; 2]| {
            let mut terms: SmallVec<[(u64, i64); 32]> = SmallVec::new();
            for (&weight, vectors) in weights.whole.iter().zip(star) {
                for (vector, sign) in vectors.iter().zip(signs).filter(|(_, sign)| *sign != 0) {
                    terms.extend(vector.map(|(exponent, _)| (exponent, sign * weight)));
                }
            }
            exact::vanishes(&(self.conductor as u64), &terms)
        };
        let near = |value: Complex<f64>| value.norm() <= numbers::ALIKE * whole;
        let (plus, minus) = (near(direct) && decide([1, 0]), near(mirrored) && decide([0, 1]));
        let [along, across] = match (plus, minus) {
            (true, true) => [true, true],
            (false, false) => [near(direct + mirrored) && decide([1, 1]), near(direct - mirrored) && decide([1, -1])],
            _ => [false, false],
        };
        let unit = weights.unit;
        let zeros = [plus, minus, along, across];
        Pair { direct: direct * unit, mirrored: mirrored * unit, zeros, total_length: whole * unit }
    }
}

impl KnownWeights {
    /// Those of the force and the moment of the pistons.
    fn of(&mut self, engine: &Engine) -> Option<[Weights; 2]> {
        let enters = |cylinder: &Cylinder| {
            [&cylinder.reciprocating_mass, &cylinder.crank_radius, &cylinder.position].map(Clone::clone)
        };
        let is_same = |cylinder: &Cylinder, [mass, radius, position]: &[BigRational; 3]| {
            (&cylinder.reciprocating_mass, &cylinder.crank_radius, &cylinder.position) == (mass, radius, position)
        };
        let (cylinders, plane) = (engine.cylinders(), engine.reference_plane());
        if let Some((pistons, known_plane, weights)) = &self.0 {
            let pairs = || cylinders.iter().zip(pistons);
            let are_same =
                pistons.len() == cylinders.len() && pairs().all(|(cylinder, known)| is_same(cylinder, known));
            if are_same && known_plane == plane {
                return Some(weights.clone());
            }
        }
        let weights = Weights::of(engine, &[])?;
        self.0 = Some((cylinders.iter().map(enters).collect(), plane.clone(), weights.clone()));
        Some(weights)
    }
}

impl Weights {
    /// Those of the force and the moment, of the pistons and then of these masses.
    fn of(engine: &Engine, turning: &[TurningMass]) -> Option<[Weights; 2]> {
        let cylinders = engine.cylinders();
        let pistons = cylinders.iter().map(|cylinder| (cylinder.weight(), &cylinder.position));
        let force: Vec<(BigRational, &BigRational)> =
            pistons.chain(turning.iter().map(|mass| (mass.weight(), &mass.position))).collect();
        let plane = engine.reference_plane();
        let moment: Vec<BigRational> =
            force.iter().map(|(weight, position)| fraction::times(weight, &fraction::minus(position, plane))).collect();
        let force: Vec<BigRational> = force.into_iter().map(|(weight, _)| weight).collect();
        Some([Weights::new(&force)?, Weights::new(&moment)?])
    }

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
