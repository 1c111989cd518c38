//! Which crankshaft of one mass is best? Solved, rounded, closed exactly, written, read back and measured.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::bound::Bound;
use super::design::{Design, measure, note, weight};
use super::direction::Directions;
use super::error::OptimiseError;
use super::exact::{Steps, mass_radii};
use super::file;
use super::first::Residual;
use super::place::{Place, places};
use super::problem::Problem;
use super::sample::Samples;
use super::solve::{Goal, Least, Solution};
use super::{Couple, Request};
use crate::engine::{Engine, throws};
use crate::exact::Turn;
use crate::file::FileResolver;
use crate::loads::Scale;
use crate::remedy::counterweight_parts;

/// Part by which the mass, or the peak, may exceed its optimum where the other is made least among all that reach it.
pub(super) const SLACK: f64 = 1e-6;
/// Part by which the peak that the solver finds may exceed the least one.
const ACCURACY: f64 = 1e-4;
/// What the rounding of irrational numbers may leave, in multiples of m r ω² a cylinder.
const SLIGHT: f64 = 1e-9;

/// A crankshaft of the front.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// The engine with its counterweights, as its own file says.
    pub engine: Engine,
    /// What it weighs and does.
    pub design: Design,
    /// No crankshaft of this mass that keeps the conditions has a lower largest bearing load, in multiples of m r ω²: by weak
    /// duality, in floats.
    pub least: f64,
}

/// A problem with what its solutions share.
pub(super) struct Search<'a> {
    engine: &'a Engine,
    request: &'a Request,
    beside: FileResolver<'a>,
    pub places: Vec<Place>,
    problem: Problem,
    samples: Samples,
    directions: Directions,
    steps: Steps,
}

impl<'a> Search<'a> {
    pub fn new(engine: &'a Engine, request: &'a Request, beside: FileResolver<'a>) -> Result<Self, OptimiseError> {
        let places = places(engine);
        let mut problem = Problem::new(engine, &places, request)?;
        let own = throws(engine).into_iter().map(|throw| throw.angle);
        let exact = problem.shafts.iter().flat_map(|shaft| &shaft.exact);
        let others = exact.flat_map(|sum| sum.terms()).map(|term| term.angle.clone());
        let directions = Directions::new(&own.chain(others).collect::<Vec<Turn>>());
        let radius = engine.dimensions().crank_radius.clone().ok_or(OptimiseError::NoMasses)?;
        let steps = Steps::new(&problem.unit, &radius);
        if let Some(most) = problem.most_couple {
            // What rounding may add: half a step along each of two directions per weight, which the closing weight takes over.
            let step = (&steps.mass_radius / &problem.unit).to_f64().unwrap_or(0.0);
            let longest = problem.arms.iter().map(|arm| arm.abs()).fold(0.0, f64::max);
            let moved: f64 = problem.arms.iter().map(|arm| arm.abs() + longest).sum();
            // A bound that leaves no room for that is kept by no couple at all.
            problem.most_couple = Some(most - step * moved).filter(|left| *left > most / 2.0);
        }
        let samples = Samples::new(&problem);
        Ok(Search { engine, request, beside, places, problem, samples, directions, steps })
    }

    fn solve(&mut self, least: Least, mass: Option<f64>, peak: Option<f64>) -> Result<Solution, OptimiseError> {
        self.samples.solve(&self.problem, Goal { least, mass, peak })
    }

    /// The masses of the ends of the front: the lightest crankshaft, and the lightest with the least load.
    pub fn ends(&mut self) -> Result<[f64; 2], OptimiseError> {
        let lightest = self.solve(Least::Mass, None, None)?.mass;
        let least = self.solve(Least::Peak, None, None)?.peak;
        let last = self.solve(Least::Mass, None, Some(least * (1.0 + SLACK)))?.mass;
        Ok([lightest, last.max(lightest)])
    }

    /// The least mass with which no bearing load is larger than this; none where no mass does that.
    pub fn lightest(&mut self, peak: f64) -> Result<Option<f64>, OptimiseError> {
        let least = self.solve(Least::Peak, None, None)?.peak;
        // The least load is known to the accuracy of the solver: a load a little below it is that load.
        if peak < least * (1.0 - ACCURACY) {
            return Ok(None);
        }
        let peak = peak.max(least * (1.0 + SLACK));
        Ok(Some(self.solve(Least::Mass, None, Some(peak))?.mass))
    }

    /// The crankshaft of this mass with the least load; of all that reach it within a millionth that with the least sum of
    /// squares of its mass-radii, which is one alone, so that roundings do not choose among equals.
    pub fn best(&mut self, mass: f64, name: &str) -> Result<Optimum, OptimiseError> {
        let best = self.solve(Least::Peak, Some(mass), None)?;
        let bound = Bound::new(&self.problem, self.samples.all(), &best);
        let peak = Some(best.peak * (1.0 + SLACK));
        let chosen = self.solve(Least::Squares, Some(mass), peak).unwrap_or(best);
        let exact = mass_radii(&self.problem, &self.places, &self.directions, &self.steps, &chosen.weights);
        let pairs = self.places.iter().zip(&exact);
        let weights: Vec<_> =
            pairs.map(|(place, sum)| counterweight_parts(&place.empty(), sum, &self.steps.mass)).collect();
        let draft = self.engine.with_counterweights(weights.iter().flatten().cloned().collect());
        let draft = draft.map_err(|error| OptimiseError::Unsolved(error.to_string()))?;
        let notes: Vec<String> = self.places.iter().map(|place| note(&weight(&draft, place))).collect();
        let head = format!("{name}: {}.\n{PARTS}", condition(&self.request.couple, self.problem.is_exact()));
        let engine = file::with_counterweights((self.engine, self.beside), &weights, &head, &notes)?;
        let design = measure(&engine, &self.places, &self.request.orders)?;
        if !self.keeps(&design) {
            return Err(OptimiseError::Unsolved("the rounded counterweights do not keep the balance".to_owned()));
        }
        let least = bound.at(design.mass.to_f64().unwrap_or(f64::INFINITY));
        Ok(Optimum { engine, design, least })
    }

    /// Whether force and couple are what was asked for, proved: nothing, or with offsets next to nothing.
    fn keeps(&self, design: &Design) -> bool {
        let slight = match (self.problem.is_exact(), &design.scale) {
            (true, _) => 0.0,
            (false, scale) => SLIGHT * scale.as_ref().map_or(1.0, Scale::force) * self.engine.cylinders().len() as f64,
        };
        let longest = self.problem.arms.iter().map(|arm| arm.abs()).fold(1.0, f64::max);
        let is_at_most = |left: Residual, most: f64| match left {
            Residual::Zero => true,
            Residual::Between(_, high) => high <= most,
        };
        let couple = match &self.request.couple {
            Couple::Zero => slight * longest,
            Couple::AtMost(most) => most.to_f64().unwrap_or(0.0).max(slight * longest),
        };
        is_at_most(design.force, slight) && is_at_most(design.couple, couple)
    }
}

const PARTS: &str = "Tables at one position are one counterweight, written in parts along directions in which its mass-radius is exact:\ntheir masses add up to its own, and their common centre of gravity lies within the radius that it had to keep.";

fn condition(couple: &Couple, is_exact: bool) -> String {
    match couple {
        Couple::Zero if is_exact => "no first-order force or couple turns with the crank, exactly".to_owned(),
        Couple::Zero => {
            "no first-order force or couple turns with the crank, but for the rounding of an irrational number"
                .to_owned()
        }
        Couple::AtMost(most) => {
            format!("no first-order force turns with the crank, and a couple of {} N·m at most", decimal(most))
        }
    }
}

/// A number in the words of a file.
pub(super) fn decimal(value: &BigRational) -> String {
    crate::numbers::float(value).to_string()
}
