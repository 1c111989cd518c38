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

use super::question::Question;
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for TorqueStudy {
    fn command(&self) -> &'static str {
        "torque"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        torque_answer(&self.engine, &self.torque)
    }

    fn page(&self) -> Document {
        torque_page(&self.engine, &self.torque)
    }
}
