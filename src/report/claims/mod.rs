//! How are claims answered, as a person reads it? A table of answers, a page with its certificates.

mod counterweights;
mod evidence;
mod finding;
mod forces;
mod gas_torque;
mod orders;
mod page;
mod shaking;
mod student;

pub use evidence::evidence as claim_evidence;
pub use finding::{claim_finding, claim_finding_on, claim_status, needs as claim_needs};
pub use page::{claims_answer, claims_page};
pub use student::table_finding;
