//! Which engine does a name or path in a claims file mean?

use crate::engine::Engine;
use crate::file::LayoutError;
use crate::file::written::{Text, place};

/// Finds the engine of a name or path; the error says what is wrong with it.
pub type Find<'a> = &'a dyn Fn(&str) -> Result<Engine, String>;

/// The engine that a text names.
pub(super) fn engine(name: &Text, find: Find) -> Result<Engine, LayoutError> {
    find(&name.get_ref().0).map_err(|reason| {
        LayoutError::new(
            reason,
            "a claim is about one engine: a name of the catalogue, or a layout file in which nothing is open",
            place(name),
        )
    })
}
