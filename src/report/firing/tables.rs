//! Which tables tell of firing stars? What each order leaves, and when the cylinders fire.

use super::super::{residual, typeset};
use super::FiringStudy;
use super::words::names_of;
use crate::page::{Number, Table, Text, phrase};

/// Orders × (length, direction, kind); an order of several classes has a row for each.
pub(super) fn orders(study: &FiringStudy) -> Table {
    let stars = study.orders.iter().flat_map(|order| order.stars.iter().map(move |star| (order, star)));
    Table::of(stars)
        .column("Order κ", |(order, star)| match order.only() {
            Some(_) => order.order.to_string().into(),
            None if star.sources.len() == 1 => {
                phrase!("{} (cylinder {})", order.order.to_string(), names_of(&study.engine, star))
            }
            None => phrase!("{} (cylinders {})", order.order.to_string(), names_of(&study.engine, star)),
        })
        .column("Firing star", |(_, star)| residual::modulus(*star))
        .column("Direction", |(_, star)| match star.vanishes() {
            true => Text::from("–"),
            false => residual::bearing(&star.sum).into(),
        })
        .column("Kind", |(order, star)| match (star.vanishes(), order.is_major()) {
            (true, _) => "vanishes",
            (false, true) => "major",
            (false, false) => "minor",
        })
        .done()
}

/// One row per firing: cylinder, crank angle, interval to the next; the deflection where there is a mode shape.
pub(super) fn firings(study: &FiringStudy) -> Table {
    let shots = study.engine.firing().into_iter().flat_map(|firing| firing.shots.iter().zip(firing.intervals()));
    Table::of(shots)
        .column("Cylinder", |(shot, _)| study.engine.cylinders()[shot.cylinder].name.clone())
        .column("Fires at", |(shot, _)| typeset::turns(&shot.angle))
        .column("Next firing after", |(_, interval)| typeset::turns(interval))
        .column_if(study.weights.is_mode_shape(), "Deflection Δ", |(shot, _)| {
            Number::exact(&study.weights.of(shot.cylinder))
        })
        .done()
}
