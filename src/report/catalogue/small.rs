//! How does an engine look in the size of a stamp? Cranks and cylinders without words.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use super::super::figure::{Figure, Ink, Point, Stroke};
use super::super::star::towards;
use crate::engine::Engine;
use crate::exact::Turn;

/// Width and height of a drawing in millimetres.
pub(super) const SIZE: f64 = 30.0;
const CENTRE: Point = Point::new(SIZE / 2.0, SIZE / 2.0);
/// Where the cylinders end, as far out as a small star reaches.
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
