//! What turns in the engine, beside its pistons: rods, pins, webs, counterweights, balancer shafts.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::factor::Factor;
use super::link;
use super::source::Source;
use crate::engine::{self, Balancer, Cylinder, Engine};
use crate::exact::{Term, Turn, fraction};
use crate::proof::Sense;

/// A mass that turns at a multiple of the crank speed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TurningMass {
    /// Which one it is.
    pub source: Source,
    /// The multiple.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Mass times radius U, in multiples of m r; below 0 where the coefficient that it is multiplied by changes its sign.
    pub mass_radius: BigRational,
    /// What it is multiplied by: 1, or a number of the motion that a balancer shaft is sized by.
    pub factor: Factor,
    /// Its direction at θ = 0.
    pub angle: Turn,
    /// Where it stands along the crankshaft.
    pub position: BigRational,
    /// Where the axis that it turns about is in the plane across the crankshaft, in crank radii: the sum of these; none in the
    /// middle, and where the file leaves it out ([`roll_lacks`](crate::order::roll_lacks)).
    pub axis: Vec<Term>,
    /// Which crankshaft it turns with, where it is on one of several.
    pub crank: Option<usize>,
}

impl TurningMass {
    /// Whether it is on the crankshaft, or on a shaft that turns as it does and whose weight is a plain number.
    pub fn turns_with_the_crank(&self) -> bool {
        (self.order, self.sense) == (1, Sense::Direct) && self.factor == Factor::One
    }

    /// What it adds to its vector: a mass-radius U at angle γ adds `2n²U e^{iγ}` (theory, section 3).
    pub fn weight(&self) -> BigRational {
        let order = u64::from(self.order);
        fraction::times(&BigRational::from_integer((2 * order * order).into()), &self.mass_radius)
    }
}

/// All masses of an engine that turn and weigh something.
pub fn turning_masses(engine: &Engine) -> Vec<TurningMass> {
    let crankshaft = engine.crankshaft();
    let cranks = engine.geared_cranks();
    let on_the_crank = |source, mass_radius, angle: &Turn, (position, crank): (&BigRational, usize)| TurningMass {
        source,
        order: cranks.get(crank).map_or(1, |crank| crank.speed),
        sense: cranks.get(crank).map_or(Sense::Direct, |crank| crank.sense),
        mass_radius,
        factor: Factor::One,
        angle: angle.clone(),
        position: position.clone(),
        axis: cranks.get(crank).map_or_else(Vec::new, |crank| crank.axis.clone()),
        crank: (crank < cranks.len()).then_some(crank),
    };
    let radius = engine.unit_radius();
    let with_rods = engine.cylinders().iter().enumerate().filter(|(_, at)| !at.rotating_mass.is_zero());
    let rods = with_rods.map(|(index, at)| {
        let size = fraction::times(&fraction::times(&at.rotating_mass, &radius), &at.crank_radius);
        on_the_crank(Source::BigEnd(index), size, &engine.pin_angle(at), (&at.position, at.crank))
    });
    let named = !crankshaft.pins.is_empty() || !crankshaft.webs.is_empty();
    let throws = if named { engine::throws(engine) } else { Vec::new() };
    let pins = throws.iter().zip(&crankshaft.pins).enumerate().map(|(index, (at, mass))| {
        let size = fraction::times(&fraction::times(mass, &radius), &at.crank_radius);
        on_the_crank(Source::Pin(index), size, &at.angle, (&at.position, at.crank))
    });
    let webs = throws.iter().zip(&crankshaft.webs).enumerate().map(|(index, (at, web))| {
        on_the_crank(Source::Webs(index), fraction::times(&web.mass, &web.radius), &at.angle, (&at.position, at.crank))
    });
    let weights = crankshaft.counterweights.iter().enumerate().map(|(index, weight)| {
        on_the_crank(
            Source::Counterweight(index),
            weight.mass_radius(),
            &weight.angle,
            (&weight.position, weight.crank),
        )
    });
    let shafts = crankshaft.balancers.iter().enumerate().flat_map(|(index, shaft)| {
        let axis: Vec<Term> = (shaft.axis.iter())
            .flat_map(|axis| [(&axis.height, Turn::zero()), (&axis.offset, Turn::fraction(1, 4))])
            .filter(|(distance, _)| !distance.is_zero())
            .map(|(distance, angle)| Term { angle, weight: distance / &radius })
            .collect();
        shaft_parts(engine, shaft).into_iter().map(move |(factor, part)| TurningMass {
            source: Source::Balancer(index),
            order: shaft.order,
            sense: shaft.sense,
            mass_radius: &shaft.mass_radius * part.weight,
            factor,
            angle: &shaft.angle + &shaft.sense.signed(part.angle),
            position: shaft.position.clone(),
            axis: axis.clone(),
            crank: None,
        })
    });
    let unit = engine.unit_mass() * &radius;
    let all = rods.chain(pins).chain(webs).chain(weights).chain(shafts);
    let weighing = all.filter(|mass| !mass.mass_radius.is_zero());
    let in_multiples =
        weighing.map(|mass| TurningMass { mass_radius: fraction::over(&mass.mass_radius, &unit), ..mass });
    in_multiples.chain(knuckles(engine)).collect()
}

/// What the masses at the knuckle pins add on the crankpins: (1 − κ e^{iγ}) of each.
fn knuckles(engine: &Engine) -> impl Iterator<Item = TurningMass> {
    let cylinders = engine.cylinders().iter().enumerate();
    let with_mass = cylinders.filter_map(|(index, cylinder)| Some((index, cylinder, link::knuckle(cylinder)?)));
    with_mass.flat_map(|(index, cylinder, (link, mass_radius))| {
        let part = |source, angle: Turn, mass_radius| TurningMass {
            source,
            order: 1,
            sense: Sense::Direct,
            mass_radius,
            factor: Factor::One,
            angle,
            position: cylinder.position.clone(),
            axis: Vec::new(),
            crank: None,
        };
        let taken_off = &mass_radius * &link.knuckle;
        let turned = (&cylinder.throw + &link.knuckle_angle()).opposite();
        [
            part(Source::KnuckleAtPin(index), cylinder.throw.clone(), mass_radius),
            part(Source::KnuckleOffPin(index), turned, taken_off),
        ]
    })
}

/// What the mass-radius of a balancer shaft is multiplied by, as the force of the piston that sizes it: 1 where none does.
pub fn shaft_parts(engine: &Engine, shaft: &Balancer) -> Vec<(Factor, Term)> {
    match shaft.coefficient_of.and_then(|index| engine.cylinders().get(index)) {
        Some(cylinder) => Factor::parts_of_force(engine, cylinder.mechanism.as_ref(), shaft.order),
        None => vec![(Factor::One, Term { angle: Turn::zero(), weight: BigRational::one() })],
    }
}

/// Mass times crank radius of a cylinder, in multiples of m r; 0 in an engine without reciprocating masses.
pub fn mass_radius(engine: &Engine, cylinder: &Cylinder) -> BigRational {
    match &engine.dimensions().mass {
        Some(mass) if mass.is_zero() => BigRational::zero(),
        _ => cylinder.weight(),
    }
}

/// Mass times crank radius of the rotating part of a cylinder's rod, in multiples of m r.
pub fn big_end(engine: &Engine, cylinder: &Cylinder) -> BigRational {
    &cylinder.rotating_mass / engine.unit_mass() * &cylinder.crank_radius
}

/// Of a mass that turns about an axis there.
pub(super) fn of_turning(mass: &TurningMass, axis: &Term) -> Term {
    let square = BigRational::from_integer((u64::from(mass.order) * u64::from(mass.order)).into());
    let ahead = &(&mass.angle - &axis.angle) - &Turn::fraction(1, 4);
    let angle = mass.sense.signed(ahead);
    Term { angle, weight: square * &mass.mass_radius * &axis.weight }
}
