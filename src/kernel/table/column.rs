//! What is a column of a table? Values of one type, a name with the unit in it, and a sentence that tells what they mean.

use std::borrow::Cow;
use std::ops::Range;

use super::Unit;
use crate::text::Untrusted;

/// The values of a column, a row each; `None` where there is nothing to say.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Words of this program.
    Words(Vec<Option<String>>),
    /// What a person wrote: a writer sees to it that it stays a text.
    Person(Vec<Option<Untrusted>>),
    /// Exact numbers as text, in closed form: `√10`, `1/3`, `0`.
    Exact(Vec<Option<String>>),
    /// Whole numbers.
    Integer(Vec<Option<i64>>),
    /// Decimals; 0 is written where it is proved, and the column beside it that ends in `vanishes` tells so.
    Decimal(Vec<Option<f64>>),
    /// True or false; `None` where it is not decided.
    Truth(Vec<Option<bool>>),
}

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Words of this program.
    Words,
    /// What a person wrote.
    Person,
    /// An exact number as text.
    Exact,
    /// A whole number.
    Integer,
    /// A decimal.
    Decimal,
    /// True or false.
    Truth,
}

impl Kind {
    /// What the documentation calls it.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Words => "text",
            Kind::Person => "text of the file",
            Kind::Exact => "exact",
            Kind::Integer => "whole",
            Kind::Decimal => "decimal",
            Kind::Truth => "truth",
        }
    }
}

impl Values {
    /// How many rows they fill.
    pub fn len(&self) -> usize {
        match self {
            Values::Words(values) | Values::Exact(values) => values.len(),
            Values::Person(values) => values.len(),
            Values::Integer(values) => values.len(),
            Values::Decimal(values) => values.len(),
            Values::Truth(values) => values.len(),
        }
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The values of some rows.
    pub(super) fn of_rows(&self, rows: Range<usize>) -> Values {
        match self {
            Values::Words(values) => Values::Words(values[rows].to_vec()),
            Values::Exact(values) => Values::Exact(values[rows].to_vec()),
            Values::Person(values) => Values::Person(values[rows].to_vec()),
            Values::Integer(values) => Values::Integer(values[rows].to_vec()),
            Values::Decimal(values) => Values::Decimal(values[rows].to_vec()),
            Values::Truth(values) => Values::Truth(values[rows].to_vec()),
        }
    }

    /// Adds those of the same type; nothing said where they are of another.
    pub(super) fn append(&mut self, other: Option<&Values>) {
        match (self, other) {
            (Values::Words(values), Some(Values::Words(more))) => values.extend_from_slice(more),
            (Values::Exact(values), Some(Values::Exact(more))) => values.extend_from_slice(more),
            (Values::Person(values), Some(Values::Person(more))) => values.extend_from_slice(more),
            (Values::Integer(values), Some(Values::Integer(more))) => values.extend_from_slice(more),
            (Values::Decimal(values), Some(Values::Decimal(more))) => values.extend_from_slice(more),
            (Values::Truth(values), Some(Values::Truth(more))) => values.extend_from_slice(more),
            (Values::Words(values) | Values::Exact(values), _) => values.push(None),
            (Values::Person(values), _) => values.push(None),
            (Values::Integer(values), _) => values.push(None),
            (Values::Decimal(values), _) => values.push(None),
            (Values::Truth(values), _) => values.push(None),
        }
    }

    /// Adds a value as a table of comma-separated values has it; none where it is no such value.
    pub(super) fn read(&mut self, text: Cow<'_, str>) -> Option<()> {
        let is_there = !text.is_empty();
        match self {
            Values::Words(values) | Values::Exact(values) => values.push(is_there.then(|| text.into_owned())),
            Values::Person(values) => values.push(is_there.then(|| Untrusted::new(&*text))),
            Values::Integer(values) => values.push(if is_there { Some(text.parse().ok()?) } else { None }),
            Values::Decimal(values) => values.push(if is_there { Some(text.parse().ok()?) } else { None }),
            Values::Truth(values) => values.push(if is_there { Some(text.parse().ok()?) } else { None }),
        }
        Some(())
    }

    /// Their type.
    pub fn kind(&self) -> Kind {
        match self {
            Values::Words(_) => Kind::Words,
            Values::Person(_) => Kind::Person,
            Values::Exact(_) => Kind::Exact,
            Values::Integer(_) => Kind::Integer,
            Values::Decimal(_) => Kind::Decimal,
            Values::Truth(_) => Kind::Truth,
        }
    }
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    name: String,
    pattern: &'static str,
    unit: Unit,
    about: &'static str,
    values: Values,
}

impl Column {
    /// A column whose name is `pattern`, with its unit in place of `{unit}`.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::table::{Column, Unit, Values};
    /// let force = Column::new("force_y_{unit}", Unit::NEWTON, "along the reference direction", Values::Decimal(vec![Some(1.5)]));
    /// assert_eq!(force.name(), "force_y_N");
    /// ```
    pub fn new(pattern: &'static str, unit: Unit, about: &'static str, values: Values) -> Self {
        Column::named(pattern, &[], unit, about, values)
    }

    /// A column whose name has other holes besides the unit: each is filled in turn.
    pub fn named(pattern: &'static str, holes: &[&str], unit: Unit, about: &'static str, values: Values) -> Self {
        Column { name: filled(pattern, holes, unit), pattern, unit, about, values }
    }

    /// The same with other values.
    pub(super) fn with(&self, values: Values) -> Self {
        Column { name: self.name.clone(), values, ..*self }
    }

    /// Its name, with the unit.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The same under another name.
    pub(super) fn called(self, name: String) -> Self {
        Column { name, ..self }
    }

    /// The name with its holes: `force_{order}_largest_{unit}`, by which the documentation lists it.
    pub fn pattern(&self) -> &'static str {
        self.pattern
    }

    /// What it is counted in.
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// What it tells.
    pub fn about(&self) -> &'static str {
        self.about
    }

    /// Its values.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// The same with decimals of this many digits.
    pub(super) fn rounded(self, digits: usize) -> Self {
        let round = |value: f64| format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
        let values = match self.values {
            Values::Decimal(values) => Values::Decimal(values.into_iter().map(|value| value.map(round)).collect()),
            other @ (Values::Words(_)
            | Values::Person(_)
            | Values::Exact(_)
            | Values::Integer(_)
            | Values::Truth(_)) => other,
        };
        Column { values, ..self }
    }
}

/// A pattern with its holes filled: `{unit}` by the unit, the others in turn.
pub fn filled(pattern: &str, holes: &[&str], unit: Unit) -> String {
    let (mut name, mut rest, mut holes) = (String::new(), pattern, holes.iter());
    while let Some((before, after)) = rest.split_once('{') {
        let (hole, after) = after.split_once('}').unwrap_or((after, ""));
        name.push_str(before);
        name.push_str(if hole == "unit" { unit.suffix } else { holes.next().copied().unwrap_or_default() });
        rest = after;
    }
    name + rest
}
