//! What is the front: for each mass of the crankshaft the least load of its bearings?

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::Request;
use super::best::{Optimum, SLACK, Search, decimal};
use super::design::{Design, measure};
use super::error::{MOST_POINTS, OptimiseError};
use super::place::{Place, uniform};
use crate::engine::Engine;
use crate::file::FileResolver;

/// A crankshaft with one balance factor for all throws, and the best ones of the same mass and of the same load.
#[derive(Clone, Debug)]
pub struct Uniform {
    /// The balance factor.
    pub factor: BigRational,
    /// What it weighs and does.
    pub design: Design,
    /// The best crankshaft of the same mass; none where no crankshaft so light keeps the conditions.
    pub best: Option<Optimum>,
    /// The lightest crankshaft that keeps the conditions with no larger a load, but for the rounding of its weights; none
    /// where there is none.
    pub lightest: Option<Optimum>,
}

/// The best crankshafts of an engine.
#[derive(Clone, Debug)]
pub struct Front {
    /// Where counterweights may stand.
    pub places: Vec<Place>,
    /// From the lightest crankshaft that keeps the conditions to the one with the least load.
    pub points: Vec<Optimum>,
    /// Those with uniform balance factors 0, 0.65 and 1, where every throw has counterweights.
    pub uniform: Vec<Uniform>,
}

/// Finds the front of an engine.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::file::FileResolver;
/// use crankstar::optimise::{Couple, Residual, Request, front};
/// let file = "speed = 6000\nbearings = [1.5, 0.5, -0.5, -1.5]\n[inline]\nthrows = [0, 120, 240]\n[mechanism]\n\
///     reciprocating_mass = 0.65\nrotating_mass = 0.5\ncrank_radius = '45 mm'\nrod_ratio = 0.25\n\
///     [crankshaft]\nbalance_factor = 1\ncounterweight_radius = '45 mm'\nweb_offset = 0.2";
/// let i3 = crankstar::file::parse("i3.toml", file).unwrap();
/// let request = Request { couple: Couple::Zero, points: 2, orders: vec![1, 2] };
/// let front = front(&i3, &request, FileResolver::nothing()).unwrap();
/// let [lightest, calmest] = front.points.as_slice() else { panic!() };
/// assert!(lightest.design.mass < calmest.design.mass && lightest.design.peak() > calmest.design.peak());
/// assert_eq!((lightest.design.force, lightest.design.couple), (Residual::Zero, Residual::Zero));
/// assert!(calmest.least > 0.999 * calmest.design.peak());
/// ```
///
/// The layout is written and read back: `beside` reads a file that it names beside itself.
///
/// # Errors
/// [`OptimiseError`] says what is missing.
pub fn front(engine: &Engine, request: &Request, beside: FileResolver<'_>) -> Result<Front, OptimiseError> {
    if !(1..=MOST_POINTS).contains(&request.points) {
        return Err(OptimiseError::Points(request.points));
    }
    let mut search = Search::new(engine, request, beside)?;
    let ends = search.ends()?;
    // Where the least load comes with the least mass, there is one point.
    let steps = if ends[1] - ends[0] > 2.0 * SLACK * ends[0] { request.points - 1 } else { 0 };
    let mut points = Vec::new();
    for step in 0..=steps {
        let part = if steps == 0 { 1.0 } else { step as f64 / steps as f64 };
        let mass = ends[0] + (ends[1] - ends[0]) * part;
        let name = format!("Point {} of {} of the front", step + 1, steps + 1);
        points.push(search.best(mass.max(ends[0] * (1.0 + SLACK)), &name)?);
    }
    let mut compared = Vec::new();
    for factor in [(0, 1), (13, 20), (1, 1)].map(|(over, under)| BigRational::new(over.into(), under.into())) {
        let Some(uniform) = uniform(engine, &factor) else { continue };
        let design = measure(&uniform, &search.places, &request.orders)?;
        let mass = design.mass.to_f64().unwrap_or(f64::INFINITY);
        // The lightest one has room to be solved in, as among the points.
        let room = ends[0] * (1.0 + SLACK);
        let name = decimal(&factor);
        let best = match mass * (1.0 + SLACK) >= ends[0] {
            true => Some(search.best(mass.max(room), &format!("As heavy as with a balance factor of {name}"))?),
            false => None,
        };
        let lightest = match search.lightest(design.peak())? {
            Some(mass) => Some(search.best(mass.max(room), &format!("As calm as with a balance factor of {name}"))?),
            None => None,
        };
        compared.push(Uniform { factor, design, best, lightest });
    }
    Ok(Front { places: search.places, points, uniform: compared })
}
