//! The pictures of the page on V engines: the torus with its lines and points, even firing, and a star of each class.

use std::f64::consts::TAU;

use crankstar::exact::Turn;
use crankstar::page::figure::{Anchor, Figure, Ink, Point, Stroke};
use crankstar::page::svg;

use super::pin_stars::{ORDERS, Pins};
use super::torus::{self, PANEL, Place, Places, dashed};
use super::v_angles::{Found, MOST, even_line, lines, meeting};
use super::v_words::name;

const COLUMNS: usize = 3;

fn sheet(panels: usize) -> (Figure, impl Fn(usize) -> Point) {
    let rows = panels.div_ceil(COLUMNS);
    let corner =
        move |at: usize| Point::new(PANEL[0] * (at % COLUMNS) as f64, PANEL[1] * (rows - 1 - at / COLUMNS) as f64);
    (Figure::new(PANEL[0] * COLUMNS as f64, PANEL[1] * rows as f64), corner)
}

fn at(places: &Places) -> impl Iterator<Item = &Place> {
    match places {
        Places::Everywhere => panic!("points are drawn of stars of which no sum vanishes"),
        Places::At(places) => places.iter(),
    }
}

/// For each order the lines on which one vector vanishes, and the points where both do.
fn orders(found: &Found) -> String {
    let (mut figure, corner) = sheet(3);
    let free = &found.classes[&[false; 3]];
    for (panel, [direct, reverse]) in lines().iter().enumerate() {
        let corner = corner(panel);
        torus::frame(&mut figure, corner, &format!("Order {}", ORDERS[panel]));
        torus::draw_line(&mut figure, corner, direct, Stroke::solid(Ink::Blue, 0.3));
        torus::draw_line(&mut figure, corner, reverse, dashed(Ink::Orange, 0.4));
        for point in at(&free.places[panel]).flat_map(|place| torus::images(corner, place)) {
            figure.circle(point, 1.0, Stroke::solid(Ink::Black, 0.2), Some(Ink::Black));
        }
    }
    svg(&figure, "Where direct and reverse force of orders 1, 2 and 4 vanish, over bank angle and pin split")
}

/// The evenly spread star of n pins: the lines of even firing, four-stroke, and the points of each order.
fn even(found: &Found) -> String {
    let (mut figure, corner) = sheet(MOST);
    let free = &found.classes[&[false; 3]];
    let [[_, reverse], ..] = lines();
    for pins in 1..=MOST {
        let corner = corner(pins - 1);
        let turns: Vec<Turn> = (0..pins as i64).map(|step| Turn::fraction(step, pins as i64)).collect();
        let plural = if pins == 1 { "pin" } else { "pins" };
        torus::frame(&mut figure, corner, &format!("{pins} {plural}"));
        for turn in &turns {
            torus::draw_line(&mut figure, corner, &even_line(turn), Stroke::solid(Ink::Green, 0.35));
        }
        let marks = [(2.0, Ink::Blue), (1.35, Ink::Orange), (0.6, Ink::Black)];
        for ((radius, ink), places) in marks.into_iter().zip(&free.places) {
            for point in at(places).flat_map(|place| torus::images(corner, place)) {
                let fill = (ink == Ink::Black).then_some(ink);
                figure.circle(point, radius, Stroke::solid(ink, 0.35), fill);
            }
        }
        for point in turns.iter().flat_map(|turn| torus::images(corner, &meeting(&reverse, turn))) {
            let by = |x: f64, y: f64| point + Point::new(x, y);
            figure.polygon(
                vec![by(-0.8, -0.8), by(0.8, -0.8), by(0.8, 0.8), by(-0.8, 0.8)],
                Stroke::solid(Ink::Red, 0.35),
                None,
            );
        }
    }
    svg(
        &figure,
        "Even firing of evenly spread pins, and the points of orders 1, 2 and 4, over bank angle and pin split",
    )
}

/// The first star of every class.
fn classes(found: &Found) -> String {
    const STEP: [f64; 2] = [44.0, 46.0];
    let rows = found.classes.len().div_ceil(4);
    let mut figure = Figure::new(4.0 * STEP[0], rows as f64 * STEP[1]);
    for (at, (vanishing, class)) in found.classes.iter().enumerate() {
        let (column, row) = (at % 4, rows - 1 - at / 4);
        let middle = Point::new((column as f64 + 0.5) * STEP[0], row as f64 * STEP[1] + 19.0);
        figure.heading(middle + Point::new(0.0, 22.0), format!("zero: {}", name(vanishing)));
        figure.circle(middle, 12.0, Stroke::solid(Ink::Grey, 0.2), None);
        pins(&mut figure, middle, &class.first);
    }
    svg(&figure, "One pin star of each class")
}

fn pins(figure: &mut Figure, middle: Point, star: &Pins) {
    let degrees = star.degrees();
    for (at, &angle) in degrees.iter().enumerate() {
        if degrees[..at].contains(&angle) {
            continue;
        }
        let pin = Point::from_polar(12.0, TAU * angle as f64 / 360.0 + TAU / 4.0);
        figure.line(middle, middle + pin, Stroke::solid(Ink::Black, 0.5));
        figure.circle(middle + pin, 1.5, Stroke::solid(Ink::Black, 0.3), Some(Ink::Blue));
        let same = degrees.iter().filter(|other| **other == angle).count();
        if same > 1 {
            figure.text(middle + pin * 1.35, format!("×{same}"), Anchor::Middle);
        }
    }
}

/// Names and texts of the pictures.
pub fn pictures(found: &Found) -> [(&'static str, String); 3] {
    [("orders.svg", orders(found)), ("even.svg", even(found)), ("classes.svg", classes(found))]
}
