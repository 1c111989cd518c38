//! Where on the torus of two unknowns does a sum vanish that no reduction fits? Cut into boxes, each with what is known of it.
//!
//! Theory, section 17: on a box a sum is free where it keeps away from 0, and about a simple zero Krawczyk's test shows that it is the only
//! one. Where neither is found before the count of boxes ends, the box is named as open.

mod evaluator;
mod spot;
mod subdivider;
mod torus;

use num_rational::BigRational;

use crate::proof::BoxesClaim;
pub(in super::super) use subdivider::solve;

/// The torus of two unknowns, cut into boxes.
#[derive(Clone, Debug)]
pub struct Boxes {
    /// The boxes, and the zeros that are alone in theirs.
    pub claim: BoxesClaim,
    /// The zeros in decimals, in turns of s and t.
    pub near: Vec<[f64; 2]>,
    /// Where it is not known: from and to, of s and of t, in turns; boxes that touch are given as one.
    pub open: Vec<[[BigRational; 2]; 2]>,
}

impl Boxes {
    /// Whether every box is known.
    pub fn is_complete(&self) -> bool {
        self.open.is_empty()
    }

    /// Whether no box has a zero.
    pub(in super::super) fn is_never(&self) -> bool {
        self.claim.zeros.is_empty() && self.is_complete()
    }

    /// How many boxes there are.
    pub fn count(&self) -> usize {
        self.claim.tree.chars().filter(|letter| !['s', 't'].contains(letter)).count()
    }
}
