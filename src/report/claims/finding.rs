//! How is the answer to a claim put in words: whether it holds, and what is the case?

use std::borrow::Cow;

use super::super::residual;
use super::super::typeset::{self, Amount};
use super::orders::Asked;
use super::{counterweights, forces, gas_torque, shaking};
use crate::claim::{self, Absolute, Answer, Condition, Finding, Numbers, Statement, Status, Subject, Topic};
use crate::engine::{Engine, WHY_NOT};
use crate::order::Masses;
use crate::page::{Text, Unit, number, phrase};
use crate::proof::{Quantity, Sense, Shape};
use crate::remedy::{Remedy, Shaft};
use crate::report::texts::claims as text;
use crate::text::Untrusted;
use crate::verdict::{Balance, OrderBalance, OrderVerdict, TorquePart, Verdict};

/// `true`, `false`, `true only if …`.
pub fn claim_status(answer: &Answer) -> Text {
    match &answer.status {
        Status::True => "true".into(),
        Status::TrueAsRounded => "true, rounded".into(),
        Status::False => "false".into(),
        Status::NotDecided => "not decided".into(),
        Status::TrueOnlyIf { conditions, met } => {
            let words = Text::joined(conditions.iter().map(condition), " and ");
            // Where the layout names no firing order there is none to be one of these, and how c_k is taken is not the engine's.
            let is_here =
                |condition: &Condition| !matches!(condition, Condition::FiringOrder | Condition::FirstTermAlone);
            if conditions.iter().all(is_here) { text::only_if_here(words, *met) } else { text::only_if(words) }
        }
    }
}

fn condition(condition: &Condition) -> Text {
    match condition {
        Condition::AboutPlane(plane) | Condition::NotAboutPlane(plane) => {
            text::moments_about(matches!(condition, Condition::AboutPlane(_)), typeset::number(plane))
        }
        Condition::NoBankOffset => text::pins_in_one_plane(),
        Condition::FiringOrder => text::even_firing_order(),
        Condition::FirstTermAlone => text::first_term_alone(),
    }
}

/// What is the case, of all masses too where a claim that names none is answered otherwise of them.
pub fn claim_finding_on(
    (engine, numbers): (&Engine, Option<&Numbers>),
    statement: &Statement,
    answer: &Answer,
) -> Text {
    let finding = claim_finding(statement, answer);
    let of_all = claim::status_of_all_masses(engine, statement, numbers);
    let differs = |of_all: &Status| *of_all == Status::NotDecided || of_all.holds() != answer.status.holds();
    match of_all.filter(|of_all| answer.status != Status::NotDecided && differs(of_all)) {
        None => finding,
        Some(Status::NotDecided) => text::of_all_not_decided(finding),
        Some(of_all) => text::of_all(finding, of_all.holds()),
    }
}

/// What is the case.
pub fn claim_finding(statement: &Statement, answer: &Answer) -> Text {
    match (&answer.finding, statement) {
        (Finding::Order(order), Statement::Order { subject, .. }) => about_order(*subject, order),
        (Finding::Order(order), _) => residual::force(order),
        (Finding::Absolute(order, absolute), Statement::Order { subject, .. }) => {
            phrase!("{} {}", about_order(*subject, order), in_newtons(*subject, absolute))
        }
        (Finding::Torque(torque), _) => about_torque(torque),
        (Finding::Absolute(order, _), _) => residual::force(order),
        (Finding::Orders { surviving, judged, period, first }, _) => {
            Asked { surviving, judged: *judged, period: *period, first: first.as_deref() }.finding(statement)
        }
        (Finding::NothingLeft, _) => text::nothing_left(statement.topic() == Topic::FreeMoment),
        (Finding::OnePlane, _) => text::one_plane(),
        (Finding::FiringStars(orders), _) => gas_torque::found(orders, statement, answer.status.holds()),
        (Finding::NoEvenFiring, _) => text::no_even_firing(),
        (Finding::OneCylinder, _) => text::one_cylinder(),
        (Finding::Firing(None), _) => text::no_firing_order(),
        (Finding::Firing(Some(intervals)), _) => {
            let degrees = intervals.iter().map(|interval| typeset::turns(interval).into());
            text::intervals(intervals.len() == 1, Text::joined(degrees, ", "))
        }
        (Finding::Mass(mass, crankshafts), _) => {
            text::crankshaft_mass(*crankshafts == 1, number::given_with(mass, Unit::KILOGRAM))
        }
        (Finding::Bearings(loads), _) => super::super::bearings::peaks_in_words(loads),
        (Finding::CombinedOrders(orders), _) => Text::joined(orders.iter().map(of_several_rods), " "),
        (Finding::Remedy(remedy), _) => needs(remedy),
        (Finding::Terms { terms, through }, _) => shaking::found(terms, *through),
        (Finding::Largest(found), _) => forces::largest(found),
        (Finding::Agreement(found), _) => forces::agreement(found),
        (Finding::Witness(found), _) => counterweights::found(found, &answer.status),
        (Finding::Nothing(Cow::Borrowed(reason)), _) => phrase!("{}.", *reason),
        // The message of an error stays as it is, its decimals and lists too.
        (Finding::Nothing(Cow::Owned(message)), _) => phrase!("{}.", &Untrusted::new(message.as_str())),
    }
}

/// What is left of an order to which several kinds of rods contribute.
fn of_several_rods(order: &OrderVerdict) -> Text {
    let [force, moment] = residual::whole(order);
    text::order_left(order.order, force, moment)
}

/// What takes an order away, in a word or two.
pub fn needs(remedy: &Remedy) -> Text {
    let order = remedy.orders.first().copied().unwrap_or_default();
    let shafts: Vec<&Shaft> = remedy.shafts_built().filter(|shaft| remedy.crank_of(shaft).is_none()).collect();
    let weights = remedy.crankshaft.is_some() || shafts.len() < remedy.shafts_built().count();
    match shafts.as_slice() {
        [] if weights => text::counterweights_alone(order),
        [] => text::nothing_needed(order),
        [one] => text::one_shaft(order, weights, one.sense),
        [one, _] if one.lanchester => text::lanchester_pair(order),
        [..] => text::two_shafts(order),
    }
}

fn about_torque(torque: &TorquePart) -> Text {
    let order = torque.verdict.order;
    match torque.exists {
        true => text::torque_order(order, residual::torque_part(torque)),
        false => text::no_torque_order(order, WHY_NOT),
    }
}

fn about_order(subject: Subject, order: &OrderBalance) -> Text {
    let is_force = subject.quantity == Quantity::FORCE;
    let k = subject.order;
    if !order.exists {
        return text::no_order(k, is_force, WHY_NOT);
    }
    let balance: &Balance = if is_force { &order.force } else { &order.moment };
    let verdict: Option<&Verdict> = subject.sense.map(|sense| sense.choose(&balance.direct, &balance.reverse));
    let name = whose(if is_force { "force" } else { residual::moment_name(order) }, subject.masses);
    match verdict {
        Some(verdict) if verdict.vanishes() => text::zero_vector(sense(verdict), name, k, Text::zero()),
        Some(verdict) => text::vector(
            sense(verdict),
            name,
            k,
            residual::modulus(verdict).mean(&Amount::zero()),
            residual::bearing(&verdict.sum),
        ),
        None if balance.is_balanced() => text::zero_order(name, k, Text::zero()),
        None => left(&name, k, balance),
    }
}

/// What is left of an order: its shape, its largest value, the angle of a rotating vector, the line of one that swings.
fn left(name: &Text, order: u32, balance: &Balance) -> Text {
    let (name, shape, largest) = (name.clone(), residual::shape_name(balance.shape), residual::largest(balance));
    match balance.shape {
        Shape::Balanced | Shape::NotDecided | Shape::DoesNotExist => text::largest_value(name, order, shape, largest),
        Shape::Rotating => text::largest_at_angle(name, order, shape, largest, residual::bearing(&balance.direct.sum)),
        Shape::CounterRotating => {
            text::largest_at_angle(name, order, shape, largest, residual::bearing(&balance.reverse.sum))
        }
        Shape::Planar | Shape::Elliptical => {
            text::largest_along_line(name, order, shape, largest, residual::line_bearing(balance))
        }
    }
}

/// A force or a moment with whose it is, where it is not that of the pistons.
fn whose(name: &'static str, masses: Masses) -> Text {
    match masses {
        Masses::Reciprocating => name.into(),
        Masses::Rotating => text::of_rotating_masses(name),
        Masses::Counterweights => text::of_counterweights(name),
        Masses::All => text::of_all_masses(name),
    }
}

fn sense(verdict: &Verdict) -> &'static str {
    verdict.sense.map_or("", Sense::name)
}

fn in_newtons(subject: Subject, absolute: &Absolute) -> Text {
    let unit = if subject.quantity == Quantity::MOMENT { Unit::NEWTON_METRE } else { Unit::NEWTON };
    let value = |value: f64| Text::measured_in(value, unit);
    let whole = value(absolute.whole);
    match absolute.first_term {
        None => text::in_newtons(whole),
        Some(first) => text::by_first_term(value(first), whole),
    }
}
