//! What does `classify --json` say, and does all of it hold together?

use std::collections::BTreeMap;

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::audit::{Audit, Fault, Reason};
use super::checked::Checked;
use super::engine::{Cylinder, Masses, Quantity, RodClaim, Sense, check_asked, check_names, has_offset, rods};
use super::fraction;
use super::reading::Format;
use super::shape::{Judged, ShapeClaim, check_shape};
use super::theorem::{TheoremClaim, check_theorem};
use super::verdict::{Subject, VerdictClaim, check_verdict};

/// The verdicts on one engine, each with its certificate: the JSON document of `classify --json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// `crankstar classify 2`.
    pub format: Format,
    /// Title of the layout: free text.
    pub title: String,
    /// Whose masses the verdicts are about: the reciprocating ones.
    pub masses: Masses,
    /// The orders that were asked for, rising.
    pub orders: Vec<u32>,
    /// The quantities that were asked for, in the order force, moment, torque.
    pub quantities: Vec<Quantity>,
    /// Whether the statements on every order were asked for.
    pub all_orders: bool,
    /// Position along the crankshaft that the moments are taken about, in metres (or multiples of the spacing).
    #[serde(with = "fraction")]
    pub reference_plane: BigRational,
    /// The engine that the terms come from.
    pub cylinders: Vec<Cylinder>,
    /// One verdict an order, class of equal rods, quantity and sense, in this order.
    pub verdicts: Vec<VerdictClaim>,
    /// The shape of what is left, one an order, class of equal rods, and force and moment.
    pub shapes: Vec<ShapeClaim>,
    /// The statements on every order, one a quantity and sense, where they were asked for.
    pub theorems: Vec<TheoremClaim>,
}

/// Checks that a document holds: that the verdicts asked for are all there and no other, that their terms are those of
/// its cylinders, that every certificate proves what it claims, and that the decimals fit.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_document(document: &Document) -> Result<Checked, Fault> {
    let audit = Audit::new();
    check_head(document)?;
    let judged = check_verdicts(document, &audit)?;
    check_shapes(document, &judged, &audit)?;
    check_theorems(document, &audit)?;
    let rods_known = document.rods().is_ok_and(|rods| rods.is_some());
    Ok(Checked::classify(document, rods_known, audit.counts()))
}

fn check_head(document: &Document) -> Result<(), Fault> {
    match document.format {
        Format::Classify => (),
        Format::Family | Format::Remedy => return Err(Fault::new("format", "verdicts are in `crankstar classify 2`")),
    }
    match document.masses {
        Masses::Reciprocating => (),
        Masses::All => return Err(Fault::new("masses", "this format knows verdicts on the reciprocating masses only")),
    }
    check_names(document.cylinders.iter().map(|cylinder| cylinder.name.as_str()))?;
    check_asked(&document.orders, &document.quantities)?;
    document.rods().map(|_| ()).map_err(|reason| Fault { place: "cylinders".into(), reason })
}

impl Document {
    fn rods(&self) -> Result<Option<Vec<&RodClaim>>, Reason> {
        rods(self.cylinders.iter().map(|cylinder| &cylinder.rod))
    }

    pub(super) fn has_equal_centric_rods(&self) -> bool {
        self.rods().is_ok_and(|rods| {
            rods.is_none_or(|rods| rods.windows(2).all(|pair| pair[0] == pair[1]) && !has_offset(&rods))
        })
    }

    /// The cylinders with equal rods, by name, in the order of the cylinders; none where no rod differs.
    fn classes(&self) -> Vec<Vec<String>> {
        let Ok(Some(rods)) = self.rods() else { return Vec::new() };
        let mut places: BTreeMap<&RodClaim, usize> = BTreeMap::new();
        let mut classes: Vec<Vec<String>> = Vec::new();
        for (cylinder, rod) in self.cylinders.iter().zip(rods) {
            let place = *places.entry(rod).or_insert(classes.len());
            if place == classes.len() {
                classes.push(Vec::new());
            }
            classes[place].push(cylinder.name.clone());
        }
        if classes.len() > 1 { classes } else { Vec::new() }
    }

    /// Whether order 1 has one coefficient whatever the rods are: all centric cranks have `c_1 = 1`; those of the torque
    /// differ with the rods at every order.
    fn order_one_is_common(&self) -> bool {
        let centric = self.rods().is_ok_and(|rods| rods.is_none_or(|rods| !has_offset(&rods)));
        centric && !self.quantities.contains(&Quantity::Torque)
    }
}

/// What the verdicts have to be about, in their order. Where rods differ, each class of equal ones is judged apart, since
/// only they have the coefficient c_k in common; an empty list of cylinders means all.
fn subjects<'a>(
    document: &'a Document,
    classes: &'a [Vec<String>],
    order_one_is_common: bool,
) -> impl Iterator<Item = Subject> + 'a {
    let all = || std::slice::from_ref(const { &Vec::new() });
    document.orders.iter().flat_map(move |&order| {
        let apart = !classes.is_empty() && (order > 1 || !order_one_is_common);
        let classes = if apart { classes } else { all() };
        classes.iter().flat_map(move |of| {
            document.quantities.iter().flat_map(move |&quantity| {
                let senses = quantity.senses().iter();
                senses.map(move |&sense| Subject { quantity, order, sense, of: of.clone() })
            })
        })
    })
}

/// Checks each verdict; returns its subject, and its sum with whether it is zero.
fn check_verdicts(document: &Document, audit: &Audit) -> Result<Vec<(Subject, Judged)>, Fault> {
    let mut found = document.verdicts.iter();
    let mut judged = Vec::new();
    let classes = document.classes();
    for (index, subject) in subjects(document, &classes, document.order_one_is_common()).enumerate() {
        let place = format!("verdicts[{index}] {}", subject.place());
        let Some(verdict) = found.next() else { return Err(Fault::new(place, "this verdict is missing")) };
        if verdict.subject() != subject {
            let found = verdict.subject().place();
            return Err(Fault::new(place, format!("here stands a verdict on {found}")));
        }
        let sum = check_verdict(document, verdict, audit).map_err(|reason| Fault { place, reason })?;
        judged.push((subject, (sum, verdict.vanishes)));
    }
    match found.next() {
        None => Ok(judged),
        Some(more) => {
            let place = format!("verdicts[{}] {}", judged.len(), more.subject().place());
            Err(Fault::new(place, "this verdict was not asked for, or stands here again"))
        }
    }
}

/// Each force and moment has a shape, in the order of the verdicts.
fn check_shapes(document: &Document, judged: &[(Subject, Judged)], audit: &Audit) -> Result<(), Fault> {
    let pairs = judged.windows(2).filter_map(|pair| match pair {
        [(direct, first), (reverse, second)]
            if (direct.sense, reverse.sense) == (Some(Sense::Direct), Some(Sense::Reverse)) =>
        {
            Some((direct, [first, second]))
        }
        _ => None,
    });
    let mut claims = document.shapes.iter();
    for (index, (subject, vectors)) in pairs.enumerate() {
        let about = Subject { sense: None, ..subject.clone() };
        let place = format!("shapes[{index}] {}", about.place());
        let Some(claim) = claims.next() else { return Err(Fault::new(place, "this shape is missing")) };
        if (claim.quantity, claim.order, &claim.of) != (about.quantity, about.order, &about.of) {
            return Err(Fault::new(place, "another shape stands here"));
        }
        check_shape(claim, vectors, audit).map_err(|reason| Fault { place, reason })?;
    }
    match claims.next() {
        None => Ok(()),
        Some(_) => Err(Fault::new("shapes", "there are more than the verdicts have")),
    }
}

/// Where they were asked for there is one a quantity and sense, in the order of the verdicts; else none.
fn check_theorems(document: &Document, audit: &Audit) -> Result<(), Fault> {
    let about = |quantity: &Quantity| match quantity {
        Quantity::Force | Quantity::Moment => Sense::BOTH.map(|sense| (*quantity, sense)).to_vec(),
        Quantity::Torque => Vec::new(),
    };
    let asked = document.quantities.iter().filter(|_| document.all_orders).flat_map(about);
    let mut claims = document.theorems.iter();
    for (index, (quantity, sense)) in asked.enumerate() {
        let place = format!("theorems[{index}] ({}, {})", quantity.name(), sense.name());
        let Some(claim) = claims.next() else { return Err(Fault::new(place, "this theorem is missing")) };
        if (claim.quantity, claim.sense) != (quantity, sense) {
            return Err(Fault::new(place, "another theorem stands here"));
        }
        check_theorem(document, claim, audit).map_err(|reason| Fault { place, reason })?;
    }
    match claims.next() {
        None => Ok(()),
        Some(_) => Err(Fault::new("theorems", "there are more than were asked for")),
    }
}
