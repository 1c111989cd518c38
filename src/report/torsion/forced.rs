//! How far does each order of the torque twist the shaft at the speed of the layout? Without damping, away from critical speeds alone.

use super::damped::largest;
use super::study::TorsionStudy;
use super::vibration::omega;
use crate::engine::CycleOrder;
use crate::torsion::{CriticalSpeeds, shaft_torques};

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
    /// In which shaft, from 0.
    pub shaft_number: usize,
}

impl TorsionStudy {
    /// How far the orders twist the shaft at the speed of the layout; none where it lacks what the torque needs.
    pub fn forced(&self) -> Vec<ForcedTwist> {
        self.speed.map_or_else(Vec::new, |speed| forced(self, speed))
    }

    /// Behind which disc the shaft with the largest torque is, by its number from 1.
    pub(super) fn behind(&self, twist: &ForcedTwist) -> usize {
        self.torsion().shafts.get(twist.shaft_number).map_or(0, |shaft| shaft.ends[0]) + 1
    }
}

/// The orders of a study at a speed; none where the layout lacks what the torque needs.
pub(super) fn forced(study: &TorsionStudy, speed: f64) -> Vec<ForcedTwist> {
    let (modes, train) = (&study.modes, &study.train);
    if study.excited().is_none() || speed <= 0.0 {
        return Vec::new();
    }
    let is_damped = study.torsion().is_damped();
    let of_order = |order: CycleOrder| {
        let hertz = order.hertz(speed);
        let twist = study.twists(train, order, speed)?;
        let (shaft_number, shaft) = largest(&shaft_torques(train, omega(order, speed), &twist)[..train.shafts]);
        let is_near = |mode: &CriticalSpeeds| !is_damped && (hertz / mode.mode.hertz() - 1.0).abs() < NEAR;
        Some(ForcedTwist {
            order,
            hertz,
            near: modes.iter().position(is_near).map(|mode| mode + 1),
            free_end: twist.first().map_or(0.0, |twist| twist.norm().to_degrees()),
            shaft,
            shaft_number,
        })
    };
    let shown = modes.first().map_or(&[][..], |first| &first.orders).iter().map(|critical| critical.order);
    shown.filter_map(of_order).collect()
}
