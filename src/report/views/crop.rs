//! How large is a drawing? As large as what is on it, with a little air.

use super::super::figure::{Figure, Mark, Point};
use super::super::plot::curve::Area;
use super::super::plot::labels;

/// Air at the edges, in millimetres.
const AIR: f64 = 1.5;

/// The same drawing on a page that just holds it; its marks may be anywhere before.
pub(in crate::report) fn cropped(mut figure: Figure) -> Figure {
    let areas = figure.marks.iter().flat_map(reach);
    let whole = areas.reduce(|a, b| Area {
        low: Point::new(a.low.re.min(b.low.re), a.low.im.min(b.low.im)),
        high: Point::new(a.high.re.max(b.high.re), a.high.im.max(b.high.im)),
    });
    let Some(Area { low, high }) = whole else { return figure };
    let air = Point::new(AIR, AIR);
    let size = high - low + air * 2.0;
    (figure.width, figure.height) = (size.re, size.im);
    figure.marks.iter_mut().for_each(|mark| mark.moved(air - low));
    figure
}

/// What a mark covers, about: a part for each of its points.
fn reach(mark: &Mark) -> Vec<Area> {
    let around = |at: &Point, far: f64| {
        let half = Point::new(far, far);
        Area { low: at - half, high: at + half }
    };
    match mark {
        Mark::Line { from, to, stroke, .. } => [from, to].map(|end| around(end, stroke.width / 2.0)).to_vec(),
        Mark::Circle { centre, radius, stroke, .. } => vec![around(centre, radius + stroke.width / 2.0)],
        Mark::Polygon { corners: points, stroke, .. } | Mark::Path { points, stroke } => {
            points.iter().map(|point| around(point, stroke.width / 2.0)).collect()
        }
        Mark::Rectangles { corners, .. } => corners.iter().map(|&(low, high)| Area { low, high }).collect(),
        Mark::Text { at, text, anchor, .. } | Mark::Title { at, text, anchor, .. } => {
            vec![labels::area(text, &(*at, *anchor))]
        }
    }
}
