//! How is a function shown? Curves over an axis, a vector that turns, and values over a plane, as drawings.
//!
//! Every drawing is a [`Figure`]: marks in millimetres that [`crate::page::svg`] and [`crate::page::tikz`] print. Values that are
//! not finite, or not positive on a logarithmic axis, have no place and break a curve; no input panics.
//!
//! ```standalone_crate
//! use crankstar::page::plot::{Axis, Curve, Plot};
//! let force = |degrees: f64| (degrees, 1200.0 * (2.0 * degrees.to_radians()).cos());
//! let mut plot = Plot::new("Order 2", Axis::angle("Crank angle θ in °", 0.0, 360.0, 90), Axis::linear("Force in N"));
//! plot.curves.push(Curve::new(0, "in-line four", (0..=360).map(f64::from).map(force).collect()));
//! let drawing = plot.figure();
//! assert!(crankstar::page::svg(&drawing, "Order 2").contains(">−1000</text>"));
//! assert!(crankstar::page::tikz(&drawing).contains("{$-$1000}"));
//! ```

mod axis;
mod contour;
pub(crate) mod curve;
mod frame;
mod head;
pub(crate) mod labels;
mod map;
mod mark;
mod names;
pub(crate) mod number;
mod polar;
pub(crate) mod stack;

pub use axis::{Axis, Ruler, Scale, Tick};
pub use curve::Curve;
pub use map::Map;
pub use mark::PointMark;
pub use polar::Polar;
pub(crate) use stack::stacked;

use super::figure::{Anchor, Dash, Figure, Ink, Point, Stroke};
use curve::pieces;
use frame::{BELOW, Frame, LABEL_ABOVE, WIDTH};
use head::{Head, Key};
use labels::Labels;
use mark::draw_marks;

/// Height of the frame in millimetres.
const HEIGHT: f64 = 54.0;
/// About this many steps between ticks.
const STEPS: (usize, usize) = (7, 6);

/// A value that is marked by a line across the frame.
#[derive(Clone, Debug)]
pub struct Rule {
    /// The value.
    pub at: f64,
    /// Whether it is a value of x, and the line upright; else of y.
    pub upright: bool,
    /// What is written beside it; nothing where it is empty.
    pub label: String,
}

/// Curves, marked points and marked values over two axes.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Heading, in plain text.
    pub title: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// Curves; later ones lie upon earlier ones.
    pub curves: Vec<Curve>,
    /// Marked points.
    pub marks: Vec<PointMark>,
    /// Marked values.
    pub rules: Vec<Rule>,
}

impl Plot {
    /// A plot with nothing in it.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Plot { title: title.into(), x, y, curves: Vec::new(), marks: Vec::new(), rules: Vec::new() }
    }

    /// Marks a zero by a ring in the ink of its curve, with one name for the zeros of several curves at one place.
    pub fn ring_zero(&mut self, at: f64, name: String, ink: Ink, series: &str) {
        let is_named = self.marks.iter().any(|mark| mark.label == name);
        let ring = PointMark::ring((at, 0.0), if is_named { String::new() } else { name });
        self.marks.push(PointMark { ink, ..ring.of(series) });
    }

    /// The drawing, 112 mm wide and about 70 mm high: curves are named where they run, and in a legend above the frame
    /// where there is no room for that.
    pub fn figure(&self) -> Figure {
        let in_inches = self.in_inches().map(|plot| Box::new(plot.drawn()));
        Figure { in_inches, ..self.drawn() }
    }

    /// The same in inches and pounds; none where neither axis has a unit that changes.
    fn in_inches(&self) -> Option<Plot> {
        let [(right, x), (up, y)] = Axis::all_in_inches([&self.x, &self.y])?;
        let mut plot = Plot { x, y, ..self.clone() };
        let scale = |at: &mut (f64, f64)| *at = (at.0 * right, at.1 * up);
        plot.curves.iter_mut().flat_map(|curve| &mut curve.points).for_each(scale);
        plot.marks.iter_mut().for_each(|mark| scale(&mut mark.at));
        plot.rules.iter_mut().for_each(|rule| rule.at *= if rule.upright { right } else { up });
        Some(plot)
    }

    fn drawn(&self) -> Figure {
        let points = || {
            let of_curves = self.curves.iter().flat_map(|curve| &curve.points).copied();
            of_curves.chain(self.marks.iter().map(|mark| mark.at))
        };
        let rules = |upright: bool| self.rules.iter().filter(move |rule| rule.upright == upright).map(|rule| rule.at);
        let x = self.x.ruler(points().map(|point| point.0).chain(rules(true)), STEPS.0);
        let y = self.y.ruler(points().map(|point| point.1).chain(rules(false)), STEPS.1);
        let frame = Frame::new(x, y, HEIGHT, 0.0);
        let mut figure = Figure::new(WIDTH, BELOW + HEIGHT + LABEL_ABOVE);
        frame.grid(&mut figure);
        let mut labels = Labels::new(frame.area);
        let drawn = self.rules.iter().filter_map(|rule| Some((rule, frame.across(rule.at, rule.upright)?)));
        let drawn: Vec<(&Rule, (Point, Point))> = drawn.collect();
        for (_, (from, to)) in &drawn {
            figure.line(*from, *to, Stroke { ink: Ink::Black, width: 0.25, dash: Dash::Dashed });
            labels.avoid_path(&[*from, *to]);
        }
        let on_page = |curve: &Curve| pieces(curve.points.iter().map(|point| frame.at(*point)), &frame.area);
        let lines: Vec<Vec<Vec<Point>>> = self.curves.iter().map(on_page).collect();
        for (curve, run) in self.curves.iter().zip(&lines) {
            draw_pieces(&mut figure, run.clone(), curve, &mut labels);
        }
        frame.axes(&mut figure, &self.x.words(), &self.y.words());
        draw_marks(&mut figure, &self.marks, &frame, &mut labels);
        for (rule, ends) in drawn.iter().filter(|(rule, _)| !rule.label.is_empty()) {
            labels.write(&mut figure, &rule.label, &beside(rule, *ends));
        }
        let homeless = names::name_curves(&mut figure, &mut labels, (&self.curves, &lines), &frame);
        let keys = Key::all(homeless, &self.marks);
        let head = Head::new(&self.title, &keys, WIDTH);
        figure.height += head.height();
        head.draw(&mut figure);
        figure
    }
}

/// Places along a marked value, on both sides of its line.
fn beside(rule: &Rule, (from, to): (Point, Point)) -> Vec<labels::Place> {
    let off = if rule.upright { Point::new(1.2, 0.0) } else { Point::new(0.0, 2.2) };
    let side = |at: Point| match rule.upright {
        true => [(at + off, Anchor::Start), (at - off, Anchor::End)],
        false => [(at + off, Anchor::End), (at - off, Anchor::End)],
    };
    [0.95, 0.85, 0.05, 0.15, 0.7, 0.3, 0.5].into_iter().flat_map(|part| side(from + (to - from) * part)).collect()
}

/// Draws the pieces of a curve; a point alone as a dot.
fn draw_pieces(figure: &mut Figure, pieces: Vec<Vec<Point>>, curve: &Curve, labels: &mut Labels) {
    for piece in pieces {
        labels.avoid_path(&piece);
        match piece[..] {
            [] => {}
            [only] => figure.circle(only, curve.width, Stroke::solid(curve.ink, 0.1), Some(curve.ink)),
            _ => figure.path(piece, curve.stroke()),
        }
    }
}
