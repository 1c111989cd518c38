//! Which masses add to which rotating vector, and by which coefficient of the motion?
//!
//! Order k of force and moment is `½ω²(P_k⁺ e^{ikθ} + P_k⁻ e^{−ikθ})` (theory, section 3). The terms of a sum that have
//! the same coefficient c_k are one exact phasor sum; sums of different coefficients are kept apart.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::exact::{PhasorSum, Term, Turn};
use crate::layout::{self, Balancer, Cylinder, Layout, Rod};
use crate::phasor;
use crate::proof::{Quantity, Sense};

/// What in the engine a force comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// Pistons, pins, and the reciprocating part of the rods.
    Reciprocating,
    /// Rotating parts of the rods, which turn with the crankpins.
    Rotating,
    /// Pins and webs of the crankshaft.
    Crankshaft,
    /// Counterweights.
    Counterweights,
    /// Balancer shafts.
    Balancers,
}

impl Effect {
    /// All effects of masses.
    pub const ALL: [Effect; 5] =
        [Effect::Reciprocating, Effect::Rotating, Effect::Crankshaft, Effect::Counterweights, Effect::Balancers];
}

/// The coefficient of a sum: none is 1; else c_k of this rod, whose offset is not negative above order 1.
pub type Factor = Option<Rod>;

/// Sums that share a factor, by factor: the vector is `Σ factor · sum`, in multiples of m r.
pub type Parts = BTreeMap<Factor, PhasorSum>;

/// How much of a force at a position counts: all of it for the force, its arm for the moment, a bearing's part of it.
pub type Weighing<'a> = &'a dyn Fn(&BigRational) -> BigRational;

/// The sums of one order and sense that an effect adds, each force weighed by its position.
pub(super) fn parts(layout: &Layout, effect: Effect, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    match effect {
        Effect::Reciprocating => reciprocating(layout, weighing, order, sense),
        _ => turning(layout, effect, weighing, order, sense),
    }
}

fn reciprocating(layout: &Layout, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    let mut parts: BTreeMap<Factor, Vec<Term>> = BTreeMap::new();
    for (cylinder, rod) in layout.cylinders.iter().zip(&layout.mechanism.rods) {
        let Some((factor, sign)) = factor(rod, order) else { continue };
        let weight = mass_radius(layout, cylinder) * weighing(&cylinder.position) * sign;
        parts.entry(factor).or_default().push(Term { angle: phasor::phase(cylinder, order, Some(sense)), weight });
    }
    parts.into_iter().map(|(factor, terms)| (factor, PhasorSum::new(terms))).collect()
}

/// The coefficient of a rod with the sign that its offset gives it; none where it is zero.
///
/// The root `√(1−(λ sinψ−δ)²)` stays as it is where δ changes its sign and ψ goes on by half a turn, so that its
/// coefficient of order k then changes by (−1)^k; c_1 has the crank's own 1 beside it.
pub(super) fn factor(rod: &Rod, order: u32) -> Option<(Factor, BigRational)> {
    let one = BigRational::from_integer(1.into());
    let centric = rod.offset.is_zero();
    match order {
        1 if centric => Some((None, one)),
        1 => Some((Some(rod.clone()), one)),
        _ if !rod.has_order(Quantity::Force, order) => None,
        _ => {
            let flips = rod.offset.is_negative() && order % 2 == 1;
            let rod = Rod { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
            Some((Some(rod), if flips { -one } else { one }))
        }
    }
}

/// Masses that turn, in terms of weight `2n²U`, n the speed ratio (theory, section 3).
fn turning(layout: &Layout, effect: Effect, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    let unit = unit_mass(layout) * unit_radius(layout);
    let of_order = turning_masses(layout, effect).into_iter().filter(|mass| (mass.order, mass.sense) == (order, sense));
    let terms: Vec<Term> = of_order
        .map(|mass| Term { weight: mass.amount() / &unit * weighing(&mass.position), angle: mass.angle })
        .collect();
    if terms.is_empty() { Parts::new() } else { Parts::from([(None, PhasorSum::new(terms))]) }
}

/// A mass that turns at a multiple of the crank speed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TurningMass {
    /// The multiple.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Mass times radius: in kilogram-metres, with 1 for a mass m or a crank radius r that the layout does not name.
    pub mass_radius: BigRational,
    /// Its direction at θ = 0.
    pub angle: Turn,
    /// Where it stands along the crankshaft.
    pub position: BigRational,
}

impl TurningMass {
    /// Whether it stands on the crankshaft, or on a shaft that turns as it does.
    pub fn turns_with_the_crank(&self) -> bool {
        (self.order, self.sense) == (1, Sense::Direct)
    }

    /// What it adds to its vector: a mass-radius U at angle γ adds `2n²U e^{iγ}`.
    fn amount(&self) -> BigRational {
        let order = BigRational::from_integer(self.order.into());
        &order * &order * &self.mass_radius * BigRational::from_integer(2.into())
    }
}

/// All masses of an engine that turn and weigh something, their mass-radii in multiples of m r.
pub fn all_turning_masses(layout: &Layout) -> Vec<TurningMass> {
    let unit = unit_mass(layout) * unit_radius(layout);
    let of_effect = |effect| turning_masses(layout, effect);
    let all = [Effect::Rotating, Effect::Crankshaft, Effect::Counterweights, Effect::Balancers].into_iter();
    let weighing = all.flat_map(of_effect).filter(|mass| !mass.mass_radius.is_zero());
    weighing.map(|mass| TurningMass { mass_radius: &mass.mass_radius / &unit, ..mass }).collect()
}

/// The masses of an effect that turn.
fn turning_masses(layout: &Layout, effect: Effect) -> Vec<TurningMass> {
    let on_the_crank = |mass_radius: BigRational, angle: &Turn, position: &BigRational| TurningMass {
        order: 1,
        sense: Sense::Direct,
        mass_radius,
        angle: angle.clone(),
        position: position.clone(),
    };
    let (mechanism, crankshaft) = (&layout.mechanism, &layout.crankshaft);
    let radius = unit_radius(layout);
    match effect {
        Effect::Reciprocating => Vec::new(),
        Effect::Rotating => {
            let rods = layout.cylinders.iter().zip(&mechanism.rotating_masses);
            let rods = rods.map(|(at, mass)| on_the_crank(mass * &radius * &at.crank_radius, &at.throw, &at.position));
            rods.collect()
        }
        Effect::Crankshaft if crankshaft.pins.is_empty() && crankshaft.webs.is_empty() => Vec::new(),
        Effect::Crankshaft => {
            let throws = layout::throws(layout);
            let pins = throws.iter().zip(&crankshaft.pins);
            let pins = pins.map(|(at, mass)| on_the_crank(mass * &radius * &at.crank_radius, &at.angle, &at.position));
            let webs = throws.iter().zip(&crankshaft.webs);
            let webs = webs.map(|(at, web)| on_the_crank(&web.mass * &web.radius, &at.angle, &at.position));
            pins.chain(webs).collect()
        }
        Effect::Counterweights => {
            let weights = crankshaft.counterweights.iter();
            weights.map(|weight| on_the_crank(weight.mass_radius(), &weight.angle, &weight.position)).collect()
        }
        Effect::Balancers => {
            let shaft = |shaft: &Balancer| TurningMass {
                order: shaft.order,
                sense: shaft.sense,
                mass_radius: shaft.mass_radius.clone(),
                angle: shaft.angle.clone(),
                position: shaft.position.clone(),
            };
            crankshaft.balancers.iter().map(shaft).collect()
        }
    }
}

/// The effects that a layout file calls for.
pub(super) fn effects_of(layout: &Layout) -> Vec<Effect> {
    let turning = [Effect::Rotating, Effect::Crankshaft, Effect::Counterweights, Effect::Balancers];
    let weighs = |effect: &Effect| turning_masses(layout, *effect).iter().any(|mass| !mass.mass_radius.is_zero());
    [Effect::Reciprocating].into_iter().chain(turning.into_iter().filter(weighs)).collect()
}

/// The largest force of the shafts that turn faster than this order, and its moment about the reference plane, in
/// multiples of m r ω²: what they add where higher orders are left out.
pub(super) fn faster_shafts(layout: &Layout, highest: u32) -> [BigRational; 2] {
    let unit = unit_mass(layout) * unit_radius(layout) * BigRational::from_integer(2.into());
    let shafts = turning_masses(layout, Effect::Balancers).into_iter().filter(|shaft| shaft.order > highest);
    shafts.fold([BigRational::zero(), BigRational::zero()], |[force, moment], shaft| {
        let size = shaft.amount() / &unit;
        let arm = (&shaft.position - &layout.reference_plane).abs();
        [force + &size, moment + size * arm]
    })
}

/// The sums of the inertia torque of one order, by rod: `Σ m r² e^{ik(β−α)}`, in multiples of m r².
pub(super) fn torque_parts(layout: &Layout, order: u32) -> BTreeMap<Rod, PhasorSum> {
    let mut parts: BTreeMap<Rod, Vec<Term>> = BTreeMap::new();
    for (cylinder, rod) in layout.cylinders.iter().zip(&layout.mechanism.rods) {
        let weight = mass_radius(layout, cylinder) * &cylinder.crank_radius;
        parts.entry(rod.clone()).or_default().push(Term { angle: phasor::phase(cylinder, order, None), weight });
    }
    parts.into_iter().map(|(rod, terms)| (rod, PhasorSum::new(terms))).collect()
}

/// Mass times crank radius of a cylinder, in multiples of m r; 0 in an engine without reciprocating masses.
pub fn mass_radius(layout: &Layout, cylinder: &Cylinder) -> BigRational {
    match &layout.mechanism.mass {
        Some(mass) if mass.is_zero() => BigRational::zero(),
        _ => cylinder.weight(),
    }
}

/// The mass in kilograms that the sums are multiples of: m, or one kilogram where m is 0 or not known.
pub fn unit_mass(layout: &Layout) -> BigRational {
    let mass = layout.mechanism.mass.clone().filter(|mass| !mass.is_zero());
    mass.unwrap_or_else(|| BigRational::from_integer(1.into()))
}

/// The crank radius in metres, or 1 where it is not known: then only masses at the crankpins are, which it cancels from.
fn unit_radius(layout: &Layout) -> BigRational {
    layout.mechanism.crank_radius.clone().unwrap_or_else(|| BigRational::from_integer(1.into()))
}
