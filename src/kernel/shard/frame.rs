//! How does a file of pieces look? A line of the format, the question, then piece after piece, each with its digest, and an end.
//!
//! ```text
//! crankstar pieces 1
//! {"words":"…","pieces":123,"shard":"2/8"}
//! crc32 0123abcd
//! piece 1 40000 89abcdef
//! … 40000 bytes …
//! end 15 4567cdef
//! ```

use std::io::{self, BufRead, Read};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::{Question, Shard, ShardError};

/// The first line: a format that changes gets another number.
const FORMAT: &str = "crankstar pieces 1";
/// Longer lines than this are none of this format.
const LONGEST_LINE: u64 = 4 << 20;

/// What a file says of itself.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Head {
    pub words: String,
    pub pieces: usize,
    /// `2/8`; none where pieces of several shards are in it.
    pub shard: Option<String>,
}

/// Where a piece is in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    pub piece: usize,
    pub start: u64,
    pub length: u64,
    pub digest: u32,
}

/// What was found in a file: its head, its whole pieces, and how it ends.
pub(super) struct Found {
    pub head: Head,
    pub frames: Vec<Frame>,
    /// Whether the end is there; else the file stops, perhaps within a piece.
    pub is_finished: bool,
    /// Bytes up to the end of the last whole piece.
    pub whole: u64,
}

impl Head {
    pub fn new(question: &Question, shard: Option<Shard>) -> Self {
        Head { words: question.words.clone(), pieces: question.pieces, shard: shard.map(|shard| shard.to_string()) }
    }

    /// The shard that it says it is of.
    pub fn shard(&self) -> Option<Shard> {
        self.shard.as_deref().and_then(|shard| Shard::parse(shard).ok())
    }

    /// The lines at the beginning of the file.
    pub fn as_line(&self) -> io::Result<String> {
        let json = serde_json::to_string(self)?;
        let digest = crc32fast::hash(json.as_bytes());
        Ok(format!("{FORMAT}\n{json}\ncrc32 {digest:08x}\n"))
    }
}

/// The digest of a piece: of its number and what it holds, so that no piece can stand for another.
pub(super) fn digest(piece: usize, content: &[u8]) -> u32 {
    let mut digest = crc32fast::Hasher::new();
    digest.update(&(piece as u64).to_le_bytes());
    digest.update(content);
    digest.finalize()
}

impl Frame {
    /// The line before the piece.
    pub fn line(&self) -> String {
        format!("piece {} {} {:08x}\n", self.piece, self.length, self.digest)
    }
}

/// The last line.
pub(super) fn end(frames: &[Frame]) -> String {
    format!("end {} {:08x}\n", frames.len(), end_digest(frames))
}

fn end_digest(frames: &[Frame]) -> u32 {
    let mut digest = crc32fast::Hasher::new();
    frames.iter().for_each(|frame| digest.update(frame.line().as_bytes()));
    digest.finalize()
}

/// Reads a file from its beginning, and checks every digest.
///
/// # Errors
/// A file of another format, another question, or one that is damaged; a file that merely stops is no error.
pub(super) fn read(path: &Path, file: &mut impl BufRead, question: &Question) -> Result<Found, ShardError> {
    let mut reader = Reader { path, file, at: 0 };
    let (format, _) = reader.line()?;
    if format != FORMAT {
        let known = format.strip_prefix("crankstar pieces ").map(|version| version.chars().take(8).collect::<String>());
        return Err(match known {
            Some(version) => {
                ShardError::of(path, format_args!("is of format {version}, and this program reads 1; compute it again"))
            }
            None => ShardError::of(path, "is not a file of pieces; --shard and --resume make them"),
        });
    }
    let (json, _) = reader.line()?;
    let (head, _) = reader.line()?;
    let told: Option<Head> = (head == format!("crc32 {:08x}", crc32fast::hash(json.as_bytes())))
        .then(|| serde_json::from_str(&json).ok())
        .flatten();
    let head = told.ok_or_else(|| damaged(path, "in its head"))?;
    if head.words != question.words || head.pieces != question.pieces {
        return Err(ShardError::of(
            path,
            "belongs to another question: other options, another layout or another version",
        ));
    }
    let mut found = Found { head, frames: Vec::new(), is_finished: false, whole: reader.at };
    loop {
        let (line, is_whole) = reader.line()?;
        if !is_whole && reader.is_at_the_end()? {
            return Ok(found);
        }
        if let Some(piece) = line.strip_prefix("piece ") {
            let Some(frame) = frame(piece, reader.at).filter(|frame| frame.piece < question.pieces) else {
                return Err(damaged(path, format_args!("after its {} pieces", found.frames.len())));
            };
            match reader.digest(&frame)? {
                None => return Ok(found),
                Some(digest) if digest != frame.digest => {
                    return Err(damaged(path, format_args!("in its piece {}", frame.piece)));
                }
                Some(_) => {}
            }
            found.whole = reader.at;
            found.frames.push(frame);
            continue;
        }
        if line + "\n" == end(&found.frames) && reader.is_at_the_end()? {
            return Ok(Found { is_finished: true, ..found });
        }
        return Err(damaged(path, format_args!("after its {} pieces", found.frames.len())));
    }
}

fn damaged(path: &Path, place: impl std::fmt::Display) -> ShardError {
    ShardError::of(path, format_args!("is damaged {place}; remove it and compute it again"))
}

fn frame(line: &str, start: u64) -> Option<Frame> {
    let mut words = line.split(' ');
    let frame = Frame {
        piece: words.next()?.parse().ok()?,
        length: words.next()?.parse().ok()?,
        digest: u32::from_str_radix(words.next()?, 16).ok()?,
        start,
    };
    // One way of writing it, so that no byte of it can change unseen.
    (frame.line() == format!("piece {line}\n")).then_some(frame)
}

struct Reader<'a, R> {
    path: &'a Path,
    file: &'a mut R,
    at: u64,
}

impl<R: BufRead> Reader<'_, R> {
    /// A line without its end, and whether it has one; what is no text is no line of this format.
    fn line(&mut self) -> Result<(String, bool), ShardError> {
        let mut bytes = Vec::new();
        let read = self.file.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut bytes);
        self.at += read.map_err(|error| ShardError::reading(self.path, &error))? as u64;
        let text = bytes.strip_suffix(b"\n");
        Ok((String::from_utf8_lossy(text.unwrap_or(&bytes)).into_owned(), text.is_some()))
    }

    /// The digest of what is at a frame; none where the file stops within it.
    fn digest(&mut self, frame: &Frame) -> Result<Option<u32>, ShardError> {
        let mut digest = crc32fast::Hasher::new();
        digest.update(&(frame.piece as u64).to_le_bytes());
        let mut left = frame.length;
        while left > 0 {
            let bytes = self.file.fill_buf().map_err(|error| ShardError::reading(self.path, &error))?;
            if bytes.is_empty() {
                return Ok(None);
            }
            let part = bytes.len().min(usize::try_from(left).unwrap_or(usize::MAX));
            digest.update(&bytes[..part]);
            self.file.consume(part);
            left -= part as u64;
        }
        self.at += frame.length;
        Ok(Some(digest.finalize()))
    }

    fn is_at_the_end(&mut self) -> Result<bool, ShardError> {
        let rest = self.file.fill_buf().map_err(|error| ShardError::reading(self.path, &error))?;
        Ok(rest.is_empty())
    }
}
