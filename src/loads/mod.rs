//! How large are the forces, moments and torques of an engine, in newtons?
//!
//! The exact sums of a layout times the coefficients of its motion. Only what the layout file asks for is computed.

mod bearing;
mod needed;
mod roll;
mod shares;
mod swing;
mod vector;
mod waveform;

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

pub use bearing::{BearingLoad, BearingLoads, BearingOrder, Method, bearing_loads};
pub use needed::{Needed, needed_orders};
pub use swing::Swing;
pub use vector::{Outcome, Vector};
pub use waveform::{Circle, Harmonic, Peak, Waveform};

use crate::beam::Mistake;
use crate::layout::{Layout, LengthUnit, Rod};
use crate::motion::{Coefficient, Enclosure, SliderCrank};
use crate::order::{self, Contribution, Factor, MassGroup, OrderSum};
use crate::proof::{Quantity, Sense};
use crate::verdict;

/// Forces, moments and torque of an engine, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct Loads {
    /// The orders, rising, each with what is left of it.
    pub orders: Vec<OrderLoads>,
    /// The groups of masses that are in the scene.
    pub groups: Vec<GroupLoads>,
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

/// What one group of masses adds.
#[derive(Clone, Debug)]
pub struct GroupLoads {
    /// The group.
    pub group: MassGroup,
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
            Missing::Bearings => f.write_str(
                "the layout says nothing of its main bearings; above the first table, give their positions: bearings = [0.15, 0.05, -0.05, -0.15]",
            ),
            Missing::Beam(mistake) => mistake.fmt(f),
        }
    }
}

impl std::error::Error for Missing {}

/// Computes the loads of an engine at these orders.
///
/// # Errors
/// What the layout lacks.
pub fn loads(layout: &Layout, orders: &[u32]) -> Result<Loads, Missing> {
    let motion = Motion::new(layout)?;
    let scene = order::groups_of(layout);
    let mut total = Vec::new();
    let mut by_group: Vec<[Vec<Harmonic>; 2]> = scene.iter().map(|_| Default::default()).collect();
    for &order in orders {
        let [direct, reverse] = SENSES.map(|sense| order::contributions(layout, order, sense));
        let [force, moment] = [Quantity::Force, Quantity::Moment].map(|quantity| {
            let swing = |of: &dyn Fn(&Contribution) -> bool| {
                let sum = |all: &[Contribution]| weighed(layout, quantity, all.iter().filter(|one| of(one)));
                motion.swing([sum(&direct), sum(&reverse)], order)
            };
            if scene.len() > 1 {
                for (group, harmonics) in scene.iter().zip(&mut by_group) {
                    let swing = swing(&|one| one.source.group() == *group);
                    harmonics[usize::from(quantity == Quantity::Moment)].push(harmonic(order, &swing));
                }
            }
            swing(&|_| true)
        });
        total.push(OrderLoads { order, coefficient: motion.common(order), force, moment });
    }
    let waveform =
        |swing: fn(&OrderLoads) -> &Swing| Waveform::new(total.iter().map(|loads| harmonic(loads.order, swing(loads))));
    let (force, moment) = (waveform(|loads| &loads.force), waveform(|loads| &loads.moment));
    if let [only] = by_group.as_mut_slice() {
        *only = [force.harmonics().to_vec(), moment.harmonics().to_vec()];
    }
    let groups = scene.into_iter().zip(by_group).map(|(group, [force, moment])| GroupLoads {
        group,
        force: Waveform::new(force),
        moment: Waveform::new(moment),
    });
    let solve = |method| bearing_loads(layout, orders, method);
    let bearings = match layout.bearings.is_empty() {
        true => None,
        false => Some([solve(Method::Continuous)?, solve(Method::Determinate)?]),
    };
    let torque = layout.effects.torque.then(|| torque(layout, &motion, orders));
    let has_shafts = !layout.crankshaft.balancers.is_empty();
    let roll = (layout.effects.torque && has_shafts).then(|| roll::roll(layout, &motion, orders));
    Ok(Loads {
        groups: groups.collect(),
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

/// Whether the masses that turn can be compared with the reciprocating ones.
///
/// # Errors
/// What the layout lacks for that.
pub fn comparable(layout: &Layout) -> Result<(), Missing> {
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

/// What turns the multiples of a layout into newtons; none where mass, crank radius or speed is missing.
pub fn scale(layout: &Layout) -> Option<Scale> {
    let mechanism = &layout.mechanism;
    Some(Scale {
        mass: mechanism.mass.as_ref().map(|_| order::unit_mass(layout))?,
        crank_radius: mechanism.crank_radius.clone()?,
        speed: mechanism.speed.clone()?,
    })
}

fn harmonic(order: u32, swing: &Swing) -> Harmonic {
    let [direct, reverse] = swing.amplitudes();
    Harmonic { order, direct, reverse }
}

/// Both senses, direct first.
const SENSES: [Sense; 2] = [Sense::Direct, Sense::Reverse];

/// These contributions as the force, or as the moment about the reference plane.
fn weighed<'a>(layout: &Layout, quantity: Quantity, contributions: impl Iterator<Item = &'a Contribution>) -> OrderSum {
    OrderSum::new(contributions.map(|one| one.weighed(|position| order::lever(layout, quantity, position))))
}

fn torque(layout: &Layout, motion: &Motion, orders: &[u32]) -> Torque {
    let order = |order: u32| {
        let sum = order::torque(layout, order);
        let pairs: Vec<_> = sum.parts().iter().map(|(factor, sum)| (motion.coefficient(factor, order), sum)).collect();
        let coefficient = match (motion.cranks.len(), pairs.as_slice()) {
            (1, [(coefficient, _)]) => Some(coefficient.clone()),
            _ => None,
        };
        TorqueOrder { order, coefficient, vector: Vector::of(&pairs, false) }
    };
    let orders: Vec<TorqueOrder> = verdict::torque_orders(orders).into_iter().map(order).collect();
    let zero = Complex::new(0.0, 0.0);
    let harmonics = orders.iter().map(|o| Harmonic { order: o.order, direct: o.vector.value, reverse: zero });
    Torque { waveform: Waveform::new(harmonics), orders }
}

/// Forces from here on are refused: their sums and squares would leave the range of decimals.
const LARGEST: f64 = 1e150;

/// The motions of the cylinders, and the coefficients that were asked of them.
struct Motion {
    cranks: BTreeMap<Rod, SliderCrank>,
    known: RefCell<BTreeMap<(Factor, u32), Coefficient>>,
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

    /// The value of a factor: computed, and counted, once.
    fn coefficient(&self, factor: &Factor, order: u32) -> Coefficient {
        let key = (factor.clone(), order);
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let coefficient = match factor {
            Factor::One => return exactly_one(),
            Factor::Motion(rod) => self.crank(rod, |crank| crank.coefficient(order)),
            Factor::Torque(rod) => self.crank(rod, |crank| crank.torque_coefficient(order)),
            Factor::Open => unreachable!("loads are those of an engine that names its rods"),
        };
        self.computed.set(self.computed.get() + 1);
        self.known.borrow_mut().insert(key, coefficient.clone());
        coefficient
    }

    fn crank(&self, rod: &Rod, value: impl Fn(&SliderCrank) -> Coefficient) -> Coefficient {
        match self.cranks.get(rod) {
            Some(crank) => value(crank),
            // An offset below zero has its coefficients from its mirror image.
            None => match SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) {
                Ok(crank) => value(&crank),
                Err(_) => unreachable!("λ + |δ| is that of a crank that turns round"),
            },
        }
    }

    fn vector(&self, sum: &OrderSum, order: u32, sense: Sense) -> Vector {
        Vector::new(sum, |factor| match sense {
            Sense::Direct => self.coefficient(factor, order),
            Sense::Reverse => Vector::conjugated(self.coefficient(factor, order)),
        })
    }

    /// What the two sums of an order trace.
    fn swing(&self, [direct, reverse]: [OrderSum; 2], order: u32) -> Swing {
        let vectors = [self.vector(&direct, order, Sense::Direct), self.vector(&reverse, order, Sense::Reverse)];
        Swing::new(vectors, [&direct, &reverse])
    }

    /// The coefficient that all cylinders have in common, where a vector asked for it.
    fn common(&self, order: u32) -> Option<Coefficient> {
        let mut rods = self.cranks.keys();
        let (Some(rod), None) = (rods.next(), rods.next()) else { return None };
        let (factor, sign) = Factor::of_force(Some(rod), order)?;
        if factor == Factor::One {
            return Some(exactly_one());
        }
        let known = self.known.borrow().get(&(factor, order)).cloned()?;
        Some(Coefficient { re: known.re.times(&sign), im: known.im.times(&sign) })
    }
}

fn exactly_one() -> Coefficient {
    Coefficient { re: Enclosure::point(BigRational::from_integer(1.into())), im: Enclosure::zero() }
}
