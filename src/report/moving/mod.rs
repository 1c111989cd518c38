//! How is an engine shown in motion? As a scene: all that a small script in a page needs to turn the crank, and no more.
//!
//! `engine, verdicts, family → scene (numbers to draw, finished words) → fragment of a page`
//!
//! What is drawn is reckoned in the page, in decimals. What is said comes from here: a verdict is finished words, and for an
//! open angle the exact list of its zeros, in whole numbers, so that the page compares and never judges.

mod bodies;
mod fragment;
mod open_angle;
mod open_scenes;
mod scene;
mod spoken;
mod stars;

use std::sync::Arc;

pub use fragment::{MOVING_SCRIPT, MOVING_STYLE, moving_fragment};
pub use open_scenes::open_scenes;
pub use scene::{Body, Knuckle, Mark, MovingAngle, MovingOrder, MovingQuantity, MovingSense, Ray, Scene, Words, Zeros};

use super::convention::{differs, said};
use super::residual;
use crate::engine::{Engine, Family};
use crate::family::OpenOrder;
use crate::page::{self, Language, Live};
use crate::text::Format;
use crate::verdict::Judgement;
use open_angle::OpenAngle;

/// What a page shows of this engine in motion.
///
/// With the family that the engine is a member of, judged at the same orders, its open angle can be moved too: where one angle
/// is open and the verdicts are about the pistons alone, as those on a family are.
pub fn scene(engine: &Engine, judged: &Judgement, family: Option<(&Family, &[OpenOrder])>) -> Scene {
    let open = family.and_then(|(family, orders)| OpenAngle::new(engine, judged, family, orders));
    let drawn = differs(engine.convention()).map(|words| words.plain());
    let whose = residual::whose_masses(engine, judged).map(|words| words.plain());
    Scene {
        title: engine.title().escaped(Format::Plain),
        seen: said(engine.convention(), SEEN),
        bodies: bodies::bodies(engine, open.as_ref()),
        orders: stars::orders(engine, judged, open.as_ref()),
        notes: whose
            .into_iter()
            .chain(drawn)
            .chain(bodies::notes(engine))
            .chain([residual::LEGEND.to_owned()])
            .collect(),
        angle: open.map(|open| open.into_angle()),
        words: Words::default(),
    }
}

const SEEN: [&str; 2] = [
    "The engine seen from the free end: pins, rods and pistons at the crank angle of the slider",
    "The engine seen from the flywheel: pins, rods and pistons at the crank angle of the slider",
];

/// A scene in a page, with its name there.
#[derive(Debug)]
struct Part {
    scene: Scene,
    id: String,
}

impl page::Moving for Part {
    fn body(&self, language: Language) -> String {
        moving_fragment(&self.scene, &self.id, language)
    }
}

/// Scenes as parts of a page that only a browser shows.
pub(super) fn live(scenes: &[Scene]) -> Vec<page::Block> {
    let part = |(index, scene): (usize, &Scene)| {
        let part = Arc::new(Part { scene: scene.clone(), id: format!("scene-{}", index + 1) });
        page::Block::Live(Live { part, style: MOVING_STYLE, script: MOVING_SCRIPT })
    };
    scenes.iter().enumerate().map(part).collect()
}
