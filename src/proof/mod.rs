//! What counts as evidence, and does it hold? The vocabulary of certificates and their checker.
//!
//! Nothing of the solver is imported here: a certificate is data, and this room re-derives what it claims with
//! arithmetic of its own.
//!
#![doc = include_str!("README.md")]

mod audit;
mod ball;
mod boxes;
mod boxes_check;
mod certificate;
mod check;
mod checked;
mod circle;
mod circle_check;
mod classes_check;
mod coefficient;
mod collected;
mod coprime_check;
mod decimals;
mod divided_check;
mod document;
mod document_check;
mod enclosure;
mod engine;
mod evidence;
mod factor_check;
mod firing;
mod firing_check;
mod fraction;
mod judged;
mod knuckle;
mod left_out;
mod link;
mod open;
mod open_check;
mod outside;
mod plane;
mod product_check;
mod quadratic;
mod quadratic_check;
mod reading;
mod recurrence;
mod refusal;
mod remedy;
mod rod;
mod roll;
mod shape;
mod source;
mod splitting;
mod theorem;
mod triangle_check;
mod twist_check;
mod unknown;
mod verdict;
mod when;
mod whole;
mod whole_sum;

pub use audit::{Counts, Fault, MOST_STEPS, Reason};
pub use boxes::{BoxZeroClaim, BoxesClaim};
pub use certificate::{Certificate, Polygon, Residue, Step};
pub use check::check_certificate;
pub use checked::Checked;
pub use circle::{ArcClaim, CircleClaim, CoprimeClaim, DividedClaim};
pub use coefficient::{Coefficient, GearedClaim};
pub use decimals::Decimal;
pub use document::Document;
pub use document_check::check_document;
pub use engine::{
    Axial, CrankClaim, Cylinder, Masses, Planar, Quantity, RodClaim, RodStatement, Sense, TurningMassClaim,
};
pub use evidence::EvidenceDocument;
pub use firing::{CycleClaim, FiringClaim, FiringCylinder, FiringDocument, PatternClaim, PatternVerdict};
pub use firing_check::check_firing_document;
pub use knuckle::{KnuckleClaim, Part};
pub use link::{LinkClaim, LinkageClaim};
pub use open::{
    AlternativeClaim, ConditionClaim, Exact, LinearClaim, OpenCylinder, OpenDocument, OpenVerdictClaim, PartClaim,
    SumClaim, WhenClaim,
};
pub use open_check::check_open_document;
pub use plane::{ClassesClaim, MeetingClaim, ProductClaim, TriangleClaim, TriangleShape};
pub use quadratic::{QuadraticClaim, RootClaim, RootsClaim, TwistClaim};
pub use reading::{AnyDocument, Difference, Format, LARGEST_DOCUMENT, Unreadable, read_document};
pub use recurrence::{ClassClaim, FactorClaim, FirstOrderClaim, RayClaim, RecurrenceClaim, SumVerdict, Zeros};
pub use refusal::Refusal;
pub use remedy::{
    CorrectedClaim, LeftOutClaim, RemedyDocument, RodCylinder, TurningClaim, WeightClaim, WeightPart,
    check_remedy_document,
};
pub use rod::coefficient_bounds;
pub use shape::{Shape, ShapeClaim, ShapeEvidence};
pub use theorem::{OrderClaim, Survivors, TheoremClaim};
pub use verdict::{Vector, VerdictClaim};
pub use whole_sum::{WholeClaim, WholeOutcome};
