//! How small can a moment still become? Projections in fixed point, and bounds for what is not placed yet.
//!
//! Whole numbers scaled by 2^40; every entry is off by less than one unit, so a sum of entries with whole weights is off by
//! less than the sum of the moduli of the weights. Nothing here decides a tie: see `value`.

use super::roots::cosine;
use super::space::Space;
use crate::exact::Turn;

/// Axes that vectors are projected on, spread over half a turn.
pub(super) const AXES: usize = 8;

/// Projections of unit vectors and of the best that is left, on the axes.
pub(super) struct Tables {
    /// Rows: the orders, and order 1 once more for the force of an uneven star.
    pub rows: usize,
    /// How far a sum of one star may be off: the sum of the moduli of its weights, in units.
    pub doubt: i64,
    directions: usize,
    projections: Vec<i64>,
    bounds: Vec<i64>,
    orders: usize,
}

impl Tables {
    pub fn new(space: &Space) -> Self {
        let force = space.pins_balance.then_some(1);
        let rows: Vec<u32> = space.orders.iter().copied().chain(force).collect();
        let mut projections = Vec::with_capacity(rows.len() * space.directions * AXES);
        for &order in &rows {
            for direction in 0..space.directions as i64 {
                let angle = Turn::fraction(direction * i64::from(order), space.directions as i64);
                projections.extend((0..AXES as i64).map(|axis| cosine(&(&angle - &axis_angle(axis)))));
            }
        }
        let weights: i64 = space.weights.iter().map(|weight| weight.abs()).sum();
        let doubt = weights.max(space.places as i64);
        let (directions, orders) = (space.directions, space.orders.len());
        Tables { rows: rows.len(), doubt, directions, projections, bounds: Vec::new(), orders }
    }

    /// The same with the bounds that the walk needs.
    pub fn with_bounds(space: &Space) -> Self {
        let mut tables = Tables::new(space);
        tables.bounds = match space.supply {
            Some(supply) => tables.of_supplies(space, supply),
            None => tables.of_free_pairs(space),
        };
        tables
    }

    /// The unit vector of a direction in a row, projected on the axes.
    pub fn projections(&self, row: usize, direction: usize) -> &[i64] {
        let start = (row * self.directions + direction) * AXES;
        &self.projections[start..start + AXES]
    }

    /// For each axis the largest projection that the places left can add to an order: `left` is the code of the directions left,
    /// or for free directions the number of pairs placed.
    pub fn bounds(&self, left: usize, order: usize) -> &[i64] {
        let start = (left * self.orders + order) * AXES;
        &self.bounds[start..start + AXES]
    }

    /// The rearrangement inequality: the largest weight goes with the largest projection.
    fn of_supplies(&self, space: &Space, supply: usize) -> Vec<i64> {
        let sorted: Vec<Vec<usize>> = (0..self.orders * AXES).map(|at| self.falling(at / AXES, at % AXES)).collect();
        let codes = (supply + 1).pow(space.directions as u32);
        let mut bounds = vec![0; codes * self.orders * AXES];
        for code in 0..codes {
            let counts = counts(code, supply, space.directions);
            let left: usize = counts.iter().sum();
            let mut weights: Vec<i64> =
                space.sequence[space.places - left..].iter().map(|&p| space.weights[p]).collect();
            weights.sort_unstable_by(|a, b| b.cmp(a));
            for at in 0..self.orders * AXES {
                let taken = sorted[at].iter().flat_map(|&direction| std::iter::repeat_n(direction, counts[direction]));
                let products =
                    taken.zip(&weights).map(|(d, weight)| weight * self.projections(at / AXES, d)[at % AXES]);
                bounds[code * self.orders * AXES + at] = products.sum();
            }
        }
        bounds
    }

    fn falling(&self, row: usize, axis: usize) -> Vec<usize> {
        let mut directions: Vec<usize> = (0..self.directions).collect();
        directions.sort_by_key(|&direction| std::cmp::Reverse(self.projections(row, direction)[axis]));
        directions
    }

    /// A pair adds its arm times the difference of two projections: at most the widest difference there is.
    fn of_free_pairs(&self, space: &Space) -> Vec<i64> {
        let widest = |at: usize| {
            let all = || (0..self.directions).map(|direction| self.projections(at / AXES, direction)[at % AXES]);
            all().max().unwrap_or(0) - all().min().unwrap_or(0)
        };
        let arms = |placed: usize| space.weights[placed..space.pairs().max(placed)].iter().sum::<i64>();
        let pairs = 0..=space.pairs();
        pairs.flat_map(|placed| (0..self.orders * AXES).map(move |at| arms(placed) * widest(at))).collect()
    }
}

fn axis_angle(axis: i64) -> Turn {
    Turn::fraction(axis, 2 * AXES as i64)
}

/// How often each direction is left, from the code with one digit per direction.
fn counts(mut code: usize, supply: usize, directions: usize) -> Vec<usize> {
    let digit = |_| {
        let count = code % (supply + 1);
        code /= supply + 1;
        count
    };
    (0..directions).map(digit).collect()
}
