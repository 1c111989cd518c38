//! How is an engine put in a few cells: its firing, the first order left, the remedy?

use super::residual;
use super::typeset;
use crate::engine::{DOES_NOT_EXIST, Firing};
use crate::proof::{Quantity, Sense};
use crate::remedy::{Kind, Remedy, RemedyError, Shaft};
use crate::verdict::{EveryOrder, NoTheorem, OrderBalance, OrderVerdict, Theorem};

/// More intervals than this are told by the least and the largest.
const MOST_INTERVALS: usize = 4;

/// `even, 180°`, `uneven: 405°, 315°`; `not given` where the layout does not say.
pub(super) fn firing(firing: Option<&Firing>) -> String {
    let Some(firing) = firing else { return "not given".to_owned() };
    let intervals = firing.intervals();
    match intervals.as_slice() {
        [first, ..] if firing.is_even() => format!("even, {}", typeset::turns(first)),
        uneven if uneven.len() <= MOST_INTERVALS => {
            format!("uneven: {}", uneven.iter().map(typeset::turns).collect::<Vec<_>>().join(", "))
        }
        uneven => match (uneven.iter().min(), uneven.iter().max()) {
            (Some(least), Some(largest)) => {
                format!("uneven: {} to {}", typeset::turns(least), typeset::turns(largest))
            }
            _ => String::new(),
        },
    }
}

/// The lowest order of the force and of the moment that is left, of all that exist: `2, planar`, or `none`.
pub(super) fn first_left(theorem: &Result<Theorem, NoTheorem>) -> [String; 2] {
    let one = |every: &EveryOrder| match &every.first {
        Some(first) => format!("{}, {}", first.direct.order, residual::shape_name(first.shape)),
        None => "none".to_owned(),
    };
    match theorem {
        Ok(theorem) => [one(&theorem.force), one(&theorem.moment)],
        Err(NoTheorem::PeriodTooLong(_)) => ["not stated: long period", "not stated: long period"].map(str::to_owned),
        Err(NoTheorem::Offset) => ["not stated: pin offset", "not stated: pin offset"].map(str::to_owned),
        Err(NoTheorem::Shaft(_)) => ["not stated: balancer shafts", "not stated: balancer shafts"].map(str::to_owned),
        Err(NoTheorem::RodsDiffer) => ["not stated: rods differ", "not stated: rods differ"].map(str::to_owned),
    }
}

/// A cell of an order: the whole, and what each of its sums leaves where there are several.
pub(super) fn cell(order: &OrderVerdict, quantity: Quantity) -> String {
    let [force, moment] = residual::whole_summary(order);
    let is_force = quantity == Quantity::Force;
    let whole = if is_force { force } else { moment };
    let words = if is_force { residual::force_summary } else { residual::moment_summary };
    let part = |part: &OrderBalance| {
        let class = part.class.as_ref()?;
        Some(format!("{}: {}", residual::class_sources(class), words(part)))
    };
    let parts: Vec<String> = order.parts.iter().filter_map(part).collect();
    // What every sum has is said once: that it is 0, or that the order does not exist.
    match parts.is_empty() || whole == "0" || whole == DOES_NOT_EXIST {
        true => whole,
        false => format!("{whole} ({})", parts.join("; ")),
    }
}

/// `2 counterweights (couple); shaft −1 (couple); Lanchester pair ±2`, or `none needed`.
pub(super) fn remedy(remedy: &Result<Remedy, RemedyError>) -> String {
    let remedy = match remedy {
        Ok(remedy) => remedy,
        Err(reason) => return format!("not stated: {}", missing(reason)),
    };
    let mut words: Vec<String> = remedy.crankshaft.iter().map(counterweights).collect();
    let mut shafts = remedy.shafts.iter().peekable();
    while let Some(shaft) = shafts.next() {
        let partner = shafts.next_if(|next| next.order == shaft.order);
        words.push(match partner {
            Some(_) if shaft.lanchester => format!("Lanchester pair ±{}", shaft.order),
            Some(other) if other.kind == shaft.kind => format!("shafts ±{} ({} each)", shaft.order, kind(shaft)),
            Some(other) => format!("shafts +{0} ({1}) and −{0} ({2})", shaft.order, kind(shaft), kind(other)),
            None => format!("shaft {}{} ({})", sign(shaft.sense), shaft.order, kind(shaft)),
        });
    }
    if words.is_empty() { "none needed".to_owned() } else { words.join("; ") }
}

fn missing(reason: &RemedyError) -> &'static str {
    match reason {
        RemedyError::Missing(_) => "masses cannot be compared",
        _ => "the planes or weights do not fit",
    }
}

fn counterweights(shaft: &Shaft) -> String {
    let count = shaft.weights.len();
    format!("{count} counterweight{} ({})", if count == 1 { "" } else { "s" }, kind(shaft))
}

fn kind(shaft: &Shaft) -> &'static str {
    match shaft.kind {
        Kind::Force => "force",
        Kind::Couple => "couple",
        Kind::ForceAndMoment => "force and moment",
    }
}

fn sign(sense: Sense) -> &'static str {
    if sense == Sense::Direct { "+" } else { "−" }
}

/// How remedies are read.
pub(super) const REMEDIES: &str = "A remedy takes away every vector of its orders exactly: counterweights on the crankshaft, balancer shafts at so many times \
    crank speed, + with the crank and − against it; a shaft for a couple has two opposite weights; a Lanchester pair is two shafts with one weight each.";
