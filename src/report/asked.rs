//! Which questions can any engine be asked by name, and how?

#[cfg(feature = "optimise")]
use super::OptimiseStudy;
use super::question::{Question, Unanswered};
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
use crate::remedy::{self, Request};

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
        let request = optimise::Request { couple: Couple::Zero, points: USUAL_POINTS, orders };
        Ok(Box::new(OptimiseStudy::new(engine, request, FileResolver::nothing())?))
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
