//! How large is a moment of a star, in newton-metres? As that of the layout: with all that turns on its throws.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::problem::ProblemError;
use crate::engine::{Engine, Rods, Throw, throws};
use crate::loads::{self, Arm};
use crate::motion::SliderCrank;

/// What turns the moments of stars into newton-metres.
#[derive(Clone, Debug)]
pub struct Sizes {
    /// m_rec r of a throw, times the spacing and the square of the speed.
    reciprocating: f64,
    /// What turns at a throw less its counterweights, likewise.
    turning: f64,
    crank: SliderCrank,
}

fn refused(what: &str) -> ProblemError {
    ProblemError::new(format!("newton-metres need {what}"))
}

impl Sizes {
    /// Those of an engine in line: its masses, crank radius, rod, speed and spacing.
    ///
    /// # Errors
    /// What the layout lacks, or what belongs to its own star alone.
    pub fn new(engine: &Engine) -> Result<Self, ProblemError> {
        let [first, others @ ..] = engine.cylinders() else { return Err(refused("a layout with cylinders")) };
        let in_line = others.iter().all(|cylinder| cylinder.bank == first.bank);
        if !engine.geared_cranks().is_empty() || !in_line {
            return Err(refused("a layout in line"));
        }
        let parts = engine.throw_parts();
        let scale = loads::scale(engine).zip(parts);
        let (scale, parts) =
            scale.ok_or_else(|| refused("the masses, the crank radius and the speed of the layout"))?;
        let mut places: Vec<&BigRational> = engine.cylinders().iter().map(|cylinder| &cylinder.position).collect();
        places.sort();
        places.dedup();
        let gaps: Vec<BigRational> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let spacing = gaps.first().filter(|_| Arm::of(engine) == Arm::Metre);
        let spacing = spacing.filter(|first| gaps.iter().all(|gap| gap == *first));
        let spacing = spacing.ok_or_else(|| refused("one spacing of all cylinders of the layout, in line"))?;
        let Rods::Alike(rod) = engine.all_rods() else {
            return Err(refused("the connecting rods of the layout, alike at all throws"));
        };
        let [reciprocating, turning] = of_a_throw(engine, &parts)?;
        let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone());
        let crank = crank.map_err(|error| ProblemError::new(error.to_string()))?;
        let scaled = |mass_radius: BigRational| {
            (mass_radius * spacing).to_f64().unwrap_or(f64::INFINITY) * scale.omega() * scale.omega()
        };
        Ok(Sizes { reciprocating: scaled(reciprocating), turning: scaled(turning), crank })
    }

    /// The largest length in a revolution of a moment of one m r ω² c_k times the spacing, in newton-metres. What turns with the crank has
    /// order 1 of the same star.
    pub fn newton_metres(&self, order: u32) -> f64 {
        let coefficient = self.crank.coefficient(order);
        let [re, im] = [coefficient.re, coefficient.im].map(|part| self.reciprocating * part.to_float() / 2.0);
        let turning = if order == 1 { self.turning } else { 0.0 };
        // A direct vector and a reverse one: along the cylinders they are added, where what turns is not overbalanced.
        (re + turning).hypot(im) + re.hypot(im)
    }
}

/// `m_rec r` of each throw, and `m_rot r` less its counterweights: what a star with any other throws has too.
fn of_a_throw(engine: &Engine, parts: &[[BigRational; 2]]) -> Result<[BigRational; 2], ProblemError> {
    let crankshaft = engine.crankshaft();
    let Some(first) = parts.first().filter(|first| parts.iter().all(|other| other == *first)) else {
        return Err(refused("masses and crank radii that are alike at all throws"));
    };
    if !crankshaft.balancers.is_empty() {
        return Err(refused("a layout without balancer shafts, which are those of its own star"));
    }
    let weights: Option<Vec<BigRational>> =
        throws(engine).iter().enumerate().map(|(index, throw)| counterweights(engine, index, throw)).collect();
    let is_own = |weights: &Vec<BigRational>| {
        let all = crankshaft.counterweights.iter().all(|weight| weight.throw.is_some());
        all && weights.iter().all(|weight| *weight == weights[0])
    };
    let weights = weights.filter(is_own).ok_or_else(|| {
        refused(
            "counterweights that are alike at all throws, opposite to the crankpin and with the throw in their middle",
        )
    })?;
    let [turning, reciprocating] = first.clone();
    Ok([reciprocating, turning - weights.first().cloned().unwrap_or_else(BigRational::zero)])
}

/// The mass-radius of a throw's own counterweights; none where they do not act opposite to its pin.
fn counterweights(engine: &Engine, index: usize, throw: &Throw) -> Option<BigRational> {
    let own = engine.crankshaft().counterweights.iter().filter(|weight| weight.throw == Some(index));
    let (mut all, mut arm) = (BigRational::zero(), BigRational::zero());
    for weight in own {
        if weight.angle != throw.angle.opposite() {
            return None;
        }
        arm += weight.mass_radius() * (&weight.position - &throw.position);
        all += weight.mass_radius();
    }
    arm.is_zero().then_some(all)
}
