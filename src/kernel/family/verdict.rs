//! What is known of an order with open angles and lengths?

use super::angles::Angles;
use super::part::Part;
use super::range::in_range;
use super::when::When;
use crate::proof::{ConditionClaim, Planar, Sense};

/// The part of a sum that one length multiplies.
#[derive(Clone, Debug)]
pub struct OpenSum {
    /// The open length, or none for the known lengths (and for the force).
    pub symbol: Option<String>,
    /// The sums by the multiples of φ and δ that they are turned by.
    pub parts: Vec<Part>,
    /// When it vanishes.
    pub when: When,
}

impl OpenSum {
    /// The parts that do not vanish.
    pub fn left(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().filter(|part| !part.certificate.claims_zero())
    }

    /// The angles, where they are conditions of rational turns.
    pub fn angles(&self) -> Option<&Angles> {
        match &self.when {
            When::Where(angles) => Some(angles),
            _ => None,
        }
    }
}

/// When one quantity, order and sense vanishes, whatever the open lengths are.
#[derive(Clone, Debug)]
pub struct OpenVerdict {
    /// Force or moment.
    pub quantity: Planar,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// One sum per length; none where no term has a weight.
    pub sums: Vec<OpenSum>,
    /// Whether some piston has the order: it is 0 else, whatever its sums are.
    pub exists: bool,
}

impl OpenVerdict {
    /// Whether it vanishes for all angles and lengths.
    pub fn always(&self) -> bool {
        !self.exists || self.sums.iter().all(|sum| matches!(sum.when, When::Always))
    }

    /// Whether it vanishes for no angle, whatever the lengths are.
    pub fn never(&self) -> bool {
        self.exists && self.sums.iter().any(|sum| matches!(sum.when, When::Never(_)))
    }

    /// Whether given lengths may make it vanish where it does not for all: the sums of several lengths may cancel.
    pub fn hangs_on_lengths(&self) -> bool {
        self.sums.iter().filter(|sum| !matches!(sum.when, When::Always)).count() > 1
    }

    /// The conditions under which the sums of all lengths vanish at once: alternatives, none where they contradict each other or hold for no angles
    /// in the range. None where a sum vanishes by something else than such conditions.
    pub fn meeting(&self) -> Option<Vec<Vec<ConditionClaim>>> {
        let mut met: Vec<Vec<ConditionClaim>> = vec![Vec::new()];
        for sum in self.sums.iter().filter(|sum| !matches!(sum.when, When::Always)) {
            let alternatives = &sum.angles()?.alternatives;
            let mut both = Vec::new();
            for conditions in
                met.iter().flat_map(|known| alternatives.iter().map(move |one| [&known[..], &one.conditions].concat()))
            {
                both.extend(in_range(&conditions).filter(|conditions| !both.contains(conditions)));
            }
            met = both;
        }
        Some(met)
    }
}

/// The verdicts on one order.
#[derive(Clone, Debug)]
pub struct OpenOrder {
    /// The order k.
    pub order: u32,
    /// Force, direct and reverse.
    pub force: [OpenVerdict; 2],
    /// Moment, direct and reverse.
    pub moment: [OpenVerdict; 2],
}

impl OpenOrder {
    /// The verdicts on both vectors of the force or the moment.
    pub fn verdicts(&self, quantity: Planar) -> &[OpenVerdict; 2] {
        quantity.choose(&self.force, &self.moment)
    }
}
