//! How much can the orders above the K-th of an engine add to a load, at most? What its pistons add, all in one direction.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{Missing, Motion};
use crate::engine::{Engine, Mechanism};
use crate::motion::{Coefficient, CorrectedTail, HungLink, LinkMass, SLACK, SliderCrank, Tail};
use crate::order::{self, Factor, mass_radius};
use crate::proof::Quantity;

/// What the orders of each piston leave to the higher ones.
#[derive(Clone, Debug)]
pub struct Tails {
    by_mechanism: BTreeMap<Mechanism, Parts>,
}

/// The motions that one of a piston is made of: those of cranks, each with the largest part it has, one, or of a link that of its master and its
/// own; and that of a link with a corrected knuckle angle.
#[derive(Clone, Debug)]
struct Parts {
    cranks: Vec<(f64, Tail)>,
    corrected: Option<CorrectedTail>,
    /// What a link hands on to the crankpin of its master rod.
    hung: Option<HungLink>,
}

impl Parts {
    /// The orders of the force above one.
    fn force(&self, order: u32) -> f64 {
        let of_cranks: f64 = self.cranks.iter().map(|(part, tail)| part * tail.force(order)).sum();
        of_cranks + self.corrected.as_ref().map_or(0.0, |tail| tail.force(order))
    }

    /// What is not computed of links has no bound.
    fn of_rod(&self, bound: impl Fn(&Tail) -> f64) -> f64 {
        match (&self.cranks[..], &self.corrected) {
            ([(_, only)], None) => bound(only),
            _ => f64::INFINITY,
        }
    }
}

impl Tails {
    /// Without computing any coefficient.
    ///
    /// # Errors
    /// What the layout lacks for numbers.
    pub fn new(engine: &Engine) -> Result<Self, Missing> {
        Ok(Tails::of(&Motion::new(engine)?))
    }

    pub(super) fn of(motion: &Motion) -> Self {
        Tails::with(motion, Tail::new)
    }

    /// Tighter, from the coefficients of all orders up to the highest.
    ///
    /// # Errors
    /// What the layout lacks for numbers.
    pub fn with_coefficients(engine: &Engine, highest: u32) -> Result<Self, Missing> {
        Ok(Tails::with(&Motion::new(engine)?, |crank| {
            let coefficients: Vec<Coefficient> = (1..=highest).map(|order| crank.coefficient(order)).collect();
            Tail::with_coefficients(crank, &coefficients)
        }))
    }

    fn with(motion: &Motion, tail: impl Fn(&SliderCrank) -> Tail) -> Self {
        let parts = |mechanism: &Mechanism| match mechanism {
            Mechanism::SliderCrank(rod) => {
                Some(Parts { cranks: vec![(1.0, tail(&order::crank_of(rod)))], corrected: None, hung: None })
            }
            Mechanism::Link(link) => {
                let master = order::crank_of(&link.master_rod());
                let mut cranks = vec![(rounded_up(&link.knuckle), tail(&master))];
                let corrected = match link.is_corrected() {
                    true => Some(link.corrected()?.tail()),
                    false => {
                        let own = link.linkage()?;
                        cranks.push((rounded_up(&own.distance()), tail(own.crank())));
                        None
                    }
                };
                Some(Parts { cranks, corrected, hung: Some(link.hung()) })
            }
        };
        let mechanisms = motion.mechanisms.iter();
        Tails { by_mechanism: mechanisms.filter_map(|one| Some((one.clone(), parts(one)?))).collect() }
    }

    /// The orders of the pistons above this one, of at least 2, and the shafts that turn faster add at most this to a load, in
    /// its multiples of m r ω²; 0 only where there is none. The roll moment has no bound here.
    pub fn above(&self, engine: &Engine, quantity: Quantity, order: u32) -> f64 {
        let pistons = self.sum(engine, quantity, &|parts, speed| match (quantity, order / speed.max(1)) {
            // A crank that turns faster has had so few of its own orders up to this one.
            (Quantity::Planar(_), 0) => 1.0 + parts.force(0),
            (Quantity::Planar(_), own) => parts.force(own),
            (Quantity::TORQUE, 0 | 1) => f64::INFINITY,
            (Quantity::TORQUE, own) => parts.of_rod(|tail| tail.torque(own)),
            (Quantity::ROLL, _) => f64::INFINITY,
        });
        let [force, moment] = self.faster_shafts(engine, order);
        let shafts = match quantity {
            Quantity::FORCE => force,
            Quantity::MOMENT => moment,
            Quantity::Axial(_) => 0.0,
        };
        (pistons + shafts) * SLACK
    }

    /// The largest force of the shafts that turn faster than this order, and its moment about the reference plane, in
    /// multiples of m r ω²: what they add where higher orders are omitted.
    fn faster_shafts(&self, engine: &Engine, highest: u32) -> [f64; 2] {
        let half = BigRational::new(1.into(), 2.into());
        let mut sums: BTreeMap<(Factor, u32), [BigRational; 2]> = BTreeMap::new();
        for shaft in order::turning_masses(engine).into_iter().filter(|mass| mass.order > highest) {
            let size = shaft.weight().abs() * &half;
            let arm = (&shaft.position - engine.reference_plane()).abs();
            let [force, moment] = sums.entry((shaft.factor, shaft.order)).or_default();
            *moment += &size * arm;
            *force += size;
        }
        // c_k is one of the orders above k − 1 that the tail is above.
        let most = |factor: &Factor, order: u32| match factor {
            Factor::One => 1.0,
            Factor::Motion(rod) => {
                let of_rod = |parts: &Parts| parts.of_rod(|tail| tail.force(order.saturating_sub(1)));
                self.by_mechanism
                    .get(&Mechanism::SliderCrank(rod.clone()))
                    .map_or(f64::INFINITY, |parts| 1.0 + of_rod(parts))
            }
            // A shaft is multiplied by none of these.
            Factor::Torque(_)
            | Factor::Quadrature(_)
            | Factor::Side(_)
            | Factor::Linkage(_)
            | Factor::Corrected(..)
            | Factor::OnPin(..)
            | Factor::Open
            | Factor::OpenTorque
            | Factor::Geared(..) => f64::INFINITY,
        };
        sums.into_iter().fold([0.0, 0.0], |[force, moment], ((factor, order), sizes)| {
            let [more_force, more_moment] = sizes.map(|size| match rounded_up(&size) {
                0.0 => 0.0,
                size => size * most(&factor, order) * SLACK,
            });
            [force + more_force, moment + more_moment]
        })
    }

    /// The orders above this one, of at least 1, add at most this to what carries these parts of the loads of the crankpins, a part per
    /// cylinder.
    pub fn of_pins_above<'a>(&self, engine: &Engine, parts: impl Iterator<Item = &'a BigRational>, order: u32) -> f64 {
        let pins = engine.cylinders().iter().zip(parts).map(|(cylinder, part)| {
            let speed = engine.speed_of(cylinder);
            let faster = BigRational::from_integer(speed.into());
            let faster = &faster * &faster * part.abs();
            let known = cylinder.mechanism.as_ref().and_then(|rod| self.by_mechanism.get(rod));
            let bound = |mass: LinkMass| match (known, order / speed.max(1)) {
                // A crank that turns faster has had so few of its own orders up to this one.
                (None, _) | (_, 0) => f64::INFINITY,
                // Decimals: a link's numbers are summed, and nothing is proved of them.
                (Some(Parts { hung: Some(link), .. }), own) => link.above(mass, own),
                (Some(parts), own) => parts.of_rod(|tail| tail.pin(own)),
            };
            let masses = [
                (LinkMass::Piston, mass_radius(engine, cylinder)),
                (LinkMass::Knuckle, &cylinder.knuckle_mass * &cylinder.crank_radius),
            ];
            let of_mass = |(mass, weight): (LinkMass, BigRational)| {
                let weight = weight.abs() * &faster;
                match if weight.is_zero() { 0.0 } else { bound(mass) } {
                    0.0 => 0.0,
                    bound => (bound * rounded_up(&weight) * SLACK).max(f64::MIN_POSITIVE),
                }
            };
            masses.map(of_mass).iter().sum::<f64>()
        });
        pins.sum::<f64>() * SLACK
    }

    /// No sum of the terms of the pistons' load is larger than this: each at the dead point of its largest acceleration.
    pub fn largest_sum(&self, engine: &Engine, quantity: Quantity) -> f64 {
        self.sum(engine, quantity, &|parts, _| {
            let shaking = 1.0 + parts.force(0);
            match quantity {
                Quantity::Planar(_) => shaking,
                Quantity::TORQUE => shaking * shaking,
                Quantity::ROLL => f64::INFINITY,
            }
        })
    }

    /// The bounds of the pistons, each as much as its load counts, by their mechanisms and how fast their cranks turn.
    fn sum(&self, engine: &Engine, quantity: Quantity, bound: &dyn Fn(&Parts, u32) -> f64) -> f64 {
        let mut weights: BTreeMap<(Mechanism, u32), BigRational> = BTreeMap::new();
        for cylinder in engine.cylinders() {
            let Some(mechanism) = &cylinder.mechanism else { continue };
            let (weight, speed) = (mass_radius(engine, cylinder).abs(), engine.speed_of(cylinder));
            let faster = |exponent| num_traits::pow(BigRational::from_integer(speed.into()), exponent);
            let weight = match quantity {
                Quantity::Planar(planar) => weight * order::lever(engine, planar, &cylinder.position).abs() * faster(2),
                Quantity::Axial(_) => weight * &cylinder.crank_radius * faster(3),
            };
            *weights.entry((mechanism.clone(), speed)).or_insert_with(BigRational::zero) += weight;
            if let (Some(link), Some(planar)) = (cylinder.link(), quantity.planar()) {
                // The mass at the knuckle pin moves as the master's piston does, in part.
                let lever = order::lever(engine, planar, &cylinder.position).abs();
                let weight = &cylinder.knuckle_mass * &cylinder.crank_radius * &link.knuckle * lever;
                let master = Mechanism::SliderCrank(link.master_rod());
                *weights.entry((master, speed)).or_insert_with(BigRational::zero) += weight;
            }
        }
        // A mass of 0 is 0 times whatever the rest is.
        let weights = weights.into_iter().filter(|(_, weight)| !weight.is_zero());
        let parts = weights.map(|((rod, speed), weight)| {
            match self.by_mechanism.get(&rod).map_or(f64::INFINITY, |parts| bound(parts, speed)) {
                0.0 => 0.0,
                bound => (bound * rounded_up(&weight) * SLACK).max(f64::MIN_POSITIVE),
            }
        });
        parts.sum()
    }
}

/// The float at or above a number that is not negative; 0 only of 0.
fn rounded_up(number: &BigRational) -> f64 {
    if number.is_zero() { 0.0 } else { number.to_f64().unwrap_or(f64::INFINITY).next_up() }
}
