//! How is the answer to a claim put in words?

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::dialect::Dialect;
use super::residual;
use super::typeset::{self, Amount};
use crate::claim::{
    Absolute, Answer, Condition, Evidence, Finding, Provenance, Quote, StarTable, Statement, Status, Subject,
    TableVerdict, Witness,
};
use crate::engine::Engine;
use crate::engine::{DOES_NOT_EXIST, WHY_NOT};
use crate::order;
use crate::order::Masses;
use crate::proof::{Quantity, Sense};
use crate::text::Untrusted;
use crate::verdict::{Balance, OrderBalance, TorquePart, Verdict};

/// `true`, `false`, `true only if …`.
pub fn claim_status(answer: &Answer) -> String {
    match &answer.status {
        Status::True => "true".to_owned(),
        Status::TrueAsRounded => "true, rounded".to_owned(),
        Status::False => "false".to_owned(),
        Status::NotDecided => "not decided".to_owned(),
        Status::TrueOnlyIf { conditions, met } => {
            let conditions: Vec<String> = conditions.iter().map(condition).collect();
            let here = if *met { "as it is here" } else { "which it is not here" };
            format!("true only if {}, {here}", conditions.join(" and "))
        }
    }
}

fn condition(condition: &Condition) -> String {
    match condition {
        Condition::AboutPlane(plane) => format!("moments are taken about the plane z = {}", typeset::number(plane)),
        Condition::NotAboutPlane(plane) => {
            format!("moments are not taken about the plane z = {}", typeset::number(plane))
        }
        Condition::NoBankOffset => "the cylinders of a crankpin stand in one plane".to_owned(),
        Condition::FiringOrder => "the firing order is one of the even ones".to_owned(),
    }
}

/// What is the case, in plain text.
pub fn claim_finding(statement: &Statement, answer: &Answer) -> String {
    match (&answer.finding, statement) {
        (Finding::Order(order), Statement::Order { subject, .. }) => about_order(*subject, order),
        (Finding::Order(order), _) => residual::force_summary(order),
        (Finding::Absolute(order, absolute), Statement::Order { subject, .. }) => {
            format!("{} That is {}.", about_order(*subject, order), in_newtons(*subject, absolute))
        }
        (Finding::Torque(torque), _) => about_torque(torque),
        (Finding::Absolute(order, _), _) => residual::force_summary(order),
        (Finding::Orders { surviving, judged, period, first }, _) => {
            orders(surviving, *judged, *period, first.as_deref(), statement)
        }
        (Finding::Firing(None), _) => "The layout names no firing order.".to_owned(),
        (Finding::Firing(Some(intervals)), _) => {
            let degrees = intervals.iter().map(typeset::turns);
            format!("The intervals are {}.", degrees.collect::<Vec<_>>().join(", "))
        }
        (Finding::Mass(mass), _) => format!("The crankshaft's mass is {} kg.", kilograms(mass)),
        (Finding::Bearings(loads), _) => {
            crate::page::text_in(&super::bearings::peaks_in_words(loads), crate::page::Format::PLAIN)
        }
        (Finding::Witness(found), _) => witness(found),
        (Finding::Nothing(reason), _) => format!("{reason}."),
    }
}

fn about_torque(torque: &TorquePart) -> String {
    let order = torque.verdict.order;
    match torque.exists {
        true => format!(
            "Order {order} of the torque is {}.",
            crate::page::text_in(&residual::torque_part(torque), crate::page::Format::PLAIN)
        ),
        false => format!("Order {order} of the torque {DOES_NOT_EXIST}. {WHY_NOT}"),
    }
}

fn about_order(subject: Subject, order: &OrderBalance) -> String {
    let is_force = subject.quantity == Quantity::Force;
    if !order.exists {
        let name = if is_force { "force" } else { "moment" };
        return format!("Order {} of the {name} {DOES_NOT_EXIST}. {WHY_NOT}", subject.order);
    }
    let balance: &Balance = if is_force { &order.force } else { &order.moment };
    let verdict: Option<&Verdict> = subject.sense.map(|sense| match sense {
        Sense::Direct => &balance.direct,
        Sense::Reverse => &balance.reverse,
    });
    let name = if is_force { "force" } else { residual::moment_name(order) };
    let name = &format!("{name}{}", whose(subject.masses));
    match verdict {
        Some(verdict) if verdict.vanishes() => {
            format!("The {} vector of the {name} of order {} is 0.", verdict_sense(verdict), subject.order)
        }
        Some(verdict) => {
            let half = residual::modulus(verdict).mean(&Amount::zero());
            let bearing = residual::bearing(&verdict.sum).plain();
            format!(
                "The {} vector of the {name} of order {} is {} long, angle {bearing}.",
                verdict_sense(verdict),
                subject.order,
                half.plain()
            )
        }
        None if balance.is_balanced() => format!("The {name} of order {} is 0.", subject.order),
        None => {
            let shape = residual::shape_name(balance.shape);
            let largest = residual::largest(balance).plain();
            format!("The {name} of order {} is {shape}, its largest value {largest}{}.", subject.order, line(balance))
        }
    }
}

/// The counterweights that were found, with their masses where the layout gives numbers.
fn witness(found: &Witness) -> String {
    let masses = found.masses.as_ref();
    let each = found.weights.iter().enumerate().map(|(index, weight)| {
        let position = typeset::number(&weight.position);
        let bearing = weight.vector.only().map(|(_, sum)| format!(", angle {}", residual::bearing(sum).plain()));
        let size = match (masses.and_then(|masses| masses.get(index)), weight.vector.only()) {
            (Some(mass), _) => format!("≈ {} kg at the crank radius", typeset::decimal(*mass)),
            (None, Some((_, sum))) => format!("mass-radius {} in multiples of m r", residual::modulus_of(sum).plain()),
            (None, None) => "none".to_owned(),
        };
        format!("at z = {position}, {size}{}", bearing.unwrap_or_default())
    });
    let each: Vec<String> = each.collect();
    let shaft =
        found.crankshaft_mass.map(|mass| format!(" The crankshaft's mass is then ≈ {} kg.", typeset::decimal(mass)));
    match each.as_slice() {
        [] => format!("No counterweight is needed.{}", shaft.unwrap_or_default()),
        each => format!("Counterweights that do it: {}.{}", each.join("; "), shaft.unwrap_or_default()),
    }
}

/// Where a claim is said, in one cell of a table, with its source where that is not the one that stands above; nothing of
/// the file's own.
pub(super) fn said(provenance: &Provenance, above: Option<&Untrusted>, dialect: Dialect) -> Option<String> {
    match provenance {
        Provenance::Quoted(Quote { source, place, words }) => {
            let [shown, place, words] = [source, place, words].map(|text| dialect.quoted(text));
            let source = if above == Some(source) { String::new() } else { format!("{shown}, ") };
            Some(format!("{source}{place}: “{words}”"))
        }
        Provenance::Folklore => Some("folklore: no source found".to_owned()),
        Provenance::Own => None,
    }
}

/// A mass as a decimal where it ends, however many places that takes.
fn kilograms(mass: &BigRational) -> String {
    let decimal = mass.to_f64().map(|mass| mass.to_string());
    let is_exact = |text: &String| crate::file::parse_number(text).is_ok_and(|number| number == *mass);
    decimal.filter(is_exact).unwrap_or_else(|| typeset::number(mass))
}

/// Whose force or moment it is, where it is not that of the pistons.
fn whose(masses: Masses) -> &'static str {
    match masses {
        Masses::Reciprocating => "",
        Masses::Rotating => " of the rotating masses",
        Masses::Counterweights => " of the counterweights",
        Masses::All => " of all masses",
    }
}

fn verdict_sense(verdict: &Verdict) -> &'static str {
    verdict.sense.map_or("", Sense::name)
}

/// `, at angle −18.4°` for a rotating vector, the line for one that swings.
fn line(balance: &Balance) -> String {
    use crate::proof::Shape;
    match balance.shape {
        Shape::Balanced | Shape::NotDecided => String::new(),
        Shape::Rotating => format!(", at angle {}", residual::bearing(&balance.direct.sum).plain()),
        Shape::CounterRotating => format!(", at angle {}", residual::bearing(&balance.reverse.sum).plain()),
        Shape::Planar | Shape::Elliptical => {
            format!(", along the line of angle {}", residual::line_bearing(balance).plain())
        }
    }
}

fn in_newtons(subject: Subject, absolute: &Absolute) -> String {
    let unit = if subject.quantity == Quantity::Moment { "N·m" } else { "N" };
    let value = |value: f64| format!("≈ {} {unit}", typeset::decimal(value));
    match subject.order {
        1 => value(absolute.whole),
        _ => format!(
            "{} with the first term of c_k alone, {} with the whole series",
            value(absolute.first_term),
            value(absolute.whole)
        ),
    }
}

fn orders(
    surviving: &[u32],
    judged: usize,
    period: Option<u32>,
    first: Option<&OrderBalance>,
    statement: &Statement,
) -> String {
    let over = match period {
        Some(period) => format!("Of all orders that exist (1 and the even ones, repeating after {period})"),
        None => format!("Of the {judged} orders"),
    };
    let Some(first) = first else {
        return match (period, statement) {
            (Some(period), Statement::NoFreeMoment) => format!(
                "No order leaves one: its moment vanishes, or is that of its force in one plane; one period of {period} orders shows it."
            ),
            (Some(period), _) => format!("All of them vanish: one period of {period} orders shows it."),
            (None, _) => format!("All {judged} of them vanish."),
        };
    };
    let shown: Vec<String> = surviving.iter().take(6).map(u32::to_string).collect();
    let more = if surviving.len() > 6 { ", …" } else { "" };
    let with_moment = match statement {
        Statement::Vanish { quantities, .. } => quantities.contains(&Quantity::Moment),
        Statement::NoFreeMoment => true,
        Statement::Order { .. }
        | Statement::CanBalance(_)
        | Statement::CrankshaftMass(_)
        | Statement::BearingLoad(_)
        | Statement::WorstBearings(_)
        | Statement::FiresEvenly { .. } => false,
    };
    let force = (!first.force.is_balanced()).then(|| format!("force {}", residual::force_summary(first)));
    let moment = (with_moment && !first.moment.is_balanced()).then(|| residual::moment_summary(first));
    let what: Vec<String> = [force, moment].into_iter().flatten().collect();
    format!(
        "{over} these are left: {}{more}; the first is order {}: {}.",
        shown.join(", "),
        first.order,
        what.join(", ")
    )
}

/// The certificates that an answer rests on, as prose.
pub(super) fn evidence(answer: &Answer) -> Vec<String> {
    answer.evidence.iter().map(one).collect()
}

fn one(evidence: &Evidence) -> String {
    let about = match evidence {
        Evidence::Verdict(verdict) => {
            let sense = verdict.sense.map(|sense| format!(", {}", sense.name())).unwrap_or_default();
            format!("{}, order {}{sense}", super::old::capital(verdict.quantity.name()), verdict.order)
        }
        Evidence::Comparison { about, .. } => super::old::capital(about),
    };
    let zero = if evidence.vanishes() { "is 0" } else { "is not 0" };
    let certificate = super::argument::certificate_of(evidence.sum(), evidence.certificate());
    let prose = crate::page::Format::Markdown(crate::page::Math::Dollars);
    format!("{about}: {zero}. {}", crate::page::text_in(&certificate, prose))
}

/// The answer to a student's table, in plain text.
pub fn table_finding(table: &StarTable, verdict: &TableVerdict) -> String {
    let k = i64::from(table.order);
    match verdict {
        TableVerdict::Right(entries) => format!("true: all {entries} entries are right"),
        TableVerdict::WrongPhase { cylinder, sense, written, right } => {
            let engine: &Engine = &table.layout;
            let cylinder = &engine.cylinders()[*cylinder];
            debug_assert_eq!(order::phase(cylinder, table.order, Some(*sense)), *right);
            format!(
                "false: the first wrong row is that of cylinder {}: its {} phase is {}, not {}: {} with β = {} and α = {} is {}",
                cylinder.name,
                sense.name(),
                typeset::angle(right),
                typeset::angle(written),
                super::table::phase_formula(k, *sense, true),
                typeset::angle(&cylinder.throw),
                typeset::degrees(&typeset::signed_degrees(&cylinder.bank)),
                super::table::working(cylinder, table.order, *sense),
            )
        }
        TableVerdict::WrongSum { quantity, sense, written, right } => {
            let amount = Amount { exact: right.0.clone(), decimal: right.1 };
            format!(
                "false: all phases given are right, but the {} sum of the {} is not {written}: its length is {}",
                sense.name(),
                quantity.name(),
                amount.plain().trim_start_matches("= ")
            )
        }
    }
}
