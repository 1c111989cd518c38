//! What is said first of a shaft that twists, and what it rests on?

use super::TorsionStudy;
use crate::page::{Piece, Text, Unit, phrase};
use crate::torsion::CriticalSpeeds;

pub(super) const ASSUMED: [&str; 5] = [
    "The shaft is a row of rigid discs on massless springs, free at both ends. The inertias are those of the layout file: the file decides which part of pistons and rods they contain, usually the rotating mass and half of the reciprocating one.",
    "Damping is neglected: no amplitude is given at a critical speed.",
    "Frequencies and modes are decimals, by Holzer's residuals and a bisection down to neighbouring numbers; the stars of the modes are decimals too.",
    "The firing stars are those of the gas torque for one pressure law common to all cylinders. How strong an order is depends on its star and on the harmonic of the torque, which falls with the order; the stars alone are compared here.",
    "At whole orders the inertia of the pistons adds to the torque.",
];

pub(super) const FOUND: &str = "In a mode the deflections $\\Theta_i$ of the discs satisfy $k_i(\\Theta_{i+1} - \\Theta_i) = k_{i-1}(\\Theta_i - \\Theta_{i-1}) - J_i\\omega^2\\Theta_i$; \
    order $\\kappa$ meets the frequency $f$ at the speed $n = 60 f/\\kappa$ in 1/min. A torque of order $\\kappa$ that all cylinders share works on the mode in proportion to \
    $\\lvert\\sum_j \\Delta_j r_j e^{-i\\kappa\\varphi_j}\\rvert$, with $\\Delta_j$ the deflection of the cylinder's crankpin.";

/// What the table of forced twists says.
pub(super) fn forced(speed: f64) -> Text {
    phrase!(
        "Forced twist at {} by the torque of gas and inertia, order by order, zero to peak, without damping; orders within 5 % of a natural frequency are left blank:",
        rpm(speed)
    )
}

fn hertz(mode: &CriticalSpeeds) -> Text {
    Piece::Quantity(mode.mode.hertz(), Unit::HERTZ).into()
}

/// A speed, rounded to what a reader wants to know.
pub(super) fn rpm(value: f64) -> Text {
    Piece::Quantity(value, Unit::PER_MINUTE).into()
}

/// A part of the greatest length, in hundredths.
pub(super) fn part(value: f64) -> Text {
    Piece::Quantity(100.0 * value, Unit::PERCENT).into()
}

/// The frequencies, and the strongest critical speed.
pub(super) fn answer(study: &TorsionStudy) -> Vec<Text> {
    let mut lines = Vec::new();
    let Some(first) = study.modes.first() else { return lines };
    lines.push(match study.modes.get(1) {
        None => phrase!("First natural frequency: {}, with one node.", hertz(first)),
        Some(second) => {
            phrase!("Natural frequencies: {} with one node, {} with two.", hertz(first), hertz(second))
        }
    });
    lines.push(match (study.strongest(first).first(), study.speed) {
        (None, Some(speed)) => phrase!("No order shown excites the first of them up to {}.", rpm(speed)),
        (None, None) => "No order shown excites the first of them.".into(),
        (Some(critical), Some(speed)) => phrase!(
            "Up to {} the order with the longest star in the first mode is {}: its critical speed is {}, its star {} of the longest possible.",
            rpm(speed),
            critical.order.to_string(),
            rpm(critical.rpm),
            part(critical.star.norm() / first.longest)
        ),
        (Some(critical), None) => phrase!(
            "The order with the longest star in the first mode is {}: its critical speed is {}, its star {} of the longest possible.",
            critical.order.to_string(),
            rpm(critical.rpm),
            part(critical.star.norm() / first.longest)
        ),
    });
    lines
}
