//! Does all that a document of firing stars says hold together?
//!
//! The vector of a cylinder that fires at the crank angle φ_j is at `−κφ_j` and is as long as its crank radius times its
//! deflection. Cylinders whose rods differ in ratio or offset make different torques from one pressure: a star for each class.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::audit::{Audit, Fault, demand, refuse_if, steps_of};
use super::check::certify;
use super::checked::Checked;
use super::collected::collect;
use super::engine::{RodStatement, check_masters, check_names, check_radii, rods};
use super::firing::{CycleClaim, FiringClaim, FiringCylinder, FiringDocument, PatternClaim};
use super::format::Format;
use super::vector::Vector;
use super::verdict::SaidSum;

/// Checks that a document of firing stars holds: that the stars asked for are all there and no other, that each vector is that of
/// its cylinder, that the cylinders can fire when they are said to, and that each certificate proves what it claims.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_firing_document(document: &FiringDocument) -> Result<Checked, Fault> {
    let audit = Audit::new();
    check_head(document)?;
    check_orders(document)?;
    check_endless(&document.cylinders)?;
    let classes = classes(&document.cylinders);
    check_verdicts(document, &classes, &audit)?;
    if let Some(pattern) = &document.pattern {
        check_pattern(document, pattern, &classes, &audit)?;
    }
    Ok(Checked::firing(document, audit.counts()))
}

impl CycleClaim {
    /// Its length in turns of the crank.
    fn turns(self) -> BigRational {
        BigRational::from_integer(match self {
            CycleClaim::TwoStroke => 1.into(),
            CycleClaim::FourStroke => 2.into(),
        })
    }

    /// What happens once in it has this order.
    fn lowest_order(self) -> BigRational {
        self.turns().recip()
    }
}

/// Each cylinder fires within the cycle, and at a top dead centre of its own; the first of them at 0.
fn check_head(document: &FiringDocument) -> Result<(), Fault> {
    refuse_if(document.format != Format::Firing, Fault::new("format", "firing stars are in `crankstar firing 1`"))?;
    check_names(document.cylinders.iter().map(|cylinder| cylinder.name.as_str()))?;
    let held = document.cylinders.iter().map(|one| (&one.throw, &one.bank, &one.rod, [&one.crank_radius]));
    rods(document.cylinders.iter().map(|cylinder| &cylinder.rod))
        .and_then(|_| check_radii(document.cylinders.iter().map(|one| &one.crank_radius)))
        .and_then(|()| check_masters(held))
        .map_err(|reason| Fault { place: "cylinders".into(), reason })?;
    let centre = |cylinder: &FiringCylinder| &cylinder.firing_angle - (&cylinder.bank - &cylinder.throw);
    let cycle = document.cycle.turns();
    let first = document.cylinders.first().map(centre).unwrap_or_default();
    for (index, cylinder) in document.cylinders.iter().enumerate() {
        let wrong = |words: String| Err(Fault::new(format!("cylinders[{index}].firing_angle"), words));
        let angle = &cylinder.firing_angle;
        if angle.is_negative() || *angle >= cycle {
            return wrong(format!("{angle} turns do not lie within the cycle of {cycle}"));
        }
        if !(centre(cylinder) - &first).is_integer() {
            return wrong(format!("at {angle} turns cylinder {} is not at a top dead centre", cylinder.name));
        }
    }
    match document.cylinders.iter().any(|cylinder| cylinder.firing_angle.is_zero()) {
        true => Ok(()),
        false => Err(Fault::new("cylinders", "no cylinder fires at 0, from where the angles are counted")),
    }
}

fn check_orders(document: &FiringDocument) -> Result<(), Fault> {
    let lowest = document.cycle.lowest_order();
    if document.orders.is_empty() && document.pattern.is_none() {
        return Err(Fault::new("orders", "the list is empty, there is nothing to check"));
    }
    if let Some(order) = document.orders.iter().find(|order| !order.is_positive() || !(*order / &lowest).is_integer()) {
        return Err(Fault::new(
            "orders",
            format!("{order} is not an order of the cycle: they are multiples of {lowest}"),
        ));
    }
    demand(document.orders.windows(2).all(|pair| pair[0] < pair[1]), Fault::new("orders", "orders rise, each once"))
}

/// Motions of infinitely long rods with several slopes are all made of the same two, so that a star of each slope proves nothing.
fn check_endless(cylinders: &[FiringCylinder]) -> Result<(), Fault> {
    let endless = cylinders.iter().filter_map(|cylinder| cylinder.rod.on_the_pin()).filter(|rod| rod.ratio.is_zero());
    let offsets: Vec<_> = endless.map(|rod| &rod.offset).collect();
    let are_equal = offsets.windows(2).all(|pair| pair[0] == pair[1]);
    demand(are_equal, Fault::new("cylinders", "infinitely long rods have several offsets, and no stars of their own"))
}

/// The cylinders by their rods, in the order of the first of each.
fn classes(cylinders: &[FiringCylinder]) -> Vec<Vec<&FiringCylinder>> {
    let mut classes: Vec<(&RodStatement, Vec<&FiringCylinder>)> = Vec::new();
    for cylinder in cylinders {
        match classes.iter_mut().find(|(rod, _)| **rod == cylinder.rod) {
            Some((_, members)) => members.push(cylinder),
            None => classes.push((&cylinder.rod, vec![cylinder])),
        }
    }
    classes.into_iter().map(|(_, members)| members).collect()
}

/// The vectors of a star, with the names of their cylinders.
fn vectors(class: &[&FiringCylinder], order: &BigRational) -> Vec<(String, Vector)> {
    let vector = |cylinder: &&FiringCylinder| {
        let angle = -(order * &cylinder.firing_angle);
        let weight = &cylinder.crank_radius * &cylinder.deflection;
        (cylinder.name.clone(), Vector { angle, weight })
    };
    class.iter().map(vector).collect()
}

fn check_verdicts(document: &FiringDocument, classes: &[Vec<&FiringCylinder>], audit: &Audit) -> Result<(), Fault> {
    let mut found = document.verdicts.iter().enumerate();
    for order in &document.orders {
        audit
            .spend(steps_of(order).saturating_mul(document.cylinders.len() as u64))
            .map_err(|refusal| Fault::new(format!("order {order}"), refusal))?;
        for class in classes {
            let of: Vec<&str> = match classes.len() {
                1 => Vec::new(),
                _ => class.iter().map(|cylinder| cylinder.name.as_str()).collect(),
            };
            let Some((index, verdict)) = found.next() else {
                return Err(Fault::new(format!("verdicts[{}]", document.verdicts.len()), "this verdict is missing"));
            };
            let place = format!("verdicts[{index}] (order {order})");
            if verdict.order != *order || verdict.of != of {
                return Err(Fault::new(place, "another verdict stands here"));
            }
            verdict.said().check(&vectors(class, order), audit).map_err(|reason| Fault { place, reason })?;
        }
    }
    match found.next() {
        None => Ok(()),
        Some((index, _)) => Err(Fault::new(format!("verdicts[{index}]"), "this verdict was not asked for")),
    }
}

/// Every firing angle times the lowest order times the period is whole, so the stars repeat; all of one period are there.
fn check_pattern(
    document: &FiringDocument,
    pattern: &PatternClaim,
    classes: &[Vec<&FiringCylinder>],
    audit: &Audit,
) -> Result<(), Fault> {
    let lowest = document.cycle.lowest_order();
    let repeats = &lowest * BigRational::from_integer(pattern.period.into());
    let wrong = |words: String| Fault::new("pattern.period", words);
    if pattern.period == 0 {
        return Err(wrong("after no order nothing repeats".into()));
    }
    if let Some(cylinder) = document.cylinders.iter().find(|one| !(&one.firing_angle * &repeats).is_integer()) {
        let words = format!("the star of cylinder {} does not repeat after {} orders", cylinder.name, pattern.period);
        return Err(wrong(words));
    }
    let mut found = pattern.verdicts.iter().enumerate();
    for index in 1..=pattern.period {
        let order = &lowest * BigRational::from_integer(index.into());
        for class in classes {
            let place = |index: usize| format!("pattern.verdicts[{index}] (order {order})");
            let Some((index, verdict)) = found.next() else {
                return Err(Fault::new(place(pattern.verdicts.len()), "this verdict is missing"));
            };
            if verdict.order != order {
                return Err(Fault::new(place(index), "another verdict stands here"));
            }
            let terms = vectors(class, &order).into_iter().map(|(_, vector)| (vector.angle, vector.weight));
            let holds =
                collect(terms, audit).and_then(|sum| certify(&sum, verdict.vanishes, &verdict.certificate, audit));
            holds.map_err(|refusal| Fault { place: place(index), reason: refusal.into() })?;
        }
    }
    match found.next() {
        None => Ok(()),
        Some((index, _)) => Err(Fault::new(format!("pattern.verdicts[{index}]"), "it is beyond the period")),
    }
}

impl FiringClaim {
    fn said(&self) -> SaidSum<'_> {
        let FiringClaim { terms, vanishes, modulus, angle_deg, certificate, .. } = self;
        SaidSum { terms, vanishes: *vanishes, modulus: *modulus, angle_deg: *angle_deg, certificate }
    }
}

impl FiringDocument {
    /// Whether the stars are weighed by a mode shape.
    pub(super) fn has_mode_shape(&self) -> bool {
        self.cylinders.iter().any(|cylinder| !cylinder.deflection.is_one())
    }
}
