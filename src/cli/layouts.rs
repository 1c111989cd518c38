//! Which engine is meant: a name of the catalogue, or the path of a layout file?

use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

use crankstar::classroom::{self, Scheme};
use crankstar::engine::Engine;
use crankstar::file::{self, Entry, FileResolver, Layout, LayoutWarning};
use crankstar::text::{decoded, harmless};

use super::failure::Failure;
use super::write;

/// Layout files are small; a larger file is something else.
const LARGEST_FILE: u64 = 4 << 20;

/// The name of a layout that is read from standard input, and what messages call it.
const STANDARD_INPUT: (&str, &str) = ("-", "standard input");

/// Reads the engine of this name or path; what is odd about its quantities is reported on standard error.
pub fn read(layout: &Path) -> Result<Layout, Failure> {
    let (name, text) = source(layout)?;
    parsed(layout, &name, &text)
}

/// The same of one whose name and text are at hand.
pub fn parsed(layout: &Path, name: &str, text: &str) -> Result<Layout, Failure> {
    match file::parse_layout_beside(name, text, resolver(layout, &|path| beside(layout, path))) {
        Ok(read) => {
            warn(file::warnings(name, text, &read));
            Ok(read)
        }
        Err(error) => {
            // A length in millimetres that is read in metres makes a crank that cannot turn.
            warn(file::warnings_of_values(name, text));
            Err(error.into())
        }
    }
}

/// The same of an engine without unknowns, which this `needs`: `the torque needs`.
pub fn known(layout: &Path, needs: &str) -> Result<Engine, Failure> {
    without_unknowns(read(layout)?, needs)
}

/// The engine of a layout that leaves nothing open.
pub fn without_unknowns(layout: Layout, needs: &str) -> Result<Engine, Failure> {
    match layout {
        Layout::Known(engine, _) => Ok(*engine),
        Layout::Open(_) => {
            Err(Failure::new(format!("{needs} an engine without unknowns; give them values below [values]")))
        }
    }
}

/// The same engine, in which a cylinder may misfire.
pub fn firing(layout: &Path, needs: &str, misfire: Option<&str>) -> Result<Engine, Failure> {
    let engine = known(layout, needs)?;
    match misfire {
        None => Ok(engine),
        Some(name) => engine.misfiring(name).map_err(Failure::new),
    }
}

/// The warnings alone, of a layout that is read in another way.
pub fn warn_of(layout: &Path) {
    // What is wrong with it is reported by whoever reads it.
    let _ = read(layout);
}

/// Tells what is odd about the quantities of a file, once.
pub fn warn(warnings: Vec<LayoutWarning>) {
    static TOLD: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    for warning in warnings {
        let is_new = TOLD.lock().is_ok_and(|mut told| told.insert(warning.to_string()));
        if is_new {
            write::warn(&warning.to_string());
        }
    }
}

/// Where a layout lies, whose neighbours this reads.
pub fn resolver<'a>(layout: &Path, read: &'a (dyn Fn(&str) -> Result<String, String> + Sync)) -> FileResolver<'a> {
    FileResolver::new(read).of_catalogue(named(layout).is_some())
}

/// The text of a file that a layout file names beside itself; what is wrong with it in one line.
pub fn beside(layout: &Path, path: &str) -> Result<String, String> {
    if named(layout).is_some() {
        return Err("nothing is beside an engine of the catalogue".to_owned());
    }
    let path = layout.parent().unwrap_or(Path::new("")).join(path);
    // Tables come from instruments and spreadsheets, in encodings of their own.
    read_bytes(&path).map(|bytes| decoded(&bytes)).map_err(|failure| failure.message().to_owned())
}

/// The engine of the catalogue that an argument names.
pub fn named(layout: &Path) -> Option<Entry> {
    file::find(layout.to_str()?)
}

/// The name that messages show of a layout, and its text.
pub fn source(layout: &Path) -> Result<(String, String), Failure> {
    match named(layout) {
        Some(entry) => Ok((entry.name.to_owned(), entry.text.to_owned())),
        None if looks_like_a_name(layout) && !layout.exists() => Err(unknown(&shown(layout))),
        None => Ok((shown(layout), read_text(layout)?)),
    }
}

/// Whether an argument may be meant as a name of the catalogue: none of those has a dot.
fn looks_like_a_name(layout: &Path) -> bool {
    !is_standard_input(layout) && !layout.to_string_lossy().contains(['/', '\\', '.'])
}

fn unknown(layout: &str) -> Failure {
    let hint = near(layout).unwrap_or_else(|| "`crankstar list` shows the names".to_owned());
    Failure::new(format!("`{layout}` is neither an engine of the catalogue nor a file; {hint}"))
}

/// A path in one line, to be read by a person.
pub fn shown(path: &Path) -> String {
    if is_standard_input(path) { STANDARD_INPUT.1.to_owned() } else { harmless(&path.to_string_lossy()) }
}

/// Refuses arguments that name standard input twice: it is read once.
///
/// # Errors
/// That it is.
pub fn read_once<'a>(paths: impl IntoIterator<Item = &'a PathBuf>) -> Result<(), Failure> {
    match paths.into_iter().filter(|path| is_standard_input(path)).count() {
        0 | 1 => Ok(()),
        _ => Err(Failure::misuse("standard input is named twice, and can be read once; write one of them into a file")),
    }
}

/// Whether a path is `-`.
pub fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == STANDARD_INPUT.0
}

/// The text of a layout or claims file, of standard input for `-`.
pub fn read_text(path: &Path) -> Result<String, Failure> {
    String::from_utf8(bytes(path)?).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = valid.iter().filter(|byte| **byte == b'\n').count() + 1;
        Failure::new(format!("`{}` is not in UTF-8, in line {line}; save it as UTF-8", shown(path)))
    })
}

/// A text of a spreadsheet or an old editor, in an encoding of its own.
pub fn read_any_text(path: &Path) -> Result<String, Failure> {
    let text = decoded(&bytes(path)?);
    if text.contains('\0') { Err(Failure::new(format!("`{}` is not a text", shown(path)))) } else { Ok(text) }
}

fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    if is_standard_input(path) { standard_input() } else { read_bytes(path) }
}

/// The scheme of this file, or the usual one.
pub fn scheme(path: Option<&Path>) -> Result<Scheme, Failure> {
    match path {
        None => Ok(Scheme::default()),
        Some(path) => Ok(classroom::parse_scheme(&shown(path), &read_text(path)?)?),
    }
}

/// All of standard input, which is read once, however often it is asked for.
fn standard_input() -> Result<Vec<u8>, Failure> {
    static READ: OnceLock<Result<Vec<u8>, String>> = OnceLock::new();
    let all = || {
        let mut bytes = Vec::new();
        match std::io::stdin().lock().take(LARGEST_FILE + 1).read_to_end(&mut bytes) {
            Ok(_) if bytes.len() as u64 > LARGEST_FILE => {
                Err("standard input is larger than 4 MiB, the limit for such files".to_owned())
            }
            Ok(_) => Ok(bytes),
            Err(error) => Err(format!("cannot read standard input: {error}")),
        }
    };
    READ.get_or_init(all).clone().map_err(Failure::new)
}

/// What a file holds, whatever it is.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let file = shown(path);
    let metadata = path.metadata().map_err(|error| not_found(&file, &error))?;
    if !metadata.is_file() {
        let expected = near(&file).map(|near| format!("; {near}")).unwrap_or_default();
        return Err(Failure::new(format!("`{file}` is not a file{expected}")));
    }
    if metadata.len() > LARGEST_FILE {
        return Err(Failure::new(format!("`{file}` is larger than 4 MiB, the limit for such files")));
    }
    std::fs::read(path).map_err(|error| Failure::new(format!("cannot read `{file}`: {error}")))
}

fn not_found(layout: &str, error: &std::io::Error) -> Failure {
    // Who asks has not looked it up there.
    if error.kind() == std::io::ErrorKind::NotFound && file::find(layout).is_some() {
        let words = "is an engine of the catalogue, and this command reads a file of its own";
        return Failure::new(format!("`{layout}` {words}"));
    }
    Failure::new(format!("cannot read `{layout}`: {error}"))
}

/// The engines of the catalogue whose names begin alike; none where no name does.
fn near(layout: &str) -> Option<String> {
    let family = |name: &str| name.split('-').next().unwrap_or(name).to_ascii_lowercase();
    let catalogue = file::catalogue().unwrap_or_default();
    let near: Vec<&str> =
        catalogue.iter().map(|(entry, _)| entry.name).filter(|name| family(name) == family(layout)).collect();
    (!near.is_empty()).then(|| format!("the catalogue has {}", near.join(", ")))
}
