//! How large are the forces, moments and torques of an engine, in newtons?
//!
//! The exact sums of a layout times the coefficients of its motion. Only what the layout file asks for is computed.

mod always;
mod bearing;
mod contribution;
mod needed;
mod roll;
mod shares;
mod spectrum;
mod swing;
mod tails;
mod vector;
mod waveform;

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt;

use num_rational::BigRational;
use num_traits::ToPrimitive;

pub use always::vanishes_at_every_order;
pub use bearing::{BearingLoad, BearingLoads, BearingOrder, Method, bearing_loads};
pub use contribution::{Effect, Factor, Parts, TurningMass, Weighing, all_turning_masses, mass_radius, unit_mass};
use needed::usual_torque_orders;
pub use needed::{Bound, LeftOut, Needed, left_out, needed_orders, usual_orders};
pub use spectrum::Spectrum;
pub use swing::Swing;
pub use tails::Tails;
pub use vector::{Outcome, Vector};
pub use waveform::{Circle, Harmonic, Peak, Waveform};

use crate::beam::Mistake;
use crate::layout::{self, Layout, LengthUnit, Rod};
use crate::motion::{Coefficient, Enclosure, SliderCrank};
use crate::proof::{Quantity, Sense};

/// Forces, moments and torque of an engine, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct Loads {
    /// The orders, rising, each with what is left of it.
    pub orders: Vec<OrderLoads>,
    /// The effects that are in the scene.
    pub effects: Vec<EffectLoads>,
    /// The force of all orders, in multiples of m r ω².
    pub force: Waveform,
    /// The moment of all orders about the reference plane, in multiples of m r ω² times the unit of the positions.
    pub moment: Waveform,
    /// The inertia torque, where the file asks for it.
    pub torque: Option<Torque>,
    /// What the main bearings feel, as a continuous beam and by the determinate approximation; none where the file gives
    /// no bearings.
    pub bearings: Option<[BearingLoads; 2]>,
    /// The roll moment on the frame, −torque and the balancer shafts, where the engine has any and the file asks for the
    /// torque.
    pub roll: Option<Torque>,
    /// What turns multiples into newtons; none where mass, crank radius or speed is missing.
    pub scale: Option<Scale>,
    /// How many values of the motion's coefficients were computed: the cost of the scene.
    pub coefficients: usize,
}

/// One order of force and moment, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct OrderLoads {
    /// The order k.
    pub order: u32,
    /// Coefficient c_k; none where the rods differ, where it is zero, or where nothing is left of the order that calls for it.
    pub coefficient: Option<Coefficient>,
    /// The shaking force.
    pub force: Swing,
    /// Its moment about the reference plane.
    pub moment: Swing,
}

/// What one effect adds.
#[derive(Clone, Debug)]
pub struct EffectLoads {
    /// The effect.
    pub effect: Effect,
    /// Its force, in multiples of m r ω².
    pub force: Waveform,
    /// Its moment.
    pub moment: Waveform,
}

/// The inertia torque, in multiples of m r² ω²: the real part of its waveform.
#[derive(Clone, Debug)]
pub struct Torque {
    /// Its orders.
    pub orders: Vec<TorqueOrder>,
    /// All of them together.
    pub waveform: Waveform,
}

/// One order of the inertia torque: `Re(vector · e^{ikθ})`.
#[derive(Clone, Debug)]
pub struct TorqueOrder {
    /// The order k.
    pub order: u32,
    /// The coefficient of the motion; none where the rods differ.
    pub coefficient: Option<Coefficient>,
    /// Coefficient times sum.
    pub vector: Vector,
}

/// What the multiples are multiples of.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// Mass m in kilograms.
    pub mass: BigRational,
    /// Crank radius r in metres.
    pub crank_radius: BigRational,
    /// Speed in revolutions a minute.
    pub speed: BigRational,
}

impl Scale {
    /// Angular speed ω in radians a second.
    pub fn omega(&self) -> f64 {
        self.speed.to_f64().unwrap_or(f64::INFINITY) / 60.0 * TAU
    }

    /// m r ω² in newtons.
    pub fn force(&self) -> f64 {
        (&self.mass * &self.crank_radius).to_f64().unwrap_or(f64::INFINITY) * self.omega() * self.omega()
    }

    /// m r² ω² in newton-metres.
    pub fn torque(&self) -> f64 {
        self.force() * self.crank_radius.to_f64().unwrap_or(f64::INFINITY)
    }
}

/// What the moments of a layout are counted in, besides the force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arm {
    /// Metres.
    Metre,
    /// The spacing a of the cylinders, which the file does not say.
    Spacing,
}

impl Arm {
    /// The unit of the positions of a layout: a file that gives them without a unit gives metres.
    pub fn of(layout: &Layout) -> Self {
        let known = layout.positions_given || layout.length_unit == LengthUnit::Metre;
        if known { Arm::Metre } else { Arm::Spacing }
    }
}

/// Why a layout has no numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// No rod: without λ no coefficient is known.
    Rods,
    /// The rotating masses cannot be compared with reciprocating ones that are not given.
    Masses,
    /// The radii of webs, counterweights or balancer shafts cannot be compared with a crank radius that is not given.
    CrankRadius,
    /// Forces that no decimal can hold.
    TooLarge,
    /// Methods are compared for what moves with the crank alone.
    BalancerShafts,
    /// A crank that cannot turn round.
    Motion(String),
    /// A number that is no order.
    Order(u32),
    /// A list of the mechanism that has not one value a cylinder.
    Lists {
        /// What the list holds.
        of: &'static str,
        /// How many.
        values: usize,
        /// For so many cylinders.
        cylinders: usize,
    },
    /// No main bearings.
    Bearings,
    /// Main bearings that hold no shaft.
    Beam(Mistake),
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Missing::Rods => f.write_str(
                "the layout says nothing of its rods; below [mechanism], give rod_ratio, or rod_length with stroke or crank_radius",
            ),
            Missing::Masses => f.write_str(
                "the layout gives rotating masses, on rods, crankshaft or balancer shafts, but no reciprocating ones; below [mechanism], give reciprocating_mass or piston_mass",
            ),
            Missing::CrankRadius => f.write_str(
                "the layout gives webs, counterweights or balancer shafts but no crank; below [mechanism], give stroke or crank_radius",
            ),
            Missing::TooLarge => {
                f.write_str("m r ω² and m r² ω² have to be below 10^150: mass, crank radius or speed of the layout is too large for decimals")
            }
            Missing::BalancerShafts => {
                f.write_str("the methods are compared for engines without balancer shafts; leave out [[balancer]]")
            }
            Missing::Motion(reason) => f.write_str(reason),
            Missing::Order(number) => {
                write!(f, "{number} is no order; an order is a whole number from 1 to {}", layout::ORDERS.end())
            }
            Missing::Lists { of, values, cylinders } => {
                write!(f, "the layout has {values} {of} for {cylinders} cylinders; give one to each")
            }
            Missing::Bearings => f.write_str(
                "the layout says nothing of its main bearings; above the first table, give their positions: bearings = [0.15, 0.05, -0.05, -0.15]",
            ),
            Missing::Beam(mistake) => mistake.fmt(f),
        }
    }
}

impl std::error::Error for Missing {}

/// Computes the loads of an engine at these orders, and the torque at those that it needs besides.
///
/// # Errors
/// What the layout lacks.
pub fn loads(layout: &Layout, orders: &[u32]) -> Result<Loads, Missing> {
    let torque = if layout.effects.torque { usual_torque_orders(layout, orders)? } else { Vec::new() };
    loads_at(layout, orders, &torque)
}

/// Computes the loads of an engine at these orders, and the torque, where the file asks for it, at orders of its own.
///
/// # Errors
/// What the layout lacks, and orders that are none.
pub fn loads_at(layout: &Layout, orders: &[u32], torque_orders: &[u32]) -> Result<Loads, Missing> {
    are_orders(orders)?;
    are_orders(torque_orders)?;
    let motion = Motion::new(layout)?;
    let scene = contribution::effects_of(layout);
    let total: Vec<OrderLoads> = orders.iter().map(|&order| OrderLoads::new(layout, &motion, &scene, order)).collect();
    let waveform =
        |swing: fn(&OrderLoads) -> &Swing| Waveform::new(total.iter().map(|loads| harmonic(loads.order, swing(loads))));
    let (force, moment) = (waveform(|loads| &loads.force), waveform(|loads| &loads.moment));
    let effects = match scene.as_slice() {
        &[effect] => vec![EffectLoads { effect, force: force.clone(), moment: moment.clone() }],
        several => several.iter().map(|&effect| EffectLoads::new(layout, &motion, effect, orders)).collect(),
    };
    let solve = |method| bearing_loads(layout, orders, method);
    let bearings = match layout.bearings.is_empty() {
        true => None,
        false => Some([solve(Method::Continuous)?, solve(Method::Determinate)?]),
    };
    let torque = layout.effects.torque.then(|| torque(layout, &motion, torque_orders));
    let has_shafts = !layout.crankshaft.balancers.is_empty();
    let roll = (layout.effects.torque && has_shafts).then(|| roll::roll(layout, &motion, torque_orders));
    Ok(Loads {
        effects,
        force,
        moment,
        torque,
        bearings,
        roll,
        scale: scale(layout),
        orders: total,
        coefficients: motion.computed.get(),
    })
}

/// Whether every number of a list is an order.
///
/// # Errors
/// The first that is none.
pub fn are_orders(orders: &[u32]) -> Result<(), Missing> {
    match orders.iter().find(|order| !layout::ORDERS.contains(order)) {
        None => Ok(()),
        Some(&other) => Err(Missing::Order(other)),
    }
}

/// The two vectors of an order of these effects, each force weighed by its position.
fn swing(layout: &Layout, motion: &Motion, effects: &[Effect], weighing: Weighing, order: u32) -> Swing {
    let [direct, reverse] =
        [Sense::Direct, Sense::Reverse].map(|sense| sums_of(layout, effects, weighing, order, sense));
    let vectors = [motion.vector(&direct, order, Sense::Direct), motion.vector(&reverse, order, Sense::Reverse)];
    Swing::new(vectors, [&direct, &reverse])
}

/// Force and moment of an order.
fn swings(layout: &Layout, motion: &Motion, effects: &[Effect], order: u32) -> [Swing; 2] {
    let whole = |_: &BigRational| BigRational::from_integer(1.into());
    let arm = |position: &BigRational| position - &layout.reference_plane;
    let weighings: [Weighing; 2] = [&whole, &arm];
    weighings.map(|weighing| swing(layout, motion, effects, weighing, order))
}

impl OrderLoads {
    fn new(layout: &Layout, motion: &Motion, scene: &[Effect], order: u32) -> Self {
        let [force, moment] = swings(layout, motion, scene, order);
        OrderLoads { order, coefficient: motion.common(order), force, moment }
    }

    /// Whether there is nothing to judge: no piston has the order, and no shaft turns so.
    pub fn exists(&self, layout: &Layout) -> bool {
        layout.mechanism.has_order(Quantity::Force, self.order)
            || layout.crankshaft.balancers.iter().any(|shaft| shaft.order == self.order)
    }
}

impl EffectLoads {
    fn new(layout: &Layout, motion: &Motion, effect: Effect, orders: &[u32]) -> Self {
        let by_order: Vec<(u32, [Swing; 2])> =
            orders.iter().map(|&order| (order, swings(layout, motion, &[effect], order))).collect();
        let waveform =
            |place: usize| Waveform::new(by_order.iter().map(|(order, swings)| harmonic(*order, &swings[place])));
        EffectLoads { effect, force: waveform(0), moment: waveform(1) }
    }
}

/// Whether the masses that turn can be compared with the reciprocating ones.
///
/// # Errors
/// What the layout lacks for that, and lists without one value a cylinder.
pub fn comparable(layout: &Layout) -> Result<(), Missing> {
    let cylinders = layout.cylinders.len();
    for (of, values) in
        [("rods", layout.mechanism.rods.len()), ("rotating masses", layout.mechanism.rotating_masses.len())]
    {
        if values != 0 && values != cylinders {
            return Err(Missing::Lists { of, values, cylinders });
        }
    }
    let (mechanism, crankshaft) = (&layout.mechanism, &layout.crankshaft);
    let in_metres =
        !crankshaft.webs.is_empty() || !crankshaft.counterweights.is_empty() || !crankshaft.balancers.is_empty();
    let turns = in_metres || !mechanism.rotating_masses.is_empty() || !crankshaft.pins.is_empty();
    match (mechanism.mass.is_none() && turns, mechanism.crank_radius.is_none() && in_metres) {
        (true, _) => Err(Missing::Masses),
        (_, true) => Err(Missing::CrankRadius),
        _ => Ok(()),
    }
}

/// The exact sums of one order and sense, of all effects that the layout calls for, each force weighed by its position:
/// by coefficient, in multiples of m r. They stand for an engine that is [`comparable`] and whose rods are known.
pub fn sums(layout: &Layout, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    sums_of(layout, &contribution::effects_of(layout), weighing, order, sense)
}

/// The same of these effects alone.
pub fn sums_of(layout: &Layout, effects: &[Effect], weighing: Weighing, order: u32, sense: Sense) -> Parts {
    let of_effect = |effect: &Effect| contribution::parts(layout, *effect, weighing, order, sense);
    merged(&effects.iter().map(of_effect).collect::<Vec<_>>())
}

/// What turns the multiples of a layout into newtons; none where mass, crank radius or speed is missing.
pub fn scale(layout: &Layout) -> Option<Scale> {
    let mechanism = &layout.mechanism;
    Some(Scale {
        mass: mechanism.mass.as_ref().map(|_| contribution::unit_mass(layout))?,
        crank_radius: mechanism.crank_radius.clone()?,
        speed: mechanism.speed.clone()?,
    })
}

fn harmonic(order: u32, swing: &Swing) -> Harmonic {
    let [direct, reverse] = swing.amplitudes();
    Harmonic { order, direct, reverse }
}

/// The sums of all effects, by factor.
fn merged<'a>(effects: impl IntoIterator<Item = &'a Parts>) -> Parts {
    let mut merged = Parts::new();
    for (factor, sum) in effects.into_iter().flatten() {
        merged.entry(factor.clone()).and_modify(|all| *all = all.plus(sum)).or_insert_with(|| sum.clone());
    }
    merged
}

fn torque(layout: &Layout, motion: &Motion, orders: &[u32]) -> Torque {
    let orders: Vec<TorqueOrder> = orders.iter().map(|&order| TorqueOrder::new(layout, motion, order)).collect();
    Torque { waveform: Waveform::new(orders.iter().map(TorqueOrder::harmonic)), orders }
}

impl TorqueOrder {
    fn new(layout: &Layout, motion: &Motion, order: u32) -> Self {
        let mut parts = contribution::torque_parts(layout, order);
        parts.retain(|rod, _| rod.has_order(Quantity::Torque, order));
        let left: Vec<_> = parts.iter().filter(|(_, sum)| !sum.vanishes()).collect();
        let pairs: Vec<_> = left.iter().map(|(rod, sum)| (motion.torque(rod, order), *sum)).collect();
        let coefficient = match (parts.len(), pairs.as_slice()) {
            (1, [(coefficient, _)]) => Some(coefficient.clone()),
            _ => None,
        };
        // No coefficient of an order that exists is zero.
        TorqueOrder { order, coefficient, vector: Vector::of(&pairs, true) }
    }
}

/// Forces from here on are refused: their sums and squares would leave the range of decimals.
const LARGEST: f64 = 1e150;

/// The motions of the cylinders, and the coefficients that were asked of them.
struct Motion {
    cranks: BTreeMap<Rod, SliderCrank>,
    known: RefCell<BTreeMap<(Rod, u32), Coefficient>>,
    computed: Cell<usize>,
}

impl Motion {
    fn new(layout: &Layout) -> Result<Self, Missing> {
        if scale(layout).is_some_and(|scale| !(scale.force() < LARGEST && scale.torque() < LARGEST)) {
            return Err(Missing::TooLarge);
        }
        let mechanism = &layout.mechanism;
        if mechanism.rods.is_empty() {
            return Err(Missing::Rods);
        }
        comparable(layout)?;
        let mut cranks = BTreeMap::new();
        for rod in &mechanism.rods {
            let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone());
            cranks.insert(rod.clone(), crank.map_err(|error| Missing::Motion(error.to_string()))?);
        }
        Ok(Motion { cranks, known: RefCell::default(), computed: Cell::new(0) })
    }

    /// c_k of a factor: computed, and counted, once.
    fn coefficient(&self, factor: &Factor, order: u32) -> Coefficient {
        let Some(rod) = factor else { return exactly_one() };
        let key = (rod.clone(), order);
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        self.computed.set(self.computed.get() + 1);
        let coefficient = match self.cranks.get(rod) {
            Some(crank) => crank.coefficient(order),
            // An offset below zero has its coefficients from its mirror image.
            None => match SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) {
                Ok(crank) => crank.coefficient(order),
                Err(_) => unreachable!("λ + |δ| is that of a crank that turns round"),
            },
        };
        self.known.borrow_mut().insert(key, coefficient.clone());
        coefficient
    }

    fn torque(&self, rod: &Rod, order: u32) -> Coefficient {
        self.computed.set(self.computed.get() + 1);
        self.cranks[rod].torque_coefficient(order)
    }

    fn vector(&self, parts: &Parts, order: u32, sense: Sense) -> Vector {
        Vector::new(parts, |factor| match sense {
            Sense::Direct => self.coefficient(factor, order),
            Sense::Reverse => Vector::conjugated(self.coefficient(factor, order)),
        })
    }

    /// The coefficient that all cylinders have in common, where a vector asked for it.
    fn common(&self, order: u32) -> Option<Coefficient> {
        let mut rods = self.cranks.keys();
        let (Some(rod), None) = (rods.next(), rods.next()) else { return None };
        let (factor, sign) = contribution::factor(rod, order)?;
        let Some(rod) = factor else { return Some(exactly_one()) };
        let known = self.known.borrow().get(&(rod, order)).cloned()?;
        Some(Coefficient { re: known.re.times(&sign), im: known.im.times(&sign) })
    }
}

fn exactly_one() -> Coefficient {
    Coefficient { re: Enclosure::point(BigRational::from_integer(1.into())), im: Enclosure::zero() }
}
