//! Which texts of a drawing cannot be read, for they lie on another or leave the page?

use crankstar::page::figure::{Extent, Figure, Point};

/// What is wrong with the texts of a drawing.
pub trait FigureTexts {
    /// The pairs of texts that lie on each other.
    fn overlaps(&self) -> Vec<(&str, &str)>;

    /// The texts that do not lie on the page.
    fn leaving(&self) -> Vec<&str>;
}

impl FigureTexts for Figure {
    fn overlaps(&self) -> Vec<(&str, &str)> {
        let boxes = self.text_boxes();
        let pairs =
            boxes.iter().enumerate().flat_map(|(index, one)| boxes[index + 1..].iter().map(move |two| (one, two)));
        pairs.filter(|(one, two)| one.1.meets(&two.1)).map(|(one, two)| (one.0, two.0)).collect()
    }

    fn leaving(&self) -> Vec<&str> {
        let page = Extent { low: Point::default(), high: Point::new(self.width, self.height) };
        self.text_boxes().into_iter().filter(|(_, text)| !page.holds(text)).map(|(text, _)| text).collect()
    }
}
