//! How do several plots stand on one page? Below each other, as small multiples.

use super::super::figure::{Figure, Mark, Point};

/// Drawings below each other on one page.
pub(crate) fn stacked(figures: Vec<Figure>) -> Figure {
    let width = figures.iter().map(|figure| figure.width).fold(0.0, f64::max);
    let mut page = Figure::new(width, figures.iter().map(|figure| figure.height).sum());
    let mut top = page.height;
    for mut figure in figures {
        top -= figure.height;
        let way = Point::new((width - figure.width) / 2.0, top);
        figure.marks.iter_mut().for_each(|mark| shift(mark, way));
        page.marks.append(&mut figure.marks);
    }
    page
}

/// Moves a mark.
pub(crate) fn shift(mark: &mut Mark, way: Point) {
    match mark {
        Mark::Line { from, to, .. } => {
            *from += way;
            *to += way;
        }
        Mark::Circle { centre, .. } => *centre += way,
        Mark::Polygon { corners: points, .. } | Mark::Path { points, .. } => {
            points.iter_mut().for_each(|point| *point += way);
        }
        Mark::Rectangles { corners, .. } => corners.iter_mut().for_each(|(low, high)| {
            *low += way;
            *high += way;
        }),
        Mark::Text { at, .. } | Mark::Title { at, .. } => *at += way,
    }
}
