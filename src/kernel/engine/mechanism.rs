//! What moves a piston? A crank with a connecting rod of its own, or a link on the rod of another cylinder.

use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::exact::Turn;
use crate::motion::{CorrectedLinkage, HungLink, LinkMotion, Linkage, PistonMotion, SliderCrank};

/// What moves the piston of a cylinder: the harmonics of its motion are the coefficients c_k and t_k.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mechanism {
    /// A crank and a connecting rod, with or without an offset of the cylinder axis. A Scotch yoke moves as the infinitely
    /// long rod λ = 0 does.
    SliderCrank(Rod),
    /// An articulated rod: a link on a knuckle pin of the master rod.
    Link(Link),
}

/// A connecting rod and how its cylinder stands to the crankshaft.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rod {
    /// Rod ratio λ = r/l.
    pub ratio: BigRational,
    /// Offset δ = e/l: the cylinder axis passes the crankshaft at the distance e, on the side of ψ = 90° of its own crank: that
    /// towards which the pin moves after dead centre.
    pub offset: BigRational,
}

impl Rod {
    /// Whether the cylinder axis meets the crankshaft.
    pub fn is_centric(&self) -> bool {
        self.offset.is_zero()
    }

    /// `e/(r + l)`, the sine of the angle by which its piston stands highest after its crankpin is in line with the axis.
    pub fn highest_after(&self) -> BigRational {
        &self.offset / (BigRational::one() + &self.ratio)
    }

    /// The same rod with its cylinder on the side of ψ = 90°, or centric.
    pub fn unsigned(&self) -> Rod {
        Rod { ratio: self.ratio.clone(), offset: self.offset.abs() }
    }
}

/// An articulated rod. Its knuckle pin stands, seen from the crankpin, at `γ = Δ + ε` from the master rod: at the angle of its cylinder
/// where ε is 0. The master rod is centric, on the same crankpin.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Link {
    /// Rod ratio λ = r/l of the master rod.
    pub master: BigRational,
    /// Knuckle radius κ = a/l, from crankpin to knuckle pin, in lengths of the master rod.
    pub knuckle: BigRational,
    /// Δ: by how much the axis of its cylinder is ahead of that of the master's.
    pub angle: Turn,
    /// ε: by how much its knuckle pin is ahead of its cylinder, seen from the crankpin; less than a quarter turn either way.
    pub correction: Turn,
    /// r/L, L the length of the link.
    pub ratio: BigRational,
}

/// What moves a piston where no rod of its own is on the crankpin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotARod {
    /// A link on the rod of another cylinder.
    Link,
}

impl fmt::Display for NotARod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            NotARod::Link => "articulated rods",
        })
    }
}

/// The rods of all pistons of an engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rods<'a> {
    /// Nothing is known of them.
    Unknown,
    /// Each piston has one on its crankpin, all like this one.
    Alike(&'a Rod),
    /// Each piston has one on its crankpin, and they differ.
    Differ,
    /// Some piston has none.
    Without(NotARod),
}

impl Mechanism {
    /// Whether the orders of the inertia torque are judged, and its values enclosed: of what is no rod on the crankpin they are decimals.
    pub fn has_judged_torque(&self) -> bool {
        self.rod().is_some()
    }

    /// The motion of its piston, in decimals.
    pub fn piston(&self) -> PistonMotion {
        match self {
            Mechanism::SliderCrank(rod) => match SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) {
                Ok(crank) => PistonMotion::Crank(crank),
                Err(_) => unreachable!("an engine's mechanisms turn round"),
            },
            Mechanism::Link(link) => PistonMotion::Link(link.motion()),
        }
    }

    /// Whether the crank can turn round.
    pub fn turns_round(&self) -> bool {
        match self {
            Mechanism::SliderCrank(rod) => !rod.ratio.is_negative() && turns_round(rod),
            Mechanism::Link(link) => link.turns_round(),
        }
    }

    /// What it is, where it is no rod on the crankpin.
    pub fn not_a_rod(&self) -> Option<NotARod> {
        match self {
            Mechanism::SliderCrank(_) => None,
            Mechanism::Link(_) => Some(NotARod::Link),
        }
    }

    /// The rod of its own that is on the crankpin; none of a link.
    pub fn rod(&self) -> Option<&Rod> {
        match self {
            Mechanism::SliderCrank(rod) => Some(rod),
            Mechanism::Link(_) => None,
        }
    }

    /// The rod on the crankpin that moves its piston: its own, or the master's of a link.
    pub fn rod_on_the_pin(&self) -> Rod {
        match self {
            Mechanism::SliderCrank(rod) => rod.clone(),
            Mechanism::Link(link) => link.master_rod(),
        }
    }

    /// The link on another rod.
    pub fn link(&self) -> Option<&Link> {
        match self {
            Mechanism::SliderCrank(_) => None,
            Mechanism::Link(link) => Some(link),
        }
    }
}

impl Link {
    /// The rod that it hangs on.
    pub fn master_rod(&self) -> Rod {
        Rod { ratio: self.master.clone(), offset: BigRational::zero() }
    }

    /// γ: where its knuckle pin stands, seen from the crankpin, from the master rod on.
    pub fn knuckle_angle(&self) -> Turn {
        &self.angle + &self.correction
    }

    /// Whether its knuckle pin is elsewhere than at the angle of its cylinder.
    pub fn is_corrected(&self) -> bool {
        self.correction != Turn::zero()
    }

    /// What it hands on to the crankpin of its master rod, in decimals.
    pub fn hung(&self) -> HungLink {
        HungLink::new([&self.ratio, &self.knuckle, &self.master], [self.angle.turns(), self.correction.turns()])
    }

    /// Its motion, in decimals.
    pub fn motion(&self) -> LinkMotion {
        LinkMotion::new([&self.ratio, &self.knuckle, &self.master], [self.angle.turns(), self.correction.turns()])
    }

    /// The part of its motion that the master rod does not give it, where its knuckle angle is not corrected.
    pub fn linkage(&self) -> Option<Linkage> {
        Linkage::new(self.ratio.clone(), self.knuckle.clone(), self.angle.turns().clone())
    }

    /// The same where it is.
    pub fn corrected(&self) -> Option<CorrectedLinkage> {
        CorrectedLinkage::new([&self.ratio, &self.knuckle, &self.master], [self.angle.turns(), self.correction.turns()])
    }

    fn turns_round(&self) -> bool {
        let master = &self.master;
        let moves = if self.is_corrected() { self.corrected().is_some() } else { self.linkage().is_some() };
        !master.is_negative() && *master < BigRational::one() && moves
    }
}

/// An offset crank that is nearer to its end than a millionth would take too many points to integrate.
fn turns_round(rod: &Rod) -> bool {
    let sum = &rod.ratio + rod.offset.abs();
    match rod.offset.is_zero() {
        true => sum < BigRational::one(),
        false => sum <= BigRational::new(999_999.into(), 1_000_000.into()),
    }
}
