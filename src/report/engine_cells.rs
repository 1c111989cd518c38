//! How is an engine put in a few cells: its firing, the first order left, the remedy?

use super::residual;
use super::typeset;
use crate::engine::{Engine, Firing, Shot, firing_pistons};
use crate::page::{Text, phrase};
use crate::proof::Planar;
use crate::remedy::{Kind, Remedy, RemedyError, Shaft};
use crate::report::texts::engine_cells as text;
use crate::verdict::{EveryOrderTheorem, FirstLeft, NoTheorem, OrderBalance, OrderVerdict};

/// Of more intervals than this only the least and the largest are given.
const MOST_INTERVALS: usize = 4;

/// How many cylinders: with its pistons, where two of these share one.
pub(super) fn cylinders(engine: &Engine) -> Text {
    let (pistons, cylinders) = (engine.cylinders().len(), firing_pistons(engine.cylinders()).len());
    if pistons == cylinders { cylinders.into() } else { phrase!("{} with {} pistons", cylinders, pistons) }
}

/// `even, 180°`, `uneven: 405°, 315°`; `not given` where the layout does not say.
pub fn firing(firing: Option<&Firing>) -> Text {
    let Some(firing) = firing else { return "not given".into() };
    let intervals = firing.intervals();
    let turns = |turns| Text::from(typeset::turns_in_decimals(turns));
    match intervals.as_slice() {
        [first, ..] if firing.is_even() => phrase!("even, {}", turns(first)),
        uneven if uneven.len() <= MOST_INTERVALS => {
            phrase!("uneven: {}", Text::joined(uneven.iter().map(turns), ", "))
        }
        uneven => match (uneven.iter().min(), uneven.iter().max()) {
            (Some(least), Some(largest)) => phrase!("uneven: {} to {}", turns(least), turns(largest)),
            _ => Text::default(),
        },
    }
}

/// `1-3-4-2`; `not given` where the layout does not say. Cylinders that fire together are in brackets.
pub(super) fn firing_order(engine: &Engine) -> Text {
    let Some(firing) = engine.firing() else { return "not given".into() };
    let together = firing.shots.chunk_by(|one, other| one.angle == other.angle);
    let name = |shot: &Shot| engine.cylinders()[shot.cylinder].name.as_str();
    let groups = together.map(|shots| match shots {
        [only] => name(only).to_owned(),
        several => format!("({})", typeset::listed(several.iter().map(name))),
    });
    Text::label(groups.collect::<Vec<_>>().join("-"))
}

/// The lowest order of the force and of the moment that is left, of all that exist: `2, planar`, or `none`. Without a theorem the verdicts
/// tell it where they are on every order up to that one.
pub(super) fn first_left(
    engine: &Engine,
    theorem: &Result<EveryOrderTheorem, NoTheorem>,
    judged: &[OrderVerdict],
) -> [Text; 2] {
    let not_stated: &'static str = match theorem {
        Ok(theorem) => return Planar::BOTH.map(|quantity| first(theorem, engine, quantity)),
        Err(NoTheorem::PeriodTooLong(_) | NoTheorem::TooManyCandidates(_)) => "not stated: long period",
        Err(NoTheorem::Shaft(_)) => "not stated: balancer shafts",
        Err(NoTheorem::FasterCrank(_)) => "not stated: crankshafts of several speeds",
        Err(NoTheorem::RodsDiffer) => "not stated: rods differ",
    };
    Planar::BOTH.map(|quantity| first_judged(engine, judged, quantity).unwrap_or_else(|| not_stated.into()))
}

/// The lowest order that is left, where all below it are judged or do not exist.
fn first_judged(engine: &Engine, judged: &[OrderVerdict], quantity: Planar) -> Option<Text> {
    for order in 1..=judged.last()?.order {
        match judged.iter().find(|verdict| verdict.order == order) {
            Some(verdict) if verdict.whole(quantity).is_left() => {
                return Some(phrase!("{}, {}", order, residual::shape_name(verdict.whole(quantity).shape)));
            }
            Some(verdict) if verdict.exists() && !verdict.whole(quantity).is_balanced() => return None,
            None if engine.has_order(order) => return None,
            _ => {}
        }
    }
    None
}

fn first(theorem: &EveryOrderTheorem, engine: &Engine, quantity: Planar) -> Text {
    match theorem.first_left(engine, quantity) {
        FirstLeft::Nothing => "none".into(),
        FirstLeft::Order(order, shape) => phrase!("{}, {}", order, residual::shape_name(shape)),
        FirstLeft::NotKnown => "not decided".into(),
    }
}

/// A cell of an order: the whole, and what each of its sums leaves where there are several.
pub(super) fn cell(order: &OrderVerdict, quantity: Planar) -> Text {
    let [force, moment] = residual::whole(order);
    let is_force = quantity == Planar::Force;
    let whole = if is_force { force } else { moment };
    let words = if is_force { residual::force } else { residual::moment };
    let part = |part: &OrderBalance| {
        let class = part.class.as_ref()?;
        Some(phrase!("{}: {}", residual::class_sources(class), words(part)))
    };
    let parts: Vec<Text> = order.parts.iter().filter_map(part).collect();
    // What every sum has is said once: that it is 0, or that the order does not exist.
    match parts.is_empty() || whole.is_zero() || !order.exists() {
        true => whole,
        false => phrase!("{} ({})", whole, Text::joined(parts, "; ")),
    }
}

/// `2 counterweights (couple); shaft −1 (couple); Lanchester pair ±2`, or `none needed`.
pub(super) fn remedy(remedy: &Result<Remedy, RemedyError>) -> Text {
    let remedy = match remedy {
        Ok(remedy) => remedy,
        Err(RemedyError::Missing(_)) => return "not stated: masses cannot be compared".into(),
        Err(_) => return text::not_stated(),
    };
    let on_the_crankshaft = remedy.crankshaft.iter().filter(|shaft| remedy.stays(&shaft.weights));
    let mut words: Vec<Text> = on_the_crankshaft.map(counterweights).collect();
    let mut shafts = remedy.shafts_built().peekable();
    while let Some(shaft) = shafts.next() {
        let is_one = |of: &Shaft| remedy.crank_of(of).is_none();
        let partner = shafts.next_if(|next| next.order == shaft.order && is_one(shaft) && is_one(next));
        let order = shaft.order;
        words.push(match (partner, remedy.crank_of(shaft)) {
            (Some(_), _) if shaft.lanchester => phrase!("Lanchester pair ±{}", order),
            (Some(other), _) if other.kind == shaft.kind => phrase!("shafts ±{} ({} each)", order, kind(shaft)),
            (Some(other), _) => phrase!("shafts +{} ({}) and −{} ({})", order, kind(shaft), order, kind(other)),
            (None, Some(crank)) => phrase!("{} on crankshaft {}", counterweights(shaft), crank.name.clone()),
            (None, None) => text::shaft(shaft.sense, order, kind(shaft)),
        });
    }
    let on_the_crank = remedy.crankshaft.as_ref().filter(|shaft| !remedy.stays(&shaft.weights));
    words.extend(on_the_crank.map(|shaft| match remedy.changes_counterweights() {
        true => text::counterweights_taken_away(),
        false => text::taken_away(shaft.sense, shaft.order),
    }));
    let taken_away = remedy.shafts.iter().filter(|shaft| !remedy.stays(&shaft.weights));
    words.extend(taken_away.map(|shaft| text::taken_away(shaft.sense, shaft.order)));
    if words.is_empty() { "none needed".into() } else { Text::joined(words, "; ") }
}

fn counterweights(shaft: &Shaft) -> Text {
    match shaft.weights.len() {
        1 => phrase!("1 counterweight ({})", kind(shaft)),
        count => phrase!("{} counterweights ({})", count, kind(shaft)),
    }
}

fn kind(shaft: &Shaft) -> &'static str {
    match shaft.kind {
        Kind::Force => "force",
        Kind::Couple => "couple",
        Kind::ForceAndMoment => "force and moment",
    }
}
