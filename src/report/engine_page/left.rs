//! What is left of an order called, and in which vectors is it left?

use super::weighing::Weighed;
use crate::engine::Engine;
use crate::order;
use crate::page::Text;
use crate::proof::{Planar, Shape};
use crate::report::texts::engine as text;
use crate::verdict::{Judgement, OrderVerdict, Outcome};

/// Whether the verdicts are about what the numbers are about.
pub(super) fn is_as_built(engine: &Engine, judged: &Judgement) -> bool {
    judged.not_as_built.is_none() && judged.masses == order::masses_as_built(engine)
}

/// What the force or the moment of an order is called: in a table, and in a sentence on its sizes.
#[derive(Clone, Copy)]
pub(super) struct Name {
    pub label: &'static str,
    pub sentence: fn(Text) -> Text,
}

/// Degrees within which a direction is that of an axis of the engine, as it is printed.
const ALONG: f64 = 1e-6;

impl Name {
    pub fn of(order: &OrderVerdict, quantity: Planar, shape: Shape, weighed: Option<&Weighed>) -> Self {
        let direction = || weighed.and_then(|weighed| weighed.path(order.order, quantity)?.1);
        let is_at = |angle: f64| direction().is_some_and(|direction| (direction.abs() - angle).abs() < ALONG);
        let (label, sentence): (&'static str, fn(Text) -> Text) = match (quantity, shape) {
            (Planar::Force, Shape::Rotating) => ("Rotating force", text::rotating_force),
            (Planar::Force, Shape::CounterRotating) => ("Counter-rotating force", text::counter_rotating_force),
            (Planar::Force, Shape::Planar) if is_at(0.0) => ("Vertical force", text::vertical_force),
            (Planar::Force, Shape::Planar) if is_at(90.0) => ("Horizontal force", text::horizontal_force),
            (Planar::Force, _) => ("Free force", text::free_force),
            _ if !order.moment_is_couple() => ("Moment about the reference plane", text::moment_about_plane),
            (_, Shape::Rotating) => ("Rotating couple", text::rotating_couple),
            (_, Shape::CounterRotating) => ("Counter-rotating couple", text::counter_rotating_couple),
            (_, Shape::Planar) if is_at(0.0) => ("Pitching couple", text::pitching_couple),
            (_, Shape::Planar) if is_at(90.0) => ("Yawing couple", text::yawing_couple),
            _ => ("Pitching and yawing couple", text::pitching_and_yawing_couple),
        };
        Name { label, sentence }
    }
}

/// The numbers of these orders of which something is true.
pub(super) fn numbers<'a>(
    orders: impl IntoIterator<Item = &'a OrderVerdict>,
    is_so: impl Fn(&OrderVerdict) -> bool,
) -> Vec<String> {
    orders.into_iter().filter(|order| is_so(order)).map(|order| order.order.to_string()).collect()
}

/// Whether the direct and the reverse vector of force or moment are left.
pub(super) fn left_vectors(order: &OrderVerdict) -> [bool; 2] {
    let is_left = |outcome: &Outcome| outcome.vanishes() == Some(false);
    [0, 1].map(|sense| is_left(&order.force.outcomes[sense]) || is_left(&order.moment.outcomes[sense]))
}
