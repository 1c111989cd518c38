//! Which of all even orders are left, which of all odd ones where rods have an offset, and which of all of a firing star? One period of
//! certificates tells it, or those of the orders of a long period that may vanish.

use num_bigint::BigInt;
use num_traits::One;

use super::evidence::{Grid, evidence, fraction, grid_of, list};
use super::not_stated::NotStated;
use super::parts::Parts;
use super::theorem::{Theorem, name, vector};
use crate::proof::{Certificate, Document, FactorClaim, FiringDocument, Quantity, RayClaim, Sense};

/// The orders 2, 4, 6 … or 3, 5, 7 … or all from 1 on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Orders {
    Even,
    Odd,
    All,
}

impl Orders {
    fn name(self) -> &'static str {
        match self {
            Orders::Even => "even_",
            Orders::Odd => "odd_",
            Orders::All => "",
        }
    }

    /// Which orders k are meant, as premises.
    pub fn premises(self) -> &'static [&'static str] {
        match self {
            Orders::Even => &["2 <= k", "k mod 2 = 0"],
            Orders::Odd => &["3 <= k", "k mod 2 = 1"],
            Orders::All => &["1 <= k"],
        }
    }
}

/// A statement on one vector, of the engine or a part of it, at all these orders.
pub(super) struct Pattern<'a> {
    pub quantity: Quantity,
    pub sense: Option<Sense>,
    /// The engine or the part.
    pub engine: String,
    pub orders: Orders,
    basis: Basis<'a>,
    /// What all angles and weights of the engine become whole by.
    grid: Grid,
}

/// On what it rests.
enum Basis<'a> {
    /// By the verdicts on one period: an order is left where it has one of these residues.
    Period { modulus: u32, residues: Vec<u32>, judged: Vec<(u32, &'a Certificate)> },
    /// As a product of sums, each with where it vanishes.
    Factors(&'a [FactorClaim]),
}

impl<'a> Pattern<'a> {
    /// Those that the document proves by a period of verdicts, and those that it tells class by class.
    pub fn all(document: &'a Document, parts: &Parts) -> Vec<Self> {
        let grid = grid_of(document);
        let told = document.theorems.iter().map(|claim| {
            let even = claim.verdicts.iter().filter(|verdict| verdict.order % 2 == 0);
            Pattern {
                quantity: claim.quantity,
                sense: Some(claim.sense),
                engine: "the_engine".to_owned(),
                orders: Orders::Even,
                basis: Basis::Period {
                    modulus: claim.survivors.modulus,
                    residues: claim.survivors.residues.clone(),
                    judged: even.map(|verdict| (verdict.order, &verdict.certificate)).collect(),
                },
                grid: grid.clone(),
            }
        });
        let classes = document.recurrences.iter().flat_map(|claim| {
            let even = claim.even.iter().map(move |class| (claim, Orders::Even, class));
            even.chain(claim.odd.iter().map(move |class| (claim, Orders::Odd, class)))
        });
        let classes = classes.map(|(claim, orders, class)| Pattern {
            quantity: claim.quantity,
            sense: Some(claim.sense),
            engine: parts.engine(&class.of),
            orders,
            basis: Basis::Factors(&class.factors),
            grid: grid.clone(),
        });
        told.chain(classes).collect()
    }

    /// Those on firing stars, one for each class of cylinders; `document` has them as an engine that turns once in a cycle.
    pub fn of_cycle(firing: &'a FiringDocument, document: &Document, parts: &Parts) -> Vec<Self> {
        let Some(pattern) = &firing.pattern else { return Vec::new() };
        let first = firing.verdicts.first().map(|verdict| &verdict.order);
        let classes = firing.verdicts.iter().filter(|verdict| Some(&verdict.order) == first);
        let classes: Vec<&[String]> = classes.map(|verdict| verdict.of.as_slice()).collect();
        let of_class = |(place, of): (usize, &&[String])| {
            let verdicts = pattern.verdicts.iter().skip(place).step_by(classes.len());
            let judged: Vec<(u32, &Certificate)> = (1..).zip(verdicts.map(|verdict| &verdict.certificate)).collect();
            let left: Vec<u32> =
                judged.iter().filter(|(_, certificate)| !certificate.claims_zero()).map(|(order, _)| *order).collect();
            let is_left = |order: u32| left.binary_search(&order).is_ok();
            let repeats = |modulus: &u32| {
                pattern.period.is_multiple_of(*modulus)
                    && (1..=pattern.period - modulus).all(|order| is_left(order) == is_left(order + modulus))
            };
            let modulus = (1..=pattern.period).find(repeats).unwrap_or(pattern.period);
            let mut residues: Vec<u32> =
                left.iter().filter(|order| **order <= modulus).map(|order| order % modulus).collect();
            residues.sort_unstable();
            Pattern {
                quantity: Quantity::TORQUE,
                sense: None,
                engine: parts.engine(of),
                orders: Orders::All,
                basis: Basis::Period { modulus, residues, judged },
                grid: grid_of(document),
            }
        };
        classes.iter().enumerate().map(of_class).collect()
    }

    /// What its theorem is called.
    pub fn name(&self) -> String {
        format!("{}_{}", name(self.quantity, self.sense), self.ends())
    }

    /// What the names of its theorems end with.
    pub fn ends(&self) -> String {
        let part = if self.engine == "the_engine" { String::new() } else { format!("_{}", self.engine) };
        format!("every_{}order{part}", self.orders.name())
    }

    /// When order k is left; `scope` is that of the whole numbers, where another is open.
    pub fn left(&self, scope: &str) -> String {
        let among = |modulus: u32, is: &str, residues: &[u32]| {
            format!("(k mod {modulus}){scope} \\{is} ({}{scope} : seq Z)", residues_of(residues))
        };
        match &self.basis {
            Basis::Period { modulus, residues, .. } => among(*modulus, "in", residues),
            Basis::Factors(factors) => {
                let left = |factor: &FactorClaim| among(factor.zeros.modulus, "notin", &factor.zeros.residues);
                factors.iter().map(left).collect::<Vec<_>>().join(" /\\ ")
            }
        }
    }

    /// The theorem on the vector.
    pub fn theorem(&self) -> Result<Theorem, NotStated> {
        let Pattern { quantity, sense, ref engine, orders, .. } = *self;
        let what = vector(quantity, sense);
        let lemma = match &self.basis {
            Basis::Period { modulus, residues, judged } => {
                let judged =
                    judged.iter().map(|(order, certificate)| self.evidence(self.grid.clone(), *order, certificate));
                let residues = residues_of(residues);
                let evidence = list(judged.collect::<Result<_, _>>()?).replace("; (Evidence", ";\n    (Evidence");
                match sense {
                    Some(_) => format!("@every_even_order F e {engine} {what} {modulus} {residues}\n  {evidence}"),
                    None => format!("@every_torque_order F e {engine} {modulus} {residues}\n  {evidence}"),
                }
            }
            Basis::Factors(factors) => {
                let grid = factors.iter().map(|factor| of_rays(&factor.terms)).fold(Grid::one(), Grid::product);
                let grid = grid.common(&self.grid);
                let factors = factors.iter().map(|factor| self.factor(factor)).collect::<Result<_, _>>()?;
                let (orders, factors) = (orders.name(), list(factors));
                let Grid { conductor, scale } = grid;
                format!("@{orders}recurrence F e {engine} {what} {conductor} {scale}\n  {factors}")
            }
        };
        let statement = format!(
            "forall k, {} ->\n  vector e {engine} {what} k <> 0%R <-> {}",
            orders.premises().join(" -> "),
            self.left("")
        );
        Ok(Theorem::new(self.name(), &statement, &format!("({lemma})")))
    }

    fn evidence(&self, grid: Grid, order: u32, certificate: &Certificate) -> Result<String, NotStated> {
        evidence(grid, certificate).ok_or(NotStated::Scale { quantity: self.quantity, order })
    }

    fn factor(&self, factor: &FactorClaim) -> Result<String, NotStated> {
        let grid = of_rays(&factor.terms);
        let ray = |RayClaim { per_order, fixed, weight }: &RayClaim| {
            let [per_order, fixed, weight] = [per_order, fixed, weight].map(fraction);
            format!("({per_order}, {fixed}, {weight})%q")
        };
        let judged = factor.judged.iter().map(|verdict| {
            let evidence = self.evidence(grid.clone(), verdict.order, &verdict.certificate)?;
            Ok(format!("({}, {evidence})", verdict.order))
        });
        let judged = list(judged.collect::<Result<_, _>>()?).replace("; (", ";\n    (");
        let Grid { conductor, scale } = &grid;
        Ok(format!(
            "(Factor {}\n    {conductor} {scale} {} {} {} {}\n    {judged})",
            list(factor.terms.iter().map(ray).collect()),
            primes_up_to(factor.terms.len()),
            factor.period,
            factor.zeros.modulus,
            residues_of(&factor.zeros.residues),
        ))
    }
}

/// Residues as a list of Coq.
fn residues_of(residues: &[u32]) -> String {
    list(residues.iter().map(u32::to_string).collect())
}

/// The product of the primes up to a number.
fn primes_up_to(number: usize) -> BigInt {
    let is_prime = |number: &usize| (2..*number).all(|divisor| !usize::is_multiple_of(*number, divisor));
    (2..=number).filter(is_prime).fold(BigInt::one(), |product, prime| product * prime)
}

/// What makes the angles and weights of rays whole.
fn of_rays(rays: &[RayClaim]) -> Grid {
    Grid::of_pairs(rays.iter().flat_map(|ray| [&ray.per_order, &ray.fixed].map(|angle| (angle, &ray.weight))))
}
