//! What is the star of one order, and is it zero?

use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::{CycleOrder, Engine, Firing, Mechanism};
use crate::exact::{PhasorSum, Term};
use crate::order::Source;
use crate::proof::{Certificate, Quantity};
use crate::text::counted;
use crate::verdict::JudgedStar;

/// What each cylinder's vector is multiplied by besides its crank radius.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Weights {
    /// By one: the torque of a rigid crankshaft.
    #[default]
    Rigid,
    /// By the deflection of its throw in a mode of torsional vibration, one per cylinder.
    ModeShape(Vec<BigRational>),
}

impl Weights {
    /// That of one cylinder.
    pub fn of(&self, cylinder: usize) -> BigRational {
        match self {
            Weights::Rigid => num_traits::One::one(),
            Weights::ModeShape(shape) => shape[cylinder].clone(),
        }
    }

    /// Whether it is a mode of torsional vibration.
    pub fn is_mode_shape(&self) -> bool {
        match self {
            Weights::Rigid => false,
            Weights::ModeShape(_) => true,
        }
    }

    /// Whether there is one for each of this many cylinders, and not 0 for all.
    ///
    /// # Errors
    /// [`NoStar::ModeShape`], [`NoStar::NoDeflection`].
    pub fn fit(&self, cylinders: usize) -> Result<(), NoStar> {
        match self {
            Weights::ModeShape(shape) if shape.len() != cylinders => {
                Err(NoStar::ModeShape { values: shape.len(), cylinders })
            }
            Weights::ModeShape(shape) if shape.iter().all(Zero::is_zero) => Err(NoStar::NoDeflection),
            Weights::Rigid | Weights::ModeShape(_) => Ok(()),
        }
    }
}

/// Why there is no firing star.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoStar {
    /// The layout says neither in which order nor when the cylinders fire.
    #[error(
        "the layout does not say when the cylinders fire; above the first table, add firing_order = \"1-3-4-2\" with the cylinders in the order of \
                 their firing, or firing_angles in degrees, one per cylinder; of a two-stroke engine cycle = \"two-stroke\" is enough"
    )]
    NoFiring,
    /// Two pistons share each cylinder, and what is asked is known only of those alike, with known angles, on a rigid crankshaft.
    #[error(
        "firing stars of opposed pistons are decided where the two move alike in all cylinders, of known angles, and without a mode shape; torque gives the orders of any"
    )]
    OpposedPistons,
    /// Infinitely long rods have several offsets.
    #[error(
        "firing stars of infinitely long rods (rod_ratio = 0) are decided where all have one offset; give a rod_ratio above 0"
    )]
    EndlessRods,
    /// A half order of an engine that fires once per revolution.
    #[error("order {0} does not exist in a two-stroke engine: its cycle is one revolution; ask for whole orders")]
    HalfOrder(CycleOrder),
    /// A crankshaft turns faster than the reference: how often its cylinders fire in a cycle is not asked.
    #[error(
        "when the cylinders of crankshafts of different speeds fire is not decided; firing stars are those of crankshafts that turn equally fast"
    )]
    FasterCrank,
    /// The mode shape has another number of values than the engine has cylinders.
    #[error("the mode shape has {} for {}; one per cylinder is needed", counted(*.values, "value"), counted(*.cylinders, "cylinder"))]
    ModeShape {
        /// How many values it has.
        values: usize,
        /// How many cylinders there are.
        cylinders: usize,
    },
    /// The mode shape deflects no throw.
    #[error("a mode shape without deflection is none; one value at least is not 0")]
    NoDeflection,
}

/// One order of the gas torque: a star for each class of cylinders that make the same torque from the same pressure.
#[derive(Clone, Debug)]
pub struct StarOrder {
    /// The order κ.
    pub order: CycleOrder,
    /// The stars, in the order of the first cylinder of each; one where all cylinders have the same rod ratio and offset.
    pub stars: Vec<FiringStar>,
}

/// The star of cylinders that make the same torque from the same pressure, in multiples of their crank radius.
#[derive(Clone, Debug)]
pub struct FiringStar {
    /// Whose vectors they are, in the order of the cylinders.
    pub sources: Vec<Source>,
    /// The sum, one term per cylinder.
    pub sum: PhasorSum,
    /// The evidence.
    pub certificate: Certificate,
}

impl StarOrder {
    pub(super) fn new(engine: &Engine, firing: &Firing, order: CycleOrder, weights: &Weights) -> Self {
        let star = |(cylinders, sum): (Vec<usize>, PhasorSum)| FiringStar {
            sources: cylinders.into_iter().map(Source::Piston).collect(),
            certificate: sum.certificate(),
            sum,
        };
        StarOrder { order, stars: sums(engine, firing, order, weights).into_iter().map(star).collect() }
    }

    /// Whether the order vanishes for every pressure law that all cylinders share.
    ///
    /// Stars of different classes do not cancel for every law: their torques from one pressure are not proportional, since rods
    /// of another ratio or offset have their dead points of `cos β` elsewhere.
    pub fn vanishes(&self) -> bool {
        self.stars.iter().all(FiringStar::vanishes)
    }

    /// The one star of an engine whose cylinders are all alike.
    pub fn only(&self) -> Option<&FiringStar> {
        match self.stars.as_slice() {
            [only] => Some(only),
            _ => None,
        }
    }

    /// Whether the firing phases of all cylinders agree, whatever the weights are: what all add is the sum of these.
    pub fn is_major(&self) -> bool {
        let mut phases = self.stars.iter().flat_map(|star| star.sum.terms()).map(|term| &term.angle);
        let first = phases.next();
        phases.all(|phase| Some(phase) == first)
    }
}

impl FiringStar {
    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

impl<'a> From<&'a FiringStar> for JudgedStar<'a> {
    fn from(star: &'a FiringStar) -> Self {
        let FiringStar { sources, sum, certificate } = star;
        JudgedStar { quantity: Quantity::TORQUE, sources, sum, certificate }
    }
}

/// The sum of each class of cylinders, with the cylinders in it.
pub(super) fn sums(
    engine: &Engine,
    firing: &Firing,
    order: CycleOrder,
    weights: &Weights,
) -> Vec<(Vec<usize>, PhasorSum)> {
    let term = |&cylinder: &usize| Term {
        angle: order.phase(angle_of(firing, cylinder)),
        weight: &engine.cylinders()[cylinder].crank_radius * weights.of(cylinder),
    };
    let sum = |cylinders: Vec<usize>| {
        let terms = cylinders.iter().map(term).collect();
        (cylinders, PhasorSum::new(terms))
    };
    classes(engine).into_iter().map(sum).collect()
}

/// When a cylinder fires, in turns of the crank after the first of the firing order.
fn angle_of(firing: &Firing, cylinder: usize) -> &BigRational {
    let shot = firing.shots.iter().find(|shot| shot.cylinder == cylinder);
    &shot.unwrap_or_else(|| unreachable!("each cylinder fires once in a cycle")).angle
}

/// The cylinders by rod ratio and offset, in the order of the first of each; one class where no rod is known. Of two pistons in one cylinder the
/// first stands for both: where they move alike in all, what they turn the crank with is in proportion to its star.
fn classes(engine: &Engine) -> Vec<Vec<usize>> {
    let mut classes: Vec<(&Option<Mechanism>, Vec<usize>)> = Vec::new();
    for index in engine.firing_pistons() {
        let mechanism = &engine.cylinders()[index].mechanism;
        match classes.iter_mut().find(|(own, _)| *own == mechanism) {
            Some((_, members)) => members.push(index),
            None => classes.push((mechanism, vec![index])),
        }
    }
    classes.into_iter().map(|(_, members)| members).collect()
}
