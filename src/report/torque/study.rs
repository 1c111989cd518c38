//! What is asked for the torque? Gas and inertia of an engine through its cycle.

use crate::engine::Engine;
use crate::loads::Missing;
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
