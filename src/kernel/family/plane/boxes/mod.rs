//! Where on the torus of two unknowns does a sum vanish that no reduction fits? Cut into boxes, each with what is known of it.
//!
//! Theory, section 17: on a box a sum is free where it keeps away from 0, and about a simple zero Krawczyk's test shows that it is the only
//! one. Where neither is found before the count of boxes ends, the box is named as open.

mod evaluator;
mod spot;
mod subdivider;
mod torus;

use num_rational::BigRational;

use crate::exact::Turn;
use crate::proof::Certificate;
pub(in super::super) use subdivider::solve;

/// The torus of s and t, which φ and δ turn, cut into boxes.
#[derive(Clone, Debug)]
pub struct Boxes {
    /// How many times φ enters s, and δ enters t: all parts are turned by whole multiples of s and t.
    pub times: [BigRational; 2],
    /// The boxes, from the whole torus on: `s` and `t` cut in two across s or t, first half first; `0` no zero, `1` within one of
    /// the zeros' boxes, `?` open.
    pub tree: String,
    /// The zeros, each alone in a box about it.
    pub zeros: Vec<BoxZero>,
    /// Where it is not known: from and to, of s and of t, in turns; boxes that touch are given as one.
    pub open: Vec<[[BigRational; 2]; 2]>,
}

/// A zero that is alone in its box.
#[derive(Clone, Debug)]
pub struct BoxZero {
    /// The middle of the box, in turns of s and t.
    pub middle: [BigRational; 2],
    /// Half of its width, in turns.
    pub reach: BigRational,
    /// Evidence that the middle is the zero, where it is.
    pub certificate: Option<Certificate>,
    /// The zero in decimals, in turns.
    pub near: [f64; 2],
}

impl BoxZero {
    /// The zero, where both turns are rational.
    pub fn exact(&self) -> Option<[Turn; 2]> {
        self.certificate.as_ref().map(|_| self.middle.clone().map(Turn::new))
    }
}

impl Boxes {
    /// Whether every box is known.
    pub fn is_complete(&self) -> bool {
        self.open.is_empty()
    }

    /// Whether no box has a zero.
    pub(in super::super) fn is_never(&self) -> bool {
        self.zeros.is_empty() && self.is_complete()
    }

    /// How many boxes there are.
    pub fn count(&self) -> usize {
        self.tree.chars().filter(|letter| !['s', 't'].contains(letter)).count()
    }
}
