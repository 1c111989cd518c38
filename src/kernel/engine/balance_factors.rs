//! How much of what turns and moves to and fro at a throw do its counterweights balance?

use num_rational::BigRational;
use num_traits::Zero;

use super::crankshaft::Counterweight;
use super::model::Engine;
use super::throws::{Throw, throws};

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
}
