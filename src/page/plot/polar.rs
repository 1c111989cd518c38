//! Where does a vector point while it turns? The curve of its tip, to equal scales.

use super::super::Unit;
use super::super::figure::{Anchor, Dash, Extent, Figure, Ink, Point, Stroke};
use super::axis::Axis;
use super::curve::{Curve, pieces, snapped};
use super::draw_pieces;
use super::head::{Head, Key};
use super::labels::{LINE, Labels, Place};
use super::mark::PointMark;

/// The curves of the tips of vectors that begin at the centre.
#[derive(Clone, Debug)]
pub struct Polar {
    /// Heading, in plain text.
    pub title: String,
    /// What the lengths are, in which unit: with a place `{}` for the unit where one is named.
    pub label: String,
    /// What they are counted in.
    pub unit: Option<Unit>,
    /// Curves through tips `(right, up)`.
    pub curves: Vec<Curve>,
    /// Marked tips.
    pub marks: Vec<PointMark>,
    /// A length that the outer circle reaches whatever the curves are: that of other drawings that it is compared with.
    pub reach: f64,
    /// Marked directions: degrees anticlockwise from upwards, and their names.
    pub directions: Vec<(f64, String)>,
}

/// The page in millimetres: its width, the radius of the outer circle, the room around it for names.
const WIDTH: f64 = 96.0;
const RADIUS: f64 = 38.0;
const ROOM: f64 = 6.5;
/// About this many circles.
const CIRCLES: usize = 4;

impl Polar {
    /// The directions of an end view: 0° upwards, angles anticlockwise.
    pub fn new(title: impl Into<String>, label: impl Into<String>, curves: Vec<Curve>) -> Self {
        let directions = [0, 90, 180, 270].map(|degrees| (f64::from(degrees), format!("{degrees}°")));
        Polar {
            title: title.into(),
            label: label.into(),
            unit: None,
            curves,
            marks: Vec::new(),
            reach: 0.0,
            directions: directions.into(),
        }
    }

    /// Marks the crank angles 0°, 90°, 180° and 270° along a curve through equal steps of a revolution; those at one place
    /// share a mark. Nothing where the curve never leaves the centre.
    pub fn mark_quarters(&mut self, tips: &[(f64, f64)], steps: usize) {
        let farthest = tips.iter().map(|(right, up)| right.hypot(*up)).fold(0.0, f64::max);
        let mut marks: Vec<((f64, f64), Vec<String>)> = Vec::new();
        for quarter in 0..4 {
            let Some(&tip) = tips.get(quarter * steps / 4) else { continue };
            let near = |at: &(f64, f64)| (at.0 - tip.0).hypot(at.1 - tip.1) < farthest / RADIUS;
            let name = format!("{}°", 90 * quarter);
            match marks.iter_mut().find(|(at, _)| near(at)) {
                Some((_, names)) => names.push(name),
                None => marks.push((tip, vec![name])),
            }
        }
        let mark = |(at, names): ((f64, f64), Vec<String>)| PointMark::ring(at, format!("θ = {}", names.join(", ")));
        self.marks.extend(marks.into_iter().filter(|_| farthest > 0.0).map(mark));
    }

    /// The drawing, 96 mm wide and about as high.
    pub fn figure(&self) -> Figure {
        let axis = Axis { unit: self.unit, ..Axis::linear(self.label.clone()) };
        let in_inches = axis.in_inches().map(|(factor, axis)| {
            let mut polar = Polar { unit: axis.unit, reach: self.reach * factor, ..self.clone() };
            let scale = |at: &mut (f64, f64)| *at = (at.0 * factor, at.1 * factor);
            polar.curves.iter_mut().flat_map(|curve| &mut curve.points).for_each(scale);
            polar.marks.iter_mut().for_each(|mark| scale(&mut mark.at));
            Box::new(polar.drawn(&axis.words()))
        });
        Figure { in_inches, ..self.drawn(&axis.words()) }
    }

    /// The same with lengths in this unit, whose name takes the place `{}` of the label.
    pub fn counted_in(self, unit: Unit) -> Self {
        Polar { unit: Some(unit), ..self }
    }

    fn drawn(&self, label: &str) -> Figure {
        let keys = Key::all(&self.curves, &self.marks);
        let head = Head::new(&self.title, &keys, WIDTH);
        let below = ROOM + LINE + 1.5;
        let mut figure = Figure::new(WIDTH, below + 2.0 * RADIUS + ROOM + head.height());
        head.draw(&mut figure);
        let centre = snapped(Point::new(WIDTH / 2.0, below + RADIUS));
        let tips = self.curves.iter().flat_map(|curve| &curve.points).chain(self.marks.iter().map(|mark| &mark.at));
        let lengths = tips.map(|(right, up)| right.hypot(*up)).chain([0.0, self.reach]);
        let ruler = Axis::linear("").ruler(lengths.filter(|length| length.is_finite()), CIRCLES);
        // A range that lies about zero, where every vector vanishes, begins at zero here.
        let full = ruler.high;
        let at = |(right, up): (f64, f64)| {
            let tip = Point::new((right / full).clamp(-1e4, 1e4), (up / full).clamp(-1e4, 1e4));
            (right.is_finite() && up.is_finite()).then(|| snapped(centre + tip * RADIUS))
        };
        let area = Extent::about(centre, RADIUS);
        let mut labels = Labels::new(area);
        let circles: Vec<_> = ruler.ticks.iter().filter(|tick| tick.value > 0.0).collect();
        for tick in &circles {
            let ink = if tick.value >= full { Ink::Shade(55) } else { Ink::Shade(14) };
            figure.circle(centre, RADIUS * tick.value / full, Stroke::solid(ink, 0.2), None);
        }
        for way in [Point::new(RADIUS, 0.0), Point::new(0.0, RADIUS)] {
            figure.line(centre - way, centre + way, Stroke::solid(Ink::Shade(55), 0.25));
            labels.avoid_path(&[centre - way, centre + way]);
        }
        self.draw_directions(&mut figure, centre);
        for curve in &self.curves {
            let run = pieces(curve.points.iter().map(|tip| at(*tip)), &area);
            draw_pieces(&mut figure, run, curve, &mut labels);
        }
        let placed = self.marks.iter().filter_map(|mark| Some((mark, at(mark.at)?)));
        let placed: Vec<(&PointMark, Point)> = placed.filter(|(_, at)| area.contains(*at)).collect();
        for (mark, at) in &placed {
            mark.sign(&mut figure, *at);
            labels.avoid_sign(*at, 0.9);
        }
        let texts: Vec<String> = circles.iter().map(|tick| tick.label.clone()).collect();
        let of_circles: Vec<_> = circles.iter().map(|tick| along_axes(centre, RADIUS * tick.value / full)).collect();
        let rows: Vec<Vec<_>> =
            (0..PLACES).map(|side| of_circles.iter().map(|places| places[side]).collect()).collect();
        labels.write_row(&mut figure, &texts, &rows);
        // A point has more places for its name than the circles have for their row.
        for (mark, at) in placed.iter().filter(|(mark, _)| !mark.label.is_empty()) {
            labels.name_point(&mut figure, &mark.label, *at);
        }
        figure.text(Point::new(centre.re, LINE / 2.0 + 1.0), label.to_owned(), Anchor::Middle);
        figure
    }

    /// Names outside the outer circle, and a thin line to each that is not on an axis.
    fn draw_directions(&self, figure: &mut Figure, centre: Point) {
        for (degrees, name) in self.directions.iter().filter(|(degrees, _)| degrees.is_finite()) {
            let along = Point::from_polar(1.0, (degrees % 360.0 + 90.0).to_radians());
            if along.re.abs().min(along.im.abs()) > 1e-6 {
                let stroke = Stroke { ink: Ink::Grey, width: 0.2, dash: Dash::Dotted };
                figure.line(centre, centre + along * RADIUS, stroke);
            }
            let anchor = match along.re {
                x if x > 0.3 => Anchor::Start,
                x if x < -0.3 => Anchor::End,
                _ => Anchor::Middle,
            };
            figure.text(centre + along * RADIUS + Point::new(along.re * 1.5, along.im * 3.0), name.clone(), anchor);
        }
    }
}

/// Places inside a circle on both sides of the four half axes.
const PLACES: usize = 8;

fn along_axes(centre: Point, reach: f64) -> [Place; PLACES] {
    let (right, up) = (Point::new(reach - 0.7, 0.0), Point::new(0.0, reach - 2.3));
    let (aside, above) = (Point::new(0.8, 0.0), Point::new(0.0, 2.3));
    [
        (centre + right - above, Anchor::End),
        (centre + right + above, Anchor::End),
        (centre - right - above, Anchor::Start),
        (centre - right + above, Anchor::Start),
        (centre + up + aside, Anchor::Start),
        (centre + up - aside, Anchor::End),
        (centre - up + aside, Anchor::Start),
        (centre - up - aside, Anchor::End),
    ]
}
