//! Which crankshafts are geared together, where do they stand, which way do they turn, and how fast?
//!
//! A piston moves alike on a crank that turns against the reference and on the mirror image of that crank in its cylinder's axis, which
//! turns with it: throw `2α − β` in place of β, and the same offset, which counts with its own crank (theory, section 14). A [`Cylinder`]
//! holds the throw and the rod of this equivalent crank, so that forces, moments and the output torque need no case of their own;
//! where its pin stands is [`Engine::pin_angle`].
//!
//! A crank that turns ν times while the reference turns once has order k of its pistons at order νk of the engine, ν² times as large:
//! it has part in the orders that ν divides, each with its own order ([`Engine::own_order`]).

use super::crankshaft::Crankshaft;
use super::cylinder::Cylinder;
use super::draft::ReferencePlane;
use super::geared_crank::{GearedCrank, own_order};
use super::model::Engine;
use super::order::{has_order, pistons_have_order};
use super::torsion::NoShaft;
use crate::exact::Turn;
use crate::proof::{Quantity, Sense};

impl<A, L> Engine<A, L> {
    /// The crankshafts that are geared together; none where there is one, in the middle, that turns anticlockwise.
    pub fn geared_cranks(&self) -> &[GearedCrank] {
        &self.draft().geared_cranks
    }

    /// How many crankshafts there are.
    pub fn crankshafts(&self) -> usize {
        self.geared_cranks().len().max(1)
    }

    /// The crankshaft that a cylinder works on, where several are geared together.
    pub fn crank_of(&self, cylinder: &Cylinder<A, L>) -> Option<&GearedCrank> {
        self.geared_cranks().get(cylinder.crank)
    }

    /// Which way the crank of a cylinder turns.
    pub fn sense_of(&self, cylinder: &Cylinder<A, L>) -> Sense {
        self.crank_of(cylinder).map_or(Sense::Direct, |crank| crank.sense)
    }

    /// How many times the crank of a cylinder turns while the reference turns once.
    pub fn speed_of(&self, cylinder: &Cylinder<A, L>) -> u32 {
        self.crank_of(cylinder).map_or(1, |crank| crank.speed)
    }

    /// The first crankshaft that turns faster than the reference.
    pub fn faster_crank(&self) -> Option<&GearedCrank> {
        self.geared_cranks().iter().find(|crank| crank.speed != 1)
    }

    /// The crankshaft that turns so often and in this sense while the reference turns once, of several geared together.
    pub fn crank_turning(&self, speed: u32, sense: Sense) -> Option<&GearedCrank> {
        self.geared_cranks().iter().find(|crank| (crank.speed, crank.sense) == (speed, sense))
    }

    /// Whether a crankshaft turns so, the reference one or another: what counterweights on it cancel needs no balancer shaft.
    pub fn has_crank_turning(&self, speed: u32, sense: Sense) -> bool {
        (speed, sense) == (1, Sense::Direct) || self.crank_turning(speed, sense).is_some()
    }

    /// The order of a cylinder's own motion that is this order of the engine; none where its crank turns so fast that it has no part in it.
    pub fn own_order(&self, cylinder: &Cylinder<A, L>, order: u32) -> Option<u32> {
        own_order(self.speed_of(cylinder), order)
    }

    /// Whether force and moment have an order: pistons do, or what turns on a shaft or a crankshaft. Odd ones of centric rods have the
    /// coefficient 0.
    pub fn has_order(&self, order: u32) -> bool {
        let turns_on_a_shaft = || self.crankshaft().balancers.iter().any(|shaft| shaft.order == order);
        let turns_on_a_crank = || self.geared_cranks().iter().any(|crank| crank.speed == order);
        self.pistons_have_order(Quantity::FORCE, order) || turns_on_a_shaft() || turns_on_a_crank()
    }

    /// Whether some piston has an order; rods of which nothing is known are of finite length and without offset.
    pub fn pistons_have_order(&self, quantity: Quantity, order: u32) -> bool {
        match self.faster_crank() {
            Some(_) => pistons_have_order(self.cylinders(), self.geared_cranks(), quantity, order),
            // Each rod once.
            None => match self.mechanisms().as_slice() {
                [] => has_order(None, quantity, order),
                mechanisms => mechanisms.iter().any(|mechanism| has_order(Some(mechanism), quantity, order)),
            },
        }
    }

    /// How many times each crankpin turns while the reference turns once, below 0 against it.
    ///
    /// # Errors
    /// A pin of two crankshafts.
    pub fn pin_speeds(&self) -> Result<Vec<i64>, NoShaft> {
        let mut cranks: Vec<Option<usize>> = Vec::new();
        for cylinder in self.cylinders() {
            cranks.resize(cranks.len().max(cylinder.pin + 1), None);
            if cranks[cylinder.pin].replace(cylinder.crank).is_some_and(|other| other != cylinder.crank) {
                return Err(NoShaft::OfTwoCranks(cylinder.pin + 1));
            }
        }
        let speed = |crank: &GearedCrank| crank.sense.signed(i64::from(crank.speed));
        Ok(cranks.into_iter().map(|crank| self.geared_cranks().get(crank.unwrap_or(0)).map_or(1, speed)).collect())
    }
}

impl Engine {
    /// One of several crankshafts by itself, as it is looked at: its cylinders, its counterweights, and its pins where they stand.
    pub fn crankshaft_alone(&self, crank: usize) -> Option<Engine> {
        let mut draft = self.clone().into_draft();
        draft.reference_plane = ReferencePlane::Named(self.reference_plane().clone());
        draft.cylinders.retain(|cylinder| cylinder.crank == crank);
        for cylinder in &mut draft.cylinders {
            (cylinder.throw, cylinder.crank, cylinder.shared) = (self.pin_angle(cylinder), 0, None);
        }
        (draft.geared_cranks, draft.firing) = (Vec::new(), None);
        // What is of all cylinders or pins does not fit some of them.
        (draft.gas, draft.misfire, draft.torsion) = (None, None, None);
        let mut counterweights = self.crankshaft().counterweights.clone();
        counterweights.retain(|weight| weight.crank == crank);
        for weight in &mut counterweights {
            (weight.throw, weight.crank) = (None, 0);
        }
        draft.crankshaft =
            Crankshaft { counterweights, length: self.crankshaft().length.clone(), ..Crankshaft::default() };
        draft.build().ok()
    }

    /// Where the crankpin of a cylinder is at θ = 0: its throw, or on a crank that turns against the reference the mirror image
    /// of it in the cylinder's axis.
    pub fn pin_angle(&self, cylinder: &Cylinder) -> Turn {
        match self.sense_of(cylinder) {
            Sense::Direct => cylinder.throw.clone(),
            Sense::Reverse => &cylinder.bank.times(2) - &cylinder.throw,
        }
    }
}
