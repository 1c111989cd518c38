//! Which pieces are done already? The state file of a search, whole at any moment.

use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

use serde::{Deserialize, Serialize};

use super::firing;
use super::front::Point;
use super::judged;
use super::piece::Counts;
use super::problem::Problem;
use super::space::Space;
use super::tables::Tables;

/// A finished piece.
#[derive(Clone, Debug, Default)]
pub(super) struct Done {
    /// The stars it adds to the front, with their counts.
    pub points: Vec<Point>,
    /// What it came to.
    pub counts: Counts,
}

#[derive(Serialize, Deserialize)]
struct StateFile {
    search: String,
    pieces: BTreeMap<usize, WrittenPiece>,
}

#[derive(Serialize, Deserialize)]
struct WrittenPiece {
    judged: u64,
    cut: u64,
    stars: Vec<WrittenStar>,
}

#[derive(Serialize, Deserialize)]
struct WrittenStar {
    throws: Vec<u16>,
    classes: u64,
    stars: u64,
}

/// What a state file is about: files of other questions, and of other ways to cut them into pieces, are refused.
fn signature(problem: &Problem, pieces: usize) -> String {
    let vee = problem.bank_angle.as_ref().map_or(String::new(), |angle| format!(", V {} turn", angle.turns()));
    let directions = problem.directions.map_or(String::new(), |count| format!(", {count} directions"));
    let grid = problem.grid.map_or(String::new(), |grid| format!(", grid {grid}"));
    let neighbours = if problem.neighbours { ", neighbours" } else { "" };
    let (cycle, cylinders, orders) = (firing::cycle_name(problem.cycle), problem.cylinders, &problem.orders);
    format!("1: {cylinders} cylinders, {cycle}{vee}{directions}{grid}{neighbours}, orders {orders:?}, {pieces} pieces")
}

/// Reads the finished pieces; none if there is no file yet.
pub(super) fn read(
    path: &Path,
    problem: &Problem,
    space: &Space,
    tables: &Tables,
    count: usize,
) -> Result<BTreeMap<usize, Done>, String> {
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(error) => return Err(format!("cannot read `{}`: {error}", path.display())),
    };
    let place = path.display();
    let file: StateFile =
        serde_json::from_str(&text).map_err(|error| format!("`{place}` is not the state of a search: {error}"))?;
    let expected = signature(problem, count);
    if file.search != expected {
        return Err(format!("`{place}` belongs to another search ({}); this one is {expected}", file.search));
    }
    let mut done = BTreeMap::new();
    for (number, piece) in file.pieces {
        let stars = &piece.stars;
        if number >= count || stars.iter().any(|star| star.classes == 0 || !space.holds(&star.throws)) {
            return Err(format!("`{place}` is damaged at piece {number}; remove it to search afresh"));
        }
        let point = |star: &WrittenStar| {
            let (classes, stars) = (star.classes, star.stars);
            Point { classes, stars, ..judged::judge(space, tables, &star.throws) }
        };
        let counts = Counts { judged: piece.judged, cut: piece.cut };
        done.insert(number, Done { points: stars.iter().map(point).collect(), counts });
    }
    Ok(done)
}

/// Writes the finished pieces: under another name first, so that the file is whole whenever the program stops.
pub(super) fn write(path: &Path, problem: &Problem, done: &BTreeMap<usize, Done>, count: usize) -> Result<(), String> {
    let star = |point: &Point| WrittenStar { throws: point.throws.clone(), classes: point.classes, stars: point.stars };
    let piece = |done: &Done| WrittenPiece {
        judged: done.counts.judged,
        cut: done.counts.cut,
        stars: done.points.iter().map(star).collect(),
    };
    let pieces = done.iter().map(|(number, done)| (*number, piece(done))).collect();
    let file = StateFile { search: signature(problem, count), pieces };
    let fail = |error: String| format!("cannot write `{}`: {error}", path.display());
    let text = serde_json::to_string(&file).map_err(|error| fail(error.to_string()))?;
    let name = path.file_name().ok_or_else(|| fail("it names no file".into()))?.to_string_lossy();
    let beside = path.with_file_name(format!(".{name}.partial"));
    let written = fs::write(&beside, text).and_then(|()| fs::rename(&beside, path));
    written.map_err(|error| {
        // What was written beside is of no use; the first error is the one to tell.
        let _ = fs::remove_file(&beside);
        fail(error.to_string())
    })
}
