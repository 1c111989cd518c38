//! Which letters are in a formula, and what of a cylinder can a formula be said of?

/// A letter of a formula, as in section 2.3 of the thesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letter {
    /// θ, the crank's angle from the dead centre on the cylinder axis, in radians.
    Theta,
    /// β, the angle of the rod with the axis: `sin β = λ sin θ − δ`.
    Beta,
    /// λ = r/L.
    Lambda,
    /// δ = e/L.
    Delta,
    /// r, the crank radius in metres.
    Radius,
    /// h = r cos θ + L cos β, the height of the piston pin over the crankshaft.
    Height,
    /// ω in radians a second.
    Omega,
    /// D, the bore.
    Bore,
    /// p, the pressure in the cylinder in pascals, absolute.
    Pressure,
    /// p_0, that of the crankcase.
    Crankcase,
    /// What a formula can be said of too: L, m_ALT, m_ROT, M, and the forces F_g, F_ALT towards the crank, F = F_g + F_ALT, F_b along the rod,
    /// F_L on the cylinder, F_t across the crank, F_ROT of the rod's rotating mass.
    Of(Measured),
}

impl Letter {
    /// Every way to write a letter; of two that begin alike the longer one stands first.
    pub(super) const NAMES: [(&'static str, Letter); 32] = [
        ("F_ALT", Letter::Of(Measured::InertiaForce)),
        ("F_ROT", Letter::Of(Measured::CentrifugalForce)),
        ("F_g", Letter::Of(Measured::GasForce)),
        ("F_b", Letter::Of(Measured::RodForce)),
        ("F_L", Letter::Of(Measured::SideForce)),
        ("F_t", Letter::Of(Measured::CrankEffort)),
        ("F", Letter::Of(Measured::PistonEffort)),
        ("m_ALT", Letter::Of(Measured::ReciprocatingMass)),
        ("m_ROT", Letter::Of(Measured::RotatingMass)),
        ("m", Letter::Of(Measured::ReciprocatingMass)),
        ("p_0", Letter::Crankcase),
        ("p", Letter::Pressure),
        ("θ", Letter::Theta),
        ("theta", Letter::Theta),
        ("ψ", Letter::Theta),
        ("psi", Letter::Theta),
        ("β", Letter::Beta),
        ("beta", Letter::Beta),
        ("λ", Letter::Lambda),
        ("lambda", Letter::Lambda),
        ("δ", Letter::Delta),
        ("delta", Letter::Delta),
        ("ω", Letter::Omega),
        ("omega", Letter::Omega),
        ("w", Letter::Omega),
        ("r", Letter::Radius),
        ("L", Letter::Of(Measured::RodLength)),
        ("l", Letter::Of(Measured::RodLength)),
        ("h", Letter::Height),
        ("D", Letter::Bore),
        ("M", Letter::Of(Measured::Torque)),
        ("T", Letter::Of(Measured::Torque)),
    ];
}

/// What a formula can be said of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// `sin β`, the slope of the rod against the axis.
    RodSine,
    /// The way of the piston from its outermost place, in metres.
    Displacement,
    /// Its speed towards the crank.
    Velocity,
    /// Its acceleration towards the crank.
    Acceleration,
    /// The gas force on the piston, towards the crank.
    GasForce,
    /// The inertia force of the reciprocating mass, towards the crank.
    InertiaForce,
    /// The centrifugal force of the rotating mass of the rod.
    CentrifugalForce,
    /// Gas and inertia together, towards the crank.
    PistonEffort,
    /// The thrust of the piston on the cylinder.
    SideForce,
    /// The force along the rod, positive where it is pressed.
    RodForce,
    /// The part of the rod's force along the crank, towards the shaft.
    RadialForce,
    /// The part across it, in the sense of rotation.
    CrankEffort,
    /// What head, cylinder and bearings of the frame feel along the axis, outward.
    FrameAlong,
    /// And across it, in the sense of rotation.
    FrameAcross,
    /// The torque on the crankshaft.
    Torque,
    /// The torque on the frame, against the sense of rotation.
    ReactionTorque,
    /// The reciprocating mass.
    ReciprocatingMass,
    /// The rotating mass of the rod.
    RotatingMass,
    /// The length of the rod.
    RodLength,
}
