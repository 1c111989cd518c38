//! At which speeds does an order of the firing meet a natural frequency, and how much does it work on the mode?

use num_complex::Complex;

use super::{Mode, Train, modes};
use crate::engine::{CycleOrder, Engine, Shot, Torsion};
use crate::exact::{Term, vanish_apart};
use crate::firing::{NoStar, are_orders_of, firing_of};
use crate::gas::CylinderGas;
use crate::numbers;

/// A speed at which an order has a natural frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Critical {
    /// The order κ.
    pub order: CycleOrder,
    /// The speed in revolutions a minute.
    pub rpm: f64,
    /// `Σ Δ_j r_j e^{−iκφ_j}`: the work of a torque of this order on the mode goes with its length. φ_j counts from where the file's gas does. Of two pistons in a cylinder both count when it
    /// fires, as if neither led the other. 0 where it is no longer than rounding.
    pub star: Complex<f64>,
    /// Whether the star is proved to be 0: cylinders that are turned as far in every mode have a star of 0 among themselves.
    pub vanishes: bool,
}

/// A mode with the speeds at which it is excited.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalSpeeds {
    /// The mode.
    pub mode: Mode,
    /// The deflection at each cylinder, in the sense in which its crank turns.
    pub deflections: Vec<f64>,
    /// The longest star that the mode can have: `Σ |Δ_j| r_j`.
    pub longest: f64,
    /// The orders, rising, so that the speeds fall.
    pub orders: Vec<Critical>,
}

impl CriticalSpeeds {
    /// The star of an order as a part of the longest possible; 0 where all cylinders are at rest.
    pub fn part(&self, critical: &Critical) -> f64 {
        if self.longest == 0.0 { 0.0 } else { critical.star.norm() / self.longest }
    }
}

/// A star shorter than this part of the longest possible is rounding.
const ROUNDING: f64 = 1e-12;

/// The critical speeds of each mode, for these orders.
///
/// # Errors
/// A layout that does not say when the cylinders fire, and half orders of a two-stroke engine.
pub fn critical_speeds(
    engine: &Engine,
    torsion: &Torsion,
    orders: &[CycleOrder],
) -> Result<Vec<CriticalSpeeds>, NoStar> {
    let firing = firing_of(engine)?;
    are_orders_of(firing.cycle, orders)?;
    let train = Train::new(torsion);
    // Two pistons in a cylinder count together: neither is farthest out when it fires.
    let zeros: Vec<f64> = (0..engine.cylinders().len())
        .map(|index| if engine.has_opposed_pistons() { 0.0 } else { CylinderGas::firing_zero(engine, index) })
        .collect();
    let radius = |cylinder: usize| numbers::float(&engine.cylinders()[cylinder].crank_radius);
    let disc = |cylinder: &crate::engine::Cylinder| torsion.pins[cylinder.pin];
    let vanishes = |order: &CycleOrder| {
        // Cylinders have a common factor in every mode that are on one node, at one speed, with gas from one angle on.
        let of_piston = |shot: &Shot, piston: usize| {
            let cylinder = &engine.cylinders()[piston];
            let (node, ratio) = (train.node(disc(cylinder)), train.discs[disc(cylinder)].ratio.abs());
            let term = Term { angle: order.phase(&shot.angle), weight: cylinder.crank_radius.clone() };
            ((node, ratio.to_bits(), (zeros[shot.cylinder] + 0.0).to_bits()), term)
        };
        let of_shot =
            |shot: &Shot| engine.pistons_of(shot.cylinder).map(|one| of_piston(shot, one)).collect::<Vec<_>>();
        vanish_apart(firing.shots.iter().flat_map(of_shot))
    };
    let zero: Vec<bool> = orders.iter().map(vanishes).collect();
    let of_mode = |mode: Mode| {
        let deflection = |cylinder: &crate::engine::Cylinder| mode.shape[disc(cylinder)] * train.sense(disc(cylinder));
        let deflections: Vec<f64> = engine.cylinders().iter().map(deflection).collect();
        let star = |order: CycleOrder| -> Complex<f64> {
            let vector = |shot: &Shot| {
                let after = zeros[shot.cylinder] * f64::from(order.halves()) / 2.0;
                let direction = numbers::direction(&order.phase(&shot.angle)) * Complex::from_polar(1.0, -after);
                let pistons = engine.pistons_of(shot.cylinder);
                direction * pistons.map(|piston| deflections[piston] * radius(piston)).sum::<f64>()
            };
            firing.shots.iter().map(vector).sum()
        };
        let longest = deflections.iter().enumerate().map(|(index, delta)| delta.abs() * radius(index)).sum();
        let critical = |(&order, &vanishes): (&CycleOrder, &bool)| {
            let star = if vanishes { Complex::default() } else { star(order) };
            let star = if star.norm() <= ROUNDING * longest { Complex::default() } else { star };
            Critical { order, rpm: order.rpm(mode.hertz()), star, vanishes }
        };
        let orders = orders.iter().zip(&zero).map(critical).collect();
        CriticalSpeeds { orders, longest, deflections, mode }
    };
    Ok(modes(&train).into_iter().map(of_mode).collect())
}
