//! Which engine is it in Python: a name of the catalogue, a text, a file, or keywords?

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

use super::error::{self, told};
use crate::engine::{self, Family};
use crate::file::{self, FileResolver, Layout};
use crate::text::decoded;

/// Files beside a layout: their names, and what is in them.
pub(super) type Files = Vec<(String, String)>;

/// A layout file, and the engine that it describes.
#[derive(Clone)]
pub(super) struct Source {
    /// What messages call the file.
    pub name: String,
    /// The file.
    pub text: String,
    /// The folder that it is in, if it is one on a disk.
    pub folder: Option<PathBuf>,
    /// What it names beside itself, once it was read.
    pub files: BTreeMap<String, String>,
}

impl Source {
    /// An engine of the catalogue.
    pub fn named(name: &str) -> PyResult<Self> {
        let Some(entry) = file::find(name) else {
            let catalogue = file::catalogue().map_err(|error| error::layout(&error))?;
            let names: Vec<&str> = catalogue.iter().map(|(entry, _)| entry.name).collect();
            return Err(told(format!("`{name}` is not an engine of the catalogue, which has {}", names.join(", "))));
        };
        Ok(Source { name: entry.name.to_owned(), text: entry.text.to_owned(), folder: None, files: BTreeMap::new() })
    }

    /// A layout file on a disk.
    pub fn on_disk(path: &Path) -> PyResult<Self> {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|error| match error.kind() {
            io::ErrorKind::InvalidData => told(format!("`{name}` is not a text in UTF-8; a TOML text is expected")),
            // With number and name Python finds the kind of the error itself.
            _ => match error.raw_os_error() {
                Some(number) => PyOSError::new_err((number, error.to_string(), name.clone())),
                None => PyErr::from(error),
            },
        })?;
        Ok(Source { name, text, folder: path.parent().map(Path::to_path_buf), files: BTreeMap::new() })
    }

    /// What a pickle holds.
    pub fn state(&self) -> (String, String, Files) {
        (self.name.clone(), self.text.clone(), self.files.clone().into_iter().collect())
    }

    /// What a pickle held.
    pub fn restored((name, text, files): (String, String, Files)) -> Self {
        Source { name, text, folder: None, files: files.into_iter().collect() }
    }

    /// The engine, and the family that it is a member of where the file gives values to symbols. The files beside it are kept.
    pub fn read(&mut self) -> PyResult<(engine::Engine, Option<Family>)> {
        let found = Mutex::new(BTreeMap::new());
        let read = |path: &str| {
            let text = self.beside(path)?;
            found.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned(), text.clone());
            Ok(text)
        };
        let is_ours = self.folder.is_none() && file::is_of_catalogue(&self.name, &self.text);
        let beside = FileResolver::new(&read).of_catalogue(is_ours);
        let layout = file::parse_layout_beside(&self.name, &self.text, beside);
        self.files = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        match layout.map_err(|error| error::layout(&error))? {
            Layout::Known(engine, family) => Ok((*engine, family.map(|family| *family))),
            Layout::Open(family) => {
                let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
                let right = "an engine of Python has values: give them below [values]";
                Err(told(format!("{}: the layout leaves {} open; {right}", self.name, unknowns.join(", "))))
            }
        }
    }

    /// A file that the layout names beside itself.
    pub fn beside(&self, path: &str) -> Result<String, String> {
        if let Some(text) = self.files.get(path) {
            return Ok(text.clone());
        }
        match &self.folder {
            Some(folder) => std::fs::read(folder.join(path))
                .map(|bytes| decoded(&bytes))
                .map_err(|error| format!("cannot read `{}`: {error}", folder.join(path).display())),
            None => Err("nothing is beside a layout that is not a file; read it with Engine.read(path)".to_owned()),
        }
    }
}
