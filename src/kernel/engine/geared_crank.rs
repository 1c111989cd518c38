//! What is one of several crankshafts that are geared together? Where it stands, which way it turns, and how fast.

use num_rational::BigRational;
use num_traits::Zero;

use crate::exact::{Term, Turn};
use crate::proof::Sense;

/// One of several crankshafts that are geared together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GearedCrank {
    /// What it is called: a few letters and digits.
    pub name: String,
    /// Direct: it turns anticlockwise, as the only crankshaft of an engine does; reverse: against that.
    pub sense: Sense,
    /// How many times it turns while the reference turns once: a whole number ν, at least 1.
    pub speed: u32,
    /// Where its axis is in the plane across it, from the middle of the engine: the sum of these, in crank radii of the engine;
    /// none in the middle, and where that is omitted.
    pub axis: Vec<Term>,
    /// What the file omits of where its axis stands.
    pub left_out: Option<AxisLeftOut>,
}

/// What a file omits of where the axis of a crankshaft stands. No result may hang on it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AxisLeftOut {
    /// The distance from the other crankshaft: the axis is this many times that far in this direction.
    Distance(Term),
    /// All of it.
    Place,
}

impl GearedCrank {
    /// A crankshaft whose axis is so high along the reference direction and so far to its left (along 90°), in crank radii.
    pub fn at(name: &str, sense: Sense, height: BigRational, offset: BigRational) -> Self {
        let terms =
            [Term { angle: Turn::zero(), weight: height }, Term { angle: Turn::fraction(1, 4), weight: offset }];
        let axis = terms.into_iter().filter(|term| !term.weight.is_zero()).collect();
        GearedCrank { name: name.to_owned(), sense, speed: 1, axis, left_out: None }
    }

    /// One of whose axis this is omitted.
    pub fn without(name: &str, sense: Sense, left_out: AxisLeftOut) -> Self {
        GearedCrank { name: name.to_owned(), sense, speed: 1, axis: Vec::new(), left_out: Some(left_out) }
    }

    /// One whose axis is at this distance, in crank radii, in this direction.
    pub fn towards(name: &str, sense: Sense, distance: BigRational, angle: Turn) -> Self {
        let axis = if distance.is_zero() { Vec::new() } else { vec![Term { angle, weight: distance }] };
        GearedCrank { name: name.to_owned(), sense, speed: 1, axis, left_out: None }
    }

    /// The same, turning this many times while the reference turns once.
    pub fn turning(self, speed: u32) -> Self {
        GearedCrank { speed, ..self }
    }
}

/// The order of a crank that turns this many times as fast as the reference that is this order of the engine.
pub(super) fn own_order(speed: u32, order: u32) -> Option<u32> {
    (speed > 0 && order.is_multiple_of(speed)).then(|| order / speed)
}
