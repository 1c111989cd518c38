//! How far does each order of the torque twist the shaft at the speed of the layout? Without damping, away from critical speeds.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::TorsionStudy;
use crate::engine::CycleOrder;
use crate::numbers;
use crate::torque;
use crate::torsion::{Excitation, Shaft, forced_twist};

/// Nearer to a natural frequency than this part of it, an undamped shaft says nothing of a real one.
const NEAR: f64 = 0.05;

/// What one order does to the shaft.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedTwist {
    /// The order κ.
    pub order: CycleOrder,
    /// Its frequency in oscillations a second.
    pub hertz: f64,
    /// The mode that it is too near to, by its number from 1.
    pub near: Option<usize>,
    /// How far the free end swings, in degrees, zero to peak.
    pub free_end: f64,
    /// The largest torque that it makes in the shaft, in newton-metres, zero to peak.
    pub shaft: f64,
    /// Behind which disc that is, by its number from 1.
    pub behind: usize,
}

/// The orders of a study at a speed; none where the layout lacks what the torque needs.
pub(super) fn forced(study: &TorsionStudy, speed: f64) -> Vec<ForcedTwist> {
    let TorsionStudy { engine, modes, .. } = study;
    let torsion = study.torsion();
    let Ok(classes) = torque::classes(engine) else { return Vec::new() };
    if speed <= 0.0 {
        return Vec::new();
    }
    let shaft = Shaft::new(torsion);
    let of_order = |order: CycleOrder| {
        let hertz = f64::from(order.halves()) / 2.0 * speed / 60.0;
        let mut torques = vec![Complex::default(); shaft.inertias.len()];
        for class in &classes {
            for (place, (&cylinder, fires)) in class.cylinders.iter().zip(&class.fires).enumerate() {
                torques[torsion.pins[engine.cylinders()[cylinder].pin]] +=
                    class.torque_of_one(place, order) * numbers::direction(&order.phase(fires));
            }
        }
        let twist = forced_twist(&shaft, &Excitation { omega: TAU * hertz, torques });
        let between = shaft.stiffnesses.iter().zip(twist.windows(2));
        let loads: Vec<f64> = between.map(|(stiffness, pair)| stiffness * (pair[1] - pair[0]).norm()).collect();
        let largest = (0..loads.len()).max_by(|one, other| loads[*one].total_cmp(&loads[*other])).unwrap_or(0);
        ForcedTwist {
            order,
            hertz,
            near: modes.iter().position(|speeds| (hertz / speeds.mode.hertz() - 1.0).abs() < NEAR).map(|mode| mode + 1),
            free_end: twist.first().map_or(0.0, |twist| twist.norm().to_degrees()),
            shaft: loads.get(largest).copied().unwrap_or_default(),
            behind: largest + 1,
        }
    };
    modes.first().map_or_else(Vec::new, |first| first.orders.iter().map(|critical| of_order(critical.order)).collect())
}
