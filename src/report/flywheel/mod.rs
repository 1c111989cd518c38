//! What is asked of a turning-moment diagram? Its fluctuation of energy, and the flywheel.

mod data;
mod page;

use super::question::Question;
use crate::file::Diagram;
use crate::flywheel::{self, Fluctuation, NoFluctuation};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

/// A turning-moment diagram with what it tells.
#[derive(Clone, Debug)]
pub struct FlywheelStudy {
    /// The diagram, as the file has it.
    pub diagram: Diagram,
    /// What it tells.
    pub fluctuation: Fluctuation,
}

impl FlywheelStudy {
    /// What this diagram tells.
    ///
    /// # Errors
    /// A load that does not fit the torque; angles of areas.
    pub fn new(diagram: Diagram) -> Result<Self, NoFluctuation> {
        Ok(FlywheelStudy { fluctuation: flywheel::fluctuation(&diagram)?, diagram })
    }
}

impl Question for FlywheelStudy {
    fn command(&self) -> &'static str {
        "flywheel"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(&self.diagram.title)
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
