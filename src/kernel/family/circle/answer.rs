//! What do the arcs of a circle say? Rational zeros, irrational ones, and what is left open.

use num_rational::BigRational;

use super::arcs::{Circle, Kind};
use crate::exact::Turn;

impl Circle {
    /// The arcs with both of their ends.
    pub fn pieces(&self) -> impl Iterator<Item = ([&BigRational; 2], &Kind)> {
        let starts = [&self.from].into_iter().chain(self.arcs.iter().map(|arc| &arc.to));
        starts.zip(&self.arcs).map(|(from, arc)| ([from, &arc.to], &arc.kind))
    }

    /// Whether every arc is known.
    pub fn is_complete(&self) -> bool {
        self.open().next().is_none()
    }

    /// The arcs that are not known, in turns of u.
    pub fn open(&self) -> impl Iterator<Item = [&BigRational; 2]> {
        self.pieces().filter_map(|(ends, kind)| match kind {
            Kind::Open => Some(ends),
            Kind::Free | Kind::Monotone | Kind::Crossing { .. } | Kind::Rational { .. } => None,
        })
    }

    /// The zeros that are rational turns of u, in [0, 1).
    pub fn rational(&self) -> impl Iterator<Item = Turn> + '_ {
        self.rational_in_order().map(|at| Turn::new(at.clone()))
    }

    /// The same as they follow each other on the arcs.
    pub(in super::super) fn rational_in_order(&self) -> impl Iterator<Item = &BigRational> {
        self.arcs.iter().filter_map(|arc| match &arc.kind {
            Kind::Rational { at, .. } => Some(at),
            Kind::Free | Kind::Monotone | Kind::Crossing { .. } | Kind::Open => None,
        })
    }

    /// Between which turns of u each irrational zero is, narrowly.
    pub fn irrational(&self) -> impl Iterator<Item = [&BigRational; 2]> {
        self.pieces().filter_map(|(_, kind)| match kind {
            Kind::Crossing { near } => Some(near.each_ref()),
            Kind::Free | Kind::Monotone | Kind::Rational { .. } | Kind::Open => None,
        })
    }

    /// Whether it is shown to vanish nowhere.
    pub fn is_free(&self) -> bool {
        self.pieces().all(|(_, kind)| match kind {
            Kind::Free | Kind::Monotone => true,
            Kind::Crossing { .. } | Kind::Rational { .. } | Kind::Open => false,
        })
    }
}
