//! How is an engine shown in motion? As a scene: all that a small script in a page needs to turn the crank, and no more.
//!
//! `engine, verdicts, family → scene (numbers to draw, finished words) → fragment of a page`
//!
//! What is drawn is computed in the page, in decimals. What is said comes from here: a verdict is finished words, and for an
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
pub use scene::{
    Body, Knuckle, Mark, MovingAngle, MovingOrder, MovingQuantity, MovingSense, MovingUnit, Ray, Scene, Words, Zeros,
};

use super::convention::{differs, said};
use super::engine_page::{Weighed, WeighedParts, Weighing};
use super::residual;
use crate::engine::{Engine, Family};
use crate::family::OpenOrder;
use crate::page::{self, Language, Live};
use crate::proof::Planar;
use crate::report::texts::moving as text;
use crate::text::Format;
use crate::verdict::Judgement;
use open_angle::OpenAngle;

/// What a page shows of this engine in motion.
///
/// With the family that the engine is a member of, judged at the same orders, its open angle can be moved too: where one angle
/// is open and the verdicts are about the pistons alone, as those on a family are.
pub fn scene(
    engine: &Engine,
    judged: &Judgement,
    family: Option<(&Family, &[OpenOrder])>,
    weighing: &Weighing,
) -> Scene {
    let weighed = WeighedParts::new(engine, judged, weighing).as_judged;
    let open = family.and_then(|(family, orders)| OpenAngle::new(engine, judged, family, orders));
    let orders = stars::orders(engine, judged, weighed.as_ref(), open.as_ref());
    Scene {
        title: engine.title().escaped(Format::Plain),
        seen: said(engine.convention(), [text::from_free_end(), text::from_flywheel()]).plain(),
        bodies: bodies::bodies(engine, open.as_ref()),
        start: start(&orders),
        orders,
        units: weighed.map(|weighed| Planar::BOTH.map(|quantity| unit(&weighed, quantity))),
        notes: residual::whose_masses(engine, judged)
            .into_iter()
            .chain(differs(engine.convention()))
            .chain(bodies::notes(engine, judged))
            .chain([super::texts::residual::exact_sizes()])
            .collect(),
        angle: open.map(|open| open.into_angle()),
        words: Words::default(),
    }
}

/// The first order of which something is left, and whether that is the force or the moment; else the first.
fn start(orders: &[MovingOrder]) -> (usize, &'static str) {
    let is_left = |quantity: &MovingQuantity| quantity.senses.iter().any(|sense| !sense.zero);
    let left = |(place, order): (usize, &MovingOrder)| match (is_left(&order.force), is_left(&order.moment)) {
        (true, _) if order.exists => Some((place, FORCE)),
        (false, true) if order.exists => Some((place, MOMENT)),
        _ => None,
    };
    orders.iter().enumerate().find_map(left).unwrap_or((0, FORCE))
}

const FORCE: &str = "force";
const MOMENT: &str = "moment";

/// What the values of a quantity are counted in.
fn unit(weighed: &Weighed, quantity: Planar) -> MovingUnit {
    let unit = weighed.unit_of_tables(quantity);
    MovingUnit { factor: unit.factor, name: unit.unit.name }
}

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
