//! How does an engine look in the size of a stamp? Its cranks and cylinders beside the star of the lowest order left, and a few words.

use super::super::figure::{Anchor, Figure, Point};
use super::super::residual;
use super::super::star::small_star;
use super::small::{SIZE, small_engine};
use super::{FirstOrderLeft, KnownEngine};
use crate::page::{Text, phrase};

/// Width of each of the two drawings in millimetres.
const DRAWING: f64 = 21.5;
/// Size of the letters of a name.
const NAME: f64 = 3.9;

/// An engine as it stands on a poster.
pub(in crate::report) struct Stamp {
    name: &'static str,
    lines: [String; 2],
    engine: Figure,
    star: Figure,
}

impl Stamp {
    /// Its width in millimetres: two drawings beside each other.
    pub const WIDTH: f64 = 2.0 * DRAWING;
    /// Its height: the drawings, the name, a line on the force and one on the moment.
    pub const HEIGHT: f64 = DRAWING + 12.0;

    /// The stamp of an engine of the catalogue.
    pub fn new(known: &KnownEngine) -> Self {
        Stamp {
            name: known.name,
            lines: lines(known).map(|line| line.plain()),
            engine: small_engine(known.engine),
            star: known.drawn().map_or_else(|| Figure::new(SIZE, SIZE), |order| small_star(&order, None)),
        }
    }

    /// Draws it below this point, centred.
    pub fn draw(&self, figure: &mut Figure, top: Point) {
        let size = |drawing: &Figure| drawing.clone().scaled(DRAWING / drawing.width);
        figure.place(size(&self.engine), top - Point::new(DRAWING, DRAWING));
        figure.place(size(&self.star), top - Point::new(0.0, DRAWING));
        let below = |millimetres: f64| top - Point::new(0.0, DRAWING + millimetres);
        figure.title(below(2.0), self.name, NAME, Anchor::Middle);
        for (index, line) in self.lines.iter().enumerate() {
            figure.text(below(6.4 + 3.9 * index as f64), line.clone(), Anchor::Middle);
        }
    }
}

/// What is left first of the force and of the moment.
fn lines(known: &KnownEngine) -> [Text; 2] {
    let Some([force, moment]) = known.first() else { return ["not stated of every order".into(), Text::default()] };
    let shape = |first: &FirstOrderLeft| residual::shape_name(first.shape);
    let force = match force {
        Some(first) => phrase!("force of order {}, {}", first.order, shape(&first)),
        None => "no force".into(),
    };
    let moment = match moment {
        Some(first) => phrase!("moment of order {}, {}", first.order, shape(&first)),
        None => "no moment".into(),
    };
    [force, moment]
}
