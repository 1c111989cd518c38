//! What else turns? Pins, webs and counterweights on the crankshaft, and the balancer shafts that it drives.

use num_rational::BigRational;

use crate::exact::Turn;
use crate::proof::Sense;

/// Masses on the crankshaft, and the balancer shafts that it drives.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Crankshaft {
    /// Mass of each throw's pin in kilograms, at the crank radius; none where the file says nothing of it.
    pub pins: Vec<BigRational>,
    /// Both webs of each throw together; none where the file says nothing of them.
    pub webs: Vec<Web>,
    /// The counterweights: those of the file, or those that its balance factors make.
    pub counterweights: Vec<Counterweight>,
    /// The balance factor of each throw that the file asks for; none where it names its counterweights itself.
    pub balance_factors: Vec<BigRational>,
    /// The balancer shafts.
    pub balancers: Vec<Balancer>,
    /// Whether all counterweights and balancer shafts are given in multiples of m r, so that no mass and no crank radius is
    /// needed to compare them: those that are not known count 1.
    pub in_multiples: bool,
    /// Length of the crankshaft, whose middle is that of the cylinders, in the unit of the positions.
    pub length: Option<BigRational>,
}

/// The webs of a throw, as one mass on the line from the shaft to the pin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Web {
    /// Mass in kilograms.
    pub mass: BigRational,
    /// Distance of its centre of gravity from the axis in metres; negative on the side away from the pin.
    pub radius: BigRational,
}

/// A counterweight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counterweight {
    /// The throw that it belongs to, by its index; none for one that stands for itself.
    pub throw: Option<usize>,
    /// Its direction, from the reference direction at θ = 0.
    pub angle: Turn,
    /// Mass in kilograms.
    pub mass: BigRational,
    /// Distance of its centre of gravity from the axis in metres.
    pub radius: BigRational,
    /// Position along the crankshaft, in the unit of the positions.
    pub position: BigRational,
    /// Which crankshaft it is on, where several are geared together; else 0.
    pub crank: usize,
}

impl Counterweight {
    /// U = m r in kilogram-metres.
    pub fn mass_radius(&self) -> BigRational {
        &self.mass * &self.radius
    }
}

/// A shaft with an eccentric weight, geared to the crankshaft.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Balancer {
    /// How many times it turns in a revolution of the crankshaft.
    pub order: u32,
    /// Direct: with the crank; reverse: against it.
    pub sense: Sense,
    /// U = m r in kilogram-metres, which is multiplied by a coefficient of the motion where one is named.
    pub mass_radius: BigRational,
    /// The cylinder, by its index, whose coefficient c_k of the shaft's order multiplies the mass-radius; none for 1.
    pub coefficient_of: Option<usize>,
    /// Direction of its weight at θ = 0.
    pub angle: Turn,
    /// Position of the weight along the crankshaft, in the unit of the positions.
    pub position: BigRational,
    /// Where its axis stands; none where the file leaves it out: then no result may hang on it.
    pub axis: Option<ShaftAxis>,
}

/// Where the axis of a balancer shaft stands, from the middle of the engine, which is the axis of an only crankshaft.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaftAxis {
    /// Height along the reference direction, in metres.
    pub height: BigRational,
    /// Distance to the left of the reference direction (along angle 90°), in metres.
    pub offset: BigRational,
}
