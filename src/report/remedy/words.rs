//! What does a remedy come to, in sentences? What cancels what, what is proved, and what is good to know besides.

use num_rational::BigRational;
use num_traits::Signed;

use super::super::calculation::percent_at_most;
use super::super::engine_page::is_usually_cured;
use super::super::typeset;
use super::{ranked, weights};
use crate::numbers::float;
use crate::page::{Choice, Number, Piece, Text, Unit, phrase};
use crate::remedy::{Kind, PairHeight, Remedy, Shaft, Weight};

/// For a place such as `{force|couple|force and moment}`.
fn choice(kind: Kind) -> Text {
    let at = match kind {
        Kind::Force => 0,
        Kind::Couple => 1,
        Kind::ForceAndMoment => 2,
    };
    Choice::of(at).into()
}

/// The orders of a remedy.
fn orders(remedy: &Remedy) -> String {
    typeset::listed(&remedy.orders)
}

/// What cancels what, a sentence each, and the proof of it: the answer to what cures an engine.
pub fn remedy_cures(remedy: &Remedy) -> Vec<Text> {
    let mut lines = resized(remedy);
    let stays = |weights: &[Weight]| weights.iter().any(|weight| remedy.as_built(weight).is_some());
    if stays(&remedy.bays) {
        lines.push(phrase!(
            "Counterweights by the balance factors asked for: {}.",
            weights::listed(remedy, &remedy.bays)
        ));
    }
    let crankshaft = remedy.crankshaft.iter().filter(|shaft| stays(&shaft.weights));
    lines.extend(crankshaft.map(|shaft| on_the_crankshaft(remedy, shaft)));
    let mut shafts = remedy.shafts.iter().filter(|shaft| stays(&shaft.weights)).peekable();
    while let Some(shaft) = shafts.next() {
        let partner = shafts.next_if(|next| next.order == shaft.order && next.kind == shaft.kind);
        lines.push(match partner {
            Some(partner) => of_two(remedy, shaft, partner),
            None => of_one(remedy, shaft),
        });
    }
    lines.extend(remedy.left_out.iter().map(left_out));
    lines.push(proof(remedy));
    if remedy.subject.engine().faster_crank().is_some() {
        lines.extend(on_crankshafts(remedy));
        return lines;
    }
    match on_a_crankshaft(remedy) {
        Some((crank, others)) => {
            lines.push(phrase!(
                "The weight at 1× against the crank may sit on crankshaft {}, which turns against the reference, at the same position and angle; no extra shaft is needed. Force and moment do not depend on where its axis is, the roll moment does.",
                crank
            ));
            if others > 0 {
                lines.push(
                    "Counterweights cannot replace the other shafts: they act only on order 1, in the sense in which their crankshaft turns."
                        .into(),
                );
            }
        }
        None if remedy.shafts.is_empty() => {}
        None => lines.push(
            "Counterweights cannot replace these shafts: they act only on what turns with the crank at order 1.".into(),
        ),
    }
    lines
}

/// The weights of the file that become others.
fn resized(remedy: &Remedy) -> Vec<Text> {
    let planes = remedy.resized();
    let listed = Text::joined(planes.iter().map(|plane| weights::resized(remedy, plane)), "; ");
    (!planes.is_empty()).then(|| phrase!("Weights of the engine are resized: {}.", listed)).into_iter().collect()
}

/// Which shafts may be counterweights on a crankshaft that turns as they do, where crankshafts turn at different speeds.
fn on_crankshafts(remedy: &Remedy) -> Vec<Text> {
    let on_crank = remedy.shafts.iter().filter_map(|shaft| Some((shaft, remedy.crank_of(shaft)?)));
    let said = on_crank.map(|(shaft, crank)| {
        phrase!(
            "The weight at {}× {with|against} the crank may sit on crankshaft {}, which turns at this speed, at the same position and angle; no extra shaft is needed. Force and moment do not depend on where its axis is, the roll moment does.",
            shaft.order,
            shaft.sense,
            crank.name.clone()
        )
    });
    let mut lines: Vec<Text> = said.collect();
    if lines.len() < remedy.shafts.len() {
        lines.push(phrase!(
            "Counterweights cannot replace {these|the other} shafts: they act only on the first order of their own crankshaft, in the sense in which it turns.",
            lines.is_empty()
        ));
    }
    lines
}

/// The first crankshaft that turns against the reference, where a shaft of the remedy turns as it does, and how many other shafts there are.
fn on_a_crankshaft(remedy: &Remedy) -> Option<(Text, usize)> {
    let crank = remedy.shafts.iter().find_map(|shaft| remedy.crank_of(shaft))?;
    Some((crank.name.clone().into(), remedy.shafts.len() - 1))
}

/// What is too little for a weight.
fn left_out(shaft: &Shaft) -> Text {
    phrase!(
        "Nothing is proposed for what turns {with|against} the crank at order {}: its residual is below 10⁻⁶ of the load, which is the force of the pistons at order 1, added end to end.",
        shaft.sense,
        shaft.order
    )
}

fn on_the_crankshaft(remedy: &Remedy, shaft: &Shaft) -> Text {
    let listed = weights::listed(remedy, &shaft.weights);
    if let (Kind::Force, [_]) = (shaft.kind, &shaft.weights[..]) {
        return phrase!(
            "A counterweight on the crankshaft cancels the first-order force that turns with the crank: {}.",
            listed
        );
    }
    phrase!(
        "Counterweights on the crankshaft cancel the first-order {force that turns with the crank|couple that turns with the crank|force that turns with the crank, and its moment}: {}.",
        choice(shaft.kind),
        listed
    )
}

/// Two shafts of one order that turn in opposite senses.
fn of_two(remedy: &Remedy, with: &Shaft, against: &Shaft) -> Text {
    let (order, twice) = (Text::from(with.order), Text::from(with.order));
    if let (true, Some(weight)) = (with.lanchester, with.weights.first()) {
        return phrase!(
            "A Lanchester pair cancels the force of order {}: two shafts at {}× crank speed, one with the crank and one against it, with {} each.",
            order,
            twice,
            weights::in_short(remedy, weight)
        );
    }
    phrase!(
        "Two balancer shafts at {}× crank speed cancel the {force|couple|force and the moment} of order {}: with the crank {}, against it {}.",
        order,
        choice(with.kind),
        twice,
        weights::listed(remedy, &with.weights),
        weights::listed(remedy, &against.weights)
    )
}

fn of_one(remedy: &Remedy, shaft: &Shaft) -> Text {
    phrase!(
        "A balancer shaft at {1}× crank speed, {2:with|against} the crank, cancels the {3:part|part|parts} of the order-{1} {3:force that turns|couple that turns|force and moment that turn} with it: {4}.",
        shaft.order,
        shaft.sense,
        choice(shaft.kind),
        weights::listed(remedy, &shaft.weights)
    )
}

fn proof(remedy: &Remedy) -> Text {
    let sums = remedy.corrected.iter().filter(|sum| sum.vanishes()).count();
    let left = remedy.corrected.len() - sums;
    if !remedy.holds() {
        return phrase!("{} sums of the corrected engine do not vanish.", left);
    }
    if left > 0 {
        return phrase!(
            "Of the sums of force and moment of the corrected engine at the orders {}, {} are proved zero and {} are below 10⁻⁶ of the load.",
            orders(remedy),
            sums,
            left
        );
    }
    let number = Choice::one_or_more(remedy.orders.len());
    match remedy.weights().is_empty() {
        true => phrase!("Force and moment vanish at {order|orders} {}: no weight is needed.", number, orders(remedy)),
        false => phrase!(
            "With these weights force and moment vanish at {order|the orders} {}: {} sums of the corrected engine, each proved zero.",
            number,
            orders(remedy),
            sums
        ),
    }
}

/// What is good to know besides: fewest shafts, heights of pairs, masses.
pub(super) fn notes(remedy: &Remedy) -> Vec<Text> {
    let on_a_crankshaft = on_a_crankshaft(remedy).map(|(_, others)| others);
    let fewest = match on_a_crankshaft.unwrap_or(remedy.shafts.len()) {
        0 => None,
        count if on_a_crankshaft.is_some() => Some(phrase!(
            "With what turns on that crankshaft, these balancer shafts are still needed: {}. Fewer are not possible: each changes only what turns at its own speed and in its own sense.",
            count
        )),
        1 => Some(
            "One balancer shaft is the fewest possible: a shaft changes only what turns at its own speed and in its own sense."
                .into(),
        ),
        count => Some(phrase!(
            "{} balancer shafts are the fewest possible: each changes only what turns at its own speed and in its own sense.",
            count
        )),
    };
    let small = &remedy.small;
    let small = (!small.orders.is_empty()).then(|| {
        phrase!(
            "Weights are proposed for the first two orders of a crankshaft and for orders of at least {} % of the largest force or moment. Smaller orders, cancelled only on request: {}.",
            percent_at_most(small.below),
            Text::joined(small.orders.iter().map(|order| (*order).into()), ", ")
        )
    });
    let engine = remedy.subject.engine();
    let (usual, optional): (Vec<u32>, Vec<u32>) =
        remedy.orders.iter().partition(|order| is_usually_cured(engine, **order));
    let optional: Vec<u32> =
        optional.into_iter().filter(|order| remedy.shafts.iter().any(|of| of.order == *order)).collect();
    let optional = (!usual.is_empty() && !optional.is_empty()).then(|| {
        phrase!(
            "Usually left uncorrected: {order|orders} {}.",
            Choice::one_or_more(optional.len()),
            typeset::listed(&optional)
        )
    });
    let half_speed = fewest.is_some().then(|| HALF_SPEED.into());
    let lines = weights::coefficients(remedy)
        .into_iter()
        .chain(small)
        .chain(fewest)
        .chain(optional)
        .chain(half_speed)
        .chain(ranked::rolling_shafts(remedy));
    lines.chain(remedy.heights.iter().map(height)).chain(of_the_crankshaft(remedy)).collect()
}

const HALF_SPEED: &str =
    "A shaft at half the crank speed is never needed, because no inertia force of the cranks has order 1/2.";

fn height(height: &PairHeight) -> Text {
    let radii = Number::Decimal(height.in_crank_radii.abs());
    let higher = height.in_crank_radii >= 0.0;
    match height.metres {
        Some(metres) => phrase!(
            "Lanchester pair of order {}: where the shaft that turns with the crank lies {} {higher|lower} than the other ({} crank radii), the pair also cancels the masses' roll moment of that order; at half the height it cancels half.",
            height.order,
            Piece::Quantity(metres.abs() * 1000.0, Unit::MILLIMETRE),
            higher,
            radii
        ),
        None => phrase!(
            "Lanchester pair of order {}: where the shaft that turns with the crank lies {} crank radii {higher|lower} than the other, the pair also cancels the masses' roll moment of that order; at half the height it cancels half.",
            height.order,
            radii,
            higher
        ),
    }
}

/// Mass, balance factors and bob weights, where the layout gives numbers.
fn of_the_crankshaft(remedy: &Remedy) -> Vec<Text> {
    let engine = remedy.subject.engine();
    let mut lines = Vec::new();
    if engine.crankshaft().counterweights.iter().any(|weight| weight.throw.is_some()) {
        let listed = |factors: &[Option<BigRational>]| {
            let one = |factor: &Option<BigRational>| match factor {
                Some(factor) => Piece::Shortly(factor.clone(), Unit::NONE).into(),
                None => "none".into(),
            };
            Text::joined(factors.iter().map(one), ", ")
        };
        lines.push(phrase!(
            "Balance factors of the throws, of rotating and half the reciprocating masses, of the counterweights in the layout file: {}.",
            listed(&engine.balance_factors())
        ));
        let parts = engine.reciprocating_factors();
        let words = match parts.iter().flatten().any(Signed::is_negative) {
            false => {
                "By the other convention the same counterweights balance all rotating masses and these parts of the reciprocating masses of each throw: {}."
            }
            true => {
                "By the other convention, with all rotating masses of a throw counted first, these parts of the reciprocating masses of each throw: {}. A negative part means that the counterweights balance not even the rotating masses."
            }
        };
        lines.push(phrase!(words, listed(&parts)));
    }
    let kilograms = |mass: f64| Piece::Quantity(mass, Unit::KILOGRAM);
    if let (Some(bare), Some(with)) = (engine.crankshaft_mass(), remedy.crankshaft_mass()) {
        let bare = kilograms(float(&bare));
        let planes = remedy.resized();
        let is_resized = planes.iter().any(|plane| plane.becomes.is_on_the_crank());
        let is_bare = remedy.bays.is_empty() && remedy.crankshaft.is_none();
        lines.push(match (is_bare, is_resized, &remedy.radius) {
            (_, true, _) => phrase!(
                "Crankshaft mass that counts in the balance (throws with rotating and half the reciprocating masses, counterweights): {}; with the counterweights of the remedy, resized ones at their own radius: {}.",
                bare,
                kilograms(with)
            ),
            (true, false, _) => phrase!(
                "Crankshaft mass that counts in the balance (throws with rotating and half the reciprocating masses, counterweights): {}.",
                bare
            ),
            (false, false, None) => phrase!(
                "Crankshaft mass that counts in the balance (throws with rotating and half the reciprocating masses, counterweights): {}; with the counterweights of the remedy at the crank radius: {}.",
                bare,
                kilograms(with)
            ),
            (false, false, Some(radius)) => phrase!(
                "Crankshaft mass that counts in the balance (throws with rotating and half the reciprocating masses, counterweights): {}; with the counterweights of the remedy at a radius of {}: {}.",
                bare,
                typeset::given_with(&(radius * BigRational::from_integer(1000.into())), Unit::MILLIMETRE),
                kilograms(with)
            ),
        });
    }
    let half = BigRational::new(1.into(), 2.into());
    if let Some(bob) = engine.bob_weight(0, &half) {
        let all = kilograms(float(&bob.per_throw));
        lines.push(match bob.per_cylinder.as_slice() {
            [one, others @ ..] if others.iter().all(|other| other == one) => phrase!(
                "Bob weight of throw 1 with half the reciprocating masses: {} per cylinder, {} for the throw.",
                kilograms(float(one)),
                all
            ),
            _ => phrase!("Bob weight of throw 1 with half the reciprocating masses: {}.", all),
        });
    }
    lines
}
