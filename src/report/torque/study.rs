//! What is asked for the torque? Gas and inertia of an engine through its cycle.

use super::super::question::Question;
use super::data;
use super::{torque_answer, torque_page};
use crate::engine::Engine;
use crate::loads::Missing;
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;
use crate::torque::{EngineTorque, torque};

/// The torque of an engine.
pub struct TorqueStudy {
    /// The engine.
    pub engine: Engine,
    /// Its torque.
    pub torque: EngineTorque,
}

impl TorqueStudy {
    /// The torque of gas and inertia.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(engine: &Engine) -> Result<Self, Missing> {
        Ok(TorqueStudy { engine: engine.clone(), torque: torque(engine)? })
    }
}

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
