//! Does it fire evenly?

use num_rational::BigRational;

use super::answer::{Answer, Condition, Status};
use super::finding::Finding;
use crate::engine::{Cycle, Engine};
use crate::exact::Turn;

/// Answers a claim about the firing intervals; a layout without a firing order is asked for one that is even.
pub(super) fn answer(engine: &Engine, claimed: bool) -> Answer {
    let (status, finding) = match engine.firing() {
        Some(_) if engine.has_dead_centres_apart() => {
            return Answer::nothing(
                "firing angles count where crankpins are in line with their cylinders, and offsets move the dead centres of this engine apart",
            );
        }
        Some(firing) => (Status::of(firing.is_even() == claimed), Finding::Firing(Some(firing.intervals()))),
        None if engine.faster_crank().is_some() => {
            return Answer::nothing("when the cylinders of crankshafts of different speeds fire is not decided");
        }
        // One cylinder has one order, whichever the cycle is.
        None if engine.cylinders().len() == 1 => (Status::of(claimed), Finding::OneCylinder),
        None => {
            let cycles = engine.cycle().map_or(vec![Cycle::TwoStroke, Cycle::FourStroke], |cycle| vec![cycle]);
            let can: Vec<bool> = cycles.into_iter().map(|cycle| can_fire_evenly(engine, cycle)).collect();
            match (can.contains(&true), can.contains(&false), claimed) {
                (true, true, _) => {
                    return Answer::nothing(
                        "the layout gives no cycle, and the throws allow an even firing in one of both, of two or of four strokes, alone",
                    );
                }
                (true, false, true) => {
                    (Status::TrueOnlyIf { conditions: vec![Condition::FiringOrder], met: true }, Finding::Firing(None))
                }
                (true, false, false) => {
                    return Answer::nothing("the layout gives no firing order, and its throws allow an even one");
                }
                (false, _, claimed) => (Status::of(!claimed), Finding::NoEvenFiring),
            }
        }
    };
    Answer { status, finding, evidence: Vec::new() }
}

/// An engine of n cylinders fires evenly in some order iff its top dead centres, modulo a revolution, are those of the firing angles, 2j/n turns
/// where it has four strokes, j/n where it has two.
fn can_fire_evenly(engine: &Engine, cycle: Cycle) -> bool {
    let Some(first) = engine.cylinders().first().map(|cylinder| cylinder.top_dead_centre()) else { return false };
    let mut centres: Vec<Turn> =
        engine.cylinders().iter().map(|cylinder| &cylinder.top_dead_centre() - &first).collect();
    let count = centres.len();
    let mut even: Vec<Turn> =
        (0..count).map(|j| Turn::new(BigRational::new(j.into(), count.into()) * cycle.turns())).collect();
    centres.sort();
    even.sort();
    centres == even
}
