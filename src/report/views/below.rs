//! What is below the view from the free end? The firing order, and the offset.

use num_rational::BigRational;

use super::super::figure::{Anchor, Figure, Point};
use super::super::plot::labels::LINE;
use super::super::typeset::Amount;
use super::{MOST_LABELS, wrapped};
use crate::engine::Engine;
use crate::numbers::{Form, float};

/// Lines are broken at this width, or at that of the drawing.
const WIDTH: f64 = 80.0;

/// The firing order and the offset in lines below the drawing.
pub(super) fn write_below(figure: &mut Figure, engine: &Engine) {
    let mut y = -LINE;
    for words in firing_words(engine).into_iter().chain(offset_words(engine)) {
        for line in wrapped(&words, &['–', ' '], WIDTH.max(figure.width)) {
            figure.text(Point::new(figure.width / 2.0, y), line.trim_end(), Anchor::Middle);
            y -= LINE + 0.4;
        }
    }
}

/// Cylinders that fire together are joined by a plus.
fn firing_words(engine: &Engine) -> Option<String> {
    let firing = engine.firing().filter(|firing| (2..=MOST_LABELS).contains(&firing.shots.len()))?;
    let together = firing.shots.chunk_by(|a, b| a.angle == b.angle).map(|shots| {
        let names = shots.iter().map(|shot| engine.cylinders()[shot.cylinder].name.as_str());
        names.collect::<Vec<_>>().join("+")
    });
    Some(format!("Fires {}", together.collect::<Vec<_>>().join("–")))
}

/// The offsets against the rod length.
fn offset_words(engine: &Engine) -> Option<String> {
    let amount =
        |offset: &BigRational| Amount { exact: Some(Form::rational(offset.clone())), decimal: float(offset) }.plain();
    let mut offsets: Vec<String> = Vec::new();
    for offset in engine.rods().map(|rod| amount(&rod.offset)) {
        if !offsets.contains(&offset) {
            offsets.push(offset);
        }
    }
    (engine.has_offset() && offsets.len() <= MOST_LABELS).then(|| format!("Offset e/l {}", offsets.join(", ")))
}
