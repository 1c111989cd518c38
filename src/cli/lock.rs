//! Who may write to a folder? One process at a time, which holds its lock; the lock ends with the process at the latest.
//!
//! Unix locks the folder itself. Windows cannot, and renames or removes no folder with an open file in it: the lock of a staged
//! folder, which is to be renamed, is a file beside it; that of a folder which stays is a file in it.

pub use system::{lock, lock_abandoned, lock_staging};

#[cfg(unix)]
mod system {
    use std::fs::File;
    use std::io::{self, ErrorKind};
    use std::path::Path;

    /// Waits for the lock of a folder that stays.
    pub fn lock(folder: &Path) -> io::Result<File> {
        let handle = File::open(folder)?;
        match handle.lock() {
            // A file system without locks: there one writer at a time is the caller's.
            Err(error) if error.kind() == ErrorKind::Unsupported => Ok(handle),
            locked => locked.map(|()| handle),
        }
    }

    /// Waits for the lock of a staged folder.
    pub fn lock_staging(staging: &Path) -> io::Result<File> {
        lock(staging)
    }

    /// The lock of a staged folder, if nobody holds it.
    pub fn lock_abandoned(staging: &Path) -> Option<File> {
        File::open(staging).ok().filter(|handle| handle.try_lock().is_ok())
    }
}

#[cfg(not(unix))]
mod system {
    use std::fs::File;
    use std::io;
    use std::path::Path;
    use std::thread;
    use std::time::Duration;

    const ENDING: &str = "crankstar-lock";
    /// Somebody has the file open.
    const SHARING_VIOLATION: i32 = 32;
    /// The file is being deleted, or nobody may write here.
    const ACCESS_DENIED: i32 = 5;

    /// Waits for the lock of a folder that stays.
    pub fn lock(folder: &Path) -> io::Result<File> {
        wait_for(&folder.join(format!(".{ENDING}")))
    }

    /// Waits for the lock of a staged folder.
    pub fn lock_staging(staging: &Path) -> io::Result<File> {
        wait_for(&staging.with_extension(ENDING))
    }

    /// The lock of a staged folder, if nobody holds it.
    pub fn lock_abandoned(staging: &Path) -> Option<File> {
        hold(&staging.with_extension(ENDING)).ok()
    }

    /// Opens a file that nobody else can open meanwhile. The system deletes it when it is closed, which a killed process does too.
    #[cfg(windows)]
    fn hold(path: &Path) -> io::Result<File> {
        use std::os::windows::fs::OpenOptionsExt;
        const FILE_FLAG_DELETE_ON_CLOSE: u32 = 0x0400_0000;
        let mut options = File::options();
        options.write(true).create(true).truncate(false).share_mode(0).custom_flags(FILE_FLAG_DELETE_ON_CLOSE);
        options.open(path)
    }

    /// A system without locks: one writer at a time is the caller's.
    #[cfg(not(windows))]
    fn hold(path: &Path) -> io::Result<File> {
        File::create(path)
    }

    fn wait_for(path: &Path) -> io::Result<File> {
        let mut refusals = 0;
        loop {
            let error = match hold(path) {
                Ok(held) => return Ok(held),
                Err(error) => error,
            };
            match error.raw_os_error() {
                Some(SHARING_VIOLATION) => {}
                Some(ACCESS_DENIED) if refusals < 20 => refusals += 1,
                _ => return Err(error),
            }
            thread::sleep(Duration::from_millis(50));
        }
    }
}
