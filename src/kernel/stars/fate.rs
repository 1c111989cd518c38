//! Can a star lose the moments of these orders, all at once? Made, never, or not told by a theorem.

use num_integer::Integer;

use super::factors::{divisors, prime_powers};
use super::made::{self, By};
use super::star::Star;

/// Of more throws nothing is said.
pub const MOST_THROWS: u32 = 400;

/// In which directions throws stand: evenly spread ones, each taken equally often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pins {
    /// How many directions make a turn.
    pub directions: u32,
    /// How many throws are in each of them.
    pub each: u32,
}

impl Pins {
    /// Every throw in a direction of its own.
    pub fn once(directions: u32) -> Self {
        Pins { directions, each: 1 }
    }

    /// The throws of an in-line engine of two-stroke, or of four-stroke cylinders that fire evenly.
    pub fn inline(cylinders: u32, is_four_stroke: bool) -> Self {
        match is_four_stroke && cylinders.is_multiple_of(2) {
            true => Pins { directions: cylinders / 2, each: 2 },
            false => Pins::once(cylinders),
        }
    }

    /// Number of throws; 0 where they are more than can be told.
    pub fn throws(self) -> u32 {
        self.directions.checked_mul(self.each).unwrap_or(0)
    }

    /// The order of the root of unity of an order: 1 where every star loses the moment.
    pub(super) fn root(self, order: u32) -> u32 {
        self.directions / self.directions.gcd(&order)
    }

    /// Whether the moments of two orders are zero in the same stars: lemma 1.
    pub fn is_one_kind(self, one: u32, other: u32) -> bool {
        self.root(one) == self.root(other)
    }

    /// Whether every star loses the moment of an order: all vectors of its throws point one way.
    pub fn is_lost_by_all(self, order: u32) -> bool {
        self.root(order) == 1
    }

    /// Whether theorems speak of this many throws.
    pub(super) fn is_told(self) -> bool {
        (1..=MOST_THROWS).contains(&self.throws())
    }
}

/// Why no star loses the moments of these orders together: throws `1/prime` of a turn apart would be at one place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Obstruction {
    /// Number of throws, each in a direction of its own.
    pub throws: u32,
    /// The orders that cannot vanish together, rising: the first of those asked for of each kind.
    pub orders: Vec<u32>,
    /// The prime.
    pub prime: u32,
    /// Its whole power in the number of throws.
    pub power: u32,
}

/// A star that loses what was asked, and how it was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// The star.
    pub star: Star,
    /// Its construction.
    pub by: By,
}

/// What theorems say of losing the moments of some orders, all at once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// This star does.
    Lost(Made),
    /// No star does, at any rational spacing.
    Never(Obstruction),
    /// The theorems do not tell.
    Open,
}

/// Whether a star of these pins can lose the moments of these orders, all at once.
pub fn fate(pins: Pins, orders: &[u32]) -> Fate {
    if !pins.is_told() {
        return Fate::Open;
    }
    if let Some(obstruction) = obstruction(pins, orders) {
        return Fate::Never(obstruction);
    }
    let made = match pins.each {
        1 => {
            let count = pins.directions;
            // One without any moment first.
            vec![made::without_any(count), Some(made::of_mixed_radix(count)), made::mirrored(count)]
        }
        each => vec![made::mirror_image(pins.directions, each)],
    };
    let lost = made.into_iter().flatten().find(|(_, star)| orders.iter().all(|order| star.loses(*order)));
    lost.map_or(Fate::Open, |(by, star)| Fate::Lost(Made { star, by }))
}

/// Lemma 2, with the fewest orders.
fn obstruction(pins: Pins, orders: &[u32]) -> Option<Obstruction> {
    if pins.each != 1 {
        return None;
    }
    let of_prime = |power: super::PrimePower| {
        let forbidden = divisors(pins.directions / power.value()).into_iter().map(|other| power.value() * other);
        let asked = |root| orders.iter().copied().filter(|order| pins.root(*order) == root).min();
        let mut orders = forbidden.map(asked).collect::<Option<Vec<u32>>>()?;
        orders.sort_unstable();
        Some(Obstruction { throws: pins.directions, orders, prime: power.prime, power: power.value() })
    };
    prime_powers(pins.directions).into_iter().filter_map(of_prime).min_by_key(|found| found.orders.len())
}
