//! Do these files hold all pieces of a question, and what is in each? Several files read as one.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use super::frame::{self, Frame};
use super::{Question, Shard, ShardError, Store};

/// Files of pieces, every digest of which was checked.
pub struct Merged {
    paths: Vec<PathBuf>,
    pieces: usize,
    /// For each piece the file that holds it, and where.
    found: BTreeMap<usize, (usize, Frame)>,
    /// A shard that one of the files says it is.
    shard: Option<Shard>,
}

impl Merged {
    /// Reads files, in any order; a piece may be in several of them.
    ///
    /// # Errors
    /// A file that is damaged, not finished, or of another question; two files that tell a piece differently.
    pub fn open(paths: &[PathBuf], question: &Question) -> Result<Self, ShardError> {
        let mut merged = Merged { paths: Vec::new(), pieces: question.pieces, found: BTreeMap::new(), shard: None };
        for path in paths {
            let file = File::open(path).map_err(|error| ShardError::reading(path, &error))?;
            let found = frame::read(path, &mut BufReader::with_capacity(1 << 20, file), question)?;
            if !found.is_finished {
                let count = found.frames.len();
                let what = format_args!("is not finished: it stops after {count} pieces; run its shard again");
                return Err(ShardError::of(path, what));
            }
            merged.shard = merged.shard.or(found.head.shard());
            for frame in found.frames {
                let known = merged.found.entry(frame.piece).or_insert((merged.paths.len(), frame));
                if (known.1.digest, known.1.length) != (frame.digest, frame.length) {
                    let other = merged.paths.get(known.0).map_or("itself".into(), |other| other.to_string_lossy());
                    let what = format_args!("and `{other}` differ in piece {}; compute both again", frame.piece);
                    return Err(ShardError::of(path, what));
                }
            }
            merged.paths.push(path.clone());
        }
        Ok(merged)
    }

    /// Sees to it that no piece is missing.
    ///
    /// # Errors
    /// Which shard is.
    pub fn whole(self) -> Result<Self, ShardError> {
        let missing: Vec<usize> = (0..self.pieces).filter(|piece| !self.found.contains_key(piece)).collect();
        let Some(first) = missing.first() else { return Ok(self) };
        let computes = match self.shard.filter(|shard| *shard != Shard::WHOLE) {
            Some(shard) => format!("; shard {} computes the first of them", shard.with(*first)),
            None => String::new(),
        };
        let (count, all) = (missing.len(), self.pieces);
        let are = if count == 1 { "is" } else { "are" };
        Err(ShardError(format!("{count} of the {all} pieces {are} in none of the files{computes}")))
    }

    /// The pieces that were found, rising.
    pub fn pieces(&self) -> impl Iterator<Item = usize> + '_ {
        self.found.keys().copied()
    }

    /// What is in a piece.
    ///
    /// # Errors
    /// A file that cannot be read any more, or has changed since.
    pub fn read(&self, piece: usize) -> Result<Vec<u8>, ShardError> {
        let Some((path, frame)) = self.found.get(&piece).and_then(|(at, frame)| Some((self.paths.get(*at)?, frame)))
        else {
            return Err(ShardError(format!("piece {piece} is in none of the files")));
        };
        let content = content(path, frame).map_err(|error| ShardError::reading(path, &error))?;
        match frame::digest(piece, &content) == frame.digest {
            true => Ok(content),
            false => Err(ShardError::of(path, "was changed while it was read")),
        }
    }

    /// Puts all pieces into one file.
    ///
    /// # Errors
    /// A file that cannot be read, or written.
    pub fn keep(&self, path: &Path, question: &Question) -> Result<(), ShardError> {
        let mut store = Store::open_merged(path, question)?;
        let there = store.pieces();
        let missing: Vec<usize> = self.pieces().filter(|piece| !there.contains(piece)).collect();
        if store.is_finished() && !missing.is_empty() {
            return Err(ShardError::of(path, "is finished, and holds other pieces; name another file"));
        }
        for piece in missing {
            store.put(piece, &self.read(piece)?)?;
        }
        store.finish()
    }
}

fn content(path: &Path, frame: &Frame) -> std::io::Result<Vec<u8>> {
    let mut file = File::open(path)?;
    file.seek(SeekFrom::Start(frame.start))?;
    let mut content = Vec::new();
    file.take(frame.length).read_to_end(&mut content)?;
    Ok(content)
}
