//! At which angles of φ and δ do parts of equal length cancel?

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::part::Part;
use crate::engine::PHI;
use crate::exact::Turn;
use crate::proof::Certificate;

/// The angles at which parts of equal length cancel: for φ alone a list, for φ and δ a line of solutions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angles {
    /// One for two parts, two for three.
    pub alternatives: Vec<Alternative>,
    /// For three parts: evidence that they are equally long, `|S_1|² − |S_j|² = 0`.
    pub equal_lengths: Vec<Certificate>,
}

/// Conditions that hold together, one for each part after the first, on how it is turned against the first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alternative {
    /// `x_j − x_1 ≡ turn`, for j = 2 (and 3).
    pub conditions: Vec<Condition>,
    /// Evidence that the parts turned so cancel.
    pub certificate: Certificate,
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
    /// The values of one unknown in a range, its ends among them, in turns; `None` where the other one enters.
    fn values(&self, unknown: &str, [low, high]: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        let (own, other) = if unknown == PHI { (&self.phi, &self.delta) } else { (&self.delta, &self.phi) };
        if !other.is_zero() || own.is_zero() {
            return None;
        }
        // px = t + m with low ≤ x ≤ high: m runs over the whole numbers between p low − t and p high − t.
        let ends = [own * low - self.turn.turns(), own * high - self.turn.turns()];
        let (mut m, last) = match own.is_positive() {
            true => (ends[0].ceil().to_integer(), ends[1].floor().to_integer()),
            false => (ends[1].ceil().to_integer(), ends[0].floor().to_integer()),
        };
        let mut values = BTreeSet::new();
        while m <= last {
            values.insert((self.turn.turns() + BigRational::from_integer(m.clone())) / own);
            m += BigInt::from(1);
        }
        Some(values)
    }
}

impl Angles {
    /// The values of one unknown, φ or δ, in a range at which a condition holds, in turns and with the ends of the range;
    /// `None` where the other one enters.
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        let mut all = BTreeSet::new();
        for alternative in &self.alternatives {
            let of = |condition: &Condition| condition.values(unknown, range);
            let sets = alternative.conditions.iter().map(of).collect::<Option<Vec<_>>>()?;
            all.extend(sets.into_iter().reduce(|common, set| common.intersection(&set).cloned().collect())?);
        }
        Some(all)
    }
}

/// The parts after the first, each turned against it by its angle.
pub(super) fn alternative(first: &Part, others: &[(&Part, Turn)]) -> Alternative {
    let conditions = others.iter().map(|(part, turn)| Condition {
        phi: &part.phi - &first.phi,
        delta: &part.delta - &first.delta,
        turn: turn.clone(),
    });
    let sum = others.iter().fold(first.sum.clone(), |sum, (part, turn)| sum.plus(&part.sum.turned(turn)));
    Alternative { conditions: conditions.collect(), certificate: sum.certificate() }
}
