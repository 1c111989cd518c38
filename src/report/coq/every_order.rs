//! Which of all even orders are left, and which of all odd ones where rods have an offset? One period of certificates tells it.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::evidence::{Grid, evidence, list};
use super::not_stated::{NotStated, has_pistons};
use super::parts::Parts;
use super::theorem::{Theorem, name, vector};
use crate::exact::{PhasorSum, Term, Turn};
use crate::proof::{Certificate, ClassClaim, Cylinder, Document, Quantity, Sense, TheoremClaim, Vector};
use crate::verdict::LONGEST_PERIOD;

/// The orders 2, 4, 6 … or 3, 5, 7 …
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parity {
    Even,
    Odd,
}

impl Parity {
    pub fn name(self) -> &'static str {
        match self {
            Parity::Even => "even",
            Parity::Odd => "odd",
        }
    }

    /// Which orders k are meant, as premises.
    pub fn premises(self) -> [&'static str; 2] {
        match self {
            Parity::Even => ["2 <= k", "k mod 2 = 0"],
            Parity::Odd => ["3 <= k", "k mod 2 = 1"],
        }
    }

    fn first(self) -> u32 {
        match self {
            Parity::Even => 2,
            Parity::Odd => 3,
        }
    }
}

/// A statement on one vector, of the engine or a part of it, at every second order.
pub(super) struct Pattern {
    pub quantity: Quantity,
    pub sense: Sense,
    /// The engine or the part.
    pub engine: String,
    pub parity: Parity,
    /// An order is left where it is one of the residues modulo this.
    pub modulus: u32,
    residues: Vec<u32>,
    judged: Vec<(Grid, Certificate)>,
}

impl Pattern {
    /// Those that the document proves by a period of verdicts; where it tells classes by recurrences, one for each class, of a period that is
    /// judged here.
    pub fn all(document: &Document, parts: &Parts) -> Result<Vec<Self>, NotStated> {
        let told = document.theorems.iter().map(|claim| Ok(Pattern::told(document, claim)));
        let classes = document.recurrences.iter().flat_map(|claim| {
            let even = claim.even.iter().map(move |class| (claim, Parity::Even, class));
            even.chain(claim.odd.iter().map(move |class| (claim, Parity::Odd, class)))
        });
        told.chain(classes.map(|(claim, parity, class)| {
            let cylinders: Vec<&Cylinder> = in_class(document, class).collect();
            let period = period(&cylinders).ok_or(NotStated::LongPeriod)?;
            let about = (claim.quantity, claim.sense, parity);
            Ok(Pattern::judge(about, parts.engine(&class.of), &cylinders, period, &document.reference_plane))
        }))
        .collect()
    }

    fn told(document: &Document, claim: &TheoremClaim) -> Self {
        let even = claim.verdicts.iter().filter(|verdict| verdict.order % 2 == 0);
        Pattern {
            quantity: claim.quantity,
            sense: claim.sense,
            engine: "the_engine".to_owned(),
            parity: Parity::Even,
            modulus: claim.survivors.modulus,
            residues: claim.survivors.residues.clone(),
            judged: even.map(|verdict| (grid_of(document), verdict.certificate.clone())).collect(),
        }
    }

    fn judge(
        (quantity, sense, parity): (Quantity, Sense, Parity),
        engine: String,
        cylinders: &[&Cylinder],
        period: u32,
        plane: &BigRational,
    ) -> Self {
        let orders: Vec<u32> = (0..period / 2).map(|index| parity.first() + 2 * index).collect();
        let sums = orders.iter().map(|order| sum(cylinders, quantity, sense, *order, plane));
        let judged: Vec<(Grid, Certificate)> =
            sums.map(|sum| (Grid::of(sum.vectors().iter()), sum.certificate())).collect();
        let zero: Vec<bool> = judged.iter().map(|(_, certificate)| certificate.claims_zero()).collect();
        let repeats =
            |length: &usize| zero.len().is_multiple_of(*length) && zero[*length..] == zero[..zero.len() - length];
        let length = (1..=zero.len()).find(repeats).unwrap_or(zero.len());
        let modulus = period / u32::try_from(zero.len() / length).unwrap_or(1);
        let left = orders.iter().zip(&zero).take(length).filter(|(_, zero)| !**zero);
        let mut residues: Vec<u32> = left.map(|(order, _)| order % modulus).collect();
        residues.sort_unstable();
        Pattern { quantity, sense, engine, parity, modulus, residues, judged }
    }

    /// What its theorem is called.
    pub fn name(&self) -> String {
        format!("{}_{}", name(self.quantity, Some(self.sense)), self.ends())
    }

    /// What the names of its theorems end with.
    pub fn ends(&self) -> String {
        let part = if self.engine == "the_engine" { String::new() } else { format!("_{}", self.engine) };
        format!("every_{}_order{part}", self.parity.name())
    }

    /// The residues as a list of Coq.
    pub fn residues(&self) -> String {
        list(self.residues.iter().map(u32::to_string).collect())
    }

    /// The theorem on the vector.
    pub fn theorem(&self) -> Result<Theorem, NotStated> {
        let Pattern { quantity, sense, ref engine, parity, modulus, .. } = *self;
        let orders = (parity.first()..).step_by(2);
        let certificates = self.judged.iter().zip(orders).map(|((grid, certificate), order)| {
            evidence(grid.clone(), certificate).ok_or(NotStated::Scale { quantity, order })
        });
        let evidence = list(certificates.collect::<Result<_, _>>()?).replace("; (Evidence", ";\n    (Evidence");
        let (what, residues, [from, second]) = (vector(quantity, Some(sense)), self.residues(), parity.premises());
        Ok(Theorem::new(
            self.name(),
            &format!(
                "forall k, {from} -> {second} ->\n  vector e {engine} {what} k <> 0%R <-> k mod {modulus} \\in ({residues} : seq Z)"
            ),
            &format!("(@every_{}_order F e {engine} {what} {modulus} {residues}\n  {evidence})", parity.name()),
        ))
    }
}

fn in_class<'a>(document: &'a Document, class: &'a ClassClaim) -> impl Iterator<Item = &'a Cylinder> {
    document.cylinders.iter().filter(|cylinder| has_pistons(document) && class.of.contains(&cylinder.name))
}

/// An even number of orders after which the vectors repeat; none where it is long.
fn period(cylinders: &[&Cylinder]) -> Option<u32> {
    let angles = cylinders.iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank]);
    let period = angles.fold(BigInt::from(2), |period, angle| period.lcm(angle.denom()));
    period.to_u32().filter(|period| *period <= LONGEST_PERIOD)
}

/// The vectors of an order, as Engine.v has them.
fn sum(cylinders: &[&Cylinder], quantity: Quantity, sense: Sense, order: u32, plane: &BigRational) -> PhasorSum {
    let times = |factor: u32, angle: &BigRational| angle * BigRational::from_integer(factor.into());
    let term = |cylinder: &&Cylinder| {
        let Cylinder { throw, bank, position, reciprocating_mass, crank_radius, .. } = *cylinder;
        let angle = match sense {
            Sense::Direct => times(order, throw) - times(order - 1, bank),
            Sense::Reverse => times(order + 1, bank) - times(order, throw),
        };
        let arm = if quantity == Quantity::MOMENT { position - plane } else { BigRational::one() };
        Term { angle: Turn::new(angle), weight: reciprocating_mass * crank_radius * arm }
    };
    PhasorSum::new(cylinders.iter().map(term).collect())
}

/// That of every order: an angle of order k is a whole combination of throws and banks, a weight one of masses times arms.
pub(super) fn grid_of(document: &Document) -> Grid {
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
