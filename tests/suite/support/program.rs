//! How is the program called, and where may a test write?

use std::ffi::OsStr;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The program, to be given arguments.
pub fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_crankstar"))
}

/// What comes of a call.
pub fn call<A: AsRef<OsStr>>(arguments: &[A]) -> Output {
    program().args(arguments).output().expect("the program starts")
}

/// The folder of this process: tests run one in a process as well as all in one, and several runs beside each other.
fn own() -> &'static Path {
    static OWN: OnceLock<(PathBuf, File)> = OnceLock::new();
    let (folder, _) = OWN.get_or_init(|| {
        let all = Path::new(env!("CARGO_TARGET_TMPDIR"));
        sweep_up(all);
        let name = format!("suite-{}", std::process::id());
        let lock = File::create(all.join(format!("{name}.lock"))).expect("a file");
        lock.lock().expect("a lock");
        let _ = fs::remove_dir_all(all.join(&name));
        (all.join(name), lock)
    });
    folder
}

/// Removes the folders of processes that ended: nobody holds their locks.
fn sweep_up(all: &Path) {
    let entries = fs::read_dir(all).into_iter().flatten().flatten().map(|entry| entry.path());
    for path in entries.filter(|path| path.extension().is_some_and(|ending| ending == "lock")) {
        let lock = File::open(&path);
        if lock.as_ref().is_ok_and(|lock| lock.try_lock().is_ok()) {
            let _ = fs::remove_dir_all(path.with_extension(""));
            let _ = fs::remove_file(&path);
        }
    }
}

/// A fresh folder, each call another.
pub fn scratch(name: &str) -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let folder = own().join(format!("{name}-{}", COUNT.fetch_add(1, Ordering::Relaxed)));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}
