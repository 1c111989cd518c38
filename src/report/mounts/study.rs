//! What is a study of mounts to whoever asks it? Its tables, its pages.

use super::super::question::Question;
use super::data;
use super::{MountsStudy, page};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for MountsStudy {
    fn command(&self) -> &'static str {
        "mounts"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        page::answer(self)
    }

    fn page(&self) -> Document {
        page::page(self)
    }
}
