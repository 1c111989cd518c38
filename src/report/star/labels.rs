//! Where do the names of the rays stand? Beyond their tips, farther off with a leader where there is no room.

use std::f64::consts::PI;

use crate::page::figure::{Anchor, Extent, Figure, Ink, Point, Stroke, text_width};

/// Distance between lines of a label over the size of its letters.
const LEADING: f64 = 1.1;
/// Air around a label in millimetres, and more of it beside neighbours: `1 7` is not `17`.
const AIR: f64 = 0.3;
const BESIDE: f64 = 0.9;
/// From the tip to the nearest label, and the steps farther off, in millimetres.
const NEAREST: f64 = 1.4;
const STEP: f64 = 1.5;
/// Farther off than this many steps there is no place.
const STEPS: u32 = 30;
/// A label so far from its tip is tied to it, in millimetres.
const TIED: f64 = 3.0;
/// Turned away from the ray by this many parts of 12°.
const ASIDE: [i32; 15] = [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7];
/// What it costs, in millimetres farther off, to cover an edge of the resultant, a vector, a guide, a leader; to cross a leader; to be broken once more.
const ON_RESULTANT: f64 = 40.0;
const ON_VECTOR: f64 = 14.0;
const ON_GUIDE: f64 = 0.6;
const ON_LEADER: f64 = 25.0;
const BROKEN: f64 = 0.9;
const TURNED: f64 = 0.35;

/// What a panel shows already, and has to be seen.
pub(super) struct Labels {
    half_width: f64,
    letters: f64,
    taken: Vec<Extent>,
    leaders: Vec<(Point, Point)>,
    lines: Vec<(Point, Point, f64)>,
}

/// A place for a label.
struct Place {
    cost: f64,
    lines: usize,
    area: Extent,
    leader: Option<(Point, Point)>,
}

impl Labels {
    /// Labels keep within this distance from the middle of the panel.
    pub fn new(half_width: f64, letters: f64) -> Self {
        Labels { half_width, letters, taken: Vec::new(), leaders: Vec::new(), lines: Vec::new() }
    }

    /// The width of a label.
    pub fn width(lines: &[String], letters: f64) -> f64 {
        lines.iter().map(|line| text_width(line, letters)).fold(0.0, f64::max)
    }

    /// A vector, which no label should cover.
    pub fn avoid(&mut self, from: Point, to: Point) {
        self.lines.push((from, to, ON_VECTOR));
    }

    /// The resultant by its corners.
    pub fn avoid_resultant(&mut self, corners: &[Point]) {
        let next = corners.iter().cycle().skip(1);
        self.lines.extend(corners.iter().zip(next).map(|(from, to)| (*from, *to, ON_RESULTANT)));
    }

    /// A thin line, which labels may cover where they have to.
    pub fn avoid_guide(&mut self, corners: &[Point]) {
        self.lines.extend(corners.windows(2).map(|pair| (pair[0], pair[1], ON_GUIDE)));
    }

    /// Writes the label of a ray beyond a point on its way, tied to its tip, and broken into lines in the best of these ways;
    /// nothing where there is no room.
    pub fn write(&mut self, figure: &mut Figure, ends: (Point, Point), along: Point, ways: &[Vec<String>]) {
        let mut best: Option<Place> = None;
        for step in 0..STEPS {
            let far = NEAREST + STEP * f64::from(step);
            if best.as_ref().is_some_and(|best| best.cost <= far) {
                break;
            }
            for (way, aside) in (0..ways.len()).flat_map(|way| ASIDE.map(|aside| (way, aside))) {
                let best_cost = best.as_ref().map_or(f64::INFINITY, |best| best.cost);
                // What a label covers makes a place dearer still.
                let least = far + TURNED * f64::from(aside).abs() + BROKEN * way as f64;
                if least >= best_cost {
                    continue;
                }
                let place = self.place(ends, along, (far, f64::from(aside), least), (way, &ways[way]));
                best = place.filter(|place| place.cost < best_cost).or(best);
            }
        }
        let Some(place) = best else { return };
        if let Some((from, to)) = place.leader {
            figure.line(from, to, Stroke::solid(Ink::Grey, 0.15));
            self.leaders.push((from, to));
        }
        let middle = (place.area.low + place.area.high) / 2.0;
        let lines = &ways[place.lines];
        for (index, line) in lines.iter().enumerate() {
            let up = (lines.len() - 1) as f64 / 2.0 - index as f64;
            let at = middle + Point::new(0.0, up * LEADING * self.letters);
            figure.text(at, line.clone(), Anchor::Middle);
        }
        self.taken.push(place.area);
    }

    /// The place so far from its beginning, turned aside; none where another label is or the panel ends.
    fn place(
        &self,
        (tip, begin): (Point, Point),
        along: Point,
        (far, aside, least): (f64, f64, f64),
        (way, lines): (usize, &[String]),
    ) -> Option<Place> {
        let towards = along * Point::cis(aside * PI / 15.0);
        let width = Labels::width(lines, self.letters);
        let height = self.letters * (1.0 + LEADING * lines.len().saturating_sub(1) as f64);
        let half = Point::new(width / 2.0, height / 2.0);
        // The side of the label that is turned to the tip touches the end of the way.
        let lean = |part: f64| (1.6 * part).clamp(-1.0, 1.0);
        let middle = begin + towards * far + Point::new(half.re * lean(towards.re), half.im * lean(towards.im));
        let area = Extent { low: middle - half, high: middle + half };
        let is_inside = middle.re.abs() + half.re <= self.half_width;
        let with_air = area.grown(AIR);
        let beside = Point::new(BESIDE, 0.0);
        let apart = Extent { low: area.low - beside, high: area.high + beside };
        if !is_inside || self.taken.iter().any(|taken| taken.meets(&apart)) {
            return None;
        }
        let leader = (far + (begin - tip).norm() > TIED).then(|| leader(tip, &area));
        if let Some((from, to)) = leader
            && self.taken.iter().any(|taken| taken.is_crossed(from, to))
        {
            return None;
        }
        let covered = self.lines.iter().filter(|(from, to, _)| with_air.is_crossed(*from, *to));
        let leaders = self.leaders.iter().filter(|(from, to)| {
            with_air.is_crossed(*from, *to) || leader.is_some_and(|leader| cross(leader, (*from, *to)))
        });
        let cost = least + covered.map(|(_, _, cost)| cost).sum::<f64>() + ON_LEADER * leaders.count() as f64;
        Some(Place { cost, lines: way, area, leader })
    }
}

/// From beside the tip to the nearest point of the label.
fn leader(tip: Point, label: &Extent) -> (Point, Point) {
    let near = label.grown(AIR);
    let end = Point::new(tip.re.clamp(near.low.re, near.high.re), tip.im.clamp(near.low.im, near.high.im));
    let way = end - tip;
    (tip + way / way.norm().max(1e-6) * 0.7, end)
}

/// Whether two lines cross.
fn cross(one: (Point, Point), other: (Point, Point)) -> bool {
    let side = |(from, to): (Point, Point), point: Point| {
        let (way, to) = (to - from, point - from);
        way.re * to.im - way.im * to.re
    };
    side(one, other.0) * side(one, other.1) < 0.0 && side(other, one.0) * side(other, one.1) < 0.0
}
