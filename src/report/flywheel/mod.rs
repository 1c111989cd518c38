//! What is asked of a turning-moment diagram? Its fluctuation of energy, and the flywheel.

mod data;
mod page;

use super::question::question;
use crate::file::Diagram;
use crate::flywheel::{self, Fluctuation, NoFluctuation};

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

question!(FlywheelStudy, "flywheel", |study| Some(&study.diagram.title));
