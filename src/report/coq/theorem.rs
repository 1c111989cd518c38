//! Which theorems does the file hold, and by what are they proved?

use num_rational::BigRational;

use super::engine::sense;
use super::evidence::{Grid, evidence, list};
use super::not_stated::NotStated;
use super::parts::Parts;
use crate::proof::{
    Certificate, Document, OrderClaim, Quantity, Sense, Shape, ShapeClaim, ShapeEvidence, TheoremClaim, Vector,
    VerdictClaim,
};

/// A theorem with its proof.
pub(super) struct Theorem {
    /// Letters, digits and `_`: nothing that a person wrote.
    pub name: String,
    /// All of it.
    pub text: String,
}

impl Theorem {
    /// A theorem that a lemma of Checker.v shows, once its premise is computed.
    fn new(name: String, statement: &str, lemma: &str) -> Self {
        let text = format!("Theorem {name} :\n  {statement}.\nProof. apply: {lemma}; vm_compute; reflexivity. Qed.\n");
        Theorem { name, text }
    }

    /// A theorem that one term proves.
    pub fn exact(name: String, statement: &str, term: &str) -> Self {
        let text = format!("Theorem {name} :\n  {statement}.\nProof. exact: ({term}). Qed.\n");
        Theorem { name, text }
    }
}

/// A theorem for each verdict, shape and statement on every order, in the order of the document.
pub(super) fn theorems(document: &Document, parts: &Parts) -> Result<Vec<Theorem>, NotStated> {
    let verdicts = document.verdicts.iter().map(|verdict| of_verdict(verdict, parts));
    let shapes = document.shapes.iter().filter_map(|shape| of_shape(document, shape).transpose());
    let every = document.theorems.iter().flat_map(|claim| of_every_order(document, claim));
    verdicts.chain(shapes).chain(every).collect()
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

/// Order 1, where it is not judged besides, and all even orders at once.
fn of_every_order(document: &Document, claim: &TheoremClaim) -> Vec<Result<Theorem, NotStated>> {
    let (quantity, sense) = (claim.quantity, Some(claim.sense));
    let of_order = |verdict: &OrderClaim| {
        let (order, ends) = (verdict.order, format!("order_{}", verdict.order));
        let about = About { quantity, order, sense, engine: "the_engine".to_owned(), ends };
        of_sum(&about, verdict.vanishes, grid_of(document), &verdict.certificate)
    };
    let (even, first): (Vec<&OrderClaim>, Vec<&OrderClaim>) =
        claim.verdicts.iter().partition(|verdict| verdict.order % 2 == 0);
    let first = first.into_iter().filter(|verdict| !document.orders.contains(&verdict.order)).map(of_order);
    let all: Result<Vec<String>, NotStated> = even
        .iter()
        .map(|verdict| {
            let order = verdict.order;
            evidence(grid_of(document), &verdict.certificate).ok_or(NotStated::Scale { quantity, order })
        })
        .collect();
    let every = all.map(|evidence| {
        let what = vector(quantity, sense);
        let (residues, modulus) = (even_residues(claim), claim.survivors.modulus);
        Theorem::new(
            format!("{}_every_even_order", name(quantity, sense)),
            &format!(
                "forall k, 2 <= k -> k mod 2 = 0 ->\n  vector e the_engine {what} k <> 0%R <-> k mod {modulus} \\in ({residues} : seq Z)"
            ),
            &format!(
                "(@every_even_order F e the_engine {what} {modulus} {residues}\n  {})",
                list(evidence).replace("; (Evidence", ";\n    (Evidence")
            ),
        )
    });
    first.chain(std::iter::once(every)).collect()
}

/// The residues at which an even order is left.
pub(super) fn even_residues(claim: &TheoremClaim) -> String {
    list(claim.survivors.residues.iter().map(u32::to_string).collect())
}

/// That of every order: an angle of order k is a whole combination of throws and banks, a weight one of masses times arms.
fn grid_of(document: &Document) -> Grid {
    let arm = |position: &BigRational| position - &document.reference_plane;
    let of = |angle: &BigRational, weight: BigRational| Vector { angle: angle.clone(), weight };
    let cylinders = document.cylinders.iter().flat_map(|cylinder| {
        let weight = &cylinder.reciprocating_mass * &cylinder.crank_radius;
        let moment = &weight * arm(&cylinder.position);
        [of(&cylinder.throw, weight), of(&cylinder.bank, moment)]
    });
    let turning = document.turning_masses.iter().flat_map(|mass| {
        let moment = &mass.mass_radius * arm(&mass.position);
        [of(&mass.angle, mass.mass_radius.clone()), of(&mass.angle, moment)]
    });
    let vectors: Vec<Vector> = cylinders.chain(turning).collect();
    Grid::of(vectors.iter())
}

/// What a theorem is called: of letters alone.
pub(super) fn name(quantity: Quantity, sense: Option<Sense>) -> String {
    match sense {
        Some(sense) => format!("{}_{}", quantity.name(), sense.name()),
        None => quantity.name().to_owned(),
    }
}

fn kind(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::FORCE => "Force",
        Quantity::MOMENT => "Moment",
        Quantity::Axial(_) => "Torque",
    }
}

/// The quantity as Engine.v calls it.
fn vector(quantity: Quantity, of: Option<Sense>) -> String {
    match of {
        Some(of) => format!("({} {})", kind(quantity), sense(of)),
        None => kind(quantity).to_owned(),
    }
}
