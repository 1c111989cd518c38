//! In which convention is a table filled in? That of the sheet, or another that the student declares.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::claim::{Star, with_point};
use crate::engine::{Engine, LengthUnit};
use crate::file::{exact_number, parse_length};
use crate::order;
use crate::proof::Sense;

/// What a student does otherwise than the sheet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Convention {
    /// Angles of the table grow clockwise: every phase has the other sign, and the star is the mirror image.
    pub clockwise: bool,
    /// The throws are counted the other way round than the banks: β stands for −β.
    pub throws_reversed: bool,
    /// The columns are exchanged: direct is what the sheet calls reverse.
    pub swapped: bool,
    /// Moments are taken about this position, and not about the reference plane of the sheet.
    pub plane: Option<BigRational>,
}

/// The keys of a convention, with the two words of each, that of the sheet first.
pub const KEYS: [(&str, [&str; 2]); 3] = [
    ("sense", ["anticlockwise", "clockwise"]),
    ("throws", ["as given", "reversed"]),
    ("vectors", ["as given", "swapped"]),
];
/// The key of the plane that moments are taken about.
pub const PLANE: &str = "plane";

impl Convention {
    /// Takes what is written to a key; nothing written leaves the convention of the sheet.
    ///
    /// # Errors
    /// What would be right.
    pub fn declare(&mut self, key: &str, written: &str, engine: &Engine) -> Result<(), String> {
        let written = written.trim();
        if written.is_empty() {
            return Ok(());
        }
        if key == PLANE {
            self.plane = Some(plane(written, engine)?);
            return Ok(());
        }
        let known = KEYS.iter().find(|(name, _)| *name == key);
        let Some((_, words)) = known else {
            return Err(format!("a convention has the keys {}", KEYS.map(|(name, _)| name).join(", ") + ", " + PLANE));
        };
        let lower = written.to_lowercase();
        let place = words.iter().position(|word| *word == lower);
        let other = place.ok_or_else(|| format!("\"{}\" or \"{}\"", words[0], words[1]))? == 1;
        match key {
            "sense" => self.clockwise = other,
            "throws" => self.throws_reversed = other,
            _ => self.swapped = other,
        }
        Ok(())
    }

    /// What is declared, key by key, where it is not as on the sheet.
    pub fn declared(&self) -> Vec<(&'static str, String)> {
        let others = [self.clockwise, self.throws_reversed, self.swapped];
        let words = KEYS.iter().zip(others).filter(|(_, other)| *other);
        let words = words.map(|((key, [_, word]), _)| (*key, (*word).to_owned()));
        let plane = self.plane.as_ref().map(|plane| (PLANE, exact_number(plane)));
        words.chain(plane).collect()
    }

    /// The others that differ in sense, throws or vectors, the plane kept: those with the fewest differences first.
    pub fn others(&self) -> Vec<Convention> {
        let flags = (1_u8..8).map(|flags| {
            let [clockwise, throws_reversed, swapped] = [1, 2, 4].map(|flag| flags & flag != 0);
            Convention {
                clockwise: self.clockwise != clockwise,
                throws_reversed: self.throws_reversed != throws_reversed,
                swapped: self.swapped != swapped,
                plane: self.plane.clone(),
            }
        });
        let mut others: Vec<(u32, Convention)> =
            flags.zip(1_u8..8).map(|(one, flags)| (flags.count_ones(), one)).collect();
        others.sort_by_key(|(differences, _)| *differences);
        others.into_iter().map(|(_, convention)| convention).collect()
    }

    /// The star of an order as this convention writes it.
    pub fn star(&self, engine: &Engine, order: u32) -> Star {
        let mut star = Star::of(engine, order);
        for (phases, cylinder) in star.phases.iter_mut().zip(engine.cylinders()) {
            if self.throws_reversed {
                let throw = -&cylinder.throw;
                *phases = Sense::BOTH.map(|sense| order::phase_of(&throw, &cylinder.bank, order, Some(sense)));
            }
            if self.clockwise {
                *phases = phases.each_ref().map(|phase| -phase);
            }
            if self.swapped {
                phases.reverse();
            }
        }
        if let Some(plane) = &self.plane {
            star.arms = engine.cylinders().iter().map(|cylinder| &cylinder.position - plane).collect();
        }
        star
    }
}

/// No plane is farther away than so many times the length of the engine; of a metre or a spacing where it has none.
const FARTHEST: i64 = 10;

/// A position along the crankshaft, in what the positions of the sheet are counted in.
fn plane(written: &str, engine: &Engine) -> Result<BigRational, String> {
    let (value, unit) = parse_length(&with_point(written))?;
    if (unit, engine.length_unit()) == (LengthUnit::Metre, LengthUnit::Spacing) {
        return Err("a multiple of the spacing, as the positions of the sheet are, such as 1.5".to_owned());
    }
    // Far away a moment is the force many times over, and nobody has to compute it.
    let positions = || engine.cylinders().iter().map(|cylinder| &cylinder.position);
    let span = positions().max().zip(positions().min()).map(|(last, first)| last - first);
    let length = span.filter(|span| !span.is_zero()).unwrap_or_else(BigRational::one);
    let farthest = length * BigRational::from_integer(FARTHEST.into());
    match (&value - engine.reference_plane()).abs() <= farthest {
        true => Ok(value),
        false => Err("a plane that is not farther away than ten times the length of the engine".to_owned()),
    }
}
