//! What has every question that is asked of an engine? Tables of typed columns, and two documents: a short answer and a page.
//!
//! The command line, Python, sweeps and comparisons ask it in one way each. A question is a study that owns its engine, and each part of
//! its answer is made when it is wanted.

use std::error::Error;

use serde::Serialize;

#[cfg(feature = "optimise")]
use super::OptimiseStudy;
use super::{
    AccuracyStudy, AngleStudy, AnglesAsked, BearingsStudy, FiringStudy, LoadsStudy, MomentsStudy, MountsAsked,
    MountsStudy, TorqueStudy, TorsionStudy,
};
use crate::accuracy::Timing;
use crate::engine::{CycleOrder, Engine};
#[cfg(feature = "optimise")]
use crate::file::FileResolver;
use crate::firing::Weights;
use crate::loads::{usual_bearing_orders, usual_orders};
#[cfg(feature = "optimise")]
use crate::optimise::{self, Couple};
use crate::page::{Document, File};
use crate::remedy::{self, Request};
use crate::table::{Named, Table};
use crate::text::Untrusted;

/// A question that was asked, and what answers it.
pub trait Question: Send + Sync {
    /// The command that asks it.
    fn command(&self) -> &'static str;

    /// The engine whose answer it is, by its title; none where there is no single one.
    fn title(&self) -> Option<&Untrusted>;

    /// The table of this name, one of [`super::data::TABLES`]; none where this answer has none.
    fn table(&self, name: &str) -> Option<Table>;

    /// What the terminal shows.
    fn answer(&self) -> Document;

    /// The page.
    fn page(&self) -> Document;

    /// What is beside the page: layout files, data.
    ///
    /// # Errors
    /// What cannot be written as JSON.
    fn beside(&self) -> serde_json::Result<Vec<File>> {
        Ok(Vec::new())
    }

    /// All tables, the main one first.
    fn tables(&self) -> Vec<Table> {
        super::data::tables_of(self.command()).iter().filter_map(|name| self.table(name)).collect()
    }

    /// The document of `--json`: the title and all tables, but for a question whose document has certificates.
    ///
    /// # Errors
    /// What cannot be written as JSON.
    fn json(&self) -> serde_json::Result<String> {
        let (format, tables) = (format!("crankstar {} 2", self.command()), self.tables());
        serde_json::to_string_pretty(&Answer {
            format,
            title: self.title().map(Untrusted::written),
            tables: Named(&tables),
        })
    }

    /// Whether its document has certificates, which are checked before it is given away.
    fn is_certified(&self) -> bool {
        false
    }

    /// The document without its evidence, where it says more than that proves: for evidence that is too large to be checked.
    fn json_without_evidence(&self) -> Option<serde_json::Result<String>> {
        None
    }
}

/// The question of a study whose tables are made by `data::table` of its room, the two documents by `page::answer` and `page::page`.
macro_rules! question_of_its_room {
    ($study:ty, $command:literal, $title:expr) => {
        impl $crate::report::Question for $study {
            fn command(&self) -> &'static str {
                $command
            }

            fn title(&self) -> Option<&$crate::text::Untrusted> {
                let title: fn(&Self) -> Option<&$crate::text::Untrusted> = $title;
                title(self)
            }

            fn table(&self, name: &str) -> Option<$crate::table::Table> {
                data::table(self, name)
            }

            fn answer(&self) -> $crate::page::Document {
                page::answer(self)
            }

            fn page(&self) -> $crate::page::Document {
                page::page(self)
            }
        }
    };
}
pub(super) use question_of_its_room;

#[derive(Serialize)]
struct Answer<'a> {
    format: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    #[serde(flatten)]
    tables: Named<'a>,
}

/// Why a question has no answer, in its own words.
pub type Unanswered = Box<dyn Error + Send + Sync>;

/// Points of a front where no number is asked for.
#[cfg(feature = "optimise")]
const USUAL_POINTS: usize = 9;

type Ask = fn(&Engine, &[CycleOrder]) -> Result<Box<dyn Question>, Unanswered>;

/// The questions that any engine can be asked, with how.
const ASKED: &[(&str, Ask)] = &[
    ("loads", |engine, orders| {
        let orders = whole_or(orders, || usual_orders(engine));
        Ok(Box::new(LoadsStudy::new(engine, &orders, None)?))
    }),
    ("bearings", |engine, orders| {
        let orders = whole_or(orders, || usual_bearing_orders(engine));
        Ok(Box::new(BearingsStudy::new(engine, &orders)?))
    }),
    ("firing", |engine, orders| Ok(Box::new(FiringStudy::new(engine, orders, Weights::Rigid)?))),
    ("torque", |engine, _| Ok(Box::new(TorqueStudy::new(engine)?))),
    ("angle", |engine, _| Ok(Box::new(AngleStudy::new(engine, &AnglesAsked::default())?))),
    ("moments", |engine, _| Ok(Box::new(MomentsStudy::new(&[(engine.title().clone(), engine.clone())])?))),
    ("torsion", |engine, orders| Ok(Box::new(TorsionStudy::new(engine, orders)?))),
    ("mounts", |engine, orders| {
        let asked = MountsAsked { orders: orders.to_vec(), ..MountsAsked::default() };
        Ok(Box::new(MountsStudy::new(engine, &asked)?))
    }),
    ("accuracy", |engine, _| Ok(Box::new(AccuracyStudy::new(engine, &[], Timing::Off, &|_| ())?))),
    ("remedy", |engine, orders| {
        let orders = whole_or(orders, || usual_orders(engine));
        Ok(Box::new(remedy::remedy(engine, &Request { orders, ..Request::default() })?))
    }),
    #[cfg(feature = "optimise")]
    ("optimise", |engine, orders| {
        let orders = whole_or(orders, || usual_bearing_orders(engine));
        let wish = optimise::Request { couple: Couple::Zero, points: USUAL_POINTS, orders };
        Ok(Box::new(OptimiseStudy::new(engine, wish, FileResolver::nothing())?))
    }),
];

/// The names of the questions that [`ask`] knows.
pub fn questions() -> impl Iterator<Item = &'static str> {
    ASKED.iter().map(|(name, _)| *name)
}

/// Asks an engine a question by its name, at these orders; at the usual ones where there are none. None where no question is called so.
pub fn ask(question: &str, engine: &Engine, orders: &[CycleOrder]) -> Option<Result<Box<dyn Question>, Unanswered>> {
    ASKED.iter().find(|(name, _)| *name == question).map(|(_, ask)| ask(engine, orders))
}

/// The whole ones of these orders; the usual ones where none is asked for.
fn whole_or(orders: &[CycleOrder], usual: impl Fn() -> Vec<u32>) -> Vec<u32> {
    match orders {
        [] => usual(),
        asked => asked.iter().filter(|order| order.is_whole()).map(|order| order.halves() / 2).collect(),
    }
}
