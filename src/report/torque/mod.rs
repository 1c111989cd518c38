//! Which torque of gas and inertia does an engine give through its cycle? The answer, plots, tables, what is assumed.

mod data;
mod page;
mod plots;
mod settings;
mod tables;
mod words;

pub(super) use page::{has_assumed, torque_section};
pub(super) use words::{angle, assumptions, double_acting, misfire, names, opposed, quantity, warning};

use super::question::question;
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

question!(TorqueStudy, "torque", |study| Some(study.engine.title()));
