//! Which pieces are done already? The state file of a search, whole at any moment.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::{Read, Write};
use std::path::Path;
use std::{fs, io};

use serde::{Deserialize, Serialize};

use super::firing;
use super::front::StarValues;
use super::judged;
use super::piece::Counts;
use super::plan::Plan;
use super::problem::Problem;
use super::space::Space;
use super::tables::Tables;
use crate::text::harmless;

/// No search keeps more than this; what is beyond is not read.
const LARGEST_FILE: u64 = 64 << 20;

/// A finished piece.
#[derive(Clone, Debug, Default)]
pub(super) struct Done {
    /// The stars it adds to the front, with their counts.
    pub points: Vec<StarValues>,
    /// What it came to.
    pub counts: Counts,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct StateFile {
    search: String,
    pieces: BTreeMap<usize, WrittenPiece>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenPiece {
    judged: u64,
    cut: u64,
    stars: Vec<WrittenStar>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenStar {
    throws: Vec<u16>,
    /// Where minor orders are compared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    firing_order: Option<Vec<usize>>,
    classes: u64,
    stars: u64,
}

/// What a state file is about: files of other questions, and of other ways to cut them into pieces, are refused.
fn signature(problem: &Problem, plan: &Plan) -> String {
    let vee = problem.bank_angle.as_ref().map_or(String::new(), |angle| format!(", V {} turn", angle.turns()));
    let directions = problem.directions.map_or(String::new(), |count| format!(", {count} directions"));
    let grid = problem.grid.map_or(String::new(), |grid| format!(", grid {grid}"));
    let neighbours = if problem.neighbours { ", neighbours" } else { "" };
    let (cycle, cylinders, orders) = (firing::cycle_name(problem.cycle), problem.cylinders, &problem.orders);
    let (way, pieces) = (plan.name(), plan.len());
    let split = problem.pin_split.as_ref().map_or(String::new(), |split| format!(", split {} turn", split.turns()));
    let offset = problem.bank_offset.as_ref().map_or(String::new(), |offset| format!(", offset {offset}"));
    let (split, minor) = (split + &offset, minor(problem));
    format!(
        "3: {cylinders} cylinders, {cycle}{vee}{split}{directions}{grid}{neighbours}{minor}, orders {orders:?}, {pieces} {way}"
    )
}

/// The minor orders that are compared, and the mode that weighs them.
fn minor(problem: &Problem) -> String {
    if problem.minor_orders.is_empty() {
        return String::new();
    }
    let listed = |values: &mut dyn Iterator<Item = String>| values.collect::<Vec<_>>().join(" ");
    let orders = listed(&mut problem.minor_orders.iter().map(|order| order.exact().to_string()));
    let shape = problem.mode_shape.iter().flatten().map(ToString::to_string);
    format!(", minor orders {orders} by [{}]", listed(&mut shape.into_iter()))
}

/// Reads the finished pieces; none if there is no file yet. What does not fit the question is refused.
pub(super) fn read(
    path: &Path,
    problem: &Problem,
    space: &Space,
    tables: &Tables,
    plan: &Plan,
) -> Result<BTreeMap<usize, Done>, String> {
    let place = harmless(&path.to_string_lossy());
    let file = match fs::File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(error) => return Err(format!("cannot read `{place}`: {error}")),
    };
    let mut bytes = Vec::new();
    file.take(LARGEST_FILE).read_to_end(&mut bytes).map_err(|error| format!("cannot read `{place}`: {error}"))?;
    let refused = |what: String| format!("`{place}` {what}; name another file, or remove it to search afresh");
    let body = undamaged(&bytes).ok_or_else(|| refused("is not the state of a search, or is damaged".to_owned()))?;
    let file: StateFile =
        serde_json::from_slice(body).map_err(|error| refused(format!("is not the state of a search: {error}")))?;
    let expected = signature(problem, plan);
    if file.search != expected {
        return Err(refused(format!("belongs to another search ({}); this one is {expected}", harmless(&file.search))));
    }
    let mut done = BTreeMap::new();
    let mut sum = Counts::default();
    for (number, written) in file.pieces {
        let damaged = || refused(format!("does not fit this search at piece {number}"));
        let finished = finished(&written, number, plan, space, tables).ok_or_else(damaged)?;
        sum = sum.plus(finished.counts).filter(|sum| is_possible(*sum, space)).ok_or_else(damaged)?;
        done.insert(number, finished);
    }
    Ok(done)
}

/// What stands before the digest, if it is that of the digest.
fn undamaged(bytes: &[u8]) -> Option<&[u8]> {
    let (body, digest) = bytes.split_at(bytes.len().checked_sub(DIGEST)?);
    (digest == digest_of(body).as_bytes()).then_some(body)
}

/// Bytes of the line with the digest.
const DIGEST: usize = "\ncrc32 01234567\n".len();

fn digest_of(body: &[u8]) -> String {
    format!("\ncrc32 {:08x}\n", crc32fast::hash(body))
}

/// A piece as it was written, if it can have come of this piece.
fn finished(written: &WrittenPiece, number: usize, plan: &Plan, space: &Space, tables: &Tables) -> Option<Done> {
    let counts = Counts { judged: written.judged, cut: written.cut };
    let mut points: Vec<StarValues> = Vec::new();
    let mut classes = 0_u64;
    for star in &written.stars {
        let is_here = space.holds(&star.throws) && plan.holds(number, space, &star.throws);
        // A class of rotation, mirror and reversal holds up to four stars with cylinder 1 at 0.
        let is_counted = star.classes > 0 && (star.classes..=star.classes.checked_mul(4)?).contains(&star.stars);
        let of_star = is_here.then(|| judged::judge(space, tables, &star.throws))?;
        let point = of_star.into_iter().find(|point| point.firing_order == star.firing_order)?;
        let is_new = points.iter().all(|known| known.compare(&point).is_none());
        points.push((is_counted && is_new).then_some(StarValues {
            classes: star.classes,
            stars: star.stars,
            ..point
        })?);
        // By its firing orders, or those of its images, a star may stand at several points.
        classes =
            if space.gives_one_point() { classes.checked_add(star.classes)? } else { classes.max(star.classes / 4) };
    }
    (classes <= counts.judged && is_possible(counts, space)).then_some(Done { points, counts })
}

/// Whether so many stars and starts exist.
fn is_possible(counts: Counts, space: &Space) -> bool {
    let all = space.count();
    u128::from(counts.judged) <= all && u128::from(counts.cut) <= all * (space.pairs() as u128 + 1)
}

/// Writes the finished pieces: under another name first, so that the file is whole whenever the program stops.
pub(super) fn write(path: &Path, problem: &Problem, done: &BTreeMap<usize, Done>, plan: &Plan) -> Result<(), String> {
    let star = |point: &StarValues| WrittenStar {
        throws: point.throws.clone(),
        firing_order: point.firing_order.clone(),
        classes: point.classes,
        stars: point.stars,
    };
    let piece = |done: &Done| WrittenPiece {
        judged: done.counts.judged,
        cut: done.counts.cut,
        stars: done.points.iter().map(star).collect(),
    };
    let pieces = done.iter().map(|(number, done)| (*number, piece(done))).collect();
    let file = StateFile { search: signature(problem, plan), pieces };
    let fail = |error: String| format!("cannot write `{}`: {error}", harmless(&path.to_string_lossy()));
    let mut text = serde_json::to_string(&file).map_err(|error| fail(error.to_string()))?;
    text.push_str(&digest_of(text.as_bytes()));
    let mut name = OsString::from(".");
    name.push(path.file_name().ok_or_else(|| fail("it names no file".into()))?);
    // Of this process alone: another search may keep its pieces in the same file.
    name.push(format!(".{}.partial", std::process::id()));
    let beside = path.with_file_name(name);
    let written = fs::File::create(&beside)
        .and_then(|mut file| file.write_all(text.as_bytes()).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&beside, path));
    written.map_err(|error| {
        // What was written beside is of no use; the first error is the one to tell.
        let _ = fs::remove_file(&beside);
        fail(error.to_string())
    })
}
