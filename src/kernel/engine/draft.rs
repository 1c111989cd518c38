//! How is an engine built? As a draft, whose fields are free, and which is an engine once it holds together.

use num_rational::BigRational;

use super::convention::Convention;
use super::crankshaft::Crankshaft;
use super::cycle::Cycle;
use super::cylinder::Cylinder;
use super::dimensions::Dimensions;
use super::effects::Effects;
use super::firing::Firing;
use super::flywheel::Flywheel;
use super::form::Form;
use super::gas::Gas;
use super::geared_crank::GearedCrank;
use super::length::LengthUnit;
use super::mounting::Mounting;
use super::open_firing::OpenFiring;
use super::title_block::TitleBlock;
use super::torsion::Torsion;
use crate::exact::Turn;
use crate::text::Untrusted;

/// An engine that is not checked yet: [`Draft::build`] makes it one.
///
/// ```
/// # use crankstar_kernel as crankstar;
/// use crankstar::{BigRational, Cylinder, Draft, Turn};
/// let mut draft = Draft::new("V-twin of 90 degrees");
/// for bank in [-1, 1] {
///     let position = BigRational::from_integer(0.into());
///     draft.cylinders.push(Cylinder::new(Turn::zero(), Turn::fraction(bank, 8), position, 0));
/// }
/// let engine = draft.build().unwrap();
/// assert_eq!(engine.cylinders()[1].name, "2");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draft<A = Turn, L = BigRational> {
    /// What it is called in a report.
    pub title: Untrusted,
    /// Where the crank star is published.
    pub source: Option<Untrusted>,
    /// Which form of layout file describes it.
    pub form: Form,
    /// How its file draws it; the angles here grow in the sense of rotation whatever that is.
    pub convention: Convention,
    /// The cylinders.
    pub cylinders: Vec<Cylinder<A, L>>,
    /// The crankshafts, where several are geared together; none where there is one, in the middle.
    pub geared_cranks: Vec<GearedCrank>,
    /// The plane that moments are taken about.
    pub reference_plane: ReferencePlane<L>,
    /// What positions are counted in.
    pub length_unit: LengthUnit,
    /// Whether the positions are those of a real engine; else the cylinders are one spacing apart.
    pub positions_given: bool,
    /// The orders that are asked for; none for the usual ones.
    pub orders: Vec<u32>,
    /// Two-stroke or four-stroke.
    pub cycle: Option<Cycle>,
    /// When the cylinders fire.
    pub firing: Option<Firing>,
    /// What a family says of its firing, whose angles hold unknowns; none in an engine.
    pub open_firing: Option<OpenFiring>,
    /// The part of the largest order from which on an order is listed separately, where it is given.
    pub above: Option<BigRational>,
    /// What presses on the pistons; none where nothing is known of it.
    pub gas: Option<Gas>,
    /// The cylinder that was kept from firing, by its index.
    pub misfire: Option<usize>,
    /// What is known, or wanted, of the flywheel.
    pub flywheel: Flywheel,
    /// Positions of the main bearings, of each crankshaft where several are geared together; none where nothing is known of them.
    pub bearings: Vec<BigRational>,
    /// What the engine measures and weighs.
    pub dimensions: Dimensions,
    /// Masses on the crankshaft, and the balancer shafts that it drives.
    pub crankshaft: Crankshaft,
    /// The shaft as discs and springs, where its torsional vibration is asked about.
    pub torsion: Option<Torsion>,
    /// The engine as a rigid body on its mounts, where that is asked about.
    pub mounting: Option<Mounting>,
    /// What is asked for beyond force and moment.
    pub effects: Effects,
    /// What is in the title block of a calculation report.
    pub title_block: TitleBlock,
    /// The layout file that it was read from; empty where it was not.
    pub file: Untrusted,
}

/// The plane across the crankshaft that moments are taken about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReferencePlane<L = BigRational> {
    /// The middle between the outermost cylinders.
    Middle,
    /// That of the family which the engine is a member of.
    OfFamily(L),
    /// This one.
    Named(L),
}

impl<A, L> Draft<A, L> {
    /// A draft without cylinders.
    pub fn new(title: &str) -> Self {
        Draft {
            title: Untrusted::new(title),
            source: None,
            form: Form::General,
            convention: Convention::default(),
            cylinders: Vec::new(),
            geared_cranks: Vec::new(),
            reference_plane: ReferencePlane::Middle,
            length_unit: LengthUnit::default(),
            positions_given: true,
            orders: Vec::new(),
            above: None,
            cycle: None,
            firing: None,
            open_firing: None,
            gas: None,
            misfire: None,
            flywheel: Flywheel::default(),
            bearings: Vec::new(),
            dimensions: Dimensions::default(),
            crankshaft: Crankshaft::default(),
            torsion: None,
            mounting: None,
            effects: Effects::default(),
            title_block: TitleBlock::default(),
            file: Untrusted::new(""),
        }
    }

    /// The same with other cylinders and another reference plane.
    pub(super) fn with_cylinders<B, M>(
        &self,
        cylinders: Vec<Cylinder<B, M>>,
        reference_plane: ReferencePlane<M>,
    ) -> Draft<B, M> {
        Draft {
            title: self.title.clone(),
            source: self.source.clone(),
            form: self.form,
            convention: self.convention,
            cylinders,
            geared_cranks: self.geared_cranks.clone(),
            reference_plane,
            length_unit: self.length_unit,
            positions_given: self.positions_given,
            orders: self.orders.clone(),
            above: self.above.clone(),
            cycle: self.cycle,
            firing: self.firing.clone(),
            open_firing: self.open_firing.clone(),
            gas: self.gas.clone(),
            misfire: self.misfire,
            flywheel: self.flywheel.clone(),
            bearings: self.bearings.clone(),
            dimensions: self.dimensions.clone(),
            crankshaft: self.crankshaft.clone(),
            torsion: self.torsion.clone(),
            mounting: self.mounting.clone(),
            effects: self.effects,
            title_block: self.title_block.clone(),
            file: self.file.clone(),
        }
    }
}
