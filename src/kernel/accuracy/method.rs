//! Which methods are compared, what do they find, and how wrong are they?

use std::time::Duration;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::branch::{Found, Search};
use super::largest::{Largest, largest};
use super::orders::Orders;
use super::reference::Fractions;
use super::sample::Doubles;
use super::timing::{Timing, measured};
use crate::engine::Engine;
use crate::loads::{self, Missing};
use crate::motion::Enclosure;
use crate::numbers::float;
use crate::order::{TurningMass, turning_masses};
use crate::proof::Quantity;

/// A way to find a peak load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// The orders up to this one, summed in doubles and searched for the peak.
    Orders(u32),
    /// The closed form at this many equal steps of the crank angle, in doubles.
    Doubles(u32),
    /// Intervals of doubles, until this many digits are sure.
    Intervals(u32),
    /// Intervals of fractions.
    Fractions,
}

/// Orders that are kept; one that adds nothing to the one before it is no method of its own.
const ORDERS: [u32; 8] = [2, 4, 6, 8, 12, 16, 24, 32];
/// Orders whose vectors are summed into the bound of what is cut off; those above are bounded together.
const SUMMED: u32 = 60;
/// As many for a load that is one rotating vector: all others have to be proved small.
const SUMMED_OF_STEADY: u32 = 160;
/// Steps of a revolution.
const STEPS: [u32; 3] = [36, 360, 3600];
/// Digits asked of the intervals.
const DIGITS: [u32; 4] = [3, 6, 9, 12];
/// Spans that the intervals may look at.
const MOST_SPANS: usize = 4000;
/// Roundings of a float sum, in units of its last place.
const ROUNDINGS: f64 = 64.0;

/// What a method finds, and what it costs.
#[derive(Clone, Debug)]
pub struct Row {
    /// Which method.
    pub method: Method,
    /// The peak, in the multiples of the loads: m r ω², that times the unit of the positions, or m r² ω².
    pub value: f64,
    /// Guaranteed: the method itself is off by at most this part of the peak, roundings of doubles apart. None where it has no bound.
    pub bound: Option<f64>,
    /// Measured: it is off by this part of the peak.
    pub error: f64,
    /// How many crank angles or spans it looked at; none for a search in orders.
    pub looked_at: Option<usize>,
    /// Median time of one evaluation, all numbers of the engine at hand; none where it was not asked for.
    pub time: Option<Duration>,
}

/// One load of an engine by all methods.
#[derive(Clone, Debug)]
pub struct Study {
    /// Which load.
    pub quantity: Quantity,
    /// The peak, guaranteed; 0 where the load is proved to vanish at every order, and no more than a bound where it does at those looked at.
    pub peak: Enclosure,
    /// Errors below this part of the peak are roundings of doubles, which differ between machines, or lie in the doubt about
    /// the peak.
    pub rounding: f64,
    /// The peak is known to this part of itself: a smaller error is below that of the yardstick.
    pub doubt: f64,
    /// The methods; none where the load vanishes at every order that was looked at.
    pub rows: Vec<Row>,
    /// What the program does for its own reports; none where no times are asked for, or nothing is left to find.
    pub own: Option<Own>,
}

/// The program's own choice ([`super::largest`]) beside the methods that are compared.
#[derive(Clone, Copy, Debug)]
pub struct Own {
    /// Guaranteed: it is off by at most this part of the peak.
    pub bound: f64,
    /// Median time from the engine itself, exact sums and bounds included.
    pub time: Duration,
}

impl Own {
    fn new(engine: &Engine, quantity: Quantity, timing: Timing) -> Option<Self> {
        let Timing::On = timing else { return None };
        match measured(timing, || largest(engine, quantity)) {
            (Ok(Largest::Known { value, error, .. }), Some(time)) => Some(Own { bound: error / value, time }),
            (Ok(Largest::Known { .. } | Largest::Zero | Largest::Below(_)) | Err(_), _) => None,
        }
    }
}

/// Whether all that turns does so with the crank.
///
/// # Errors
/// What does not: a crankshaft that turns against the first, else a balancer shaft.
pub(super) fn all_turn_with_the_crank(engine: &Engine) -> Result<(), Missing> {
    let masses = turning_masses(engine);
    let other: Vec<&TurningMass> = masses.iter().filter(|mass| !mass.turns_with_the_crank()).collect();
    match other.iter().any(|mass| mass.crank.is_some()) {
        true => Err(Missing::CranksAgainstEachOther),
        false if other.is_empty() => Ok(()),
        false => Err(Missing::BalancerShafts),
    }
}

/// Finds the peak of a load by all methods, and the time of each where they are timed.
///
/// # Errors
/// What the engine lacks for numbers.
pub fn study(engine: &Engine, quantity: Quantity, timing: Timing) -> Result<Study, Missing> {
    if engine.faster_crank().is_some() {
        return Err(Missing::FasterCrank("the accuracy of methods"));
    }
    all_turn_with_the_crank(engine)?;
    engine.only_rods().map_err(|with| Missing::OfRodsAlone(with, "the accuracy of methods"))?;
    let orders = Orders::new(engine, quantity, SUMMED)?;
    if loads::vanishes_at_every_order(engine, quantity) {
        return Ok(Study { quantity, peak: Enclosure::zero(), rounding: 0.0, doubt: 0.0, rows: Vec::new(), own: None });
    }
    let fractions = Fractions::new(engine, quantity);
    let (steady, steady_rest) = match orders.steady() {
        false => (false, 0.0),
        true => {
            let more = Orders::new(engine, quantity, SUMMED_OF_STEADY)?;
            (more.steady(), more.bound(SUMMED_OF_STEADY))
        }
    };
    let peak = || match steady {
        true => fractions.at_zero().map(|at| widened(&at, steady_rest)),
        false => fractions.peak(orders.bound(0), orders.angle()),
    };
    let (enclosure, time) = measured(timing, peak);
    let search = Search::new(engine, quantity);
    let searched = searches(&search, timing);
    // What any method guarantees holds for the yardstick, so that none is compared with a worse one than itself.
    let guaranteed = searched.iter().filter_map(|(_, (found, _))| ends(found)).chain(orders.enclosure());
    let nothing = || Missing::Motion("the peak cannot be enclosed: a crank comes too near the end of its reach".into());
    let enclosure = enclosure.into_iter().chain(guaranteed).reduce(narrowed).ok_or_else(nothing)?;
    if orders.waveform.harmonics().is_empty() && steady {
        return Ok(Study { quantity, peak: enclosure, rounding: 0.0, doubt: 0.0, rows: Vec::new(), own: None });
    }
    let yardstick = Yardstick::new(&enclosure);
    let mut rows = Vec::new();
    for order in orders.worth_keeping(&ORDERS) {
        let waveform = orders.up_to(order);
        let (value, time) = measured(timing, || orders.peak(&waveform));
        let bound = Some(orders.bound(order) / yardstick.size);
        rows.push(Row {
            method: Method::Orders(order),
            value,
            bound,
            error: yardstick.error(value),
            looked_at: None,
            time,
        });
    }
    let doubles = Doubles::new(engine, quantity)?;
    for steps in STEPS {
        let (value, time) = measured(timing, || doubles.peak(steps));
        let looked_at = Some(steps as usize);
        let error = yardstick.error(value);
        rows.push(Row { method: Method::Doubles(steps), value, bound: None, error, looked_at, time });
    }
    for (digits, (found, time)) in searched {
        let ends = float_ends(&found);
        let value = f64::midpoint(ends[0], ends[1]);
        let bound = Some((ends[1] - ends[0]) / yardstick.size);
        let (error, looked_at) = (yardstick.error(value), Some(found.looked_at));
        rows.push(Row { method: Method::Intervals(digits), value, bound, error, looked_at, time });
    }
    let doubt = (enclosure.width() / &yardstick.middle).to_f64().unwrap_or(f64::INFINITY);
    let (value, error) = (yardstick.size, yardstick.error(yardstick.size));
    rows.push(Row { method: Method::Fractions, value, bound: Some(doubt), error, looked_at: None, time });
    let rounding = (ROUNDINGS * f64::EPSILON * orders.largest_sum / yardstick.size).max(doubt);
    let own = Own::new(engine, quantity, timing);
    Ok(Study { quantity, peak: enclosure, rounding: ten_above(rounding), doubt, rows, own })
}

impl Study {
    /// Whether the yardstick is too coarse to tell the error of a method.
    pub fn is_below_reference(&self, row: &Row) -> bool {
        row.error <= self.doubt
    }
}

/// A search for each number of digits, up to the first that ends at [`MOST_SPANS`]: one for more digits would look at the same spans.
fn searches(search: &Search, timing: Timing) -> Vec<(u32, (Found, Option<Duration>))> {
    let mut searched: Vec<(u32, (Found, Option<Duration>))> = Vec::new();
    for digits in DIGITS {
        let (found, time) = measured(timing, || search.run(ten_to_minus(digits), MOST_SPANS));
        let is_the_last = found.looked_at >= MOST_SPANS;
        searched.push((digits, (found, time)));
        if is_the_last {
            break;
        }
    }
    searched
}

/// The peak that a search leaves.
fn float_ends(found: &Found) -> [f64; 2] {
    [found.low.sqrt().next_down().max(0.0), found.high.sqrt().next_up()]
}

fn ends(found: &Found) -> Option<Enclosure> {
    let [low, high] = float_ends(found);
    Some(Enclosure { low: BigRational::from_float(low)?, high: BigRational::from_float(high)? })
}

/// What both say of one number.
fn narrowed(one: Enclosure, other: Enclosure) -> Enclosure {
    Enclosure { low: one.low.max(other.low), high: one.high.min(other.high) }
}

/// The length at one angle becomes the peak where all that changes is at most this.
fn widened(length: &Enclosure, change: f64) -> Enclosure {
    let change = BigRational::from_float(2.0 * change).unwrap_or_else(BigRational::zero);
    Enclosure { low: length.low.clone(), high: &length.high + change }
}

/// What values are compared with.
struct Yardstick {
    middle: BigRational,
    size: f64,
}

impl Yardstick {
    fn new(peak: &Enclosure) -> Self {
        let middle = (&peak.low + &peak.high) / BigRational::from_integer(2.into());
        let size = float(&middle);
        Yardstick { middle, size }
    }

    /// Relative error of a value.
    fn error(&self, value: f64) -> f64 {
        let difference = BigRational::from_float(value).map(|value| (value - &self.middle).abs() / &self.middle);
        difference.and_then(|difference| difference.to_f64()).unwrap_or(f64::NAN)
    }
}

fn ten_to_minus(digits: u32) -> f64 {
    format!("1e-{digits}").parse().unwrap_or(0.0)
}

/// The power of ten at or above a positive number.
fn ten_above(number: f64) -> f64 {
    format!("1e{}", number.log10().ceil()).parse().unwrap_or(number)
}
