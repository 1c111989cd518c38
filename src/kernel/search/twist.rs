//! How far does a firing order twist the shaft? The phase-vector sums of minor orders, as aims beside the moments.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::clock::Clock;
use super::firing::orders_of;
use super::problem::{Problem, ProblemError};
use super::roots::Roots;
use super::value::Value;
use super::{firing, mode_shape};
use crate::exact::fraction;

/// The sum of the deflections is below this, in the whole numbers that they are multiples of.
const LONGEST: i64 = 1 << 20;
/// More firing orders than this are not evaluated: none of them can be omitted unseen.
const MOST_FIRING_ORDERS: u128 = 4_000_000;
/// By more minor orders than this nearly every firing order is best in something, and each is compared with all others.
const FEW_MINOR_ORDERS: usize = 3;
/// Then this many are evaluated at most.
const MOST_BY_MANY: u128 = 50_000;

/// The minor orders that are compared, and the deflections that weigh them.
pub(super) struct Twist {
    /// By how many steps of 1/n turn a vector falls behind in a step of the cycle, for each order.
    multiples: Vec<usize>,
    /// Deflections of the throws, in whole numbers.
    deflections: Vec<i64>,
    roots: Roots,
    clock: Clock,
    /// Whether a shaft end for end has sums of the same lengths.
    pub reverses: bool,
}

/// A firing order of a star.
pub(super) struct Fired {
    /// Cylinders in firing order.
    pub order: Vec<usize>,
    /// Neighbours that fire in succession.
    pub neighbours: usize,
    /// The square of the phase-vector sum of each order.
    pub values: Vec<Value>,
}

impl Twist {
    /// What a question asks for; none without minor orders.
    pub fn new(problem: &Problem) -> Result<Option<Self>, ProblemError> {
        if problem.minor_orders.is_empty() {
            return Ok(None);
        }
        let shape = mode_shape::deflections(problem, problem.mode_shape.clone())?;
        let clock = Clock::new(problem)?;
        if !clock.is_even() {
            return Err(ProblemError::new(
                "phase-vector sums are compared where every star fires evenly; omit the minor orders, or give another bank angle or pin split",
            ));
        }
        let firing_orders = firing_orders(problem);
        if firing_orders > MOST_FIRING_ORDERS {
            return Err(ProblemError::new(format!(
                "{} cylinders have too many firing orders: with minor orders up to {MOST_FIRING_ORDERS} are compared",
                problem.cylinders
            )));
        }
        if problem.minor_orders.len() > FEW_MINOR_ORDERS && firing_orders > MOST_BY_MANY {
            return Err(ProblemError::new(format!(
                "{} cylinders have {firing_orders} firing orders, too many for {} minor orders, since nearly all of them are best in some order: with more than {FEW_MINOR_ORDERS} up to {MOST_BY_MANY} are compared; give {FEW_MINOR_ORDERS} or fewer",
                problem.cylinders,
                problem.minor_orders.len()
            )));
        }
        let deflections = whole(&shape).ok_or_else(|| {
            ProblemError::new("by minor orders deflections of up to 4 digits are compared; round the mode shape")
        })?;
        let lowest = problem.cycle.lowest_order().halves();
        let cylinders = problem.cylinders;
        let multiple = |order: &crate::engine::CycleOrder| (order.halves() / lowest % cylinders) as usize;
        let ends = || deflections.iter().zip(deflections.iter().rev());
        let total = deflections.first().zip(deflections.last()).map_or(0, |(first, last)| first + last);
        let reverses = ends().all(|(one, other)| one == other) || ends().all(|(one, other)| one + other == total);
        Ok(Some(Twist {
            multiples: problem.minor_orders.iter().map(multiple).collect(),
            roots: Roots::new(cylinders as usize),
            deflections,
            clock,
            reverses,
        }))
    }

    /// The firing orders of a star, those of equal values once.
    pub fn of(&self, throws: &[u16], with_neighbours: bool) -> Vec<Fired> {
        let Some(steps) = self.clock.even_steps(throws) else { return Vec::new() };
        let mut different: Vec<Fired> = Vec::new();
        for order in orders_of(&steps) {
            let values = self.multiples.iter().map(|multiple| self.square(&order, *multiple)).collect();
            let neighbours = if with_neighbours { firing::in_succession(&order, throws.len()) } else { 0 };
            let fired = Fired { order, neighbours, values };
            if !different.iter().any(|known| known.equals(&fired)) {
                different.push(fired);
            }
        }
        different
    }

    fn square(&self, order: &[usize], multiple: usize) -> Value {
        let count = self.roots.order();
        let term = |(step, cylinder): (usize, &usize)| {
            (step * multiple % count, self.deflections[cylinder % self.deflections.len()])
        };
        self.roots.square(&order.iter().enumerate().map(term).collect::<Vec<_>>())
    }
}

impl Fired {
    fn equals(&self, other: &Fired) -> bool {
        self.neighbours == other.neighbours
            && self.values.iter().zip(&other.values).all(|(own, theirs)| own.compare(theirs).is_eq())
    }
}

/// Firing orders of all stars, up to rotation: of n cylinders in line (n − 1)!; of a V each star has the two of every instant.
fn firing_orders(problem: &Problem) -> u128 {
    let throws = u128::from(problem.throws());
    let stars: u128 = (1..throws).product();
    match problem.bank_angle {
        None => stars,
        Some(_) => stars << (problem.cylinders / 2).saturating_sub(1),
    }
}

/// Deflections as whole numbers without a common factor; none where these are too long.
fn whole(shape: &[BigRational]) -> Option<Vec<i64>> {
    let unit = Some(fraction::common_unit(shape)).filter(|unit| !unit.is_zero()).unwrap_or_else(BigRational::one);
    let scaled: Vec<BigInt> = shape.iter().map(|deflection| (deflection / &unit).to_integer()).collect();
    let total: BigInt = scaled.iter().map(Signed::abs).sum();
    // A V has two cylinders on each throw.
    (total * 2 < BigInt::from(LONGEST)).then(|| scaled.iter().filter_map(ToPrimitive::to_i64).collect())
}

impl Problem {
    pub(super) fn check_minor_orders(&self) -> Result<(), ProblemError> {
        let lowest = self.cycle.lowest_order().halves();
        for order in &self.minor_orders {
            if !order.exists_in(self.cycle) {
                return Err(ProblemError::new(format!("a two-stroke engine has whole orders, not {order}")));
            }
            if (order.halves() / lowest).is_multiple_of(self.cylinders) {
                return Err(ProblemError::new(format!(
                    "order {order} is a major one: the firing phases of all cylinders agree, and all deflections add up for any firing order"
                )));
            }
        }
        if self.minor_orders.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(ProblemError::new("minor orders are given rising, each once"));
        }
        if self.minor_orders.len() > super::problem::MOST_ORDERS {
            return Err(ProblemError::new(format!(
                "up to {} minor orders are compared, not {}",
                super::problem::MOST_ORDERS,
                self.minor_orders.len()
            )));
        }
        Ok(())
    }
}
