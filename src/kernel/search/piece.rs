//! Which pieces is a search cut into, and what comes of one?

use super::front::{Judge, StarValues};
use super::space::Space;
use super::tables::Tables;
use super::walk::{Counts, Piece, Walk};

/// Above this many directions a piece fixes one pair, else two.
const COARSE: usize = 24;

/// All pieces, in the order of their numbers: a function of the space alone.
pub(super) fn pieces(space: &Space, tables: &Tables) -> Vec<Piece> {
    let depth = if space.directions <= COARSE { 2 } else { 1 };
    let mut walk = Walk::new(space, tables, Everything);
    walk.listing = Some((depth.min(space.pairs()), Vec::new()));
    walk.pair(0, [true; 3]);
    walk.listing.map(|(_, pieces)| pieces).unwrap_or_default()
}

/// Judges the stars of a piece.
pub(super) fn run<J: Judge>(space: &Space, tables: &Tables, piece: &Piece, judge: J) -> (J, Counts) {
    let mut walk = Walk::new(space, tables, judge);
    for (at, &(a, b)) in piece.pairs.iter().enumerate() {
        walk.put(at, a, b);
    }
    let placed = piece.pairs.len();
    if walk.may_matter(placed) {
        walk.pair(placed, piece.same);
    }
    (walk.judge, walk.counts)
}

/// Where pieces are listed no star is evaluated.
struct Everything;

impl Judge for Everything {
    fn hopeless(&self, _: &[i128]) -> bool {
        false
    }
    fn take(&mut self, _: StarValues) {}
}
