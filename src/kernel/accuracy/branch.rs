//! Between which numbers does the largest load of a revolution lie? Branch and bound over the crank angle.
//!
//! The revolution is cut into spans. Over a span intervals enclose the squared load and its slope. A span whose slope
//! cannot be zero holds no largest value, and one that lies below a value that was found holds none either; the span that
//! has the highest bound is cut in two. At every moment the highest bound is one of the peak.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::bodies::{Bodies, phases};
use super::interval::Interval;
use super::jet::{Jet, turning};
use super::real::Real;
use crate::engine::Engine;
use crate::exact::Turn;
use crate::proof::Quantity;

/// Spans at the start.
const FIRST_SPANS: u32 = 32;

/// A span of the crank angle in turns, and a bound of the squared load in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub from: f64,
    pub to: f64,
    pub bound: f64,
}

impl PartialEq for Span {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Span {}

impl PartialOrd for Span {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Span {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

/// What a search found of the largest squared load.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub low: f64,
    pub high: f64,
    /// The spans that may hold it.
    pub spans: Vec<Span>,
    /// How many spans were looked at.
    pub looked_at: usize,
}

/// An engine in intervals, with derivatives and without.
#[derive(Clone, Debug)]
pub(super) struct Search {
    still: Bodies<Interval>,
    moving: Bodies<Jet<Interval>>,
    curved: Bodies<Jet<Jet<Interval>>>,
    phases: Vec<Interval>,
}

impl Search {
    pub fn new(engine: &Engine, quantity: Quantity) -> Self {
        let direction = |angle: &Turn| Interval::around(angle.turns()).direction();
        let still = Bodies::new(engine, quantity, &Interval::around, &direction);
        let moving = still.map(&Jet::constant);
        let curved = moving.map(&Jet::constant);
        let phases = phases(engine).iter().map(|phase| Interval::around(phase.turns())).collect();
        Search { still, moving, curved, phases }
    }

    fn directions(&self, turns: Interval) -> impl Iterator<Item = [Interval; 2]> {
        self.phases.iter().map(move |phase| turns.plus(phase).direction())
    }

    /// The squared load at an angle.
    fn at(&self, turns: f64) -> Interval {
        let turns = Interval::point(turns);
        self.still.squared_load(&turns.direction(), self.directions(turns)).unwrap_or(Interval::WHOLE)
    }

    /// The squared load over a span, with its slope in radians.
    fn over(&self, turns: Interval) -> Jet<Interval> {
        let cylinders = self.directions(turns).map(|direction| turning(&direction));
        let load = self.moving.squared_load(&turning(&turns.direction()), cylinders);
        load.unwrap_or(Jet { value: Interval::WHOLE, slope: Interval::WHOLE })
    }

    /// Slope and curvature of the squared load over a span.
    pub fn curvature(&self, from: f64, to: f64) -> [Interval; 2] {
        let turns = Interval { low: from, high: to };
        let twice = |direction: [Interval; 2]| {
            let [cos, sin] = turning(&direction);
            turning(&[cos, sin])
        };
        let load = self.curved.squared_load(&twice(turns.direction()), self.directions(turns).map(twice));
        load.map_or([Interval::WHOLE; 2], |load| [load.value.slope, load.slope.slope])
    }

    /// Searches until the peak is known to this relative tolerance, or this many spans were looked at.
    pub fn run(&self, tolerance: f64, most: usize) -> Found {
        self.resume(self.start(), tolerance, most)
    }

    /// A revolution in a few spans.
    pub fn start(&self) -> Found {
        let step = 1.0 / f64::from(FIRST_SPANS);
        let mut found = Found { low: 0.0, high: f64::INFINITY, spans: Vec::new(), looked_at: 0 };
        for place in 0..FIRST_SPANS {
            found.spans.extend(self.look(f64::from(place) * step, f64::from(place + 1) * step, &mut found.low));
        }
        found.looked_at = FIRST_SPANS as usize;
        found
    }

    /// Goes on with a search.
    pub fn resume(&self, found: Found, tolerance: f64, most: usize) -> Found {
        let Found { mut low, mut looked_at, spans, .. } = found;
        let mut heap: BinaryHeap<Span> = spans.into();
        while let Some(top) = heap.peek().copied() {
            let middle = top.from + (top.to - top.from) / 2.0;
            let is_known = top.bound <= low * (1.0 + tolerance) * (1.0 + tolerance);
            if is_known || looked_at >= most || !(top.from < middle && middle < top.to) {
                let spans = heap.into_iter().filter(|span| span.bound >= low).collect();
                return Found { low, high: top.bound, spans, looked_at };
            }
            heap.pop();
            heap.extend(self.look(top.from, middle, &mut low));
            heap.extend(self.look(middle, top.to, &mut low));
            looked_at += 2;
        }
        Found { low, high: low, spans: Vec::new(), looked_at }
    }

    /// A span with its bound, if it may hold the peak; a load that is found there raises the lower bound.
    fn look(&self, from: f64, to: f64, low: &mut f64) -> Option<Span> {
        let over = self.over(Interval { low: from, high: to });
        let at = self.at(from + (to - from) / 2.0);
        *low = low.max(at.low);
        // Mean value theorem: from the middle the load changes at most by the slope times half the span, in radians.
        let change =
            Interval::point(over.slope.size()).times(&Interval::TAU.times(&Interval::point(to - from)).over(2));
        let bound = over.value.high.min(at.plus(&change).high);
        (over.slope.contains_zero() && bound >= *low).then_some(Span { from, to, bound })
    }
}
