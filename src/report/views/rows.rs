//! Where do the cylinders stand along the engine? A row for each bank, with the names that fit.

use std::collections::{BTreeMap, BTreeSet};

use super::super::figure::{Anchor, Figure, Ink, Point, Stroke};
use super::super::plot::labels::LINE;
use super::super::plot::number::text_width;
use super::super::typeset;
use super::scale::Scale;
use super::{MOST_LABELS, signed_angle, wrapped};
use crate::engine::{Cylinder, Engine};
use crate::exact::Turn;

/// More banks than this are not drawn as rows.
const MOST_ROWS: usize = 4;
/// Half the width of a cylinder where there is room; half its height, and the air between rows.
const WIDEST: f64 = 4.4;
const HALF: f64 = 2.9;
const AIR: f64 = 2.0;

/// The banks that have a row of their own, from below, angles rising; none where there are many.
pub(super) fn banks(engine: &Engine) -> Vec<&Turn> {
    let banks: BTreeSet<&Turn> = engine.cylinders().iter().map(|cylinder| &cylinder.bank).collect();
    let mut banks: Vec<&Turn> = if banks.len() > MOST_ROWS { Vec::new() } else { banks.into_iter().collect() };
    banks.sort_by_key(|bank| typeset::signed_degrees(bank));
    banks
}

/// Draws the rows above this height; gives the height of their top.
pub(super) fn draw_rows(figure: &mut Figure, engine: &Engine, scale: &Scale, bottom: f64, left: f64) -> f64 {
    let banks = banks(engine);
    let mut low = bottom;
    for row in 0..banks.len().max(1) {
        let bank = banks.get(row).copied();
        let top = draw_row(figure, engine, scale, bank, low);
        if let Some(bank) = bank.filter(|_| banks.len() > 1) {
            figure.text(Point::new(left, low + HALF), signed_angle(bank), Anchor::End);
        }
        low = top + AIR;
    }
    low - AIR
}

fn draw_row(figure: &mut Figure, engine: &Engine, scale: &Scale, bank: Option<&Turn>, low: f64) -> f64 {
    let of_row = |cylinder: &&Cylinder| bank.is_none_or(|bank| *bank == cylinder.bank);
    let mut places: BTreeMap<_, Vec<&str>> = BTreeMap::new();
    for cylinder in engine.cylinders().iter().filter(of_row) {
        places.entry(&cylinder.position).or_default().push(&cylinder.name);
    }
    let labelled = places.len() <= MOST_LABELS;
    let half = (scale.cylinders_apart * 0.44).clamp(0.5, WIDEST);
    let places: Vec<(f64, String)> =
        places.iter().rev().map(|(position, names)| (scale.x(position), typeset::names(names))).collect();
    // A cylinder may be as wide as its name where its own row leaves room.
    let gaps = places.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(f64::INFINITY, f64::min);
    let room = if gaps.is_finite() { gaps * 0.44 } else { 14.0 }.max(half);
    let lines: Vec<Vec<String>> = places.iter().map(|(_, name)| wrapped(name, &[' '], 2.0 * room - 0.6)).collect();
    let widest = lines.iter().flatten().map(|line| text_width(line.trim_end())).fold(0.0, f64::max);
    let fits = widest + 0.6 <= 2.0 * room;
    let half = if fits { half.max(widest / 2.0 + 0.8).min(room) } else { half };
    let most = if fits && labelled { lines.iter().map(Vec::len).max().unwrap_or(1) } else { 1 };
    let high = low + 2.0 * HALF + (most.max(1) - 1) as f64 * LINE;
    for (x, _) in &places {
        let corners = [(-half, low), (half, low), (half, high), (-half, high)].map(|(dx, y)| Point::new(x + dx, y));
        figure.polygon(corners.to_vec(), Stroke::solid(Ink::Black, 0.3), Some(Ink::Light));
    }
    match (labelled, fits) {
        (false, _) => high,
        (true, true) => {
            for ((x, _), lines) in places.iter().zip(&lines) {
                let first = (low + high) / 2.0 + (lines.len() - 1) as f64 * LINE / 2.0;
                for (index, line) in lines.iter().enumerate() {
                    figure.text(Point::new(*x, first - index as f64 * LINE), line.trim_end(), Anchor::Middle);
                }
            }
            high
        }
        (true, false) => in_levels(figure, &places, high + LINE / 2.0 + 0.4, 1.0) + LINE / 2.0,
    }
}

/// Writes texts centred at their places, each on the first level where it touches no other; gives the last level.
/// `way` is 1 for levels upwards and −1 for levels downwards.
pub(super) fn in_levels(figure: &mut Figure, texts: &[(f64, String)], first: f64, way: f64) -> f64 {
    let mut free: Vec<f64> = Vec::new();
    for (x, text) in texts {
        let half = text_width(text) / 2.0 + 0.5;
        let level = free.iter().position(|end| *end <= x - half).unwrap_or(free.len());
        match free.get_mut(level) {
            Some(end) => *end = x + half,
            None => free.push(x + half),
        }
        let y = first + way * level as f64 * LINE;
        figure.text(Point::new(*x, y), text.clone(), Anchor::Middle);
    }
    first + way * free.len().saturating_sub(1) as f64 * LINE
}
