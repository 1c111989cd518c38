//! Which stars are not beaten? The exact Pareto front, ties counted.

use std::cmp::Ordering;

use super::value::Value;

/// What a search does with the stars it comes to.
pub(super) trait Judge {
    /// Whether every star with squares of at least these lower bounds can be omitted.
    fn hopeless(&self, low: &[i128]) -> bool;
    /// A star that may matter.
    fn take(&mut self, point: StarValues);
}

/// The values of a star, and how many stars share them.
#[derive(Clone, Debug)]
pub(super) struct StarValues {
    /// One value per order that differs from star to star, then one per minor order.
    pub values: Vec<Value>,
    /// Neighbours that fire in succession; 0 where they do not count.
    pub neighbours: usize,
    /// The first of these stars, as directions by place.
    pub throws: Vec<u16>,
    /// The firing order that the values are of, where minor orders are compared.
    pub firing_order: Option<Vec<usize>>,
    /// Stars up to rotation, mirror and reversal.
    pub classes: u64,
    /// Stars with cylinder 1 at direction 0.
    pub stars: u64,
}

impl StarValues {
    /// Whether it is no worse in anything (then less or equal), no better in anything (then greater or equal), or neither.
    pub fn compare(&self, other: &StarValues) -> Option<Ordering> {
        let mut sign = self.neighbours.cmp(&other.neighbours);
        for (own, theirs) in self.values.iter().zip(&other.values) {
            match (sign, own.compare(theirs)) {
                (_, Ordering::Equal) => {}
                (Ordering::Equal, next) => sign = next,
                (known, next) if known == next => {}
                _ => return None,
            }
        }
        Some(sign)
    }

    /// Value by value, then neighbours: the order of a printed front.
    pub fn rank(&self, other: &StarValues) -> Ordering {
        let mut pairs = self.values.iter().zip(&other.values).map(|(own, theirs)| own.compare(theirs));
        let first = pairs.find(|ordering| *ordering != Ordering::Equal).unwrap_or(Ordering::Equal);
        first.then(self.neighbours.cmp(&other.neighbours))
    }

    /// Whether nothing but the moments of this many orders can be better in another star.
    pub fn is_least_beyond(&self, orders: usize) -> bool {
        self.neighbours == 0 && self.values.iter().skip(orders).all(Value::is_zero)
    }

    /// Counts the stars of an equal point too.
    pub fn join(&mut self, other: StarValues) {
        // A star that is not counted here belongs to another piece.
        if self.classes == 0 || other.throws < self.throws {
            self.throws = other.throws;
            self.firing_order = other.firing_order;
        }
        self.classes += other.classes;
        self.stars += other.stars;
    }
}

/// Points none of which is beaten by another.
#[derive(Clone, Debug, Default)]
pub(super) struct Pareto {
    points: Vec<StarValues>,
}

impl Pareto {
    /// The points, in no order.
    pub fn points(&self) -> &[StarValues] {
        &self.points
    }

    /// The same front with nothing counted yet.
    pub fn uncounted(&self) -> Self {
        let points = self.points.iter().map(|point| StarValues { classes: 0, stars: 0, ..point.clone() });
        Pareto { points: points.collect() }
    }
}

impl Judge for Pareto {
    fn hopeless(&self, low: &[i128]) -> bool {
        // No worse in anything and better in one, with all that is not bounded at its least.
        self.points.iter().any(|point| {
            let mut highs = point.values.iter().map(|value| value.high).zip(low);
            let better = point.values.iter().zip(low).any(|(value, low)| value.high < *low);
            point.is_least_beyond(low.len()) && better && highs.all(|(high, low)| high <= *low)
        })
    }

    fn take(&mut self, point: StarValues) {
        let mut at = 0;
        while at < self.points.len() {
            match self.points[at].compare(&point) {
                Some(Ordering::Less) => return,
                Some(Ordering::Equal) => return self.points[at].join(point),
                Some(Ordering::Greater) => {
                    self.points.swap_remove(at);
                }
                None => at += 1,
            }
        }
        self.points.push(point);
    }
}

/// Every value there is, each once, in the order of [`StarValues::rank`].
#[derive(Default)]
pub(super) struct Census {
    pub points: Vec<StarValues>,
}

impl Judge for Census {
    fn hopeless(&self, _: &[i128]) -> bool {
        false
    }

    fn take(&mut self, point: StarValues) {
        match self.points.binary_search_by(|known| known.rank(&point)) {
            Ok(at) => self.points[at].join(point),
            Err(at) => self.points.insert(at, point),
        }
    }
}
