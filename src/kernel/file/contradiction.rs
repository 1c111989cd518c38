//! A firing that banks and throws cannot have: which mirror image, or which numbering, would fit?
//!
//! Exchanging the banks of a V turns its second pins by twice the bank angle (theory of mechanisms, section 4).

use std::ops::Range;

use num_rational::BigRational;

use super::error::LayoutError;
use super::numbering::{Along, renumbered};
use super::pin_split::{split_of, throws_of};
use super::shared_keys::evenly;
use crate::engine::{Convention, Cycle, Cylinder, Engine, Firing, Linear, Rotation};
use crate::exact::Turn;
use crate::proof::Sense;

/// A firing order that the throws cannot fire; `said` is what the engine says of it.
pub(super) fn of_order(
    said: (String, String),
    engine: &Engine,
    order: &[usize],
    cycle: Cycle,
    place: Option<Range<usize>>,
    fits: impl Fn(&[Cylinder]) -> Option<Firing>,
) -> LayoutError {
    let (message, right) = said;
    let cylinders = engine.cylinders();
    let open: Vec<Cylinder<Linear, Linear>> = cylinders.iter().map(opened).collect();
    let needed = split_of(&open, &throws_of(&open, &evenly(order, cycle)));
    let needed = needed.filter(|split| *split != Linear::default() && turns_one_way(engine));
    let needed = needed.map(|split| format!("with these banks this order needs pins {}° apart", split.in_degrees()));
    let right = match would_fit(engine, fits) {
        Some(words) => needed.into_iter().chain([words]).collect::<Vec<_>>().join("; "),
        None => format!("{right}; {}", steps(cylinders, order)),
    };
    LayoutError::new(message, right, place)
}

/// Firing angles that the throws cannot have.
pub(super) fn of_angles(
    said: (String, String),
    engine: &Engine,
    place: Option<Range<usize>>,
    fits: impl Fn(&[Cylinder]) -> Option<Firing>,
) -> LayoutError {
    let (message, right) = said;
    let right = would_fit(engine, fits).map_or(right.clone(), |words| format!("{right}; {words}"));
    LayoutError::new(message, right, place)
}

fn would_fit(engine: &Engine, fits: impl Fn(&[Cylinder]) -> Option<Firing>) -> Option<String> {
    let evenly = |cylinders: &[Cylinder]| fits(cylinders).map(|firing| firing.is_even());
    if turns_one_way(engine) {
        return what_would_fit(engine.cylinders(), engine.convention(), |angle: &Turn| -angle, evenly);
    }
    // The throws of a crankshaft against the others are those of its mirror image: of what is drawn only the whole is as easily turned.
    let negated = |cylinder: &Cylinder| Cylinder { throw: -&cylinder.throw, bank: -&cylinder.bank, ..cylinder.clone() };
    let turned: Vec<Cylinder> = engine.cylinders().iter().map(negated).collect();
    evenly(&turned).map(|_| drawn_otherwise(engine.convention()))
}

fn turns_one_way(engine: &Engine) -> bool {
    engine.geared_cranks().iter().all(|crank| crank.sense == Sense::Direct)
}

fn drawn_otherwise(convention: Convention) -> String {
    format!("as drawn it fits a crank that turns with {}", rotation_other_than(convention))
}

/// The angles from each top dead centre of the order to the next, which are all that this crankshaft has.
fn steps(cylinders: &[Cylinder], order: &[usize]) -> String {
    const MOST: usize = 16;
    let step = |(&one, &next): (&usize, &usize)| {
        let step = &cylinders[next].top_dead_centre() - &cylinders[one].top_dead_centre();
        format!("{}°", if step == Turn::zero() { BigRational::from_integer(360.into()) } else { step.degrees() })
    };
    let mut steps: Vec<String> = order.iter().zip(order.iter().cycle().skip(1)).map(step).take(MOST).collect();
    if order.len() > MOST {
        steps.push("…".to_owned());
    }
    format!("from each to the next it takes {}", steps.join(", "))
}

fn opened(cylinder: &Cylinder) -> Cylinder<Linear, Linear> {
    let angle = |turn: &Turn| Linear::constant(turn.turns().clone());
    let position = Linear::constant(cylinder.position.clone());
    let open = Cylinder::new(angle(&cylinder.throw), angle(&cylinder.bank), position, cylinder.pin);
    Cylinder { name: cylinder.name.clone(), ..open }
}

/// The same engine with each bank on the other side.
pub(super) fn banks_exchanged<A: Clone, L: Clone>(
    cylinders: &[Cylinder<A, L>],
    negated: impl Fn(&A) -> A,
) -> Vec<Cylinder<A, L>> {
    cylinders.iter().map(|cylinder| Cylinder { bank: negated(&cylinder.bank), ..cylinder.clone() }).collect()
}

/// What the file would have to say so that it fits, in one sentence; none where nothing near it would.
///
/// `fits` says whether an engine can fire so, and whether evenly: those that do are named before those that only can.
pub(super) fn what_would_fit<A: Clone + PartialEq, L: Clone>(
    cylinders: &[Cylinder<A, L>],
    convention: Convention,
    negated: impl Fn(&A) -> A,
    fits: impl Fn(&[Cylinder<A, L>]) -> Option<bool>,
) -> Option<String> {
    let other_throws = |cylinders: &[Cylinder<A, L>]| -> Vec<Cylinder<A, L>> {
        cylinders.iter().map(|cylinder| Cylinder { throw: negated(&cylinder.throw), ..cylinder.clone() }).collect()
    };
    let exchanged = banks_exchanged(cylinders, &negated);
    let turned = other_throws(&exchanged);
    let turns = drawn_otherwise(convention);
    let ways = [
        (Some(exchanged), BANKS),
        (Some(turned), &turns),
        (Some(other_throws(cylinders)), THROWS),
        (renumbered(cylinders, Along::Banks), "with numbering = \"per bank\" it fits"),
        (renumbered(cylinders, Along::Pins), "with numbering = \"alternating\" it fits"),
    ];
    let fitting: Vec<(bool, &str)> =
        ways.into_iter().filter_map(|(engine, words)| fits(&engine?).map(|evenly| (evenly, words))).collect();
    let evenly = fitting.iter().any(|(evenly, _)| *evenly);
    let words: Vec<&str> = fitting.iter().filter(|(even, _)| *even == evenly).map(|(_, words)| *words).collect();
    (!words.is_empty()).then(|| words.join("; "))
}

const BANKS: &str = "with the banks exchanged (bank_angle, or each bank, with the other sign) it fits this crankshaft: it turns the other way, or \
                     bank 1 is the other bank";

/// The key that turns the crank the other way than the file says.
pub(super) fn rotation_other_than(convention: Convention) -> &'static str {
    match convention.rotation {
        Rotation::Anticlockwise => "rotation = \"clockwise\"",
        Rotation::Clockwise => "rotation = \"anticlockwise\"",
    }
}

const THROWS: &str = "with the other sign of each throw it fits: who fires later has the throw behind";
