//! Which lines does a comparison have? A column per engine: words of the verdicts, newtons where all have them.

use num_traits::ToPrimitive;

use super::super::calculation::{self, Unit};
use super::super::old::Rows;
use super::super::{bearings, engine_cells, residual, typeset};
use super::{Compared, orders_of};
use crate::engine::LengthUnit;
use crate::engine::{DOES_NOT_EXIST, WHY_NOT};
use crate::loads::{Missing, OrderLoads};
use crate::proof::Quantity;
use crate::text::Format;
use crate::verdict::OrderVerdict;

/// The table: a column per engine, a row each thing that is compared; cells in plain text.
pub fn compare_rows(engines: &[Compared]) -> Rows {
    let header =
        std::iter::once(String::new()).chain(engines.iter().map(|engine| engine.name.escaped(Format::Plain))).collect();
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut add = |name: String, cell: &dyn Fn(&Compared) -> String| {
        rows.push(std::iter::once(name).chain(engines.iter().map(cell)).collect());
    };
    add("Title".to_owned(), &|engine| engine.engine.title().escaped(Format::Plain));
    add("Cylinders".to_owned(), &|engine| engine.engine.cylinders().len().to_string());
    add("Firing".to_owned(), &|engine| engine.firing());
    let orders = orders_of(engines);
    for &order in &orders {
        for (name, quantity) in [("Force", Quantity::Force), ("Moment", Quantity::Moment)] {
            let words = |judged: Option<&OrderVerdict>| {
                judged.map_or_else(String::new, |judged| engine_cells::cell(judged, quantity))
            };
            add(format!("{name} {order}"), &|engine| words(engine.at(order)));
            if engines.iter().any(|engine| engine.pistons_at(order).is_some()) {
                add(format!("{name} {order}, pistons alone"), &|engine| {
                    words(engine.pistons_at(order).or(engine.at(order)))
                });
            }
        }
    }
    let first = |engine: &Compared| engine_cells::first_left(&engine.theorem);
    add("First force left".to_owned(), &|engine| first(engine)[0].clone());
    add("First moment left".to_owned(), &|engine| first(engine)[1].clone());
    add("Remedy".to_owned(), &|engine| engine_cells::remedy(&engine.remedy));
    if engines.iter().all(Compared::has_newtons) {
        add("Speed in rpm".to_owned(), &speed);
        for &order in &orders {
            add(format!("Force {order} in N"), &|engine| newtons(engine, order, Quantity::Force));
            add(format!("Moment {order} in N·m"), &|engine| newtons(engine, order, Quantity::Moment));
        }
    }
    if engines.iter().any(|engine| engine.bearings.as_ref().err() != Some(&Missing::Bearings)) {
        add("Worst main bearing".to_owned(), &worst_bearing);
    }
    Rows { header, rows }
}

fn speed(engine: &Compared) -> String {
    engine.engine.dimensions().speed.as_ref().map_or_else(String::new, typeset::number)
}

fn newtons(engine: &Compared, order: u32, quantity: Quantity) -> String {
    let Ok(loads) = &engine.loads else { return String::new() };
    let unit = Unit::of(engine.engine, loads, quantity);
    let swing = |loads: &OrderLoads| match quantity {
        _ if !loads.exists(engine.engine) => DOES_NOT_EXIST.to_owned(),
        Quantity::Force => calculation::plain(calculation::largest(&loads.force, unit)),
        _ => calculation::plain(calculation::largest(&loads.moment, unit)),
    };
    loads.orders.iter().find(|loads| loads.order == order).map_or_else(String::new, swing)
}

fn worst_bearing(engine: &Compared) -> String {
    match &engine.bearings {
        Ok(loads) => calculation::plain(bearings::worst(loads).unwrap_or_else(|| "0 in all".into())),
        Err(Missing::Bearings) => "none named".to_owned(),
        Err(Missing::Rods) => "not computed: no rods".to_owned(),
        Err(_) => "not computed".to_owned(),
    }
}

/// What follows the table: units, how it is read, why there are no newtons.
pub fn compare_lines(engines: &[Compared]) -> Vec<String> {
    let mut lines = vec![residual::LEGEND.to_owned()];
    lines.push(format!("m, r, ω and c_k are those of each engine. {}", positions(engines)));
    lines.push("First left: the lowest of all orders that exist. All is about the engines as they are built, with all masses that a layout names; where masses that turn have a part in an order, the pistons alone stand below it.".to_owned());
    lines.push(engine_cells::REMEDIES.to_owned());
    if engines.iter().any(|engine| engine.judged.orders.iter().any(|order| order.parts.len() > 1)) {
        lines.push(
            "Where rods differ, or a shaft turns at an order of the pistons, the whole of it is judged, and each of its sums by itself: only equal rods have c_k in common."
                .to_owned(),
        );
    }
    if engines.iter().any(|engine| engine.judged.orders.iter().any(|order| !order.exists())) {
        lines.push(WHY_NOT.to_owned());
    }
    let with: Vec<String> = engines.iter().filter(|e| e.has_newtons()).map(|e| e.name.escaped(Format::Plain)).collect();
    let without: Vec<String> =
        engines.iter().filter(|e| !e.has_newtons()).map(|e| e.name.escaped(Format::Plain)).collect();
    if !with.is_empty() && !without.is_empty() {
        lines.push(format!(
            "No newtons: for these all engines have to give rods, mass, crank radius, speed and positions in metres. With them: {}; without: {}.",
            with.join(", "),
            without.join(", ")
        ));
    }
    lines
}

/// What the positions, and with them the moments, are counted in.
fn positions(engines: &[Compared]) -> String {
    let of = |unit: LengthUnit| -> Vec<String> {
        engines.iter().filter(|e| e.engine.length_unit() == unit).map(|e| e.name.escaped(Format::Plain)).collect()
    };
    match (of(LengthUnit::Metre), of(LengthUnit::Spacing)) {
        (_, spacings) if spacings.is_empty() => "Positions are in metres.".to_owned(),
        (metres, _) if metres.is_empty() => {
            "Positions have no unit: they are multiples of the spacing of each engine.".to_owned()
        }
        (metres, spacings) => format!(
            "Positions are in different units, so that the moments do not compare: metres in {}, multiples of the spacing in {}.",
            metres.join(", "),
            spacings.join(", ")
        ),
    }
}

/// A speed or an angle for other programs.
pub(super) fn decimal(value: &num_rational::BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
