//! What is proved of one order: its sums, one for each coefficient, and so whether the whole is zero?

use super::coefficient::Coefficient;
use super::collected::Collected;
use super::quantity::{Quantity, Sense};

/// The sums before one coefficient, one for each sense of the quantity, each proved to be zero or not.
pub(super) struct JudgedGroup {
    pub coefficient: Coefficient,
    /// Whether the coefficient is zero.
    pub is_zero: bool,
    pub sums: Vec<(Collected, bool)>,
}

impl JudgedGroup {
    /// With a sum in one sense; of the other nothing is said.
    pub fn of_sense(coefficient: Coefficient, is_zero: bool, sense: usize, sum: (Collected, bool)) -> Self {
        let mut sums = vec![(Collected::new(), true); Sense::BOTH.len()];
        sums[sense] = sum;
        JudgedGroup { coefficient, is_zero, sums }
    }
}

/// An order of a quantity.
pub(super) struct Judged {
    pub quantity: Quantity,
    pub order: u32,
    pub groups: Vec<JudgedGroup>,
    /// For each sense whether the whole is zero; none where that is not decided. Of a single sum that is multiplied by zero
    /// it says what the sum is.
    pub wholes: Vec<Option<bool>>,
}

impl Judged {
    /// What counts in a sense: the sums that are not zero, before coefficients that are not.
    pub fn left(&self, sense: usize) -> Vec<&JudgedGroup> {
        self.groups.iter().filter(|group| !group.is_zero && !group.sums[sense].1).collect()
    }

    /// Whether some source has the order, before a coefficient that is not zero.
    pub fn exists(&self) -> bool {
        self.groups.iter().any(|group| !group.is_zero)
    }

    /// Whether the order is zero in a sense, the coefficients counted too.
    pub fn vanishes(&self, sense: usize) -> Option<bool> {
        if self.exists() { self.wholes[sense] } else { Some(true) }
    }
}
