//! Which methods are compared, what do they find, and how wrong are they?

use std::hint::black_box;
use std::time::{Duration, Instant};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::branch::Search;
use super::interval::Interval;
use super::reference::Fractions;
use super::sample::{Doubles, Singles};
use super::tail::Tails;
use crate::layout::Layout;
use crate::loads::{self, Harmonic, Loads, Missing, Waveform};
use crate::motion::Enclosure;
use crate::proof::Quantity;

/// A way to find a peak load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The orders up to this one, summed in doubles and searched for the peak.
    Orders(u32),
    /// The closed form at so many equal steps of the crank angle, in doubles.
    Doubles(u32),
    /// The same in single floats.
    Singles(u32),
    /// Intervals of doubles, until so many digits are sure.
    Intervals(u32),
    /// Intervals of fractions.
    Fractions,
}

/// Orders that are kept.
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
    /// The peak, guaranteed; at most the largest bound that is known where the load vanishes.
    pub peak: Enclosure,
    /// Errors below this part of the peak are roundings of doubles, which differ between machines, or lie in the doubt about
    /// the peak.
    pub rounding: f64,
    /// The methods; none where the load vanishes at every order.
    pub rows: Vec<Row>,
}

/// Finds the peak of a load by all methods, and their times if they are wanted.
///
/// # Errors
/// What the layout lacks for numbers.
pub fn study(layout: &Layout, quantity: Quantity, timed: bool) -> Result<Study, Missing> {
    let orders = Orders::new(layout, quantity, SUMMED)?;
    let fractions = Fractions::new(layout, quantity);
    let (steady, steady_rest) = match orders.steady() {
        false => (false, 0.0),
        true => {
            let more = Orders::new(layout, quantity, SUMMED_OF_STEADY)?;
            (more.steady(), more.bound(SUMMED_OF_STEADY))
        }
    };
    let peak = || match steady {
        true => fractions.at_zero().map(|at| widened(&at, steady_rest)),
        false => fractions.peak(orders.bound(0), orders.angle()),
    };
    let (enclosure, time) = measured(timed, peak);
    let nothing = || Missing::Motion("the peak cannot be enclosed: a crank comes too near the end of its reach".into());
    let enclosure = enclosure.ok_or_else(nothing)?;
    if orders.waveform.harmonics().is_empty() && steady {
        return Ok(Study { quantity, peak: enclosure, rounding: 0.0, rows: Vec::new() });
    }
    let yardstick = Yardstick::new(&enclosure);
    let mut rows = Vec::new();
    for order in ORDERS {
        let waveform = orders.up_to(order);
        let (value, time) = measured(timed, || orders.peak(&waveform));
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
    let doubles = Doubles::new(layout, quantity)?;
    let singles = Singles::new(layout, quantity);
    for steps in STEPS {
        let (value, time) = measured(timed, || doubles.peak(steps));
        let looked_at = Some(steps as usize);
        let error = yardstick.error(value);
        rows.push(Row { method: Method::Doubles(steps), value, bound: None, error, looked_at, time });
    }
    for steps in STEPS {
        let (value, time) = measured(timed, || singles.peak(steps));
        let looked_at = Some(steps as usize);
        let error = yardstick.error(value);
        rows.push(Row { method: Method::Singles(steps), value, bound: None, error, looked_at, time });
    }
    let search = Search::new(layout, quantity);
    for digits in DIGITS {
        let (found, time) = measured(timed, || search.run(ten_to_minus(digits), MOST_SPANS));
        let squares = Interval { low: found.low, high: found.high };
        let ends = [squares.low.sqrt().next_down(), squares.high.sqrt().next_up()];
        let value = f64::midpoint(ends[0], ends[1]);
        let bound = Some((ends[1] - ends[0]) / yardstick.size);
        let (error, looked_at) = (yardstick.error(value), Some(found.looked_at));
        rows.push(Row { method: Method::Intervals(digits), value, bound, error, looked_at, time });
    }
    let doubt = (enclosure.width() / &yardstick.middle).to_f64().unwrap_or(f64::INFINITY);
    let (value, error) = (yardstick.size, yardstick.error(yardstick.size));
    rows.push(Row { method: Method::Fractions, value, bound: Some(doubt), error, looked_at: None, time });
    let rounding = (ROUNDINGS * f64::EPSILON * orders.largest_sum / yardstick.size).max(doubt);
    Ok(Study { quantity, peak: enclosure, rounding: ten_above(rounding), rows })
}

/// The orders of one load.
struct Orders {
    quantity: Quantity,
    waveform: Waveform,
    /// By order: its largest length.
    largest: Vec<(u32, f64)>,
    /// Bound of all orders above those.
    rest: f64,
    /// No sum of the terms of the load is larger: its roundings are in the last place of this.
    largest_sum: f64,
}

impl Orders {
    fn new(layout: &Layout, quantity: Quantity, highest: u32) -> Result<Self, Missing> {
        let mut asked = layout.clone();
        asked.effects.torque = quantity == Quantity::Torque;
        let all: Vec<u32> = (1..=highest).collect();
        let Loads { orders, force, moment, torque, .. } = loads::loads(&asked, &all)?;
        let tails = Tails::new(layout, highest)?;
        let (rest, largest_sum) = (tails.above(layout, quantity, highest), tails.largest_sum(layout, quantity));
        let (waveform, largest) = match (quantity, torque) {
            (Quantity::Force, _) => (force, orders.iter().map(|o| (o.order, o.force.largest())).collect()),
            (Quantity::Moment, _) => (moment, orders.iter().map(|o| (o.order, o.moment.largest())).collect()),
            (Quantity::Torque, Some(torque)) => {
                let largest = torque.orders.iter().map(|order| (order.order, order.vector.value.norm()));
                (torque.waveform, largest.collect())
            }
            (Quantity::Torque, None) => (Waveform::default(), Vec::new()),
        };
        Ok(Orders { quantity, waveform, largest, rest, largest_sum })
    }

    /// The orders above this one add at most this.
    fn bound(&self, order: u32) -> f64 {
        let summed: f64 = self.largest.iter().filter(|(k, _)| *k > order).map(|(_, largest)| largest).sum();
        (summed + self.rest) * (1.0 + 1e-9)
    }

    /// Whether one rotating vector, or none, is all there is in the orders that were summed.
    fn steady(&self) -> bool {
        match self.waveform.harmonics() {
            [] => true,
            [only] => {
                self.quantity != Quantity::Torque && (only.direct.norm_sqr() == 0.0 || only.reverse.norm_sqr() == 0.0)
            }
            _ => false,
        }
    }

    fn up_to(&self, order: u32) -> Waveform {
        let kept = self.waveform.harmonics().iter().filter(|harmonic: &&Harmonic| harmonic.order <= order);
        Waveform::new(kept.copied())
    }

    /// Crank angle of the peak in degrees.
    fn angle(&self) -> f64 {
        let peak = match self.quantity {
            Quantity::Torque => self.waveform.real_peak(),
            Quantity::Force | Quantity::Moment => self.waveform.peak(),
        };
        peak.angle.unwrap_or(0.0)
    }

    fn peak(&self, waveform: &Waveform) -> f64 {
        match self.quantity {
            Quantity::Torque => waveform.real_peak().value,
            Quantity::Force | Quantity::Moment => waveform.peak().value,
        }
    }
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
        let size = middle.to_f64().unwrap_or(f64::NAN);
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

/// Evaluations whose times are compared.
const REPEATS: usize = 7;
/// Short evaluations are timed together, so many that they take about this long.
const BATCH: Duration = Duration::from_micros(500);

/// The result, and the median time where it is wanted.
fn measured<T>(timed: bool, run: impl Fn() -> T) -> (T, Option<Duration>) {
    let start = Instant::now();
    let result = run();
    if !timed {
        return (result, None);
    }
    let first = start.elapsed().max(Duration::from_nanos(1));
    let batch = (BATCH.as_nanos() / first.as_nanos()).clamp(1, 100_000) as u32;
    let mut times: Vec<Duration> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..batch {
                black_box(run());
            }
            start.elapsed() / batch
        })
        .collect();
    times.sort_unstable();
    (result, Some(times[REPEATS / 2]))
}
