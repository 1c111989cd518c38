//! Does a draft hold together? Only then it is an engine.

use std::collections::BTreeSet;

use super::build_error::{BuildError, MOST_CYLINDERS, not_negative, positive};
use super::draft::{Draft, ReferencePlane};
use super::family::Family;
use super::length::Length;
use super::linear::Linear;
use super::mechanism::Mechanism;
use super::model::Engine;
use super::order::{ORDERS, are_orders, pistons_have_order};
use super::throws::throws;
use crate::proof::{Quantity, Sense};

/// The orders of a draft that names none are those that exist, up to this one.
const USUALLY_UP_TO: u32 = 6;

impl<A, L: Length> Draft<A, L> {
    /// What holds for engines and families alike.
    fn checked(mut self) -> Result<Engine<A, L>, BuildError> {
        if self.cylinders.is_empty() || self.cylinders.len() > MOST_CYLINDERS {
            return Err(BuildError::Cylinders(self.cylinders.len()));
        }
        for (index, cylinder) in self.cylinders.iter_mut().enumerate().filter(|(_, cylinder)| cylinder.name.is_empty())
        {
            cylinder.name = (index + 1).to_string();
        }
        let mut names = BTreeSet::new();
        // That of the cylinder before, which turns round: most engines have one.
        let mut turning: Option<&Mechanism> = None;
        for cylinder in &self.cylinders {
            let name = &cylinder.name;
            if !names.insert(name) {
                return Err(BuildError::SameName(name.clone()));
            }
            not_negative(&cylinder.reciprocating_mass, || format!("the reciprocating mass of cylinder {name}"))?;
            not_negative(&cylinder.rotating_mass, || format!("the rotating mass of cylinder {name}"))?;
            not_negative(&cylinder.knuckle_mass, || format!("the mass at the knuckle pin of cylinder {name}"))?;
            positive(&cylinder.crank_radius, || format!("the crank radius of cylinder {name}"))?;
            if cylinder.crank >= self.geared_cranks.len().max(1) {
                return Err(BuildError::NoSuchCrank(name.clone()));
            }
            let mechanism = cylinder.mechanism.as_ref();
            if mechanism != turning && mechanism.is_some_and(|mechanism| !mechanism.turns_round()) {
                return Err(BuildError::CannotTurnRound(name.clone()));
            }
            turning = mechanism;
            if let Some(own) = cylinder.shared {
                let within =
                    self.cylinders.iter().filter_map(|other| other.shared).filter(|other| other.number == own.number);
                let seconds: Vec<bool> = within.map(|other| other.is_second).collect();
                if !matches!(seconds[..], [true, false] | [false, true]) {
                    return Err(BuildError::Shared(name.clone()));
                }
            }
        }
        let without = self.cylinders.iter().find(|cylinder| cylinder.mechanism.is_none());
        if let Some(cylinder) = without.filter(|_| self.cylinders.iter().any(|one| one.mechanism.is_some())) {
            return Err(BuildError::MechanismMissing(cylinder.name.clone()));
        }
        if let Some(first) = self.geared_cranks.first() {
            if first.sense == Sense::Reverse || first.speed != 1 {
                return Err(BuildError::FirstCrank);
            }
            if let Some(crank) = self.geared_cranks.iter().find(|crank| !ORDERS.contains(&crank.speed)) {
                return Err(BuildError::Speed { crank: crank.name.clone(), speed: crank.speed });
            }
        }
        if let Some(gas) = &self.gas {
            gas.check(self.cylinders.len(), self.cycle).map_err(BuildError::Gas)?;
        }
        if let Some(mounting) = &self.mounting {
            mounting.check().map_err(BuildError::Mounting)?;
        }
        let flywheel = &self.flywheel;
        flywheel.inertia.iter().try_for_each(|inertia| positive(inertia, || "the inertia of the flywheel".into()))?;
        flywheel.irregularity.iter().try_for_each(|wanted| positive(wanted, || "the irregularity".into()))?;
        let dimensions = &self.dimensions;
        dimensions.mass.iter().try_for_each(|mass| not_negative(mass, || "the reciprocating mass".into()))?;
        dimensions.speed.iter().try_for_each(|speed| not_negative(speed, || "the speed".into()))?;
        dimensions.crank_radius.iter().try_for_each(|radius| positive(radius, || "the crank radius".into()))?;
        let has_order = |&order: &u32| pistons_have_order(&self.cylinders, &self.geared_cranks, Quantity::FORCE, order);
        let usual: Vec<u32> = (1..=USUALLY_UP_TO).filter(has_order).collect();
        are_orders(&self.orders).map_err(BuildError::Order)?;
        self.orders.sort_unstable();
        self.orders.dedup();
        let orders = if self.orders.is_empty() { usual } else { self.orders.clone() };
        let positions: Vec<&L> = self.cylinders.iter().map(|cylinder| &cylinder.position).collect();
        let plane = match &self.reference_plane {
            ReferencePlane::Middle => L::middle(&positions),
            ReferencePlane::OfFamily(plane) | ReferencePlane::Named(plane) => plane.clone(),
        };
        Ok(Engine::new(self, plane, orders))
    }
}

impl Draft {
    /// The engine, if all of it fits together. Cylinders without a name get their number.
    ///
    /// # Errors
    /// The first thing that does not fit.
    pub fn build(self) -> Result<Engine, BuildError> {
        let engine = self.checked()?;
        super::links::check(&engine)?;
        let crankshaft = engine.crankshaft();
        if !crankshaft.pins.is_empty() || !crankshaft.webs.is_empty() || !crankshaft.counterweights.is_empty() {
            let throws = throws(&engine).len();
            for (of, values) in [("pins", crankshaft.pins.len()), ("webs", crankshaft.webs.len())] {
                if values != 0 && values != throws {
                    return Err(BuildError::List { of, values, throws });
                }
            }
            let mut on_throws = crankshaft.counterweights.iter().filter_map(|weight| weight.throw);
            if let Some(index) = on_throws.find(|index| *index >= throws) {
                return Err(BuildError::NoSuchThrow(index));
            }
        }
        crankshaft.pins.iter().try_for_each(|mass| not_negative(mass, || "the mass of a pin".into()))?;
        crankshaft.webs.iter().try_for_each(|web| not_negative(&web.mass, || "the mass of the webs".into()))?;
        for weight in &crankshaft.counterweights {
            not_negative(&weight.mass, || "the mass of a counterweight".into())?;
            not_negative(&weight.radius, || "the radius of a counterweight".into())?;
        }
        for shaft in &crankshaft.balancers {
            not_negative(&shaft.mass_radius, || "the mass-radius of a balancer shaft".into())?;
            are_orders(&[shaft.order]).map_err(BuildError::Order)?;
            if let Some(index) = shaft.coefficient_of {
                let cylinder = engine.cylinders().get(index).ok_or(BuildError::NoSuchCylinder(index))?;
                if engine.speed_of(cylinder) != 1 {
                    return Err(BuildError::FasterCrank(
                        "a shaft with the coefficient of a cylinder on the faster one",
                    ));
                }
            }
        }
        if let Some(torsion) = engine.torsion() {
            engine.pin_speeds().and_then(|pins| torsion.check(&pins)).map_err(BuildError::Torsion)?;
        }
        if engine.firing().is_some() && engine.faster_crank().is_some() {
            return Err(BuildError::FasterCrank("a firing order"));
        }
        if let Some(firing) = engine.firing() {
            let fired: BTreeSet<usize> = firing.shots.iter().map(|shot| shot.cylinder).collect();
            let cylinders = engine.firing_pistons();
            if firing.shots.len() != cylinders.len() || !fired.into_iter().eq(cylinders) {
                return Err(BuildError::Firing);
            }
        }
        Ok(engine)
    }
}

impl Draft<Linear, Linear> {
    /// The family, if all of it fits together.
    ///
    /// # Errors
    /// The first thing that does not fit.
    pub fn build(self) -> Result<Family, BuildError> {
        let family = self.checked()?;
        family.only_rods().map_err(|with| BuildError::OfRodsAlone(with, "an engine with open angles or lengths"))?;
        match family.faster_crank() {
            None => Ok(family),
            Some(_) => Err(BuildError::FasterCrank("open angles or lengths")),
        }
    }
}
