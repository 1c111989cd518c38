//! How large is the crankshaft drawn from the side? To scale along its length, so that names have room.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::engine::{Engine, throws};

/// The outermost cylinders and bearings are this far apart at most, in millimetres.
const LONGEST: f64 = 84.0;
/// Where there are many places, each has this much room, up to a limit.
const CROWDED: f64 = 3.4;
const WIDEST: f64 = 240.0;
/// Neighbours are not drawn farther apart than this.
const FARTHEST: f64 = 17.0;
/// A reference plane farther outside than this at the free end, or at the other, is drawn there.
const EDGES: (f64, f64) = (22.0, 8.0);

/// Positions along the crankshaft on the page: +z, the free end, to the left.
pub(super) struct Scale {
    highest: f64,
    millimetres: f64,
    /// Distance of the outermost places on the page.
    pub span: f64,
    /// Smallest distance between two cylinders on the page, and between two throws; infinite where there is only one.
    pub cylinders_apart: f64,
    pub throws_apart: f64,
}

impl Scale {
    pub fn new(engine: &Engine) -> Self {
        let float = |position: &BigRational| position.to_f64().unwrap_or(0.0);
        let cylinders = sorted(engine.cylinders().iter().map(|cylinder| float(&cylinder.position)));
        let throws = sorted(throws(engine).iter().map(|throw| float(&throw.position)));
        let weights = engine.crankshaft().counterweights.iter().map(|weight| float(&weight.position));
        let all = sorted(cylinders.iter().copied().chain(engine.bearings().iter().map(float)).chain(weights));
        let (low, high) = (all.first().copied().unwrap_or(0.0), all.last().copied().unwrap_or(0.0));
        let span = high - low;
        let gap = |places: &[f64]| {
            let gaps = places.windows(2).map(|pair| pair[1] - pair[0]);
            gaps.filter(|gap| *gap > span * 1e-6).fold(f64::INFINITY, f64::min)
        };
        let different = 1 + cylinders.windows(2).filter(|pair| pair[1] - pair[0] > span * 1e-6).count();
        let most = LONGEST.max(different as f64 * CROWDED).min(WIDEST);
        let millimetres = if span > 0.0 { (most / span).min(FARTHEST / gap(&throws).min(span)) } else { 1.0 };
        Scale {
            highest: high,
            millimetres,
            span: span * millimetres,
            cylinders_apart: gap(&cylinders) * millimetres,
            throws_apart: gap(&throws) * millimetres,
        }
    }

    /// Where a position is on the page; the free end at 0.
    pub fn x(&self, position: &BigRational) -> f64 {
        (self.highest - position.to_f64().unwrap_or(0.0)) * self.millimetres
    }

    /// The same for a plane that may lie far outside, and whether it had to be brought nearer.
    pub fn near(&self, position: &BigRational) -> (f64, bool) {
        let x = self.x(position);
        let near = x.clamp(-EDGES.0, self.span + EDGES.1);
        (near, near != x)
    }
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}
