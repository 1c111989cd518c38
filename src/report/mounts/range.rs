//! How strongly does each order move the engine over a range of speeds, and where most?

use super::{AtSpeed, MountsStudy, largest};
use crate::motion::golden_section;
use crate::mounts::{Mode, OrderExcitation};
use crate::torsion::{beside, peaks};

/// So many speeds of a range are computed of every order.
const SPEEDS: u32 = 80;
/// Where an order meets a mode its speeds stand closer, at these parts of that speed.
const BESIDE: [f64; 8] = [-0.04, -0.02, -0.01, -0.005, 0.005, 0.01, 0.02, 0.04];
/// So many golden sections find a peak.
const SECTIONS: u32 = 30;
/// A peak below this part of the highest computed value is not looked for.
const LOWER: f64 = 0.5;

impl MountsStudy {
    /// The orders over the range of speeds, rising: each at even distances, closer where it meets a mode, and at its peaks.
    pub fn range(&self) -> &[AtSpeed] {
        self.over_range.get_or_init(|| {
            let [from, to] = self.ends;
            let even = (0..=SPEEDS).map(|step| from + (to - from) * f64::from(step) / f64::from(SPEEDS));
            let even: Vec<f64> = even.collect();
            let orders = 0..self.orders.len();
            let mut range: Vec<AtSpeed> = orders.flat_map(|order| of_order(self, order, &even)).collect();
            range.sort_by(|one, other| one.rpm.total_cmp(&other.rpm).then(one.order.cmp(&other.order)));
            range
        })
    }
}

fn of_order(study: &MountsStudy, place: usize, even: &[f64]) -> Vec<AtSpeed> {
    let excitation = &study.orders[place].excitation;
    if excitation.still.is_whole() {
        return even.iter().map(|rpm| at(study, place, *rpm)).collect();
    }
    let (Some(&from), Some(&to)) = (even.first(), even.last()) else { return Vec::new() };
    let met: Vec<(f64, &Mode)> = study.modes.iter().map(|mode| (excitation.order.rpm(mode.hertz()), mode)).collect();
    let endless: Vec<f64> = met.iter().filter(|(_, mode)| !study.body.is_damped(mode)).map(|(rpm, _)| *rpm).collect();
    let close = met.iter().flat_map(|(rpm, _)| BESIDE.map(|part| rpm * (1.0 + part)));
    let damped = met.iter().map(|(rpm, _)| *rpm).filter(|rpm| !endless.contains(rpm));
    let mut speeds: Vec<f64> = even.iter().copied().chain(close).chain(damped).collect();
    speeds.retain(|speed| (from..=to).contains(speed));
    speeds.sort_by(f64::total_cmp);
    speeds.dedup_by(|one, other| (*one - *other).abs() < 1e-9 * to);
    let mut found: Vec<AtSpeed> = speeds.iter().map(|rpm| at(study, place, *rpm)).collect();
    for of in [|at: &AtSpeed| at.velocity, |at: &AtSpeed| at.force] {
        let values: Vec<f64> = found.iter().map(|at| of(at).unwrap_or_default()).collect();
        let speeds: Vec<f64> = found.iter().map(|at| at.rpm).collect();
        let least = LOWER * values.iter().copied().fold(0.0, f64::max);
        let sides = peaks(&values, least).map(|index| beside(&speeds, index));
        // Beside a natural frequency without damping a response rises without end, or is that of rounding.
        let sides = sides.filter(|[low, high]| !endless.iter().any(|rpm| (low..=high).contains(&rpm)));
        let value = |rpm| of(&at(study, place, rpm)).unwrap_or_default();
        found.extend(sides.map(|[low, high]| at(study, place, golden_section(low, high, SECTIONS, value))));
        found.sort_by(|one, other| one.rpm.total_cmp(&other.rpm));
        found.dedup_by(|one, other| one.rpm == other.rpm);
    }
    // Where such a frequency is excited no number is the largest.
    let is_endless = |(rpm, mode): &&(f64, &Mode)| endless.contains(rpm) && is_excited(excitation, mode, *rpm);
    let unbounded = met.iter().filter(is_endless).filter(|(rpm, _)| (from..=to).contains(rpm));
    found.extend(unbounded.map(|(rpm, _)| AtSpeed { rpm: *rpm, order: place, velocity: None, force: None }));
    found
}

/// Whether an order does work in a mode at a speed, beyond rounding.
fn is_excited(excitation: &OrderExcitation, mode: &Mode, rpm: f64) -> bool {
    let [force, moment] = excitation.at(rpm);
    let parts = || force.iter().chain(&moment).zip(mode.shape);
    let work: num_complex::Complex<f64> = parts().map(|(load, shape)| load * shape).sum();
    let most: f64 = parts().map(|(load, shape)| load.norm() * shape.abs()).sum();
    work.norm() > 1e-9 * most
}

fn at(study: &MountsStudy, order: usize, rpm: f64) -> AtSpeed {
    let excitation = &study.orders[order].excitation;
    let [force, moment] = excitation.at(rpm);
    let motion = study.body.motion(excitation.omega(rpm), force, moment);
    let most = |motion| {
        let mounts = 0..study.body.mounts();
        mounts.map(|mount| largest(&study.body.mount_force(mount, motion))).fold(0.0, f64::max)
    };
    let (velocity, force) = (motion.as_ref().map(|motion| study.velocity(motion)), motion.as_ref().map(most));
    AtSpeed { rpm, order, velocity, force }
}
