//! How does a layout file read what lies beside it? By a function of whoever reads the layout; this room opens no file.

use std::fmt;

use crate::text::Untrusted;

/// Where a layout file lies: what reads the files beside it, a relative path in, a text or what is wrong out; and whether it is of the catalogue.
#[derive(Clone, Copy)]
pub struct FileResolver<'a> {
    read: &'a (dyn Fn(&str) -> Result<String, String> + Sync),
    is_of_catalogue: bool,
}

impl<'a> FileResolver<'a> {
    /// What this function reads.
    pub fn new(read: &'a (dyn Fn(&str) -> Result<String, String> + Sync)) -> Self {
        FileResolver { read, is_of_catalogue: false }
    }

    /// The same of a layout that is a file of the catalogue, or is none.
    #[must_use]
    pub fn of_catalogue(self, is_of_catalogue: bool) -> Self {
        FileResolver { is_of_catalogue, ..self }
    }

    /// A title that the layout has: that of an engine of the catalogue, or a person's.
    pub(super) fn title(self, written: Untrusted) -> Untrusted {
        if self.is_of_catalogue { written.of_catalogue() } else { written }
    }

    /// The text of a file.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn read(self, path: &str) -> Result<String, String> {
        let parts = path.split(['/', '\\']);
        let is_below = parts.clone().all(|part| !part.is_empty() && part != "..") && !path.contains(':');
        match is_below {
            true => (self.read)(path),
            false => Err("it is beside the layout file, or in a folder below: such as \"indicator.csv\"".to_owned()),
        }
    }
}

impl FileResolver<'static> {
    /// Nothing lies beside a layout that is only a text.
    pub fn nothing() -> Self {
        FileResolver::new(&|_| {
            Err("nothing beside this layout can be read here; write its rows into it: pressure = [[angle, pressure], …]".to_owned())
        })
    }
}

impl fmt::Debug for FileResolver<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Beside")
    }
}
