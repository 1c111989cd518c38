//! What does the second checker, `formal/verify.py`, say of documents?

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use serde::Serialize;

use super::program::scratch;

/// What it prints, and its exit code; none where there is no Python.
pub fn second_checker(files: &[PathBuf]) -> Option<(String, i32)> {
    run(&Path::new(env!("CARGO_MANIFEST_DIR")).join("formal/verify.py"), files)
}

/// The same of a copy of it.
pub fn run(script: &Path, files: &[PathBuf]) -> Option<(String, i32)> {
    let Some(python) = python() else {
        eprintln!("SKIPPED: there is no python3, so formal/verify.py is not run");
        return None;
    };
    // It needs no package, and begins in half the time where none is looked for.
    let output = Command::new(python).args(["-E", "-S", "-X", "utf8"]).arg(script).args(files).output();
    let output = output.expect("Python runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.is_empty(), "{errors}");
    Some((String::from_utf8(output.stdout).expect("UTF-8"), output.status.code().expect("an exit code")))
}

/// Python itself: `python3` may be a script that looks for it each time.
fn python() -> Option<&'static Path> {
    static PYTHON: OnceLock<Option<PathBuf>> = OnceLock::new();
    let found = || {
        let asked = Command::new("python3").args(["-c", "import sys; print(sys.executable)"]).output().ok()?;
        let path = String::from_utf8(asked.stdout).ok().filter(|_| asked.status.success())?;
        Some(PathBuf::from(path.trim()))
    };
    PYTHON.get_or_init(found).as_deref()
}

/// Fails unless it verifies every document, and does not leave out any of `due`: what it may name as "not checked".
#[track_caller]
pub fn accepts<T: Serialize>(documents: &[T], due: &[&str]) {
    let files = written(documents);
    let Some((told, code)) = second_checker(&files) else { return };
    let verified = told.lines().filter(|line| line.contains(": verified, ")).count();
    assert!(code == 0 && verified == files.len(), "{code}\n{told}");
    for words in due {
        assert!(!told.contains(words), "{told}");
    }
}

/// Fails unless it refuses every document, each a cheat with a name.
#[track_caller]
pub fn refuses<T: Serialize>(cheats: &[(&str, T)]) {
    let documents: Vec<&T> = cheats.iter().map(|(_, document)| document).collect();
    let files = written(&documents);
    let Some((told, _)) = second_checker(&files) else { return };
    for (path, (name, _)) in files.iter().zip(cheats) {
        let about = format!("{}: ", path.display());
        let line = told.lines().find(|line| line.starts_with(&about)).unwrap_or_default();
        assert!(line.starts_with(&format!("{about}refused at ")), "{name}: {line}");
    }
}

fn written<T: Serialize>(documents: &[T]) -> Vec<PathBuf> {
    static CALLS: AtomicUsize = AtomicUsize::new(0);
    let folder = scratch(&format!("second-checker-{}", CALLS.fetch_add(1, Ordering::Relaxed)));
    let file = |(index, document): (usize, &T)| {
        let path = folder.join(format!("{index}.json"));
        fs::write(&path, serde_json::to_string(document).expect("JSON")).expect("written");
        path
    };
    documents.iter().enumerate().map(file).collect()
}
