//! What is said of the orders of the gas torque? The firing stars, what every order leaves, the proofs, and a JSON document.

mod catalogue;
mod data;
mod document;
mod open;
mod page;
mod study;
mod tables;
mod words;

use std::sync::OnceLock;

use crate::engine::{CycleOrder, Engine};
use crate::firing::{self, FiringPattern, NoPattern, NoStar, StarOrder, Weights};
use crate::report::rising;

pub use catalogue::{firing_catalogue_answer, firing_catalogue_page, run_as};
pub use document::{firing_document, firing_engine};
pub(super) use open::plot_of_stars;
pub use open::{OpenFiringStudy, open_firing_answer, open_firing_page};
pub(super) use page::firing_section;
pub use page::{firing_answer, firing_page};
pub(super) use words::strongest_in_words;

/// Firing stars that are decided, and what they say of every order.
#[derive(Clone, Debug)]
pub struct FiringStudy {
    /// The engine.
    pub engine: Engine,
    /// What the vectors are weighed by.
    pub weights: Weights,
    /// The orders that were asked for, rising, each once.
    pub orders: Vec<StarOrder>,
    pattern: OnceLock<Result<FiringPattern, NoPattern>>,
}

impl FiringStudy {
    /// Judges these orders, the usual ones where there are none.
    ///
    /// # Errors
    /// Where the engine has no firing stars.
    pub fn new(engine: &Engine, orders: &[CycleOrder], weights: Weights) -> Result<Self, NoStar> {
        let cycle = firing::firing_of(engine)?.cycle;
        let orders = rising(match orders {
            [] => firing::usual_orders(engine.firing_pistons().len(), cycle.lowest_order()),
            asked => asked.to_vec(),
        });
        let orders = firing::firing_stars(engine, &orders, &weights)?;
        Ok(FiringStudy { engine: engine.clone(), weights, orders, pattern: OnceLock::new() })
    }

    /// No order judged yet.
    ///
    /// # Errors
    /// Where the engine has no firing stars.
    fn of_engine(engine: &Engine, weights: Weights) -> Result<Self, NoStar> {
        firing::firing_of(engine)?;
        Ok(FiringStudy { engine: engine.clone(), weights, orders: Vec::new(), pattern: OnceLock::new() })
    }

    /// The stars of one period, judged when they are first asked for.
    ///
    /// # Errors
    /// Where there is no pattern, or too long a one.
    pub fn pattern(&self) -> Result<&FiringPattern, &NoPattern> {
        self.pattern.get_or_init(|| firing::pattern(&self.engine, &self.weights)).as_ref()
    }

    /// Whether all cylinders make the same torque from the same pressure.
    fn is_of_one_class(&self) -> bool {
        self.orders.iter().all(|order| order.only().is_some())
    }
}
