//! What is wrong, where in the text, and what would be right, as an editor marks it?

use std::fmt;

use serde::Serialize;

use crate::file::LayoutError;
use crate::text::harmless;

/// A message for the page.
#[derive(Debug, Serialize)]
pub(super) struct Mistake {
    message: String,
    right: String,
    place: Option<Place>,
}

/// Where it stands.
#[derive(Debug, Serialize)]
struct Place {
    /// The line, from 1.
    line: usize,
    /// The letter in it, from 1.
    column: usize,
    /// Begin and end in the units that scripts count texts in, UTF-16.
    from: usize,
    to: usize,
}

impl Mistake {
    /// One that has no place in the layout.
    pub fn plain(message: &str, right: &str) -> Self {
        Mistake { message: harmless(message), right: harmless(right), place: None }
    }

    /// What a room says itself.
    pub fn of(error: impl fmt::Display) -> Self {
        Mistake::plain(&error.to_string(), "")
    }

    /// One in a layout, at its place.
    pub fn in_layout(error: &LayoutError, source: &str) -> Self {
        let place = error.span().and_then(|span| {
            let (before, inside) = (source.get(..span.start)?, source.get(span)?);
            let units = |text: &str| text.encode_utf16().count();
            let line = before.rsplit('\n').next().unwrap_or_default();
            Some(Place {
                line: before.matches('\n').count() + 1,
                column: line.chars().count() + 1,
                from: units(before),
                to: units(before) + units(inside),
            })
        });
        Mistake { place, ..Mistake::plain(error.message(), error.right()) }
    }
}
