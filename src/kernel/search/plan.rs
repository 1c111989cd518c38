//! Which way does a search go, and what are its pieces?

use super::front::Pareto;
use super::join::{self, outer::Outer};
use super::space::Space;
use super::tables::Tables;
use super::walk::{Counts, Piece};
use super::{piece, symmetry};

/// How the stars are gone through.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// Outer sums meet inner sums, where each direction is taken a fixed number of times; on a grid the stars are walked.
    #[default]
    Join,
    /// Pair by pair from the outside, what cannot matter omitted by a bound.
    Walk,
}

/// The pieces of a search: a function of the question and the way alone.
pub(super) enum Plan {
    Join(Vec<Outer>),
    Walk(Vec<Piece>),
}

impl Plan {
    /// The plan, with the tables that it needs.
    pub fn new(space: &Space, way: Way) -> (Tables, Plan) {
        match (way, space.supply) {
            (Way::Join, Some(supply)) => (Tables::new(space), Plan::Join(join::outer::all(space, supply))),
            (Way::Join, None) | (Way::Walk, _) => {
                let tables = Tables::with_bounds(space);
                let pieces = piece::pieces(space, &tables);
                (tables, Plan::Walk(pieces))
            }
        }
    }

    /// Number of pieces.
    pub fn len(&self) -> usize {
        match self {
            Plan::Join(pieces) => pieces.len(),
            Plan::Walk(pieces) => pieces.len(),
        }
    }

    /// What the pieces are called in a state file.
    pub fn name(&self) -> &'static str {
        match self {
            Plan::Join(_) => "choices of outer directions",
            Plan::Walk(_) => "pieces",
        }
    }

    /// Judges the stars of a piece.
    pub fn run(&self, number: usize, space: &Space, tables: &Tables, front: Pareto) -> (Pareto, Counts) {
        match self {
            Plan::Join(pieces) => join::run(space, tables, &pieces[number], front),
            Plan::Walk(pieces) => piece::run(space, tables, &pieces[number], front),
        }
    }

    /// Whether there is such a piece, and a star of the question belongs to it.
    pub fn holds(&self, number: usize, space: &Space, throws: &[u16]) -> bool {
        match self {
            Plan::Join(pieces) => pieces.get(number).is_some_and(|outer| outer.holds(space, throws)),
            Plan::Walk(pieces) => {
                let (first, _) = symmetry::first_of_class(throws, space.directions);
                pieces.get(number).is_some_and(|piece| piece.holds(&first))
            }
        }
    }
}
