//! Which verdicts does a reader want of an engine: as it is built, and of its pistons alone?

use super::{OrderVerdict, classify};
use crate::engine::Engine;
use crate::order::{self, Masses, NotComparable, Source};
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

impl Judgement {
    /// Judges an engine at these orders: as it is built, where the file says enough of its masses.
    pub fn new(engine: &Engine, orders: &[u32], quantities: &[Quantity]) -> Self {
        let (masses, not_as_built) = match order::comparable(engine) {
            Ok(()) if order::groups_of(engine).len() > 1 => (Masses::All, None),
            Ok(()) => (Masses::Reciprocating, None),
            Err(why) => (Masses::Reciprocating, Some(why)),
        };
        let judge = |masses| classify(engine, orders, masses, quantities);
        Judgement {
            masses,
            orders: judge(masses),
            pistons: (masses == Masses::All).then(|| judge(Masses::Reciprocating)),
            not_as_built,
        }
    }

    /// Judges these masses of an engine.
    ///
    /// # Errors
    /// What the engine lacks for its masses to be in one sum.
    pub fn of(engine: &Engine, orders: &[u32], masses: Masses, quantities: &[Quantity]) -> Result<Self, NotComparable> {
        if masses != Masses::Reciprocating {
            order::comparable(engine)?;
        }
        let orders = classify(engine, orders, masses, quantities);
        Ok(Judgement { masses, orders, pistons: None, not_as_built: None })
    }

    /// The orders of the pistons alone in which a mass that turns has a part in the engine as it is built.
    pub fn differing(&self) -> impl Iterator<Item = &OrderVerdict> {
        let has_turning = |order: u32| {
            let parts = self.orders.iter().filter(|verdict| verdict.order == order).flat_map(|verdict| &verdict.parts);
            let verdicts = parts.flat_map(|part| part.force.verdicts());
            verdicts.flat_map(|verdict| &verdict.sources).any(|source| !matches!(source, Source::Piston(_)))
        };
        self.pistons.iter().flatten().filter(move |verdict| has_turning(verdict.order))
    }
}
