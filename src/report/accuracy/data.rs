//! Which columns hold what accuracy costs? A row a method of a load, and a row a load with its peak.

use crate::accuracy::{Method, PeakRow, Row, Study};
use crate::loads::PeakMethod;
use crate::report::accuracy::{methods, words};
use crate::report::data::Filling;
use crate::report::data::exact_number;
use crate::report::{AccuracyStudy, Further, FurtherLoad};
use crate::table::{Table, Unit};

/// A table of what accuracy costs.
pub fn table(study: &AccuracyStudy, name: &str) -> Option<Table> {
    Some(match name {
        "methods" => all_methods(study),
        "peaks" => peaks(study)?,
        _ => return None,
    })
}

/// A method of a load.
struct Found {
    case: usize,
    load: &'static str,
    method: &'static str,
    setting: Option<f64>,
    value: f64,
    unit: Unit,
    error: f64,
    farthest: Option<f64>,
    bound: Option<f64>,
    seconds: Option<f64>,
    on_front: Option<bool>,
}

fn all_methods(study: &AccuracyStudy) -> Table {
    let mut rows = Vec::new();
    for (number, case) in (1..).zip(&study.cases) {
        rows.extend(case.studies.iter().flat_map(|load| of_study(study, number, load)));
        rows.extend(case.further.iter().flat_map(|load| of_further(number, load)));
    }
    let mut table = Filling::new("accuracy.methods", &rows).keyed(4);
    table.whole("case", |row| row.case);
    table.words("load", |row| Some(row.load.to_owned()));
    table.words("method", |row| Some(row.method.to_owned()));
    table.decimal("setting", Unit::NONE, |row| Some(row.setting.unwrap_or(0.0)));
    table.decimal("value", Unit::NONE, |row| Some(row.value));
    table.words("unit", |row| Some(row.unit.name.to_owned()));
    table.decimal("error", Unit::NONE, |row| Some(row.error));
    table.decimal("error_anywhere", Unit::NONE, |row| row.farthest);
    table.decimal("bound", Unit::NONE, |row| row.bound);
    table.decimal("time_{unit}", Unit::SECOND, |row| row.seconds);
    table.truth("unbeaten", |row| row.on_front);
    table.done()
}

fn of_study<'a>(study: &'a AccuracyStudy, case: usize, load: &'a Study) -> impl Iterator<Item = Found> + 'a {
    let (unit, factor) = methods::unit(&study.engine, load.quantity);
    let front = methods::front(load);
    load.rows.iter().enumerate().map(move |(place, row): (usize, &Row)| {
        let (method, setting) = match row.method {
            Method::Orders(order) => ("orders", Some(order)),
            Method::Doubles(steps) => ("closed_form", Some(steps)),
            Method::Intervals(digits) => ("intervals", Some(digits)),
            Method::Fractions => ("fractions", None),
        };
        Found {
            case,
            load: words::name(load.quantity),
            method,
            setting: setting.map(f64::from),
            value: row.value * factor,
            unit,
            error: row.error,
            farthest: None,
            bound: row.bound,
            seconds: row.time.map(|time| time.as_secs_f64()),
            on_front: row.time.map(|_| front.contains(&place)),
        }
    })
}

fn of_further(case: usize, load: &Further) -> impl Iterator<Item = Found> {
    load.rows.iter().map(move |row: &PeakRow| {
        let (method, setting) = match row.method {
            PeakMethod::Orders(order) => ("orders", Some(order.value())),
            PeakMethod::Samples(steps) => ("closed_form", Some(f64::from(steps))),
            PeakMethod::Refined => ("refined", None),
        };
        Found {
            case,
            load: match load.load {
                FurtherLoad::Bearing => "bearing",
                FurtherLoad::Torque => "torque",
                FurtherLoad::BearingWithGas => "bearing_with_gas",
            },
            method,
            setting,
            value: row.value * load.factor,
            unit: load.unit,
            error: row.error,
            farthest: row.farthest,
            bound: row.bound,
            seconds: row.time.map(|time| time.as_secs_f64()),
            on_front: None,
        }
    })
}

fn peaks(study: &AccuracyStudy) -> Option<Table> {
    let cases = (1..).zip(&study.cases);
    let rows = cases.flat_map(|(number, case)| case.studies.iter().map(move |load| (number, case, load)));
    let mut table = Filling::new("accuracy.peaks", rows).keyed(2);
    table.whole("case", |(number, ..)| *number);
    table.words("load", |(.., load)| Some(words::name(load.quantity).to_owned()));
    table.exact("rod_ratio", Unit::NONE, |(_, case, _)| case.ratio.as_ref().map(exact_number));
    table.truth("nothing_found", |(.., load)| Some(load.rows.is_empty()));
    table.exact("at_least", Unit::NONE, |(.., load)| Some(methods::decimals(&load.peak.low, false)));
    table.exact("at_most", Unit::NONE, |(.., load)| Some(methods::decimals(&load.peak.high, true)));
    table.decimal("multiple", Unit::NONE, |(.., load)| Some(methods::unit(&study.engine, load.quantity).1));
    table.decimal("rounding", Unit::NONE, |(.., load)| Some(load.rounding));
    table.decimal("reference_error", Unit::NONE, |(.., load)| Some(load.doubt));
    table.done_if_any()
}
