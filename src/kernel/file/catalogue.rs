//! Which engines are known by name? One layout file each, in the folder `catalogue`.

use super::error::LayoutError;
use super::file_resolver::FileResolver;
use super::layout::parse_beside;
use crate::engine::Engine;

/// A layout file of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name on the command line: the file's name without `.toml`.
    pub name: &'static str,
    /// The layout file.
    pub text: &'static str,
}

impl Entry {
    /// The engine.
    ///
    /// # Errors
    /// None in a released catalogue: the tests read every entry.
    pub fn engine(&self) -> Result<Engine, LayoutError> {
        parse_beside(self.name, self.text, FileResolver::nothing().of_catalogue(true))
    }
}

include!(concat!(env!("OUT_DIR"), "/catalogue.rs"));

/// All engines: by form, then by number of cylinders, then by name.
///
/// # Errors
/// None in a released catalogue: the tests read every entry.
pub fn catalogue() -> Result<Vec<(Entry, Engine)>, LayoutError> {
    let mut engines =
        ENTRIES.iter().map(|entry| Ok((*entry, entry.engine()?))).collect::<Result<Vec<_>, LayoutError>>()?;
    engines.sort_by_key(|(entry, layout)| (layout.form(), layout.cylinders().len(), entry.name));
    Ok(engines)
}

/// Whether this is a file of the catalogue, as it stands there.
pub fn is_of_catalogue(name: &str, text: &str) -> bool {
    find(name).is_some_and(|entry| entry.text == text)
}

/// The entry of this name, in upper or lower case; spaces around it, or the end of its line, do not count.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// assert_eq!(crankstar::file::find("v8-CROSSPLANE").unwrap().name, "V8-crossplane");
/// ```
pub fn find(name: &str) -> Option<Entry> {
    ENTRIES.iter().find(|entry| entry.name.eq_ignore_ascii_case(name.trim())).copied()
}
