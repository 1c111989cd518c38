//! Which cylinders are equal, but for when they fire and what their pistons weigh?

use num_rational::BigRational;
use num_traits::Zero;

use super::bodies::{self, Bodies, HIGHEST, Inertia};
use crate::engine::Engine;
use crate::gas::{CylinderGas, Harmonics, NoGas, Warning};
use crate::loads::Missing;

/// Cylinders of one crank, rod, bore and pressure: their gas is the same, and the inertia of their pistons in proportion to their masses.
#[derive(Clone, Debug)]
pub struct Class {
    /// The gas of each.
    pub gas: CylinderGas,
    /// Its harmonics.
    pub harmonics: Harmonics,
    /// The inertia of a piston whose mass is 1 in the engine's multiples; none where mass or speed is not known.
    pub inertia: Option<Inertia>,
    /// Which cylinders, by index.
    pub cylinders: Vec<usize>,
    /// The crank angle θ at which each fires, in turns of the cycle.
    pub fires: Vec<BigRational>,
    /// The mass of each piston in those multiples: [`crate::engine::Cylinder::reciprocating_mass`].
    pub masses: Vec<BigRational>,
}

/// The crank angle θ at which each piston is at the dead centre at which its cylinder fires, in turns of the cycle, from that of the first
/// cylinder to fire: in the first revolution, unless the file says which it is.
fn fires(engine: &Engine) -> Result<Vec<BigRational>, Missing> {
    let cylinders = engine.cylinders();
    let top = |index: usize| cylinders[index].top_dead_centre().turns().clone();
    if engine.faster_crank().is_some() {
        return Err(Missing::FasterCrank("the torque of the gas"));
    }
    let Some(firing) = engine.firing() else {
        // A cylinder alone fires at its dead centre.
        return match engine.firing_pistons().as_slice() {
            [only] => Ok((0..cylinders.len()).map(|index| top(*only) + behind(engine, index)).collect()),
            _ => Err(Missing::Firing),
        };
    };
    let first = firing.shots.first().map_or_else(|| top(0), |shot| top(shot.cylinder) + &firing.first_revolution);
    let mut angles = vec![first.clone(); cylinders.len()];
    for shot in &firing.shots {
        angles[shot.cylinder] = &first + &shot.angle;
        if let Some(partner) = engine.partner(shot.cylinder) {
            angles[partner] = &first + &shot.angle + behind(engine, partner);
        }
    }
    Ok(angles)
}

/// By how much a piston comes to its dead centre after the first one of its cylinder, in turns.
fn behind(engine: &Engine, index: usize) -> BigRational {
    engine.lead(index).filter(|_| engine.is_second_piston(index)).map_or_else(BigRational::zero, |lead| -lead)
}

/// The classes of equal cylinders, in the order of their first ones.
///
/// # Errors
/// What the layout lacks.
pub fn classes(engine: &Engine) -> Result<Vec<Class>, Missing> {
    up_to(engine, HIGHEST)
}

/// Those with harmonics up to this order.
///
/// # Errors
/// What the layout lacks.
pub fn up_to(engine: &Engine, highest: u32) -> Result<Vec<Class>, Missing> {
    let Some(gas) = engine.gas() else { return Err(NoGas::Gas.into()) };
    let fires = fires(engine)?;
    let inertias = bodies::up_to(engine, highest);
    let cylinders = engine.cylinders();
    let moves_alike = |one: usize, other: usize| {
        let (a, b) = (&cylinders[one], &cylinders[other]);
        a.mechanism == b.mechanism && a.crank_radius == b.crank_radius
    };
    let faces_alike = |one: usize, other: usize| match (engine.partner(one), engine.partner(other)) {
        (None, None) => true,
        (Some(a), Some(b)) => engine.lead(one) == engine.lead(other) && moves_alike(a, b),
        (None, Some(_)) | (Some(_), None) => false,
    };
    let is_alike = |one: usize, other: usize| {
        gas.chambers[one] == gas.chambers[other] && moves_alike(one, other) && faces_alike(one, other)
    };
    let mut classes: Vec<Class> = Vec::new();
    for (index, fires) in fires.into_iter().enumerate() {
        match classes.iter_mut().find(|class| is_alike(class.cylinders[0], index)) {
            Some(class) => {
                class.cylinders.push(index);
                class.fires.push(fires);
                class.masses.push(cylinders[index].reciprocating_mass.clone());
            }
            None => {
                let gas = CylinderGas::new(engine, index)?;
                let harmonics = gas.harmonics((highest * gas.revolutions()) as usize);
                let own = |one: &&Bodies| one.is_of_pistons && one.cylinders.contains(&index);
                let inertia = inertias.iter().find(own).and_then(|one| one.inertia.clone());
                classes.push(Class {
                    gas,
                    harmonics,
                    inertia,
                    cylinders: vec![index],
                    fires: vec![fires],
                    masses: vec![cylinders[index].reciprocating_mass.clone()],
                });
            }
        }
    }
    Ok(classes)
}

/// What is odd about the pressures, by class.
pub fn warnings(engine: &Engine, classes: &[Class]) -> Vec<(usize, Warning)> {
    let (Some(gas), Some(cycle)) = (engine.gas(), engine.cycle()) else { return Vec::new() };
    let of_class = |(index, class): (usize, &Class)| {
        let law = &gas.laws[gas.chambers[class.cylinders[0]].law];
        class.gas.warnings(law, cycle).into_iter().map(move |warning| (index, warning)).collect::<Vec<_>>()
    };
    // What a cylinder does that was kept from firing is as it should be, and what two pistons share is told once.
    let fires = |(_, class): &(usize, &Class)| {
        engine.misfire() != Some(class.cylinders[0]) && !engine.is_second_piston(class.cylinders[0])
    };
    classes.iter().enumerate().filter(fires).flat_map(of_class).collect()
}
