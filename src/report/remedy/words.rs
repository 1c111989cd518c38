//! What does a remedy come to, in sentences? What cancels what, what is proved, and what is good to know besides.

use num_rational::BigRational;
use num_traits::Signed;

use super::super::calculation::percent_at_most;
use super::super::engine_page::is_usually_cured;
use super::super::typeset;
use super::{ranked, weights};
use crate::engine::GearedCrank;
use crate::numbers::float;
use crate::page::{Choice, Number, Piece, Text, Unit};
use crate::remedy::{Kind, PairHeight, Remedy, Shaft};
use crate::report::texts::remedy as text;

/// For a place such as `{force|couple|force and moment}`.
fn choice(kind: Kind) -> Choice {
    Choice::of(match kind {
        Kind::Force => 0,
        Kind::Couple => 1,
        Kind::ForceAndMoment => 2,
    })
}

/// The orders of a remedy.
fn orders(remedy: &Remedy) -> String {
    typeset::listed(&remedy.orders)
}

/// What cancels what, a sentence each, and the proof of it: the answer to what cures an engine.
pub fn remedy_cures(remedy: &Remedy) -> Vec<Text> {
    let mut lines = resized(remedy);
    if remedy.stays(&remedy.bays) {
        lines.push(text::by_factors(weights::listed(remedy, &remedy.bays)));
    }
    let crankshaft = remedy.crankshaft.iter().filter(|shaft| remedy.stays(&shaft.weights));
    lines.extend(crankshaft.map(|shaft| on_the_crankshaft(remedy, shaft)));
    lines.extend(of_several_crankshafts(remedy));
    let mut shafts = remedy.shafts_built().peekable();
    while let Some(shaft) = shafts.next() {
        let partner = shafts.next_if(|next| next.order == shaft.order && next.kind == shaft.kind);
        lines.push(match partner {
            Some(partner) => of_two(remedy, shaft, partner),
            None => {
                let weights = weights::listed(remedy, &shaft.weights);
                text::one_shaft(shaft.order, shaft.sense, choice(shaft.kind), weights)
            }
        });
    }
    lines.extend(remedy.left_out.iter().map(|shaft| text::below_residual(shaft.sense, shaft.order)));
    lines.push(proof(remedy));
    if remedy.subject.engine().faster_crank().is_some() {
        lines.extend(on_crankshafts(remedy));
        return lines;
    }
    match replaceable(remedy).first() {
        Some((shaft, crank)) => {
            lines.push(text::on_reverse_crankshaft(crank.name.clone(), rolls(shaft)));
            if remedy.shafts_built().count() > 1 {
                lines.push(text::only_own_order());
            }
        }
        None if remedy.shafts_built().next().is_none() => {}
        None => lines.push(text::only_order_1(Choice::one_or_more(remedy.shafts_built().count()))),
    }
    lines
}

/// The weights of the file that become others.
fn resized(remedy: &Remedy) -> Vec<Text> {
    let planes: Vec<Text> = remedy.resized().map(|plane| weights::resized(remedy, plane)).collect();
    let several = |(index, shaft): (usize, &Shaft)| match remedy.axes(shaft).len() {
        0 | 1 => None,
        axes => Some(text::on_several_axes(index + 1, axes)),
    };
    let resized = (!planes.is_empty()).then(|| text::resized(Text::joined(planes, "; ")));
    resized.into_iter().chain(remedy.shafts_built().enumerate().filter_map(several)).collect()
}

/// On which of several crankshafts the counterweights are.
fn of_several_crankshafts(remedy: &Remedy) -> Option<Text> {
    let engine = remedy.subject.engine();
    let reference = engine.geared_cranks().first()?;
    let others = engine.crankshaft().counterweights.iter().any(|weight| weight.crank != 0);
    let are_there = remedy.built.iter().any(|plane| plane.becomes.is_on_the_crank());
    are_there.then(|| text::on_reference(reference.name.clone(), others))
}

/// The shafts of the remedy that a crankshaft turns like, each with the first such crankshaft.
fn replaceable(remedy: &Remedy) -> Vec<(&Shaft, &GearedCrank)> {
    remedy.shafts_built().filter_map(|shaft| Some((shaft, remedy.crank_of(shaft)?))).collect()
}

/// Which shafts may be counterweights on a crankshaft that turns as they do, where crankshafts turn at different speeds.
fn on_crankshafts(remedy: &Remedy) -> Vec<Text> {
    let on = |(shaft, crank): (&Shaft, &GearedCrank)| {
        text::on_crankshaft(shaft.order, shaft.sense, crank.name.clone(), rolls(shaft))
    };
    let mut lines: Vec<Text> = replaceable(remedy).into_iter().map(on).collect();
    if lines.len() < remedy.shafts_built().count() {
        lines.push(text::only_own_crankshaft(lines.is_empty()));
    }
    lines
}

/// Whether the roll moment depends on where the axis of a shaft is: that of weights which sum to 0 does not.
fn rolls(shaft: &Shaft) -> bool {
    shaft.kind != Kind::Couple
}

fn on_the_crankshaft(remedy: &Remedy, shaft: &Shaft) -> Text {
    let listed = weights::listed(remedy, &shaft.weights);
    if let (Kind::Force, [_]) = (shaft.kind, &shaft.weights[..]) {
        return text::counterweight(listed);
    }
    text::counterweights(choice(shaft.kind), listed)
}

/// Two shafts of one order that turn in opposite senses.
fn of_two(remedy: &Remedy, with: &Shaft, against: &Shaft) -> Text {
    if let (true, Some(weight)) = (with.lanchester, with.weights.first()) {
        return text::lanchester_pair(with.order, weights::in_short(remedy, weight));
    }
    text::two_shafts(
        with.order,
        choice(with.kind),
        weights::listed(remedy, &with.weights),
        weights::listed(remedy, &against.weights),
    )
}

fn proof(remedy: &Remedy) -> Text {
    let sums = remedy.corrected.iter().filter(|sum| sum.vanishes()).count();
    let left = remedy.corrected.len() - sums;
    if !remedy.holds() {
        return text::not_vanishing(left);
    }
    let number = Choice::one_or_more(remedy.orders.len());
    if left > 0 {
        return text::nearly_vanishing(number, orders(remedy), sums, left);
    }
    match remedy.weights().is_empty() {
        true => text::no_weight(number, orders(remedy)),
        false => {
            let has_weights = remedy.built.iter().any(|plane| !plane.becomes.vector.vanishes());
            text::vanishing(has_weights, number, orders(remedy), sums)
        }
    }
}

/// What is good to know besides: fewest shafts, heights of pairs, masses.
pub(super) fn notes(remedy: &Remedy) -> Vec<Text> {
    let on_crankshafts = replaceable(remedy).len();
    let fewest = match remedy.shafts_built().count() - on_crankshafts {
        0 => None,
        count if on_crankshafts > 0 => Some(text::shafts_beside_crankshaft(Choice::one_or_more(on_crankshafts), count)),
        1 => Some(text::one_is_fewest()),
        count => Some(text::fewest(count)),
    };
    let small = &remedy.small;
    let small = (!small.orders.is_empty()).then(|| {
        text::small_orders(
            percent_at_most(small.below),
            Text::joined(small.orders.iter().map(|order| (*order).into()), ", "),
        )
    });
    let engine = remedy.subject.engine();
    let (usual, optional): (Vec<u32>, Vec<u32>) =
        remedy.orders.iter().partition(|order| is_usually_cured(engine, **order));
    let optional: Vec<u32> =
        optional.into_iter().filter(|order| remedy.shafts_built().any(|of| of.order == *order)).collect();
    let optional = (!usual.is_empty() && !optional.is_empty())
        .then(|| text::usually_left(Choice::one_or_more(optional.len()), typeset::listed(&optional)));
    let half_speed = fewest.is_some().then(text::half_speed);
    let lines = weights::coefficients(remedy)
        .into_iter()
        .chain(small)
        .chain(fewest)
        .chain(optional)
        .chain(half_speed)
        .chain(ranked::rolling_shafts(remedy));
    lines.chain(remedy.heights.iter().map(height)).chain(of_the_crankshaft(remedy)).collect()
}

fn height(height: &PairHeight) -> Text {
    let radii = Number::Decimal(height.in_crank_radii.abs());
    let higher = height.in_crank_radii >= 0.0;
    match height.metres {
        Some(metres) => {
            let millimetres = Piece::Quantity(metres.abs() * 1000.0, Unit::MILLIMETRE);
            text::pair_height(height.order, millimetres, higher, radii)
        }
        None => text::pair_height_in_radii(height.order, radii, higher),
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
        lines.push(text::balance_factors(listed(&engine.balance_factors())));
        let parts = engine.reciprocating_factors();
        lines.push(match parts.iter().flatten().any(Signed::is_negative) {
            false => text::reciprocating_parts(listed(&parts)),
            true => text::negative_parts(listed(&parts)),
        });
    }
    let kilograms = |mass: f64| Piece::Quantity(mass, Unit::KILOGRAM);
    if let (Some(bare), Some(with)) = (engine.crankshaft_mass(), remedy.crankshaft_mass()) {
        let bare = kilograms(float(&bare));
        let is_one = engine.crankshafts() == 1;
        let is_resized = remedy.resized().any(|plane| plane.becomes.is_on_the_crank());
        let is_bare = remedy.bays.is_empty() && remedy.crankshaft.is_none();
        lines.push(match (is_bare, is_resized, &remedy.radius) {
            (_, true, _) => text::crankshaft_mass_resized(is_one, bare, kilograms(with)),
            (true, false, _) => text::crankshaft_mass(is_one, bare),
            (false, false, None) => text::crankshaft_mass_at_crank(is_one, bare, kilograms(with)),
            (false, false, Some(radius)) => text::crankshaft_mass_at_radius(
                is_one,
                bare,
                typeset::given_with(&(radius * BigRational::from_integer(1000.into())), Unit::MILLIMETRE),
                kilograms(with),
            ),
        });
    }
    let half = BigRational::new(1.into(), 2.into());
    if let Some(bob) = engine.bob_weight(0, &half) {
        let all = kilograms(float(&bob.per_throw));
        lines.push(match bob.per_cylinder.as_slice() {
            [one, others @ ..] if others.iter().all(|other| other == one) => {
                text::bob_weight_per_cylinder(kilograms(float(one)), all)
            }
            _ => text::bob_weight(all),
        });
    }
    lines
}
