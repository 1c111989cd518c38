//! When do pistons stand highest whose axes miss the crankshaft? Beside the angles that firing is counted by.

use crate::engine::{DeadCentre, Engine, Mechanism, Rod};
use crate::numbers::float;
use crate::page::Text;
use crate::report::texts::dead_centres as text;

/// What firing angles count, with the intervals from one top dead centre to the next, where offsets move these apart; else nothing.
pub(super) fn counted(engine: &Engine) -> Option<Text> {
    let firing = engine.firing().filter(|_| engine.has_dead_centres_apart())?;
    let mut angles: Vec<f64> = firing
        .shots
        .iter()
        .map(|shot| {
            let rod = engine.cylinders()[shot.cylinder].mechanism.as_ref().and_then(Mechanism::rod);
            360.0 * float(&shot.angle) + rod.map_or(0.0, after_alignment)
        })
        .collect();
    angles.sort_by(f64::total_cmp);
    let first = angles.first()? + 360.0 * float(&firing.cycle.turns());
    let intervals: Vec<f64> =
        angles.iter().skip(1).chain([&first]).zip(&angles).map(|(next, angle)| next - angle).collect();
    let [least, most] =
        [intervals.iter().copied().fold(f64::INFINITY, f64::min), intervals.iter().copied().fold(0.0, f64::max)];
    let counted = text::firing_angles(Text::figures(least), Text::figures(most));
    let by_piston = engine.gas().is_some_and(|gas| gas.chambers.iter().any(|one| one.zero == DeadCentre::Piston));
    Some(if by_piston { counted.and(" ").and(text::gas_by_piston()) } else { counted })
}

/// By how many degrees after its pin is in line with its axis a piston stands highest: `arcsin(e/(r + l))`.
fn after_alignment(rod: &Rod) -> f64 {
    float(&rod.highest_after()).asin().to_degrees()
}
