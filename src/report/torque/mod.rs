//! Which torque does the engine give, as a person reads it? The answer, plots, tables, what is assumed.

mod data;
mod page;
mod plots;
mod settings;
mod study;
mod tables;
mod words;

pub(super) use page::{LINKED_GUIDES, has_assumed, torque_section};
pub use page::{torque_answer, torque_page};
pub use study::TorqueStudy;
pub(super) use words::{angle, assumptions, double_acting, misfire, names, opposed, quantity, warning};
