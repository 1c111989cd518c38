//! What else turns? Pins, webs and counterweights on the crankshaft, and the balancer shafts that it drives.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::model::Engine;
use super::throws::{Throw, throws};
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

/// What is hung on a crankpin to balance a crankshaft on the machine of the workshop, in kilograms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BobWeight {
    /// For one cylinder: its rotating mass and the factor times its reciprocating mass.
    pub per_cylinder: Vec<BigRational>,
    /// For the throw: that of all cylinders that share it.
    pub per_throw: BigRational,
}

impl Engine {
    /// Crank radius of a throw in metres; `None` where the layout gives none.
    fn radius_of(&self, throw: &Throw) -> Option<BigRational> {
        Some(self.dimensions().crank_radius.as_ref()? * &throw.crank_radius)
    }

    /// Rotating and reciprocating mass of a cylinder in kilograms; `None` where the layout gives no masses. A knuckle mass counts as
    /// rotating at the crankpin: the master rod carries it round with the pin.
    fn masses_of(&self, cylinder: usize) -> Option<[BigRational; 2]> {
        let unit = self.dimensions().mass.as_ref()?;
        let cylinder = &self.cylinders()[cylinder];
        Some([&cylinder.rotating_mass + unit * &cylinder.knuckle_mass, unit * &cylinder.reciprocating_mass])
    }

    /// The mass in kilograms that all masses can be counted in: m, or one kilogram where m is 0 or not known.
    pub fn unit_mass(&self) -> BigRational {
        let mass = self.dimensions().mass.clone().filter(|mass| !mass.is_zero());
        mass.unwrap_or_else(BigRational::one)
    }

    /// The crank radius in metres, or 1 where it is not known.
    pub fn unit_radius(&self) -> BigRational {
        self.dimensions().crank_radius.clone().unwrap_or_else(BigRational::one)
    }

    /// What turns at each throw, `m_rot r` with pin, webs and the rotating parts of the rods, and the reciprocating mass there,
    /// `Σ m_rec r`, in kilogram-metres.
    ///
    /// One pair of each of [`throws`]; `None` where the layout gives no masses or no crank radius.
    pub fn throw_parts(&self) -> Option<Vec<[BigRational; 2]>> {
        throws(self).iter().enumerate().map(|(index, throw)| self.parts_of(index, throw)).collect()
    }

    /// The part of the reciprocating masses of each throw that its own counterweights hold in balance beside all that turns
    /// there: `b = (U − m_rot r) / Σ m_rec r`, the factor of the trade.
    ///
    /// `None` where the layout gives no masses or no crank radius, and for a throw without reciprocating mass.
    pub fn reciprocating_factors(&self) -> Vec<Option<BigRational>> {
        let factor = |(index, throw): (usize, Throw)| {
            let [rotating, reciprocating] = self.parts_of(index, &throw)?;
            (!reciprocating.is_zero()).then(|| (self.own_weights(index) - rotating) / reciprocating)
        };
        throws(self).into_iter().enumerate().map(factor).collect()
    }

    /// `Σ m_cw r_cw` of the counterweights of a throw.
    fn own_weights(&self, index: usize) -> BigRational {
        let own = self.crankshaft().counterweights.iter().filter(|weight| weight.throw == Some(index));
        own.map(Counterweight::mass_radius).sum()
    }

    /// What the counterweights of each throw hold in balance at the factor 1, in kilogram-metres:
    /// `m_rot r + ½ n_rods m_rec r` (theory, section 7), with pin, webs and the rotating parts of the rods.
    ///
    /// One of each of [`throws`]; `None` where the layout gives no masses or no crank radius.
    pub fn throw_mass_radii(&self) -> Option<Vec<BigRational>> {
        throws(self).iter().enumerate().map(|(index, throw)| self.mass_radius_of(index, throw)).collect()
    }

    fn mass_radius_of(&self, index: usize, throw: &Throw) -> Option<BigRational> {
        let [rotating, reciprocating] = self.parts_of(index, throw)?;
        Some(rotating + reciprocating / BigRational::from_integer(2.into()))
    }

    fn parts_of(&self, index: usize, throw: &Throw) -> Option<[BigRational; 2]> {
        let mut at_pin = self.crankshaft().pins.get(index).cloned().unwrap_or_else(BigRational::zero);
        let mut to_and_fro = BigRational::zero();
        for &cylinder in &throw.cylinders {
            let [rotating, reciprocating] = self.masses_of(cylinder)?;
            at_pin += rotating;
            to_and_fro += reciprocating;
        }
        let webs = self.crankshaft().webs.get(index).map_or_else(BigRational::zero, |web| &web.mass * &web.radius);
        let radius = self.radius_of(throw)?;
        Some([at_pin * &radius + webs, to_and_fro * radius])
    }

    /// The balance factor of each throw, `Σ m_cw r_cw` of its own counterweights over [`Engine::throw_mass_radii`]
    /// (theory, section 7); a skewed weight counts in full.
    ///
    /// `None` where the layout gives no masses or no crank radius, and for a throw without mass.
    pub fn balance_factors(&self) -> Vec<Option<BigRational>> {
        let factor = |(index, throw): (usize, Throw)| {
            let whole = self.mass_radius_of(index, &throw).filter(|whole| !whole.is_zero())?;
            Some(self.own_weights(index) / whole)
        };
        throws(self).into_iter().enumerate().map(factor).collect()
    }

    /// The crankshaft's mass in the sense of the theory's source (section 7): that of the balance equations, the
    /// masses of the throws brought to their crank radii, half the reciprocating ones among them, and the counterweights.
    /// With the same mass D a throw and counterweights at the crank radius it is `N·D·(1 + BF)`. In kilograms.
    pub fn crankshaft_mass(&self) -> Option<BigRational> {
        let throw =
            |(index, throw): (usize, Throw)| Some(self.mass_radius_of(index, &throw)? / self.radius_of(&throw)?);
        let throws: Option<BigRational> = throws(self).into_iter().enumerate().map(throw).sum();
        Some(throws? + self.crankshaft().counterweights.iter().map(|weight| &weight.mass).sum::<BigRational>())
    }

    /// The bob weights of a throw for a factor of the reciprocating masses, such as ½.
    ///
    /// Pin and webs are no part of it: they turn on the balancing machine themselves.
    pub fn bob_weight(&self, index: usize, factor: &BigRational) -> Option<BobWeight> {
        let throw = throws(self).into_iter().nth(index)?;
        let of_cylinder = |&cylinder: &usize| {
            let [rotating, reciprocating] = self.masses_of(cylinder)?;
            Some(rotating + reciprocating * factor)
        };
        let per_cylinder = throw.cylinders.iter().map(of_cylinder).collect::<Option<Vec<_>>>()?;
        let per_throw = per_cylinder.iter().sum();
        Some(BobWeight { per_cylinder, per_throw })
    }

    /// The ends of the crankshaft along z: by its length, or else the outermost main bearings and cylinders; `None` where the
    /// file gives neither length nor bearings.
    pub fn shaft_ends(&self) -> Option<[BigRational; 2]> {
        let positions = || self.cylinders().iter().map(|cylinder| &cylinder.position);
        if let Some(length) = &self.crankshaft().length {
            let two = BigRational::from_integer(2.into());
            let middle = (positions().min()? + positions().max()?) / &two;
            let half = length / two;
            return Some([&middle - &half, middle + half]);
        }
        if self.bearings().is_empty() {
            return None;
        }
        let all = || positions().chain(self.bearings());
        Some([all().min()?.clone(), all().max()?.clone()])
    }
}
