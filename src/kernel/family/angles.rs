//! At which angles of φ and δ do parts of equal length cancel?

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::part::Part;
use crate::engine::PHI;
use crate::exact::Turn;
use crate::proof::{AlternativeClaim, Certificate, ConditionClaim};

/// The angles at which parts of equal length cancel: for φ alone a list, for φ and δ a line of solutions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angles {
    /// One for two parts, two for three.
    pub alternatives: Vec<AlternativeClaim>,
    /// For three parts: evidence that they are equally long, `|S_1|² − |S_j|² = 0`.
    pub equal_lengths: Vec<Certificate>,
}

impl Angles {
    /// The values of one unknown, φ or δ, in a range at which a condition holds, in turns and with the ends of the range;
    /// `None` where the other one enters.
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        let mut all = BTreeSet::new();
        for alternative in &self.alternatives {
            let of = |condition: &ConditionClaim| values(condition, unknown, range);
            let sets = alternative.conditions.iter().map(of).collect::<Option<Vec<_>>>()?;
            all.extend(sets.into_iter().reduce(|common, set| common.intersection(&set).cloned().collect())?);
        }
        Some(all)
    }
}

/// The values of one unknown in a range, its ends among them, in turns; `None` where the other one enters.
fn values(
    ConditionClaim { phi, delta, turn }: &ConditionClaim,
    unknown: &str,
    [low, high]: [&BigRational; 2],
) -> Option<BTreeSet<BigRational>> {
    let (own, other) = if unknown == PHI { (phi, delta) } else { (delta, phi) };
    if !other.is_zero() || own.is_zero() {
        return None;
    }
    // px = t + m with low ≤ x ≤ high: m runs over the whole numbers between p low − t and p high − t.
    let ends = [own * low - turn, own * high - turn];
    let (mut m, last) = match own.is_positive() {
        true => (ends[0].ceil().to_integer(), ends[1].floor().to_integer()),
        false => (ends[1].ceil().to_integer(), ends[0].floor().to_integer()),
    };
    let mut values = BTreeSet::new();
    while m <= last {
        values.insert((turn + BigRational::from_integer(m.clone())) / own);
        m += BigInt::from(1);
    }
    Some(values)
}

/// The parts after the first, each turned against it by its angle.
pub(super) fn alternative(first: &Part, others: &[(&Part, Turn)]) -> AlternativeClaim {
    let conditions = others.iter().map(|(part, turn)| ConditionClaim {
        phi: &part.phi - &first.phi,
        delta: &part.delta - &first.delta,
        turn: turn.turns().clone(),
    });
    let sum = others.iter().fold(first.sum.clone(), |sum, (part, turn)| sum.plus(&part.sum.turned(turn)));
    AlternativeClaim { conditions: conditions.collect(), certificate: sum.certificate() }
}
