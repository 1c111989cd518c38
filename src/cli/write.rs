//! How is the answer written? Whole, or not at all.

use std::io::{ErrorKind, Write};
use std::path::Path;
use std::{fs, io};

use crankstar::report::File;

use super::failure::Failure;

/// Prints a text; a reader that has seen enough and closes the pipe is no failure.
pub fn to_stdout(text: &str) -> Result<(), Failure> {
    let mut out = anstream::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::new(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes the files into a folder: all are written beside it first, and then moved to their places.
pub fn to_folder(folder: &Path, files: &[File]) -> Result<(), Failure> {
    let fail = |error: io::Error| Failure::new(format!("cannot write the folder `{}`: {error}", folder.display()));
    if folder.exists() && !folder.is_dir() {
        return Err(Failure::new(format!("`{}` is a file; --output names a folder", folder.display())));
    }
    let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(parent).map_err(fail)?;
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let staging = parent.join(format!(".{name}.{}.partial", std::process::id()));
    let outcome = stage_and_move(&staging, folder, files);
    if outcome.is_err() {
        // What was staged is of no use to anyone; the first error is the one to tell.
        let _ = fs::remove_dir_all(&staging);
    }
    outcome.map_err(fail)
}

fn stage_and_move(staging: &Path, folder: &Path, files: &[File]) -> io::Result<()> {
    fs::create_dir(staging)?;
    for file in files {
        fs::write(staging.join(&file.name), &file.text)?;
    }
    if !folder.exists() {
        return fs::rename(staging, folder);
    }
    for file in files {
        fs::rename(staging.join(&file.name), folder.join(&file.name))?;
    }
    fs::remove_dir(staging)
}
