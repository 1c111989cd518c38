//! Do the links of an engine hang on its rods, and is nothing asked of it that links have no numbers for?

use super::build_error::{BuildError, not_negative};
use super::crankshaft::Balancer;
use super::model::Engine;

/// Each link hangs on a master rod, and nothing is asked of the engine that links have no numbers for.
pub(super) fn check(engine: &Engine) -> Result<(), BuildError> {
    for cylinder in engine.cylinders() {
        if cylinder.link().is_none() {
            not_negative(&-&cylinder.knuckle_mass, || format!("minus the knuckle mass of cylinder {}", cylinder.name))?;
            continue;
        }
        if !engine.cylinders().iter().any(|other| other.is_master_of(cylinder)) {
            return Err(BuildError::NoMaster { cylinder: cylinder.name.clone() });
        }
    }
    let of_link = |shaft: &Balancer| {
        let cylinder = shaft.coefficient_of.and_then(|index| engine.cylinders().get(index));
        cylinder.is_some_and(|cylinder| cylinder.link().is_some())
    };
    let effects = engine.effects();
    let has_links = engine.has_links();
    let asked = [
        (effects.torque && !engine.has_judged_torque(), "the exact inertia torque, \"torque\" in effects,"),
        (has_links && !engine.geared_cranks().is_empty(), "several crankshafts"),
        (
            engine.crankshaft().balancers.iter().any(of_link),
            "a shaft with the coefficient of a link, which has several,",
        ),
    ];
    match asked.into_iter().find(|(is_asked, _)| *is_asked) {
        Some((_, what)) => Err(BuildError::ArticulatedRods(what)),
        None => Ok(()),
    }
}
