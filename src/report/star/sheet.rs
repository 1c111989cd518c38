//! How are stars arranged on a drawing? In rows, each no taller than it needs, with bars that tell their scales.

use num_traits::Zero;

use super::panel::sum;
use super::scale::{LETTERS, Scale, WIDTH};
use super::{Panel, Star};
use crate::engine::Engine;
use crate::page::Units;
use crate::page::figure::{Anchor, Figure, Ink, Mark, Point, Stroke, text_width};
use crate::proof::{Planar, Quantity};
use crate::verdict::{Balance, JudgedStar, OrderBalance, Verdict};

/// Between texts and stars, and between rows.
const GAP: f64 = 1.6;
const ROWS_APART: f64 = 5.0;

/// A drawing that grows downwards, row by row.
pub(in crate::report) struct Sheet {
    figure: Figure,
    columns: usize,
    foot: f64,
}

impl Sheet {
    /// An empty one with this many panels beside each other.
    pub fn new(columns: usize) -> Self {
        Sheet { figure: Figure::new(0.0, 0.0).lettered(LETTERS), columns, foot: 0.0 }
    }

    /// Where the middle of a panel lies; a row with fewer panels is in the middle.
    fn middle(&self, column: usize, of: usize) -> f64 {
        (column as f64 + (self.columns.saturating_sub(of) as f64 + 1.0) / 2.0) * WIDTH
    }

    /// Makes room for a line of text, and says where it is.
    fn line(&mut self) -> f64 {
        self.foot -= LETTERS;
        self.foot + LETTERS / 2.0
    }

    /// Names above the columns.
    pub fn names(&mut self, names: &[String]) {
        let y = self.line();
        for (column, name) in names.iter().enumerate() {
            self.figure.heading(Point::new(self.middle(column, names.len()), y), name.clone());
        }
        self.foot -= GAP;
    }

    /// A row of stars, with bars that tell their scale or without.
    pub fn row(&mut self, panels: Vec<Panel>, with_bars: bool) {
        let of = panels.len();
        let heads = self.line();
        let highest = panels.iter().map(|panel| panel.extent().high.im).fold(0.0, f64::max);
        let lowest = panels.iter().map(|panel| panel.extent().low.im).fold(0.0, f64::min);
        let centre = self.foot - GAP - highest;
        self.foot = centre + lowest - GAP;
        let sums = self.line();
        let scales: Vec<Scale> = panels.iter().map(|panel| panel.scale).collect();
        for (column, panel) in panels.into_iter().enumerate() {
            let x = self.middle(column, of);
            self.figure.heading(Point::new(x, heads), panel.heading);
            self.figure.place(panel.drawing, Point::new(x, centre));
            self.figure.formula(Point::new(x, sums), panel.sum.0, panel.sum.1);
        }
        if with_bars {
            self.foot -= GAP;
            let y = self.line();
            match scales.as_slice() {
                [first, others @ ..] if others.iter().all(|other| other.is_alike(first)) => {
                    self.bar(Point::new(self.columns as f64 * WIDTH / 2.0, y), *first);
                }
                each => each.iter().enumerate().for_each(|(column, scale)| {
                    self.bar(Point::new(self.middle(column, of), y), *scale);
                }),
            }
        }
        self.foot -= ROWS_APART;
    }

    /// A line of words below a row.
    pub fn words(&mut self, [plain, prose]: [String; 2]) {
        self.foot += ROWS_APART - GAP;
        let y = self.line();
        self.figure.formula(Point::new(self.columns as f64 * WIDTH / 2.0, y), plain, prose);
        self.foot -= ROWS_APART;
    }

    /// The bar that tells the scale, centred.
    fn bar(&mut self, at: Point, scale: Scale) {
        let Some((units, written)) = scale.bar() else { return };
        let long = units * scale.millimetres;
        let text = scale.unit.0.replacen("{}", &written, 1);
        let start = at - Point::new((long + GAP + text_width(&text, LETTERS)) / 2.0, 0.0);
        let (end, tick) = (start + long, Point::new(0.0, 0.9));
        let stroke = Stroke::solid(Ink::Black, 0.35);
        self.figure.line(start, end, stroke);
        self.figure.line(start - tick, start + tick, stroke);
        self.figure.line(end - tick, end + tick, stroke);
        self.figure.marks.push(Mark::Text {
            at: end + GAP,
            text,
            prose: Some(scale.unit.1.replacen("{}", &written, 1)),
            anchor: Anchor::Start,
            bold: false,
        });
    }

    /// The drawing, no larger than its marks.
    pub fn finish(self) -> Figure {
        self.figure.cropped(1.5)
    }
}

/// The rows of an order: force above moment, direct beside reverse; the moment only where an arm is not zero.
pub(super) fn order_rows(order: &OrderBalance) -> Vec<[&Verdict; 2]> {
    let has_vectors = |balance: &&Balance| {
        let terms = balance.verdicts().into_iter().flat_map(|verdict| verdict.sum.terms());
        terms.into_iter().any(|term| !term.weight.is_zero())
    };
    let moment = Some(&order.moment).filter(has_vectors);
    [Some(&order.force), moment].into_iter().flatten().map(Balance::verdicts).collect()
}

/// The stars of one order, direct beside reverse, each to a scale of its own.
pub fn star_figure(engine: &Engine, order: &OrderBalance) -> Figure {
    drawn(engine, order, |_| None)
}

/// The same, with what direct and reverse make together below each row: how much that is, in the units of the reader.
pub(in crate::report) fn sized_star_figure(
    engine: &Engine,
    order: &OrderBalance,
    size: impl Fn(Planar, Units) -> Option<[String; 2]>,
) -> Figure {
    in_both_units(|units| drawn(engine, order, |quantity| size(quantity, units)), &size)
}

/// A drawing in units of the SI, with the one in inches where these words differ.
pub(super) fn in_both_units<T: PartialEq>(
    draw: impl Fn(Units) -> Figure,
    words: impl Fn(Planar, Units) -> T,
) -> Figure {
    let differ = Planar::BOTH.into_iter().any(|quantity| words(quantity, Units::Si) != words(quantity, Units::Inch));
    Figure { in_inches: differ.then(|| Box::new(draw(Units::Inch))), ..draw(Units::Si) }
}

fn drawn(engine: &Engine, order: &OrderBalance, size: impl Fn(Planar) -> Option<[String; 2]>) -> Figure {
    let mut sheet = Sheet::new(2);
    for row in order_rows(order) {
        let panel = |verdict: &Verdict| {
            let star = Star::of(engine, verdict);
            Panel::new(engine, verdict, &star, Scale::of([&star], verdict.quantity, engine))
        };
        sheet.row(row.map(panel).into(), true);
        if let Quantity::Planar(quantity) = row[0].quantity
            && let Some(words) = size(quantity)
        {
            sheet.words(words);
        }
    }
    sheet.finish()
}

/// The stars of the inertia torque, two beside each other, all to one scale.
pub fn torque_figure(engine: &Engine, verdicts: &[&Verdict]) -> Figure {
    let stars: Vec<Star> = verdicts.iter().map(|verdict| Star::new(*verdict)).collect();
    let scale = Scale::of(&stars, Quantity::TORQUE, engine);
    let panels = verdicts.iter().zip(&stars).map(|(verdict, star)| Panel::new(engine, verdict, star, scale));
    in_rows(panels.collect(), 2)
}

/// Firing stars under their headings, three beside each other, all to one scale.
pub fn firing_figure(engine: &Engine, headed: Vec<(String, JudgedStar<'_>)>) -> Figure {
    let stars: Vec<Star> = headed.iter().map(|(_, judged)| Star::new(*judged)).collect();
    let scale = Scale::of_crank_radii(&stars);
    let panel = |((heading, judged), star)| Panel::headed(heading, engine, sum(judged), star, scale);
    in_rows(headed.into_iter().zip(&stars).map(panel).collect(), 3)
}

/// Panels of one scale in rows of this many, the bar below the last.
fn in_rows(panels: Vec<Panel>, columns: usize) -> Figure {
    let mut sheet = Sheet::new(panels.len().min(columns));
    let mut panels = panels.into_iter().peekable();
    while panels.peek().is_some() {
        let row: Vec<Panel> = panels.by_ref().take(columns).collect();
        let is_last = panels.peek().is_none();
        sheet.row(row, is_last);
    }
    sheet.finish()
}
