//! What is the front: for each mass of the crankshaft the least load of its bearings?

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::bound::Bound;
use super::design::{Design, Left, measure, note, weight};
use super::direction::Directions;
use super::exact::{Steps, counterweights, mass_radii};
use super::file;
use super::place::{Place, bare, places, uniform};
use super::problem::Problem;
use super::refused::Refused;
use super::sample::Samples;
use super::solve::{Goal, Least, Solution};
use super::{Couple, Wish};
use crate::exact::Turn;
use crate::layout::{Layout, throws};

/// A crankshaft of the front.
#[derive(Clone, Debug)]
pub struct Point {
    /// The layout with its counterweights, as its own file says.
    pub layout: Layout,
    /// What it weighs and does.
    pub design: Design,
    /// No crankshaft of this mass that keeps the conditions has a lower largest bearing load, in multiples of m r ω²: by weak
    /// duality, in floats.
    pub least: f64,
}

/// A crankshaft with one balance factor for all throws, and the best of the same mass.
#[derive(Clone, Debug)]
pub struct Uniform {
    /// The balance factor.
    pub factor: BigRational,
    /// What it weighs and does.
    pub design: Design,
    /// The best crankshaft of the same mass; none where no crankshaft so light keeps the conditions.
    pub best: Option<Point>,
}

/// The best crankshafts of a layout.
#[derive(Clone, Debug)]
pub struct Front {
    /// Where counterweights may stand.
    pub places: Vec<Place>,
    /// From the lightest crankshaft that keeps the conditions to the one with the least load.
    pub points: Vec<Point>,
    /// Those with uniform balance factors 0, 0.65 and 1, where every throw has counterweights.
    pub uniform: Vec<Uniform>,
}

/// Part by which the mass, or the peak, may exceed its optimum where the other is made least among all that reach it.
const SLACK: f64 = 1e-6;

/// Finds the front of a layout.
///
/// ```standalone_crate
/// use crankstar::optimise::{Couple, Left, Wish, front};
/// let file = "speed = 6000\nbearings = [1.5, 0.5, -0.5, -1.5]\n[inline]\nthrows = [0, 120, 240]\n[mechanism]\n\
///     reciprocating_mass = 0.65\nrotating_mass = 0.5\ncrank_radius = '45 mm'\nrod_ratio = 0.25\n\
///     [crankshaft]\nbalance_factor = 1\ncounterweight_radius = '45 mm'\nweb_offset = 0.2";
/// let i3 = crankstar::layout::parse("i3.toml", file).unwrap();
/// let wish = Wish { couple: Couple::Zero, points: 2, orders: vec![1, 2] };
/// let front = front(&i3, &wish).unwrap();
/// let [lightest, calmest] = front.points.as_slice() else { panic!() };
/// assert!(lightest.design.mass < calmest.design.mass && lightest.design.peak() > calmest.design.peak());
/// assert_eq!((lightest.design.force, lightest.design.couple), (Left::Zero, Left::Zero));
/// assert!(calmest.least > 0.999 * calmest.design.peak());
/// ```
///
/// # Errors
/// [`Refused`] says what is missing.
pub fn front(layout: &Layout, wish: &Wish) -> Result<Front, Refused> {
    if wish.points == 0 {
        return Err(Refused::NoPoints);
    }
    let mut search = Search::new(layout, wish)?;
    let ends = search.ends()?;
    // Where the least load comes with the least mass, there is one point.
    let steps = if ends[1] - ends[0] > 2.0 * SLACK * ends[0] { wish.points - 1 } else { 0 };
    let mut points = Vec::new();
    for step in 0..=steps {
        let part = if steps == 0 { 1.0 } else { step as f64 / steps as f64 };
        let mass = ends[0] + (ends[1] - ends[0]) * part;
        let name = format!("Point {} of {} of the front", step + 1, steps + 1);
        points.push(search.best(mass.max(ends[0] * (1.0 + SLACK)), &name)?);
    }
    let mut compared = Vec::new();
    for factor in [(0, 1), (13, 20), (1, 1)].map(|(over, under)| BigRational::new(over.into(), under.into())) {
        let Some(uniform) = uniform(layout, &factor) else { continue };
        let design = measure(&uniform, &search.places, &wish.orders)?;
        let mass = design.mass.to_f64().unwrap_or(f64::INFINITY);
        // The lightest one has room to be solved in, as among the points.
        let room = ends[0] * (1.0 + SLACK);
        let best = match mass * (1.0 + SLACK) >= ends[0] {
            true => Some(
                search.best(mass.max(room), &format!("As heavy as with a balance factor of {}", decimal(&factor)))?,
            ),
            false => None,
        };
        compared.push(Uniform { factor, design, best });
    }
    Ok(Front { places: search.places, points, uniform: compared })
}

struct Search<'a> {
    layout: &'a Layout,
    wish: &'a Wish,
    places: Vec<Place>,
    problem: Problem,
    samples: Samples,
    directions: Directions,
    steps: Steps,
}

impl<'a> Search<'a> {
    fn new(layout: &'a Layout, wish: &'a Wish) -> Result<Self, Refused> {
        let places = places(layout);
        let mut problem = Problem::new(layout, &places, wish)?;
        let own = throws(layout).into_iter().map(|throw| throw.angle);
        let others = problem.exact.iter().flat_map(|sum| sum.terms()).map(|term| term.angle.clone());
        let directions = Directions::new(&own.chain(others).collect::<Vec<Turn>>());
        let radius = layout.mechanism.crank_radius.clone().ok_or(Refused::NoMasses)?;
        let steps = Steps::new(&problem.unit, &radius);
        if let Some(most) = problem.most_couple {
            // What rounding may add: half a step along each of two directions a weight, which the closing weight takes over.
            let step = (&steps.mass_radius / &problem.unit).to_f64().unwrap_or(0.0);
            let longest = problem.arms.iter().map(|arm| arm.abs()).fold(0.0, f64::max);
            let moved: f64 = problem.arms.iter().map(|arm| arm.abs() + longest).sum();
            // A bound that leaves no room for that is kept by no couple at all.
            problem.most_couple = Some(most - step * moved).filter(|left| *left > most / 2.0);
        }
        let samples = Samples::new(&problem);
        Ok(Search { layout, wish, places, problem, samples, directions, steps })
    }

    fn solve(&mut self, least: Least, mass: Option<f64>, peak: Option<f64>) -> Result<Solution, Refused> {
        self.samples.solve(&self.problem, Goal { least, mass, peak })
    }

    /// The masses of the ends of the front: the lightest crankshaft, and the lightest with the least load.
    fn ends(&mut self) -> Result<[f64; 2], Refused> {
        let lightest = self.solve(Least::Mass, None, None)?.mass;
        let least = self.solve(Least::Peak, None, None)?.peak;
        let last = self.solve(Least::Mass, None, Some(least * (1.0 + SLACK)))?.mass;
        Ok([lightest, last.max(lightest)])
    }

    /// The crankshaft of this mass with the least load; of all that reach it within a millionth that with the least sum of
    /// squares of its mass-radii, which is one alone, so that roundings do not choose among equals.
    fn best(&mut self, mass: f64, name: &str) -> Result<Point, Refused> {
        let best = self.solve(Least::Peak, Some(mass), None)?;
        let bound = Bound::new(&self.problem, self.samples.all(), &best);
        let peak = Some(best.peak * (1.0 + SLACK));
        let chosen = self.solve(Least::Squares, Some(mass), peak).unwrap_or(best);
        let exact = mass_radii(&self.problem, &self.places, &self.directions, &self.steps, &chosen.weights);
        let pairs = self.places.iter().zip(&exact);
        let weights: Vec<_> = pairs.map(|(place, sum)| counterweights(place, sum, &self.steps.mass)).collect();
        let mut draft = bare(self.layout);
        draft.crankshaft.counterweights = weights.iter().flatten().cloned().collect();
        let notes: Vec<String> = self.places.iter().map(|place| note(&weight(&draft, place))).collect();
        let head = format!("{name}: {}.\n{PARTS}", condition(&self.wish.couple));
        let layout = file::with_counterweights(self.layout, &weights, &head, &notes)?;
        let design = measure(&layout, &self.places, &self.wish.orders)?;
        if !keeps(&design, &self.wish.couple) {
            return Err(Refused::Unsolved("the rounded counterweights do not keep the balance".to_owned()));
        }
        let least = bound.at(design.mass.to_f64().unwrap_or(f64::INFINITY));
        Ok(Point { layout, design, least })
    }
}

const PARTS: &str =
    "Tables at one position are one counterweight, written in parts along directions in which its mass-radius is exact:
their masses add up to its own, and their common centre of gravity stands within the radius that it had to keep.";

/// Whether force and couple are what was asked for, proved.
fn keeps(design: &Design, couple: &Couple) -> bool {
    let bounded = match (design.couple, couple) {
        (Left::Zero, _) => true,
        (Left::Between(_, high), Couple::AtMost(most)) => high <= most.to_f64().unwrap_or(0.0),
        (Left::Between(..), Couple::Zero) => false,
    };
    bounded && design.force == Left::Zero
}

fn condition(couple: &Couple) -> String {
    match couple {
        Couple::Zero => "no first-order force or couple turns with the crank, exactly".to_owned(),
        Couple::AtMost(most) => {
            format!("no first-order force turns with the crank, and a couple of {} N·m at most", decimal(most))
        }
    }
}

fn decimal(value: &BigRational) -> String {
    value.to_f64().unwrap_or(f64::NAN).to_string()
}
