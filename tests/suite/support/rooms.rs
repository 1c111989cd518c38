//! Where are the rooms? Those of the kernel in `src/kernel`, the others in `src`.

use std::fs;
use std::path::{Path, PathBuf};

/// The folders of the rooms; that of the build script is none.
pub fn folders() -> Vec<PathBuf> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let kernel = source.join("kernel");
    let below =
        |folder: &Path| fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    let all: [Vec<PathBuf>; 2] = [below(&source), below(&kernel)];
    let others = [kernel, source.join("embed")];
    all.concat().into_iter().filter(|path| path.is_dir() && !others.contains(path)).collect()
}

/// The name of a room.
pub fn name(folder: &Path) -> String {
    folder.file_name().expect("a name").to_string_lossy().into_owned()
}

/// A file of a room, from the folder on in which its room stands: `exact/decide.rs`.
pub fn path_in_crate(file: &Path) -> &Path {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let below = file.strip_prefix(source).expect("a file of src");
    below.strip_prefix("kernel").unwrap_or(below)
}
