//! Who makes a force?

use num_rational::BigRational;

use super::masses::MassGroup;
use crate::engine::Engine;

/// What makes a force; by its index in the layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// The reciprocating mass of a cylinder.
    Piston(usize),
    /// The rotating mass of a cylinder's rod.
    BigEnd(usize),
    /// What the mass at the knuckle pin of a cylinder's link adds on the piston pin of the master rod.
    Knuckle(usize),
    /// What it adds on the crankpin.
    KnuckleAtPin(usize),
    /// What of that is on the master rod, turned from the throw by the knuckle angle.
    KnuckleOffPin(usize),
    /// The pin of a throw.
    Pin(usize),
    /// Both webs of a throw.
    Webs(usize),
    /// A counterweight.
    Counterweight(usize),
    /// A balancer shaft.
    Balancer(usize),
}

impl Source {
    /// The cylinder whose reciprocating mass it is; none of a mass that turns, or of a knuckle's.
    pub fn piston(self) -> Option<usize> {
        if let Source::Piston(index) = self { Some(index) } else { None }
    }

    /// The group that it belongs to.
    pub fn group(self) -> MassGroup {
        match self {
            Source::Piston(_) | Source::Knuckle(_) => MassGroup::Reciprocating,
            Source::BigEnd(_) | Source::KnuckleAtPin(_) | Source::KnuckleOffPin(_) => MassGroup::Rotating,
            Source::Pin(_) | Source::Webs(_) => MassGroup::Crankshaft,
            Source::Counterweight(_) => MassGroup::Counterweights,
            Source::Balancer(_) => MassGroup::Balancers,
        }
    }

    /// Where it stands along the crankshaft, where it is a part of a cylinder.
    pub fn position(self, engine: &Engine) -> Option<&BigRational> {
        match self {
            Source::Piston(index)
            | Source::BigEnd(index)
            | Source::Knuckle(index)
            | Source::KnuckleAtPin(index)
            | Source::KnuckleOffPin(index) => Some(&engine.cylinders()[index].position),
            Source::Pin(_) | Source::Webs(_) | Source::Counterweight(_) | Source::Balancer(_) => None,
        }
    }

    /// What it is called where there is little room: `2`, `rod 2`, `cw 1`.
    pub fn label(self, engine: &Engine) -> String {
        match self {
            Source::Piston(_) => self.name(engine),
            Source::BigEnd(index) if engine.has_yokes_alone() => format!("rot {}", engine.cylinders()[index].name),
            Source::BigEnd(index) => format!("rod {}", engine.cylinders()[index].name),
            Source::Knuckle(index) => format!("kn {}", engine.cylinders()[index].name),
            Source::KnuckleAtPin(index) => format!("kn {} on", engine.cylinders()[index].name),
            Source::KnuckleOffPin(index) => format!("kn {} off", engine.cylinders()[index].name),
            Source::Pin(index) => format!("pin {}", index + 1),
            Source::Webs(index) => format!("webs {}", index + 1),
            Source::Counterweight(index) => format!("cw {}", index + 1),
            Source::Balancer(index) => format!("shaft {}", index + 1),
        }
    }

    /// What it is called: a cylinder by its name, what turns by its number from 1.
    pub fn name(self, engine: &Engine) -> String {
        match self {
            Source::Piston(index) => engine.cylinders()[index].name.clone(),
            Source::BigEnd(index) if engine.has_yokes_alone() => {
                format!("rotating mass of cylinder {}", engine.cylinders()[index].name)
            }
            Source::BigEnd(index) => format!("big end of cylinder {}", engine.cylinders()[index].name),
            Source::Knuckle(index) => format!("knuckle of cylinder {}", engine.cylinders()[index].name),
            Source::KnuckleAtPin(index) => {
                format!("knuckle of cylinder {} on the crankpin", engine.cylinders()[index].name)
            }
            Source::KnuckleOffPin(index) => {
                format!("knuckle of cylinder {} off the crankpin", engine.cylinders()[index].name)
            }
            Source::Pin(index) => format!("pin {}", index + 1),
            Source::Webs(index) => format!("webs of throw {}", index + 1),
            Source::Counterweight(index) => format!("counterweight {}", index + 1),
            Source::Balancer(index) => format!("balancer shaft {}", index + 1),
        }
    }
}
