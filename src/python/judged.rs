//! What does an engine of Python say of itself: its verdicts, its report?

use pyo3::prelude::*;

use super::engine::Engine;
use super::error::told;
use crate::family;
use crate::loads;
use crate::order::Masses;
use crate::page::Document;
use crate::report::{self, Contents};
use crate::verdict::{self, Judgement};

impl Engine {
    /// The verdicts on these masses, or on all that the layout has.
    pub(super) fn judged(&self, orders: &[u32], masses: Option<Masses>, torque: bool) -> PyResult<Judgement> {
        if torque {
            loads::Missing::unless_torque_is_judged(&self.engine, "verdicts on the inertia torque").map_err(told)?;
        }
        let quantities = verdict::quantities(&self.engine, torque);
        match masses {
            None => Judgement::new(&self.engine, orders, &quantities).map_err(told),
            Some(masses) => Judgement::of(&self.engine, orders, masses, &quantities).map_err(told),
        }
    }

    /// The report as a document of blocks.
    pub(super) fn page(&self, orders: &[u32], in_motion: bool) -> PyResult<Document> {
        let judged = self.judged(orders, None, false)?;
        let family = self.family.as_ref().filter(|family| family::comparable(family).is_ok());
        let open = family.map(|family| family::classify(family, orders).map(|judged| (family, judged)));
        let open = open.transpose().map_err(told)?;
        let family = open.as_ref().map(|(family, orders)| (*family, orders.as_slice()));
        let (engine, judged) = (&self.engine, &judged);
        Ok(report::engine_page(Contents {
            engine,
            judged,
            family,
            needed: None,
            in_motion,
            accuracy: None,
            weighing: report::Weighing::usual(),
        }))
    }

    /// The engine with its first star and the short answer.
    pub(super) fn glance(&self) -> PyResult<Document> {
        let judged = self.judged(&self.orders(None), None, false)?;
        Ok(report::engine_at_a_glance(&self.engine, &judged))
    }
}
