//! Which rows does a comparison have? A column per engine: words of the verdicts, newtons where all have them.

use super::super::calculation::{self, Unit};
use super::super::{bearings, engine_cells};
use super::{Compared, orders_of};
use crate::engine::DOES_NOT_EXIST;
use crate::loads::{Missing, OrderLoads};
use crate::page::{self, Number, Table, Text, phrase};
use crate::proof::Planar;
use crate::verdict::OrderVerdict;

/// The table of some of the engines that are compared: a column per engine, a row each thing that any of all has.
pub(super) fn table(all: &[Compared], shown: &[Compared]) -> Table {
    let mut table = Table::new([Text::default()].into_iter().chain(shown.iter().map(|engine| (&engine.name).into())));
    let mut add = |name: Text, cell: &dyn Fn(&Compared) -> Text| {
        table.push([name].into_iter().chain(shown.iter().map(cell)).collect());
    };
    add("Title".into(), &|engine| engine.engine.title().into());
    add("Cylinders".into(), &|engine| engine.engine.cylinders().len().into());
    add("Firing".into(), &|engine| engine_cells::firing(engine.engine.firing()));
    let orders = orders_of(all);
    for &order in &orders {
        for (name, alone, quantity) in [
            ("Force {}", "Force {}, pistons alone", Planar::Force),
            ("Moment {}", "Moment {}, pistons alone", Planar::Moment),
        ] {
            let words = |judged: Option<&OrderVerdict>| {
                judged.map_or_else(Text::default, |judged| engine_cells::cell(judged, quantity))
            };
            add(phrase!(name, order), &|engine| words(engine.at(order)));
            if all.iter().any(|engine| engine.pistons_at(order).is_some()) {
                add(phrase!(alone, order), &|engine| words(engine.pistons_at(order).or(engine.at(order))));
            }
        }
    }
    let first = |engine: &Compared| engine_cells::first_left(&engine.engine, &engine.theorem);
    add("First force left".into(), &|engine| first(engine)[0].clone());
    add("First moment left".into(), &|engine| first(engine)[1].clone());
    add("Remedy".into(), &|engine| engine_cells::remedy(&engine.remedy));
    if all.iter().all(Compared::has_newtons) {
        add("Speed in rpm".into(), &speed);
        for &order in &orders {
            add(phrase!("Force {} in {}", order, page::Unit::NEWTON), &|engine| newtons(engine, order, Planar::Force));
            add(phrase!("Moment {} in {}", order, page::Unit::NEWTON_METRE), &|engine| {
                newtons(engine, order, Planar::Moment)
            });
        }
    }
    if all.iter().any(|engine| engine.bearings.as_ref().err() != Some(&Missing::Bearings)) {
        add("Worst main bearing".into(), &worst_bearing);
    }
    if all.iter().any(|engine| engine.with_gas.is_some()) {
        add("Worst main bearing with gas".into(), &worst_with_gas);
    }
    table
}

/// The speed of an engine, where its layout has one.
pub(super) fn speed(engine: &Compared) -> Text {
    engine.engine.dimensions().speed.as_ref().map_or_else(Text::default, |speed| Number::exact(speed).into())
}

fn newtons(engine: &Compared, order: u32, quantity: Planar) -> Text {
    let Ok(loads) = &engine.loads else { return Text::default() };
    let unit = Unit::of(&engine.engine, loads, quantity);
    let swing = |loads: &OrderLoads| match loads.exists(&engine.engine) {
        false => DOES_NOT_EXIST.into(),
        true => calculation::largest(loads.swing(quantity), unit),
    };
    loads.orders.iter().find(|loads| loads.order == order).map_or_else(Text::default, swing)
}

fn worst_bearing(engine: &Compared) -> Text {
    match &engine.bearings {
        Ok(loads) => bearings::worst(loads).unwrap_or_else(|| "0 in all".into()),
        Err(Missing::Bearings) => "none named".into(),
        Err(Missing::Rods) => "not computed: no rods".into(),
        Err(_) => "not computed".into(),
    }
}

fn worst_with_gas(engine: &Compared) -> Text {
    match (&engine.with_gas, engine.worst_with_gas()) {
        (None, _) => "gas not asked for".into(),
        (Some(Err(Missing::Bearings)), _) => "none named".into(),
        (Some(Err(_)), _) => "not computed".into(),
        (Some(Ok(_)), None) => "none named".into(),
        (Some(Ok(_)), Some((index, peak))) => {
            phrase!(
                "bearing {} with {} {}",
                (index + 1).to_string(),
                Text::measured(peak.value, page::Unit::NEWTON),
                page::Unit::NEWTON
            )
        }
    }
}
