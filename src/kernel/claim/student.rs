//! Is a student's vector-star table right? The first wrong entry is reported, and what it should be.

use serde::Deserialize;
use serde_spanned::Spanned;

use super::find::{Find, engine};
use super::handwritten::{WrittenAngle, WrittenLength};
use super::star_marks::{self, Filled, Judged, Marked, Place, RightEntry, Star};
use crate::engine::{Engine, Rods};
use crate::exact::Turn;
use crate::file::LayoutError;
use crate::file::quantities::misread;
use crate::file::written::{Table, Text, place};
use crate::numbers::Form;
use crate::proof::{Planar, Sense};
use crate::text::Untrusted;

/// A vector-star table of one order, as a student fills it in.
#[derive(Clone, Debug)]
pub struct StarTable {
    /// The engine's name or path, as written.
    pub engine: Untrusted,
    /// The engine.
    pub layout: Engine,
    /// The order k.
    pub order: u32,
    /// What is filled in.
    pub filled: Filled,
}

/// The answer to a student's table.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// All entries are right; how many there are.
    Right(usize),
    /// The first wrong phase.
    WrongPhase {
        /// The cylinder by index.
        cylinder: usize,
        /// Direct or reverse.
        sense: Sense,
        /// What was written.
        written: Untrusted,
        /// What it should be.
        right: Turn,
    },
    /// The first wrong sum, all phases being right.
    WrongSum {
        /// Force or moment.
        quantity: Planar,
        /// Direct or reverse.
        sense: Sense,
        /// What was written.
        written: Untrusted,
        /// The length in closed form, where there is one, and in decimals.
        right: (Option<Form>, f64),
    },
}

impl Verdict {
    /// Whether the table is right.
    pub fn holds(&self) -> bool {
        matches!(self, Verdict::Right(_))
    }
}

/// A `[[table]]` as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Written {
    layout: Text,
    order: Text,
    rows: Option<Vec<Spanned<Table<Row>>>>,
    sums: Option<Table<Sums>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Row {
    cylinder: Text,
    direct: Option<Text>,
    reverse: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sums {
    force_direct: Option<Text>,
    force_reverse: Option<Text>,
    moment_direct: Option<Text>,
    moment_reverse: Option<Text>,
}

pub(super) fn read(table: &Written, find: Find) -> Result<StarTable, LayoutError> {
    let layout = engine(&table.layout, find)?;
    one_star(&layout).map_err(|why| {
        let right = "an engine whose rods are alike, on the crankpins and without offsets, and whose crankshafts turn equally fast";
        LayoutError::new(format!("no vector-star table: {why}"), right, place(&table.layout))
    })?;
    let order = order(&table.order)?;
    let filled = filled(&layout, table.rows.iter().flatten(), table.sums.as_ref())?;
    if filled.phases.is_empty() && filled.sums.is_empty() {
        let right = "rows = [{ cylinder = 1, direct = 0 }], or sums = { force_direct = 4 }: at least one entry";
        return Err(LayoutError::new("a table without entries claims nothing", right, place(&table.order)));
    }
    let unread = filled.phases.iter().filter_map(|(_, _, written)| written.as_ref().err());
    let unread = unread.chain(filled.sums.iter().filter_map(|(_, _, written)| written.as_ref().err())).next();
    match unread {
        None => Ok(StarTable { engine: table.layout.get_ref().untrusted(), layout, order, filled }),
        Some((words, right)) => {
            let mut cells = table.cells();
            let wrong = cells.find(|(_, text)| *words == text.get_ref().0.as_str());
            let (what, text) = wrong.unwrap_or(("order", &table.order));
            Err(misread(text, what, right))
        }
    }
}

/// Whether each order of the pistons is one star, in which each cylinder has a direct and a reverse vector.
///
/// # Errors
/// Why it is not.
pub(crate) fn one_star(engine: &Engine) -> Result<(), &'static str> {
    match engine.all_rods() {
        _ if engine.faster_crank().is_some() => {
            Err("its crankshafts turn at different speeds, each with orders of its own")
        }
        Rods::Without(_) => Err("its rods are articulated, or not on the crankpins: a piston has several vectors"),
        Rods::Differ => Err("its rods or their offsets differ, so that an order is several sums"),
        Rods::Alike(rod) if !rod.is_centric() => {
            Err("its cylinder axes miss the crankshaft, which turns the vectors of order 1")
        }
        Rods::Alike(_) | Rods::Unknown => Ok(()),
    }
}

impl Written {
    /// What is filled in, with what it is called.
    fn cells(&self) -> impl Iterator<Item = (&'static str, &Text)> {
        let rows = self.rows.iter().flatten().map(|row| &row.get_ref().0);
        let phases = rows.flat_map(|row| [&row.direct, &row.reverse]).flatten().map(|text| ("phase", text));
        let sums = self.sums.iter().flat_map(|Table(sums)| sums.entries()).filter_map(|(_, _, text)| text.as_ref());
        phases.chain(sums.map(|text| ("length", text)))
    }
}

impl Row {
    /// Whether nothing is written in it.
    pub(crate) fn is_empty(&self) -> bool {
        [&self.direct, &self.reverse].into_iter().flatten().filter_map(entry).next().is_none()
    }
}

impl Sums {
    /// Whether nothing is written in them.
    pub(crate) fn is_empty(&self) -> bool {
        self.entries().into_iter().filter_map(|(_, _, text)| text.as_ref().and_then(entry)).next().is_none()
    }

    fn entries(&self) -> [(Planar, Sense, &Option<Text>); 4] {
        [
            (Planar::Force, Sense::Direct, &self.force_direct),
            (Planar::Force, Sense::Reverse, &self.force_reverse),
            (Planar::Moment, Sense::Direct, &self.moment_direct),
            (Planar::Moment, Sense::Reverse, &self.moment_reverse),
        ]
    }
}

/// The order of a table.
pub(crate) fn order(text: &Text) -> Result<u32, LayoutError> {
    let order = text.get_ref().0.parse().ok().filter(|order| (1..=crate::engine::HIGHEST_ORDER).contains(order));
    order.ok_or_else(|| misread(text, "order", format!("a whole number from 1 to {}", crate::engine::HIGHEST_ORDER)))
}

/// What is filled in: an entry without words is none, and one that cannot be read is kept as such.
pub(crate) fn filled<'a>(
    engine: &Engine,
    rows: impl IntoIterator<Item = &'a Spanned<Table<Row>>>,
    sums: Option<&Table<Sums>>,
) -> Result<Filled, LayoutError> {
    let mut filled = Filled::default();
    for row in rows.into_iter().map(|row| &row.get_ref().0) {
        let name = &row.cylinder.get_ref().0;
        let index = engine.cylinders().iter().position(|cylinder| cylinder.name == *name);
        let index = index.ok_or_else(|| misread(&row.cylinder, "cylinder", "the name of a cylinder of the engine"))?;
        if filled.phases.iter().any(|(there, ..)| *there == index) {
            let message = format!("cylinder `{name}` has a row before");
            return Err(LayoutError::new(message, "one row per cylinder", place(&row.cylinder)));
        }
        for (sense, text) in [(Sense::Direct, &row.direct), (Sense::Reverse, &row.reverse)] {
            if let Some(words) = text.as_ref().and_then(entry) {
                filled.phases.push((index, sense, kept(words, WrittenAngle::read(words))));
            }
        }
    }
    for (quantity, sense, text) in sums.into_iter().flat_map(|Table(sums)| sums.entries()) {
        if let Some(words) = text.as_ref().and_then(entry) {
            filled.sums.push((quantity, sense, kept(words, WrittenLength::read(words))));
        }
    }
    Ok(filled)
}

/// The words of an entry, where there are any.
fn entry(text: &Text) -> Option<&str> {
    Some(text.get_ref().0.as_str()).filter(|words| !words.trim().is_empty())
}

/// An entry, or its words with what would be right.
pub(crate) fn kept<T>(words: &str, read: Result<T, String>) -> star_marks::Written<T> {
    read.map_err(|right| (Untrusted::new(words), right))
}

impl StarTable {
    /// Its entries with their judgements; those that are missing too.
    pub fn marks(&self) -> Vec<Marked> {
        star_marks::mark(&Star::of(&self.layout, self.order), &self.filled, star_marks::LEAST_DIGITS)
    }
}

/// Phases first, row by row, then the sums.
pub(super) fn judge(table: &StarTable) -> Verdict {
    let marks = table.marks();
    let is_wrong = |mark: &&Marked| match mark.judged {
        Judged::Wrong | Judged::Coarse | Judged::Consequential | Judged::Unreadable => true,
        Judged::Right | Judged::Missing => false,
    };
    let right = marks.iter().filter(|mark| mark.judged == Judged::Right).count();
    let Some(wrong) = marks.into_iter().find(|mark| is_wrong(&mark)) else { return Verdict::Right(right) };
    let written = wrong.written.unwrap_or_default();
    match (wrong.place, wrong.right) {
        (Place::Phase(cylinder, sense), RightEntry::Angle(right)) => {
            Verdict::WrongPhase { cylinder, sense, written, right }
        }
        (Place::Sum(quantity, sense), RightEntry::Length(exact, decimal)) => {
            Verdict::WrongSum { quantity, sense, written, right: (exact, decimal) }
        }
        (Place::Phase(..), RightEntry::Length(..)) | (Place::Sum(..), RightEntry::Angle(_)) => {
            unreachable!("a phase is an angle, a sum has a length")
        }
    }
}
