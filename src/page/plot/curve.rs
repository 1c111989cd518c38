//! Which points of a curve are drawn? Those inside the frame that change what is seen.

use super::super::figure::{Dash, Extent, Ink, Point, Stroke};

/// A curve through points in the units of the axes; a value that is not finite breaks it.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its name in the legend; none where it is empty.
    pub name: String,
    /// Points in order.
    pub points: Vec<(f64, f64)>,
    /// Colour.
    pub ink: Ink,
    /// How the line is broken.
    pub dash: Dash,
    /// Width of the line in millimetres.
    pub width: f64,
}

impl Curve {
    /// A curve in the style of its number: no two of the first twenty share both colour and dash, and neighbours
    /// differ in both, so that they can be distinguished in grey too.
    pub fn new(number: usize, name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        const INKS: [Ink; 5] = [Ink::Blue, Ink::Orange, Ink::Green, Ink::Red, Ink::Black];
        const DASHES: [Dash; 4] = [Dash::Solid, Dash::Dashed, Dash::DashDotted, Dash::Dotted];
        Curve { name: name.into(), points, ink: INKS[number % 5], dash: DASHES[number % 4], width: 0.45 }
    }

    /// The same values as stairs: each holds until the next begins.
    pub fn stepped(mut self) -> Self {
        let mut stairs: Vec<(f64, f64)> = Vec::with_capacity(2 * self.points.len());
        for (x, y) in self.points {
            if let Some((_, before)) = stairs.last().copied() {
                stairs.push((x, before));
            }
            stairs.push((x, y));
        }
        self.points = stairs;
        self
    }

    pub(super) fn stroke(&self) -> Stroke {
        Stroke { ink: self.ink, width: self.width, dash: self.dash }
    }
}

/// Points of curves lie on a lattice of this many to a millimetre.
///
/// The last digits of sines differ from machine to machine. On the lattice they are gone, and with them the chance that they choose
/// between two places for a name that are equally good, or between two points that are equally far from a line.
const LATTICE: f64 = 4096.0;
/// How far below the middle of two points of the lattice the upper one begins: a value that is exactly there, such as 0 in the middle of a plot,
/// is not parted by its last digit.
const BELOW_THE_MIDDLE: f64 = 1e-6;

/// The nearest point of the lattice.
pub(super) fn snapped(point: Point) -> Point {
    let on_lattice = |value: f64| (value * LATTICE + (0.5 + BELOW_THE_MIDDLE)).floor() / LATTICE;
    Point::new(on_lattice(point.re), on_lattice(point.im))
}

/// Points that move the line by less than this, in millimetres, are omitted.
const TOLERANCE: f64 = 0.02;
/// The tolerance grows until a curve has no more points than this.
const MOST_POINTS: usize = 400;
/// It does not grow beyond this: a curve broken in hundreds of places stays so.
const COARSEST: f64 = 2.0;

/// The pieces of a curve to be drawn: broken where a point has no place, cut at the edges of the area, thinned.
pub(super) fn pieces(points: impl Iterator<Item = Option<Point>>, area: &Extent) -> Vec<Vec<Point>> {
    let points: Vec<Option<Point>> = points.collect();
    let unbroken = points.split(Option::is_none).map(|run| run.iter().copied().flatten().collect::<Vec<Point>>());
    let whole: Vec<Vec<Point>> = unbroken.flat_map(|run| clipped(&run, area)).collect();
    let mut tolerance = TOLERANCE;
    loop {
        let thin: Vec<Vec<Point>> = whole.iter().map(|run| thinned(run, tolerance)).collect();
        if tolerance >= COARSEST || thin.iter().map(Vec::len).sum::<usize>() <= MOST_POINTS {
            return thin;
        }
        tolerance *= 1.5;
    }
}

fn clipped(run: &[Point], area: &Extent) -> Vec<Vec<Point>> {
    if let [only] = run {
        return if area.contains(*only) { vec![vec![*only]] } else { Vec::new() };
    }
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    for pair in run.windows(2) {
        let Some((from, to)) = area.cut(pair[0], pair[1]) else {
            open = false;
            continue;
        };
        match pieces.last_mut() {
            Some(piece) if open && from == pair[0] => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
        open = to == pair[1];
    }
    pieces
}

/// Fewer points of the same line, by Ramer, Douglas and Peucker; its outermost points stay.
fn thinned(run: &[Point], tolerance: f64) -> Vec<Point> {
    let Some(last) = run.len().checked_sub(1) else { return Vec::new() };
    let mut kept = vec![false; run.len()];
    let outermost = |key: fn(&Point) -> f64| {
        let best = |a: &usize, b: &usize| key(&run[*a]).total_cmp(&key(&run[*b]));
        (0..run.len()).max_by(best).unwrap_or(0)
    };
    let corners = [outermost(|p| p.re), outermost(|p| -p.re), outermost(|p| p.im), outermost(|p| -p.im)];
    let mut fixed = vec![0, last];
    fixed.extend(corners);
    fixed.sort_unstable();
    fixed.dedup();
    fixed.iter().for_each(|index| kept[*index] = true);
    let mut open: Vec<(usize, usize)> = fixed.windows(2).map(|pair| (pair[0], pair[1])).collect();
    while let Some((from, to)) = open.pop() {
        let away = |index: &usize| square_of_distance(run[*index], run[from], run[to]);
        let farthest = (from + 1..to).map(|index| (away(&index), index)).max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, index)) = farthest.filter(|(away, _)| *away > tolerance * tolerance) {
            kept[index] = true;
            open.extend([(from, index), (index, to)]);
        }
    }
    run.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// From a point to a line between two others. Squared: a square root is not the same on every machine, and could part two that are equally far.
fn square_of_distance(point: Point, from: Point, to: Point) -> f64 {
    let (way, arm) = (to - from, point - from);
    let length = way.norm_sqr();
    let part = if length > 0.0 { ((arm * way.conj()).re / length).clamp(0.0, 1.0) } else { 0.0 };
    (arm - way * part).norm_sqr()
}
