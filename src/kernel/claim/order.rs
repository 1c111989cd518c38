//! Is it true, what is said about one order?

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::absolute::{self, Numbers};
use super::answer::{Answer, Condition, Evidence, Status};
use super::classes::{self, SEVERAL};
use super::compare::{self, half_of_lengths};
use super::condition::{self, of_vanishing, plane_of_vanishing, senses};
use super::finding::Finding;
use super::masses;
use super::statement::{Angle, Predicate, Subject, Unit, Value};
use crate::engine::{Engine, LengthUnit};
use crate::exact::PhasorSum;
use crate::numbers;
use crate::proof::{Masses, Quantity, Shape};
use crate::verdict::{self, Balance, OrderBalance, Verdict};

/// The vectors that a claim is about: both, or one and nothing.
struct Vectors<'a> {
    verdicts: Vec<&'a Verdict>,
    shape: Option<Shape>,
    comparison: Option<Evidence>,
}

impl<'a> Vectors<'a> {
    fn new(order: &'a OrderBalance, subject: Subject) -> Self {
        let of = |balance: &'a Balance| match subject.sense {
            Some(sense) => Vectors { verdicts: vec![condition::of(balance, sense)], shape: None, comparison: None },
            None => Vectors {
                verdicts: balance.verdicts().to_vec(),
                shape: Some(balance.shape),
                comparison: balance.comparison.is_some().then(|| {
                    let squares = [&balance.direct, &balance.reverse].map(|verdict| verdict.sum.squared_modulus());
                    Evidence::comparison("The difference of the squared lengths", squares[0].minus(&squares[1]))
                }),
            },
        };
        of(if subject.quantity == Quantity::FORCE { &order.force } else { &order.moment })
    }

    fn vanish(&self) -> bool {
        self.verdicts.iter().all(|verdict| verdict.vanishes())
    }

    fn evidence(&self) -> Vec<Evidence> {
        let verdicts = self.verdicts.iter().map(|verdict| Evidence::Verdict((*verdict).clone()));
        verdicts.chain(self.comparison.clone()).collect()
    }
}

const BARE: &str = "`m r ω²` leaves c_1 to the pin offset: claim the multiple of m r ω² c_1, or newtons";

/// Answers a claim about one order.
pub(super) fn answer(engine: &Engine, subject: Subject, predicate: &Predicate, numbers: Option<&Numbers>) -> Answer {
    if subject.quantity == Quantity::TORQUE {
        return of_torque(engine, subject, predicate);
    }
    let whole = match masses::judged(engine, subject.order, subject.masses) {
        Ok(whole) => whole,
        Err(reason) => return Answer::nothing(reason),
    };
    let Some(order) = masses::one_sum(engine, &whole, subject.masses) else {
        return classes::one(whole, subject, predicate);
    };
    if !order.exists {
        return Answer { status: missing(predicate), finding: Finding::Order(Box::new(order)), evidence: Vec::new() };
    }
    let vectors = Vectors::new(&order, subject);
    let mut evidence = vectors.evidence();
    let mut finding = Finding::Order(Box::new(order.clone()));
    let status = match predicate {
        Predicate::Vanishes(claimed) => vanishing(engine, subject, &order, vectors.vanish(), *claimed),
        Predicate::Is(shape) if vectors.shape == Some(*shape) => Status::True,
        Predicate::Is(_) => Status::False,
        Predicate::Plane(angle) => direction(&vectors, angle, true, &mut evidence),
        // What is said to be 0 is said to vanish, about this plane or about each.
        Predicate::Equals(value, None)
            if vectors.vanish() && value.form.as_rational().is_some_and(|zero| zero.is_zero()) =>
        {
            vanishing(engine, subject, &order, true, true)
        }
        Predicate::Equals(value, angle) => {
            let is_of_pistons = matches!(subject.masses, Masses::Reciprocating | Masses::All);
            let size = match value.unit {
                _ if value.is_bare && is_of_pistons && !engine.is_centric() && !vectors.vanish() => Err(BARE),
                None => Ok(largest(&vectors, subject, value)),
                Some(Unit::Spacing) => in_spacings(engine, value).map(|value| largest(&vectors, subject, &value)),
                Some(Unit::Newton | Unit::NewtonMetre) => absolute::answer(engine, subject, &order, value, numbers)
                    .map(|(status, absolute)| {
                        if !vectors.vanish() {
                            finding = Finding::Absolute(Box::new(order.clone()), absolute);
                        }
                        (status, Vec::new())
                    }),
            };
            match size {
                Ok(size) => directed(&vectors, size, angle.as_ref(), &mut evidence),
                Err(lack) => return Answer::nothing(lack),
            }
        }
    };
    Answer { status, finding, evidence }
}

/// Answers a claim about one order of the inertia torque.
fn of_torque(engine: &Engine, subject: Subject, predicate: &Predicate) -> Answer {
    if classes::has_several(engine) {
        return Answer::nothing(SEVERAL);
    }
    let judged = verdict::torque(engine, &[subject.order]).into_iter().flatten().flat_map(|torque| torque.parts).next();
    let Some(torque) = judged else { return Answer::nothing("no order") };
    let vectors = Vectors { verdicts: vec![&torque.verdict], shape: None, comparison: None };
    let mut evidence = if torque.exists { vectors.evidence() } else { Vec::new() };
    let status = match predicate {
        _ if !torque.exists => missing(predicate),
        Predicate::Vanishes(claimed) => Status::of(vectors.vanish() == *claimed),
        Predicate::Is(_) => Status::False,
        Predicate::Plane(angle) => direction(&vectors, angle, true, &mut evidence),
        Predicate::Equals(value, _) if value.unit.is_some() => {
            return Answer::nothing("the inertia torque is compared in multiples of m r² ω², without a unit");
        }
        Predicate::Equals(value, angle) => {
            directed(&vectors, largest(&vectors, subject, value), angle.as_ref(), &mut evidence)
        }
    };
    Answer { status, finding: Finding::Torque(Box::new(torque.clone())), evidence }
}

/// An order that does not exist is 0, and balanced, whatever its sums are.
fn missing(predicate: &Predicate) -> Status {
    Status::of(match predicate {
        Predicate::Vanishes(claimed) => *claimed,
        Predicate::Is(shape) => *shape == Shape::Balanced,
        Predicate::Plane(_) | Predicate::Equals(_, Some(_)) => false,
        Predicate::Equals(value, None) => {
            let [empty, zero] = [PhasorSum::new(Vec::new()), PhasorSum::new(Vec::new())];
            return compare::length(value, [&empty, &zero], None, 0.0).0;
        }
    })
}

/// Vanishing, with what it depends on.
fn vanishing(engine: &Engine, subject: Subject, order: &OrderBalance, vanishes: bool, claimed: bool) -> Status {
    let senses = senses(subject.sense);
    let plane = || match subject.quantity {
        Quantity::MOMENT => plane_of_vanishing(engine, order, &senses),
        _ => None,
    };
    let conditions = match (vanishes, claimed) {
        (true, true) if subject.quantity == Quantity::MOMENT => of_vanishing(engine, order, &senses),
        (false, true) => plane().map(Condition::AboutPlane).into_iter().collect(),
        (false, false) => plane().map(Condition::NotAboutPlane).into_iter().collect(),
        _ => Vec::new(),
    };
    match (vanishes == claimed, conditions.is_empty()) {
        (true, true) => Status::True,
        (false, true) => Status::False,
        (met, false) => Status::TrueOnlyIf { conditions, met },
    }
}

/// The answer on the largest value, and where it holds that on the direction, if one is claimed.
fn directed(
    vectors: &Vectors,
    (status, more): (Status, Vec<Evidence>),
    angle: Option<&Angle>,
    evidence: &mut Vec<Evidence>,
) -> Status {
    evidence.extend(more);
    let Some(angle) = angle.filter(|_| status.holds()) else { return status };
    let is_line = matches!(vectors.shape, Some(Shape::Planar | Shape::Elliptical));
    match (status, direction(vectors, angle, is_line, evidence)) {
        (Status::True, other) | (other, Status::True) => other,
        // That of the size may depend on more than roundings.
        (depends @ Status::TrueOnlyIf { .. }, other) if other.holds() => depends,
        (_, other) => other,
    }
}

/// A value in spacings, counted in the unit of the positions.
fn in_spacings(engine: &Engine, value: &Value) -> Result<Value, &'static str> {
    let spacing = spacing(engine).ok_or(
        "`a` is the spacing from each cylinder to the next, and those of the layout are not equally far apart: claim the moment in metres, without `a`",
    )?;
    let tolerance = value.tolerance.clone().times(&spacing);
    Ok(Value { form: value.form.scaled(&spacing), tolerance, unit: None, ..*value })
}

/// The spacing a in the unit of the positions: in metres what lies between each position and the next, where that is the same.
fn spacing(engine: &Engine) -> Option<BigRational> {
    match engine.length_unit() {
        LengthUnit::Spacing => Some(BigRational::one()),
        LengthUnit::Metre => {
            let positions: BTreeSet<&BigRational> = engine.cylinders().iter().map(|one| &one.position).collect();
            let next = positions.iter().skip(1);
            let apart: BTreeSet<BigRational> = positions.iter().zip(next).map(|(one, next)| *next - *one).collect();
            apart.first().filter(|_| apart.len() == 1).cloned()
        }
    }
}

/// The largest value, ½(|P⁺| + |P⁻|); half the length of one vector alone; the length of a torque.
fn largest(vectors: &Vectors, subject: Subject, value: &Value) -> (Status, Vec<Evidence>) {
    let empty = PhasorSum::new(Vec::new());
    let sums: [&PhasorSum; 2] = match vectors.verdicts.as_slice() {
        [direct, reverse] => [&direct.sum, &reverse.sum],
        [only] if subject.quantity == Quantity::TORQUE => [&only.sum, &only.sum],
        [only] => [&only.sum, &empty],
        _ => [&empty, &empty],
    };
    let (exact, decimal) = half_of_lengths(sums);
    compare::length(value, sums, exact.as_ref(), decimal)
}

/// The direction of the one vector that is left, or the line that two of them swing along.
fn direction(vectors: &Vectors, angle: &Angle, is_line: bool, evidence: &mut Vec<Evidence>) -> Status {
    let left: Vec<&PhasorSum> = vectors.verdicts.iter().filter(|v| !v.vanishes()).map(|v| &v.sum).collect();
    let (sum, is_line) = match left.as_slice() {
        [] => return Status::False,
        [only] if is_line => (only.times(only), true),
        [only] => ((*only).clone(), false),
        [first, second, ..] => (first.times(second), true),
    };
    let decimal = numbers::evaluate(&sum).arg().to_degrees() / if is_line { 2.0 } else { 1.0 };
    let (status, more) = compare::bearing(angle, &sum, is_line, decimal);
    evidence.extend(more);
    status
}
