//! Does a value agree with what the evidence beside it says?

use super::audit::{Fault, demand};
use super::decimals::Size;
use super::document::Document;

pub(super) fn check_title(place: &str, title: &str, document: &Document) -> Result<(), Fault> {
    if title == document.title { Ok(()) } else { Err(Fault::new(place, "it is not the title of the evidence")) }
}

/// A size is 0 exactly where the evidence proves that it is.
pub(super) fn agrees(place: &str, size: Size, is_zero: bool) -> Result<(), Fault> {
    demand(size.is_nothing() == is_zero, Fault::new(place, "it is not what the evidence says"))
}
