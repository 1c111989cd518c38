//! Which orders of the gas torque vanish, whatever the pressure is? The firing star of each order, judged exactly.
//!
//! A cylinder that fires at the crank angle φ_j of the cycle adds `t_κ r_j e^{−iκφ_j}` to order κ of the torque, where t_κ is
//! that of its pressure law. With one law for all cylinders, order κ is t_κ times the **firing star**
//! `S_κ = Σ_j r_j e^{−iκφ_j}`: it vanishes for every law exactly where S_κ is zero (theory, section 11).
//! Weighed by a mode shape, the same star is the sum of phase vectors of torsional vibration.

mod pattern;
mod star;
mod strength;

use num_traits::Zero;

use crate::engine::{Cycle, CycleOrder, Engine, Firing, HIGHEST_ORDER};
use crate::exact::PhasorSum;
pub use pattern::{FiringPattern, LONGEST_PATTERN, NoPattern, pattern};
pub use star::{FiringStar, NoStar, StarOrder, Weights};
pub use strength::by_length;

/// When the cylinders fire.
///
/// # Errors
/// A layout that does not say it, and crankshafts of different speeds.
pub fn firing_of(engine: &Engine) -> Result<&Firing, NoStar> {
    let why = || match engine.faster_crank() {
        Some(_) => NoStar::FasterCrank,
        None => NoStar::NoFiring,
    };
    engine.firing().ok_or_else(why)
}

/// Whether what repeats once per cycle has these orders.
///
/// # Errors
/// [`NoStar::HalfOrder`].
pub fn are_orders_of(cycle: Cycle, orders: &[CycleOrder]) -> Result<(), NoStar> {
    match orders.iter().find(|order| !order.exists_in(cycle)) {
        None => Ok(()),
        Some(order) => Err(NoStar::HalfOrder(*order)),
    }
}

/// Judges the firing stars of these orders, as they stand.
///
/// # Errors
/// See [`NoStar`].
pub fn firing_stars(engine: &Engine, orders: &[CycleOrder], weights: &Weights) -> Result<Vec<StarOrder>, NoStar> {
    let firing = firing_of(engine)?;
    can_be_judged(engine, weights)?;
    weights.fit(engine.cylinders().len())?;
    are_orders_of(firing.cycle, orders)?;
    Ok(orders.iter().map(|&order| StarOrder::new(engine, firing, order, weights)).collect())
}

/// Whether the pistons move so that stars tell which orders vanish.
fn can_be_judged(engine: &Engine, weights: &Weights) -> Result<(), NoStar> {
    if engine.has_opposed_pistons() && (weights.is_mode_shape() || !engine.pairs_are_alike()) {
        return Err(NoStar::OpposedPistons);
    }
    if has_endless_rods_apart(engine) { Err(NoStar::EndlessRods) } else { Ok(()) }
}

/// Whether endless rods have several slopes: their motions are all made of the same two, so that stars of each slope prove nothing.
fn has_endless_rods_apart(engine: &Engine) -> bool {
    let rods = engine.firing_pistons().into_iter().filter_map(|index| engine.cylinders()[index].rod());
    let mut slopes = rods.filter(|rod| rod.ratio.is_zero()).map(|rod| &rod.offset);
    slopes.next().is_some_and(|first| slopes.any(|other| other != first))
}

/// The stars of one order without their certificates, one for each class of cylinders: of whole orders for any engine whose crankshafts turn equally
/// fast, of half orders where it is known when the cylinders of a four-stroke fire.
///
/// # Errors
/// See [`NoStar`].
pub fn star_sums(engine: &Engine, order: CycleOrder) -> Result<Vec<PhasorSum>, NoStar> {
    if engine.faster_crank().is_some() {
        return Err(NoStar::FasterCrank);
    }
    can_be_judged(engine, &Weights::Rigid)?;
    let dead_centres = || Firing::two_stroke(engine.cylinders());
    let firing = match order.is_whole() {
        // In turns a revolution more leaves κφ as it is.
        true => dead_centres(),
        false => engine.firing().filter(|firing| order.exists_in(firing.cycle)).ok_or(NoStar::NoFiring)?.clone(),
    };
    Ok(star::sums(engine, &firing, order, &Weights::Rigid).into_iter().map(|(_, sum)| sum).collect())
}

/// The orders that are decided for this many cylinders where none are asked for, multiples of the lowest: up to the first at which all
/// cylinders of an even order would add up, and at least up to 4.
pub fn usual_orders(cylinders: usize, lowest: CycleOrder) -> Vec<CycleOrder> {
    let step = lowest.halves();
    let cylinders = u32::try_from(cylinders).unwrap_or(u32::MAX);
    let last = cylinders.saturating_mul(step).clamp(8, 2 * HIGHEST_ORDER);
    (1..=last / step).filter_map(|index| CycleOrder::of_halves(index * step)).collect()
}
