//! What is left of an order called, and in which vectors is it left?

use super::weighing::Weighed;
use crate::engine::Engine;
use crate::order;
use crate::proof::{Planar, Shape};
use crate::verdict::{Judgement, OrderVerdict, Outcome};

/// Whether the verdicts are about what the numbers are about.
pub(super) fn is_as_built(engine: &Engine, judged: &Judgement) -> bool {
    judged.not_as_built.is_none() && judged.masses == order::masses_as_built(engine)
}

/// What the force or the moment of an order is called.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Name {
    Vertical,
    Horizontal,
    RotatingForce,
    CounterRotatingForce,
    Force,
    Pitching,
    Yawing,
    RotatingCouple,
    CounterRotatingCouple,
    Couple,
    Moment,
}

/// Degrees within which a direction is that of an axis of the engine, as it is printed.
const ALONG: f64 = 1e-6;

impl Name {
    pub fn of(order: &OrderVerdict, quantity: Planar, shape: Shape, weighed: Option<&Weighed>) -> Self {
        let direction = || weighed.and_then(|weighed| weighed.path(order.order, quantity)?.1);
        let is_at = |angle: f64| direction().is_some_and(|direction| (direction.abs() - angle).abs() < ALONG);
        match (quantity, shape) {
            (Planar::Force, Shape::Rotating) => Name::RotatingForce,
            (Planar::Force, Shape::CounterRotating) => Name::CounterRotatingForce,
            (Planar::Force, Shape::Planar) if is_at(0.0) => Name::Vertical,
            (Planar::Force, Shape::Planar) if is_at(90.0) => Name::Horizontal,
            (Planar::Force, _) => Name::Force,
            _ if !order.moment_is_couple() => Name::Moment,
            (_, Shape::Rotating) => Name::RotatingCouple,
            (_, Shape::CounterRotating) => Name::CounterRotatingCouple,
            (_, Shape::Planar) if is_at(0.0) => Name::Pitching,
            (_, Shape::Planar) if is_at(90.0) => Name::Yawing,
            _ => Name::Couple,
        }
    }

    /// In a table.
    pub fn label(self) -> &'static str {
        match self {
            Name::Vertical => "Vertical force",
            Name::Horizontal => "Horizontal force",
            Name::RotatingForce => "Rotating force",
            Name::CounterRotatingForce => "Counter-rotating force",
            Name::Force => "Free force",
            Name::Pitching => "Pitching couple",
            Name::Yawing => "Yawing couple",
            Name::RotatingCouple => "Rotating couple",
            Name::CounterRotatingCouple => "Counter-rotating couple",
            Name::Couple => "Pitching and yawing couple",
            Name::Moment => "Moment about the reference plane",
        }
    }

    pub fn sentence(self) -> &'static str {
        match self {
            Name::Vertical => "Vertical force: {}.",
            Name::Horizontal => "Horizontal force: {}.",
            Name::RotatingForce => "Rotating force: {}.",
            Name::CounterRotatingForce => "Counter-rotating force: {}.",
            Name::Force => "Free force: {}.",
            Name::Pitching => "Pitching couple: {}.",
            Name::Yawing => "Yawing couple: {}.",
            Name::RotatingCouple => "Rotating couple: {}.",
            Name::CounterRotatingCouple => "Counter-rotating couple: {}.",
            Name::Couple => "Pitching and yawing couple: {}.",
            Name::Moment => "Moment about the reference plane: {}.",
        }
    }
}

/// Whether the direct and the reverse vector of force or moment are left.
pub(super) fn left_vectors(order: &OrderVerdict) -> [bool; 2] {
    let is_left = |outcome: &Outcome| outcome.vanishes() == Some(false);
    [0, 1].map(|sense| is_left(&order.force.outcomes[sense]) || is_left(&order.moment.outcomes[sense]))
}
