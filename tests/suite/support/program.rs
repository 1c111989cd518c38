//! How is the program called, and where may a test write?

use std::ffi::OsStr;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// The program, to be given arguments.
pub fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_crankstar"))
}

/// What comes of a call.
pub fn call<A: AsRef<OsStr>>(arguments: &[A]) -> Output {
    program().args(arguments).output().expect("the program starts")
}

/// A fresh folder for one test.
pub fn scratch(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}
