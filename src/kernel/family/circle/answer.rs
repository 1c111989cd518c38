//! What do the arcs of a circle say? Rational zeros, irrational ones, and what is left open.

use num_rational::BigRational;

use super::arcs::Circle;
use crate::exact::Turn;
use crate::proof::ArcClaim;

impl Circle {
    /// Whether every arc is known.
    pub fn is_complete(&self) -> bool {
        self.open().next().is_none()
    }

    /// The arcs that are not known, in turns of u.
    pub fn open(&self) -> impl Iterator<Item = [&BigRational; 2]> {
        let arcs = &self.claim.arcs;
        let starts = [&self.claim.from].into_iter().chain(arcs.iter().map(ArcClaim::to));
        starts.zip(arcs).filter_map(|(from, arc)| match arc {
            ArcClaim::Open { to } => Some([from, to]),
            ArcClaim::Free { .. }
            | ArcClaim::Monotone { .. }
            | ArcClaim::Crossing { .. }
            | ArcClaim::Rational { .. } => None,
        })
    }

    /// The zeros that are rational turns of u, in [0, 1).
    pub fn rational(&self) -> impl Iterator<Item = Turn> + '_ {
        self.rational_in_order().map(|at| Turn::new(at.clone()))
    }

    /// The same as they follow each other on the arcs.
    pub(in super::super) fn rational_in_order(&self) -> impl Iterator<Item = &BigRational> {
        self.claim.arcs.iter().filter_map(|arc| match arc {
            ArcClaim::Rational { at, .. } => Some(at),
            ArcClaim::Free { .. } | ArcClaim::Monotone { .. } | ArcClaim::Crossing { .. } | ArcClaim::Open { .. } => {
                None
            }
        })
    }

    /// Between which turns of u each irrational zero is, narrowly.
    pub fn irrational(&self) -> impl Iterator<Item = [&BigRational; 2]> {
        self.near.iter().map(|ends| ends.each_ref())
    }

    /// Whether it is shown to vanish nowhere.
    pub fn is_free(&self) -> bool {
        self.claim.arcs.iter().all(|arc| match arc {
            ArcClaim::Free { .. } | ArcClaim::Monotone { .. } => true,
            ArcClaim::Crossing { .. } | ArcClaim::Rational { .. } | ArcClaim::Open { .. } => false,
        })
    }
}
