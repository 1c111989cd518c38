//! Which theorems over the real numbers follow? The force (moment, torque) of an order is zero at every crank angle, or at some angle it is not.

use super::every_order::{Orders, Pattern};
use super::parts::Parts;
use super::theorem::{Theorem, name};
use crate::proof::{Document, Quantity, Sense, VerdictClaim};

/// What stands before the theorems over the real numbers.
pub(super) const HEAD: &str = "\
(* Over the real numbers of Coq: the force (moment, torque) of an order at the crank angle theta in radians, by definitions that
   formal/real/RealForce.v holds. The pair c is the number c_k of the motion, real and imaginary part; it is any at all where it is a
   variable, and 1 where masses turn with the order. *)
From Coq Require Import Reals.
From Crankstar.real Require Import RealForce Bridge.
Local Open Scope R_scope.
";

/// A theorem for each order of force, moment and torque, and for all orders of a parity of force and moment; the vectors have theirs above.
pub(super) fn theorems(document: &Document, parts: &Parts, every: &[Pattern]) -> Vec<Theorem> {
    let first = |index: usize, verdict: &VerdictClaim| {
        let about = |other: &VerdictClaim| (other.quantity, other.order);
        index == 0 || about(&document.verdicts[index - 1]) != about(verdict)
    };
    let orders = document.verdicts.iter().enumerate().filter(|(index, verdict)| first(*index, verdict));
    let orders = orders.filter_map(|(_, VerdictClaim { quantity, order, .. })| {
        let sums = Sum::all(document, parts, *quantity, *order);
        match sums.as_slice() {
            [sum] => Some(sum.theorem()),
            sums => together(sums),
        }
    });
    orders.chain(every.iter().filter_map(|pattern| of_every_order(every, pattern))).collect()
}

/// What is multiplied by one number of the motion: one vector of the torque, or the direct and the reverse one of force and moment.
struct Sum<'a> {
    quantity: Quantity,
    order: u32,
    motion: Motion,
    engine: String,
    vectors: Vec<(&'a VerdictClaim, String)>,
}

impl<'a> Sum<'a> {
    fn all(document: &'a Document, parts: &Parts, quantity: Quantity, order: u32) -> Vec<Self> {
        let verdicts =
            || document.verdicts.iter().filter(move |verdict| (verdict.quantity, verdict.order) == (quantity, order));
        let vector = |verdict: &'a VerdictClaim| {
            (verdict, format!("({}_{} C real_circle)", name(quantity, verdict.sense), parts.order(verdict)))
        };
        let sum = |first: &'a VerdictClaim| Sum {
            quantity,
            order,
            motion: Motion::of(document, first),
            engine: parts.engine(&first.of),
            vectors: verdicts().filter(|verdict| verdict.of == first.of).map(vector).collect(),
        };
        verdicts().filter(|verdict| verdict.sense != Some(Sense::Reverse)).map(sum).collect()
    }

    fn vanishes(&self) -> bool {
        self.vectors.iter().all(|(verdict, _)| verdict.vanishes)
    }

    /// The function of the crank angle.
    fn function(&self, number: &str) -> String {
        format!("{} {number} {} {}", self.quantity.name(), self.engine, self.order)
    }

    /// That it vanishes, where it does, for the number of that name.
    fn none(&self, number: &str) -> String {
        let (quantity, shared) = (self.quantity.name(), self.shared());
        let vectors: Vec<&str> = self.vectors.iter().map(|(_, vector)| vector.as_str()).collect();
        format!("@no_{quantity} {} {number} {} {shared}{}", self.engine, self.order, vectors.join(" "))
    }

    /// That it does not.
    fn some(&self, number: &str, other: &str) -> String {
        let (quantity, shared) = (self.quantity.name(), self.shared());
        let left = match self.vectors.as_slice() {
            [(verdict, first), (_, second)] => match verdict.vanishes {
                false => format!("(or_introl {first})"),
                true => format!("(or_intror {second})"),
            },
            vectors => vectors.iter().map(|(_, vector)| vector.as_str()).collect(),
        };
        format!("@some_{quantity} {} {number} {} {shared}erefl {other} {left}", self.engine, self.order)
    }

    /// Why the sums of the pistons and of the masses that turn are one.
    fn shared(&self) -> &'static str {
        match (self.quantity, self.motion) {
            (Quantity::Axial(_), _) => "",
            (_, Motion::Any) => "(or_intror erefl) ",
            (_, Motion::One) => "(or_introl erefl) ",
        }
    }

    fn theorem(&self) -> Theorem {
        let zero = zero(self.quantity);
        let (statement, proof) = match (self.vanishes(), self.motion) {
            (true, Motion::Any) => (
                format!("forall (c : R * R) (theta : R), {} theta = {zero}", self.function("c")),
                format!("fun c => {}", self.none("c")),
            ),
            (true, Motion::One) => (format!("forall theta : R, {} theta = {zero}", self.function(ONE)), self.none(ONE)),
            (false, Motion::Any) => (
                format!("forall c : R * R, c <> (0, 0) -> exists theta : R, {} theta <> {zero}", self.function("c")),
                format!("fun c c0 => {}", self.some("c", "c0")),
            ),
            (false, Motion::One) => {
                (format!("exists theta : R, {} theta <> {zero}", self.function(ONE)), self.some(ONE, "one_is_other"))
            }
        };
        Theorem::exact(real_name(self.quantity, self.order), &statement, &proof)
    }
}

/// What is known of the number of the motion.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Motion {
    /// The theorem holds for any; where it says that a force is left, for any but 0.
    Any,
    /// It is 1, in one sum with masses that turn with the order.
    One,
}

const ONE: &str = "(1, 0)";

impl Motion {
    fn of(document: &Document, verdict: &VerdictClaim) -> Self {
        let in_part = |name: &String| verdict.of.is_empty() || verdict.of.contains(name);
        let turns = document.turning_masses.iter().any(|mass| mass.order == verdict.order && in_part(&mass.name));
        match verdict.quantity {
            Quantity::FORCE | Quantity::MOMENT if turns => Motion::One,
            Quantity::FORCE | Quantity::MOMENT | Quantity::Axial(_) => Motion::Any,
        }
    }
}

/// That several sums vanish together, whatever their numbers are, where each of them does.
fn together(sums: &[Sum]) -> Option<Theorem> {
    let first = sums.first().filter(|_| sums.iter().all(Sum::vanishes))?;
    let number = |(index, sum): (usize, &Sum)| match sum.motion {
        Motion::Any => format!("c_{}", index + 1),
        Motion::One => ONE.to_owned(),
    };
    let numbers: Vec<String> = sums.iter().enumerate().map(number).collect();
    let variables: Vec<&str> = numbers.iter().map(String::as_str).filter(|number| *number != ONE).collect();
    let variables = variables.join(" ");
    let (together, part) = match first.quantity {
        Quantity::Axial(_) => ("torques_together", "torque_part"),
        Quantity::FORCE | Quantity::MOMENT => ("together", "part"),
    };
    let each = || sums.iter().zip(&numbers);
    let functions: Vec<String> = each().map(|(sum, number)| sum.function(number)).collect();
    let none = each()
        .rev()
        .fold(format!("@no_{part}s"), |rest, (sum, number)| format!("and_{part} ({}) ({rest})", sum.none(number)));
    let statement = format!(
        "forall {}(theta : R), {together} [:: {}] theta = {}",
        if variables.is_empty() { String::new() } else { format!("({variables} : R * R) ") },
        functions.join("; "),
        zero(first.quantity)
    );
    let proof = if variables.is_empty() { none } else { format!("fun {variables} => {none}") };
    Some(Theorem::exact(real_name(first.quantity, first.order), &statement, &proof))
}

fn real_name(quantity: Quantity, order: u32) -> String {
    format!("real_{}_order_{order}", quantity.name())
}

fn zero(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::FORCE | Quantity::MOMENT => "(0, 0)",
        Quantity::Axial(_) => "0",
    }
}

/// All these orders at once; of two vectors the statement on the direct one calls it.
fn of_every_order(every: &[Pattern], pattern: &Pattern) -> Option<Theorem> {
    let about = |pattern: &Pattern| (pattern.quantity, pattern.ends());
    let reverse = |other: &&Pattern| other.sense == Some(Sense::Reverse) && about(other) == about(pattern);
    let both = match pattern.sense {
        None => vec![pattern],
        Some(Sense::Direct) => vec![pattern, every.iter().find(reverse)?],
        Some(Sense::Reverse) => return None,
    };
    let (what, engine) = (pattern.quantity.name(), &pattern.engine);
    let (premises, names, from) = match pattern.orders {
        Orders::Even => (pattern.orders.premises(), "from second", "erefl from"),
        Orders::Odd => (pattern.orders.premises(), "from second", "erefl (above_one from)"),
        Orders::All => (pattern.orders.premises(), "from", "from"),
    };
    let premises: String = premises.iter().map(|premise| format!("({premise})%Z -> ")).collect();
    let left: Vec<String> = both.iter().map(|pattern| pattern.left("%Z")).collect();
    let by: Vec<String> = both.iter().map(|pattern| format!("({} C real_circle k {names})", pattern.name())).collect();
    Some(Theorem::exact(
        format!("real_{what}_{}", pattern.ends()),
        &format!(
            "forall (k : Z) (c : R * R), {premises}c <> (0, 0) ->\n  \
             (exists theta : R, {what} c {engine} k theta <> {}) <->\n  {}",
            zero(pattern.quantity),
            left.join(" \\/ ")
        ),
        &format!(
            "fun k c {names} c0 => @every_{what} {engine} c k {} {from} c0\n  {}",
            vec!["_"; both.len()].join(" "),
            by.join(" ")
        ),
    ))
}
