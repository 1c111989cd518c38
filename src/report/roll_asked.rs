//! What is said where the roll moment hangs on a length that the layout omits? Which key would give it.

use crate::engine::Engine;
use crate::order::MissingArm;
use crate::page::Text;
use crate::report::texts::roll_asked as text;

/// Why there is no roll moment, and what to write for it.
pub(super) fn roll_asked(engine: &Engine, missing: MissingArm) -> Text {
    match missing {
        MissingArm::EndlessRod => text::endless_rod(),
        MissingArm::Distance => text::crankshaft_distance(),
        MissingArm::Crankshaft(index) => {
            let name = engine.geared_cranks().get(index).map_or_else(String::new, |crank| crank.name.clone());
            text::crankshaft_place(name)
        }
        MissingArm::Balancer(index) => text::balancer_place(index + 1),
    }
}
