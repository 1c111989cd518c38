//! Which torque does the engine give, as a person reads it? The answer, plots, tables, what is assumed, a JSON document.

mod document;
mod page;
mod plots;
mod settings;
mod tables;
mod words;

pub use document::{TorqueDocument, torque_document};
pub(super) use page::{has_assumed, torque_section};
pub use page::{torque_answer, torque_page};
pub(super) use words::{angle, assumptions, names, quantity, warning};
