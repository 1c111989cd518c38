//! What counts as evidence, and does it hold? The vocabulary of certificates and their checker.
//!
//! Nothing of the solver is imported here: a certificate is data, and this room re-derives what it claims with
//! arithmetic of its own.
//!
#![doc = include_str!("README.md")]

mod certificate;
mod check;
mod document;
mod fraction;
mod open;
mod remedy;
mod theorem;

pub use certificate::{Certificate, Polygon, Residue, Step};
pub use check::{Refusal, check_certificate};
pub use document::{
    Cylinder, Decimal, Document, Fault, Quantity, Sense, Shape, ShapeClaim, Vector, VerdictClaim, check_document,
};
pub use open::{
    AlternativeClaim, ConditionClaim, Exact, LinearClaim, OpenCylinder, OpenDocument, OpenVerdictClaim, PartClaim,
    SumClaim, WhenClaim, check_open_document,
};
pub use remedy::{
    CorrectedClaim, RemedyDocument, RodClaim, RodCylinder, TurningClaim, WeightClaim, WeightPart, check_remedy_document,
};
pub use theorem::{OrderClaim, Survivors, TheoremClaim};
