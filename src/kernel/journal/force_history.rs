//! Which forces act at a crank angle: on piston, wall, rod and crankpin of each cylinder, and on what carries them?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::carried::{Carried, turns_of};
use crate::engine::{self, Engine};
use crate::gas::Harmonics;
use crate::loads::HungRod;
use crate::numbers;
use crate::order;
use crate::torque::Class;

/// The forces over the crank angle θ, in radians and newtons.
#[derive(Clone, Debug)]
pub struct ForceHistory {
    classes: Vec<Class>,
    cylinders: Vec<Cylinder>,
    period: f64,
}

#[derive(Clone, Debug)]
struct Cylinder {
    class: usize,
    /// Where it fires, in radians of the cycle.
    fires: f64,
    /// The mass of its piston in multiples of the engine's.
    mass: f64,
    /// The direction of its axis.
    axis: Complex<f64>,
    /// That of its crankpin at θ = 0.
    throw: Complex<f64>,
    /// How many times its crank turns while the reference turns once; below 0 against it.
    turns: f64,
    /// What it does by its master rod, where its rod is a link.
    hung: Option<Hung>,
    /// What the rotating part of its rod pulls the pin outward with.
    rotating: f64,
}

/// A link, with what `m r ω²` of its piston is, and of the engine, in newtons.
#[derive(Clone, Debug)]
struct Hung {
    rod: HungRod,
    piston: f64,
    unit: f64,
}

/// The forces along and across the axis of one cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PistonForces {
    /// F_g: of the gas on the piston, towards the crank; the head feels the opposite.
    pub gas: f64,
    /// F_in: of the inertia of the reciprocating mass, outward.
    pub inertia: f64,
    /// tan β, the slope of the rod.
    pub slope: f64,
}

impl PistonForces {
    /// The piston effort `F = F_g − F_in`, towards the crank.
    pub fn effort(&self) -> f64 {
        self.gas - self.inertia
    }

    /// The side force `F tan β` of the wall on the piston, a quarter turn anticlockwise from the axis outward.
    pub fn side(&self) -> f64 {
        self.effort() * self.slope
    }

    /// The force `F/cos β` along the rod: positive where it is pressed.
    pub fn rod(&self) -> f64 {
        self.effort() * self.slope.hypot(1.0)
    }

    /// The direction from the crankpin to the piston, in the frame of the axis: `cos β − i sin β`.
    fn rod_direction(&self) -> Complex<f64> {
        Complex::new(1.0, -self.slope) / self.slope.hypot(1.0)
    }

    /// What a force towards the crank loads the pin of the rod with, in the frame of the axis.
    fn on_the_pin(&self, effort: f64) -> Complex<f64> {
        -effort * Complex::new(1.0, -self.slope)
    }
}

impl ForceHistory {
    pub(super) fn new(engine: &Engine, classes: Vec<Class>, newtons: f64) -> Self {
        let fires = |index: usize| {
            classes.iter().enumerate().find_map(|(class, of)| {
                let place = of.cylinders.iter().position(|&cylinder| cylinder == index)?;
                Some((class, numbers::float(&of.fires[place]) * TAU))
            })
        };
        let rods = HungRod::all(engine);
        let hung = |index: usize| {
            let rod = rods.iter().find(|rod| rod.cylinder == index)?.clone();
            let piston = numbers::float(&order::mass_radius(engine, &engine.cylinders()[index])) * newtons;
            Some(Hung { rod, piston, unit: newtons })
        };
        let mass = |cylinder: &engine::Cylinder| numbers::float(&cylinder.reciprocating_mass);
        let cylinders = engine.cylinders().iter().enumerate().map(|(index, cylinder)| {
            let Some((class, fires)) = fires(index) else { unreachable!("every cylinder belongs to a class") };
            let [axis, throw] = [&cylinder.bank, &engine.pin_angle(cylinder)].map(numbers::direction);
            let turns = turns_of(engine, cylinder.crank);
            let rotating = numbers::float(&order::big_end(engine, cylinder)) * newtons * turns * turns;
            let (mass, hung) = (mass(cylinder), hung(index));
            Cylinder { class, fires, mass, axis, throw, turns, rotating, hung }
        });
        let cylinders = cylinders.collect();
        ForceHistory { cylinders, period: classes.first().map_or(TAU, |class| class.gas.period()), classes }
    }

    /// Length of the cycle in radians.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// How many cylinders there are.
    pub fn cylinders(&self) -> usize {
        self.cylinders.len()
    }

    /// The classes of equal cylinders.
    pub fn classes(&self) -> &[Class] {
        &self.classes
    }

    /// Cylinders, by index, whose crankpins feel the same seen from the crank, each when it fires.
    pub fn alike(&self) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (index, cylinder) in self.cylinders.iter().enumerate() {
            let felt = |one: &Cylinder| (one.class, one.mass, one.rotating, one.turns);
            let is_alike = |other: &Cylinder| felt(other) == felt(cylinder);
            match groups.iter_mut().find(|group| is_alike(&self.cylinders[group[0]])) {
                Some(group) => group.push(index),
                None => groups.push(vec![index]),
            }
        }
        groups
    }

    /// Angles at which the pressure of some cylinder has a kink.
    pub(super) fn kinks(&self) -> impl Iterator<Item = f64> {
        self.cylinders
            .iter()
            .flat_map(|cylinder| self.classes[cylinder.class].gas.kinks().map(|psi| psi + cylinder.fires))
    }

    /// The direction of the axis of a cylinder.
    pub(super) fn axis(&self, index: usize) -> Complex<f64> {
        self.cylinders[index].axis
    }

    /// The forces in a cylinder, by its index.
    pub fn forces(&self, index: usize, theta: f64) -> PistonForces {
        self.forces_with(index, theta, |class, psi| class.gas.force(psi))
    }

    fn forces_with(&self, index: usize, theta: f64, gas: impl Fn(&Class, f64) -> f64) -> PistonForces {
        let cylinder = &self.cylinders[index];
        let class = &self.classes[cylinder.class];
        let psi = theta - cylinder.fires;
        let gas = gas(class, psi);
        match &cylinder.hung {
            Some(hung) => {
                PistonForces { gas, inertia: -hung.piston * hung.rod.acceleration(theta), slope: hung.rod.slope(theta) }
            }
            None => PistonForces {
                gas,
                inertia: class.inertia.as_ref().map_or(0.0, |inertia| cylinder.mass * inertia.force(psi)),
                // The rod of a crank that turns against the reference stands as that of the equivalent crank in a mirror.
                slope: class.gas.geometry().slope(psi) * cylinder.turns.signum(),
            },
        }
    }

    /// What the knuckle pin of a link feels, seen from the engine: of the masses, and of the gas; none where the rod is on the crankpin.
    pub fn knuckle_parts(&self, index: usize, theta: f64) -> Option<[Complex<f64>; 2]> {
        self.knuckle_parts_of(index, theta, self.forces(index, theta))
    }

    fn knuckle_parts_of(&self, index: usize, theta: f64, forces: PistonForces) -> Option<[Complex<f64>; 2]> {
        let Hung { rod, unit, .. } = self.cylinders[index].hung.as_ref()?;
        Some([rod.on_the_knuckle(theta, forces.inertia, *unit), rod.on_the_knuckle(theta, -forces.gas, 0.0)])
    }

    /// The same of the masses alone, for which no pressure is found.
    pub(super) fn knuckle_of_inertia(&self, index: usize, theta: f64) -> Option<Complex<f64>> {
        let still = self.forces_with(index, theta, |_, _| 0.0);
        self.knuckle_parts_of(index, theta, still).map(|[inertia, _]| inertia)
    }

    /// The direction from the crankpin to the knuckle pin of a link.
    pub fn knuckle_direction(&self, index: usize, theta: f64) -> Option<Complex<f64>> {
        self.cylinders[index].hung.as_ref().map(|hung| hung.rod.outward(theta))
    }

    /// The cylinder whose rod a link hangs on.
    pub fn master_of(&self, index: usize) -> Option<usize> {
        self.cylinders[index].hung.as_ref().map(|hung| hung.rod.master)
    }

    /// The cylinders whose links hang on a rod.
    pub fn links_of(&self, index: usize) -> impl Iterator<Item = usize> {
        (0..self.cylinders.len()).filter(move |&link| self.master_of(link) == Some(index))
    }

    /// The side force of the wall on a piston in which these forces act, a quarter turn anticlockwise from the axis outward: on a master's with
    /// what its links put on it.
    pub fn side_of(&self, index: usize, theta: f64, forces: PistonForces) -> f64 {
        let of_link = |link: usize| {
            let hung = self.cylinders[link].hung.as_ref();
            let load = self.knuckle_parts(link, theta).map_or_else(Complex::default, |[inertia, gas]| inertia + gas);
            hung.map_or(0.0, |hung| hung.rod.side(theta, load))
        };
        forces.side() + self.links_of(index).map(of_link).sum::<f64>()
    }

    /// What a rod loads its crankpin with, seen from the engine: of the masses, and of the gas.
    pub fn pin_parts(&self, index: usize, theta: f64) -> [Complex<f64>; 2] {
        self.pin_parts_of(index, theta, self.forces(index, theta))
    }

    pub(super) fn pin_parts_of(&self, index: usize, theta: f64, forces: PistonForces) -> [Complex<f64>; 2] {
        let cylinder = &self.cylinders[index];
        if let (Some(hung), Some(knuckle)) = (&cylinder.hung, self.knuckle_parts_of(index, theta, forces)) {
            return knuckle.map(|load| hung.rod.on_the_crankpin(theta, load));
        }
        let rotating = cylinder.throw * Complex::cis(cylinder.turns * theta) * cylinder.rotating;
        let on_the_pin = |effort: f64| forces.on_the_pin(effort) * cylinder.axis;
        [on_the_pin(-forces.inertia) + rotating, on_the_pin(forces.gas)]
    }

    /// The part of the masses alone, for which no pressure is found.
    pub(super) fn pin_of_inertia(&self, index: usize, theta: f64) -> Complex<f64> {
        let still = self.forces_with(index, theta, |_, _| 0.0);
        self.pin_parts_of(index, theta, still)[0]
    }

    /// What a rod loads its crankpin with, seen from the engine.
    pub fn pin(&self, index: usize, theta: f64) -> Complex<f64> {
        let [inertia, gas] = self.pin_parts(index, theta);
        inertia + gas
    }

    /// The same seen from the crank: the real part is outward along the throw, the imaginary part in the sense of rotation.
    pub fn pin_on_the_crank(&self, index: usize, theta: f64) -> Complex<f64> {
        self.seen_from_the_crank(index, self.pin(index, theta), theta)
    }

    /// A force seen from the crank of a cylinder.
    pub(super) fn seen_from_the_crank(&self, index: usize, force: Complex<f64>, theta: f64) -> Complex<f64> {
        let cylinder = &self.cylinders[index];
        force * (cylinder.throw * Complex::cis(cylinder.turns * theta)).conj()
    }

    /// The pull of the big end on its pin along the rod, towards the piston, in which these forces act: the bolts of its cap bear it, less what
    /// the cap itself makes. A master rod pulls with all its links, a link on its knuckle pin.
    pub fn pull_of(&self, index: usize, theta: f64, forces: PistonForces) -> f64 {
        let along = forces.rod_direction() * self.cylinders[index].axis;
        let own = self.knuckle_parts_of(index, theta, forces);
        let [inertia, gas] = own.unwrap_or_else(|| self.pin_parts_of(index, theta, forces));
        let of_links: Complex<f64> = self.links_of(index).map(|link| self.pin(link, theta)).sum();
        ((inertia + gas + of_links) * along.conj()).re
    }

    /// Order κ of the gas of what a place carries, with the harmonics of each class at their index: what turns with the crank, and against
    /// it. In decimals: [`super::JournalOrder`] has the exact stars.
    pub(super) fn gas_order(
        &self,
        carried: &Carried,
        harmonics: &[Harmonics],
        index: usize,
        kappa: f64,
    ) -> [Complex<f64>; 2] {
        let zero = Complex::new(0.0, 0.0);
        self.cylinders.iter().zip(&carried.parts).fold([zero, zero], |[direct, reverse], (cylinder, part)| {
            let own = &harmonics[cylinder.class];
            let (force, side) = (own.force[index], own.side[index] * cylinder.turns.signum());
            let along = cylinder.axis * (-part / 2.0);
            let turned = Complex::cis(kappa * cylinder.fires);
            [
                direct + along * (force - Complex::<f64>::i() * side) * turned.conj(),
                reverse + along * (force.conj() - Complex::<f64>::i() * side.conj()) * turned,
            ]
        })
    }

    /// What a place carries of masses and of gas.
    pub fn carried_parts(&self, carried: &Carried, theta: f64) -> [Complex<f64>; 2] {
        let shaft = [carried.of_shaft(theta), Complex::new(0.0, 0.0)];
        let loads = carried.parts.iter().enumerate().filter(|(_, part)| **part != 0.0);
        carried.left(loads.fold(shaft, |[inertia, gas], (index, part)| {
            let [of_inertia, of_gas] = self.pin_parts(index, theta);
            [inertia + of_inertia * part, gas + of_gas * part]
        }))
    }

    /// What it carries of the masses alone.
    pub(super) fn carried_of_inertia(&self, carried: &Carried, theta: f64) -> Complex<f64> {
        let loads = carried.parts.iter().enumerate().filter(|(_, part)| **part != 0.0);
        let shaft = carried.of_shaft(theta);
        let all = loads.fold(shaft, |sum, (index, part)| sum + self.pin_of_inertia(index, theta) * part);
        carried.left([all, Complex::default()])[0]
    }

    /// What a place carries of all forces.
    pub fn carried(&self, carried: &Carried, theta: f64) -> Complex<f64> {
        let [inertia, gas] = self.carried_parts(carried, theta);
        inertia + gas
    }
}
