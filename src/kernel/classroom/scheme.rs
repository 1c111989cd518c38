//! How many points does an entry bring?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::Deserialize;

use crate::claim::{Judged, LEAST_DIGITS, Marked, Place};
use crate::file::written::{Text, place, read};
use crate::file::{LayoutError, exact_number, parse_number};

/// Points of the entries of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scheme {
    /// A right phase.
    pub phase: BigRational,
    /// A right length of a sum.
    pub sum: BigRational,
    /// The part of that for a sum which is wrong only because a phase is.
    pub consequential: BigRational,
    /// The part of all points of a sheet that is right in a convention which it does not declare.
    pub undeclared: BigRational,
    /// The significant digits that a rounded length needs.
    pub digits: usize,
    /// The part of the points for an entry that is right to fewer digits.
    pub coarse: BigRational,
}

/// Nobody rounds to more digits by hand.
const MOST_DIGITS: usize = 12;

impl Default for Scheme {
    fn default() -> Self {
        let one = BigRational::one;
        let half = BigRational::new(1.into(), 2.into());
        Scheme {
            phase: one(),
            sum: one() + one(),
            consequential: one(),
            undeclared: half.clone(),
            digits: LEAST_DIGITS,
            coarse: half,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    phase: Option<Text>,
    sum: Option<Text>,
    consequential: Option<Text>,
    undeclared: Option<Text>,
    digits: Option<Text>,
    coarse: Option<Text>,
}

/// Reads a scheme; a key that is omitted keeps its default.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::classroom::{Scheme, parse_scheme};
/// let scheme = parse_scheme("scheme.toml", "sum = 4\nundeclared = 0").unwrap();
/// assert_eq!(scheme.to_toml(), "phase = 1\nsum = 4\nconsequential = 1\nundeclared = 0\ndigits = 2\ncoarse = 0.5\n");
/// assert_eq!(parse_scheme("scheme.toml", "").unwrap(), Scheme::default());
/// ```
///
/// # Errors
/// The first mistake, with its place and what would be right.
pub fn parse_scheme(name: &str, source: &str) -> Result<Scheme, LayoutError> {
    read::<Keys>(source).and_then(scheme).map_err(|error| error.in_file(name, source))
}

fn scheme(keys: Keys) -> Result<Scheme, LayoutError> {
    let usual = Scheme::default();
    let points = "points, 0 or more, such as 2 or 0.5";
    let part = "a part of the points from 0 to 1, such as 0.5";
    let not_negative = |value: &BigRational| !value.is_negative();
    let is_part = |value: &BigRational| !value.is_negative() && *value <= BigRational::one();
    let of_sum = keys.sum.as_ref().and_then(place);
    let (phase, sum) =
        (number(keys.phase, usual.phase, points, not_negative)?, number(keys.sum, usual.sum, points, not_negative)?);
    if phase.is_zero() && sum.is_zero() {
        return Err(LayoutError::new("no entry earns a point", "phase or sum above 0", of_sum));
    }
    Ok(Scheme {
        phase,
        sum,
        consequential: number(keys.consequential, usual.consequential, part, is_part)?,
        undeclared: number(keys.undeclared, usual.undeclared, part, is_part)?,
        digits: keys.digits.map_or(Ok(usual.digits), digits)?,
        coarse: number(keys.coarse, usual.coarse, part, is_part)?,
    })
}

fn digits(text: Text) -> Result<usize, LayoutError> {
    let written = &text.get_ref().0;
    let value = written.parse().ok().filter(|value| (1..=MOST_DIGITS).contains(value));
    let right = || format!("a whole number of significant digits from 1 to {MOST_DIGITS}");
    value.ok_or_else(|| LayoutError::new(format!("cannot read `{written}`"), right(), place(&text)))
}

fn number(
    text: Option<Text>,
    usual: BigRational,
    right: &str,
    fits: impl Fn(&BigRational) -> bool,
) -> Result<BigRational, LayoutError> {
    let Some(text) = text else { return Ok(usual) };
    let written = &text.get_ref().0;
    let value = parse_number(written).ok().filter(fits);
    value.ok_or_else(|| LayoutError::new(format!("cannot read `{written}`"), right, place(&text)))
}

impl Scheme {
    /// As a file has it.
    pub fn to_toml(&self) -> String {
        let keys = [
            ("phase", &self.phase),
            ("sum", &self.sum),
            ("consequential", &self.consequential),
            ("undeclared", &self.undeclared),
            ("digits", &BigRational::from_integer(self.digits.into())),
            ("coarse", &self.coarse),
        ];
        keys.map(|(key, value)| format!("{key} = {}\n", exact_number(value))).concat()
    }

    /// The points of an entry in the convention of its sheet.
    pub fn points(&self, entry: &Marked) -> BigRational {
        match entry.judged {
            Judged::Right => self.full(entry),
            Judged::Consequential => self.full(entry) * &self.consequential,
            Judged::Coarse => self.full(entry) * &self.coarse,
            Judged::Wrong | Judged::Unreadable | Judged::Missing => BigRational::zero(),
        }
    }

    /// Those that the entry brings where it is right.
    pub fn full(&self, entry: &Marked) -> BigRational {
        match entry.place {
            Place::Phase(..) => self.phase.clone(),
            Place::Sum(..) => self.sum.clone(),
        }
    }
}
