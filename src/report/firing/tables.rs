//! Which tables tell of firing stars? What each order leaves, and when the cylinders fire.

use num_rational::BigRational;

use super::super::{residual, typeset};
use super::FiringStudy;
use super::words::names_of;
use crate::firing::{FiringStar, StarOrder};
use crate::page::{Number, Table, Text, phrase};

/// Orders × (length, direction, kind); an order of several classes has a row for each.
pub(super) fn orders(study: &FiringStudy) -> Table {
    let mut table = Table::new(["Order κ", "Firing star", "Direction", "Kind"]);
    for order in &study.orders {
        for star in &order.stars {
            table.push(row(study, order, star));
        }
    }
    table
}

fn row(study: &FiringStudy, order: &StarOrder, star: &FiringStar) -> Vec<Text> {
    let name: Text = match order.only() {
        Some(_) => order.order.to_string().into(),
        None => phrase!("{} (cylinders {})", order.order.to_string(), names_of(&study.engine, star)),
    };
    let direction = if star.vanishes() { "–".into() } else { residual::bearing(&star.sum).into() };
    let kind = match (star.vanishes(), order.is_major()) {
        (true, _) => "vanishes",
        (false, true) => "major",
        (false, false) => "minor",
    };
    vec![name, residual::modulus(star).into(), direction, kind.into()]
}

/// One row per firing: cylinder, crank angle, interval to the next; the deflection where there is a mode shape.
pub(super) fn firings(study: &FiringStudy) -> Table {
    let mut header = vec!["Cylinder", "Fires at", "Next firing after"];
    header.extend(study.weights.is_mode_shape().then_some("Deflection Δ"));
    let mut table = Table::new(header);
    let Some(firing) = study.engine.firing() else { return table };
    let degrees = |turns: &BigRational| Text::from(typeset::turns(turns));
    for (shot, interval) in firing.shots.iter().zip(firing.intervals()) {
        let name = study.engine.cylinders()[shot.cylinder].name.clone();
        let mut cells = vec![name.into(), degrees(&shot.angle), degrees(&interval)];
        cells.extend(study.weights.is_mode_shape().then(|| Number::exact(&study.weights.of(shot.cylinder)).into()));
        table.push(cells);
    }
    table
}
