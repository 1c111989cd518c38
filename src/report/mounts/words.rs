//! What is said of an engine on its mounts in words?

use super::super::{residual, typeset};
use super::{MountsStudy, OrderMotion, Place, SOFTEST, largest};
use crate::engine::CycleOrder;
use crate::page::{Piece, Text, Unit, phrase};

pub(super) const ASSUMED: [&str; 6] = [
    "The engine is one rigid body; its bending is left out, and so is the gyroscopic moment of the crankshaft and the flywheel, which is about one hundredth of the inertia term for a usual engine.",
    "Crankshaft and flywheel do not count in the moment of inertia about z, for the roll moment turns the frame alone. A driven machine on the same frame counts in mass and inertia; its mean torque is balanced within the frame.",
    "The mounts are linear springs with dampers beside them; the ground does not move. Frequencies and modes are those without damping.",
    "The gas is that of the layout at every speed of the range; it acts on the frame by the roll moment alone.",
    "Amplitudes are zero to peak, and **0** is proved; where rms is said, the orders are added as $\\sqrt{\\tfrac12\\sum v_\\kappa^2}$, which holds whatever their phases are. A limit in rms is lower than one in peaks by √2 for a single order.",
    "x is along angle 0, y along angle 90° in the sense of rotation, z along the crankshaft towards the free end.",
];

pub(super) const FOUND: &str = "With $M = \\mathrm{diag}(m, I)$, and $B_j$ for how far the mount j moves with the body, $K = \\sum B_j^T k_j B_j$; order $\\kappa$ at the speed $\\omega$ moves the body by \
    $(K(1 + i\\eta) + i\\Omega C - \\Omega^2 M)^{-1}(F, M_G)$, $\\Omega = \\kappa\\omega$, and a mount passes on $(k_j(1 + i\\eta) + i\\Omega c_j) B_j q$. Phasors of force, moment and roll moment are those of `loads` and `torque`, about the centre of gravity.";

pub(super) const STILL: &str = "An order leaves the engine still on any mounts exactly where its force, its moment and its roll moment vanish: the dynamic stiffness $K(1 + i\\eta) + i\\Omega C - \\Omega^2 M$ has an inverse, with damping or away from resonance. Whether they vanish is decided by exact sums.";

pub(super) const AXIS: &str = "A free body rotates under a roll moment about the torque-roll axis $I^{-1}\\hat z$ through its centre of gravity, not about the crankshaft. Where the mounts do not couple that rotation with other motions, the roll moment causes \
    this pure rotation at every speed.";

pub(super) const NO_GAS: &str =
    "The layout gives no gas: the roll moment is that of the masses alone. At low speeds that of the gas is larger.";

pub(super) const UNDAMPED: &str =
    "The mounts have neither damping nor loss factors: at a natural frequency the motion has no bound.";

pub(super) fn rpm(value: f64) -> Text {
    Piece::Quantity(value, Unit::PER_MINUTE).into()
}

pub(super) fn place(of: Place) -> Text {
    match of {
        Place::Centre => "centre of gravity".into(),
        Place::Point => "point of the file".into(),
        Place::Mount(mount) => phrase!("mount {}", mount + 1),
    }
}

/// The short answer: what is passed on and what moves, which orders do not, where the natural frequencies are.
pub(super) fn answer(study: &MountsStudy) -> Vec<Text> {
    let moving: Vec<&OrderMotion> = study.moving().map(|(_, one)| one).collect();
    let mut lines: Vec<Text> = resonance(study).into_iter().chain(force(study)).chain(velocity(study)).collect();
    lines.push(match (typeset::listed(study.still()), moving.is_empty()) {
        (none, _) if none.is_empty() => "Every order shown moves the engine: in each, force, moment or roll moment is left.".into(),
        (_, true) => "No order shown moves the engine, proved: force, moment and roll moment of each vanish.".into(),
        (still, false) => phrase!(
            "These orders do not move the engine on any mounts, proved: {}. Force, moment and roll moment of each vanish.",
            still
        ),
    });
    let roll_alone = moving
        .iter()
        .filter(|one| one.excitation.still.force && one.excitation.still.moment)
        .map(|one| one.excitation.order);
    let roll_alone: Vec<CycleOrder> = roll_alone.collect();
    if !roll_alone.is_empty() {
        lines.push(phrase!("At {} the roll moment alone moves it.", residual::orders_in_words(&roll_alone)));
    }
    lines.push(frequencies(study));
    lines
}

/// The largest force along one axis that a mount passes on, its mount and its order.
pub(super) fn passed_on(study: &MountsStudy) -> Option<(f64, usize, CycleOrder)> {
    let moving = study.moving().filter_map(|(_, one)| Some((one.excitation.order, one.motion.as_ref()?)));
    let of_mounts = moving.flat_map(|(order, motion)| {
        let mounts = 0..study.body.mounts();
        mounts.map(move |mount| (largest(&study.body.mount_force(mount, motion)), mount, order))
    });
    of_mounts.max_by(|one, other| one.0.total_cmp(&other.0))
}

fn resonance(study: &MountsStudy) -> Option<Text> {
    let orders =
        typeset::listed(study.moving().filter(|(_, one)| one.motion.is_none()).map(|(_, one)| one.excitation.order));
    (!orders.is_empty()).then(|| {
        phrase!("**Resonance.** At {} without damping the motion has no bound in order {}.", rpm(study.speed), orders)
    })
}

fn force(study: &MountsStudy) -> Option<Text> {
    let (force, mount, order) = passed_on(study)?;
    Some(phrase!(
        "**Force transmitted** at {}: at most {} along one axis, by mount {} at order {}.",
        rpm(study.speed),
        Piece::Quantity(force, Unit::NEWTON),
        mount + 1,
        order.to_string()
    ))
}

fn velocity(study: &MountsStudy) -> Option<Text> {
    let moving = study.moving().filter_map(|(_, one)| Some((study.velocity(one.motion.as_ref()?), one)));
    let (speed, fastest) = moving.max_by(|one, other| one.0.total_cmp(&other.0))?;
    Some(phrase!(
        "**Largest velocity** of the {}: {} along one axis, zero to peak, at order {}.",
        place(study.watched()),
        Piece::Quantity(speed * 1e3, Unit::MILLIMETRE_PER_SECOND),
        fastest.excitation.order.to_string()
    ))
}

/// All natural frequencies, and the highest speed at which an order that moves the engine meets one.
fn frequencies(study: &MountsStudy) -> Text {
    let all = study.modes.iter().map(|mode| Piece::Quantity(mode.hertz(), Unit::HERTZ).into());
    let all = Text::joined(all, ", ");
    let lowest = study.moving().map(|(_, one)| one.excitation.order).next();
    match (lowest, study.modes.last()) {
        (Some(order), Some(highest)) => phrase!(
            "**Natural frequencies** on the mounts: {}. Order {} meets the highest of them at {}.",
            all,
            order.to_string(),
            rpm(order.rpm(highest.hertz()))
        ),
        _ => phrase!("**Natural frequencies** on the mounts: {}.", all),
    }
}

/// The torque-roll axis.
pub(super) fn axis(study: &MountsStudy) -> Option<Text> {
    let axis = study.axis.as_ref()?;
    let direction = axis.direction.map(|part| Text::measured(part, Unit::NONE));
    Some(phrase!(
        "Here it is inclined to the crankshaft by {}, its direction is ({}); a rotation about it alone has the frequency {}, and the mounts couple it with other motions by {}.",
        Piece::Quantity(axis.from_crankshaft, Unit::DEGREE),
        Text::joined(direction, "; "),
        Piece::Quantity(axis.hertz, Unit::HERTZ),
        Piece::Quantity(100.0 * axis.coupling, Unit::PERCENT)
    ))
}

/// What a reader has to know of the file.
pub(super) fn notes(study: &MountsStudy) -> Vec<Text> {
    let mut notes = Vec::new();
    if study.modes.iter().all(|mode| mode.hertz() < SOFTEST) {
        notes.push(phrase!(
            "All natural frequencies are below {}: are the stiffnesses in N/m? A number without a unit is; 1 N/mm is 1000 N/m.",
            Piece::Quantity(SOFTEST, Unit::HERTZ)
        ));
    }
    if !study.has_gas {
        notes.push(NO_GAS.into());
    }
    if study.body.is_undamped() {
        notes.push(UNDAMPED.into());
    }
    notes
}

/// The planes of symmetry of body and mounts.
pub(super) fn mirrors(study: &MountsStudy) -> Vec<Text> {
    let [x, y, z] = study.mounting().mirrors();
    let mut told = Vec::new();
    if z {
        told.push("Body and mounts are symmetric about the plane across the crankshaft through the centre of gravity, exactly: force and roll moment move x, y and the rotation about z alone, the moment z and the rotations about x and y.".into());
    }
    for (_, is_across) in [(y, true), (x, false)].into_iter().filter(|(is_mirror, _)| *is_mirror) {
        told.push(phrase!(
            "Body and mounts are symmetric about the plane of {1:x|y} and z through the centre of gravity, exactly: motions in that plane, {1:x|y}, z and the rotation about {1:y|x}, are not coupled with {1:y|x} and the rotations about {1:x|y} and z.",
            is_across
        ));
    }
    told
}
