//! How are firing stars stated in Coq? As the torque of cylinders whose cranks turn once in a cycle, each behind by its firing angle.

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::every_order::Pattern;
use super::parts::Parts;
use super::{NotStated, file};
use crate::proof::{
    CycleClaim, Cylinder, Document, FiringClaim, FiringCylinder, FiringDocument, Format, Masses, Quantity,
    RodStatement, VerdictClaim,
};
use crate::text::coq_comment;

/// A file as that of [`super::coq_file`], on the firing stars: which orders of the gas torque vanish, whatever the pressure law is.
///
/// # Errors
/// What the stars have that the file cannot state.
pub fn coq_file_of_firing(document: &FiringDocument) -> Result<String, NotStated> {
    let (cycle, order) = match document.cycle {
        CycleClaim::FourStroke => ("two revolutions", "k/2"),
        CycleClaim::TwoStroke => ("one revolution", "k"),
    };
    let head = format!(
        "(* {}: firing stars, each a theorem.

   A cylinder fires once in a cycle of {cycle}. Here a turn is a cycle: order k is order {order} of the crank, and theta runs
   through 2 pi in a cycle; the throw of a cylinder is minus its firing angle, its mass the crank radius times the deflection of the
   mode. So [torque] is order k of the gas torque of all cylinders, and c that of one: any, whatever the pressure law is.",
        coq_comment(&document.title)
    );
    let engine = as_engine(document);
    let parts = Parts::of(&engine);
    file(&head, &engine, &parts, &Pattern::of_cycle(document, &engine, &parts))
}

/// One turn of this engine is a cycle.
fn as_engine(document: &FiringDocument) -> Document {
    let revolutions = BigRational::from_integer(match document.cycle {
        CycleClaim::FourStroke => 2.into(),
        CycleClaim::TwoStroke => 1.into(),
    });
    let in_cycles = |order: &BigRational| (order * &revolutions).to_integer().to_u32();
    let cylinder = |cylinder: &FiringCylinder| Cylinder {
        name: cylinder.name.clone(),
        throw: -(&cylinder.firing_angle / &revolutions),
        bank: BigRational::zero(),
        position: BigRational::zero(),
        reciprocating_mass: &cylinder.crank_radius * &cylinder.deflection,
        crank_radius: BigRational::one(),
        rod: RodStatement::Unknown,
        knuckle_weight: BigRational::zero(),
        speed: 1,
        crankshaft: None,
    };
    let verdict = |claim: &FiringClaim| {
        Some(VerdictClaim {
            quantity: Quantity::TORQUE,
            order: in_cycles(&claim.order)?,
            sense: None,
            of: claim.of.clone(),
            vanishes: claim.vanishes,
            terms: claim.terms.clone(),
            modulus: claim.modulus,
            angle_deg: claim.angle_deg,
            certificate: claim.certificate.clone(),
        })
    };
    Document {
        format: Format::Classify,
        title: document.title.clone(),
        masses: Masses::Reciprocating,
        orders: document.orders.iter().filter_map(in_cycles).collect(),
        quantities: vec![Quantity::TORQUE],
        all_orders: false,
        reference_plane: BigRational::zero(),
        cylinders: document.cylinders.iter().map(cylinder).collect(),
        turning_masses: Vec::new(),
        verdicts: document.verdicts.iter().filter_map(verdict).collect(),
        wholes: Vec::new(),
        shapes: Vec::new(),
        theorems: Vec::new(),
        recurrences: Vec::new(),
    }
}
