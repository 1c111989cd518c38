//! How much room do marks take? The box of a text by its letters, and the box of all marks.

use super::{Figure, Mark, Point, arrow_head};
use crate::text::SUPERSCRIPTS;

/// Boxes that share less than this, in millimetres, only touch.
const TOUCH: f64 = 0.05;
/// Height of a box over the size of its letters: from the foot of a g to the top of an l.
const TALL: f64 = 1.0;

/// A rectangle with its sides along the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Lower left corner.
    pub low: Point,
    /// Upper right corner.
    pub high: Point,
}

impl Extent {
    /// All that is no farther from a point than this.
    pub(crate) fn about(point: Point, reach: f64) -> Self {
        Extent { low: point, high: point }.grown(reach)
    }

    /// The smallest that holds these points.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let points = points.into_iter().filter(|point| point.is_finite());
        points.map(|point| Extent { low: point, high: point }).reduce(|all, point| all.joined(&point))
    }

    /// The smallest that holds both.
    pub fn joined(&self, other: &Extent) -> Self {
        Extent {
            low: Point::new(self.low.re.min(other.low.re), self.low.im.min(other.low.im)),
            high: Point::new(self.high.re.max(other.high.re), self.high.im.max(other.high.im)),
        }
    }

    /// With this many millimetres more on every side.
    pub fn grown(&self, by: f64) -> Self {
        let by = Point::new(by, by);
        Extent { low: self.low - by, high: self.high + by }
    }

    /// Whether the two have more in common than an edge.
    pub fn meets(&self, other: &Extent) -> bool {
        let shared = |low: fn(&Point) -> f64| {
            low(&self.high).min(low(&other.high)) - low(&self.low).max(low(&other.low)) > TOUCH
        };
        shared(|point| point.re) && shared(|point| point.im)
    }

    /// Whether the two have a point in common, be it of an edge.
    pub(in crate::page) fn touches(&self, other: &Extent) -> bool {
        let apart = self.high.re < other.low.re || other.high.re < self.low.re;
        !apart && self.low.im <= other.high.im && other.low.im <= self.high.im
    }

    /// Whether a point lies inside, edges included. Plots ask it of every point for every place of a name.
    #[inline]
    pub(in crate::page) fn contains(&self, point: Point) -> bool {
        (self.low.re..=self.high.re).contains(&point.re) && (self.low.im..=self.high.im).contains(&point.im)
    }

    /// Whether a line passes through.
    pub fn is_crossed(&self, from: Point, to: Point) -> bool {
        self.cut(from, to).is_some()
    }

    /// The part of a line inside, by Liang and Barsky.
    pub(in crate::page) fn cut(&self, from: Point, to: Point) -> Option<(Point, Point)> {
        let way = to - from;
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (along, before, after) in [
            (way.re, self.low.re - from.re, self.high.re - from.re),
            (way.im, self.low.im - from.im, self.high.im - from.im),
        ] {
            if along == 0.0 {
                if before > 0.0 || after < 0.0 {
                    return None;
                }
                continue;
            }
            let (first, last) = (before / along, after / along);
            enter = enter.max(first.min(last));
            leave = leave.min(first.max(last));
        }
        let start = if enter == 0.0 { from } else { from + way * enter };
        let end = if leave == 1.0 { to } else { from + way * leave };
        (enter <= leave).then_some((start, end))
    }

    /// Whether the other lies inside, edges included.
    pub fn holds(&self, other: &Extent) -> bool {
        let both = self.joined(other);
        (both.low - self.low).norm() < TOUCH && (both.high - self.high).norm() < TOUCH
    }
}

/// About the width of a text in letters of this size, in the widest face that stands in for Helvetica.
pub fn text_width(text: &str, letters: f64) -> f64 {
    let width = |letter: char| match letter {
        '\u{202f}' => 0.2,
        'i' | 'j' | 'l' | 't' | 'f' | 'r' | 'I' | '.' | ',' | ';' | ':' | '·' | '\'' | '(' | ')' | ' ' | '/' => 0.35,
        'm' | 'w' | 'M' | 'W' | '−' | '+' | '=' | '≈' | '×' => 0.87,
        '…' => 1.0,
        'A'..='Z' => 0.7,
        letter if letter == '⁻' || SUPERSCRIPTS.contains(&letter) => 0.4,
        _ => 0.627,
    };
    text.chars().map(width).sum::<f64>() * letters
}

/// Around texts for which a page was made larger, in millimetres.
const AIR: f64 = 0.8;

impl Mark {
    /// A text with what it covers; nothing of other marks.
    fn text_box(&self, letters: f64) -> Option<(&str, Extent)> {
        let (at, text, anchor, bold, letters) = match self {
            Mark::Text { at, text, anchor, bold, .. } => (at, text, anchor, *bold, letters),
            Mark::Title { at, text, anchor, letters } => (at, text, anchor, true, *letters),
            _ => return None,
        };
        let width = text_width(text, letters) * if bold { 1.1 } else { 1.0 };
        let low = Point::new(at.re - anchor.before(width), at.im - TALL * letters / 2.0);
        Some((text, Extent { low, high: low + Point::new(width, TALL * letters) }))
    }

    /// What the mark covers, its outline with it.
    fn extent(&self, letters: f64) -> Option<Extent> {
        match self {
            Mark::Line { from, to, stroke, arrow } => {
                let head = arrow.then(|| arrow_head(*from, *to, stroke)).flatten();
                let outline = head.map_or(stroke.width / 2.0, |(_, half)| half.max(stroke.width / 2.0));
                Extent::around([*from, *to]).map(|line| line.grown(outline))
            }
            Mark::Circle { centre, radius, stroke, .. } => {
                Extent::around([*centre]).map(|point| point.grown(radius + stroke.width / 2.0))
            }
            Mark::Polygon { corners: points, stroke, .. } | Mark::Path { points, stroke } => {
                Extent::around(points.iter().copied()).map(|area| area.grown(stroke.width / 2.0))
            }
            Mark::Rectangles { corners, .. } => Extent::around(corners.iter().flat_map(|(low, high)| [*low, *high])),
            Mark::Text { .. } | Mark::Title { .. } => self.text_box(letters).map(|(_, text)| text),
        }
    }

    fn points_mut(&mut self) -> Vec<&mut Point> {
        match self {
            Mark::Line { from, to, .. } => vec![from, to],
            Mark::Circle { centre: at, .. } | Mark::Text { at, .. } | Mark::Title { at, .. } => vec![at],
            Mark::Polygon { corners: points, .. } | Mark::Path { points, .. } => points.iter_mut().collect(),
            Mark::Rectangles { corners, .. } => corners.iter_mut().flat_map(|(low, high)| [low, high]).collect(),
        }
    }

    pub(crate) fn moved(&mut self, by: Point) {
        self.points_mut().into_iter().for_each(|point| *point += by);
    }

    fn scaled(&mut self, by: f64) {
        self.points_mut().into_iter().for_each(|point| *point *= by);
        match self {
            Mark::Circle { radius, stroke, .. } => {
                *radius *= by;
                stroke.width *= by;
            }
            Mark::Line { stroke, .. } | Mark::Polygon { stroke, .. } | Mark::Path { stroke, .. } => stroke.width *= by,
            Mark::Title { letters, .. } => *letters *= by,
            Mark::Rectangles { .. } | Mark::Text { .. } => {}
        }
    }
}

impl Figure {
    /// The texts to be changed, each with its prose; titles have none.
    pub(in crate::page) fn texts_mut(&mut self) -> impl Iterator<Item = (&mut String, Option<&mut Option<String>>)> {
        self.marks.iter_mut().filter_map(|mark| match mark {
            Mark::Text { text, prose, .. } => Some((text, Some(prose))),
            Mark::Title { text, .. } => Some((text, None)),
            _ => None,
        })
    }

    /// The texts with the boxes that they cover, as far as the widths of letters are known.
    pub fn text_boxes(&self) -> Vec<(&str, Extent)> {
        self.marks.iter().filter_map(|mark| mark.text_box(self.letters)).collect()
    }

    /// The same marks on a page that holds all their texts, which may have become longer in another language.
    pub fn with_room_for_texts(self) -> Figure {
        let page = self.page();
        let leaving = self.text_boxes().into_iter().map(|(_, text)| text).filter(|text| !page.holds(text));
        let Some(leaving) = leaving.reduce(|all, text| all.joined(&text)) else { return self };
        self.on_page(page.joined(&leaving.grown(AIR)))
    }

    fn page(&self) -> Extent {
        Extent { low: Point::new(0.0, 0.0), high: Point::new(self.width, self.height) }
    }

    /// The same marks, what this rectangle holds of them as the page.
    fn on_page(self, page: Extent) -> Figure {
        let size = page.high - page.low;
        let mut figure = Figure::new(size.re, size.im).lettered(self.letters);
        figure.place(self, -page.low);
        figure
    }

    /// What all marks together cover; nothing where there are none.
    pub fn extent(&self) -> Option<Extent> {
        self.marks.iter().filter_map(|mark| mark.extent(self.letters)).reduce(|all, mark| all.joined(&mark))
    }

    /// Puts another drawing on this one, its origin at a point.
    pub fn place(&mut self, other: Figure, at: Point) {
        let moved = |mut mark: Mark| {
            mark.moved(at);
            mark
        };
        self.marks.extend(other.marks.into_iter().map(moved));
    }

    /// The same drawing this many times as large, its letters and lines with it.
    pub fn scaled(mut self, by: f64) -> Figure {
        self.marks.iter_mut().for_each(|mark| mark.scaled(by));
        let in_inches = self.in_inches.map(|figure| Box::new(figure.scaled(by)));
        let (width, height) = (by * self.width, by * self.height);
        Figure { width, height, letters: by * self.letters, marks: self.marks, in_inches }
    }

    /// The same marks on a page that they fill, with a margin in millimetres.
    pub fn cropped(self, margin: f64) -> Figure {
        let Some(extent) = self.extent() else { return self };
        self.on_page(extent.grown(margin))
    }
}
