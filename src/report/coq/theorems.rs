//! Which theorems does the file hold, and by what are they proved?

use super::every_order::Pattern;
use super::evidence::{Grid, evidence, grid_of};
use super::not_stated::NotStated;
use super::parts::Parts;
use super::theorem::{Theorem, kind, name, vector};
use crate::proof::{
    Certificate, Document, Quantity, Sense, Shape, ShapeClaim, ShapeEvidence, TheoremClaim, VerdictClaim,
};

/// A theorem for each verdict, shape and statement on every order, in the order of the document.
pub(super) fn theorems(document: &Document, parts: &Parts, every: &[Pattern]) -> Result<Vec<Theorem>, NotStated> {
    let verdicts = document.verdicts.iter().map(|verdict| of_verdict(verdict, parts));
    let shapes = document.shapes.iter().filter_map(|shape| of_shape(document, shape).transpose());
    let first = document.theorems.iter().filter_map(|claim| of_first_order(document, claim));
    verdicts.chain(shapes).chain(first).chain(every.iter().map(Pattern::theorem)).collect()
}

/// The vector that a theorem is about.
struct About {
    quantity: Quantity,
    order: u32,
    sense: Option<Sense>,
    /// The engine, or the part of it.
    engine: String,
    /// What the name of the theorem ends with.
    ends: String,
}

fn of_verdict(verdict: &VerdictClaim, parts: &Parts) -> Result<Theorem, NotStated> {
    let VerdictClaim { quantity, order, sense, .. } = *verdict;
    let about = About { quantity, order, sense, engine: parts.engine(&verdict.of), ends: parts.order(verdict) };
    of_sum(&about, verdict.vanishes, Grid::of(verdict.terms.iter()), &verdict.certificate)
}

fn of_sum(about: &About, vanishes: bool, grid: Grid, certificate: &Certificate) -> Result<Theorem, NotStated> {
    let About { quantity, order, sense, ref engine, ref ends } = *about;
    let evidence = evidence(grid, certificate).ok_or(NotStated::Scale { quantity, order })?;
    let (relation, lemma) = if vanishes { ("=", "vanishes") } else { ("<>", "is_left") };
    let what = vector(quantity, sense);
    Ok(Theorem::new(
        format!("{}_{ends}", name(quantity, sense)),
        &format!("vector e {engine} {what} {order} {relation} 0%R"),
        &format!("(@{lemma} F e {engine} {what} {order}\n  {evidence})"),
    ))
}

/// That the two vectors are equally long, or that they are not; nothing where one of them is zero.
fn of_shape(document: &Document, claim: &ShapeClaim) -> Result<Option<Theorem>, NotStated> {
    let (relation, lemma) = match claim.shape {
        Shape::Planar => ("=", "equal_lengths"),
        Shape::Elliptical => ("<>", "unequal_lengths"),
        Shape::Balanced | Shape::Rotating | Shape::CounterRotating | Shape::NotDecided | Shape::DoesNotExist => {
            return Ok(None);
        }
    };
    let (quantity, order) = (claim.quantity, claim.order);
    let vectors = || document.verdicts.iter().filter(|verdict| (verdict.quantity, verdict.order) == (quantity, order));
    // Where rods differ, the lengths are those of a whole that no vector of the file is.
    let certificate = match &claim.evidence {
        Some(ShapeEvidence::Certificate(certificate)) if vectors().all(|verdict| verdict.of.is_empty()) => certificate,
        Some(_) | None => return Ok(None),
    };
    let grid = Grid::of(vectors().flat_map(|verdict| &verdict.terms)).squared();
    let evidence = evidence(grid, certificate).ok_or(NotStated::Scale { quantity, order })?;
    let length = |sense| format!("`|vector e the_engine {} {order}|%R", vector(quantity, Some(sense)));
    Ok(Some(Theorem::new(
        format!("{}_lengths_order_{order}", quantity.name()),
        &format!("{} {relation} {}", length(Sense::Direct), length(Sense::Reverse)),
        &format!("(@{lemma} F e the_engine {} {order}\n  {evidence})", kind(quantity)),
    )))
}

/// Order 1, where it is not judged besides.
fn of_first_order(document: &Document, claim: &TheoremClaim) -> Option<Result<Theorem, NotStated>> {
    let first = claim.verdicts.iter().find(|verdict| verdict.order == 1 && !document.orders.contains(&1))?;
    let about = About {
        quantity: claim.quantity,
        order: 1,
        sense: Some(claim.sense),
        engine: "the_engine".to_owned(),
        ends: "order_1".to_owned(),
    };
    Some(of_sum(&about, first.vanishes, grid_of(document), &first.certificate))
}
