//! What was checked so far, and how much may the rest cost?
//!
//! Steps are counted and not seconds, so that a document is accepted on every machine or on none.

use std::cell::{Cell, RefCell};
use std::fmt;
use std::rc::Rc;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::certificate::Certificate;
use super::enclosure::Circle;
use super::refusal::{MOST_STEPS, Refusal};

/// How many certificates of each kind were checked, and how many decimals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Sums that are zero, by polygons.
    pub polygons: usize,
    /// Sums that are not zero, by a residue.
    pub residues: usize,
    /// Sums that are not zero, by a splitting.
    pub splittings: usize,
    /// Lengths and directions in decimals.
    pub decimals: usize,
}

impl Counts {
    /// All certificates.
    pub fn certificates(&self) -> usize {
        self.polygons + self.residues + self.splittings
    }
}

/// The course of one check.
#[derive(Debug)]
pub(super) struct Audit {
    left: Cell<u64>,
    counts: Cell<Counts>,
    circles: RefCell<Vec<Rc<Circle>>>,
}

impl Audit {
    pub fn new() -> Self {
        Audit { left: Cell::new(MOST_STEPS), counts: Cell::default(), circles: RefCell::default() }
    }

    /// Takes steps off what may still be spent, before they are done.
    pub fn spend(&self, steps: u64) -> Result<(), Refusal> {
        let left = self.left.get().checked_sub(steps).ok_or(Refusal::TooManySteps)?;
        self.left.set(left);
        Ok(())
    }

    /// Counts a certificate that holds.
    pub fn count(&self, certificate: &Certificate) {
        let mut counts = self.counts.get();
        match certificate {
            Certificate::Polygons { .. } => counts.polygons += 1,
            Certificate::Residue(_) => counts.residues += 1,
            Certificate::Splitting { .. } => counts.splittings += 1,
        }
        self.counts.set(counts);
    }

    /// Counts decimals that hold.
    pub fn count_decimals(&self, decimals: usize) {
        let counts = self.counts.get();
        self.counts.set(Counts { decimals: counts.decimals + decimals, ..counts });
    }

    pub fn counts(&self) -> Counts {
        self.counts.get()
    }

    /// Cosines and sines to this many bits.
    pub fn circle(&self, bits: u32) -> Rc<Circle> {
        let mut circles = self.circles.borrow_mut();
        if let Some(circle) = circles.iter().find(|circle| circle.bits() == bits) {
            return Rc::clone(circle);
        }
        let circle = Rc::new(Circle::new(bits));
        circles.push(Rc::clone(&circle));
        circle
    }
}

/// Steps of one operation on numbers of this size: as in long division, the square of their words.
pub(super) fn steps_of(number: &BigRational) -> u64 {
    squared_words(number.numer()) + squared_words(number.denom())
}

/// Steps of what is computed with some numbers: those of the longest.
pub(super) fn steps_of_longest<'a>(numbers: impl IntoIterator<Item = &'a BigRational>) -> u64 {
    numbers.into_iter().map(steps_of).max().unwrap_or(1)
}

/// The square of the number of machine words.
pub(super) fn squared_words(number: &BigInt) -> u64 {
    let words = number.bits() / 64 + 1;
    words.saturating_mul(words)
}

/// Why something in a document is not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It does not hold, or is not said as it has to be.
    Wrong(String),
    /// The check would take more than [`MOST_STEPS`].
    TooManySteps,
}

/// Holds, or is refused for this reason.
pub(super) fn demand<E>(holds: bool, why: E) -> Result<(), E> {
    if holds { Ok(()) } else { Err(why) }
}

/// Is refused for this reason where that is so.
pub(super) fn refuse_if<E>(is_so: bool, why: E) -> Result<(), E> {
    demand(!is_so, why)
}

impl Reason {
    /// Tells where it belongs.
    pub(super) fn within(self, place: impl fmt::Display) -> Self {
        match self {
            Reason::Wrong(words) => Reason::Wrong(format!("{place}: {words}")),
            Reason::TooManySteps => Reason::TooManySteps,
        }
    }
}

impl From<String> for Reason {
    fn from(words: String) -> Self {
        Reason::Wrong(words)
    }
}

impl From<&str> for Reason {
    fn from(words: &str) -> Self {
        Reason::Wrong(words.to_owned())
    }
}

impl From<Refusal> for Reason {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::TooManySteps => Reason::TooManySteps,
            refusal => Reason::Wrong(refusal.to_string()),
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::Wrong(words) => f.write_str(words),
            Reason::TooManySteps => Refusal::TooManySteps.fmt(f),
        }
    }
}

/// What is wrong with a document: where, and why.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {reason}")]
pub struct Fault {
    /// Which entry, as in `verdicts[3] (force, order 2, direct)`.
    pub place: String,
    /// What is wrong with it.
    pub reason: Reason,
}

impl Fault {
    pub(super) fn new(place: impl Into<String>, reason: impl Into<Reason>) -> Self {
        Fault { place: place.into(), reason: reason.into() }
    }
}
