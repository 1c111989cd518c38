//! What is asked for the best counterweights? The front of an engine, with the couple that is allowed.

use super::super::question::Question;
use super::amounts::Units;
use super::data;
use super::{optimise_answer, optimise_layouts, optimise_page};
use crate::engine::Engine;
use crate::file::FileResolver;
use crate::optimise::{Couple, Front, OptimiseError, Request, front_beside};
use crate::page::{Document, File};
use crate::table::Table;
use crate::text::Untrusted;

/// The best crankshafts of an engine.
pub struct OptimiseStudy {
    /// The engine.
    pub engine: Engine,
    /// Its best crankshafts.
    pub front: Front,
    /// What may remain of the first-order couple.
    pub couple: Couple,
    /// What the layout names beside itself, for the layouts of the points.
    pub files: Vec<File>,
}

impl OptimiseStudy {
    /// Finds them, for a layout that names files which `beside` reads.
    ///
    /// # Errors
    /// See [`OptimiseError`].
    pub fn new(engine: &Engine, wish: Request, beside: FileResolver<'_>) -> Result<Self, OptimiseError> {
        let front = front_beside(engine, &wish, beside)?;
        Ok(OptimiseStudy { engine: engine.clone(), front, couple: wish.couple, files: Vec::new() })
    }

    pub(in crate::report) fn units(&self) -> Units {
        Units::of(&self.engine, &self.front)
    }
}

impl Question for OptimiseStudy {
    fn command(&self) -> &'static str {
        "optimise"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        optimise_answer(&self.engine, &self.front, &self.couple)
    }

    fn page(&self) -> Document {
        optimise_page(&self.engine, &self.front, &self.couple)
    }

    /// The layout files of the points, and what they name.
    fn beside(&self) -> serde_json::Result<Vec<File>> {
        Ok(optimise_layouts(&self.front).into_iter().chain(self.files.iter().cloned()).collect())
    }
}
