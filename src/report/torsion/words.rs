//! What is said first of a shaft that twists, and what it rests on?

use super::super::torque::misfire;
use super::amounts::{part, rpm, shaft, torque};
use super::study::TorsionStudy;
use super::tables::MOST_MODES;
use super::{barred, gears};
use crate::page::{Piece, Text, Unit, phrase};
use crate::torsion::CriticalSpeeds;

/// What the answer rests on.
pub(super) fn assumed(study: &TorsionStudy) -> Vec<Text> {
    let torsion = study.torsion();
    let mut lines: Vec<Text> = vec![
        match study.is_row() {
            true => "The shaft is a row of rigid discs on massless springs, free at both ends. The inertias are those of the layout file: the file decides which part of pistons and rods they contain, usually the rotating mass and half of the reciprocating one.",
            false => "The train is a tree of rigid discs on massless shafts, free at all ends; gears do not give way. The inertias are those of the layout file: the file decides which part of pistons and rods they contain, usually the rotating mass and half of the reciprocating one.",
        }
        .into(),
        match torsion.is_damped() {
            true => "Damping is linear: the stiffness of a shaft is $k(1 + i\\eta) + i\\Omega c$, a disc is held back by $i\\Omega c$. Natural frequencies and modes are those without damping.",
            false => "Damping is neglected: no amplitude is given at a critical speed.",
        }
        .into(),
    ];
    if study.at_speed().is_some() {
        lines.push(match torsion.harmonics.is_empty() {
            true => "The pressures are those of the layout at every speed; the inertia of the pistons grows with the square of the speed. Orders up to 12 are added.".into(),
            false => "The torque of each cylinder is that of the harmonics in the layout, the same at every speed.".into(),
        });
    }
    lines.extend(ALWAYS.map(Text::from));
    lines.extend(study.engine.has_links().then(|| LINKS.into()));
    lines
}

const LINKS: &str =
    "With links on a master rod the cylinders do not all give the same torque, so that the stars are approximate.";

const ALWAYS: [&str; 3] = [
    "Frequencies and modes are decimals, by Holzer's residuals and a bisection down to neighbouring numbers; the stars of the modes are decimals too.",
    "The firing stars are those of the gas torque for one pressure law common to all cylinders. How strong an order is depends on its star and on the harmonic of the torque, which falls with the order; the stars alone are compared here.",
    "At whole orders the inertia of the pistons adds to the torque.",
];

const FOUND: &str = "In a mode the deflections $\\Theta_i$ of the discs satisfy $k_i(\\Theta_{i+1} - \\Theta_i) = k_{i-1}(\\Theta_i - \\Theta_{i-1}) - J_i\\omega^2\\Theta_i$; \
    order $\\kappa$ meets the frequency $f$ at the speed $n = 60 f/\\kappa$ in rpm. A torque of order $\\kappa$ that all cylinders share works on the mode in proportion to \
    $\\lvert\\sum_j \\Delta_j r_j e^{-i\\kappa\\varphi_j}\\rvert$, with $\\Delta_j$ the deflection of the cylinder's crankpin.";

/// How the forced vibration is found.
const FOUND_DAMPED: &str = "With damping, order $\\kappa$ of the torque forces $(K(1 + i\\eta) + i\\Omega C - \\Omega^2 J)\\,\\Theta = t_\\kappa e^{-i\\kappa\\varphi}$, $\\Omega = \\kappa\\omega$; the torque in a shaft is \
    $(k(1 + i\\eta) + i\\Omega c)(\\Theta_i - \\Theta_j)$, its stress $16 M d / \\pi(d^4 - d_i^4)$. All orders together: half of the largest less the smallest value in a cycle. \
    The energy method (Den Hartog, Nestorides) gives $\\lvert t \\sum \\Delta_j e^{-i\\kappa\\varphi_j}\\rvert / (\\Omega \\sum c \\Delta^2 + \\sum (\\Omega c + \\eta k)(\\delta\\Delta)^2)$ at the critical speed.";

/// How all of it is found.
pub(super) fn found(study: &TorsionStudy) -> Vec<Text> {
    let mut paragraphs = vec![Text::from(FOUND)];
    if study.excited().is_some() && study.torsion().is_damped() {
        paragraphs.push(FOUND_DAMPED.into());
        paragraphs.extend((!study.train.gears.is_empty()).then(|| gears::FOUND.into()));
    }
    if (0..study.train.shafts).any(|shaft| study.limit(shaft).is_some()) {
        paragraphs.push(FOUND_CLASS.into());
    }
    if !study.torsion().dampers.is_empty() {
        paragraphs.push(FOUND_DAMPER.into());
    }
    paragraphs
}

/// How a permissible stress is found.
const FOUND_CLASS: &str = "IACS Unified Requirement M68: for continuous running $\\tau_C = (\\sigma_B + 160)/18 \\cdot c_K c_D (3 - 2\\lambda^2)$ in MPa up to $\\lambda = 0.9$, then $1.38$ in place of the bracket up to $1.05$; $c_D = 0.35 + 0.93\\,d^{-0.2}$, $d$ in mm; \
    $\\lambda$ is the speed over the rated speed. Passing quickly, below $\\lambda = 0.8$: $\\tau_T = 1.7\\,\\tau_C/\\sqrt{c_K}$. A barred range is $16 n_c/(18 - \\lambda)$ to $(18 - \\lambda) n_c/16$. From $\\lambda = 0.8$ on no range may be barred. The class decides, with misfiring and other loads.";

/// How a damper is found.
const FOUND_DAMPER: &str = "Best dampers (Den Hartog), $\\mu$ the inertia of the ring over $\\sum J \\Delta^2$ of the first mode, $\\Delta = 1$ at the damper: viscous $\\zeta = 1/\\sqrt{2(1 + \\mu)(2 + \\mu)}$; tuned $\\omega_a = \\omega_1/(1 + \\mu)$, $\\zeta^2 = 3\\mu/8(1 + \\mu)^3$; \
    $c = 2 \\zeta J_d \\omega_1$. The search makes the largest torque in a shaft near the first mode least, by the order with the most work in it.";

/// What the table of forced twists says.
pub(super) fn forced(study: &TorsionStudy, speed: f64) -> Text {
    if study.torsion().is_damped() {
        return phrase!("Forced twist at {}, order by order, zero to peak:", rpm(speed));
    }
    phrase!(
        "Forced twist at {} by the torque of gas and inertia, order by order, zero to peak, without damping; orders within 5 % of a natural frequency are left blank:",
        rpm(speed)
    )
}

fn hertz(mode: &CriticalSpeeds) -> Text {
    Piece::Quantity(mode.mode.hertz(), Unit::HERTZ).into()
}

const MISFIRE: &str = "Amplitudes, torques, stresses and heat are those of the misfire, in decimals. The stars are those of all cylinders firing alike; which orders vanish is not decided for a misfire.";

/// What shakes where the torque is known, the frequencies, and the strongest critical speed.
pub(super) fn answer(study: &TorsionStudy) -> Vec<Text> {
    let mut lines: Vec<Text> = misfire(&study.engine).into_iter().collect();
    lines.extend(study.engine.misfire().map(|_| MISFIRE.into()));
    lines.extend(forced_answer(study));
    lines.extend(frequencies(study));
    lines.extend(at_rest(study));
    if !study.torsion().is_damped() && study.torsion().has_forced() {
        lines.push("The shaft is undamped: at a critical speed the amplitude is infinite.".into());
    }
    if study.torsion().is_damped() && study.excited().is_none() {
        lines.push("No amplitudes: they need the torque, from [gas] with a speed or from [[torsion.harmonic]].".into());
    }
    lines
}

fn frequencies(study: &TorsionStudy) -> Vec<Text> {
    let mut lines = Vec::new();
    let Some(first) = study.modes.first() else { return lines };
    lines.push(match study.modes.get(1) {
        _ if !study.is_row() => {
            let first = study.modes.iter().take(MOST_MODES).map(hertz);
            phrase!("Natural frequencies: {}.", Text::joined(first, ", "))
        }
        None => phrase!("First natural frequency: {}, with one node.", hertz(first)),
        Some(second) => {
            phrase!("Natural frequencies: {} with one node, {} with two.", hertz(first), hertz(second))
        }
    });
    lines.push(match (study.strongest(first).first(), study.highest_speed()) {
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

fn damping(value: f64) -> Text {
    Piece::Quantity(value, Unit::NEWTON_METRE_SECOND).into()
}

/// The forced vibration with damping: at the speed, at the strongest resonance, stresses, dampers.
fn forced_answer(study: &TorsionStudy) -> Vec<Text> {
    let mut lines = Vec::new();
    if let Some(vibration) = study.at_speed() {
        let torques = (0..study.train.shafts).map(|shaft| (shaft, vibration.torque(shaft)));
        let (most, value) = torques.fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most });
        let swings: Text = Piece::Quantity(vibration.twist(0).to_degrees(), Unit::DEGREE).into();
        let where_it_is = shaft(study, most);
        lines.push(match study.stress(most, value) {
            None => phrase!("At {} the first disc swings by {} to each side, and the largest vibration torque is {}, in shaft {}.", rpm(vibration.speed), swings, torque(value), where_it_is),
            Some(stress) => phrase!("At {} the first disc swings by {} to each side, and the largest vibration torque is {}, in shaft {}: a stress of {}.", rpm(vibration.speed), swings, torque(value), where_it_is, Piece::Quantity(1e-6 * stress, Unit::MEGAPASCAL)),
        });
    }
    lines.extend(gears::answer(study));
    let strongest = study.resonances().iter().max_by(|one, other| one.largest.torque.total_cmp(&other.largest.torque));
    if let Some(one) = strongest {
        lines.push(phrase!(
            "The strongest resonance of one order in the range is that of order {} at {}: {} in shaft {}.",
            one.order.to_string(),
            rpm(one.largest.rpm),
            torque(one.largest.torque),
            shaft(study, one.largest.shaft)
        ));
    }
    for excess in study.excesses() {
        let [from, to] = excess.speeds.map(rpm);
        lines.push(phrase!(
            "In shaft {} the vibration stress is larger than IACS UR M68 permits for continuous running from {} to {}.",
            shaft(study, excess.shaft),
            from,
            to
        ));
    }
    for one in study.resonances() {
        if one.is_unbarred {
            lines.push(phrase!(
                "At the critical speed {} of order {} the stress is above the limit, and so near the rated speed no range may be barred.",
                rpm(one.rpm),
                one.order.to_string()
            ));
        }
        lines.extend(one.barred.as_ref().map(|range| barred::said(study, one, range)));
    }
    for (damper, given) in study.dampers().iter().zip(&study.torsion().dampers) {
        if let Some(found) = &damper.found {
            lines.push(phrase!(
                "Damper at disc {}: damping {}, by the formula {}, by a search {}; the largest torque of order {} near the first mode is {} with it, {} without.",
                given.disc + 1,
                damping(damper.setting.damping),
                damping(damper.in_mode.best.damping),
                damping(found.best.damping),
                found.order.to_string(),
                torque(found.peaks[1]),
                torque(found.peaks[2])
            ));
        }
    }
    lines
}

/// Orders that leave a free shaft at rest as a whole, exactly, and twist it all the same.
fn at_rest(study: &TorsionStudy) -> Option<Text> {
    let torsion = study.torsion();
    let orders = &study.excited().filter(|_| torsion.is_damped())?.twist_alone;
    if orders.is_empty()
        || study.engine.misfire().is_some()
        || torsion.dampings.iter().any(num_traits::Signed::is_positive)
        || !torsion.gears.is_empty()
    {
        return None;
    }
    let named = Text::joined(orders.iter().map(|order| order.to_string().into()), ", ");
    let which = if orders.len() == 1 { phrase!("order {}", named) } else { phrase!("orders {}", named) };
    Some(phrase!(
        "The firing star is zero at {}: the train does not roll as a whole, $\\sum J\\Theta = 0$ exactly, whatever the stiffness and damping of the shafts. The torque of such an order still twists it.",
        which
    ))
}
