//! `firing`: which orders of the gas torque vanish, whatever the pressure is?

use num_traits::ToPrimitive;
use pyo3::prelude::*;

use crate::engine::{CycleOrder, Engine};
use crate::firing::{FiringStar, StarOrder, Weights};
use crate::page::Document;
use crate::python::answer::Question;
use crate::python::documents;
use crate::python::error::told;
use crate::report::{self, FiringStudy};
use crate::table::{Column, Table, Unit, Values};

struct Fired {
    orders: Table,
    json: String,
    answer: Document,
    page: Document,
}

/// Judges the firing stars of these orders, weighed by a mode shape where one is given.
pub(in crate::python) fn firing(
    engine: &Engine,
    orders: &[CycleOrder],
    weights: Weights,
) -> PyResult<impl Question + use<>> {
    let study = FiringStudy::new(engine, orders, weights).map_err(told)?;
    Ok(Fired {
        orders: table(&study),
        json: documents::json(&report::firing_document(&study, false))?,
        answer: report::firing_answer(&study),
        page: report::firing_page(&study),
    })
}

impl Question for Fired {
    fn tables(&self) -> Vec<Table> {
        vec![self.orders.clone()]
    }

    fn json(&self) -> PyResult<String> {
        Ok(self.json.clone())
    }

    fn answer(&self) -> Document {
        self.answer.clone()
    }

    fn page(&self) -> Document {
        self.page.clone()
    }
}

/// A row a star: an order has one, or one for each class of equal cylinders.
fn table(study: &FiringStudy<'_>) -> Table {
    let of_order = |order| move |star| (order, star);
    let stars = study.orders.iter().flat_map(|order| order.stars.iter().map(of_order(order)));
    let rows: Vec<(&StarOrder, &FiringStar)> = stars.collect();
    let cylinders = |star: &FiringStar| {
        let names: Vec<String> = star.sources.iter().map(|source| source.name(study.engine)).collect();
        Some(names.join(" "))
    };
    let lengths: Vec<_> = rows.iter().map(|(_, star)| report::star_length(*star)).collect();
    let columns = [
        Column::new(
            "order",
            Unit::NONE,
            "the order κ of the crank speed",
            Values::Decimal(rows.iter().map(|(order, _)| order.order.exact().to_f64()).collect()),
        ),
        Column::new(
            "of",
            Unit::NONE,
            "the cylinders whose vectors it adds, with a space between",
            Values::Words(rows.iter().map(|(_, star)| cylinders(star)).collect()),
        ),
        Column::new(
            "vanishes",
            Unit::NONE,
            "whether it is proved to be 0, whatever the pressure is; else it is proved not to be",
            Values::Truth(rows.iter().map(|(_, star)| Some(star.vanishes())).collect()),
        ),
        Column::new(
            "length_{unit}",
            Unit::CRANK_RADIUS,
            "its length",
            Values::Decimal(lengths.iter().map(|length| Some(length.decimal)).collect()),
        ),
        Column::new(
            "length_exact",
            Unit::NONE,
            "the same in closed form",
            Values::Exact(lengths.iter().map(|length| length.exact.as_ref().map(ToString::to_string)).collect()),
        ),
        Column::new(
            "major",
            Unit::NONE,
            "whether all vectors of the order stand in one direction",
            Values::Truth(rows.iter().map(|(order, _)| Some(order.is_major())).collect()),
        ),
    ];
    columns.into_iter().fold(Table::new("orders", "a firing star", rows.len()), Table::with)
}
