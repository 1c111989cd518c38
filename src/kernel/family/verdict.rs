//! What is known of an order with open angles and lengths?

use super::part::Part;
use super::when::When;
use crate::proof::{Planar, Sense};

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
