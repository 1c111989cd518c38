//! What is asked for the best counterweights? The front of an engine, with the couple that is allowed.

use super::amounts::Units;
use crate::engine::Engine;
use crate::file::FileResolver;
use crate::optimise::{Couple, Front, OptimiseError, Request, front};
use crate::page::File;

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
    pub fn new(engine: &Engine, request: Request, beside: FileResolver<'_>) -> Result<Self, OptimiseError> {
        let front = front(engine, &request, beside)?;
        Ok(OptimiseStudy { engine: engine.clone(), front, couple: request.couple, files: Vec::new() })
    }

    pub(in crate::report) fn units(&self) -> Units {
        Units::of(&self.engine, &self.front)
    }
}
