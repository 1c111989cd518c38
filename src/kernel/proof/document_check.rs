//! Does all that a document of verdicts says hold together?

use num_traits::Zero;

use super::audit::{Audit, Fault, Reason, refuse_if};
use super::checked::Checked;
use super::document::Document;
use super::engine::{
    Masses, check_asked, check_knuckle, check_masses, check_masters, check_names, check_radii, check_shafts,
    check_speed,
};
use super::format::Format;
use super::judged::{Judged, JudgedGroup};
use super::motion::Motion;
use super::quantity::{Quantity, Sense};
use super::recurrence::RecurrenceClaim;
use super::recurrence_check::check_recurrence;
use super::rod::RodClaim;
use super::shape::check_shape;
use super::source::knuckle_name;
use super::theorem_check::check_theorem;
use super::verdict::About;
use super::whole_sum::check_whole;

/// Checks that a document holds: that the verdicts asked for are all there and no other, that their terms are those of
/// its engine, that every certificate proves what it claims, and that the decimals fit.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_document(document: &Document) -> Result<Checked, Fault> {
    let audit = Audit::new();
    judge(document, &audit)?;
    Ok(Checked::classify(document, audit.counts()))
}

/// The same, with what is proved of each order.
pub(super) fn judge(document: &Document, audit: &Audit) -> Result<Vec<Judged>, Fault> {
    check_head(document)?;
    let mut judged = check_verdicts(document, audit)?;
    let motion = Motion::new(audit);
    check_wholes(document, &mut judged, &motion)?;
    check_shapes(document, &judged, &motion)?;
    check_theorems(document, audit, &motion)?;
    Ok(judged)
}

fn check_head(document: &Document) -> Result<(), Fault> {
    refuse_if(document.format != Format::Classify, Fault::new("format", "verdicts are in `crankstar classify 2`"))?;
    check_names(document.cylinders.iter().map(|cylinder| cylinder.name.as_str()))?;
    check_turning_masses(document)?;
    check_axes(document)?;
    check_asked(&document.orders, &document.quantities)?;
    let are_rods = document.cylinders.iter().all(|cylinder| cylinder.rod.is_rod());
    if !are_rods && document.quantities.iter().any(|quantity| quantity.planar().is_none()) {
        return Err(Fault::new("quantities", "torque and roll moment are decided where all rods are on the crankpins"));
    }
    for cylinder in &document.cylinders {
        let checked = check_knuckle(&cylinder.rod, &cylinder.knuckle_weight);
        let checked = checked.and_then(|()| check_speed(&cylinder.rod, cylinder.speed));
        checked.map_err(|reason| Fault { place: "cylinders".into(), reason })?;
    }
    let masses = document.cylinders.iter().flat_map(|one| [&one.reciprocating_mass, &one.knuckle_weight]);
    let radii = document.cylinders.iter().map(|one| &one.crank_radius);
    let sizes = check_masses(masses).and_then(|()| check_radii(radii));
    // No link hangs on a crank that turns faster.
    let cylinders = document.cylinders.iter().filter(|one| one.speed == 1);
    let held = cylinders.map(|one| (&one.throw, &one.bank, &one.rod, [&one.crank_radius, &one.position]));
    let rods = sizes.and_then(|()| document.rods()).and_then(|_| check_masters(held));
    rods.map_err(|reason| Fault { place: "cylinders".into(), reason })
}

/// Where axes stand and which way cranks turn counts for the roll moment alone: elsewhere nothing is said of it.
fn check_axes(document: &Document) -> Result<(), Fault> {
    let why = "it is in documents with the roll moment alone, which nothing else could check";
    if document.quantities.contains(&Quantity::ROLL) {
        let is_endless = |rod: &RodClaim| rod.ratio.is_zero() && !rod.offset.is_zero();
        let endless = document.cylinders.iter().position(|cylinder| cylinder.rod.on_the_pin().is_some_and(is_endless));
        return match endless {
            None => Ok(()),
            Some(index) => {
                let why = "an endless rod with an offset has no arm, and its engine no roll moment";
                Err(Fault::new(format!("cylinders[{index}].rod"), why))
            }
        };
    }
    if let Some(index) = document.cylinders.iter().position(|cylinder| cylinder.crankshaft.is_some()) {
        return Err(Fault::new(format!("cylinders[{index}].crankshaft"), why));
    }
    match document.turning_masses.iter().position(|mass| !mass.axis.is_empty()) {
        Some(index) => Err(Fault::new(format!("turning_masses[{index}].axis"), why)),
        None => Ok(()),
    }
}

fn check_turning_masses(document: &Document) -> Result<(), Fault> {
    if document.masses == Masses::Reciprocating && !document.turning_masses.is_empty() {
        return Err(Fault::new(
            "turning_masses",
            "the verdicts are about the reciprocating masses, so there is none here",
        ));
    }
    let of_shafts = document.turning_masses.iter().filter_map(|mass| mass.coefficient_of.as_ref());
    check_shafts(of_shafts).map_err(|reason| Fault::new("turning_masses", reason))?;
    let knuckles: Vec<String> = document.knuckles().map(|(cylinder, _)| knuckle_name(cylinder)).collect();
    let mut names: Vec<&str> = document.cylinders.iter().map(|cylinder| cylinder.name.as_str()).collect();
    if let Some(name) = knuckles.iter().find(|name| names.contains(&name.as_str())) {
        return Err(Fault::new("cylinders", format!("another cylinder is called {name}")));
    }
    names.extend(knuckles.iter().map(String::as_str));
    names.sort_unstable();
    let mut turning: Vec<&str> = document.turning_masses.iter().map(|mass| mass.name.as_str()).collect();
    turning.sort_unstable();
    let twice = turning.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0]);
    let taken = turning.iter().copied().find(|name| names.binary_search(name).is_ok());
    if let Some(name) = twice.or(taken) {
        return Err(Fault::new("turning_masses", format!("another mass or a cylinder is called {name} too")));
    }
    match document.turning_masses.iter().position(|mass| mass.order == 0) {
        Some(index) => Err(Fault::new(format!("turning_masses[{index}]"), "a mass that turns has an order from 1 on")),
        None => Ok(()),
    }
}

/// Checks each verdict; returns the sums of each order and quantity, with whether they are zero.
fn check_verdicts(document: &Document, audit: &Audit) -> Result<Vec<Judged>, Fault> {
    let mut found = document.verdicts.iter().enumerate();
    let mut judged = Vec::new();
    for &order in &document.orders {
        for &quantity in &document.quantities {
            audit
                .spend(document.steps_of_terms(order))
                .map_err(|refusal| Fault::new(format!("order {order}"), refusal))?;
            let groups = document.groups(quantity, order);
            let is_alone = groups.len() == 1;
            let mut sums = Vec::new();
            for group in groups {
                let mut of_group = Vec::new();
                for &sense in quantity.senses() {
                    let terms = document.terms(&group, quantity, order, sense);
                    let of = terms.iter().filter(|_| !is_alone).map(|(name, _)| name.clone()).collect();
                    let subject = About { quantity, order, sense, of };
                    let Some((index, verdict)) = found.next() else {
                        let place = format!("verdicts[{}] {}", document.verdicts.len(), subject.place());
                        return Err(Fault::new(place, "this verdict is missing"));
                    };
                    let place = format!("verdicts[{index}] {}", subject.place());
                    if verdict.subject() != subject {
                        let found = verdict.subject().place();
                        return Err(Fault::new(place, format!("here stands a verdict on {found}")));
                    }
                    let sum = verdict.said().check(&terms, audit).map_err(|reason| Fault { place, reason })?;
                    of_group.push((sum, verdict.vanishes));
                }
                sums.push(JudgedGroup { coefficient: group.coefficient, is_zero: group.is_zero, sums: of_group });
            }
            judged.push(Judged { quantity, order, groups: sums, wholes: Vec::new() });
        }
    }
    match found.next() {
        None => Ok(judged),
        Some((index, more)) => {
            let place = format!("verdicts[{index}] {}", more.subject().place());
            Err(Fault::new(place, "this verdict was not asked for, or is here twice"))
        }
    }
}

/// Where an order has several sums, each sense has a statement on the whole; a single sum is the whole.
fn check_wholes(document: &Document, judged: &mut [Judged], motion: &Motion<'_>) -> Result<(), Fault> {
    let mut claims = document.wholes.iter().enumerate();
    for one in judged {
        if let [only] = &one.groups[..] {
            one.wholes = only.sums.iter().map(|(_, vanishes)| Some(*vanishes)).collect();
            continue;
        }
        for (place, &sense) in one.quantity.senses().iter().enumerate() {
            let about = About { quantity: one.quantity, order: one.order, sense, of: Vec::new() }.place();
            let Some((index, claim)) = claims.next() else {
                let place = format!("wholes[{}] {about}", document.wholes.len());
                return Err(Fault::new(place, "this statement is missing"));
            };
            let at = format!("wholes[{index}] {about}");
            if (claim.quantity, claim.order, claim.sense) != (one.quantity, one.order, sense) {
                return Err(Fault::new(at, "another statement stands here"));
            }
            let vanishes = check_whole(claim, one, place, motion).map_err(|reason| Fault { place: at, reason })?;
            one.wholes.push(vanishes);
        }
    }
    refuse_if(claims.next().is_some(), Fault::new("wholes", "there are more than orders with several sums have"))
}

/// Each order of force and moment has a shape, in the order of the verdicts.
fn check_shapes(document: &Document, judged: &[Judged], motion: &Motion<'_>) -> Result<(), Fault> {
    let mut claims = document.shapes.iter();
    for (index, one) in judged.iter().filter(|one| one.quantity.senses().len() == 2).enumerate() {
        let about = About { quantity: one.quantity, order: one.order, sense: None, of: Vec::new() };
        let place = format!("shapes[{index}] {}", about.place());
        let Some(claim) = claims.next() else { return Err(Fault::new(place, "this shape is missing")) };
        if (claim.quantity, claim.order) != (one.quantity, one.order) {
            return Err(Fault::new(place, "another shape stands here"));
        }
        check_shape(claim, one, motion).map_err(|reason| Fault { place, reason })?;
    }
    refuse_if(claims.next().is_some(), Fault::new("shapes", "there are more than the verdicts have"))
}

/// Where they were asked for there is one per quantity and sense, in the order of the verdicts; else none. They are given class by
/// class where `recurrences` has anything.
fn check_theorems(document: &Document, audit: &Audit, motion: &Motion<'_>) -> Result<(), Fault> {
    let about = |quantity: &Quantity| match quantity {
        Quantity::Planar(_) => Sense::BOTH.map(|sense| (*quantity, sense)).to_vec(),
        Quantity::Axial(_) => Vec::new(),
    };
    let asked: Vec<(Quantity, Sense)> =
        document.quantities.iter().filter(|_| document.all_orders).flat_map(about).collect();
    match document.recurrences.is_empty() {
        true => check_each(
            "theorem",
            &document.theorems,
            &asked,
            |claim| (claim.quantity, claim.sense),
            |claim| check_theorem(document, claim, audit),
        ),
        false => {
            if !document.theorems.is_empty() {
                return Err(Fault::new("theorems", "what is said class by class is in `recurrences` alone"));
            }
            let subject = |claim: &RecurrenceClaim| (claim.quantity, claim.sense);
            check_each("recurrence", &document.recurrences, &asked, subject, |claim| {
                check_recurrence(document, claim, motion)
            })
        }
    }
}

fn check_each<T>(
    name: &str,
    claims: &[T],
    asked: &[(Quantity, Sense)],
    subject: impl Fn(&T) -> (Quantity, Sense),
    check: impl Fn(&T) -> Result<(), Reason>,
) -> Result<(), Fault> {
    let mut claims = claims.iter();
    for (index, (quantity, sense)) in asked.iter().enumerate() {
        let place = format!("{name}s[{index}] ({}, {})", quantity.name(), sense.name());
        let Some(claim) = claims.next() else { return Err(Fault::new(place, format!("this {name} is missing"))) };
        if subject(claim) != (*quantity, *sense) {
            return Err(Fault::new(place, format!("another {name} stands here")));
        }
        check(claim).map_err(|reason| Fault { place, reason })?;
    }
    refuse_if(claims.next().is_some(), Fault::new(format!("{name}s"), "there are more than were asked for"))
}
