//! Which curve is which? Names on the curves, where they hide none; those of curves that coincide together.

use super::super::Language;
use super::super::figure::{Anchor, Figure, Ink, Point, Stroke};
use super::Curve;
use super::frame::Frame;
use super::labels::{LINE, Labels, Place, area};
use super::number::text_width;

/// Curves whose points are nearer than this on the page, in millimetres, are drawn on each other.
const SAME: f64 = 0.3;
/// Longer names than this are in the legend.
const LONGEST: f64 = 46.0;
/// A name belongs to its curve if every other one is farther from it by this.
const CLEAR: f64 = 1.6;
/// Places along a curve that are tried.
const PLACES: usize = 30;
/// A place that costs more is no place: the name goes to the legend.
const WORST: usize = 300;

/// Curves that coincide on the page, by their numbers; the others alone.
fn coinciding(curves: &[Curve], frame: &Frame) -> Vec<Vec<usize>> {
    let same = |a: &Curve, b: &Curve| {
        let near = |(a, b): (&(f64, f64), &(f64, f64))| match (frame.at(*a), frame.at(*b)) {
            (Some(a), Some(b)) => (a - b).norm() < SAME,
            (None, None) => true,
            _ => false,
        };
        a.points.len() == b.points.len() && a.points.len() > 1 && a.points.iter().zip(&b.points).all(near)
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (number, curve) in curves.iter().enumerate().filter(|(_, curve)| !curve.name.is_empty()) {
        match groups.iter_mut().find(|group| same(&curves[group[0]], curve)) {
            Some(group) => group.push(number),
            None => groups.push(vec![number]),
        }
    }
    groups
}

/// Writes the names upon the curves, whose lines on the page are given; returns the curves that found no place for theirs.
///
/// That curves coincide is seen on the page and not proved: `2 ≈ 4`.
pub(super) fn name_curves<'a>(
    figure: &mut Figure,
    labels: &mut Labels,
    (curves, lines): (&'a [Curve], &[Vec<Vec<Point>>]),
    frame: &Frame,
) -> Vec<&'a Curve> {
    let mut homeless = Vec::new();
    for group in coinciding(curves, frame) {
        let names = group.iter().map(|number| curves[*number].name.clone());
        let name = names.reduce(|names, name| format!("{names} ≈ {name}")).unwrap_or_default();
        let others = lines.iter().enumerate().filter(|(number, _)| !group.contains(number));
        let others: Vec<Point> = others.flat_map(|(_, runs)| runs.iter().flat_map(|run| dense(run))).collect();
        let own: Vec<Point> = lines[group[0]].iter().flat_map(|run| dense(run)).collect();
        let wide = widest(&name);
        let places = if text_width(&wide) > LONGEST { Vec::new() } else { places(&wide, &own, &others) };
        let best = labels.best(&wide, places.iter().map(|(place, cost, _)| (*place, *cost)));
        match best.filter(|(_, cost)| *cost <= WORST) {
            Some((index, _)) => {
                let (place, _, from) = places[index];
                labels.write(figure, &name, &[place]);
                labels.avoid_area(area(&wide, &place));
                let end = nearest_side(&name, place, from);
                if (end - from).norm() > 1.6 {
                    figure.line(from, end, Stroke::solid(Ink::Grey, 0.15));
                }
            }
            None => homeless.extend(group.iter().map(|number| &curves[*number])),
        }
    }
    homeless
}

/// A name in the language in which it is the widest: there is room for it in each.
pub(super) fn widest(name: &str) -> String {
    let spelled = Language::ALL.into_iter().map(|language| language.label(name).into_owned());
    spelled.max_by(|one, other| text_width(one).total_cmp(&text_width(other))).unwrap_or_default()
}

/// Points of a line that are a millimetre apart at most.
fn dense(run: &[Point]) -> Vec<Point> {
    let step = |pair: &[Point]| {
        let (from, way) = (pair[0], pair[1] - pair[0]);
        let steps = way.norm().ceil().clamp(1.0, 400.0) as usize;
        (0..steps).map(|step| from + way * (step as f64 / steps as f64)).collect::<Vec<_>>()
    };
    let mut points: Vec<Point> = run.windows(2).flat_map(step).collect();
    points.extend(run.last());
    points
}

/// The middle of the lower or upper edge of a text, or of its side, towards a point of its curve.
fn nearest_side(name: &str, (at, anchor): Place, from: Point) -> Point {
    match anchor {
        Anchor::Middle => {
            let half = (text_width(name) / 2.0 - 1.0).max(0.0);
            let x = from.re.clamp(at.re - half, at.re + half);
            Point::new(x, at.im + (from.im - at.im).signum() * LINE * 0.4)
        }
        Anchor::Start | Anchor::End => at,
    }
}

/// Places beside the curve with what speaks against each, and the point of the curve that the name belongs to.
fn places(name: &str, own: &[Point], others: &[Point]) -> Vec<(Place, usize, Point)> {
    let half = text_width(name) / 2.0;
    let stride = (own.len() / PLACES).max(1);
    let mut places = Vec::new();
    // Squares compare as distances do, without a root for each of some hundred thousand pairs.
    let nearest = |points: &[Point], squared: &dyn Fn(&Point) -> f64| {
        points.iter().map(squared).fold(f64::INFINITY, f64::min).sqrt()
    };
    for from in own.iter().step_by(stride) {
        let crossing = nearest(others, &|other| (other - from).norm_sqr());
        for (rank, far) in [2.3, 4.0, 6.5, 9.5].into_iter().enumerate() {
            let around = [
                (Point::new(0.0, far), Anchor::Middle),
                (Point::new(0.0, -far), Anchor::Middle),
                (Point::new(far * 0.7, far * 0.6), Anchor::Start),
                (Point::new(-far * 0.7, far * 0.6), Anchor::End),
                (Point::new(far * 0.7, -far * 0.6), Anchor::Start),
                (Point::new(-far * 0.7, -far * 0.6), Anchor::End),
            ];
            for (off, anchor) in around {
                let at = from + off;
                let middle = match anchor {
                    Anchor::Start => at.re + half,
                    Anchor::Middle => at.re,
                    Anchor::End => at.re - half,
                };
                let to_text = |point: &Point| {
                    let (x, y) = ((point.re - middle).abs() - half, (point.im - at.im).abs() - LINE / 2.0);
                    x.max(0.0).powi(2) + y.max(0.0).powi(2)
                };
                let (to_own, to_others) = (nearest(own, &to_text), nearest(others, &to_text));
                // The name of a curve must not be read as that of another, nor its point lie where they cross.
                let unclear = to_own + CLEAR - to_others;
                let mut cost = if unclear > 0.0 { 30 + (unclear * 20.0) as usize } else { 0 };
                if crossing < 2.0 {
                    cost += 40;
                }
                places.push(((at, anchor), cost + 12 * rank, *from));
            }
        }
    }
    places
}
