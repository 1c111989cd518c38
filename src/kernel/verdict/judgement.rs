//! Which verdicts does a reader want of an engine: as it is built, and of its pistons alone?

use super::{OrderVerdict, classify};
use crate::engine::{Engine, NotAnOrder};
use crate::order::{self, Masses, NotComparable};
use crate::proof::Quantity;

/// The verdicts on an engine.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Whose masses they are about.
    pub masses: Masses,
    /// The verdicts, one per order.
    pub orders: Vec<OrderVerdict>,
    /// Those on the pistons alone, where the engine as it is built has masses that turn.
    pub pistons: Option<Vec<OrderVerdict>>,
    /// Why the engine is not judged as it is built, although it has masses that turn.
    pub not_as_built: Option<NotComparable>,
}

/// What is decided of an engine: force and moment, the torque where it is asked for; where crankshafts are geared together, the torque
/// and the roll moment in any case; no roll moment where it hangs on a length that is not there ([`order::roll_lacks`]).
pub fn quantities(engine: &Engine, with_torque: bool) -> Vec<Quantity> {
    let is_geared = !engine.geared_cranks().is_empty();
    let torque = (with_torque || is_geared).then_some(Quantity::TORQUE);
    let roll = (is_geared && order::roll_lacks(engine).is_none()).then_some(Quantity::ROLL);
    [Quantity::FORCE, Quantity::MOMENT].into_iter().chain(torque).chain(roll).collect()
}

/// Why an engine is not judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotJudged {
    /// A number that is no order.
    #[error("{0}")]
    Order(NotAnOrder),
    /// Masses that are not in one unit.
    #[error("{0}")]
    Masses(NotComparable),
}

impl Judgement {
    /// Judges an engine at these orders: as it is built, where the file says enough of its masses.
    ///
    /// # Errors
    /// A number that is no order.
    pub fn new(engine: &Engine, orders: &[u32], quantities: &[Quantity]) -> Result<Self, NotAnOrder> {
        let (masses, not_as_built) = match order::comparable(engine) {
            Ok(()) => (order::masses_as_built(engine), None),
            Err(why) => (Masses::Reciprocating, Some(why)),
        };
        let judge = |masses| classify(engine, orders, masses, quantities);
        Ok(Judgement {
            masses,
            orders: judge(masses)?,
            pistons: (masses == Masses::All).then(|| judge(Masses::Reciprocating)).transpose()?,
            not_as_built,
        })
    }

    /// Judges these masses of an engine.
    ///
    /// # Errors
    /// A number that is no order, and what the engine lacks for its masses to be in one sum.
    pub fn of(engine: &Engine, orders: &[u32], masses: Masses, quantities: &[Quantity]) -> Result<Self, NotJudged> {
        if masses != Masses::Reciprocating {
            order::comparable(engine).map_err(NotJudged::Masses)?;
        }
        let orders = classify(engine, orders, masses, quantities).map_err(NotJudged::Order)?;
        Ok(Judgement { masses, orders, pistons: None, not_as_built: None })
    }

    /// The orders of the pistons alone in which a mass that turns has a part in the engine as it is built.
    pub fn differing(&self) -> impl Iterator<Item = &OrderVerdict> {
        let has_turning = |order: u32| {
            let parts = self.orders.iter().filter(|verdict| verdict.order == order).flat_map(|verdict| &verdict.parts);
            let verdicts = parts.flat_map(|part| part.force.verdicts());
            verdicts.flat_map(|verdict| &verdict.sources).any(|source| source.piston().is_none())
        };
        self.pistons.iter().flatten().filter(move |verdict| has_turning(verdict.order))
    }
}
