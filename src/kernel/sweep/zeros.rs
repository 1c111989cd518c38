//! What of an order vanishes at which values of a sweep's parameter?

use num_rational::BigRational;

use super::swept_engine::SweptEngine;
use crate::proof::{Planar, Sense};

/// What vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Zeros {
    /// The vector that turns with the crank.
    Direct,
    /// The vector that turns against it.
    Reverse,
    /// Both.
    Largest,
    /// The part along the reference direction.
    Along,
    /// The part across it.
    Across,
}

impl Zeros {
    /// All of them.
    pub const ALL: [Zeros; 5] = [Zeros::Direct, Zeros::Reverse, Zeros::Largest, Zeros::Along, Zeros::Across];

    /// Which vector it is, where it is one.
    pub(super) fn vector(self) -> Option<Sense> {
        match self {
            Zeros::Direct => Some(Sense::Direct),
            Zeros::Reverse => Some(Sense::Reverse),
            Zeros::Largest | Zeros::Along | Zeros::Across => None,
        }
    }

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Zeros::Direct => "direct",
            Zeros::Reverse => "reverse",
            Zeros::Largest => "all",
            Zeros::Along => "along",
            Zeros::Across => "across",
        }
    }
}

/// Where one of them vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZeroSet {
    /// Force or moment.
    pub quantity: Planar,
    /// The order k.
    pub order: u32,
    /// What vanishes.
    pub of: Zeros,
    /// Whether the engine has the order at all.
    pub exists: bool,
    /// Whether it vanishes for every value of the parameter.
    pub everywhere: bool,
    /// The values in the range at which it vanishes, rising, in the unit of the range; empty where it does everywhere.
    pub at: Vec<BigRational>,
    /// Ends, narrow ones, between which it vanishes once each, at an angle that is no rational turn.
    pub irrational: Vec<[BigRational; 2]>,
    /// Whether these are proved to be all; else they are those found.
    pub complete: bool,
}

impl ZeroSet {
    pub(super) fn everywhere(quantity: Planar, order: u32, of: Zeros) -> Self {
        ZeroSet {
            quantity,
            order,
            of,
            exists: true,
            everywhere: true,
            at: Vec::new(),
            irrational: Vec::new(),
            complete: true,
        }
    }

    /// Whether it vanishes nowhere in the range, proved.
    pub(super) fn is_never(&self) -> bool {
        self.complete && self.exists && !self.everywhere && self.at.is_empty() && self.irrational.is_empty()
    }

    /// Takes in the points of a grid at which it is proved to vanish: what is zero there is in the list, even where nothing is proved
    /// of what lies between.
    pub(super) fn take_from(&mut self, points: &[SweptEngine]) {
        if !self.exists || self.everywhere {
            return;
        }
        for point in points {
            let Some(order) = point.orders.iter().find(|swept| swept.order == self.order) else { continue };
            let part = order.amplitudes(self.quantity);
            let vanishes = match self.of {
                Zeros::Direct => part.direct.vanishes,
                Zeros::Reverse => part.reverse.vanishes,
                Zeros::Largest => part.largest.vanishes,
                Zeros::Along => part.along.vanishes,
                Zeros::Across => part.across.vanishes,
            };
            if let (true, [value]) = (vanishes, point.values.as_slice())
                && let Err(place) = self.at.binary_search(value)
            {
                self.at.insert(place, value.clone());
                // What a complete list lacks would be a mistake of the list.
                self.complete = false;
            }
        }
    }
}
