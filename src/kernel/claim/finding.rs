//! What is the case, whatever is claimed of it?

use std::borrow::Cow;

use num_rational::BigRational;

use super::formula::{Measured, Powers, Wave};
use super::statement::Loaded;
use crate::firing::StarOrder;
use crate::loads::BearingLoads;
use crate::numbers::Form;
use crate::remedy::{Remedy, Weight};
use crate::torque::Extreme;
use crate::verdict::{OrderBalance, OrderVerdict, TorquePart};

/// What is the case.
#[derive(Clone, Debug)]
pub enum Finding {
    /// One order of the force and the moment.
    Order(Box<OrderBalance>),
    /// One order of the inertia torque.
    Torque(Box<TorquePart>),
    /// Of the orders asked, those that do not vanish, over one period.
    Orders {
        /// The orders that do not vanish.
        surviving: Vec<u32>,
        /// How many orders were decided.
        judged: usize,
        /// After this many orders everything repeats; none where single orders were asked.
        period: Option<u32>,
        /// The first that does not vanish.
        first: Option<Box<OrderBalance>>,
    },
    /// No order is left, of whichever kinds the rods are.
    NothingLeft,
    /// All pistons are in one plane.
    OnePlane,
    /// The throws allow no even firing, in whichever order.
    NoEvenFiring,
    /// One cylinder fires evenly, whichever the cycle is.
    OneCylinder,
    /// Firing stars: those asked about, or the strongest of minor orders.
    FiringStars(Vec<StarOrder>),
    /// The firing intervals in turns, where the layout says them.
    Firing(Option<Vec<BigRational>>),
    /// A value in newtons or newton-metres.
    Absolute(Box<OrderBalance>, Absolute),
    /// The mass of all crankshafts in kilograms, and how many there are.
    Mass(BigRational, usize),
    /// What the main bearings feel.
    Bearings(Box<BearingLoads>),
    /// Orders to which several kinds of rods contribute.
    CombinedOrders(Vec<OrderVerdict>),
    /// What takes an order away.
    Remedy(Box<Remedy>),
    /// A largest load of gas and masses together.
    Largest(LargestOf),
    /// How far a formula of one cylinder is off.
    Agreement(Agreement),
    /// The terms of a series.
    Terms {
        /// Those claimed, and those that are there.
        terms: Vec<Term>,
        /// Through which order; none where all are compared.
        through: Option<u32>,
    },
    /// Counterweights, found for a claim that some can do it.
    Witness(Box<Witness>),
    /// Nothing could be found out, for this reason: words of this room, or the message of an error.
    Nothing(Cow<'static, str>),
}

/// A largest value in newtons or newton-metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absolute {
    /// With the first term of the series of c_k alone, as textbooks take it: c_2 = r/l; none in order 1, nor with an offset.
    pub first_term: Option<f64>,
    /// With the whole series.
    pub whole: f64,
}

/// How far a formula is off through the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// What the formula is said of.
    pub what: Measured,
    /// The largest of its absolute values, and the cylinder's crank angle there in degrees.
    pub largest: Extreme,
    /// The largest difference, and where.
    pub off: Extreme,
    /// At how many crank angles both were compared.
    pub angles: usize,
    /// Whether they are equal but for roundings.
    pub equal: bool,
}

impl Agreement {
    /// The largest difference as a part of the largest value.
    pub fn part(&self) -> f64 {
        if self.largest.value > 0.0 { self.off.value / self.largest.value } else { self.off.value }
    }
}

/// A largest load of gas and masses together.
#[derive(Clone, Debug, PartialEq)]
pub struct LargestOf {
    /// What feels it.
    pub of: Loaded,
    /// The number of the bearing, from 1, or the name of the cylinder.
    pub which: String,
    /// The load in newtons, and the crank angle.
    pub peak: Extreme,
    /// The largest of the masses alone, where that is known.
    pub without_gas: Option<f64>,
}

/// One wave of a claimed series, with what is said of it.
#[derive(Clone, Debug)]
pub struct Term {
    /// The cosine or sine.
    pub wave: Wave,
    /// What is claimed to stand before it; nothing where the claim leaves it out.
    pub said: Vec<(Powers, Form)>,
    /// What stands before it without m r ω² c_k: in closed form where there is one, and in decimals.
    pub right: (Option<Form>, f64),
    /// The first powers of λ in c_k, with their numbers; none of an order that does not exist.
    pub coefficient: Vec<(u32, BigRational)>,
    /// Whether it is right.
    pub verdict: TermVerdict,
}

/// What is said of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TermVerdict {
    /// It is the term.
    Right,
    /// It is the term up to this power of λ, higher ones omitted.
    UpTo(u32),
    /// Its decimals are those of the term, rounded.
    Rounded,
    /// It is another number.
    Wrong,
    /// It does not count in m r ω².
    WrongUnit,
    /// It is omitted.
    Missing,
    /// A number stands for λ, which the layout does not give.
    NoRatio,
}

/// Counterweights that do what is claimed to be possible, or the only ones that could.
#[derive(Clone, Debug)]
pub struct Witness {
    /// The counterweights.
    pub weights: Vec<Weight>,
    /// Their masses in kilograms at the crank radius; none where the layout gives no numbers.
    pub masses: Option<Vec<f64>>,
    /// The mass of all crankshafts with them in kilograms.
    pub crankshaft_mass: Option<f64>,
    /// How many crankshafts there are.
    pub crankshafts: usize,
}
