//! What cancels what is left: counterweights on the crankshaft, balancer shafts?
//!
//! Every remedy is a set of weights whose mass-radii are exact sums in the field of the engine's own, so that the sums of
//! the corrected engine are formed anew and proved to vanish (theory, section 7). Engines without numbers are answered in
//! multiples of m r, and of c_k where the order has a coefficient.

mod built;
mod comparable_engine;
mod corrected;
mod counterweights;
mod cures;
mod error;
mod file;
mod height;
mod partial;
mod parts;
mod planes;
mod rounded;
mod shafts;
mod tables;
mod weight;

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

pub use comparable_engine::ComparableEngine;
pub use corrected::{Corrected, corrected};
pub use counterweights::{bay_by_bay, one_plane, two_planes};
pub use cures::{Cure, cures};
pub use error::RemedyError;
pub use file::{CorrectedFile, FileError, corrected_file};
pub use height::{PairHeight, PairRoll, pair_height};
pub use partial::{Ellipse, Partial};
pub use parts::{counterweight_parts, mass_step, power_of_ten_below};
pub use planes::{Built, Replaced, factor_of, plane_of};
use planes::{ends, usual_planes};
pub use shafts::{Kind, LEAST, Shaft, shaft, shafts, without_slight};
pub use weight::Weight;

use crate::engine::{Engine, GearedCrank, throws};
use crate::exact::Turn;
use crate::file::shown_position;
use crate::proof::Sense;

/// Orders that are too small for weights of their own, unless these are asked for.
#[derive(Clone, Debug, Default)]
pub struct SmallOrders {
    /// They are below this part of the largest order.
    pub below: f64,
    /// The orders, rising.
    pub orders: Vec<u32>,
}

/// What is asked of a remedy.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The orders that are to vanish, rising.
    pub orders: Vec<u32>,
    /// Those that the remedy names and does not cancel.
    pub small: SmallOrders,
    /// Planes of counterweights and couples; the outermost throws by default.
    pub planes: Option<[BigRational; 2]>,
    /// Balance factors of the throws for counterweights bay by bay, one for all or one per throw; none for a correction in
    /// two planes alone.
    pub factors: Vec<BigRational>,
    /// How far the counterweights of each bay are turned on from opposite to their throw; 0 by default.
    pub skews: Vec<Turn>,
    /// The radius in metres at which masses are told; none tells masses times radii alone.
    pub radius: Option<BigRational>,
    /// Speeds in revolutions a minute over which the shafts of a pair are to stand best.
    pub speeds: Vec<BigRational>,
}

/// Weights that balance an engine up to the orders asked for.
#[derive(Clone, Debug)]
pub struct Remedy {
    /// The engine.
    pub subject: ComparableEngine,
    /// The orders that were asked for.
    pub orders: Vec<u32>,
    /// Those that are named only.
    pub small: SmallOrders,
    /// Counterweights bay by bay, where balance factors are given.
    pub bays: Vec<Weight>,
    /// Counterweights on the crankshaft that cancel what is left of the direct first order.
    pub crankshaft: Option<Shaft>,
    /// Balancer shafts for all the rest.
    pub shafts: Vec<Shaft>,
    /// What would cancel less than [`LEAST`] of the load, all of an order together, and is omitted; these orders and senses keep what
    /// they have.
    pub left_out: Vec<Shaft>,
    /// The radius in metres at which masses are told.
    pub radius: Option<BigRational>,
    /// Speeds in revolutions a minute over which the shafts of a pair are to stand best.
    pub speeds: Vec<BigRational>,
    /// Heights at which the Lanchester pairs cancel the roll moment of their order too.
    pub heights: Vec<PairHeight>,
    /// What is in each plane in which the remedy has weights, each plane once.
    pub built: Vec<Built>,
    /// The sums of the corrected engine.
    pub corrected: Vec<Corrected>,
}

impl Remedy {
    /// All weights of the remedy: what is added to the engine, where it has weights itself the difference to what they become
    /// ([`Remedy::built`]).
    pub fn weights(&self) -> Vec<Weight> {
        let shafts = self.crankshaft.iter().chain(&self.shafts).flat_map(|shaft| &shaft.weights);
        self.bays.iter().chain(shafts).cloned().collect()
    }

    /// The crankshaft's mass in kilograms, as [`Engine::crankshaft_mass`] counts it, with the counterweights of the remedy at
    /// their radii; `None` where the layout gives no numbers.
    pub fn crankshaft_mass(&self) -> Option<f64> {
        let engine = self.subject.engine();
        let there = &engine.crankshaft().counterweights;
        let on_the_crank = self.built.iter().filter(|plane| plane.becomes.is_on_the_crank());
        let more = on_the_crank.map(|plane| {
            let before = plane.replaced.counterweights.iter().map(|index| there[*index].mass.to_f64());
            let becomes = plane.becomes.mass_radius(&self.subject)? / self.radius_in(plane).to_f64()?;
            Some(becomes - before.sum::<Option<f64>>()?)
        });
        Some(engine.crankshaft_mass()?.to_f64()? + more.sum::<Option<f64>>()?)
    }

    /// The crankshaft that turns as a shaft does, whose counterweights can take its place; none but in engines of several.
    pub fn crank_of(&self, shaft: &Shaft) -> Option<&GearedCrank> {
        self.subject.engine().crank_turning(shaft.order, shaft.sense)
    }

    /// The radius in metres at which counterweights in a plane are: what is resized keeps its own, others are at the one that is asked for, or
    /// at the crank radius.
    pub fn radius_in(&self, plane: &Built) -> BigRational {
        let engine = self.subject.engine();
        let own = plane.replaced.counterweights.first().map(|index| &engine.crankshaft().counterweights[*index].radius);
        let radius = own.or(self.radius.as_ref()).filter(|radius| !radius.is_zero());
        radius.cloned().unwrap_or_else(|| engine.unit_radius())
    }

    /// The mass in kilograms of a weight at the radius that is asked for; none where none is.
    pub fn mass(&self, weight: &Weight) -> Option<f64> {
        Some(weight.mass_radius(&self.subject)? / self.radius.as_ref()?.to_f64()?)
    }

    /// The mass times radius in kilogram-metres of all weights of a cure of a force; none of a couple, whose weights depend on their distance, and
    /// where masses or the crank radius are not given.
    pub fn cure_mass_radius(&self, cure: &Cure) -> Option<f64> {
        let [unit, _] = self.subject.scale()?;
        (cure.kind == Kind::Force).then_some(cure.mass_radius * unit.to_f64()?)
    }

    /// Their mass in kilograms at the radius that is asked for; none where none is.
    pub fn cure_mass(&self, cure: &Cure) -> Option<f64> {
        Some(self.cure_mass_radius(cure)? / self.radius.as_ref()?.to_f64()?)
    }

    /// Whether every sum of the corrected engine is proved to be zero, but for those that are omitted.
    pub fn holds(&self) -> bool {
        self.corrected.iter().all(|sum| sum.vanishes() || self.leaves_out(sum.order, sum.sense))
    }

    /// Whether what is left of an order and sense is too little for a weight.
    pub fn leaves_out(&self, order: u32, sense: Sense) -> bool {
        self.left_out.iter().any(|shaft| (shaft.order, shaft.sense) == (order, sense))
    }
}

/// Finds the weights that make every vector of the orders asked for vanish, and proves it on the corrected engine.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::remedy::{Request, remedy};
/// let i3 = crankstar::file::find("I3").unwrap().engine().unwrap();
/// let remedy = remedy(&i3, &Request { orders: vec![1, 2], ..Request::default() }).unwrap();
/// assert!(remedy.holds());
/// // Two counterweights in the planes of the outer throws, and three shafts with a couple each.
/// assert_eq!(remedy.crankshaft.as_ref().unwrap().weights[0].modulus().unwrap().to_string(), "√3/4");
/// assert_eq!(remedy.shafts.len(), 3);
/// ```
///
/// # Errors
/// What is missing, or does not fit.
pub fn remedy(engine: &Engine, request: &Request) -> Result<Remedy, RemedyError> {
    let subject = ComparableEngine::new(engine).map_err(RemedyError::Missing)?;
    if request.radius.is_some() && subject.scale().is_none() {
        return Err(RemedyError::NoMass);
    }
    let count = throws(engine).len();
    for (what, given) in [("balance factors", request.factors.len()), ("skew angles", request.skews.len())] {
        if given > 1 && given != count {
            return Err(RemedyError::TooMany { what, given, throws: count });
        }
    }
    let turns_as_the_first = |crank: &GearedCrank| (crank.speed, crank.sense) == (1, Sense::Direct);
    if !request.factors.is_empty() && !engine.geared_cranks().iter().all(turns_as_the_first) {
        return Err(RemedyError::Bays);
    }
    let shown = |at: &BigRational| shown_position(at, engine.length_unit());
    let planes = match &request.planes {
        Some([first, second]) if first == second => return Err(RemedyError::PlanesCoincide(shown(first))),
        Some(planes) => {
            if let Some(ends) = engine.shaft_ends()
                && let Some(beyond) = planes.iter().find(|plane| **plane < ends[0] || **plane > ends[1])
            {
                return Err(RemedyError::BeyondTheShaft(shown(beyond), Box::new([&ends[0], &ends[1]].map(shown))));
            }
            planes.clone()
        }
        None => usual_planes(engine),
    };
    let bays = match request.factors.is_empty() {
        true => Vec::new(),
        false => planes::in_place_of_what_is_there(&subject, bay_by_bay(&subject, &request.factors, &request.skews))?,
    };
    let crankshaft =
        request.orders.contains(&1).then(|| on_the_crankshaft(&subject, &bays, &planes, request.planes.is_some()));
    let crankshaft = crankshaft.flatten();
    let shafts = shafts(&subject, &request.orders, &planes, request.planes.is_some());
    let [needed, left_out] = without_slight(&subject, crankshaft.into_iter().chain(shafts).collect());
    let (on_the_crank, shafts): (Vec<Shaft>, Vec<Shaft>) =
        needed.into_iter().partition(|shaft| (shaft.order, shaft.sense) == (1, Sense::Direct));
    let crankshaft = on_the_crank.into_iter().next();
    let pairs = shafts.iter().filter(|shaft| shaft.lanchester && shaft.sense == Sense::Direct);
    let heights = pairs.filter_map(|shaft| pair_height(engine, shaft.order)).collect();
    let mut remedy = Remedy {
        subject,
        orders: request.orders.clone(),
        small: request.small.clone(),
        bays,
        crankshaft,
        shafts,
        left_out,
        radius: request.radius.clone(),
        speeds: request.speeds.clone(),
        heights,
        built: Vec::new(),
        corrected: Vec::new(),
    };
    remedy.built = planes::built(&remedy.subject, remedy.weights());
    remedy.corrected = corrected(&remedy.subject, &remedy.orders, &remedy.weights());
    Ok(remedy)
}

/// What cancels the direct first order that the bays leave: one weight where one does, unless planes were named.
fn on_the_crankshaft(
    subject: &ComparableEngine,
    bays: &[Weight],
    planes: &[BigRational; 2],
    planes_named: bool,
) -> Option<Shaft> {
    let (mut force, mut moment) = (subject.force(1, Sense::Direct), subject.moment(1, Sense::Direct));
    for weight in bays {
        force = force.plus(&weight.adds());
        moment = moment.plus(&weight.adds().scaled(&weight.position));
    }
    let found = shaft(1, Sense::Direct, &force, &moment, planes, &ends(subject.engine()))?;
    let in_planes = |planes: &[BigRational; 2]| two_planes(1, Sense::Direct, &force, &moment, planes);
    let there = if bays.is_empty() { planes::planes(subject, 1, Sense::Direct) } else { Vec::new() };
    let weights = match shafts::resizing(&found, &there, planes) {
        _ if planes_named => in_planes(planes),
        Some(own) => in_planes(&own),
        None => found.weights,
    };
    Some(Shaft { weights, ..found })
}
