//! What is a star, and which of its moments are zero?

use num_rational::BigRational;

use crate::exact::{PhasorSum, Term, Turn};

/// The directions of throws one spacing apart, from the free end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Star {
    directions: u32,
    throws: Vec<u32>,
}

impl Star {
    /// A star by its throws, as multiples of `1 / directions` turn; turned so that the first one is at 0.
    pub fn new(directions: u32, throws: &[u32]) -> Self {
        let first = throws.first().map_or(0, |first| first % directions);
        let turned = throws.iter().map(|throw| (throw % directions + directions - first) % directions);
        Star { directions, throws: turned.collect() }
    }

    /// A star by the place of the throw in each direction.
    pub(super) fn of_places(places: &[u32]) -> Self {
        let mut throws = vec![0; places.len()];
        for (direction, &place) in (0..).zip(places) {
            throws[place as usize] = direction;
        }
        Star::new(places.len() as u32, &throws)
    }

    /// How many directions make a turn.
    pub fn directions(&self) -> u32 {
        self.directions
    }

    /// The direction of each throw.
    pub fn throws(&self) -> &[u32] {
        &self.throws
    }

    /// The angles of the throws.
    pub fn angles(&self) -> Vec<Turn> {
        self.throws.iter().map(|&throw| Turn::fraction(throw.into(), self.directions.into())).collect()
    }

    /// The moment of an order about the mid-plane, in `m r ω² c_k` times the spacing.
    pub fn moment(&self, order: u32) -> PhasorSum {
        let last = self.throws.len() as i64 - 1;
        let term = |(place, &throw): (i64, &u32)| Term {
            angle: Turn::fraction(i64::from(throw) * i64::from(order), self.directions.into()),
            weight: BigRational::new((last - 2 * place).into(), 2.into()),
        };
        PhasorSum::new((0..).zip(&self.throws).map(term).collect())
    }

    /// Whether the moment of an order is zero.
    pub fn loses(&self, order: u32) -> bool {
        self.moment(order).vanishes()
    }

    /// The first of the orders that exist, 1 and the even ones, whose moment is left; none where every moment is zero.
    ///
    /// A moment depends on the order modulo the number of directions, so the even orders up to twice that number are all.
    pub fn first_left(&self) -> Option<u32> {
        let mut orders = [1].into_iter().chain((2..=2 * self.directions).step_by(2));
        orders.find(|order| !self.loses(*order))
    }
}
