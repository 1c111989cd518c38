//! How do several plots share one page? Below each other, as small multiples.

use super::super::figure::{Figure, Point};

/// Drawings below each other on one page.
pub(crate) fn stacked(figures: Vec<Figure>) -> Figure {
    let in_inches = figures.iter().any(|figure| figure.in_inches.is_some()).then(|| {
        let one = |figure: &Figure| figure.in_inches.as_deref().unwrap_or(figure).clone();
        Box::new(below_each_other(figures.iter().map(one).collect()))
    });
    Figure { in_inches, ..below_each_other(figures) }
}

fn below_each_other(figures: Vec<Figure>) -> Figure {
    let width = figures.iter().map(|figure| figure.width).fold(0.0, f64::max);
    let mut page = Figure::new(width, figures.iter().map(|figure| figure.height).sum());
    let mut top = page.height;
    for figure in figures {
        top -= figure.height;
        let way = Point::new((width - figure.width) / 2.0, top);
        page.place(figure, way);
    }
    page
}
