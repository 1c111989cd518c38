//! Which entries of a student's tables are right, in which convention, and how many points is that?

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::convention::Convention;
use super::exercise::Pupil;
use super::scheme::Scheme;
use super::submission::Answers;
use crate::claim::{Agrees, Filled, Judged, Marked, Place, mark};
use crate::proof::Sense;
use crate::text::Untrusted;

/// A table with every entry judged.
#[derive(Clone, Debug)]
pub struct MarkedTable {
    /// The order k.
    pub order: u32,
    /// The entries, row by row, then the sums.
    pub entries: Vec<Marked>,
}

/// All tables of a student.
#[derive(Clone, Debug)]
pub struct MarkedSheet {
    /// The convention that the student declares.
    pub declared: Convention,
    /// The conventions that the tables are read in, where it is not the declared one: alike in every phase, the first is taken.
    pub undeclared: Vec<Convention>,
    /// The tables, one for each order asked for.
    pub tables: Vec<MarkedTable>,
    /// The points.
    pub points: BigRational,
    /// The points of a sheet without a mistake.
    pub possible: BigRational,
    /// What is wrong with rows that belong nowhere in the tables asked for, each with its line.
    pub not_read: Vec<Untrusted>,
}

/// How many entries are judged as each of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Right, exactly or rounded.
    pub right: usize,
    /// Right, but rounded to too few digits.
    pub coarse: usize,
    /// Wrong sums that are right given the phases.
    pub consequential: usize,
    /// Wrong.
    pub wrong: usize,
    /// Not to be read.
    pub unreadable: usize,
    /// Not filled in.
    pub missing: usize,
}

impl Counts {
    fn of<'a>(entries: impl Iterator<Item = &'a Marked>) -> Self {
        let mut counts = Counts::default();
        for entry in entries {
            *match entry.judged {
                Judged::Right => &mut counts.right,
                Judged::Coarse => &mut counts.coarse,
                Judged::Consequential => &mut counts.consequential,
                Judged::Wrong => &mut counts.wrong,
                Judged::Unreadable => &mut counts.unreadable,
                Judged::Missing => &mut counts.missing,
            } += 1;
        }
        counts
    }
}

impl MarkedSheet {
    /// How many entries are right, wrong and so on.
    pub fn counts(&self) -> Counts {
        Counts::of(self.entries())
    }

    /// The convention in which the entries are judged.
    pub fn convention(&self) -> &Convention {
        self.undeclared.first().unwrap_or(&self.declared)
    }

    /// The part of the points that is had.
    pub fn part(&self) -> BigRational {
        if self.possible.is_zero() { BigRational::one() } else { &self.points / &self.possible }
    }

    fn entries(&self) -> impl Iterator<Item = &Marked> {
        self.tables.iter().flat_map(|table| &table.entries)
    }
}

/// Marks what a student has filled in.
///
/// It is read in the convention that is declared. Where more phases are right in another, and those are more than half of the
/// phases that are filled in, and it brings no fewer points though only a part of them counts, it is read in that one.
pub(super) fn mark_sheet(pupil: &Pupil, orders: &[u32], answers: Answers, scheme: &Scheme) -> MarkedSheet {
    let Answers { convention, tables, not_read } = answers;
    let not_read: Vec<Untrusted> = not_read.into_iter().map(Untrusted::new).collect();
    let nothing = Filled::default();
    let read = |convention: &Convention| -> Vec<MarkedTable> {
        let table = |order: &u32| {
            let filled = tables.iter().find(|(of, _)| of == order).map_or(&nothing, |(_, filled)| filled);
            MarkedTable { order: *order, entries: mark(&convention.star(&pupil.engine, *order), filled, scheme.digits) }
        };
        orders.iter().map(table).collect()
    };
    let points = |tables: &[MarkedTable]| -> BigRational {
        tables.iter().flat_map(|table| &table.entries).map(|entry| scheme.points(entry)).sum()
    };
    let declared = read(&convention);
    let possible = declared.iter().flat_map(|table| &table.entries).map(|entry| scheme.full(entry)).sum();
    let of_declared = points(&declared);
    let there = right_phases(&declared);
    let filled_in: usize = tables.iter().map(|(_, filled)| filled.phases.len()).sum();
    if there < filled_in {
        let others = convention.others();
        let right: Vec<usize> = others.iter().map(|other| right_phases_in(pupil, &tables, other)).collect();
        let most = right.iter().copied().max().unwrap_or(0);
        if most > there && 2 * most > filled_in {
            let alike = others.into_iter().zip(right).filter(|(_, right)| *right == most);
            let undeclared: Vec<Convention> = alike.map(|(other, _)| other).collect();
            let tables = read(&undeclared[0]);
            let reduced = points(&tables) * &scheme.undeclared;
            if reduced >= of_declared {
                let (declared, points) = (convention, reduced);
                return MarkedSheet { declared, undeclared, tables, points, possible, not_read };
            }
        }
    }
    let undeclared = Vec::new();
    MarkedSheet { declared: convention, undeclared, tables: declared, points: of_declared, possible, not_read }
}

fn right_phases(tables: &[MarkedTable]) -> usize {
    let is_phase = |entry: &&Marked| match entry.place {
        Place::Phase(..) => matches!(entry.judged, Judged::Right | Judged::Coarse),
        Place::Sum(..) => false,
    };
    tables.iter().flat_map(|table| &table.entries).filter(is_phase).count()
}

/// The same of what is written, whatever the sums are.
fn right_phases_in(pupil: &Pupil, tables: &[(u32, Filled)], convention: &Convention) -> usize {
    let of_table = |(order, filled): &(u32, Filled)| {
        let star = convention.star(&pupil.engine, *order);
        let right = |cylinder: usize, sense: Sense| sense.choose(&star.phases[cylinder][0], &star.phases[cylinder][1]);
        let angles =
            filled.phases.iter().filter_map(|(cylinder, sense, angle)| Some((angle.as_ref().ok()?, *cylinder, *sense)));
        angles.filter(|(angle, cylinder, sense)| angle.agrees(right(*cylinder, *sense)) != Agrees::Not).count()
    };
    tables.iter().map(of_table).sum()
}
