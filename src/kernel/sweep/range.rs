//! Which values does a parameter take? `0..180:10`: from, to and step, exact, with a unit behind them or without.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::SweepError;
use crate::exact::fraction;
use crate::file::parse_number;

/// More points than this are not kept for a page: at some kilobytes each they would fill a memory. A table of them may be longer.
pub const MOST_POINTS: usize = 100_000;
/// More than this no machine computes.
pub(super) const MOST_COUNTED: usize = 1_000_000_000;

/// Exact values at equal steps. The end is one of them where it lies on the grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Range {
    from: BigRational,
    step: BigRational,
    count: usize,
    unit: String,
}

impl Range {
    /// Reads `FROM..TO:STEP`, perhaps with a unit: `80..120:5 mm`, or behind each number.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// let range = crankstar::sweep::Range::parse("0..1:1/3").unwrap();
    /// assert_eq!(range.values().map(|value| value.to_string()).collect::<Vec<_>>(), ["0", "1/3", "2/3", "1"]);
    /// assert!(crankstar::sweep::Range::parse("0..1000000000:1").is_err());
    /// ```
    ///
    /// # Errors
    /// What cannot be read, a step of 0, a range that is empty, or one of more than a thousand million points.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let example = "write FROM..TO:STEP, such as 0..180:10 or 80..120:5 mm";
        let refuse = |what: String| SweepError::new(format!("the range `{}` {what}", shown(text)));
        let (from, rest) = text.split_once("..").ok_or_else(|| refuse(format!("has no `..`; {example}")))?;
        let (to, rest) = rest.split_once(':').ok_or_else(|| refuse(format!("has no step; {example}")))?;
        let rest = rest.trim();
        let end = match parse_number(rest) {
            Ok(_) => rest.len(),
            Err(_) => rest.find(|letter: char| !is_of_a_number(letter)).unwrap_or(rest.len()),
        };
        let (step, unit) = rest.split_at(end);
        if !unit.chars().all(|letter| letter.is_alphanumeric() || " °·/".contains(letter)) {
            return Err(refuse(format!("has `{}` for its unit; such as mm, deg or rpm", shown(unit.trim()))));
        }
        let number = |what: &str, text: &str| {
            parse_number(text.trim().strip_suffix(unit.trim()).unwrap_or(text).trim())
                .map_err(|error| refuse(format!("has `{}` for its {what}: {error}", shown(text.trim()))))
        };
        let (from, to, step) = (number("start", from)?, number("end", to)?, number("step", step.trim())?);
        if step.is_zero() {
            return Err(refuse(format!("has a step of 0, which never arrives; {example}")));
        }
        let way = &to - &from;
        if (way.is_positive() && step.is_negative()) || (way.is_negative() && step.is_positive()) {
            let right = format!("{from}..{to}:{}", -&step);
            return Err(refuse(format!("is empty: its step leads away from {to}; {right} would lead there")));
        }
        let count: BigInt = (way / &step).floor().to_integer() + BigInt::one();
        let Some(count) = count.to_usize().filter(|count| *count <= MOST_COUNTED) else {
            return Err(refuse(format!("has {count} points; up to {MOST_COUNTED} are computed: take a larger step")));
        };
        Ok(Range { from, step, count, unit: unit.trim().to_owned() })
    }

    /// How many values there are, at least 1.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The unit behind the numbers; empty where there is none.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// The value of this index.
    pub fn value(&self, index: usize) -> BigRational {
        fraction::plus(&self.from, &fraction::times(&self.step, &BigRational::from_integer(index.into())))
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = BigRational> + '_ {
        (0..self.count).map(|index| self.value(index))
    }

    /// The last value.
    pub fn last(&self) -> BigRational {
        self.value(self.count - 1)
    }

    /// The same range in steps that are `parts` times as short.
    pub fn finer(&self, parts: usize) -> Range {
        let step = &self.step / BigRational::from_integer(parts.max(1).into());
        Range { step, count: (self.count - 1) * parts.max(1) + 1, ..self.clone() }
    }

    /// A value as a layout file has it.
    pub(super) fn written(&self, value: &BigRational) -> String {
        if self.unit.is_empty() { value.to_string() } else { format!("{value} {}", self.unit) }
    }
}

fn is_of_a_number(letter: char) -> bool {
    letter.is_ascii_digit() || matches!(letter, '.' | '/' | '-' | '+' | '−')
}

fn shown(text: &str) -> String {
    let short: String = text.chars().take(40).collect();
    if short.len() < text.len() { format!("{short}…") } else { short }
}
