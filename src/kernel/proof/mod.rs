//! What counts as evidence, and does it hold? The vocabulary of certificates and their checker.
//!
//! Nothing of the solver is imported here: a certificate is data, and this room re-derives what it claims with
//! arithmetic of its own.
//!
#![doc = include_str!("README.md")]

mod agreement;
mod alternative;
mod any_document;
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
mod format;
mod fraction;
mod judged;
mod knuckle;
mod laurent;
mod left_out;
mod link;
mod loads_check;
mod motion;
mod open;
mod open_check;
mod outside;
mod part;
mod plane;
mod quadratic;
mod quadratic_check;
mod quantity;
mod reading;
mod recurrence;
mod recurrence_check;
mod refusal;
mod remedy;
mod remedy_check;
mod rod;
mod roll;
mod shape;
mod sizes;
mod source;
mod splitting;
mod theorem;
mod theorem_check;
mod triangle_check;
mod twist_check;
mod unknown;
mod vector;
mod verdict;
mod when;
mod whole;
mod whole_sum;

pub use alternative::{AlternativeClaim, ConditionClaim};
pub use any_document::{AnyDocument, read_document};
pub use audit::{Counts, Fault, Reason};
pub use boxes::{BoxZeroClaim, BoxesClaim};
pub use certificate::{Certificate, Polygon, Residue, Step};
pub use check::check_certificate;
pub use checked::Checked;
pub use circle::{ArcClaim, CircleClaim, CoprimeClaim, DividedClaim};
pub use coefficient::{Coefficient, GearedClaim};
pub use decimals::Decimal;
pub use document::Document;
pub use document_check::check_document;
pub use engine::{CrankClaim, Cylinder, Masses, RodStatement, TurningMassClaim};
pub use evidence::EvidenceDocument;
pub use firing::{CycleClaim, FiringClaim, FiringCylinder, FiringDocument, PatternClaim, PatternVerdict};
pub use firing_check::check_firing_document;
pub use format::Format;
pub use knuckle::{KnuckleClaim, Part};
pub use link::{LinkClaim, LinkageClaim};
pub use motion::coefficient_bounds;
pub use open::{
    CosineClaim, Exact, LinearClaim, OpenCylinder, OpenDocument, OpenVerdictClaim, PartClaim, ProductClaim, SumClaim,
    WhenClaim,
};
pub use open_check::check_open_document;
pub use outside::{COMPARE_NOT_CHECKED, LOADS_NOT_CHECKED};
pub use plane::{ClassesClaim, MeetingClaim, TriangleClaim, TriangleShape};
pub use quadratic::{QuadraticClaim, RootClaim, RootsClaim, TwistClaim};
pub use quantity::{Axial, Planar, Quantity, Sense};
pub use reading::{Difference, LARGEST_DOCUMENT, Unreadable};
pub use recurrence::{ClassClaim, FactorClaim, FirstOrderClaim, RayClaim, RecurrenceClaim, SumVerdict, Zeros};
pub use refusal::{MOST_STEPS, Refusal};
pub use remedy::{CorrectedClaim, LeftOutClaim, RemedyDocument, RodCylinder, TurningClaim, WeightClaim, WeightPart};
pub use remedy_check::check_remedy_document;
pub use rod::RodClaim;
pub use shape::{Shape, ShapeClaim, ShapeEvidence};
pub use theorem::{OrderClaim, Survivors, TheoremClaim};
pub use vector::Vector;
pub use verdict::VerdictClaim;
pub use whole_sum::{WholeClaim, WholeOutcome};
