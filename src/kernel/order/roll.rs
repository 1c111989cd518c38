//! Which terms does each source add to an order of the roll moment on the frame?
//!
//! About the middle of the engine, in multiples of m r² ω² (theory, section 14): the force `f = Re Σ c_k e^{ik(θ+β−α)}` of a piston
//! acts along a line that passes at an arm, and the torque T on its crank turns the frame with −T,
//!
//! `Re Σ_k e^{ikθ} (arm · c_k − s t_k) e^{ik(β−α)}`, s = ±1 for a crank that turns with or against the reference.
//!
//! The arm of a line whose crankshaft is at distance d in the direction η is `d sin(α−η)`, two vectors of half the length:
//! `d/2 (e^{i(α−η−90°)} + e^{−i(α−η−90°)})`. An offset e adds −e. A mass-radius U that turns about such an axis at n times the crank
//! speed adds `n²Ud e^{i(γ−η−90°)}` with the crank, `n²Ud e^{−i(γ−η−90°)}` against it. What a piston adds whose crank turns ν times as fast
//! is ν² times as large, at ν times the order.

use num_rational::BigRational;
use num_traits::Zero;

use super::contribution::{Contribution, Sources, power};
use super::factor::Factor;
use super::phase::phase;
use super::source::Source;
use super::turning::{mass_radius, of_turning};
use crate::engine::{Cylinder, Engine};
use crate::exact::{Term, Turn};

impl Sources<'_> {
    /// What each source adds to the roll moment of one order.
    pub fn of_roll(&self, order: u32) -> Vec<Contribution> {
        let pistons = self.cylinders_with(order).flat_map(|(index, cylinder, own)| {
            let terms = of_cylinder(self.engine(), cylinder, own).into_iter();
            terms.map(move |(factor, term)| Contribution {
                source: Source::Piston(index),
                position: cylinder.position.clone(),
                factor,
                term,
            })
        });
        let turning = self.turning().iter().filter(|mass| mass.order == order).flat_map(|mass| {
            mass.axis.iter().map(move |axis| Contribution {
                source: mass.source,
                position: mass.position.clone(),
                factor: mass.factor.clone(),
                term: of_turning(mass, axis),
            })
        });
        pistons.chain(turning).collect()
    }
}

/// Of the order of its own motion.
fn of_cylinder(engine: &Engine, cylinder: &Cylinder, order: u32) -> Vec<(Factor, Term)> {
    let star = phase(cylinder, order, None);
    let speed = engine.speed_of(cylinder);
    let weight = mass_radius(engine, cylinder) * power(speed, 2);
    let of_arm = |arm: Term| {
        let parts = Factor::parts_of_force(engine, cylinder.mechanism.as_ref(), order).into_iter();
        let part = |(factor, part): (Factor, Term)| {
            let angle = &(&star + &part.angle) + &arm.angle;
            (factor.geared(speed), Term { angle, weight: &weight * &part.weight * &arm.weight })
        };
        parts.map(part).collect::<Vec<_>>()
    };
    let arms = arms(engine, cylinder).into_iter().flat_map(of_arm);
    let turned = engine.sense_of(cylinder).signed(-&weight * &cylinder.crank_radius);
    let torque = Term { angle: star.clone(), weight: turned };
    arms.chain([(Factor::of_torque(cylinder.mechanism.as_ref()).geared(speed), torque)]).collect()
}

/// The arm of a cylinder's axis about the middle of the engine, in crank radii, as a sum of vectors.
fn arms(engine: &Engine, cylinder: &Cylinder) -> Vec<Term> {
    let half = BigRational::new(1.into(), 2.into());
    let mut arms = Vec::new();
    for axis in engine.crank_of(cylinder).into_iter().flat_map(|crank| &crank.axis) {
        // Its cosine is the sine of α − η.
        let turned = &(&cylinder.bank - &axis.angle) - &Turn::fraction(1, 4);
        let weight = axis.weight.clone();
        if turned == Turn::zero() || turned == Turn::fraction(1, 2) {
            arms.push(Term { angle: turned, weight });
        } else if turned != Turn::fraction(1, 4) && turned != Turn::fraction(3, 4) {
            arms.push(Term { angle: -&turned, weight: &weight * &half });
            arms.push(Term { angle: turned, weight: weight * &half });
        }
    }
    if let Some(rod) = cylinder.rod().filter(|rod| !rod.offset.is_zero() && !rod.ratio.is_zero()) {
        let offset = &rod.offset / &rod.ratio * &cylinder.crank_radius;
        // The rod of a crank that turns against the reference is that of the equivalent crank, which lies on the other side.
        arms.push(Term { angle: Turn::zero(), weight: engine.sense_of(cylinder).signed(-offset) });
    }
    arms
}
