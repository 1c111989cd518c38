//! Do the classes of a statement on every order come from the engine, and do their factors tell where they vanish?

use super::audit::{Reason, refuse_if};
use super::check::certify;
use super::collected::collect;
use super::document::Document;
use super::factor_check::{check_factor, expand};
use super::judged::{Judged, JudgedGroup};
use super::motion::Motion;
use super::quantity::Sense;
use super::recurrence::{ClassClaim, Parity, RecurrenceClaim, collect_rays};
use super::source::{Group, Source};
use super::whole_sum::{WholeClaim, check_whole};

/// Order 1 is decided as any other; for each parity the classes are those of its first order, as every other has the same.
pub(super) fn check_recurrence(
    document: &Document,
    claim: &RecurrenceClaim,
    motion: &Motion<'_>,
) -> Result<(), Reason> {
    refuse_if(document.has_links(), "a statement class by class needs rods on the crankpins, no links")?;
    document.check_turning()?;
    check_first(document, claim, motion).map_err(|reason| reason.within("order 1"))?;
    for (parity, classes) in [(Parity::Even, &claim.even), (Parity::Odd, &claim.odd)] {
        let groups = document.groups(claim.quantity, parity.first_order());
        let groups: Vec<&Group> = groups.iter().filter(|group| !group.is_zero && !group.sources.is_empty()).collect();
        if groups.len() != classes.len() {
            let (found, right) = (classes.len(), groups.len());
            return Err(format!("{} orders: {found} classes here, the engine has {right}", parity.name()).into());
        }
        for (index, (group, class)) in groups.into_iter().zip(classes).enumerate() {
            check_class(document, claim, group, class, parity, motion)
                .map_err(|reason| reason.within(format!("{} orders, class {index}", parity.name())))?;
        }
    }
    Ok(())
}

fn check_first(document: &Document, claim: &RecurrenceClaim, motion: &Motion<'_>) -> Result<(), Reason> {
    let (quantity, audit) = (claim.quantity, motion.audit());
    let groups = document.groups(quantity, 1);
    if groups.len() != claim.first.sums.len() {
        return Err(format!("{} sums here, the engine has {}", claim.first.sums.len(), groups.len()).into());
    }
    let place = Sense::BOTH.iter().position(|sense| *sense == claim.sense).unwrap_or_default();
    let mut judged = Judged { quantity, order: 1, groups: Vec::new(), wholes: Vec::new() };
    for (group, verdict) in groups.into_iter().zip(&claim.first.sums) {
        let terms = document.terms(&group, quantity, 1, Some(claim.sense));
        let sum = collect(terms.into_iter().map(|(_, term)| (term.angle, term.weight)), audit)?;
        certify(&sum, verdict.vanishes, &verdict.certificate, audit)?;
        let sum = (sum, verdict.vanishes);
        judged.groups.push(JudgedGroup::of_sense(group.coefficient, group.is_zero, place, sum));
    }
    match (claim.first.outcome, judged.groups.len()) {
        (None, 1) => Ok(()),
        (Some(outcome), 2..) => {
            let whole = WholeClaim { quantity, order: 1, sense: Some(claim.sense), outcome };
            check_whole(&whole, &judged, place, motion).map(|_| ())
        }
        (None, _) => Err("`outcome` is missing: there are several sums".into()),
        (Some(_), _) => Err("`outcome` belongs to several sums: one is the whole".into()),
    }
}

/// The factors multiplied out are the terms of the class, and each tells its zeros.
fn check_class(
    document: &Document,
    claim: &RecurrenceClaim,
    group: &Group<'_>,
    class: &ClassClaim,
    parity: Parity,
    motion: &Motion<'_>,
) -> Result<(), Reason> {
    let audit = motion.audit();
    let terms = document.terms(group, claim.quantity, parity.first_order(), Some(claim.sense));
    let names: Vec<&String> = terms.iter().map(|(name, _)| name).collect();
    if !names.iter().copied().eq(&class.of) {
        return Err(format!("its cylinders are {names:?}").into());
    }
    let mut rays = Vec::new();
    for (source, (_, term)) in group.sources.iter().zip(terms) {
        let Source::Cylinder(cylinder, _) = source else { return Err("a term that is not of a cylinder".into()) };
        let per_order = claim.sense.signed(&cylinder.throw - &cylinder.bank);
        rays.push(([per_order, cylinder.bank.clone()], term.weight));
    }
    refuse_if(class.factors.is_empty(), "a class has one factor at least")?;
    if expand(&class.factors, audit)? != collect_rays(rays) {
        return Err("the factors multiplied out are not the terms of the class".into());
    }
    for (index, factor) in class.factors.iter().enumerate() {
        check_factor(factor, parity, audit).map_err(|reason| reason.within(format!("factor {index}")))?;
    }
    Ok(())
}
