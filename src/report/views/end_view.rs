//! What does the engine look like from its free end? Crank star, rods, pistons and cylinders at θ = 0.

use super::super::figure::{Dash, Figure, Ink, Point, Stroke};
use super::super::plot::labels::Labels;
use super::MOST_LABELS;
use super::below::write_below;
use super::crop::cropped;
use super::linkage::{CROWN, HEAD, Linkage, Linkages, SKIRT, linkages};
use super::names::{name_banks, name_offsets, name_pins, name_pistons};
use crate::engine::{Engine, SeenFrom};
use crate::page::Units;
use crate::proof::Sense;

/// Half the bore where there is room.
const WIDEST: f64 = 4.6;
const NARROWEST: f64 = 1.2;
/// Colours of the rows of a radial.
const ROWS: [(Ink, Dash); 3] = [(Ink::Blue, Dash::Solid), (Ink::Orange, Dash::Dashed), (Ink::Green, Dash::DashDotted)];

/// The engine from its free end at θ = 0: angle 0 upwards, angles anticlockwise, cylinders that coincide drawn once.
pub fn end_view(engine: &Engine) -> Figure {
    let in_inches = engine.has_offset().then(|| Box::new(drawn(engine, Units::Inch)));
    Figure { in_inches, ..drawn(engine, Units::Si) }
}

fn drawn(engine: &Engine, units: Units) -> Figure {
    let Linkages { all, axes } = linkages(engine, units);
    let has_labels = all.len() <= MOST_LABELS;
    let from = engine.convention().turns_anticlockwise_from();
    let mut whole = Figure::new(0.0, 0.0);
    for own in all.chunk_by(|a, b| a.crank == b.crank) {
        let crank = own[0].crank;
        let sense = engine.geared_cranks().get(crank).map_or(Sense::Direct, |crank| crank.sense);
        let heads = !engine.has_opposed_pistons();
        let axis = axes.get(crank).copied().unwrap_or_default();
        whole.place(of_crankshaft(own, sense, from, heads, has_labels), axis);
    }
    let mut figure = cropped(whole);
    write_below(&mut figure, engine);
    cropped(figure)
}

/// One crankshaft with its pistons, its axis at the origin.
fn of_crankshaft(linkages: &[Linkage], sense: Sense, from: SeenFrom, heads: bool, has_labels: bool) -> Figure {
    let half = half_bore(linkages);
    let mut figure = Figure::new(0.0, 0.0);
    let mut labels = Labels::anywhere();
    draw_cylinders(&mut figure, &mut labels, linkages, half, heads);
    // The row at the end that is looked from lies upon the others.
    let nearest_last: Vec<&Linkage> = match from {
        SeenFrom::FreeEnd => linkages.iter().rev().collect(),
        SeenFrom::Flywheel => linkages.iter().collect(),
    };
    for linkage in nearest_last {
        draw_rod(&mut figure, &mut labels, linkage, half);
    }
    draw_crank(&mut figure, &mut labels, linkages, sense);
    if has_labels {
        name_pins(&mut figure, &mut labels, linkages);
        name_pistons(&mut figure, &mut labels, linkages, half);
        // Where two pistons share a cylinder, the room between them is theirs.
        if heads {
            name_banks(&mut figure, &mut labels, linkages, half);
        }
        name_offsets(&mut figure, &mut labels, linkages);
    }
    figure
}

/// Half the bore: neighbouring banks leave each other room where the pistons are lowest.
fn half_bore(linkages: &[Linkage]) -> f64 {
    let lowest = linkages.iter().map(|linkage| linkage.stroke.0 - SKIRT).fold(f64::INFINITY, f64::min);
    let mut banks: Vec<f64> = linkages.iter().map(|linkage| linkage.along.arg()).collect();
    banks.sort_by(f64::total_cmp);
    banks.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let around = banks.first().map(|first| first + std::f64::consts::TAU);
    let next = banks.iter().skip(1).copied().chain(around);
    let gap = banks.iter().zip(next).map(|(bank, next)| next - bank).fold(f64::INFINITY, f64::min);
    let room = if gap < std::f64::consts::PI { 0.92 * lowest.max(0.0) * (gap / 2.0).tan() } else { WIDEST };
    room.clamp(NARROWEST, WIDEST)
}

/// Axes through the crankshaft's plane, and cylinders with their heads; each once.
fn draw_cylinders(figure: &mut Figure, labels: &mut Labels, linkages: &[Linkage], half: f64, heads: bool) {
    let mut drawn: Vec<Point> = Vec::new();
    for linkage in linkages {
        let Linkage { along, across, foot, stroke: (low, high), .. } = linkage;
        let head = foot + along * (high + CROWN + HEAD);
        if drawn.iter().any(|other| (other - head).norm() < 1e-6) {
            continue;
        }
        drawn.push(head);
        let axis = Stroke { ink: Ink::Grey, width: 0.2, dash: Dash::DashDotted };
        // With an offset the axis is drawn past the crank, so that it is seen on which side of the shaft it passes.
        let past = if foot.norm() > 0.0 { linkage.pin.norm() + 4.0 } else { 3.0 };
        figure.line(foot - along * past, head + along * 1.2, axis);
        let side = across * half;
        let bottom = foot + along * (low - SKIRT);
        if foot.norm() > 0.0 {
            labels.avoid_path(&[foot - along * past, bottom]);
        }
        let walls = vec![bottom + side, head + side, head - side, bottom - side];
        labels.avoid_path(&walls);
        match heads {
            true => figure.path(walls, Stroke::solid(Ink::Grey, 0.35)),
            // The cylinder goes on to the other piston.
            false => {
                walls.chunks(2).for_each(|wall| figure.path(wall.to_vec(), Stroke::solid(Ink::Grey, 0.35)));
            }
        }
    }
}

fn draw_rod(figure: &mut Figure, labels: &mut Labels, linkage: &Linkage, half: f64) {
    let (ink, dash) = ROWS[linkage.row % ROWS.len()];
    let Linkage { along, across, piston, pin, joint, .. } = linkage;
    let side = across * (half - 0.45);
    let (low, high) = (piston - along * SKIRT, piston + along * CROWN);
    figure.polygon(
        vec![low + side, high + side, high - side, low - side],
        Stroke::solid(Ink::Black, 0.25),
        Some(Ink::Light),
    );
    figure.line(*joint, *piston, Stroke { ink, width: 0.45, dash });
    labels.avoid_path(&[*joint, *piston]);
    if (joint - pin).norm() > 0.0 {
        // The flange of the master rod, as far as this link needs it.
        figure.line(*pin, *joint, Stroke::solid(ink, 0.9));
        figure.circle(*joint, 0.5, Stroke::solid(ink, 0.3), Some(Ink::Shade(0)));
        labels.avoid_path(&[*pin, *joint]);
    }
    figure.circle(*piston, 0.6, Stroke::solid(ink, 0.3), Some(Ink::Shade(0)));
}

/// A crank is too small for an arrow within its circle from this radius down, in millimetres.
const SMALL_CRANK: f64 = 3.0;
/// The least length of a line under the head of an arrow, in millimetres.
const UNDER_A_HEAD: f64 = 2.6;

/// The circle of the pins, the throws, the pins and the shaft, and which way it turns.
fn draw_crank(figure: &mut Figure, labels: &mut Labels, linkages: &[Linkage], sense: Sense) {
    let mut radii: Vec<f64> = linkages.iter().map(|linkage| linkage.pin.norm()).collect();
    radii.sort_by(f64::total_cmp);
    radii.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    for radius in &radii {
        figure.circle(Point::default(), *radius, Stroke::solid(Ink::Grey, 0.15), None);
    }
    for linkage in linkages.iter().rev() {
        let (ink, _) = ROWS[linkage.row % ROWS.len()];
        figure.line(Point::default(), linkage.pin, Stroke::solid(ink, 1.2));
        labels.avoid_path(&[Point::default(), linkage.pin]);
    }
    for linkage in linkages.iter().rev() {
        let (ink, _) = ROWS[linkage.row % ROWS.len()];
        figure.circle(linkage.pin, 1.3, Stroke::solid(ink, 0.4), Some(Ink::Light));
        labels.avoid_sign(linkage.pin, 1.5);
    }
    figure.circle(Point::default(), 1.8, Stroke::solid(Ink::Black, 0.35), Some(Ink::Light));
    labels.avoid_sign(Point::default(), 2.0);
    draw_offsets(figure, linkages);
    if let Some(farthest) = radii.last() {
        // Beside the throws, or round a crank too small for that.
        let mut arc = turning(linkages, if *farthest > SMALL_CRANK { farthest * 0.62 } else { farthest + SMALL_CRANK });
        if sense == Sense::Reverse {
            arc.reverse();
        }
        labels.avoid_path(&arc);
        if let Some(last) = arc.last().copied() {
            // The head needs a line of this length; a step of the arc is too short for one.
            let before = arc.iter().rposition(|point| (last - point).norm() >= UNDER_A_HEAD).unwrap_or(0);
            figure.arrow(arc[before], last, Stroke::solid(Ink::Black, 0.3));
            arc.truncate(before + 1);
        }
        figure.path(arc, Stroke::solid(Ink::Black, 0.3));
    }
}

/// From the middle of the shaft to each cylinder axis that misses it.
fn draw_offsets(figure: &mut Figure, linkages: &[Linkage]) {
    for linkage in linkages.iter().filter(|linkage| linkage.foot.norm() > 0.0) {
        let Linkage { foot, along, .. } = linkage;
        figure.line(Point::default(), *foot, Stroke::solid(Ink::Red, 0.5));
        figure.line(foot - along * 1.2, foot + along * 1.2, Stroke::solid(Ink::Red, 0.25));
    }
}

/// An arc in the widest gap between the throws, anticlockwise.
fn turning(linkages: &[Linkage], radius: f64) -> Vec<Point> {
    let full = std::f64::consts::TAU;
    let mut angles: Vec<f64> = linkages.iter().map(|linkage| linkage.pin.arg().rem_euclid(full)).collect();
    angles.sort_by(f64::total_cmp);
    let around = angles.first().map(|first| first + full);
    let next = angles.iter().skip(1).copied().chain(around);
    let gaps = angles.iter().zip(next).map(|(angle, next)| (next - angle, *angle));
    // Of equal gaps the one farthest from the cylinders, whose rods would hide the arrow; then the one that comes first, whatever floats say.
    let apart = |middle: f64, along: f64| {
        let turn = (middle - along).rem_euclid(full);
        turn.min(full - turn)
    };
    let free = |(gap, start): (f64, f64)| {
        let middle = start + gap / 2.0;
        linkages.iter().map(|linkage| apart(middle, linkage.along.arg())).fold(full, f64::min)
    };
    let is_better = |gap: (f64, f64), best: (f64, f64)| {
        gap.0 > best.0 + 1e-6 || gap.0 > best.0 - 1e-6 && free(gap) > free(best) + 1e-6
    };
    let widest = gaps.reduce(|best, gap| if is_better(gap, best) { gap } else { best });
    let (gap, start) = widest.unwrap_or((full, 0.0));
    let (middle, arm) = (start + gap / 2.0, (gap * 0.3).min(0.8));
    (0..=8).map(|step| Point::from_polar(radius, middle - arm + arm * 2.0 * f64::from(step) / 8.0)).collect()
}
