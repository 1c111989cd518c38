//! How does a layout file read what lies beside it? By a function of whoever reads the layout; this room opens no file.

use std::fmt;

/// Reads a file that a layout names: a relative path in, its text or what is wrong out.
#[derive(Clone, Copy)]
pub struct FileResolver<'a>(&'a (dyn Fn(&str) -> Result<String, String> + Sync));

impl<'a> FileResolver<'a> {
    /// What this function reads.
    pub fn new(read: &'a (dyn Fn(&str) -> Result<String, String> + Sync)) -> Self {
        FileResolver(read)
    }

    /// The text of a file.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn read(self, path: &str) -> Result<String, String> {
        let parts = path.split(['/', '\\']);
        let is_below = parts.clone().all(|part| !part.is_empty() && part != "..") && !path.contains(':');
        match is_below {
            true => (self.0)(path),
            false => Err("it is beside the layout file, or in a folder below: such as \"indicator.csv\"".to_owned()),
        }
    }
}

impl FileResolver<'static> {
    /// Nothing lies beside a layout that is only a text.
    pub fn nothing() -> Self {
        FileResolver(&|_| {
            Err("nothing beside this layout can be read here; write its rows into it: pressure = [[angle, pressure], …]".to_owned())
        })
    }
}

impl fmt::Debug for FileResolver<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Beside")
    }
}
