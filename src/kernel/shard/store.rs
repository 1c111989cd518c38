//! How are finished pieces kept? In a file that grows by one piece at a time, and goes on where a stop cut it off.

use std::collections::BTreeSet;
use std::fs::{self, File, TryLockError};
use std::io::{BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use super::frame::{self, Frame, Head};
use super::{Question, Shard, ShardError};

/// A file of pieces that is being written by this process alone.
pub struct Store {
    path: PathBuf,
    file: File,
    head: Head,
    frames: Vec<Frame>,
    is_finished: bool,
}

impl Store {
    /// Opens the file of a shard, which may hold pieces of an earlier run; makes it where there is none.
    ///
    /// # Errors
    /// A file of something else, of another question or shard, one that is damaged, or that another process is writing.
    pub fn open(path: &Path, question: &Question, shard: Shard) -> Result<Self, ShardError> {
        Self::of(path, question, Some(shard))
    }

    /// The same for pieces of several shards.
    ///
    /// # Errors
    /// As for [`Store::open`].
    pub fn open_merged(path: &Path, question: &Question) -> Result<Self, ShardError> {
        Self::of(path, question, None)
    }

    fn of(path: &Path, question: &Question, shard: Option<Shard>) -> Result<Self, ShardError> {
        let writing = |error: &std::io::Error| ShardError::writing(path, error);
        if let Some(parent) = path.parent().filter(|parent| !parent.as_os_str().is_empty()) {
            fs::create_dir_all(parent).map_err(|error| writing(&error))?;
        }
        let mut options = fs::OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(path).map_err(|error| writing(&error))?;
        if is_held(&file) {
            return Err(ShardError::of(path, "is being written by another process"));
        }
        let head = Head::new(question, shard);
        let begin = head.as_line().map_err(|error| writing(&error))?;
        let mut store = Store { path: path.to_owned(), file, head, frames: Vec::new(), is_finished: false };
        if store.stops_within(begin.as_bytes())? {
            store.cut(0)?;
            store.add(begin.as_bytes())?;
            return Ok(store);
        }
        file = store.file.try_clone().map_err(|error| writing(&error))?;
        file.seek(SeekFrom::Start(0)).map_err(|error| writing(&error))?;
        let found = frame::read(path, &mut BufReader::with_capacity(1 << 20, file), question)?;
        if found.head.shard != store.head.shard {
            let holds = found.head.shard().map_or("pieces of several shards".to_owned(), |it| format!("shard {it}"));
            return Err(ShardError::of(path, format_args!("holds {holds}; name another file")));
        }
        if !found.is_finished {
            store.cut(found.whole)?;
        }
        Ok(Store { frames: found.frames, is_finished: found.is_finished, ..store })
    }

    /// Whether the file stops within its head: nothing is in it yet.
    fn stops_within(&mut self, begin: &[u8]) -> Result<bool, ShardError> {
        let mut there = Vec::new();
        let read = (&self.file).take(begin.len() as u64).read_to_end(&mut there);
        read.map_err(|error| ShardError::reading(&self.path, &error))?;
        Ok(there.len() < begin.len() && begin.starts_with(&there))
    }

    /// Cuts off what is behind this place, and goes on there.
    fn cut(&mut self, length: u64) -> Result<(), ShardError> {
        let cut = self.file.set_len(length).and_then(|()| self.file.seek(SeekFrom::Start(length)));
        cut.map(drop).map_err(|error| ShardError::writing(&self.path, &error))
    }

    fn add(&mut self, bytes: &[u8]) -> Result<(), ShardError> {
        let written = self.file.write_all(bytes).and_then(|()| self.file.sync_data());
        written.map_err(|error| ShardError::writing(&self.path, &error))
    }

    /// The pieces that are in it.
    pub fn pieces(&self) -> BTreeSet<usize> {
        self.frames.iter().map(|frame| frame.piece).collect()
    }

    /// Whether its end is written.
    pub fn is_finished(&self) -> bool {
        self.is_finished
    }

    /// Adds a piece; it is on the disk when this returns.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn put(&mut self, piece: usize, content: &[u8]) -> Result<(), ShardError> {
        let digest = frame::digest(piece, content);
        let frame = Frame { piece, start: 0, length: content.len() as u64, digest };
        let mut bytes = frame.line().into_bytes();
        bytes.extend_from_slice(content);
        self.add(&bytes)?;
        self.frames.push(frame);
        Ok(())
    }

    /// Ends the file: all that belongs in it is there.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn finish(mut self) -> Result<(), ShardError> {
        if self.is_finished {
            return Ok(());
        }
        self.add(frame::end(&self.frames).as_bytes())
    }
}

/// How often, and how long apart, a lock is asked for: that of a process which was killed, or is starting another, goes at once.
const ASKED: u32 = 20;
const APART: Duration = Duration::from_millis(50);

/// Whether another process holds the file; else this one does.
fn is_held(file: &File) -> bool {
    for time in 0..ASKED {
        match file.try_lock() {
            Err(TryLockError::WouldBlock) if time + 1 < ASKED => thread::sleep(APART),
            Err(TryLockError::WouldBlock) => return true,
            // A file system without locks: there one writer at a time is the caller's.
            Ok(()) | Err(TryLockError::Error(_)) => return false,
        }
    }
    true
}
