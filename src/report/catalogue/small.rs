//! How do an engine and an order look in little room? Cranks and cylinders without words, a star without words.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::super::figure::{Figure, Ink, Point, Stroke};
use super::super::star::{Star, towards, upright};
use crate::engine::Engine;
use crate::exact::Turn;
use crate::verdict::{OrderBalance, Verdict};

/// Width and height of a drawing in millimetres.
pub(super) const SIZE: f64 = 30.0;
const CENTRE: Point = Point::new(SIZE / 2.0, SIZE / 2.0);
/// Where a star and the cylinders end.
const RADIUS: f64 = 13.0;
/// Where the cylinders begin, and half their width where there are few.
const CYLINDERS: f64 = 8.0;
const HALF: f64 = 2.6;
/// From the centre to the pins.
const CRANK: f64 = 5.2;

/// The engine from its free end: pins inside, cylinders outside, angle 0 upwards.
pub(super) fn small_engine(engine: &Engine) -> Figure {
    let mut figure = Figure::new(SIZE, SIZE);
    let banks: BTreeSet<&Turn> = engine.cylinders().iter().map(|cylinder| &cylinder.bank).collect();
    let throws: BTreeSet<&Turn> = engine.cylinders().iter().map(|cylinder| &cylinder.throw).collect();
    let half = HALF.min(0.4 * TAU * CYLINDERS / banks.len().max(1) as f64);
    for bank in banks {
        let (along, across) = (towards(bank), towards(bank) * Point::i());
        let corner = |reach: f64, side: f64| CENTRE + along * reach + across * side;
        let corners =
            vec![corner(CYLINDERS, half), corner(RADIUS, half), corner(RADIUS, -half), corner(CYLINDERS, -half)];
        figure.polygon(corners, Stroke::solid(Ink::Black, 0.4), Some(Ink::Light));
    }
    for throw in throws {
        let pin = CENTRE + towards(throw) * CRANK;
        figure.line(CENTRE, pin, Stroke::solid(Ink::Blue, 0.9));
        figure.circle(pin, 1.2, Stroke::solid(Ink::Blue, 0.5), Some(Ink::Light));
    }
    figure.circle(CENTRE, 1.2, Stroke::solid(Ink::Black, 0.5), Some(Ink::Light));
    figure
}

/// The sum that tells most of an order: the first that is left of force and moment, direct and reverse; where nothing is
/// left, the direct force.
fn told(order: &OrderBalance) -> &Verdict {
    let sums = [order.force.verdicts(), order.moment.verdicts()].into_iter().flatten();
    sums.into_iter().find(|verdict| !verdict.vanishes()).unwrap_or(&order.force.direct)
}

/// That sum as a star.
pub(super) fn small_star(order: &OrderBalance) -> Figure {
    let star = Star::new(told(order));
    let mut figure = Figure::new(SIZE, SIZE);
    let reach = star.reach();
    let scale = if reach > 0.0 { RADIUS / reach } else { 0.0 };
    figure.circle(CENTRE, RADIUS, Stroke::solid(Ink::Light, 0.5), None);
    for (index, polygon) in star.polygons.iter().enumerate() {
        let corner = |j: u64| {
            let step = BigRational::new(j.into(), polygon.sides.into());
            let along = towards(&Turn::new(&polygon.rotation + step));
            CENTRE + along * polygon.weight.to_f64().unwrap_or(0.0) * scale
        };
        let ink = [Ink::Blue, Ink::Orange, Ink::Green][index % 3];
        figure.polygon((0..polygon.sides).map(corner).collect(), Stroke::solid(ink, 1.0), None);
    }
    for ray in &star.rays {
        let along = towards(&ray.angle) * ray.total().to_f64().unwrap_or(0.0) * scale;
        figure.arrow(CENTRE, CENTRE + along, Stroke::solid(Ink::Black, 0.45));
    }
    if let Some(resultant) = star.resultant {
        draw_resultant(&mut figure, upright(resultant) * scale);
    }
    figure
}

/// An arrow in outline from the centre, through which the vectors below it are seen; a short one is filled.
fn draw_resultant(figure: &mut Figure, tip: Point) {
    let length = tip.norm();
    if length < 1e-6 {
        return;
    }
    let (along, across) = (tip / length, tip / length * Point::i());
    let head = (0.4 * length).min(4.4);
    let (half, shaft) = (0.5 * head, 0.28 * head);
    let neck = tip - along * head;
    let shaft = across * shaft;
    let corners = [shaft, neck + shaft, neck + across * half, tip, neck - across * half, neck - shaft, -shaft];
    let fill = (length < 5.0).then_some(Ink::Red);
    figure.polygon(corners.map(|corner| CENTRE + corner).to_vec(), Stroke::solid(Ink::Red, 0.7), fill);
}
