//! How large is a drawing? As large as what is on it, with a little air.

use super::super::figure::{Extent, Figure, Mark, Point};
use super::super::plot::labels;

/// Air at the edges, in millimetres.
const AIR: f64 = 1.5;

/// The same drawing on a page that just holds it; its marks may be anywhere before.
pub(in crate::report) fn cropped(mut figure: Figure) -> Figure {
    let whole = figure.marks.iter().flat_map(reach).reduce(|all, part| all.joined(&part));
    let Some(Extent { low, high }) = whole else { return figure };
    let air = Point::new(AIR, AIR);
    let size = high - low + air * 2.0;
    (figure.width, figure.height) = (size.re, size.im);
    figure.marks.iter_mut().for_each(|mark| mark.moved(air - low));
    figure
}

/// What a mark covers, about: a part for each of its points.
fn reach(mark: &Mark) -> Vec<Extent> {
    match mark {
        Mark::Line { from, to, stroke, .. } => [*from, *to].map(|end| Extent::about(end, stroke.width / 2.0)).to_vec(),
        Mark::Circle { centre, radius, stroke, .. } => vec![Extent::about(*centre, radius + stroke.width / 2.0)],
        Mark::Polygon { corners: points, stroke, .. } | Mark::Path { points, stroke } => {
            points.iter().map(|point| Extent::about(*point, stroke.width / 2.0)).collect()
        }
        Mark::Rectangles { corners, .. } => corners.iter().map(|&(low, high)| Extent { low, high }).collect(),
        Mark::Text { at, text, anchor, .. } | Mark::Title { at, text, anchor, .. } => {
            vec![labels::area(text, &(*at, *anchor))]
        }
    }
}
