//! What does `classify --json` hold for a family? Every part with its certificate, and when they cancel.

use crate::engine::{Cylinder, Family, Linear};
use crate::family::{Corner, Never, OpenOrder, OpenSum, OpenVerdict, Part, Triangle, When};
use crate::proof::{
    Exact, Format, LinearClaim, Masses, OpenCylinder, OpenDocument, OpenVerdictClaim, PartClaim, ProductClaim,
    Quantity, SumClaim, TriangleClaim, WhenClaim,
};

/// The verdicts on a family as data: what `verify` reads.
pub fn open_document(family: &Family, orders: &[OpenOrder]) -> OpenDocument {
    let cylinder = |cylinder: &Cylinder<Linear, Linear>| OpenCylinder {
        name: cylinder.name.clone(),
        throw: linear(&cylinder.throw),
        bank: linear(&cylinder.bank),
        position: linear(&cylinder.position),
        reciprocating_mass: cylinder.reciprocating_mass.clone(),
        crank_radius: cylinder.crank_radius.clone(),
    };
    OpenDocument {
        format: Format::Family,
        masses: Masses::Reciprocating,
        orders: orders.iter().map(|order| order.order).collect(),
        quantities: Quantity::PLANAR.to_vec(),
        title: family.title().written().to_owned(),
        reference_plane: linear(family.reference_plane()),
        cylinders: family.cylinders().iter().map(cylinder).collect(),
        open_verdicts: orders.iter().flat_map(|order| order.force.iter().chain(&order.moment)).map(verdict).collect(),
    }
}

fn linear(value: &Linear) -> LinearClaim {
    let known = [("1".to_owned(), Exact(value.known().clone()))];
    let symbols = value.symbols().iter().map(|(name, coefficient)| (name.clone(), Exact(coefficient.clone())));
    symbols.chain(known).collect()
}

fn verdict(verdict: &OpenVerdict) -> OpenVerdictClaim {
    OpenVerdictClaim {
        quantity: verdict.quantity.into(),
        order: verdict.order,
        sense: verdict.sense,
        sums: verdict.sums.iter().map(sum).collect(),
    }
}

fn sum(sum: &OpenSum) -> SumClaim {
    SumClaim { symbol: sum.symbol.clone(), parts: sum.parts.iter().map(part).collect(), when: when(&sum.when) }
}

fn part(part: &Part) -> PartClaim {
    PartClaim {
        phi: part.phi.clone(),
        delta: part.delta.clone(),
        terms: part.sum.vectors(),
        certificate: part.certificate.clone(),
    }
}

fn when(when: &When) -> WhenClaim {
    match when {
        When::Always => WhenClaim::Always,
        When::Never(Never::OnePart) => WhenClaim::Never,
        When::Never(Never::UnequalLengths(certificate)) => {
            WhenClaim::UnequalLengths { certificate: certificate.clone() }
        }
        When::Irrational { equal_lengths, .. } => WhenClaim::EqualLengths { certificate: equal_lengths.clone() },
        When::Cosine(found) => WhenClaim::Cosine(found.clone()),
        When::Never(Never::Coprime(found)) => WhenClaim::Coprime(found.clone()),
        When::Never(Never::Circle(found)) | When::Circle(found) => WhenClaim::Circle(Box::new(found.claim.clone())),
        When::Never(Never::Triangle(found)) | When::Triangle(found) => WhenClaim::Triangle(Box::new(triangle(found))),
        When::Never(Never::Classes(found)) | When::Classes(found) => WhenClaim::Classes(Box::new(found.claim.clone())),
        When::Never(Never::Quadratic(found)) | When::Quadratic(found) => {
            WhenClaim::Quadratic(Box::new(found.claim.clone()))
        }
        When::Never(Never::Product(found)) | When::Product(found) => WhenClaim::Product(Box::new(ProductClaim {
            groups: found.groups.clone(),
            certificates: found.certificates.clone(),
            group: self::when(&found.group),
            firsts: self::when(&found.firsts),
        })),
        When::Never(Never::Boxes(found)) | When::Boxes(found) => WhenClaim::Boxes(Box::new(found.claim.clone())),
        When::NotSolved(_) => WhenClaim::NotSolved,
        When::Where(angles) => {
            WhenClaim::Where { alternatives: angles.alternatives.clone(), equal_lengths: angles.equal_lengths.clone() }
        }
    }
}

fn triangle(triangle: &Triangle) -> TriangleClaim {
    let exact = triangle.corners.iter().filter_map(|corner| match corner {
        Corner::Exact(exact) => Some(exact.clone()),
        Corner::Near(_) => None,
    });
    TriangleClaim { shape: triangle.shape.clone(), alternatives: exact.collect() }
}
