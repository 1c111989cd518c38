//! What is above a plot? Its title, and the legend in rows.

use super::super::figure::{Anchor, Figure, Point};
use super::Curve;
use super::frame::EDGE;
use super::labels::LINE;
use super::mark::PointMark;
use super::names::widest;
use super::number::text_width;

/// Length of the sample of a curve in the legend.
const SAMPLE: f64 = 9.0;

/// An entry of the legend: a curve, or the sign of a series of points.
pub(super) enum Key<'a> {
    Line(&'a Curve),
    Sign(&'a PointMark),
}

impl<'a> Key<'a> {
    /// The named curves, and the named series of points, each once.
    pub fn all(curves: impl IntoIterator<Item = &'a Curve>, marks: &'a [PointMark]) -> Vec<Key<'a>> {
        let mut keys: Vec<Key> = curves.into_iter().filter(|curve| !curve.name.is_empty()).map(Key::Line).collect();
        for (index, mark) in marks.iter().enumerate() {
            let is_new = marks[..index].iter().all(|other| other.series != mark.series);
            if !mark.series.is_empty() && is_new {
                keys.push(Key::Sign(mark));
            }
        }
        keys
    }

    fn name(&self) -> &str {
        match self {
            Key::Line(curve) => &curve.name,
            Key::Sign(mark) => &mark.series,
        }
    }

    fn sample(&self) -> f64 {
        if matches!(self, Key::Line(_)) { SAMPLE } else { 2.5 }
    }
}

/// What is above the frame, laid out before the height of the page is known.
pub(super) struct Head<'a> {
    title: Vec<String>,
    rows: Vec<Vec<&'a Key<'a>>>,
    width: f64,
}

impl<'a> Head<'a> {
    /// The title in lines and the legend in rows that fit the width.
    pub fn new(title: &str, keys: &'a [Key<'a>], width: f64) -> Self {
        let mut lines: Vec<String> = Vec::new();
        for word in title.split_whitespace() {
            match lines.last_mut() {
                // Bold letters are wider.
                Some(line) if text_width(line) * 1.1 + text_width(word) * 1.1 < width - 4.0 * EDGE => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        let mut rows: Vec<Vec<&Key>> = Vec::new();
        for key in keys {
            match rows.last_mut() {
                Some(row) if row_width(row) + row_width(&[key]) < width - 2.0 * EDGE => row.push(key),
                _ => rows.push(vec![key]),
            }
        }
        Head { title: lines, rows, width }
    }

    /// Its height in millimetres.
    pub fn height(&self) -> f64 {
        (self.title.len() + self.rows.len()) as f64 * (LINE + 0.6) + EDGE
    }

    /// Draws it at the top of the page.
    pub fn draw(&self, figure: &mut Figure) {
        let mut y = figure.height - EDGE - LINE / 2.0;
        for line in &self.title {
            figure.heading(Point::new(self.width / 2.0, y), line.clone());
            y -= LINE + 0.6;
        }
        for row in &self.rows {
            let mut x = (self.width - row_width(row)) / 2.0 + 2.0;
            for key in row {
                match key {
                    Key::Line(curve) => {
                        let (from, to) = (Point::new(x, y), Point::new(x + SAMPLE, y));
                        figure.line(from, to, curve.stroke());
                    }
                    Key::Sign(mark) => mark.sign(figure, Point::new(x + 1.2, y)),
                }
                figure.text(Point::new(x + key.sample() + 1.2, y), key.name(), Anchor::Start);
                x += row_width(&[key]);
            }
            y -= LINE + 0.6;
        }
    }
}

fn row_width(row: &[&Key]) -> f64 {
    row.iter().map(|key| key.sample() + text_width(&widest(key.name())) + 6.0).sum()
}
