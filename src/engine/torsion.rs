//! What is a crankshaft that twists? Discs with moments of inertia, and the stiffness of the shaft between them.

use std::fmt;

use num_rational::BigRational;
use num_traits::Signed;

/// More discs are not read.
pub const MOST_DISCS: usize = 200;

/// The shaft as discs on a massless spring, from the free end on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Torsion {
    /// Moment of inertia of each disc, in kg m².
    pub inertias: Vec<BigRational>,
    /// Stiffness between each disc and the next, in N m per radian.
    pub stiffnesses: Vec<BigRational>,
    /// On which disc each crankpin stands, by its number from 0; the first pins on the first discs where nothing is said.
    pub pins: Vec<usize>,
}

/// Why discs and springs are no shaft.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoShaft {
    /// Fewer than two discs, or more than [`MOST_DISCS`].
    Discs(usize),
    /// Not one stiffness fewer than inertias.
    Stiffnesses {
        /// How many discs.
        discs: usize,
        /// How many stiffnesses.
        stiffnesses: usize,
    },
    /// An inertia or a stiffness that is not above 0, by its number from 1.
    NotPositive(&'static str, usize),
    /// Not one disc for each crankpin.
    Pins {
        /// How many are given.
        given: usize,
        /// How many crankpins there are.
        pins: usize,
    },
    /// A crankpin on a disc that is not there, both by their numbers from 1.
    NoSuchDisc {
        /// The crankpin.
        pin: usize,
        /// The disc.
        disc: usize,
        /// How many discs there are.
        discs: usize,
    },
}

impl fmt::Display for NoShaft {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoShaft::Discs(count) => write!(f, "{count} moments of inertia; a torsional model has 2 to {MOST_DISCS}"),
            NoShaft::Stiffnesses { discs, stiffnesses } => {
                write!(
                    f,
                    "{stiffnesses} stiffnesses for {discs} moments of inertia; between {discs} discs there are {}",
                    discs - 1
                )
            }
            NoShaft::NotPositive(what, number) => write!(f, "{what} {number} is not above 0"),
            NoShaft::Pins { given, pins } => {
                write!(f, "{given} discs are named for {pins} crankpins; name one for each")
            }
            NoShaft::NoSuchDisc { pin, disc, discs } => {
                write!(f, "crankpin {pin} is on disc {disc}; there are {discs}, numbered from 1")
            }
        }
    }
}

impl std::error::Error for NoShaft {}

impl Torsion {
    /// Whether it is a shaft for so many crankpins.
    ///
    /// # Errors
    /// The first thing that does not fit.
    pub fn check(&self, pins: usize) -> Result<(), NoShaft> {
        let discs = self.inertias.len();
        if !(2..=MOST_DISCS).contains(&discs) {
            return Err(NoShaft::Discs(discs));
        }
        if self.stiffnesses.len() + 1 != discs {
            return Err(NoShaft::Stiffnesses { discs, stiffnesses: self.stiffnesses.len() });
        }
        for (what, values) in [("moment of inertia", &self.inertias), ("stiffness", &self.stiffnesses)] {
            if let Some(index) = values.iter().position(|value| !value.is_positive()) {
                return Err(NoShaft::NotPositive(what, index + 1));
            }
        }
        if self.pins.len() != pins {
            return Err(NoShaft::Pins { given: self.pins.len(), pins });
        }
        match self.pins.iter().enumerate().find(|(_, disc)| **disc >= discs) {
            None => Ok(()),
            Some((pin, disc)) => Err(NoShaft::NoSuchDisc { pin: pin + 1, disc: disc + 1, discs }),
        }
    }
}
