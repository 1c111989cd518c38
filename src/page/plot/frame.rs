//! What stands around a plot? Axes with their ticks and labels, and the grid.

use super::super::figure::{Anchor, Extent, Figure, Ink, Point, Stroke};
use super::axis::{Ruler, Scale};
use super::curve::snapped;
use super::labels::LINE;
use super::number::text_width;

/// Width of a plot in millimetres.
///
/// Its letters have eleven pixels on a screen of 390, the margins of the page left out.
pub(super) const WIDTH: f64 = 96.0;
/// Air at the edges of the page.
pub(super) const EDGE: f64 = 2.0;
/// From the frame down to the numbers of its axis, and to its label.
const NUMBERS_BELOW: f64 = 3.0;
const LABEL_BELOW: f64 = 7.4;
/// The rectangle between the axes.
pub(super) struct Frame {
    pub area: Extent,
    pub x: Ruler,
    pub y: Ruler,
}

/// Height of what is below the frame, and between the frame and the head.
pub(super) const BELOW: f64 = LABEL_BELOW + LINE / 2.0 + 1.0;
pub(super) const LABEL_ABOVE: f64 = 5.0;
pub(super) const LABEL_UP: f64 = 3.4;

impl Frame {
    /// A frame of this height, as wide as the page leaves it, with some room kept at the right.
    pub fn new(x: Ruler, y: Ruler, height: f64, right: f64) -> Self {
        let numbers = y.ticks.iter().map(|tick| text_width(&tick.label)).fold(0.0, f64::max);
        let first = x.ticks.first().map_or(0.0, |tick| text_width(&tick.label) / 2.0);
        let last = x.ticks.last().map_or(0.0, |tick| text_width(&tick.label) / 2.0);
        let left = (EDGE + numbers + 1.6).max(EDGE + first).min(WIDTH / 3.0);
        let (low, high) = (Point::new(left, BELOW), Point::new(WIDTH - right - EDGE - last.max(1.0), BELOW + height));
        // A point on an edge stays on it.
        Frame { area: Extent { low: snapped(low), high: snapped(high) }, x, y }
    }

    /// Where a point is on the page; none where it has no place.
    pub fn at(&self, (x, y): (f64, f64)) -> Option<Point> {
        Some(snapped(Point::new(self.right(&self.x, x)?, self.up(&self.y, y)?)))
    }

    fn right(&self, ruler: &Ruler, value: f64) -> Option<f64> {
        Some(self.area.low.re + (self.area.high.re - self.area.low.re) * ruler.place(value)?)
    }

    fn up(&self, ruler: &Ruler, value: f64) -> Option<f64> {
        Some(self.area.low.im + (self.area.high.im - self.area.low.im) * ruler.place(value)?)
    }

    /// A line across the frame at a value of x, or of y.
    pub fn across(&self, value: f64, upright: bool) -> Option<(Point, Point)> {
        let Extent { low, high } = self.area;
        let ends = if upright {
            let x = self.right(&self.x, value)?;
            (Point::new(x, low.im), Point::new(x, high.im))
        } else {
            let y = self.up(&self.y, value)?;
            (Point::new(low.re, y), Point::new(high.re, y))
        };
        (self.area.contains(ends.0) && self.area.contains(ends.1)).then_some(ends)
    }

    /// The grid in light grey, the lines of zero darker.
    pub fn grid(&self, figure: &mut Figure) {
        for (ruler, upright) in [(&self.x, true), (&self.y, false)] {
            for value in ruler.ticks.iter().map(|tick| tick.value) {
                if let Some((from, to)) = self.across(value, upright) {
                    figure.line(from, to, Stroke::solid(Ink::Shade(14), 0.15));
                }
            }
        }
        for (ruler, upright) in [(&self.x, true), (&self.y, false)] {
            let zero = self.across(0.0, upright).filter(|_| ruler.scale() == Scale::Linear);
            if let Some((from, to)) = zero {
                figure.line(from, to, Stroke::solid(Ink::Shade(55), 0.25));
            }
        }
    }

    /// The outline, ticks with numbers, and the labels of both axes; numbers that have no room are omitted.
    pub fn axes(&self, figure: &mut Figure, x_label: &str, y_label: &str) {
        let Extent { low, high } = self.area;
        let corners = vec![low, Point::new(high.re, low.im), high, Point::new(low.re, high.im)];
        let thin = Stroke::solid(Ink::Black, 0.2);
        figure.polygon(corners, thin, None);
        for (ruler, upright) in [(&self.x, true), (&self.y, false)] {
            let inwards = if upright { Point::i() } else { Point::new(1.0, 0.0) };
            for at in ruler.small.iter().filter_map(|value| self.across(*value, upright)) {
                figure.line(at.0, at.0 + inwards * 0.9, thin);
            }
            let mut free = f64::NEG_INFINITY;
            for tick in &ruler.ticks {
                let Some((at, _)) = self.across(tick.value, upright) else { continue };
                figure.line(at, at - inwards * 0.9, thin);
                let (start, half) = if upright { (at.re, text_width(&tick.label) / 2.0) } else { (at.im, 1.5) };
                if start - half < free {
                    continue;
                }
                free = start + half + if upright { 1.2 } else { 0.2 };
                if upright {
                    figure.text(at - Point::new(0.0, NUMBERS_BELOW), tick.label.clone(), Anchor::Middle);
                } else {
                    figure.text(at - Point::new(1.5, 0.0), tick.label.clone(), Anchor::End);
                }
            }
        }
        let middle = Point::new((low.re + high.re) / 2.0, low.im - LABEL_BELOW);
        figure.text(middle, x_label, Anchor::Middle);
        figure.text(Point::new(EDGE, high.im + LABEL_UP), y_label, Anchor::Start);
    }
}
