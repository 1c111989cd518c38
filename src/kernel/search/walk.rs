//! Which stars does one piece of the search come to, and which does it omit?

use super::front::Judge;
use super::problem::MOST_ORDERS;
use super::roots::BITS;
use super::space::Space;
use super::symmetry::{self, Same};
use super::tables::{AXES, Tables};
use super::{judged, value};

/// One piece of the search: the outermost pairs of throws, and which of their images are the same.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub pairs: Vec<(usize, usize)>,
    pub same: Same,
}

impl Piece {
    /// Whether a star begins like this.
    pub fn holds(&self, throws: &[u16]) -> bool {
        let ends = throws.iter().zip(throws.iter().rev()).map(|(&a, &b)| (usize::from(a), usize::from(b)));
        self.pairs.iter().copied().eq(ends.take(self.pairs.len()))
    }
}

/// What came of a piece.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    /// Stars judged, one per class of rotation, mirror and reversal.
    pub judged: u64,
    /// Starts omitted with all their completions, by the bound.
    pub cut: u64,
}

impl Counts {
    /// Both together; none where that is more than can be counted.
    pub fn plus(self, other: Counts) -> Option<Counts> {
        Some(Counts { judged: self.judged.checked_add(other.judged)?, cut: self.cut.checked_add(other.cut)? })
    }
}

/// Fills places pair by pair.
pub(super) struct Walk<'a, J> {
    space: &'a Space,
    tables: &'a Tables,
    pub judge: J,
    pub counts: Counts,
    throws: Vec<usize>,
    left: Vec<usize>,
    /// One digit per direction: how often it is left.
    code: usize,
    digits: Vec<usize>,
    /// Projections of what is placed, after each pair.
    sums: Vec<i64>,
    /// Where a piece ends, while pieces are listed.
    pub listing: Option<(usize, Vec<Piece>)>,
}

impl<'a, J: Judge> Walk<'a, J> {
    pub fn new(space: &'a Space, tables: &'a Tables, judge: J) -> Self {
        let base = space.supply.map_or(1, |supply| supply + 1);
        let digits = match space.supply {
            Some(_) => (0..space.directions).map(|direction| base.pow(direction as u32)).collect(),
            None => vec![0; space.directions],
        };
        let code = space.supply.map_or(0, |_| base.pow(space.directions as u32) - 1);
        Walk {
            space,
            tables,
            judge,
            counts: Counts::default(),
            throws: vec![0; space.places],
            left: vec![space.supply.unwrap_or(usize::MAX); space.directions],
            code,
            digits,
            sums: vec![0; (space.pairs() + 1) * tables.rows * AXES],
            listing: None,
        }
    }

    /// Fills the pairs from this one inwards.
    pub fn pair(&mut self, at: usize, same: Same) {
        if let Some((depth, pieces)) = &mut self.listing
            && *depth == at
        {
            let pair = |at: usize| (self.throws[at], self.throws[self.space.places - 1 - at]);
            return pieces.push(Piece { pairs: (0..at).map(pair).collect(), same });
        }
        if at == self.space.pairs() {
            return self.middle(same);
        }
        let directions = self.space.directions;
        for a in 0..if at == 0 { 1 } else { directions } {
            if self.left[a] == 0 {
                continue;
            }
            self.left[a] -= 1;
            for b in 0..directions {
                if self.left[b] == 0 {
                    continue;
                }
                let last = if at == 0 { b } else { self.throws[self.space.places - 1] };
                let Some(same) = symmetry::compare_pair(same, (a, b), last, directions) else { continue };
                self.left[a] += 1;
                self.put(at, a, b);
                if self.listing.is_some() || self.may_matter(at + 1) {
                    self.pair(at + 1, same);
                }
                self.take_back(at);
                self.left[a] -= 1;
            }
            self.left[a] += 1;
        }
    }

    pub fn put(&mut self, at: usize, a: usize, b: usize) {
        self.throws[at] = a;
        self.throws[self.space.places - 1 - at] = b;
        self.left[a] -= 1;
        self.left[b] -= 1;
        self.code -= self.digits[a] + self.digits[b];
        let (width, weight) = (AXES * self.tables.rows, self.space.weights[at]);
        for row in 0..self.tables.rows {
            let (first, second) = (self.tables.projections(row, a), self.tables.projections(row, b));
            let from = at * width + row * AXES;
            let is_force = row == self.space.orders.len();
            for axis in 0..AXES {
                // Arms of a pair are opposite; in the force both count alike.
                let step = if is_force { first[axis] + second[axis] } else { weight * (first[axis] - second[axis]) };
                self.sums[from + width + axis] = self.sums[from + axis] + step;
            }
        }
    }

    fn take_back(&mut self, at: usize) {
        let (a, b) = (self.throws[at], self.throws[self.space.places - 1 - at]);
        self.left[a] += 1;
        self.left[b] += 1;
        self.code += self.digits[a] + self.digits[b];
    }

    fn sums(&self, placed: usize, row: usize) -> &[i64] {
        let start = (placed * self.tables.rows + row) * AXES;
        &self.sums[start..start + AXES]
    }

    /// Whether a completion of the first pairs may be on the front, as far as the bounds tell.
    pub fn may_matter(&mut self, placed: usize) -> bool {
        let count = self.space.orders.len();
        let left = if self.space.supply.is_some() { self.code } else { placed };
        let mut low = [0_i128; MOST_ORDERS];
        for (order, low) in low.iter_mut().enumerate().take(count) {
            let lengths = self.sums(placed, order).iter().zip(self.tables.bounds(left, order));
            let least = lengths.map(|(sum, bound)| sum.abs() - bound).max().unwrap_or(0) - self.tables.doubt;
            *low = value::square(least.max(0), 0, 0).0;
        }
        let cannot_balance = self.space.pins_balance && {
            let longest = (self.space.places - 2 * placed) as i64 * ((1 << BITS) + 1);
            self.sums(placed, count).iter().any(|sum| sum.abs() > longest + self.tables.doubt)
        };
        let matters = !cannot_balance && !self.judge.hopeless(&low[..count]);
        self.counts.cut += u64::from(!matters);
        matters
    }

    /// The throw in the middle of an odd number: its arm is 0.
    fn middle(&mut self, same: Same) {
        let (places, directions) = (self.space.places, self.space.directions);
        if places.is_multiple_of(2) {
            return self.star(same);
        }
        let last = self.throws[places - 1];
        for throw in 0..if places == 1 { 1 } else { directions } {
            if self.left[throw] > 0
                && let Some(same) =
                    symmetry::compare_middle(same, throw, if places == 1 { 0 } else { last }, directions)
            {
                self.throws[places / 2] = throw;
                self.star(same);
            }
        }
    }

    fn star(&mut self, same: Same) {
        self.counts.judged += 1;
        let mut bounds = [(0_i128, 0_i128); MOST_ORDERS];
        let mut low = [0_i128; MOST_ORDERS];
        let count = self.space.orders.len();
        for order in 0..count {
            let sums = self.sums(self.space.pairs(), order);
            bounds[order] = value::square(sums[0], sums[AXES / 2], self.tables.doubt);
            low[order] = bounds[order].0;
        }
        if self.judge.hopeless(&low[..count]) {
            return;
        }
        let throws: Vec<u16> = self.throws.iter().map(|&throw| throw as u16).collect();
        if self.space.is_balanced(&throws) {
            let points = judged::points(self.space, throws, &bounds[..count], symmetry::class_size(same));
            points.into_iter().for_each(|point| self.judge.take(point));
        }
    }
}
