//! Is it true, what is said about an engine? Each claim of a file is answered with its evidence.
//!
//! `words → statement → answer`: the words of an answer are put down by the room of reports.
//!
#![doc = include_str!("README.md")]

mod absolute;
mod answer;
mod classes;
mod compare;
mod condition;
mod error;
mod every;
mod everyday;
mod file;
mod find;
mod finding;
mod firing;
mod forces;
mod formula;
mod free;
mod gas_torque;
mod grammar;
mod handwritten;
mod masses;
mod moving_parts;
mod multiples;
mod order;
mod ordinal;
mod parts;
mod possible;
mod provenance;
mod real;
mod sentence;
mod shafts;
mod shaking;
mod star_marks;
mod statement;
pub(crate) mod student;
mod symbols;
mod written_value;

use crate::engine::Engine;
use crate::order::{Masses, masses_as_built};
use crate::proof::Quantity;

pub use absolute::Numbers;
pub use answer::{Answer, Condition, Evidence, Status};
pub use error::ClaimError;
pub use file::{Claim, Claims, Published, parse_claims, readable_claims};
pub use find::Find;
pub use finding::{Absolute, Agreement, Finding, LargestOf, Term, TermVerdict, Witness};
pub use formula::{Factor, Formula, Letter, Measured, Powers, Series, Wave};
pub use handwritten::{Agrees, WrittenAngle, WrittenLength, with_point};
pub use provenance::{Provenance, Quote};
pub use sentence::parse_statement;
pub use star_marks::{Filled, Judged, LEAST_DIGITS, Marked, Place, RightEntry, SUMS, Star, mark};
pub use statement::{
    Angle, Balanced, Bearing, GasTorque, Loaded, OfCylinder, Orders, Possible, Predicate, Shafts, ShakingForce,
    Statement, Subject, Tolerance, Topic, Unit, Value,
};
pub use student::{StarTable, Verdict as TableVerdict};

/// How a claim that names no masses is answered of all of them; none where it names some or is about no order of a force or moment, and
/// where the engine has none beside its pistons.
pub fn status_of_all_masses(engine: &Engine, statement: &Statement, numbers: Option<&Numbers>) -> Option<Status> {
    let Statement::Order { subject, predicate } = statement else { return None };
    let has_others = masses_as_built(engine) != Masses::Reciprocating;
    if subject.masses != Masses::Reciprocating || subject.quantity == Quantity::TORQUE || !has_others {
        return None;
    }
    let subject = Subject { masses: Masses::All, ..*subject };
    Some(order::answer(engine, subject, predicate, numbers).status)
}

/// Answers a claim about an engine.
pub fn answer(engine: &Engine, statement: &Statement, numbers: Option<&Numbers>) -> Answer {
    let several = classes::has_several(engine);
    match statement {
        Statement::NoFreeMoment if several => classes::free(engine),
        Statement::NoFreeMoment => free::answer(engine),
        Statement::Order { subject, predicate } => order::answer(engine, *subject, predicate, numbers),
        Statement::Vanish { orders, quantities } if several => classes::many(engine, orders, quantities),
        Statement::Vanish { orders, quantities } => every::answer(engine, orders, quantities),
        Statement::Shafts { order, shafts } => shafts::answer(engine, *order, *shafts),
        Statement::CanBalance(possible) => possible::answer(engine, possible),
        Statement::CrankshaftMass(mass) => masses::crankshaft(engine, mass),
        Statement::BearingLoad(value) => masses::bearing_load(engine, value),
        Statement::WorstBearings(numbers) => masses::worst_bearings(engine, numbers),
        Statement::LargestLoad(of, value) => forces::largest(engine, *of, value),
        Statement::ShakingForce(says) => shaking::answer(engine, says, numbers),
        Statement::Formula(says) => forces::formula(engine, says),
        Statement::GasTorque { orders, says, weights } => gas_torque::answer(engine, orders, *says, weights),
        Statement::FiresEvenly { evenly } => firing::answer(engine, *evenly),
    }
}

impl Claim {
    /// Answers the claim.
    pub fn answer(&self) -> Answer {
        answer(&self.layout, &self.statement, self.numbers.as_ref())
    }
}
