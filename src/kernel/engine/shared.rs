//! Which pistons share a cylinder? Opposed ones, with one pressure between them.

use num_rational::BigRational;
use num_traits::One;

use super::cylinder::{firing_pistons, is_second, partner};
use super::model::Engine;
use crate::exact::Turn;

impl<A, L> Engine<A, L> {
    /// The piston that faces the one at this index in one cylinder, by its own; none of a piston with a cylinder of its own.
    pub fn partner(&self, index: usize) -> Option<usize> {
        partner(self.cylinders(), index)
    }

    /// The pistons of the cylinder for which this one stands.
    pub fn pistons_of(&self, first: usize) -> impl Iterator<Item = usize> + Clone + use<A, L> {
        std::iter::once(first).chain(self.partner(first))
    }

    /// Whether another piston, which faces it, stands for its cylinder.
    pub fn is_second_piston(&self, index: usize) -> bool {
        is_second(&self.cylinders()[index])
    }

    /// Whether two pistons share some cylinder.
    pub fn has_opposed_pistons(&self) -> bool {
        self.cylinders().iter().any(|cylinder| cylinder.shared.is_some())
    }

    /// The pistons by which cylinders are told: all but the second of two in one.
    pub fn firing_pistons(&self) -> Vec<usize> {
        firing_pistons(self.cylinders())
    }
}

impl Engine {
    /// By how much the crank of the piston at this index is ahead of that of the one that faces it, each from its own dead centre, in turns from
    /// −½ to ½; none of a piston with a cylinder of its own.
    pub fn lead(&self, index: usize) -> Option<BigRational> {
        let partner = self.partner(index)?;
        let is_second = self.is_second_piston(index);
        let [first, second] = if is_second { [partner, index] } else { [index, partner] };
        let top = |index: usize| self.cylinders()[index].top_dead_centre();
        let later = nearest(&(&top(second) - &top(first)));
        Some(if is_second { -later } else { later })
    }

    /// Whether all cylinders have two pistons, with the same motions in all.
    pub fn pairs_are_alike(&self) -> bool {
        let kind = |index: usize| {
            let (own, other) = (&self.cylinders()[index], &self.cylinders()[self.partner(index)?]);
            Some((&own.mechanism, &other.mechanism, &own.crank_radius / &other.crank_radius, self.lead(index)))
        };
        let mut kinds = self.firing_pistons().into_iter().map(kind);
        let first = kinds.next().flatten();
        first.is_some() && kinds.all(|kind| kind == first)
    }
}

/// A turn as a number from above −½ to ½.
fn nearest(turn: &Turn) -> BigRational {
    let turns = turn.turns().clone();
    let half = BigRational::new(1.into(), 2.into());
    if turns > half { turns - BigRational::one() } else { turns }
}
