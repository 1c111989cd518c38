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

impl Effects {
    /// The words by which a layout file asks for them.
    pub fn asked(&self) -> Vec<&'static str> {
        let words = [
            ("torque", self.torque),
            ("remedy", self.remedy),
            ("gas", self.gas),
            ("firing", self.firing),
            ("torsion", self.torsion),
        ];
        words.into_iter().filter(|(_, asked)| *asked).map(|(word, _)| word).collect()
    }
}
