//! Is it true of orders that are several sums: of several kinds of rods, of crankshafts of several speeds, of masses beside offset rods?

use super::answer::{Answer, Evidence, Status};
use super::compare::is_exact_zero;
use super::finding::Finding;
use super::masses;
use super::shafts::evidence;
use super::statement::{Orders, Predicate, Subject};
use crate::engine::{Engine, ORDERS};
use crate::loads;
use crate::order::Masses;
use crate::proof::{Planar, Quantity, Sense, Shape};
use crate::verdict::{OrderVerdict, Outcome, WholeOrder, both_vanish};

/// Of a size, a direction or a torque nothing is said then.
pub(super) const SEVERAL: &str =
    "this order is several sums, each with a coefficient of its own, so that it is not compared";

/// Of many orders of it nothing is said.
pub(super) const TORQUE: &str = "the inertia torque is decided order by order: claim one order of it at a time";

/// Whether the rods, their offsets or the speeds of the crankshafts differ.
pub(super) fn has_several(engine: &Engine) -> bool {
    engine.mechanisms().len() > 1 || engine.faster_crank().is_some()
}

fn judged(engine: &Engine, order: u32) -> Option<OrderVerdict> {
    masses::judged(engine, order, Masses::Reciprocating).ok()
}

/// Answers of several sums whether the order vanishes and which shape is left; sizes and directions are not compared.
pub(super) fn one(order: OrderVerdict, subject: Subject, predicate: &Predicate) -> Answer {
    let Quantity::Planar(quantity) = subject.quantity else { return Answer::nothing(SEVERAL) };
    let whole = order.whole(quantity);
    let vanishes = vanish(whole, subject.sense);
    let holds = match (predicate, subject.sense) {
        (Predicate::Vanishes(claimed), _) => vanishes.map(|vanishes| vanishes == *claimed),
        (Predicate::Is(shape), None) => match whole.shape {
            Shape::NotDecided => None,
            found => Some(found == *shape),
        },
        (Predicate::Equals(value, None), _) if is_exact_zero(value) => vanishes,
        (Predicate::Is(_) | Predicate::Equals(..) | Predicate::Plane(_), _) => return Answer::nothing(SEVERAL),
    };
    Answer { status: status(holds), evidence: evidence(&order), finding: Finding::CombinedOrders(vec![order]) }
}

/// Force and moment among these, where they are all that is asked for.
pub(super) fn planar(quantities: &[Quantity]) -> Option<Vec<Planar>> {
    quantities.iter().map(|quantity| quantity.planar()).collect()
}

/// Answers whether orders vanish.
pub(super) fn many(engine: &Engine, orders: &Orders, quantities: &[Quantity]) -> Answer {
    let Some(quantities) = planar(quantities) else { return Answer::nothing(TORQUE) };
    match orders {
        Orders::From(first) => every(engine, *first, &quantities),
        Orders::Listed(orders) => listed(engine, orders, &quantities),
    }
}

/// Answers whether all orders vanish from this one on. They do where the first order of each crank does, and the sums of the pistons that
/// move alike; of n such sums that do not vanish 2n orders of one crank are left, unless those of another cancel them.
pub(super) fn every(engine: &Engine, first: u32, quantities: &[Planar]) -> Answer {
    let firsts = loads::speeds(engine).filter(|order| *order >= first);
    let firsts: Vec<OrderVerdict> = firsts.filter_map(|order| judged(engine, order)).collect();
    let sums = quantities.iter().flat_map(|one| loads::sums_of_alike(engine, (*one).into()));
    let mut proofs: Vec<Evidence> = sums.map(|sum| Evidence::comparison("The pistons that move alike", sum)).collect();
    let is_zero = |order: &OrderVerdict| quantities.iter().all(|one| order.whole(*one).is_balanced());
    if firsts.iter().all(is_zero) && proofs.iter().all(Evidence::vanishes) {
        proofs.extend(firsts.iter().flat_map(evidence));
        return Answer { status: Status::True, finding: Finding::NothingLeft, evidence: proofs };
    }
    let is_left = |order: &OrderVerdict| quantities.iter().any(|one| order.whole(*one).is_left());
    refuted(engine, first, is_left, "whether the sums of different rods cancel at every order is not decided")
}

/// Answers whether a moment is left that no choice of the reference plane cancels.
pub(super) fn free(engine: &Engine) -> Answer {
    if engine.cylinders().windows(2).all(|pair| pair[0].position == pair[1].position) {
        return Answer { status: Status::True, finding: Finding::OnePlane, evidence: Vec::new() };
    }
    let about_the_plane = every(engine, 1, &[Planar::Moment]);
    if about_the_plane.status.holds() {
        return about_the_plane;
    }
    let is_free = |order: &OrderVerdict| order.moment.is_left() && order.moment_is_couple();
    refuted(engine, 1, is_free, "whether it is one force in one plane is not decided where rods differ")
}

/// That a claim on every order is false, by the first order that is so.
fn refuted(engine: &Engine, first: u32, is_so: impl Fn(&OrderVerdict) -> bool, open: &'static str) -> Answer {
    let fastest = loads::speeds(engine).max().unwrap_or(1) as usize;
    let last = 2 * fastest * (engine.cylinders().len() + 1);
    let orders = ORDERS.take(last).skip_while(|order| *order < first);
    match orders.filter_map(|order| judged(engine, order)).find(is_so) {
        None => Answer::nothing(open),
        Some(order) => {
            Answer { status: Status::False, evidence: evidence(&order), finding: Finding::CombinedOrders(vec![order]) }
        }
    }
}

fn listed(engine: &Engine, orders: &[u32], quantities: &[Planar]) -> Answer {
    let orders: Vec<OrderVerdict> = orders.iter().filter_map(|order| judged(engine, *order)).collect();
    let asked = orders.iter().filter(|order| order.exists());
    let outcomes = asked.flat_map(|order| quantities.iter().map(|quantity| vanish(order.whole(*quantity), None)));
    let holds = outcomes.fold(Some(true), both_vanish);
    let evidence = orders.iter().flat_map(evidence).collect();
    Answer { status: status(holds), finding: Finding::CombinedOrders(orders), evidence }
}

fn vanish(whole: &WholeOrder, sense: Option<Sense>) -> Option<bool> {
    let [direct, reverse] = whole.outcomes.each_ref().map(Outcome::vanishes);
    match sense {
        Some(Sense::Direct) => direct,
        Some(Sense::Reverse) => reverse,
        None => both_vanish(direct, reverse),
    }
}

fn status(holds: Option<bool>) -> Status {
    holds.map_or(Status::NotDecided, Status::of)
}
