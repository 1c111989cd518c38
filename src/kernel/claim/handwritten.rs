//! What did a student write into a table: which angle, which length, and to how many digits?

use num_rational::BigRational;
use num_traits::{Pow, Signed, Zero};

use super::real::is_negative;
use crate::exact::{PhasorSum, Turn};
use crate::file::{parse_number, turns_per_unit, units};
use crate::numbers::{self, Form};
use crate::text::Untrusted;

/// Longer entries than this are no number of a table.
const LONGEST: usize = 80;

/// An angle as it was written.
#[derive(Clone, Debug)]
pub struct WrittenAngle {
    /// The words.
    pub text: Untrusted,
    /// The angle, exactly as written.
    pub turn: Turn,
    /// How it is rounded, in turns, where decimals are written.
    rounding: Option<Rounding>,
}

/// A length as it was written.
#[derive(Clone, Debug)]
pub struct WrittenLength {
    /// The words.
    pub text: Untrusted,
    /// The length, exactly as written; metres where a unit is behind it.
    pub form: Form,
    /// How it is rounded, where nothing but decimals is written.
    rounding: Option<Rounding>,
}

/// How a decimal is rounded.
#[derive(Clone, Debug)]
struct Rounding {
    /// Half a unit of its last digit.
    half: BigRational,
    /// Digits from the first that is not 0.
    digits: usize,
}

/// How a number that was written agrees with the true one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agrees {
    /// It is the number.
    Exactly,
    /// Its decimals are those of the number, rounded.
    Rounded,
    /// Neither.
    Not,
}

impl WrittenAngle {
    /// Reads an angle in degrees, `22.5`, `51,43°`, or with a unit, `1/7 turn`.
    ///
    /// # Errors
    /// What would be right.
    pub fn read(text: &str) -> Result<Self, String> {
        let Cell { plain, about } = cell(text)?;
        let turn = Turn::new(units::angle(&plain)?);
        let (number, unit) =
            plain.split_at(plain.trim_end_matches(|sign: char| !sign.is_ascii_digit() && sign != '.').len());
        let rounding = rounding(number, about).zip(turns_per_unit(unit)).map(|(rounding, unit)| rounding.scaled(&unit));
        Ok(WrittenAngle { text: Untrusted::new(text), turn, rounding })
    }

    /// By how many turns it may have been rounded.
    pub fn rounding(&self) -> BigRational {
        self.rounding.as_ref().map(|rounding| rounding.half.clone()).unwrap_or_default()
    }

    /// Whether it is rounded to whole degrees or more coarsely, which are too few digits for one that is none.
    pub fn is_coarse(&self) -> bool {
        self.rounding.as_ref().is_some_and(|rounding| rounding.half >= BigRational::new(1.into(), 720.into()))
    }

    /// Whether it is this angle, modulo a turn.
    pub fn agrees(&self, right: &Turn) -> Agrees {
        let off = &self.turn - right;
        let back = -&off;
        let off = if off < back { off } else { back };
        match &self.rounding {
            _ if off == Turn::zero() => Agrees::Exactly,
            Some(rounding) if *off.turns() <= rounding.half => Agrees::Rounded,
            Some(_) | None => Agrees::Not,
        }
    }
}

impl WrittenLength {
    /// Reads a number, `3.16`, `3,16`, `≈3.16`, `sqrt(10)`, `2 sin 36°`; perhaps with m r behind it, of a moment also with mm, cm or m.
    ///
    /// # Errors
    /// What would be right.
    pub fn read(text: &str) -> Result<Self, String> {
        let Cell { plain, about } = cell(text)?;
        let units = [("mm", 1000), ("cm", 100), ("m", 1)];
        let plain = without_mass_radius(&plain);
        let unit = units.iter().find_map(|(unit, parts)| Some((plain.strip_suffix(unit)?.trim_end(), *parts)));
        let (number, parts) = unit.unwrap_or((plain, 1));
        let number = without_mass_radius(number).trim_start_matches('+');
        let scale = BigRational::new(1.into(), parts.into());
        let form = Form::parse(number).ok_or("a number such as 4, 1.732 or \"2√3\"")?;
        let rounding = rounding(number, about).map(|rounding| rounding.scaled(&scale));
        Ok(WrittenLength { text: Untrusted::new(text), form: form.scaled(&scale), rounding })
    }

    /// Whether it is rounded to fewer significant digits than these.
    pub fn is_coarse(&self, least: usize) -> bool {
        self.rounding.as_ref().is_some_and(|rounding| rounding.digits < least)
    }

    /// Whether it is the length of this sum.
    pub fn agrees(&self, sum: &PhasorSum) -> Agrees {
        self.agrees_within(sum, &BigRational::zero())
    }

    /// The same where the sum itself is known only to be this far from that of the true one.
    pub fn agrees_within(&self, sum: &PhasorSum, slack: &BigRational) -> Agrees {
        if is_length(&self.form, sum) {
            return Agrees::Exactly;
        }
        // Zero is proved or not: it is no rounding of anything, and nothing else is one of it.
        let written = self.form.as_rational().filter(|written| !written.is_zero() && !written.is_negative());
        match (&self.rounding, written) {
            (Some(Rounding { half, .. }), Some(written))
                if !sum.vanishes() && is_within(sum, &written, &(half + slack)) =>
            {
                Agrees::Rounded
            }
            _ => Agrees::Not,
        }
    }
}

/// What is in a cell of a table.
struct Cell {
    /// Without spaces at its ends, with a point where a comma stands between digits.
    plain: String,
    /// Whether ≈ stands before it: then a whole number is rounded too.
    about: bool,
}

fn cell(text: &str) -> Result<Cell, String> {
    if text.chars().count() > LONGEST {
        return Err(format!("at most {LONGEST} signs"));
    }
    let text = text.trim();
    let about = text.strip_prefix(['≈', '~']).map(str::trim_start);
    let (text, about) = (about.unwrap_or(text), about.is_some());
    Ok(Cell { plain: with_point(text), about })
}

/// A number with a point where a comma stands between its digits.
pub fn with_point(text: &str) -> String {
    let comma = text.split_once(',').filter(|(before, after)| {
        let digit = |letter: Option<char>| letter.is_some_and(|letter| letter.is_ascii_digit());
        digit(before.chars().next_back()) && digit(after.chars().next()) && !after.contains(',') && !text.contains('.')
    });
    comma.map_or_else(|| text.to_owned(), |(before, after)| format!("{before}.{after}"))
}

/// A length without `m r` behind it, which it is counted in whether that is written or not.
fn without_mass_radius(length: &str) -> &str {
    const WRITTEN: [&str; 4] = ["m r", "m·r", "m*r", "mr"];
    let number = WRITTEN.iter().find_map(|unit| length.strip_suffix(unit));
    number.map_or(length, str::trim_end)
}

/// How a plain decimal is rounded: one with a point, or one that ≈ stands before.
fn rounding(number: &str, about: bool) -> Option<Rounding> {
    let number = number.trim().trim_start_matches(['+', '-', '−']);
    let (whole, behind) = number.split_once('.').or(about.then_some((number, "")))?;
    let is_plain = |digits: &str| digits.bytes().all(|digit| digit.is_ascii_digit());
    let is_decimal = is_plain(whole) && is_plain(behind) && parse_number(number).is_ok();
    let digits = format!("{whole}{behind}").trim_start_matches('0').len();
    let half = || BigRational::new(1.into(), 2.into()) / BigRational::from_integer(10.into()).pow(behind.len());
    is_decimal.then(|| Rounding { half: half(), digits })
}

impl Rounding {
    fn scaled(self, factor: &BigRational) -> Self {
        Rounding { half: self.half * factor, ..self }
    }
}

/// Whether the form is `|S|`: `v² = S S̄` decides where the square is a sum, else the closed form of the length.
fn is_length(form: &Form, sum: &PhasorSum) -> bool {
    if form.to_float() < 0.0 && form.as_rational().is_none_or(|value| value.is_negative()) {
        return false;
    }
    match numbers::square_as_sum(form) {
        Some(square) => square.minus(&sum.squared_modulus()).vanishes(),
        None => numbers::modulus(sum).is_some_and(|right| right == *form),
    }
}

/// Whether `|S|` is no farther than `half` from a number above 0.
fn is_within(sum: &PhasorSum, written: &BigRational, half: &BigRational) -> bool {
    let square = sum.squared_modulus();
    let squared = |value: &BigRational| numbers::number(value * value);
    let (low, high) = (written - half, written + half);
    let is_above = !low.is_positive() || !is_negative(&square.minus(&squared(&low)));
    is_above && !is_negative(&squared(&high).minus(&square))
}

/// Whether a real sum is no farther than `half` from a number.
pub(super) fn is_within_of(real: &PhasorSum, written: &BigRational, half: &BigRational) -> bool {
    let [low, high] = [written - half, written + half].map(numbers::number);
    !is_negative(&real.minus(&low)) && !is_negative(&high.minus(real))
}
