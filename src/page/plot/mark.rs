//! How is a point marked on a plot, and named?

use super::super::figure::{Figure, Ink, Point, Stroke};
use super::super::number::decimal;
use super::frame::Frame;
use super::labels::Labels;

/// A point that is marked, in the units of the axes.
#[derive(Clone, Debug)]
pub struct PointMark {
    /// Where.
    pub at: (f64, f64),
    /// What is written beside it, in plain text; nothing where it is empty or has no room.
    pub label: String,
    /// A value that is written beside it in place of a label, counted as those of its map.
    pub value: Option<f64>,
    /// The name of its kind in the legend; none where it is empty.
    pub series: String,
    /// Colour.
    pub ink: Ink,
    /// Whether it is a dot; else a ring.
    pub filled: bool,
}

impl PointMark {
    /// A black dot.
    pub fn dot(at: (f64, f64), label: impl Into<String>) -> Self {
        PointMark { at, label: label.into(), value: None, series: String::new(), ink: Ink::Black, filled: true }
    }

    /// A black ring: exact zeros, and points that are only compared with.
    pub fn ring(at: (f64, f64), label: impl Into<String>) -> Self {
        PointMark { filled: false, ..PointMark::dot(at, label) }
    }

    /// The same mark with a name of its kind in the legend.
    pub fn of(self, series: impl Into<String>) -> Self {
        PointMark { series: series.into(), ..self }
    }

    /// The same mark with this value of its map beside it.
    pub fn valued(self, value: f64) -> Self {
        PointMark { value: Some(value), ..self }
    }

    /// What is written beside it.
    fn words(&self) -> String {
        self.value.map_or_else(|| self.label.clone(), |value| format!("≈ {}", decimal(value)))
    }

    pub(super) fn sign(&self, figure: &mut Figure, at: Point) {
        let fill = if self.filled { self.ink } else { Ink::Shade(0) };
        figure.circle(at, 0.8, Stroke::solid(self.ink, 0.3), Some(fill));
    }
}

/// Draws the marked points that lie in the frame, then their names.
pub(super) fn draw_marks(figure: &mut Figure, marks: &[PointMark], frame: &Frame, labels: &mut Labels) {
    let placed = marks.iter().filter_map(|mark| Some((mark, frame.at(mark.at)?)));
    let placed: Vec<(&PointMark, Point)> = placed.filter(|(_, at)| frame.area.contains(*at)).collect();
    for (mark, at) in &placed {
        mark.sign(figure, *at);
        labels.avoid_sign(*at, 0.9);
    }
    for (words, at) in placed.iter().map(|(mark, at)| (mark.words(), at)).filter(|(words, _)| !words.is_empty()) {
        labels.name_point(figure, &words, *at);
    }
}
