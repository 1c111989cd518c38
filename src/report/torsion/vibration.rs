//! What does the damped shaft do, at a speed, at a resonance and with another damper?

use std::f64::consts::TAU;

use num_complex::Complex;

use crate::engine::CycleOrder;
use crate::torsion::{DamperInMode, DamperSetting, Heat, Resonance, half_range};

/// The range of the formula around a critical speed.
#[derive(Clone, Debug)]
pub struct Barred {
    /// Its ends in revolutions a minute.
    pub speeds: [f64; 2],
    /// Whether the stresses are permitted again at both ends, as far as they are in the range that is asked for.
    pub suffices: bool,
    /// The order with the largest part of the torque at the critical speed, in the shaft whose stress is farthest above its limit.
    pub largest_part: CycleOrder,
}

/// An order of the vibration at a speed.
#[derive(Clone, Debug)]
pub struct VibrationOrder {
    /// The order κ.
    pub order: CycleOrder,
    /// Its frequency in oscillations a second.
    pub hertz: f64,
    /// The twist of each disc, then of the rings, in radians.
    pub twists: Vec<Complex<f64>>,
    /// The torque in each shaft, then in the dampers, in newton-metres.
    pub torques: Vec<Complex<f64>>,
    /// The torque in the teeth of each gear, as its first disc feels it, in newton-metres.
    pub meshes: Vec<Complex<f64>>,
    /// The power that becomes heat.
    pub heat: Heat,
}

/// The vibration at a speed, all orders.
#[derive(Clone, Debug)]
pub struct Vibration {
    /// The speed in revolutions a minute.
    pub speed: f64,
    /// The orders of the torque, rising.
    pub orders: Vec<VibrationOrder>,
}

impl Vibration {
    /// The torque in a shaft of all orders together, half its range.
    pub fn torque(&self, link: usize) -> f64 {
        half_range(&self.orders.iter().map(|one| (one.order, one.torques[link])).collect::<Vec<_>>())
    }

    /// The torque in the teeth of a gear, as its first disc feels it, of all orders together, half its range.
    pub fn mesh(&self, gear: usize) -> f64 {
        half_range(&self.orders.iter().map(|one| (one.order, one.meshes[gear])).collect::<Vec<_>>())
    }

    /// The twist of a disc of all orders together, half its range, in radians.
    pub fn twist(&self, disc: usize) -> f64 {
        half_range(&self.orders.iter().map(|one| (one.order, one.twists[disc])).collect::<Vec<_>>())
    }

    /// The heat of all orders in what damps: its place with its power in watts.
    pub fn heat(&self) -> Heat {
        let sum = |of: &dyn Fn(&Heat) -> &Vec<f64>| -> Vec<f64> {
            let count = self.orders.first().map_or(0, |one| of(&one.heat).len());
            (0..count).map(|index| self.orders.iter().map(|one| of(&one.heat)[index]).sum()).collect()
        };
        Heat { discs: sum(&|heat| &heat.discs), links: sum(&|heat| &heat.links) }
    }
}

/// The vibration at a speed in short, each value half the range of all orders together.
#[derive(Clone, Debug)]
pub struct TwistAtSpeed {
    /// The speed in revolutions a minute.
    pub speed: f64,
    /// The twist of the first disc in radians.
    pub first: f64,
    /// The torque in each shaft in newton-metres.
    pub torques: Vec<f64>,
    /// The torque in the teeth of each gear, as its first disc feels it.
    pub meshes: Vec<f64>,
}

/// An order at a natural frequency.
#[derive(Clone, Debug)]
pub struct ResonanceOrder {
    /// The mode, from 0.
    pub mode: usize,
    /// The order κ.
    pub order: CycleOrder,
    /// The critical speed in revolutions a minute.
    pub rpm: f64,
    /// By the energy method.
    pub energy: Resonance,
    /// Whether the first disc is a node of the mode.
    pub first_is_node: bool,
    /// Amplitude of the first disc there, with damping, in radians.
    pub first: f64,
    /// The shaft with the largest torque there, from 0.
    pub shaft: usize,
    /// That torque in newton-metres.
    pub torque: f64,
    /// Where the largest torque of this order near it is: the speed and the torque; none where it has no peak there.
    pub peak: Option<(f64, f64)>,
    /// The largest torque of this order in the range, near it: that at the peak where the peak is in the range, else at the critical speed.
    pub largest: LargestTorque,
    /// What IACS UR M68 bars around it, where a stress of all orders is larger there than permitted.
    pub barred: Option<Barred>,
    /// Whether the stress is above the limit where no range may be barred, from 80 % of the rated speed on.
    pub is_unbarred: bool,
}

impl ResonanceOrder {
    /// A deflection of the mode by the energy method, at the first disc.
    pub(super) fn at_first(&self, deflection: f64) -> f64 {
        if self.first_is_node { 0.0 } else { deflection }
    }
}

/// The largest torque of an order, with its place.
#[derive(Clone, Debug)]
pub struct LargestTorque {
    /// The order κ.
    pub order: CycleOrder,
    /// The speed in revolutions a minute.
    pub rpm: f64,
    /// The shaft, from 0.
    pub shaft: usize,
    /// The torque in newton-metres.
    pub torque: f64,
}

/// Speeds at which the vibration stress of a shaft is larger than is permitted for continuous running.
#[derive(Clone, Debug)]
pub struct Excess {
    /// The shaft, from 0.
    pub shaft: usize,
    /// The speeds in revolutions a minute.
    pub speeds: [f64; 2],
}

/// A damper and its best settings.
#[derive(Clone, Debug)]
pub struct DamperStudy {
    /// In the first mode, with the formula's setting.
    pub in_mode: DamperInMode,
    /// Its setting.
    pub setting: DamperSetting,
    /// What a search finds, where a torque excites the first mode and the disc moves in it.
    pub found: Option<FoundDamper>,
}

/// The best setting by a search.
#[derive(Clone, Debug)]
pub struct FoundDamper {
    /// The order with the most work in the first mode of those that meet it in the range, for which it is looked for.
    pub order: CycleOrder,
    /// The setting.
    pub best: DamperSetting,
    /// The largest torque in a shaft by this order near the first mode: with the best setting, with that of the layout.
    pub peaks: [f64; 2],
    /// The same without dampers; none where nothing else damps the mode, and it has no bound.
    pub without: Option<f64>,
}

/// Where vibration becomes heat: each by its number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeatPlace {
    /// At a disc that is held back.
    Disc(usize),
    /// In a shaft.
    Shaft(usize),
    /// In a damper.
    Damper(usize),
}

pub(super) fn omega(order: CycleOrder, speed: f64) -> f64 {
    TAU * order.hertz(speed)
}
