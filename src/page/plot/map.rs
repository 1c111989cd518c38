//! How do values lie over a plane? Cells in shades of grey, the darker the higher, and the bar of their scale.

use std::collections::BTreeMap;

use super::super::figure::{Anchor, Extent, Figure, Ink, Point, Stroke};
use super::axis::{Axis, Ruler};
use super::contour::contour;
use super::curve::{Curve, pieces};
use super::frame::{BELOW, Frame, LABEL_ABOVE, LABEL_UP, WIDTH};
use super::head::{Head, Key};
use super::labels::Labels;
use super::mark::{PointMark, draw_marks};
use super::number::text_width;
use super::{HEIGHT, STEPS, draw_pieces};

/// Values over a grid of cells.
#[derive(Clone, Debug)]
pub struct Map {
    /// Heading, in plain text.
    pub title: String,
    /// To the right; its range is that of the outer edges of the cells, which divide it evenly on the page.
    pub x: Axis,
    /// Upwards, likewise.
    pub y: Axis,
    /// What is shown, and the scale of its shades.
    pub value: Axis,
    /// The values in rows from below, each from the left; where one is not finite or is missing, the cell is crossed.
    pub rows: Vec<Vec<f64>>,
    /// Curves drawn upon the cells.
    pub curves: Vec<Curve>,
    /// Marked points.
    pub marks: Vec<PointMark>,
}

/// The shades in per cent black, and how many of them: more are not told apart.
const SHADES: (f64, f64) = (4.0, 84.0);
const LEVELS: f64 = 40.0;
/// The bar of the scale.
const BAR: f64 = 5.0;
const BAR_GAP: f64 = 4.0;
/// Contour lines that stay within this are points.
const SHORTEST: f64 = 0.1;
/// Shorter contour lines than this have no name; the scale tells their values too.
const LONG_ENOUGH: f64 = 35.0;
/// Places along a contour line that are tried for its value.
const NAME_PLACES: usize = 12;
/// Cells reach this far under the next, so that no seam shows between them.
const OVERLAP: f64 = 0.06;
/// More columns or rows than this are not drawn; their number is the caller's to choose.
const MOST_CELLS: usize = 400;

impl Map {
    /// The drawing, 112 mm wide and about 70 mm high, with a contour line at each tick of the scale.
    pub fn figure(&self) -> Figure {
        let in_inches = self.in_inches().map(|map| Box::new(map.drawn()));
        Figure { in_inches, ..self.drawn() }
    }

    /// The same in inches and pounds; none where no axis has a unit that changes.
    fn in_inches(&self) -> Option<Map> {
        let [(right, x), (up, y), (factor, value)] = Axis::all_in_inches([&self.x, &self.y, &self.value])?;
        let mut map = Map { x, y, value, ..self.clone() };
        let scale = |at: &mut (f64, f64)| *at = (at.0 * right, at.1 * up);
        map.rows.iter_mut().flatten().for_each(|value| *value *= factor);
        map.curves.iter_mut().flat_map(|curve| &mut curve.points).for_each(scale);
        for mark in &mut map.marks {
            scale(&mut mark.at);
            mark.value = mark.value.map(|value| value * factor);
        }
        Some(map)
    }

    fn drawn(&self) -> Figure {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0).min(MOST_CELLS);
        let rows = self.rows.len().min(MOST_CELLS);
        let values = self.rows.iter().flatten().copied();
        let value = self.value.ruler(values, STEPS.1);
        let of_cells = |axis: &Axis, cells: usize, steps: usize| match axis.range {
            Some(_) => axis.ruler([], steps),
            None => Axis { range: Some((0.0, cells.max(1) as f64)), ..axis.clone() }.ruler([], steps),
        };
        let keys = Key::all(&self.curves, &self.marks);
        let head = Head::new(&self.title, &keys, WIDTH);
        let numbers = value.ticks.iter().map(|tick| text_width(&tick.label)).fold(0.0, f64::max);
        let right = BAR_GAP + BAR + numbers + 2.0;
        let (x, y) = (of_cells(&self.x, columns, STEPS.0), of_cells(&self.y, rows, STEPS.1));
        let frame = Frame::new(x, y, HEIGHT, right);
        let mut figure = Figure::new(WIDTH, BELOW + HEIGHT + LABEL_ABOVE + head.height());
        head.draw(&mut figure);
        self.draw_cells(&mut figure, &frame.area, &value, (columns, rows));
        let mut labels = Labels::new(frame.area);
        let contours = self.draw_contours(&mut figure, &frame.area, &value, (columns, rows), &mut labels);
        for curve in &self.curves {
            let run = pieces(curve.points.iter().map(|point| frame.at(*point)), &frame.area);
            draw_pieces(&mut figure, run, curve, &mut labels);
        }
        frame.axes(&mut figure, &self.x.words(), &self.y.words());
        draw_bar(&mut figure, &frame.area, &value);
        let end = Point::new(WIDTH - 2.0, frame.area.high.im + LABEL_UP);
        figure.text(end, self.value.words(), Anchor::End);
        draw_marks(&mut figure, &self.marks, &frame, &mut labels);
        for (name, line) in contours {
            let stride = (line.len() / NAME_PLACES).max(1);
            let inner = line.iter().skip(stride / 2).step_by(stride);
            let places: Vec<_> = inner.map(|at| (*at, Anchor::Middle)).collect();
            labels.write_if_free(&mut figure, &name, &places);
        }
        figure
    }

    /// Draws the line of each value of the scale, black on white so that it is seen on every shade; gives names and lines.
    fn draw_contours(
        &self,
        figure: &mut Figure,
        area: &Extent,
        value: &Ruler,
        (columns, rows): (usize, usize),
        labels: &mut Labels,
    ) -> Vec<(String, Vec<Point>)> {
        let size = area.high - area.low;
        let cell = Point::new(size.re / columns.max(1) as f64, size.im / rows.max(1) as f64);
        let values: Vec<Vec<f64>> =
            self.rows.iter().take(rows).map(|row| row.iter().take(columns).copied().collect()).collect();
        let mut named = Vec::new();
        for tick in &value.ticks {
            for line in contour(&values, tick.value) {
                let on_page =
                    |at: &Point| Some(area.low + Point::new((at.re + 0.5) * cell.re, (at.im + 0.5) * cell.im));
                // Where a value of the grid is that of the line, there is a line of no length.
                let long = |run: &Vec<Point>| run.iter().any(|at| (at - run[0]).norm() > SHORTEST);
                for run in pieces(line.iter().map(on_page), area).into_iter().filter(long) {
                    figure.path(run.clone(), Stroke::solid(Ink::Shade(0), 0.5));
                    figure.path(run.clone(), Stroke::solid(Ink::Black, 0.2));
                    labels.avoid_path(&run);
                    if run.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum::<f64>() > LONG_ENOUGH {
                        named.push((tick.label.clone(), run));
                    }
                }
            }
        }
        named
    }

    /// Neighbours of one shade in a row are one rectangle, and all of one shade are one mark.
    fn draw_cells(&self, figure: &mut Figure, area: &Extent, value: &Ruler, (columns, rows): (usize, usize)) {
        let size = area.high - area.low;
        let (wide, high) = (size.re / columns.max(1) as f64, size.im / rows.max(1) as f64);
        let mut of_shade: BTreeMap<u8, Vec<(Point, Point)>> = BTreeMap::new();
        let mut crossed = Vec::new();
        for (index, row) in self.rows.iter().take(rows).enumerate() {
            let shades: Vec<Option<u8>> = (0..columns).map(|column| shade(value, *row.get(column)?)).collect();
            let mut start = 0;
            for run in shades.chunk_by(|a, b| a == b) {
                let low = area.low + Point::new(wide * start as f64, high * index as f64);
                let far = Point::new(low.re + wide * run.len() as f64, low.im + high);
                match run[0] {
                    Some(percent) => of_shade.entry(percent).or_default().push((low, reach_under(far, area))),
                    None => crossed.push((low, far)),
                }
                start += run.len();
            }
        }
        for (percent, corners) in of_shade {
            figure.rectangles(corners, Ink::Shade(percent));
        }
        let thin = Stroke::solid(Ink::Grey, 0.1);
        for &(low, high) in &crossed {
            figure.line(low, high, thin);
            figure.line(Point::new(low.re, high.im), Point::new(high.re, low.im), thin);
        }
    }
}

fn reach_under(corner: Point, area: &Extent) -> Point {
    Point::new((corner.re + OVERLAP).min(area.high.re), (corner.im + OVERLAP).min(area.high.im))
}

/// The shade of a value, at the ends of the scale beyond it.
fn shade(value: &Ruler, of: f64) -> Option<u8> {
    let level = (value.place(of)?.clamp(0.0, 1.0) * LEVELS).round() / LEVELS;
    Some((SHADES.0 + (SHADES.1 - SHADES.0) * level).round() as u8)
}

/// The bar of the scale right of the frame, as high as it.
fn draw_bar(figure: &mut Figure, area: &Extent, value: &Ruler) {
    let low = Point::new(area.high.re + BAR_GAP, area.low.im);
    let high = Point::new(low.re + BAR, area.high.im);
    let level = |part: f64| low.im + (high.im - low.im) * part;
    for step in 0..=LEVELS as usize {
        let part = step as f64 / LEVELS;
        // Each shade stands for the values that are rounded to it.
        let ends = [part - 0.5 / LEVELS, part + 0.5 / LEVELS].map(|end| level(end.clamp(0.0, 1.0)));
        let percent = (SHADES.0 + (SHADES.1 - SHADES.0) * part).round() as u8;
        let top = (ends[1] + OVERLAP).min(high.im);
        figure.rectangles(vec![(Point::new(low.re, ends[0]), Point::new(high.re, top))], Ink::Shade(percent));
    }
    let thin = Stroke::solid(Ink::Black, 0.2);
    figure.polygon(vec![low, Point::new(high.re, low.im), high, Point::new(low.re, high.im)], thin, None);
    let small = value.small.iter().map(|value| (*value, None));
    for (at, label) in value.ticks.iter().map(|tick| (tick.value, Some(&tick.label))).chain(small) {
        let Some(part) = value.place(at) else { continue };
        let at = Point::new(high.re, level(part.clamp(0.0, 1.0)));
        figure.line(at, at + Point::new(if label.is_some() { 0.9 } else { -0.7 }, 0.0), thin);
        if let Some(label) = label {
            figure.text(at + Point::new(1.6, 0.0), label.clone(), Anchor::Start);
        }
    }
}
