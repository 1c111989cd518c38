//! What can be asked for beyond the forces and moments of the masses?

/// What is asked for beyond the forces and moments of the masses: `effects = ["torque", "remedy"]` in a layout file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// The inertia torque.
    pub torque: bool,
    /// Counterweights and balancer shafts for what is left of orders 1 and 2.
    pub remedy: bool,
    /// The forces and the torque of the gas.
    pub gas: bool,
    /// The firing stars: which orders of the gas torque vanish, whatever the pressure is.
    pub firing: bool,
    /// Torsional vibration of the crankshaft.
    pub torsion: bool,
}
