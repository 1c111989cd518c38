//! How are files put into a folder? A new folder is whole or absent; in an old one each file is replaced whole, the first last.
//!
//! Who writes holds a lock on the folder that it fills, so that a second writer waits, and what a killed one left is known by
//! its lock being free.

use std::fs::{self, File as Handle};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crankstar::page::File;

use super::failure::Failure;
use super::layouts::shown;
use super::lock::{lock, lock_abandoned, lock_staging};

/// Marks folders and files that are not finished.
const ENDING: &str = "crankstar-partial";

/// The name of a file, and what it holds.
type Content<'a> = (&'a str, &'a [u8]);

/// Writes the files into a folder, the first of which is the page that leads to the others.
pub fn write(folder: &Path, files: &[File]) -> Result<(), Failure> {
    let contents: Vec<Content> = files.iter().map(|file| (file.name.as_str(), file.text.as_bytes())).collect();
    write_contents(folder, &contents)
}

/// Writes one file whole, through a link too; `example` is a name that it could have.
pub fn write_file(path: &Path, content: &[u8], example: &str) -> Result<(), Failure> {
    let fail = |error: io::Error| Failure::new(format!("cannot write `{}`: {error}", shown(path)));
    let Some(path) = followed(path) else { return fs::write(path, content).map_err(fail) };
    let (parent, name) = parts(&path, example)?;
    place(parent, &[(name, content)]).map_err(fail)
}

/// The file itself where a link leads to one; none of a device or a pipe, which is written to and stays.
fn followed(path: &Path) -> Option<PathBuf> {
    let is_device = path.metadata().is_ok_and(|there| !there.is_file() && !there.is_dir());
    (!is_device).then(|| path.canonicalize().unwrap_or_else(|_| path.to_owned()))
}

/// The folder and the name of a file.
fn parts<'a>(path: &'a Path, example: &str) -> Result<(&'a Path, &'a str), Failure> {
    let name = path.file_name().filter(|_| !path.is_dir()).and_then(|name| name.to_str());
    let Some(name) = name else {
        let path = shown(path);
        return Err(Failure::new(format!("`{path}` is not a name of a file, such as {example}")));
    };
    let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty());
    Ok((parent.unwrap_or(Path::new(".")), name))
}

/// Writes one file that grows under another name, and has its own when it is whole; `example` is a name that it could have.
pub fn grow_file(path: &Path, example: &str, fill: impl FnOnce(Handle) -> Result<(), Failure>) -> Result<(), Failure> {
    let fail = |error: io::Error| Failure::new(format!("cannot write `{}`: {error}", shown(path)));
    let Some(path) = followed(path) else {
        return Handle::options().write(true).open(path).map_err(fail).and_then(fill);
    };
    let (parent, name) = parts(&path, example)?;
    fs::create_dir_all(parent).map_err(fail)?;
    clear_abandoned(parent, name);
    let (staging, lock) = staging(parent, name).map_err(fail)?;
    let partial = staging.join(name);
    let grown = Handle::create_new(&partial).map_err(fail).and_then(fill);
    let placed = grown.and_then(|()| {
        let synced = Handle::options().write(true).open(&partial).and_then(|file| file.sync_all());
        synced.and_then(|()| fs::rename(&partial, &path)).and_then(|()| sync(parent)).map_err(fail)
    });
    // What was staged is of no use to anyone by now; the first error is the one to tell.
    let _ = fs::remove_dir_all(&staging);
    drop(lock);
    placed
}

/// The same of any files.
pub fn write_contents(folder: &Path, files: &[Content]) -> Result<(), Failure> {
    let fail = |error: io::Error| Failure::new(format!("cannot write the folder `{}`: {error}", shown(folder)));
    place(folder, files).map_err(fail)
}

fn place(folder: &Path, files: &[Content]) -> io::Result<()> {
    if folder.exists() && !folder.is_dir() {
        return Err(io::Error::new(ErrorKind::NotADirectory, format!("`{}` is a file", shown(folder))));
    }
    if folder.is_dir() {
        return fill(folder, files);
    }
    let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(parent)?;
    match folder.file_name() {
        Some(name) => new_folder(folder, parent, &name.to_string_lossy(), files),
        // `a/..` and the like: there, since its parent is.
        None => fill(folder, files),
    }
}

/// Where this was written, for the terminal.
pub fn written(folder: &Path, files: &[File]) -> String {
    format!("Written: {}\n", shown(&folder.join(&files[0].name)))
}

/// Fills a folder beside the wanted one, and gives it the name when it is whole.
fn new_folder(folder: &Path, parent: &Path, name: &str, files: &[Content]) -> io::Result<()> {
    clear_abandoned(parent, name);
    let (staging, lock) = staging(parent, name)?;
    let outcome = fill_locked(&staging, files).and_then(|()| match fs::rename(&staging, folder) {
        // Another writer was first, so that the folder is there by now.
        Err(_) if folder.is_dir() => fill(folder, files).and_then(|()| fs::remove_dir_all(&staging)),
        renamed => renamed,
    });
    if outcome.is_err() {
        // What was staged is of no use to anyone; the first error is the one to tell.
        let _ = fs::remove_dir_all(&staging);
    }
    drop(lock);
    outcome.and_then(|()| sync(parent))
}

/// A folder of this process alone, locked.
fn staging(parent: &Path, name: &str) -> io::Result<(PathBuf, Handle)> {
    let mut attempt = 0_u32;
    loop {
        let staging = parent.join(format!(".{name}.{}-{attempt}.{ENDING}", std::process::id()));
        attempt += 1;
        match fs::create_dir(&staging) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => continue,
            created => created?,
        }
        // Before the lock is held, somebody may take it for abandoned and remove it.
        match lock_staging(&staging) {
            Err(error) if error.kind() == ErrorKind::NotFound => continue,
            lock if staging.is_dir() => return Ok((staging, lock?)),
            _ => continue,
        }
    }
}

/// Removes what killed runs have staged for this folder: their locks are free.
fn clear_abandoned(parent: &Path, name: &str) {
    let begin = format!(".{name}.");
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let found = entry.file_name().to_string_lossy().into_owned();
        let number = found.strip_prefix(&begin).and_then(|rest| rest.strip_suffix(ENDING));
        let is_ours = number.is_some_and(|number| {
            number.ends_with('.') && number.trim_end_matches('.').bytes().all(|b| b.is_ascii_digit() || b == b'-')
        });
        if let Some(_lock) = is_ours.then(|| lock_abandoned(&entry.path())).flatten() {
            // Nobody waits for it; what cannot be removed stays.
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

/// Replaces the files of a folder that is there, one writer at a time.
fn fill(folder: &Path, files: &[Content]) -> io::Result<()> {
    let lock = lock(folder)?;
    let outcome = fill_locked(folder, files);
    drop(lock);
    outcome
}

fn fill_locked(folder: &Path, files: &[Content]) -> io::Result<()> {
    are_free(folder, files)?;
    let partial = folder.join(format!(".{ENDING}"));
    let Some((first, others)) = files.split_first() else { return Ok(()) };
    for (name, content) in others.iter().chain([first]) {
        let place = folder.join(name);
        // A name may lead into a folder inside this one.
        let inside = place.parent().filter(|inside| *inside != folder);
        let placed = inside.map_or(Ok(()), fs::create_dir_all).and_then(|()| put(&partial, &place, content));
        if placed.is_err() {
            let _ = fs::remove_file(&partial);
        }
        placed?;
    }
    sync(folder)
}

/// What keeps a file from its place is reported before the first one is replaced.
fn are_free(folder: &Path, files: &[Content]) -> io::Result<()> {
    let told = |kind: ErrorKind, what: &str| Err(io::Error::new(kind, what.to_owned()));
    for (name, _) in files {
        let place = folder.join(name);
        if fs::symlink_metadata(&place).is_ok_and(|there| there.is_dir()) {
            let what = format!("`{}` is a folder, where a file is needed; remove it", shown(&place));
            return told(ErrorKind::IsADirectory, &what);
        }
        let mut inside = place.ancestors().skip(1).take_while(|inside| *inside != folder);
        if let Some(file) = inside.find(|inside| inside.exists() && !inside.is_dir()) {
            let what = format!("`{}` is a file, where a folder is needed; remove it", shown(file));
            return told(ErrorKind::NotADirectory, &what);
        }
    }
    Ok(())
}

/// Writes a file under another name, and gives it its own when it is on the disk.
fn put(partial: &Path, place: &Path, content: &[u8]) -> io::Result<()> {
    // A killed run may have left one; it is not written through, for it may be a link by now.
    match fs::remove_file(partial) {
        Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
        _ => {}
    }
    let mut file = Handle::create_new(partial)?;
    file.write_all(content)?;
    file.sync_all()?;
    fs::rename(partial, place)
}

/// The names in a folder reach the disk.
fn sync(folder: &Path) -> io::Result<()> {
    if cfg!(unix) { Handle::open(folder)?.sync_all() } else { Ok(()) }
}
