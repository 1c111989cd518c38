//! How does one engine become a different one for each student, of the same kind and as good to learn from?
//!
//! The throws are dealt out to the crankpins anew and the crankshaft is turned as a whole; two banks get another angle between
//! them; the spacing and the mass are others. Redrawn is what leaves nothing to find: where some sums of the layout vanish and
//! some do not, it is so for every student.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::draw::Draw;
use crate::claim::student::one_star;
use crate::claim::{SUMS, Star};
use crate::engine::{Convention, Cylinder, Engine, LengthUnit, Rotation, SeenFrom};
use crate::exact::Turn;
use crate::file::{bare_number, exact_number};
use crate::proof::Sense;

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vary {
    /// The throws: which pin has which, and where the crankshaft is at θ = 0.
    pub throws: bool,
    /// The angle between two banks.
    pub banks: bool,
    /// The distances along the crankshaft.
    pub spacing: bool,
    /// The mass of all pistons, in multiples.
    pub masses: bool,
}

impl Vary {
    /// All of it.
    pub const ALL: Vary = Vary { throws: true, banks: true, spacing: true, masses: true };
    /// Nothing: every student has the engine of the layout.
    pub const NOTHING: Vary = Vary { throws: false, banks: false, spacing: false, masses: false };
}

/// Bank angles in degrees whose stars have lengths in closed form.
const BANK_ANGLES: [i64; 8] = [45, 60, 72, 75, 90, 105, 120, 135];
/// Spacings in millimetres.
const SPACINGS: [i64; 11] = [80, 84, 90, 96, 100, 104, 108, 110, 116, 120, 125];
/// The same of a layout with lengths of its own, in hundredths of them.
const PARTS: [i64; 7] = [80, 85, 90, 100, 110, 115, 120];
/// How much all pistons weigh, in halves of the unit.
const HALVES: [i64; 5] = [2, 3, 4, 5, 6];
/// Steps of 15° that the crankshaft is turned by.
const STEPS: usize = 24;
/// So often it is drawn anew; then the engine of the layout itself is given.
const TRIES: usize = 64;

/// Whether the engine makes a vector-star table.
///
/// # Errors
/// Why it does not.
pub fn can_be_set(engine: &Engine) -> Result<(), &'static str> {
    match engine.geared_cranks() {
        [] => one_star(engine),
        _ => Err("it has several crankshafts, and a table has throws of one"),
    }
}

/// The layout file of a student, drawn as the given one is, with cylinders and masses in multiples; what was varied is in it.
///
/// The engine is one that [`can_be_set`].
pub fn varied(engine: &Engine, orders: &[u32], vary: Vary, mut draw: Draw) -> String {
    let plain = Plain::of(engine);
    let wanted = zeros(&plain, orders);
    let drawn = (0..TRIES).map(|_| plain.varied(vary, &mut draw));
    // Both kinds of sums, or one kind as in the layout.
    let is_as_good = |other: &Plain| zeros(other, orders).is_superset(&wanted);
    let found = drawn.into_iter().find(is_as_good);
    found.unwrap_or(plain).layout(orders)
}

/// Whether there are sums that vanish, and sums that do not.
fn zeros(plain: &Plain, orders: &[u32]) -> BTreeSet<bool> {
    let stars = orders.iter().map(|order| Star::about(&plain.cylinders, &plain.plane, *order));
    let sums =
        stars.flat_map(|star| SUMS.map(|quantity| Sense::BOTH.map(|sense| star.sum(quantity, sense).vanishes())));
    sums.flatten().collect()
}

/// What a table needs of an engine.
struct Plain {
    cylinders: Vec<Cylinder>,
    plane: BigRational,
    plane_given: bool,
    unit: LengthUnit,
    convention: Convention,
}

impl Plain {
    fn of(engine: &Engine) -> Self {
        Plain {
            cylinders: engine.cylinders().to_vec(),
            plane: engine.reference_plane().clone(),
            plane_given: engine.reference_plane_given(),
            unit: engine.length_unit(),
            convention: engine.convention(),
        }
    }

    fn varied(&self, vary: Vary, draw: &mut Draw) -> Plain {
        let mut cylinders = self.cylinders.clone();
        let (mut plane, mut unit) = (self.plane.clone(), self.unit);
        if vary.throws {
            deal_throws(&mut cylinders, draw);
        }
        if vary.banks {
            other_banks(&mut cylinders, draw);
        }
        if vary.spacing {
            let scale = match unit {
                LengthUnit::Spacing => BigRational::new(draw.one_of(&SPACINGS).into(), 1000.into()),
                LengthUnit::Metre => BigRational::new(draw.one_of(&PARTS).into(), 100.into()),
            };
            cylinders.iter_mut().for_each(|cylinder| cylinder.position *= &scale);
            plane *= scale;
            unit = LengthUnit::Metre;
        }
        if vary.masses {
            let mass = BigRational::new(draw.one_of(&HALVES).into(), 2.into());
            cylinders.iter_mut().for_each(|cylinder| cylinder.reciprocating_mass *= &mass);
        }
        Plain { cylinders, plane, plane_given: self.plane_given, unit, convention: self.convention }
    }

    /// As a layout file.
    fn layout(&self, orders: &[u32]) -> String {
        let orders: Vec<String> = orders.iter().map(u32::to_string).collect();
        let mut text = format!("title = \"Vector-star exercise\"\norders = [{}]\n", orders.join(", "));
        if self.convention.rotation == Rotation::Clockwise {
            text.push_str("rotation = \"clockwise\"\n");
        }
        if self.convention.seen_from == SeenFrom::Flywheel {
            text.push_str("seen_from = \"flywheel\"\n");
        }
        if self.plane_given {
            text.push_str(&format!("reference_plane = {}\n", self.length(&self.plane)));
        }
        for cylinder in &self.cylinders {
            text.push_str(&format!(
                "\n[[cylinder]]\nname = {}\nthrow = {}\nbank = {}\nposition = {}\npin = {}\n",
                quoted(&cylinder.name),
                exact_number(&self.convention.as_written(&cylinder.throw).degrees()),
                exact_number(&signed(&self.convention.as_written(&cylinder.bank))),
                self.length(&cylinder.position),
                cylinder.pin + 1,
            ));
            if !cylinder.weight().is_one() {
                text.push_str(&format!("reciprocating_mass = {}\n", exact_number(&cylinder.weight())));
            }
        }
        text
    }

    fn length(&self, length: &BigRational) -> String {
        match self.unit {
            LengthUnit::Spacing => exact_number(length),
            LengthUnit::Metre => {
                format!("\"{} mm\"", bare_number(&(length * BigRational::from_integer(1000.into()))))
            }
        }
    }
}

/// Degrees in (−180, 180].
fn signed(angle: &Turn) -> BigRational {
    let degrees = angle.degrees();
    let half = BigRational::from_integer(180.into());
    if degrees > half { degrees - &half - half } else { degrees }
}

/// A text as TOML has it.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", escaped(text))
}

/// What stands between the quotes, of one line.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '"' | '\\' => out.extend(['\\', letter]),
            ' ' => out.push(' '),
            letter if letter.is_ascii_graphic() || letter.is_alphanumeric() => out.push(letter),
            // What is no letter might turn the line round for its reader.
            letter => out.push_str(&format!("\\U{:08X}", u32::from(letter))),
        }
    }
    out
}

/// The cylinders that share a throw of every bank, from one end to the other: each gets the throw of another such set, and the
/// whole crankshaft is turned. Where a throw is split, or banks are opposed, the parts stay as far apart as they were.
fn deal_throws(cylinders: &mut [Cylinder], draw: &mut Draw) {
    let turned = Turn::fraction(draw.below(STEPS) as i64, STEPS as i64);
    let sets = sets(cylinders);
    let first: Vec<Turn> = sets.iter().map(|set| cylinders[set[0]].throw.clone()).collect();
    let order = draw.order_of(sets.len());
    for (set, (old, new)) in sets.iter().zip(first.iter().zip(order.iter().map(|place| &first[*place]))) {
        for index in set {
            let throw = &(&cylinders[*index].throw - old) + new;
            cylinders[*index].throw = &throw + &turned;
        }
    }
}

/// One cylinder of each bank, the banks in the order of their first cylinder; one set of all where banks have not equally many.
fn sets(cylinders: &[Cylinder]) -> Vec<Vec<usize>> {
    let mut banks: Vec<(&Turn, Vec<usize>)> = Vec::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        match banks.iter_mut().find(|(bank, _)| **bank == cylinder.bank) {
            Some((_, of_bank)) => of_bank.push(index),
            None => banks.push((&cylinder.bank, vec![index])),
        }
    }
    banks.iter_mut().for_each(|(_, bank)| bank.sort_by(|a, b| cylinders[*b].position.cmp(&cylinders[*a].position)));
    let count = banks.first().map_or(0, |(_, bank)| bank.len());
    match banks.iter().all(|(_, bank)| bank.len() == count) {
        true => (0..count).map(|place| banks.iter().map(|(_, bank)| bank[place]).collect()).collect(),
        false => vec![(0..cylinders.len()).collect()],
    }
}

/// Another angle between two banks that stand even to both sides of the reference direction and are not opposed.
fn other_banks(cylinders: &mut [Cylinder], draw: &mut Draw) {
    let mut banks: Vec<Turn> = Vec::new();
    for cylinder in cylinders.iter() {
        if !banks.contains(&cylinder.bank) {
            banks.push(cylinder.bank.clone());
        }
    }
    let half = BigRational::new(draw.one_of(&BANK_ANGLES).into(), 2.into());
    let [one, other] = banks.as_slice() else { return };
    let is_even = signed(one) == -signed(other) && !signed(one).is_zero() && *one != other.opposite();
    if !is_even {
        return;
    }
    for cylinder in cylinders.iter_mut() {
        let side = if signed(&cylinder.bank) > BigRational::zero() { half.clone() } else { -half.clone() };
        cylinder.bank = Turn::from_degrees(&side);
    }
}
