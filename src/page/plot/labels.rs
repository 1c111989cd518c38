//! Where does a label stand, so that it covers neither curves nor other labels?

use super::super::figure::{Anchor, Extent, Figure, Ink, Mark, Point, Stroke};
use super::number::text_width;

/// Height of a line of text in millimetres.
pub(crate) const LINE: f64 = 3.6;
/// Curves are felt at points this far apart.
const FEELER: f64 = 0.8;
/// A label on another is as bad as one on this many points of curves.
const COLLISION: usize = 1000;
/// A point of a curve under a name, against what else speaks against a place.
const LINE_COST: usize = 25;

/// A place where a label may stand.
pub(crate) type Place = (Point, Anchor);

/// What is on the page already, and has to be seen.
pub(crate) struct Labels {
    bounds: Extent,
    taken: Vec<Extent>,
    felt: Vec<Point>,
    /// Whether a text on a line hides it.
    hides: bool,
}

impl Labels {
    /// Labels go inside these bounds, and beside what the figure shows in them.
    pub fn new(bounds: Extent) -> Self {
        Labels { bounds, taken: Vec::new(), felt: Vec::new(), hides: false }
    }

    /// Labels go anywhere, and are on white where they must lie on a line.
    pub fn anywhere() -> Self {
        Labels { hides: true, ..Labels::new(Extent::about(Point::default(), 1e4)) }
    }

    /// A rectangle that has to be seen.
    pub fn avoid_area(&mut self, area: Extent) {
        self.taken.push(area);
    }

    /// A curve that should be seen.
    pub fn avoid_path(&mut self, points: &[Point]) {
        for pair in points.windows(2) {
            let way = pair[1] - pair[0];
            let steps = (way.norm() / FEELER).ceil().clamp(1.0, 1000.0) as usize;
            self.felt.extend((0..=steps).map(|step| pair[0] + way * (step as f64 / steps as f64)));
        }
    }

    /// A sign that has to be seen.
    pub fn avoid_sign(&mut self, at: Point, radius: f64) {
        self.taken.push(Extent::about(at, radius));
    }

    /// Writes a text at the best of these places, the first of equals, on white where it covers cells.
    pub fn write(&mut self, figure: &mut Figure, text: &str, places: &[Place]) -> Option<Place> {
        let cost = |place: &&Place| self.cost(&area(text, place));
        let best = *places.iter().min_by_key(cost)?;
        let area = area(text, &best);
        let covers = |mark: &Mark| match mark {
            Mark::Rectangles { corners, .. } => corners.iter().any(|&(low, high)| area.touches(&Extent { low, high })),
            _ => false,
        };
        let hides = self.hides && self.felt.iter().any(|point| area.contains(*point));
        if hides || figure.marks.iter().any(covers) {
            figure.rectangles(vec![(area.low, area.high)], Ink::Shade(0));
        }
        figure.text(best.0, text, best.1);
        self.taken.push(area);
        Some(best)
    }

    /// The best of places that have costs of their own, with its cost in all; the first of equals.
    pub fn best(&self, text: &str, places: impl Iterator<Item = (Place, usize)>) -> Option<(usize, usize)> {
        let costs = places.map(|(place, own)| own + LINE_COST * self.cost(&area(text, &place)));
        costs.enumerate().min_by_key(|(_, cost)| *cost)
    }

    /// Writes a text at the best of these places, unless each lies on another text or sign or leaves the bounds.
    pub fn write_if_free(&mut self, figure: &mut Figure, text: &str, places: &[Place]) -> Option<Place> {
        let is_free = |place: &&Place| self.cost(&area(text, place)) < COLLISION;
        let free: Vec<Place> = places.iter().filter(is_free).copied().collect();
        self.write(figure, text, &free)
    }

    /// Writes texts that belong together, such as the numbers of an axis: each at its place of the best row of places.
    pub fn write_row(&mut self, figure: &mut Figure, texts: &[String], rows: &[Vec<Place>]) {
        let cost = |row: &&Vec<Place>| {
            let areas: Vec<Extent> = texts.iter().zip(row.iter()).map(|(text, place)| area(text, place)).collect();
            let neighbours = areas.windows(2).filter(|pair| pair[0].touches(&pair[1])).count();
            areas.iter().map(|area| self.cost(area)).sum::<usize>() + COLLISION * neighbours
        };
        for (text, place) in texts.iter().zip(rows.iter().min_by_key(cost).into_iter().flatten()) {
            self.write(figure, text, &[*place]);
        }
    }

    /// Writes the name of a point beside it, farther off with a thin line to it where there is no room nearer, and not
    /// at all where there is none.
    pub fn name_point(&mut self, figure: &mut Figure, text: &str, at: Point) {
        let ring = |far: f64| {
            let (slant, up) = (far * 0.75, far.max(2.6));
            [
                (far, 0.0, Anchor::Start),
                (slant, up, Anchor::Start),
                (slant, -up, Anchor::Start),
                (-far, 0.0, Anchor::End),
                (-slant, up, Anchor::End),
                (-slant, -up, Anchor::End),
                (0.0, up, Anchor::Middle),
                (0.0, -up, Anchor::Middle),
            ]
            .map(|(right, up, anchor)| (at + Point::new(right, up), anchor))
        };
        let places: Vec<Place> = [1.8, 3.4, 5.0, 8.0, 11.0].into_iter().flat_map(ring).collect();
        let Some((end, _)) = self.write_if_free(figure, text, &places) else { return };
        let way = end - at;
        if way.norm() > 4.5 {
            let along = way / way.norm();
            let reach = way - along * if way.re.abs() < 0.1 { 1.9 } else { 0.5 };
            figure.line(at + along * 1.0, at + reach, Stroke::solid(Ink::Grey, 0.15));
        }
    }

    fn cost(&self, area: &Extent) -> usize {
        let outside = !(self.bounds.contains(area.low) && self.bounds.contains(area.high));
        let taken = self.taken.iter().filter(|taken| taken.touches(area)).count();
        let felt = self.felt.iter().filter(|point| area.contains(**point)).count();
        COLLISION * (taken + usize::from(outside)) + felt
    }
}

/// What a text covers, with a little air.
pub(crate) fn area(text: &str, (at, anchor): &Place) -> Extent {
    let width = text_width(text);
    let low = Point::new(at.re - anchor.before(width) - 0.4, at.im - LINE / 2.0 + 0.1);
    Extent { low, high: low + Point::new(width + 0.8, LINE - 0.2) }
}
