//! How is the layout read that the page sends?

use serde::Deserialize;

use super::judged::Judged;
use super::mistake::Mistake;
use crate::file::{self, FileResolver, Layout};

/// Larger texts are no layouts.
const LARGEST: usize = 1 << 20;

/// A layout file as it was written.
#[derive(Deserialize)]
pub(super) struct Written {
    /// What messages call it, and its title where it has none.
    pub name: String,
    pub text: String,
}

impl Written {
    pub fn read(&self) -> Result<Layout, Mistake> {
        if self.text.len() > LARGEST {
            return Err(Mistake::plain("the layout is larger than 1 MiB", "a layout file is a page or two"));
        }
        let beside = FileResolver::nothing().of_catalogue(file::is_of_catalogue(&self.name, &self.text));
        file::parse_layout_beside(&self.name, &self.text, beside)
            .map_err(|error| Mistake::in_layout(&error, &self.text))
    }

    pub fn judged(&self) -> Result<Judged, Mistake> {
        Judged::of(self.read()?)
    }
}
