//! What is a study of torsion to whoever asks it? Its tables, its pages.

use super::super::question::Question;
use super::study::TorsionStudy;
use super::{data, torsion_answer, torsion_page};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for TorsionStudy {
    fn command(&self) -> &'static str {
        "torsion"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        torsion_answer(self)
    }

    fn page(&self) -> Document {
        torsion_page(self)
    }
}
