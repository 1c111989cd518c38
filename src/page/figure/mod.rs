//! What is a drawing? Marks in millimetres, y upwards; SVG and TikZ are printed from the same marks.

mod extent;

pub use extent::{Extent, text_width};

use num_complex::Complex;

/// A point of the drawing, in millimetres: x to the right, y upwards.
pub type Point = Complex<f64>;

/// Colours of different lightness, so that they differ in grey too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ink {
    /// Text and vectors.
    Black,
    /// Axes and guides.
    Grey,
    /// Bodies that other marks are drawn upon.
    Light,
    /// First colour of polygons and pins.
    Blue,
    /// Second colour of polygons.
    Orange,
    /// Third colour of polygons.
    Green,
    /// Resultants.
    Red,
    /// A grey of this many per cent black, at most 100: grids and maps.
    Shade(u8),
}

impl Ink {
    /// What it is called in files; all shades together.
    pub(super) fn name(self) -> &'static str {
        match self {
            Ink::Black => "black",
            Ink::Grey => "grey",
            Ink::Light => "light",
            Ink::Blue => "blue",
            Ink::Orange => "orange",
            Ink::Green => "green",
            Ink::Red => "red",
            Ink::Shade(_) => "shade",
        }
    }
}

/// How a line is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Not at all.
    Solid,
    /// In dashes.
    Dashed,
    /// In dots.
    Dotted,
    /// In dashes with dots between them.
    DashDotted,
}

/// A line: its colour, its width in millimetres, how it is broken.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// Colour.
    pub ink: Ink,
    /// Width in millimetres.
    pub width: f64,
    /// Solid, dashed or dotted.
    pub dash: Dash,
}

impl Stroke {
    /// A solid line.
    pub fn solid(ink: Ink, width: f64) -> Self {
        Stroke { ink, width, dash: Dash::Solid }
    }
}

/// Where a text hangs on its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at the point.
    Start,
    /// The text is centred on the point.
    Middle,
    /// The text ends at the point.
    End,
}

impl Anchor {
    /// How far to the left of its point a text of this width begins.
    pub fn before(self, width: f64) -> f64 {
        match self {
            Anchor::Start => 0.0,
            Anchor::Middle => width / 2.0,
            Anchor::End => width,
        }
    }
}

/// One mark of a drawing; later marks lie upon earlier ones.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A straight line, with an arrow head at its end or without.
    Line {
        /// Start.
        from: Point,
        /// End.
        to: Point,
        /// Line.
        stroke: Stroke,
        /// Whether an arrow head is at the end.
        arrow: bool,
    },
    /// A circle, filled or not.
    Circle {
        /// Centre.
        centre: Point,
        /// Radius in millimetres.
        radius: f64,
        /// Outline.
        stroke: Stroke,
        /// Colour inside.
        fill: Option<Ink>,
    },
    /// A closed polygon, filled or not.
    Polygon {
        /// Corners in order.
        corners: Vec<Point>,
        /// Outline.
        stroke: Stroke,
        /// Colour inside.
        fill: Option<Ink>,
    },
    /// An open line through points.
    Path {
        /// The points in order.
        points: Vec<Point>,
        /// Line.
        stroke: Stroke,
    },
    /// Filled rectangles of one colour, without outlines, their sides along the page.
    Rectangles {
        /// Lower left and upper right corners.
        corners: Vec<(Point, Point)>,
        /// Colour inside.
        fill: Ink,
    },
    /// A line of text, centred in height on its point.
    Text {
        /// Where.
        at: Point,
        /// What, in plain text.
        text: String,
        /// The same as prose with `$formulas$`, where it has any.
        prose: Option<String>,
        /// How it hangs.
        anchor: Anchor,
        /// Whether it is a heading of the drawing.
        bold: bool,
    },
    /// A bold line of letters of a size of its own, centred in height on its point.
    Title {
        /// Where.
        at: Point,
        /// What, in plain text.
        text: String,
        /// Size of the letters in millimetres.
        letters: f64,
        /// How it hangs.
        anchor: Anchor,
    },
}

/// Size of the letters of a drawing that asks for no other, in millimetres.
pub const LETTERS: f64 = 3.0;

/// A drawing of a given size, its origin at the lower left.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Width in millimetres.
    pub width: f64,
    /// Height in millimetres.
    pub height: f64,
    /// Size of its letters in millimetres.
    pub letters: f64,
    /// What is drawn, in order.
    pub marks: Vec<Mark>,
    /// The same with its values in inches and pounds, where it has any in units.
    pub in_inches: Option<Box<Figure>>,
}

impl Figure {
    /// An empty drawing.
    pub fn new(width: f64, height: f64) -> Self {
        Figure { width, height, letters: LETTERS, marks: Vec::new(), in_inches: None }
    }

    /// The same drawing with letters of this size in millimetres.
    pub fn lettered(self, letters: f64) -> Self {
        Figure { letters, ..self }
    }

    /// Draws a line.
    pub fn line(&mut self, from: Point, to: Point, stroke: Stroke) {
        self.marks.push(Mark::Line { from, to, stroke, arrow: false });
    }

    /// Draws an arrow.
    pub fn arrow(&mut self, from: Point, to: Point, stroke: Stroke) {
        self.marks.push(Mark::Line { from, to, stroke, arrow: true });
    }

    /// Draws a circle.
    pub fn circle(&mut self, centre: Point, radius: f64, stroke: Stroke, fill: Option<Ink>) {
        self.marks.push(Mark::Circle { centre, radius, stroke, fill });
    }

    /// Draws a closed polygon.
    pub fn polygon(&mut self, corners: Vec<Point>, stroke: Stroke, fill: Option<Ink>) {
        self.marks.push(Mark::Polygon { corners, stroke, fill });
    }

    /// Draws an open line through points.
    pub fn path(&mut self, points: Vec<Point>, stroke: Stroke) {
        self.marks.push(Mark::Path { points, stroke });
    }

    /// Fills rectangles, given by their lower left and upper right corners.
    pub fn rectangles(&mut self, corners: Vec<(Point, Point)>, fill: Ink) {
        self.marks.push(Mark::Rectangles { corners, fill });
    }

    /// Writes a text.
    pub fn text(&mut self, at: Point, text: impl Into<String>, anchor: Anchor) {
        self.marks.push(Mark::Text { at, text: text.into(), prose: None, anchor, bold: false });
    }

    /// Writes a text that has formulas, centred: plain where there is no TeX, else as prose.
    pub fn formula(&mut self, at: Point, text: String, prose: String) {
        self.marks.push(Mark::Text { at, text, prose: Some(prose), anchor: Anchor::Middle, bold: false });
    }

    /// Writes a bold line in letters of this many millimetres.
    pub fn title(&mut self, at: Point, text: impl Into<String>, letters: f64, anchor: Anchor) {
        self.marks.push(Mark::Title { at, text: text.into(), letters, anchor });
    }

    /// Writes a heading, centred.
    pub fn heading(&mut self, at: Point, text: impl Into<String>) {
        self.marks.push(Mark::Text { at, text: text.into(), prose: None, anchor: Anchor::Middle, bold: true });
    }
}

/// Letters on a screen are not smaller than this in pixels.
const READABLE: f64 = 11.0;
/// Half of a printed page in millimetres, and the least size of letters there.
const HALF_A_PAGE: f64 = 83.0;
const PRINTED: f64 = 2.2;

impl Figure {
    /// How wide it is on a screen at least, so that its letters are read.
    pub fn least_pixels(&self) -> f64 {
        (READABLE * self.width / self.letters).ceil()
    }

    /// Whether its letters are too small where two drawings stand beside each other.
    pub fn is_spread(&self) -> bool {
        self.letters * HALF_A_PAGE < PRINTED * self.width
    }
}

/// Heads are not drawn smaller than this, in millimetres: they would round to nothing.
const SMALLEST_HEAD: f64 = 0.05;

/// Length and half the width of the head of an arrow in millimetres; none on a line that is too short for one.
pub(super) fn arrow_head(from: Point, to: Point, stroke: &Stroke) -> Option<(f64, f64)> {
    let length = (to - from).norm();
    let size = (1.2 + 1.6 * stroke.width).min(0.35 * length);
    (size > SMALLEST_HEAD).then_some((1.6 * size, 0.5 * size))
}

/// A coordinate as text: two places at most, no negative zero, and 0 for what is no number.
pub(super) fn coordinate(value: f64) -> String {
    if !value.is_finite() {
        return "0".to_owned();
    }
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
