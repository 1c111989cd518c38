//! From where does a page look at the engine? From the end from which the crank turns anticlockwise, whatever the file draws.
//!
//! So angles in the sense of rotation are those of the drawing (theory of mechanisms, section 4), and no page mixes two counts.

use crate::engine::{Convention, Rotation, SeenFrom};
use crate::page::{Text, phrase};

/// A sentence for pages that look from the free end, and the same for the flywheel.
pub(super) fn said(convention: Convention, [free_end, flywheel]: [&'static str; 2]) -> &'static str {
    match convention.turns_anticlockwise_from() {
        SeenFrom::FreeEnd => free_end,
        SeenFrom::Flywheel => flywheel,
    }
}

/// From where angles are seen, and in which sense they grow.
pub(super) fn seen(convention: Convention) -> Text {
    said(convention, SEEN).into()
}

/// How the drawing of the file differs from that of the page; none where nothing does, or the page looks from the free end anyway.
pub(super) fn differs(convention: Convention) -> Option<Text> {
    match (convention.rotation, convention.seen_from) {
        (Rotation::Anticlockwise, SeenFrom::FreeEnd) => None,
        (Rotation::Anticlockwise, SeenFrom::Flywheel) => Some(FROM_THE_FLYWHEEL.into()),
        (Rotation::Clockwise, end) => Some(phrase!(CLOCKWISE, end)),
    }
}

const SEEN: [&str; 2] = [
    "Seen from the free end of the crankshaft (+z towards the reader), angles grow anticlockwise from the \
     reference direction, drawn upwards; for a V it is the bisector of the banks. The crank turns \
     anticlockwise by θ.",
    "Seen from the flywheel end of the crankshaft (+z away from the reader, towards the free end), angles grow anticlockwise from the \
     reference direction, drawn upwards; for a V it is the bisector of the banks. The crank turns anticlockwise by θ.",
];
const FROM_THE_FLYWHEEL: &str =
    "The layout file and this page view the engine from the flywheel; angles grow in the sense of rotation.";
const CLOCKWISE: &str = "The layout file draws the engine from the {1:free end|flywheel}, where the crank turns clockwise. This page views it from the {1:flywheel|free end}, where it turns anticlockwise: angles grow in the sense of rotation, and an angle of the file has the opposite sign here.";
