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
            return Err(BuildError::NoMaster(cylinder.name.clone()));
        }
    }
    let has_several = |shaft: &Balancer| {
        let cylinder = shaft.coefficient_of.and_then(|index| engine.cylinders().get(index));
        cylinder.and_then(|one| one.mechanism.as_ref()).is_some_and(|one| !one.has_one_vector_per_order())
    };
    let torque = engine.effects().torque && !engine.has_judged_torque();
    let shaft = engine.crankshaft().balancers.iter().any(has_several);
    let asked = [
        (torque, "the exact inertia torque, \"torque\" in effects,"),
        (!engine.geared_cranks().is_empty(), "several crankshafts"),
        (shaft, "a shaft with the coefficient of a cylinder that has several"),
    ];
    let what = asked.into_iter().find(|(is_asked, _)| *is_asked);
    what.map_or(Ok(()), |(_, what)| engine.only_rods().map_err(|with| BuildError::OfRodsAlone(with, what)))
}
