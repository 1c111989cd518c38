//! `torque`: which torque does the engine give, and which flywheel does it need?

use num_traits::ToPrimitive;
use pyo3::prelude::*;

use crate::engine::Engine;
use crate::page::Document;
use crate::python::answer::Question;
use crate::python::documents;
use crate::python::error::told;
use crate::report;
use crate::table::{Column, Table, Unit, Values};
use crate::torque::{self, EngineTorque};

struct Torque {
    engine: Engine,
    torque: EngineTorque,
}

/// The torque of gas and inertia.
pub(in crate::python) fn torque(engine: &Engine) -> PyResult<impl Question + use<>> {
    let torque = torque::torque(engine).map_err(told)?;
    Ok(Torque { engine: engine.clone(), torque })
}

impl Question for Torque {
    fn tables(&self) -> Vec<Table> {
        vec![orders(&self.torque), theta(&self.torque)]
    }

    fn json(&self) -> PyResult<String> {
        documents::json(&report::torque_document(&self.engine, &self.torque))
    }

    fn answer(&self) -> Document {
        report::torque_answer(&self.engine, &self.torque)
    }

    fn page(&self) -> Document {
        report::torque_page(&self.engine, &self.torque)
    }
}

fn decimals(values: impl Iterator<Item = f64>) -> Values {
    Values::Decimal(values.map(Some).collect())
}

/// A row an order of the cycle.
fn orders(torque: &EngineTorque) -> Table {
    let orders = &torque.orders;
    let number = orders.iter().map(|order| order.order.exact().to_f64());
    let columns = [
        Column::new("order", Unit::NONE, "the order κ of the crank speed", Values::Decimal(number.collect())),
        Column::new(
            "gas_vanishes",
            Unit::NONE,
            "whether the part of the gas is proved to be 0, for every pressure that equal cylinders share",
            Values::Truth(orders.iter().map(|order| Some(order.vanishes)).collect()),
        ),
        Column::new(
            "gas_zero_to_peak_{unit}",
            Unit::NEWTON_METRE,
            "the amplitude of the gas",
            decimals(orders.iter().map(|order| if order.vanishes { 0.0 } else { order.gas.norm() })),
        ),
        Column::new(
            "inertia_zero_to_peak_{unit}",
            Unit::NEWTON_METRE,
            "the amplitude of the inertia; empty where masses or speed are not given",
            Values::Decimal(orders.iter().map(inertia).collect()),
        ),
    ];
    columns.into_iter().fold(Table::new("orders", "an order of the torque", orders.len()), Table::with)
}

fn inertia(order: &torque::TorqueOrder) -> Option<f64> {
    order.inertia.map(|inertia| if order.inertia_vanishes { 0.0 } else { inertia.norm() })
}

/// A row a degree of the cycle.
fn theta(torque: &EngineTorque) -> Table {
    let degrees = 0..torque.course.period().to_degrees().round() as u32;
    let rows = degrees.len();
    let at = |value: &dyn Fn(f64) -> f64| decimals(degrees.clone().map(|degree| value(f64::from(degree).to_radians())));
    let columns = [
        Column::new("theta_{unit}", Unit::DEGREE, "the crank angle θ", decimals(degrees.clone().map(f64::from))),
        Column::new(
            "torque_{unit}",
            Unit::NEWTON_METRE,
            "the torque on the crankshaft, of gas and inertia",
            at(&|theta| torque.course.total(theta)),
        ),
        Column::new(
            "roll_{unit}",
            Unit::NEWTON_METRE,
            "the roll moment on the frame, without that of balancer shafts",
            at(&|theta| torque.course.roll(theta)),
        ),
    ];
    columns.into_iter().fold(Table::new("theta", "a crank angle of the cycle", rows), Table::with)
}
