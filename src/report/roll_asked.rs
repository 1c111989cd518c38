//! What is said where the roll moment hangs on a length that the layout omits? Which key would give it.

use crate::engine::Engine;
use crate::order::MissingArm;
use crate::page::{Text, phrase};

/// Why there is no roll moment, and what to write for it.
pub(super) fn roll_asked(engine: &Engine, missing: MissingArm) -> Text {
    match missing {
        MissingArm::EndlessRod => ENDLESS.into(),
        MissingArm::Distance => DISTANCE.into(),
        MissingArm::Crankshaft(index) => {
            let name = engine.geared_cranks().get(index).map_or_else(String::new, |crank| crank.name.clone());
            phrase!(
                "The roll moment is not given: it depends on the position of crankshaft {}. Give height and offset, or distance and angle, in its table [[crankshaft]].",
                name
            )
        }
        MissingArm::Balancer(index) => phrase!(
            "The roll moment is not given: it depends on the position of balancer shaft {}. Give height and offset in its table [[balancer]].",
            index + 1
        ),
    }
}

const ENDLESS: &str = "The roll moment is not given: the offset of an endless rod is not a length. Give a rod_ratio above 0 below [mechanism].";
const DISTANCE: &str = "The roll moment is not given: it depends on the distance between the crankshafts through the rotating masses. Give distance below [opposed_piston].";
