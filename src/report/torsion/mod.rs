//! What is said of a crankshaft that twists? Frequencies, modes, critical speeds with the star of each, a Campbell diagram.

mod amounts;
mod barred;
mod damped;
mod damped_data;
mod damped_tables;
mod data;
mod excited;
mod forced;
mod gears;
mod page;
mod plots;
mod study;
mod tables;
mod vibration;
mod words;

pub use forced::ForcedTwist;
pub(super) use page::torsion_section;
pub use study::{NoTorsion, TorsionStudy};
pub use vibration::{
    Barred, DamperStudy, Excess, FoundDamper, HeatPlace, LargestTorque, ResonanceOrder, TwistAtSpeed, Vibration,
    VibrationOrder,
};

use super::question::question;

question!(TorsionStudy, "torsion", |study| Some(study.engine.title()));
