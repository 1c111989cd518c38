//! What is answered of the main bearings: tables, a short answer, a page?

use super::super::journal::{complete_bearings_answer, complete_bearings_page, without_gas};
use super::super::question::Question;
use super::{BearingsStudy, bearings_answer, bearings_page, data};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for BearingsStudy {
    fn command(&self) -> &'static str {
        "bearings"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        let answer = || bearings_answer(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            None => answer(),
            Some(Err(lack)) => without_gas(answer(), lack),
            Some(Ok(loads)) => complete_bearings_answer(&self.engine, loads),
        }
    }

    fn page(&self) -> Document {
        let page = || bearings_page(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            None => page(),
            Some(Err(lack)) => without_gas(page(), lack),
            Some(Ok(loads)) => complete_bearings_page(&self.engine, loads, &self.continuous),
        }
    }
}
