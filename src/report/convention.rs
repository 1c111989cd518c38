//! From where does a page look at the engine? From the end from which the crank turns anticlockwise, whatever the file draws.
//!
//! So angles in the sense of rotation are those of the drawing (theory of mechanisms, section 4), and no page mixes two counts.

use crate::engine::{Convention, Rotation, SeenFrom};
use crate::page::Text;
use crate::report::texts::convention as text;

/// A sentence for pages that look from the free end, and the same for the flywheel.
pub(super) fn said<T>(convention: Convention, [free_end, flywheel]: [T; 2]) -> T {
    match convention.turns_anticlockwise_from() {
        SeenFrom::FreeEnd => free_end,
        SeenFrom::Flywheel => flywheel,
    }
}

/// From where angles are seen, and in which sense they grow.
pub(super) fn seen(convention: Convention) -> Text {
    said(convention, [text::from_free_end(), text::from_flywheel()])
}

/// How the drawing of the file differs from that of the page; none where nothing does, or the page looks from the free end anyway.
pub(super) fn differs(convention: Convention) -> Option<Text> {
    match (convention.rotation, convention.seen_from) {
        (Rotation::Anticlockwise, SeenFrom::FreeEnd) => None,
        (Rotation::Anticlockwise, SeenFrom::Flywheel) => Some(text::also_from_flywheel()),
        (Rotation::Clockwise, end) => Some(text::clockwise(end)),
    }
}
