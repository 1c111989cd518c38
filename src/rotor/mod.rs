//! Which masses balance a shaft? Masses, radii, angles and planes that are wanted, exactly, with all solutions or the reason why there is none.
//!
//! With `U = m r e^{iβ}` a shaft is balanced where `ΣU = 0` and `ΣzU = 0`: four real equations (theory, section 7). Whether they hold,
//! and whether what is wanted exists, is decided by exact sums; what is found is exact where a closed form is known.

mod exact;
mod secondary;
mod solve;
mod triangle;

use num_rational::BigRational;

use crate::exact::{PhasorSum, Term};
use crate::file::{Rotor, RotorMass};
pub use exact::Real;
pub use secondary::{Secondary, secondary};

/// What is known of masses on a shaft.
#[derive(Clone, Debug)]
pub enum Answer {
    /// Nothing is wanted, and nothing is left: proved.
    Balanced,
    /// Nothing is wanted, and this is left: `ΣU` and `ΣzU` about position 0.
    Residual(Box<[PhasorSum; 2]>),
    /// All solutions: one, or two that are mirrored.
    Found(Vec<Vec<Found>>),
    /// No masses balance it.
    Never(Reason),
    /// Any of many do.
    Many(Reason),
}

/// Why there is no solution, or more than can be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// Both wanted masses are in one plane, and a couple is left.
    OnePlane,
    /// The wanted mass can balance the force, but then a couple is left.
    Couple,
    /// The forces cannot be balanced in these directions.
    Force,
    /// A couple is left in a direction in which the wanted masses balance no force.
    CoupleAlone,
    /// The one mass would have to be in no plane: force and couple are not parallel.
    NotParallel,
    /// Both wanted masses are in one line, and their planes are free.
    OneLine,
    /// Of three moments about the plane of the wanted mass, one is larger than the other two together.
    NoTriangle,
    /// Balanced without the wanted masses, so that their planes and directions are free.
    BalancedAlready,
}

/// What was found of a mass.
#[derive(Clone, Debug)]
pub struct Found {
    /// Which mass, by its index.
    pub index: usize,
    /// Mass times radius in kilogram-metres; below 0 it is at half a turn more than the angle of the file.
    pub mass_radius: Real,
    /// The vector itself, where it is a sum of vectors at rational angles.
    pub vector: Option<PhasorSum>,
    /// The direction in degrees from 0 to 360; of a mass of 0 any would do.
    pub angle: f64,
    /// The cosine of the direction against that of the first mass without an angle, where that is rational.
    pub cosine: Option<BigRational>,
    /// Where it stands, in metres, where that was wanted.
    pub position: Option<Real>,
}

/// Which unknowns are not solved for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotSolved;

impl std::fmt::Display for NotSolved {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(
            "these unknowns are not solved for; what may be omitted: mass (or radius) and angle of one or two masses; of one of them its position too; the masses of one \
             or two whose angles are given, with or without their positions; mass and angle of one with the angles of three others, or of two of them, or its mass alone with the angles of all three; with secondary = true the angles of four cranks in planes symmetric about the middle and the masses of the inner two, the outer two being equal",
        )
    }
}

impl std::error::Error for NotSolved {}

/// Which parts of a mass are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Wanted {
    size: bool,
    angle: bool,
    position: bool,
}

impl Wanted {
    fn of(mass: &RotorMass) -> Self {
        Wanted {
            size: mass.mass.is_none() || mass.radius.is_none(),
            angle: mass.angle.is_none(),
            position: mass.position.is_none(),
        }
    }

    fn is_none(self) -> bool {
        !(self.size || self.angle || self.position)
    }
}

/// `m r` of a known mass with its share of the reciprocating mass.
fn mass_radius(rotor: &Rotor, mass: &RotorMass) -> Option<BigRational> {
    Some((mass.mass.as_ref()? + &rotor.share * &mass.reciprocating) * mass.radius.as_ref()?)
}

/// `ΣU` and `ΣzU` about position 0 of the masses of which all is known, each of this weight.
fn sums(rotor: &Rotor, weight: impl Fn(&RotorMass) -> Option<BigRational>) -> [PhasorSum; 2] {
    let known = rotor.masses.iter().filter(|mass| Wanted::of(mass).is_none());
    let terms = known.filter_map(|mass| {
        let (angle, weight, at) = (mass.angle.clone()?, weight(mass)?, mass.position.as_ref()?);
        let couple = Term { angle: angle.clone(), weight: &weight * at };
        Some([Term { angle, weight }, couple])
    });
    let (force, couple) = terms.map(|[force, couple]| (force, couple)).unzip();
    [PhasorSum::new(force), PhasorSum::new(couple)]
}

/// What balances these masses.
///
/// # Errors
/// Unknowns that are not solved for.
pub fn balance(rotor: &Rotor) -> Result<Answer, NotSolved> {
    solve::solve(rotor, sums(rotor, |mass| mass_radius(rotor, mass)))
}

/// What the share of the reciprocating masses that is balanced in two wheels does, and what the rest does; lengths of stars of order 1,
/// in kilogram-metres and kilogram square metres: times ω² they are newtons and newton-metres.
#[derive(Clone, Debug)]
pub struct Locomotive {
    /// The hammer blow of each wheel.
    pub hammer_blow: [PhasorSum; 2],
    /// Variation of the tractive force.
    pub tractive: PhasorSum,
    /// Swaying couple about the middle between the wheels.
    pub swaying: PhasorSum,
}

/// Those of a shaft whose two wanted masses are in the planes of the wheels; none where nothing reciprocates.
pub fn locomotive(rotor: &Rotor) -> Option<Locomotive> {
    let wheels: Vec<&BigRational> = rotor
        .masses
        .iter()
        .filter(|mass| Wanted::of(mass) == Wanted { size: true, angle: true, position: false })
        .filter_map(|mass| mass.position.as_ref())
        .collect();
    let has = rotor.masses.iter().any(|mass| mass.reciprocating > BigRational::from_integer(0.into()));
    let [one, other] = wheels.as_slice() else { return None };
    if !has || one == other {
        return None;
    }
    let [force, couple] = sums(rotor, |mass| Some(&mass.reciprocating * mass.radius.as_ref()?));
    let rest = BigRational::from_integer(1.into()) - &rotor.share;
    let middle = (*one + *other) / BigRational::from_integer(2.into());
    let part =
        |at: &BigRational, from: &BigRational| couple.minus(&force.scaled(from)).scaled(&(&rotor.share / (at - from)));
    Some(Locomotive {
        hammer_blow: [part(one, other), part(other, one)],
        tractive: force.scaled(&rest),
        swaying: couple.minus(&force.scaled(&middle)).scaled(&rest),
    })
}
