//! About which axis does the roll moment turn a body that hangs free, and do the mounts let it?

use nalgebra::{Vector3, Vector6};

use super::Body;

/// The torque-roll axis (Jeong and Singh, Journal of Sound and Vibration 234, 2000): a free body under a moment about the crankshaft turns
/// about `I⁻¹ẑ` through its centre of gravity.
#[derive(Clone, Debug, PartialEq)]
pub struct RollAxis {
    /// Its direction, a unit vector with z above 0.
    pub direction: [f64; 3],
    /// The angle between it and the crankshaft, in degrees.
    pub from_crankshaft: f64,
    /// The frequency of a turn about it alone, in oscillations a second.
    pub hertz: f64,
    /// How much the mounts couple that turn with other motions: the sine of the angle between `K(0, d)` and `(0, ẑ)`, measured by the
    /// kinetic energy. Where it is 0 the roll moment makes a pure turn about this axis.
    pub coupling: f64,
    /// The same of the damping; none without any.
    pub damping_coupling: Option<f64>,
}

/// The torque-roll axis of a body on its mounts; none where decimals cannot hold its inertia.
pub fn roll_axis(body: &Body) -> Option<RollAxis> {
    let inverse = body.mass.try_inverse()?;
    let crankshaft = Vector6::new(0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let turn: Vector6<f64> = inverse * crankshaft;
    let axis = Vector3::new(turn[3], turn[4], turn[5]);
    let unit = axis / axis.norm();
    let stiffness = turn.dot(&(body.stiffness * turn));
    let inertia = turn.dot(&(body.mass * turn));
    let coupling = |matrix: &nalgebra::Matrix6<f64>| {
        let answer = matrix * turn;
        // What is beside (0, ẑ), which is M times the turn; the norm is that of the kinetic energy.
        let beside = answer - crankshaft * (turn.dot(&answer) / inertia);
        let length = |of: &Vector6<f64>| of.dot(&(inverse * of)).max(0.0);
        (length(&answer) > 0.0).then(|| (length(&beside) / length(&answer)).sqrt())
    };
    Some(RollAxis {
        direction: unit.into(),
        from_crankshaft: libm::atan2(libm::hypot(unit[0], unit[1]), unit[2]).to_degrees(),
        hertz: (stiffness / inertia).sqrt() / std::f64::consts::TAU,
        coupling: coupling(&body.stiffness)?,
        damping_coupling: coupling(&(body.damping + body.loss)),
    })
}
