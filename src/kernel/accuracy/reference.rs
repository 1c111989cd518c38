//! What is the peak, to many digits and guaranteed? The yardstick of all other methods.
//!
//! Branch and bound leaves short spans around the largest values. In each of them the squared load F is concave, which
//! intervals prove: `F″ ≤ −κ`. Then with any angle m of the span `F ≤ F(m) + F′(m)²/(2κ)`, and Newton's method finds an m at
//! which that is hardly more than F(m). F(m) and F′(m) are evaluated in fractions with outward rounding.

use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::bodies::{Bodies, phases};
use super::branch::{Found, Search, Span};
use super::fixed::Fixed;
use super::interval::Interval;
use super::jet::{Jet, turning};
use crate::engine::Engine;
use crate::exact::Turn;
use crate::motion::Enclosure;
use crate::proof::Quantity;

/// Bits behind the point; more where a crank comes near the end of its reach.
const BITS: u32 = 192;
/// Relative widths at which the spans are handed over: the next one where a span is too long for its load to be concave.
const HANDED_OVER: [f64; 4] = [1e-6, 1e-8, 1e-10, 1e-12];
/// A peak that is known to this part is known.
const ENOUGH: f64 = 1e-24;
/// Spans that the search may look at.
const MOST_SPANS: usize = 16_000;
/// More separate places than this are those of a load that hardly changes.
const MOST_PLACES: usize = 64;
/// Steps of Newton's method in floats.
const NEWTON_STEPS: usize = 8;
/// The last step, in fractions, is shorter than this many turns.
const LAST_STEP: f64 = 1e-9;

/// An engine in fractions.
#[derive(Clone, Debug)]
pub(super) struct Fractions {
    search: Search,
    bodies: Bodies<Jet<Fixed>>,
    phases: Vec<Turn>,
    bits: u32,
}

impl Fractions {
    pub fn new(engine: &Engine, quantity: Quantity) -> Self {
        let gap = |rod: &crate::engine::Rod| {
            let sum: BigRational = &rod.ratio + rod.offset.abs();
            let gap = BigRational::from_integer(1.into()) - sum;
            (gap.denom().bits() as i64 - gap.numer().bits() as i64).clamp(0, 4096) as u32
        };
        // The motion divides by the third power of a root of the gap.
        let bits = BITS + 4 * engine.rods().map(gap).max().unwrap_or(0);
        let number = |number: &BigRational| Fixed::around(number, bits);
        let direction = |angle: &Turn| Fixed::direction(angle, bits);
        let bodies = Bodies::new(engine, quantity, &number, &direction).map(&Jet::constant);
        Fractions { search: Search::new(engine, quantity), bodies, phases: phases(engine), bits }
    }

    /// The squared load at an angle, and its slope; none where nothing is known.
    fn at(&self, turns: &BigRational) -> Option<[[BigRational; 2]; 2]> {
        let angle = Turn::new(turns.clone());
        let cylinders = self.phases.iter().map(|phase| turning(&Fixed::direction(&(&angle + phase), self.bits)));
        let load = self.bodies.squared_load(&turning(&Fixed::direction(&angle, self.bits)), cylinders)?;
        Some([load.value.ends()?, load.slope.ends()?])
    }

    /// The length of the load at crank angle 0.
    pub fn at_zero(&self) -> Option<Enclosure> {
        let [[low, high], _] = self.at(&BigRational::zero())?;
        Some(root(&low, &high))
    }

    /// The peak, which lies below a known bound and first of all near an angle in degrees; none where it cannot be enclosed.
    pub fn peak(&self, bound: f64, near: f64) -> Option<Enclosure> {
        let near = BigRational::from_float(near)? / BigRational::from_integer(360.into());
        let [[near, _], _] = self.at(&near)?;
        let bound = BigRational::from_float(bound);
        let mut best: Option<Enclosure> = None;
        let mut found = self.search.start();
        for tolerance in HANDED_OVER {
            found = self.search.resume(found, tolerance, MOST_SPANS);
            let squares = self.within(&found)?;
            let peak = root(&squares.low.max(near.clone()), &squares.high);
            let high = bound.iter().fold(peak.high, |high, bound| high.min(bound.clone()));
            let peak = Enclosure { high: high.max(peak.low.clone()), low: peak.low };
            let is_known = peak.width() <= &peak.high * BigRational::from_float(ENOUGH)?;
            best = match best {
                Some(best) if best.width() <= peak.width() => Some(best),
                _ => Some(peak),
            };
            if is_known || found.looked_at >= MOST_SPANS {
                break;
            }
        }
        best
    }

    /// The squared peak from the spans that a search left.
    fn within(&self, found: &Found) -> Option<Enclosure> {
        let places = places(found);
        let mut low = BigRational::from_float(found.low)?;
        let mut high = BigRational::zero();
        let few = places.len() <= MOST_PLACES;
        for place in places {
            let bound = place.iter().map(|span| span.bound).fold(0.0, f64::max);
            let known = BigRational::from_float(bound)?;
            let bound = match few.then(|| self.concave(&place)).flatten() {
                Some(tight) => {
                    low = low.max(tight.low);
                    tight.high.min(known)
                }
                None => known,
            };
            high = high.max(bound);
        }
        Some(Enclosure { high: high.max(low.clone()), low })
    }

    /// Encloses the largest squared load of spans side by side, in all of which it is concave.
    fn concave(&self, spans: &[Span]) -> Option<Enclosure> {
        let (from, to) = (spans.first()?.from, spans.last()?.to);
        let middle = from + (to - from) / 2.0;
        let newton = |turns: f64| {
            let [slope, curvature] = self.search.curvature(turns, turns).map(|part| f64::midpoint(part.low, part.high));
            turns - slope / curvature / TAU
        };
        let top = (0..NEWTON_STEPS).fold(middle, |turns, _| newton(turns));
        let top = if (top - middle).abs() <= to - from { top } else { middle };
        // The angle found may lie just outside; the load has to be concave up to there.
        let beside = [(top - LAST_STEP, from), (to, top + LAST_STEP)].into_iter().filter(|(from, to)| from < to);
        let mut curvature: Option<Interval> = None;
        for (from, to) in spans.iter().map(|span| (span.from, span.to)).chain(beside) {
            let [_, here] = self.search.curvature(from, to);
            if here.high >= 0.0 {
                return None;
            }
            curvature = Some(curvature.map_or(here, |so_far| so_far.hull(here)));
        }
        let curvature = curvature?;
        let kappa = BigRational::from_float(-curvature.high)?;
        let mut turns = BigRational::from_float(top)?;
        // One more step, from the slope in fractions: the step itself may be rounded.
        let [_, [low, high]] = self.at(&turns)?;
        let [_, bend] = self.search.curvature(top, top);
        let step = (low + high).to_f64()? / 2.0 / f64::midpoint(bend.low, bend.high) / TAU;
        if step.abs() < LAST_STEP {
            turns -= BigRational::from_float(step)?;
        }
        let [[low, high], slope] = self.at(&turns)?;
        let steep = slope[0].abs().max(slope[1].abs());
        Some(Enclosure { high: high + &steep * &steep / (kappa * BigRational::from_integer(2.into())), low })
    }
}

/// Spans in their order, those that touch together.
fn places(found: &Found) -> Vec<Vec<Span>> {
    let mut spans = found.spans.clone();
    spans.sort_by(|a, b| a.from.total_cmp(&b.from));
    spans.chunk_by(|one, next| next.from <= one.to).map(<[Span]>::to_vec).collect()
}

/// The square roots of the ends, rounded outward.
fn root(low: &BigRational, high: &BigRational) -> Enclosure {
    let bits = 2 * BITS;
    let unit = BigInt::from(1) << bits;
    let square = |number: &BigRational| (number.numer().max(&BigInt::zero()) << (2 * bits)) / number.denom();
    let end = |root: BigInt| BigRational::new(root, unit.clone());
    Enclosure { low: end(square(low).sqrt()), high: end((square(high) + 1_u32).sqrt() + 1) }
}
