//! For which values of its open angle do the cylinders of a family fire at which angles?
//!
//! Cylinder j fires at `τ_j = α_j − β_j` and whole revolutions. In a firing order each interval is above 0 and at most a
//! revolution: with `v_i` from one τ to the next it is `v_i + n_i`, `n_i = 1 − ⌈v_i⌉`. All v_i add to 0, so an order can be fired
//! exactly where the n_i add to the revolutions of the cycle; they change only where some v_i is whole.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::cycle::Cycle;
use super::family::Family;
use super::linear::Linear;
use super::open_firing::{OpenFiring, dead_centre};

/// An end of a range of angles, in turns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// The angle.
    pub at: BigRational,
    /// Whether it belongs to the range.
    pub included: bool,
}

/// Values of the open angle for which the cylinders fire at these angles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FiringSpan {
    /// From where to where; none where they do so for all values.
    pub within: Option<[End; 2]>,
    /// The crank angle in turns at which each cylinder fires.
    pub angles: Vec<Linear>,
}

impl FiringSpan {
    /// Whether a value of the open angle lies in it.
    pub fn holds(&self, value: &BigRational) -> bool {
        self.within.as_ref().is_none_or(|[low, high]| {
            let above = *value > low.at || low.included && *value == low.at;
            above && (*value < high.at || high.included && *value == high.at)
        })
    }
}

/// Why it is not known when the cylinders of a family fire.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoSpans {
    /// The layout does not say it.
    #[error(
        "half orders depend on which revolution each cylinder fires in; add cycle = \"four-stroke\" with firing_order, or with firing_angles such as [0, \"360 + phi\"]"
    )]
    NotSaid,
    /// Two angles are open, so that an order holds in a region of the plane.
    #[error(
        "two angles are open, and for which of them the firing order can be fired is not solved; give firing_angles, or one of them a value below [values]"
    )]
    TwoAngles,
    /// The range of the angle holds more changes of the revolutions than are looked at.
    #[error("the range of the open angle is too wide for a firing order; give firing_angles")]
    TooWide,
}

/// More changes of the revolutions than this are not looked at.
const MOST_CHANGES: i64 = 2000;

impl Family {
    /// What it says of its firing.
    pub fn open_firing(&self) -> Option<&OpenFiring> {
        self.draft().open_firing.as_ref()
    }

    /// The unknowns in its angles, by name.
    pub fn open_angles(&self) -> BTreeSet<&str> {
        let angles = self.cylinders().iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank]);
        angles.flat_map(|angle| angle.symbols().keys()).map(String::as_str).collect()
    }

    /// Crank angle `α − β` in turns at which each cylinder is at a top dead centre.
    pub fn dead_centres(&self) -> Vec<Linear> {
        self.cylinders().iter().map(dead_centre).collect()
    }

    /// For which values of its open angle in a range, in turns, the cylinders fire at which angles, rising; the ends of the range
    /// belong to it where `with_ends` says so. Empty where its firing order cannot be fired.
    ///
    /// # Errors
    /// See [`NoSpans`].
    pub fn firing_spans(&self, range: [&BigRational; 2], with_ends: bool) -> Result<Vec<FiringSpan>, NoSpans> {
        let (cycle, firing) = self.cycle().zip(self.open_firing()).ok_or(NoSpans::NotSaid)?;
        let order = match firing {
            OpenFiring::Angles(angles) => return Ok(vec![FiringSpan { within: None, angles: angles.clone() }]),
            OpenFiring::Order(order) => order,
        };
        let unknowns = self.open_angles();
        let mut unknowns = unknowns.iter();
        match (unknowns.next(), unknowns.next()) {
            (_, Some(_)) => Err(NoSpans::TwoAngles),
            (unknown, None) => Steps::new(&self.dead_centres(), order, unknown.copied().unwrap_or_default(), cycle)
                .spans(range, with_ends),
        }
    }
}

/// The crank angles from each top dead centre to that of the next cylinder of the order, whole revolutions apart.
struct Steps<'a> {
    order: &'a [usize],
    unknown: &'a str,
    cycle: Cycle,
    steps: Vec<Linear>,
}

impl<'a> Steps<'a> {
    fn new(dead_centres: &[Linear], order: &'a [usize], unknown: &'a str, cycle: Cycle) -> Self {
        let next = order.iter().cycle().skip(1);
        let steps = order.iter().zip(next).map(|(&one, &next)| dead_centres[next].minus(&dead_centres[one])).collect();
        Steps { order, unknown, cycle, steps }
    }

    fn spans(&self, [low, high]: [&BigRational; 2], with_ends: bool) -> Result<Vec<FiringSpan>, NoSpans> {
        let changes: Vec<BigRational> = self.changes(low, high)?.into_iter().collect();
        let half = BigRational::new(1.into(), 2.into());
        let mut spans: Vec<FiringSpan> = Vec::new();
        let mut add = |from: &BigRational, to: &BigRational, is_point: bool, at: &BigRational| {
            let Some(angles) = self.angles_at(at) else { return };
            let end = |at: &BigRational| End { at: at.clone(), included: is_point };
            match spans.last_mut() {
                Some(FiringSpan { within: Some([_, last]), angles: own })
                    if *own == angles && last.at == *from && (last.included || is_point) =>
                {
                    *last = end(to);
                }
                _ => spans.push(FiringSpan { within: Some([end(from), end(to)]), angles }),
            }
        };
        for (place, from) in changes.iter().enumerate() {
            let is_end = place == 0 || place + 1 == changes.len();
            if with_ends || !is_end {
                add(from, from, true, from);
            }
            if let Some(to) = changes.get(place + 1) {
                add(from, to, false, &((from + to) * &half));
            }
        }
        Ok(spans)
    }

    /// The ends of the range, and the values in it at which some step is whole.
    fn changes(&self, low: &BigRational, high: &BigRational) -> Result<BTreeSet<BigRational>, NoSpans> {
        let mut changes = BTreeSet::from([low.clone(), high.clone()]);
        for step in &self.steps {
            let coefficient = step.coefficient(self.unknown);
            if coefficient.is_zero() {
                continue;
            }
            let ends = [low, high].map(|end| step.known() + &coefficient * end);
            let (Some(least), Some(most)) = (ends.iter().min(), ends.iter().max()) else { continue };
            let (mut whole, last) = (least.ceil().to_integer(), most.floor().to_integer());
            if &last - &whole > BigInt::from(MOST_CHANGES) {
                return Err(NoSpans::TooWide);
            }
            while whole <= last {
                changes.insert((BigRational::from_integer(whole.clone()) - step.known()) / &coefficient);
                whole += 1;
            }
        }
        Ok(changes)
    }

    /// When each cylinder fires, after the first of the order, at this value and round it; none where the order cannot be fired.
    fn angles_at(&self, at: &BigRational) -> Option<Vec<Linear>> {
        let mut angles = vec![Linear::default(); self.order.len()];
        let mut angle = Linear::default();
        let mut revolutions = BigRational::zero();
        for (&cylinder, step) in self.order.iter().zip(&self.steps) {
            angles[cylinder] = angle.clone();
            let whole = BigRational::one() - (step.known() + step.coefficient(self.unknown) * at).ceil();
            angle = angle.plus(step).plus(&Linear::constant(whole.clone()));
            revolutions += whole;
        }
        (self.order.len() == 1 || revolutions == self.cycle.turns()).then_some(angles)
    }
}
