//! How much can the orders above the K-th of an engine add to a load, at most? What its pistons add, all in one direction.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{Missing, Motion};
use crate::engine::{Engine, Law, Link, Mechanism, Ray};
use crate::motion::{Coefficient, CorrectedTail, HungLink, LinkMass, SLACK, SliderCrank, Tail};
use crate::order::{self, Factor, mass_radius, power};
use crate::proof::{Planar, Quantity};

/// What the orders of each piston leave to the higher ones.
#[derive(Clone, Debug)]
pub struct Tails {
    by_law: BTreeMap<Law, LawTail>,
    /// What links hand on to the crankpins of their master rods.
    hung: BTreeMap<Link, HungLink>,
}

/// What the orders of a law leave to the higher ones.
#[derive(Clone, Debug)]
enum LawTail {
    /// Of a crankpin, which has order 1 alone.
    First,
    /// Of a crank, whose harmonics are multiplied by no more than this.
    Crank(f64, Tail),
    /// Of a link with a corrected knuckle angle.
    Corrected(CorrectedTail),
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
        let of_law = |law: &Law| match law {
            Law::Crank => Some(LawTail::First),
            Law::Rod(rod) => Some(LawTail::Crank(1.0, tail(&order::crank_of(rod)))),
            Law::Link(link) => {
                let own = link.linkage()?;
                Some(LawTail::Crank(rounded_up(&own.distance()), tail(own.crank())))
            }
            Law::Corrected(link) => Some(LawTail::Corrected(link.corrected()?.tail())),
        };
        let laws: BTreeSet<Law> = motion.mechanisms.iter().flat_map(Ray::of).map(|ray| ray.law).collect();
        let links = motion.mechanisms.iter().filter_map(Mechanism::link);
        Tails {
            by_law: laws.into_iter().filter_map(|law| Some((law.clone(), of_law(&law)?))).collect(),
            hung: links.map(|link| (link.clone(), link.hung())).collect(),
        }
    }

    /// The orders of the force above one.
    fn force(&self, law: &Law, order: u32) -> f64 {
        match self.by_law.get(law) {
            Some(LawTail::First) => {
                if order == 0 {
                    1.0
                } else {
                    0.0
                }
            }
            Some(LawTail::Crank(part, tail)) => part * tail.force(order),
            Some(LawTail::Corrected(tail)) => tail.force(order),
            None => f64::INFINITY,
        }
    }

    /// What is known of a rod alone: what is not computed of links has no bound.
    fn of_rod(&self, mechanism: &Mechanism, bound: impl Fn(&Tail) -> f64) -> f64 {
        match mechanism.rod().and_then(|rod| self.by_law.get(&Law::Rod(rod.clone()))) {
            Some(LawTail::Crank(_, tail)) => bound(tail),
            Some(LawTail::First | LawTail::Corrected(_)) | None => f64::INFINITY,
        }
    }

    /// The orders of the pistons above this one, of at least 2, and the shafts that turn faster add at most this to a load, in
    /// its multiples of m r ω²; 0 only where there is none. The roll moment has no bound here.
    pub fn above(&self, engine: &Engine, quantity: Quantity, order: u32) -> f64 {
        let pistons = match quantity {
            Quantity::Planar(planar) => self.of_force(engine, planar, order),
            Quantity::TORQUE => self.of_torque(engine, |mechanism, speed| match order / speed.max(1) {
                0 | 1 => f64::INFINITY,
                own => self.of_rod(mechanism, |tail| tail.torque(own)),
            }),
            Quantity::ROLL => f64::INFINITY,
        };
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
            Factor::Motion(rod) => 1.0 + self.force(&Law::Rod(rod.clone()), order.saturating_sub(1)),
            // A shaft is multiplied by no other.
            _ => f64::INFINITY,
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
            let bound = |mass: LinkMass| match (&cylinder.mechanism, order / speed.max(1)) {
                // A crank that turns faster has had so few of its own orders up to this one.
                (None, _) | (_, 0) => f64::INFINITY,
                // Decimals: a link's numbers are summed, and nothing is proved of them.
                (Some(Mechanism::Link(link)), own) => {
                    self.hung.get(link).map_or(f64::INFINITY, |link| link.above(mass, own))
                }
                (Some(mechanism), own) => self.of_rod(mechanism, |tail| tail.pin(own)),
            };
            let masses = [
                (LinkMass::Piston, mass_radius(engine, cylinder)),
                (LinkMass::Knuckle, &cylinder.knuckle_mass * &cylinder.crank_radius),
            ];
            sum(masses.map(|(mass, weight)| (mass, weight.abs() * &faster)), |mass| bound(*mass))
        });
        pins.sum::<f64>() * SLACK
    }

    /// No sum of the terms of the pistons' load is larger than this: each at the dead point of its largest acceleration.
    pub fn largest_sum(&self, engine: &Engine, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Planar(planar) => self.of_force(engine, planar, 0),
            Quantity::TORQUE => self.of_torque(engine, |mechanism, _| {
                let of_ray = |ray: Ray| rounded_up(&ray.weight.abs()) * self.force(&ray.law, 0);
                let shaking: f64 = Ray::of(mechanism).into_iter().map(of_ray).sum();
                shaking * shaking
            }),
            Quantity::ROLL => f64::INFINITY,
        }
    }

    /// What the orders of the pistons above this one add to a force or a moment: each ray in one direction, and the first of the cranks
    /// that have it above.
    fn of_force(&self, engine: &Engine, quantity: Planar, order: u32) -> f64 {
        let mut weights: BTreeMap<(Law, u32), BigRational> = BTreeMap::new();
        for cylinder in engine.cylinders() {
            let speed = engine.speed_of(cylinder);
            let lever = order::lever(engine, quantity, &cylinder.position).abs() * power(speed, 2);
            for ray in order::rays(engine, cylinder) {
                *weights.entry((ray.law, speed)).or_insert_with(BigRational::zero) += ray.weight.abs() * &lever;
            }
        }
        // A crank that turns faster has had so few of its own orders up to this one.
        sum(weights, |(law, speed)| self.force(law, order / (*speed).max(1)))
    }

    /// The bounds of the torques of the pistons, by their mechanisms and how fast their cranks turn.
    fn of_torque(&self, engine: &Engine, bound: impl Fn(&Mechanism, u32) -> f64) -> f64 {
        let mut weights: BTreeMap<(Mechanism, u32), BigRational> = BTreeMap::new();
        for (cylinder, mechanism) in engine.moved() {
            let speed = engine.speed_of(cylinder);
            let weight = mass_radius(engine, cylinder).abs() * &cylinder.crank_radius * power(speed, 3);
            *weights.entry((mechanism.clone(), speed)).or_insert_with(BigRational::zero) += weight;
        }
        sum(weights, |(mechanism, speed)| bound(mechanism, *speed))
    }
}

/// Bounds of what has these weights, each as much as it counts; 0 only where there is none.
fn sum<K>(weights: impl IntoIterator<Item = (K, BigRational)>, bound: impl Fn(&K) -> f64) -> f64 {
    // A mass of 0 is 0 times whatever the rest is.
    let weights = weights.into_iter().filter(|(_, weight)| !weight.is_zero());
    let parts = weights.map(|(key, weight)| match bound(&key) {
        0.0 => 0.0,
        bound => (bound * rounded_up(&weight) * SLACK).max(f64::MIN_POSITIVE),
    });
    parts.sum()
}

/// The float at or above a number that is not negative; 0 only of 0.
fn rounded_up(number: &BigRational) -> f64 {
    if number.is_zero() { 0.0 } else { number.to_f64().unwrap_or(f64::INFINITY).next_up() }
}
