//! Which entries of a vector-star table are right, which are wrong, and which only follow from a wrong one?

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::handwritten::{Agrees, WrittenAngle, WrittenLength};
use crate::engine::{Cylinder, Engine};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::{self, Form};
use crate::order;
use crate::proof::{Planar, Sense};
use crate::text::Untrusted;

/// The vector star of one order as a table has it: a row per cylinder (theory, section 3).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Star {
    /// Direct and reverse phase of each cylinder.
    pub phases: Vec<[Turn; 2]>,
    /// Length of the vectors of each cylinder: reciprocating mass times crank radius, in multiples of the engine's.
    pub weights: Vec<BigRational>,
    /// Arm of each cylinder from the reference plane.
    pub arms: Vec<BigRational>,
}

/// The rows below those of the cylinders.
pub const SUMS: [Planar; 2] = Planar::BOTH;

impl Star {
    /// The star of the pistons of an engine without links.
    pub fn of(engine: &Engine, order: u32) -> Self {
        Star::about(engine.cylinders(), engine.reference_plane(), order)
    }

    /// The same of these cylinders, about this plane.
    pub fn about(cylinders: &[Cylinder], plane: &BigRational, order: u32) -> Self {
        let phase = |cylinder| Sense::BOTH.map(|sense| order::phase(cylinder, order, Some(sense)));
        Star {
            phases: cylinders.iter().map(phase).collect(),
            weights: cylinders.iter().map(Cylinder::weight).collect(),
            arms: cylinders.iter().map(|cylinder| &cylinder.position - plane).collect(),
        }
    }

    /// One of its four sums.
    pub fn sum(&self, quantity: Planar, sense: Sense) -> PhasorSum {
        let column = self.phases.iter().map(|phases| phases[column(sense)].clone());
        self.sum_of(column.collect(), quantity)
    }

    /// The sum where the phases of a column are these.
    fn sum_of(&self, phases: Vec<Turn>, quantity: Planar) -> PhasorSum {
        let vectors = phases.into_iter().zip(&self.weights).zip(&self.arms);
        let term = |((angle, weight), arm): ((Turn, &BigRational), &BigRational)| Term {
            angle,
            weight: match quantity {
                Planar::Moment => weight * arm,
                Planar::Force => weight.clone(),
            },
        };
        PhasorSum::new(vectors.map(term).collect())
    }
}

fn column(sense: Sense) -> usize {
    sense.choose(0, 1)
}

/// Where an entry stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The phase of a cylinder, by its index.
    Phase(usize, Sense),
    /// The length of a sum.
    Sum(Planar, Sense),
}

/// An entry: what was written, or the words that cannot be read and what would be right.
pub type Written<T> = Result<T, (Untrusted, String)>;

/// The entries of one table, each place at most once.
#[derive(Clone, Debug, Default)]
pub struct Filled {
    /// Phases: cylinder by index, sense.
    pub phases: Vec<(usize, Sense, Written<WrittenAngle>)>,
    /// Lengths of sums.
    pub sums: Vec<(Planar, Sense, Written<WrittenLength>)>,
}

/// What is said of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judged {
    /// It is right, exactly or as rounded decimals.
    Right,
    /// It is right as far as it goes, but rounded to too few digits.
    Coarse,
    /// A sum that is wrong, but right for the wrong phases of its column.
    Consequential,
    /// It is wrong.
    Wrong,
    /// It cannot be read.
    Unreadable,
    /// Nothing is written there.
    Missing,
}

/// What belongs there.
#[derive(Clone, Debug, PartialEq)]
pub enum RightEntry {
    /// A phase.
    Angle(Turn),
    /// The length of a sum: in closed form, where there is one, and in decimals.
    Length(Option<Form>, f64),
}

/// An entry with its judgement.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Where it stands.
    pub place: Place,
    /// What is written there, perhaps unreadable.
    pub written: Option<Untrusted>,
    /// What is said of it.
    pub judged: Judged,
    /// What belongs there.
    pub right: RightEntry,
}

/// The significant digits that a rounded length needs where nothing else is said; a rounded phase needs a decimal.
pub const LEAST_DIGITS: usize = 2;

/// Every entry of a table, row by row, then its sums; rounded lengths need at least this many significant digits.
pub fn mark(star: &Star, filled: &Filled, digits: usize) -> Vec<Marked> {
    let mut marks = Vec::new();
    // The phases that the sums of each column rest on: the true one where what is written is it, rounded perhaps.
    let mut own: [Vec<Option<OwnPhase>>; 2] = [Vec::new(), Vec::new()];
    for (cylinder, right) in star.phases.iter().enumerate() {
        for (sense, right) in Sense::BOTH.into_iter().zip(right) {
            let written = filled.phases.iter().find(|(index, own, _)| (*index, *own) == (cylinder, sense));
            let agrees = |angle: &WrittenAngle| (angle.agrees(right), angle.is_coarse());
            let judged = judged(written.map(|(_, _, written)| written), agrees);
            own[column(sense)].push(match (judged, written) {
                (Judged::Right | Judged::Coarse, _) => {
                    Some(OwnPhase { turn: right.clone(), rounding: BigRational::zero(), is_right: true })
                }
                (_, Some((_, _, Ok(angle)))) => {
                    Some(OwnPhase { turn: angle.turn.clone(), rounding: angle.rounding(), is_right: false })
                }
                (_, _) => None,
            });
            let written = written.map(|(_, _, written)| words(written, |angle| &angle.text));
            let right = RightEntry::Angle(right.clone());
            marks.push(Marked { place: Place::Phase(cylinder, sense), written, judged, right });
        }
    }
    let own = own.map(|column| column.into_iter().collect::<Option<Vec<OwnPhase>>>());
    for quantity in SUMS {
        for sense in Sense::BOTH {
            let sum = star.sum(quantity, sense);
            let written = filled.sums.iter().find(|(of, own, _)| (*of, *own) == (quantity, sense));
            let agrees = |length: &WrittenLength| (length.agrees(&sum), length.is_coarse(digits));
            let judged = match judged(written.map(|(_, _, written)| written), agrees) {
                Judged::Wrong if follows(star, own[column(sense)].as_ref(), quantity, written, digits) => {
                    Judged::Consequential
                }
                judged => judged,
            };
            let written = written.map(|(_, _, written)| words(written, |length| &length.text));
            marks.push(Marked { place: Place::Sum(quantity, sense), written, judged, right: length_of(&sum) });
        }
    }
    marks
}

/// By how a number agrees with the right one, and whether it has too few digits.
fn judged<T>(written: Option<&Written<T>>, agrees: impl FnOnce(&T) -> (Agrees, bool)) -> Judged {
    match written {
        None => Judged::Missing,
        Some(Err(_)) => Judged::Unreadable,
        Some(Ok(written)) => match agrees(written) {
            (Agrees::Rounded, true) => Judged::Coarse,
            (Agrees::Exactly | Agrees::Rounded, _) => Judged::Right,
            (Agrees::Not, _) => Judged::Wrong,
        },
    }
}

fn words<T>(written: &Written<T>, text: impl FnOnce(&T) -> &Untrusted) -> Untrusted {
    match written {
        Ok(written) => text(written).clone(),
        Err((words, _)) => words.clone(),
    }
}

/// A phase that a sum rests on, and by how many turns it may have been rounded.
struct OwnPhase {
    turn: Turn,
    rounding: BigRational,
    is_right: bool,
}

/// Whether a length is that of the sum of the phases that are in the column, or of the phases that they are the roundings of, to enough digits. At
/// least half of the phases have to be right: a column of zeros makes every sum easy.
fn follows(
    star: &Star,
    own: Option<&Vec<OwnPhase>>,
    quantity: Planar,
    written: Option<&(Planar, Sense, Written<WrittenLength>)>,
    digits: usize,
) -> bool {
    let (Some(own), Some((_, _, Ok(length)))) = (own, written) else { return false };
    if own.iter().filter(|phase| phase.is_right).count() < own.len().div_ceil(2) {
        return false;
    }
    let sum = star.sum_of(own.iter().map(|phase| phase.turn.clone()).collect(), quantity);
    // A vector moves by less than 44/7 of its length times the turns that it is turned by.
    let moved = sum.terms().iter().zip(own).map(|(term, phase)| term.weight.abs() * &phase.rounding);
    let slack = moved.sum::<BigRational>() * BigRational::new(44.into(), 7.into());
    match length.agrees_within(&sum, &slack) {
        Agrees::Exactly => true,
        Agrees::Rounded => !length.is_coarse(digits),
        Agrees::Not => false,
    }
}

fn length_of(sum: &PhasorSum) -> RightEntry {
    match sum.vanishes() {
        true => RightEntry::Length(Some(Form::rational(BigRational::from_integer(0.into()))), 0.0),
        false => RightEntry::Length(numbers::modulus(sum), numbers::evaluate(sum).norm()),
    }
}
