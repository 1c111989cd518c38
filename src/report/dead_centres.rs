//! When do pistons stand highest whose axes miss the crankshaft? Beside the angles that firing is counted by.

use crate::engine::{DeadCentre, Engine};
use crate::page::Text;
use crate::report::texts::dead_centres as text;
use crate::sweep::dead_centre_intervals;

/// What firing angles count, with the intervals from one top dead centre to the next, where offsets move these apart; else nothing.
pub(super) fn counted(engine: &Engine) -> Option<Text> {
    let [least, most] = dead_centre_intervals(engine)?.map(Text::figures);
    let counted = text::firing_angles(least, most);
    let by_piston = engine.gas().is_some_and(|gas| gas.chambers.iter().any(|one| one.zero == DeadCentre::Piston));
    Some(if by_piston { counted.and(" ").and(text::gas_by_piston()) } else { counted })
}
