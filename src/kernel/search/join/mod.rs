//! Which stars of a choice of outer directions may be on the front? Outer sums meet the inner sums that nearly cancel them.

mod cells;
mod filling;
pub(super) mod outer;

use super::front::{Judge, Pareto};
use super::problem::MOST_ORDERS;
use super::space::Space;
use super::tables::Tables;
use super::walk::Counts;
use super::{judged, symmetry, value};
use cells::Cells;
use filling::{Arrangement, Filling, Group, still_same};
use outer::{Image, Outer};

/// Longer than every sum, and short enough to be added to one.
const EVERYWHERE: i64 = 1 << 60;

/// Judges the stars of a choice of outer directions.
pub(super) fn run(space: &Space, tables: &Tables, outer: &Outer, judge: Pareto) -> (Pareto, Counts) {
    let symmetries = outer.symmetries();
    let split = outer::pairs(space);
    let mut join = Join {
        space,
        tables,
        symmetries: &symmetries,
        inner: Inner::new(space, tables, outer),
        judge,
        counts: Counts::default(),
        reach: [EVERYWHERE; MOST_ORDERS],
        near: Vec::new(),
    };
    join.look_around();
    let visit = |arrangement: &Arrangement| join.meet(arrangement);
    let group = Group { first: 0, end: split, with_middle: false };
    Filling::all((space, tables), group, outer.counts.clone(), &symmetries, visit);
    (join.judge, join.counts)
}

/// Every way to fill the inner places.
struct Inner {
    /// Throws of one arrangement.
    places: usize,
    /// Directions, arrangement by arrangement.
    throws: Vec<u8>,
    /// Sums `x, y` of every order, arrangement by arrangement.
    sums: Vec<i64>,
    /// For each order.
    cells: Vec<Cells>,
}

impl Inner {
    fn new(space: &Space, tables: &Tables, outer: &Outer) -> Self {
        let split = outer::pairs(space);
        let supply = space.supply.unwrap_or(0);
        let counts: Vec<usize> = outer.counts.iter().map(|count| supply - count).collect();
        let (places, width) = (space.places - 2 * split, 2 * space.orders.len());
        let arrangements = arrangements(&counts);
        let (mut throws, mut sums) =
            (Vec::with_capacity(arrangements * places), Vec::with_capacity(arrangements * width));
        let visit = |arrangement: &Arrangement| {
            throws.extend(arrangement.throws.iter().map(|&throw| throw as u8));
            sums.extend_from_slice(arrangement.sums);
        };
        let group = Group { first: split, end: space.pairs(), with_middle: !space.places.is_multiple_of(2) };
        Filling::all((space, tables), group, counts, &[], visit);
        let of_order =
            |order: usize| Cells::new(sums.chunks_exact(width).map(move |s| [s[2 * order], s[2 * order + 1]]));
        let cells = (0..space.orders.len()).map(of_order).collect();
        Inner { places, throws, sums, cells }
    }
}

/// In how many ways directions, each so often, are put in a row.
fn arrangements(counts: &[usize]) -> usize {
    let (mut ways, mut places) = (1, 0);
    for &count in counts {
        // Whole after each step: a product of binomial coefficients.
        for taken in 1..=count {
            places += 1;
            ways = ways * places / taken;
        }
    }
    ways
}

struct Join<'a> {
    space: &'a Space,
    tables: &'a Tables,
    symmetries: &'a [Image],
    inner: Inner,
    judge: Pareto,
    counts: Counts,
    /// For each order how far from 0 a sum may be that is looked at.
    reach: [i64; MOST_ORDERS],
    near: Vec<u32>,
}

impl Join<'_> {
    /// What no star of the front beats is no longer than any one of them in some order: takes the one that leaves the least to look at.
    fn look_around(&mut self) {
        let mut least = u128::MAX;
        for point in self.judge.points().iter().filter(|point| point.is_least_beyond(self.space.orders.len())) {
            let mut reach = [EVERYWHERE; MOST_ORDERS];
            let mut effort = 0;
            let aims = point.values.iter().zip(&self.inner.cells);
            for (reach, (value, cells)) in reach.iter_mut().zip(aims) {
                *reach = (value.high as u128).isqrt() as i64 + 1 + self.tables.doubt;
                // Below 2^48 for the inner throws of twenty, so that the square has room for 30 bits more.
                let extent = cells.extent();
                effort += ((*reach).min(extent) as u128).pow(2) * (1 << 30) / (extent as u128).pow(2).max(1);
            }
            if effort < least {
                (least, self.reach) = (effort, reach);
            }
        }
    }

    fn meet(&mut self, outer: &Arrangement) {
        let orders = self.space.orders.len();
        let mut found = false;
        // One star of the front for all orders, though a better one comes up meanwhile.
        let reach = self.reach;
        for order in 0..orders {
            let mut near = std::mem::take(&mut self.near);
            near.clear();
            let sum = [outer.sums[2 * order], outer.sums[2 * order + 1]];
            self.inner.cells[order].near(sum, reach[order], &mut near);
            found |= !near.is_empty();
            near.iter().for_each(|&number| self.star(outer, number as usize, &reach[..order]));
            self.near = near;
            if reach[order] == EVERYWHERE {
                break;
            }
        }
        self.counts.cut += u64::from(!found);
    }

    /// A star that is short in an order; `reach` of the orders before, in which it has been looked at if it is short there too.
    fn star(&mut self, outer: &Arrangement, number: usize, reach: &[i64]) {
        let orders = self.space.orders.len();
        let inner = &self.inner.sums[2 * orders * number..2 * orders * (number + 1)];
        let mut sums = [0_i64; 2 * MOST_ORDERS];
        (0..2 * orders).for_each(|at| sums[at] = outer.sums[at] + inner[at]);
        let is_short =
            |(order, reach): (usize, &i64)| sums[2 * order].abs() <= *reach && sums[2 * order + 1].abs() <= *reach;
        let throws = &self.inner.throws[self.inner.places * number..self.inner.places * (number + 1)];
        if reach.iter().enumerate().any(is_short) || !self.is_first(outer.same, throws) {
            return;
        }
        self.counts.judged += 1;
        let mut bounds = [(0_i128, 0_i128); MOST_ORDERS];
        let mut low = [0_i128; MOST_ORDERS];
        for order in 0..orders {
            bounds[order] = value::square(sums[2 * order], sums[2 * order + 1], self.tables.doubt);
            low[order] = bounds[order].0;
        }
        if self.judge.hopeless(&low[..orders]) {
            return;
        }
        let mut star = vec![0_u16; self.space.places];
        let filled = outer.throws.iter().copied().chain(throws.iter().map(|&throw| usize::from(throw)));
        self.space.sequence.iter().zip(filled).for_each(|(&place, throw)| star[place] = throw as u16);
        let (star, size) = symmetry::first_of_class(&star, self.space.directions);
        judged::points(self.space, star, &bounds[..orders], size).into_iter().for_each(|point| self.judge.take(point));
        self.look_around();
    }

    /// Whether no image that leaves the outer throws as they are puts the inner ones before these.
    fn is_first(&self, same: u128, throws: &[u8]) -> bool {
        let directions = self.space.directions;
        let mut same = same;
        for pair in throws.chunks(2) {
            let still = match *pair {
                [a, b] => {
                    let own = (usize::from(a), usize::from(b));
                    still_same(same, self.symmetries, &own, |image| image.of_pair(own, directions))
                }
                [throw] => {
                    still_same(same, self.symmetries, &usize::from(throw), |image| image.of(throw.into(), directions))
                }
                _ => Some(same),
            };
            match still {
                Some(0) => return true,
                Some(still) => same = still,
                None => return false,
            }
        }
        true
    }
}
