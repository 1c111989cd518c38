//! When does `S_1 e^{ix_1} + S_2 e^{ix_2} + … = 0`, with x linear in φ and δ?
//!
//! One part never vanishes. Two do iff |S_1| = |S_2| and `x_2 − x_1 ≡ arg S_1 − arg S_2 + 180°`. Three of equal length do
//! iff they stand 120° apart; the rest is not solved here, and said so.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::Part;
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction};
use crate::proof::Certificate;

/// When a sum vanishes.
#[derive(Clone, Debug)]
pub enum When {
    /// For all angles: every part is gone.
    Always,
    /// For no angles.
    Never(Never),
    /// Exactly where one of these conditions holds.
    Where(Angles),
    /// At no rational angle: exactly where `phi·φ + delta·δ` is an angle that is no rational turn, in degrees.
    Irrational {
        /// How many times φ enters.
        phi: BigRational,
        /// How many times δ enters.
        delta: BigRational,
        /// The angle in degrees, approximately.
        degrees: f64,
    },
    /// This many parts are too many to solve for.
    NotSolved(usize),
}

/// Why a sum never vanishes.
#[derive(Clone, Debug)]
pub enum Never {
    /// One part is left.
    OnePart,
    /// Two parts of different length: evidence that `|S_1|² − |S_2|²` is not zero.
    UnequalLengths(Certificate),
}

/// `phi·φ + delta·δ ≡ turn`: for φ alone a list of angles, else a line of solutions; several lines for three parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angles {
    /// Each a set of conditions that hold together.
    pub alternatives: Vec<Vec<Condition>>,
}

/// `phi·φ + delta·δ ≡ turn` modulo a turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// How many times φ enters.
    pub phi: BigRational,
    /// How many times δ enters.
    pub delta: BigRational,
    /// What it must be.
    pub turn: Turn,
}

impl Condition {
    /// The angles φ in (0°, 360°); `None` where δ enters.
    fn bank_angles(&self) -> Option<BTreeSet<Turn>> {
        if !self.delta.is_zero() || self.phi.is_zero() {
            return None;
        }
        // pφ = t + m with 0 < φ < 1: m runs over the whole numbers between −t and p − t.
        let (low, high) = if self.phi.is_positive() {
            (BigRational::zero(), self.phi.clone())
        } else {
            (self.phi.clone(), BigRational::zero())
        };
        let mut m = (low - self.turn.turns()).floor().to_integer();
        let last = (high - self.turn.turns()).ceil().to_integer();
        let mut angles = BTreeSet::new();
        while m <= last {
            let phi = (self.turn.turns() + BigRational::from_integer(m.clone())) / &self.phi;
            if phi.is_positive() && phi < BigRational::from_integer(1.into()) {
                angles.insert(Turn::new(phi));
            }
            m += BigInt::from(1);
        }
        Some(angles)
    }
}

impl Angles {
    /// The angles φ in (0°, 360°) at which a condition holds; `None` where δ enters.
    pub fn bank_angles(&self) -> Option<BTreeSet<Turn>> {
        let mut all = BTreeSet::new();
        for together in &self.alternatives {
            let sets = together.iter().map(Condition::bank_angles).collect::<Option<Vec<_>>>()?;
            all.extend(sets.into_iter().reduce(|common, set| common.intersection(&set).cloned().collect())?);
        }
        Some(all)
    }
}

/// When the parts sum to zero.
pub(super) fn when(parts: &[&Part]) -> When {
    match parts {
        [] => When::Always,
        [_] => When::Never(Never::OnePart),
        [first, second] => two(first, second),
        [first, second, third] => three(first, second, third),
        more => When::NotSolved(more.len()),
    }
}

fn length_difference(a: &PhasorSum, b: &PhasorSum) -> Certificate {
    PhasorSum::new(a.squared_modulus().minus(&b.squared_modulus()).collected()).certificate()
}

fn two(first: &Part, second: &Part) -> When {
    let comparison = length_difference(&first.sum, &second.sum);
    if !comparison.claims_zero() {
        return When::Never(Never::UnequalLengths(comparison));
    }
    let quotient = first.sum.times(&second.sum.conjugate());
    let (phi, delta) = (&second.phi - &first.phi, &second.delta - &first.delta);
    match numbers::direction_of(&quotient) {
        Some(Direction::Turn(turn)) => {
            When::Where(Angles { alternatives: vec![vec![condition(phi, delta, turn.opposite())]] })
        }
        _ => {
            let degrees = numbers::evaluate(&quotient).arg().to_degrees() + 180.0;
            When::Irrational { phi, delta, degrees }
        }
    }
}

/// The same condition with φ, or else δ, entering positively.
fn condition(phi: BigRational, delta: BigRational, turn: Turn) -> Condition {
    if phi.is_negative() || phi.is_zero() && delta.is_negative() {
        Condition { phi: -phi, delta: -delta, turn: -&turn }
    } else {
        Condition { phi, delta, turn }
    }
}

/// Three vectors of equal length sum to zero iff they stand 120° apart, in either order.
fn three(first: &Part, second: &Part, third: &Part) -> When {
    let equal = |a: &Part, b: &Part| length_difference(&a.sum, &b.sum).claims_zero();
    let relative = |part: &Part| match numbers::direction_of(&first.sum.times(&part.sum.conjugate())) {
        Some(Direction::Turn(turn)) => Some(turn),
        _ => None,
    };
    let (true, true, Some(to_second), Some(to_third)) =
        (equal(first, second), equal(first, third), relative(second), relative(third))
    else {
        return When::NotSolved(3);
    };
    let apart = |part: &Part, relative: &Turn, thirds: i64| {
        condition(&part.phi - &first.phi, &part.delta - &first.delta, relative + &Turn::fraction(thirds, 3))
    };
    let alternatives = [1, 2].map(|thirds| vec![apart(second, &to_second, thirds), apart(third, &to_third, -thirds)]);
    When::Where(Angles { alternatives: alternatives.to_vec() })
}
