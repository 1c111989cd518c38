//! What is an engine, as far as its balance goes? A draft that holds together.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::build_error::BuildError;
use super::convention::Convention;
use super::crankshaft::{Counterweight, Crankshaft};
use super::cycle::Cycle;
use super::cylinder::Cylinder;
use super::dimensions::Dimensions;
use super::draft::{Draft, ReferencePlane};
use super::effects::Effects;
use super::firing::Firing;
use super::flywheel::Flywheel;
use super::form::Form;
use super::gas::Gas;
use super::length::{Length, LengthUnit};
use super::mechanism::{Link, Mechanism, NotARod, Rod, Rods};
use super::mounting::Mounting;
use super::title_block::TitleBlock;
use super::torsion::Torsion;
use crate::exact::Turn;
use crate::proof::Quantity;
use crate::text::Untrusted;

/// An engine, in exact numbers. What it holds fits together: see [`BuildError`](super::BuildError) for what does not.
///
/// `A` are its angles and `L` its lengths: known here, with unknowns in a [`Family`](super::Family).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Engine<A = Turn, L = BigRational> {
    draft: Draft<A, L>,
    reference_plane: L,
    orders: Vec<u32>,
}

impl<A, L> Engine<A, L> {
    /// An engine whose draft was checked.
    pub(super) fn new(draft: Draft<A, L>, reference_plane: L, orders: Vec<u32>) -> Self {
        Engine { draft, reference_plane, orders }
    }

    /// What it is called in a report.
    pub fn title(&self) -> &Untrusted {
        &self.draft.title
    }

    /// Where the crank star is published.
    pub fn source(&self) -> Option<&Untrusted> {
        self.draft.source.as_ref()
    }

    /// Which form of layout file describes it.
    pub fn form(&self) -> Form {
        self.draft.form
    }

    /// How its file draws it. The angles of the engine grow in the sense of rotation whatever that is.
    pub fn convention(&self) -> Convention {
        self.draft.convention
    }

    /// The cylinders, one at least, each with a name of its own.
    pub fn cylinders(&self) -> &[Cylinder<A, L>] {
        &self.draft.cylinders
    }

    /// Position of the plane that moments are taken about.
    pub fn reference_plane(&self) -> &L {
        &self.reference_plane
    }

    /// Whether the reference plane was named; else it is the middle of the cylinders.
    pub fn reference_plane_given(&self) -> bool {
        matches!(self.draft.reference_plane, ReferencePlane::Named(_))
    }

    /// What positions are counted in.
    pub fn length_unit(&self) -> LengthUnit {
        self.draft.length_unit
    }

    /// Whether the positions are those of a real engine; else the cylinders are one spacing apart.
    pub fn positions_given(&self) -> bool {
        self.draft.positions_given
    }

    /// Whether positions are in metres: those with a unit, and numbers alone beside a crank radius.
    pub fn is_in_metres(&self) -> bool {
        self.length_unit() == LengthUnit::Metre || self.positions_given() && self.dimensions().crank_radius.is_some()
    }

    /// The orders that are asked for, rising; the usual ones where none are.
    pub fn orders(&self) -> &[u32] {
        &self.orders
    }

    /// Whether orders are asked for.
    pub fn orders_given(&self) -> bool {
        !self.draft.orders.is_empty()
    }

    /// The part of the largest order from which on an order is listed separately, where it is given.
    pub fn above(&self) -> Option<&BigRational> {
        self.draft.above.as_ref()
    }

    /// Two-stroke or four-stroke, where that is known.
    pub fn cycle(&self) -> Option<Cycle> {
        self.draft.cycle
    }

    /// When the cylinders fire, where that is known.
    pub fn firing(&self) -> Option<&Firing> {
        self.draft.firing.as_ref()
    }

    /// The names of the cylinders as they fire, `1-3-4-2`, where that is known.
    pub fn firing_order(&self) -> Option<String> {
        let names = self.firing()?.shots.iter().map(|shot| self.cylinders()[shot.cylinder].name.as_str());
        Some(names.collect::<Vec<_>>().join("-"))
    }

    /// What presses on the pistons; none where nothing is known of it.
    pub fn gas(&self) -> Option<&Gas> {
        self.draft.gas.as_ref()
    }

    /// What is known, or wanted, of the flywheel.
    pub fn flywheel(&self) -> &Flywheel {
        &self.draft.flywheel
    }

    /// Positions of the main bearings, of each crankshaft where several are geared together; none where nothing is known of them.
    pub fn bearings(&self) -> &[BigRational] {
        &self.draft.bearings
    }

    /// What the engine measures and weighs.
    pub fn dimensions(&self) -> &Dimensions {
        &self.draft.dimensions
    }

    /// Masses on the crankshaft, and the balancer shafts that it drives.
    pub fn crankshaft(&self) -> &Crankshaft {
        &self.draft.crankshaft
    }

    /// The shaft as discs and springs, where its torsional vibration is asked about.
    pub fn torsion(&self) -> Option<&Torsion> {
        self.draft.torsion.as_ref()
    }

    /// The engine as a rigid body on its mounts, where that is asked about.
    pub fn mounting(&self) -> Option<&Mounting> {
        self.draft.mounting.as_ref()
    }

    /// What is asked for beyond force and moment.
    pub fn effects(&self) -> Effects {
        self.draft.effects
    }

    /// What is in the title block of a calculation report.
    pub fn title_block(&self) -> &TitleBlock {
        &self.draft.title_block
    }

    /// The layout file that it was read from; empty where it was not.
    pub fn file(&self) -> &Untrusted {
        &self.draft.file
    }

    /// The draft that it was built from.
    pub(super) fn draft(&self) -> &Draft<A, L> {
        &self.draft
    }

    /// A draft to change: what it says may no longer hold together.
    pub fn into_draft(self) -> Draft<A, L> {
        self.draft
    }

    /// The cylinders with what moves their pistons; none where nothing is known of that.
    pub fn moved(&self) -> impl Iterator<Item = (&Cylinder<A, L>, &Mechanism)> {
        self.cylinders().iter().filter_map(|cylinder| Some((cylinder, cylinder.mechanism.as_ref()?)))
    }

    /// The connecting rods, in the order of the cylinders; none where nothing is known of them.
    pub fn rods(&self) -> impl Iterator<Item = &Rod> {
        self.cylinders().iter().filter_map(Cylinder::rod)
    }

    /// The rods of all pistons as one answer: what holds of rods on the crankpins alone asks this.
    pub fn all_rods(&self) -> Rods<'_> {
        match (self.only_rods(), self.mechanisms().as_slice()) {
            (Err(other), _) => Rods::Without(other),
            (Ok(()), []) => Rods::Unknown,
            (Ok(()), [Mechanism::SliderCrank(rod)]) => Rods::Alike(rod),
            (Ok(()), _) => Rods::Differ,
        }
    }

    /// Whether Scotch yokes without an offset, which are read as endless rods, move all pistons.
    pub fn has_yokes_alone(&self) -> bool {
        matches!(self.all_rods(), Rods::Alike(rod) if rod.ratio.is_zero() && rod.offset.is_zero())
    }

    /// Whether no piston is moved otherwise than by a rod of its own on the crankpin, or nothing is known of it.
    ///
    /// # Errors
    /// What moves one otherwise.
    pub fn only_rods(&self) -> Result<(), NotARod> {
        self.moved().find_map(|(_, mechanism)| mechanism.not_a_rod()).map_or(Ok(()), Err)
    }

    /// Whether some rod is a link on another.
    pub fn has_links(&self) -> bool {
        self.cylinders().iter().any(|cylinder| cylinder.link().is_some())
    }

    /// Whether the orders of the inertia torque of all cylinders are judged.
    pub fn has_judged_torque(&self) -> bool {
        self.moved().all(|(_, mechanism)| mechanism.has_judged_torque())
    }

    /// Whether each piston has one rotating vector in each order and sense of the force.
    pub fn has_one_vector_per_order(&self) -> bool {
        self.moved().all(|(_, mechanism)| mechanism.has_one_vector_per_order())
    }

    /// The different mechanisms of its cylinders, in their order; none where nothing is known of them.
    pub fn mechanisms(&self) -> Vec<&Mechanism> {
        let mut different: Vec<&Mechanism> = Vec::new();
        for mechanism in self.cylinders().iter().filter_map(|cylinder| cylinder.mechanism.as_ref()) {
            if !different.contains(&mechanism) {
                different.push(mechanism);
            }
        }
        different
    }
}

impl<A, L: Length> Engine<A, L> {
    /// Arm of a cylinder: its position measured from the reference plane.
    pub fn arm(&self, cylinder: &Cylinder<A, L>) -> L {
        cylinder.position.less(&self.reference_plane)
    }
}

impl Engine {
    /// Whether the rod of a cylinder loads its crankpin by itself: it is no link, and has none.
    pub fn has_plain_rod(&self, cylinder: usize) -> bool {
        let own = &self.cylinders()[cylinder];
        own.link().is_none() && !self.cylinders().iter().any(|other| own.is_master_of(other))
    }

    /// The same engine with these masses on its crankshaft and these shafts.
    ///
    /// # Errors
    /// What does not fit.
    pub fn with_crankshaft(&self, crankshaft: Crankshaft) -> Result<Engine, BuildError> {
        Draft { crankshaft, ..self.clone().into_draft() }.build()
    }

    /// The same engine with its counterweights replaced; balance factors are those of no file then.
    ///
    /// # Errors
    /// What does not fit.
    pub fn with_counterweights(&self, counterweights: Vec<Counterweight>) -> Result<Engine, BuildError> {
        let bare = self.crankshaft().clone();
        self.with_crankshaft(Crankshaft { counterweights, balance_factors: Vec::new(), ..bare })
    }

    /// Whether some cylinder axis misses the crankshaft, so that every order exists.
    pub fn has_offset(&self) -> bool {
        self.rods().any(|rod| !rod.offset.is_zero())
    }

    /// Whether some piston has an odd order of the force above the first: infinitely long rods have none, whatever their offset is.
    pub fn has_odd_orders(&self) -> bool {
        self.mechanisms().iter().any(|mechanism| mechanism.has_order(Quantity::FORCE, 3))
    }

    /// Whether offsets move the top dead centres of cylinders by different angles, so that they are not as far apart as the firing angles.
    pub fn has_dead_centres_apart(&self) -> bool {
        let mut moved = self.rods().map(Rod::highest_after);
        self.has_offset() && moved.next().is_some_and(|first| moved.any(|other| other != first))
    }

    /// Whether order 1 of every piston is `cos ψ`, and no other odd order is there: no offset, and no corrected knuckle angle.
    pub fn is_centric(&self) -> bool {
        self.mechanisms().iter().all(|mechanism| mechanism.is_centric())
    }

    /// Whether the knuckle pin of some link is elsewhere than at the angle of its cylinder.
    pub fn has_corrected_links(&self) -> bool {
        self.cylinders().iter().filter_map(Cylinder::link).any(Link::is_corrected)
    }

    /// Whether every reciprocating mass and crank radius is 1, so that weights need not be shown.
    pub fn has_unit_masses(&self) -> bool {
        self.cylinders().iter().all(|cylinder| cylinder.weight().is_one())
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
