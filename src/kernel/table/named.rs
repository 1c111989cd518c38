//! Which value of a table has a name? A place in its keys and the name of a column: `1.frequency` in a table of modes.

use std::cmp::Reverse;
use std::fmt;

use super::{Column, Table, Unit, Values};
use crate::text::{Untrusted, harmless};

/// A value of a table, with the type of its column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// Words of this program.
    Words(&'a str),
    /// What a person wrote.
    Person(&'a Untrusted),
    /// An exact number as text.
    Exact(&'a str),
    /// A whole number.
    Integer(i64),
    /// A decimal.
    Decimal(f64),
    /// True or false.
    Truth(bool),
}

impl Values {
    /// The value of a row; none where there is nothing to say.
    pub fn get(&self, row: usize) -> Option<Value<'_>> {
        match self {
            Values::Words(values) => values.get(row)?.as_deref().map(Value::Words),
            Values::Exact(values) => values.get(row)?.as_deref().map(Value::Exact),
            Values::Person(values) => values.get(row)?.as_ref().map(Value::Person),
            Values::Integer(values) => values.get(row)?.map(Value::Integer),
            Values::Decimal(values) => values.get(row)?.map(Value::Decimal),
            Values::Truth(values) => values.get(row)?.map(Value::Truth),
        }
    }
}

impl Value<'_> {
    /// Whether a key means it: as it is written, a decimal as a fraction too.
    fn is(&self, key: &str) -> bool {
        match self {
            Value::Decimal(number) => decimal(key) == Some(*number),
            Value::Words(_) | Value::Person(_) | Value::Exact(_) | Value::Integer(_) | Value::Truth(_) => {
                self.to_string() == key
            }
        }
    }
}

/// `1.5` or `3/2`.
fn decimal(text: &str) -> Option<f64> {
    match text.split_once('/') {
        None => text.parse().ok(),
        Some((above, below)) => Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?),
    }
}

impl fmt::Display for Value<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Words(text) | Value::Exact(text) => f.write_str(text),
            Value::Person(text) => f.write_str(&harmless(text.written())),
            Value::Integer(number) => number.fmt(f),
            Value::Decimal(number) => number.fmt(f),
            Value::Truth(truth) => truth.fmt(f),
        }
    }
}

/// A value that was taken from a table, with what its column says of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Single {
    /// What it is counted in.
    pub unit: Unit,
    /// What it tells.
    pub about: &'static str,
    values: Values,
}

impl Single {
    /// The value; none where there is nothing to say.
    pub fn value(&self) -> Option<Value<'_>> {
        self.values.get(0)
    }

    /// Values of the same name as a column, with the unit and the type of this one; what is of another is omitted.
    pub fn column<'a>(&self, name: &str, all: impl IntoIterator<Item = Option<&'a Single>>) -> Column {
        let mut values = self.values.of_rows(0..0);
        for one in all {
            values.append(one.filter(|one| one.unit == self.unit).map(|one| &one.values));
        }
        let pattern = if self.unit.suffix.is_empty() { "{value}" } else { "{value}_{unit}" };
        // Who names a value with its unit has it once.
        let name = without_unit(name, self.unit);
        Column::named(pattern, &[name], self.unit, self.about, values)
    }
}

/// Why a table has no value of this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotNamed {
    /// No column is called so: those that there are, the most alike first.
    Column(String, Vec<String>),
    /// No row has this key.
    Row {
        /// The name of the first key that fits none.
        key: String,
        /// What was asked for.
        asked: String,
        /// Those that there are.
        there: Vec<String>,
    },
    /// More or fewer keys than the table has: their names.
    Keys(Vec<String>),
    /// So many rows have these keys, and other values.
    Several(usize),
    /// The row is of several parts, and has no value of its own: what they are called.
    Parts(Vec<String>),
}

impl NotNamed {
    fn nothing() -> Self {
        NotNamed::Row { key: String::new(), asked: String::new(), there: Vec::new() }
    }
}

/// So many names are listed at most.
const MOST_LISTED: usize = 12;

fn listed(names: &[String]) -> String {
    let shown: Vec<String> = names.iter().take(MOST_LISTED).map(|name| harmless(name)).collect();
    let more = if names.len() > MOST_LISTED { ", …" } else { "" };
    shown.join(", ") + more
}

impl fmt::Display for NotNamed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotNamed::Column(asked, there) => write!(f, "no column `{}`; there are {}", harmless(asked), listed(there)),
            NotNamed::Row { asked, there, .. } if there.is_empty() => {
                write!(f, "no row `{}`; the table is empty", harmless(asked))
            }
            NotNamed::Row { asked, there, .. } => {
                write!(f, "no row `{}`; there are {}", harmless(asked), listed(there))
            }
            NotNamed::Keys(keys) if keys.is_empty() => write!(f, "the table has one row; name a column alone"),
            NotNamed::Several(rows) => {
                write!(f, "{rows} rows have these keys and differ in this column: it has no one value")
            }
            NotNamed::Parts(parts) => write!(f, "it is told of each part alone: {}", harmless(&parts.join("; "))),
            NotNamed::Keys(keys) => write!(f, "a row is named by {}, then a column", keys.join(", then ")),
        }
    }
}

impl std::error::Error for NotNamed {}

/// The part of a column's name that is said of every zero-to-peak value.
const PEAK: &str = "_zero_to_peak";

impl Column {
    /// Its name without its unit and without `zero_to_peak`: `force` for `force_zero_to_peak_N`.
    pub fn stem(&self) -> String {
        without_unit(self.name(), self.unit()).replace(PEAK, "")
    }
}

fn without_unit(name: &str, unit: Unit) -> &str {
    let bare = name.strip_suffix(unit.suffix).filter(|_| !unit.suffix.is_empty());
    bare.and_then(|bare| bare.strip_suffix('_')).unwrap_or(name)
}

/// How much of a name another has: words, then letters from the beginning on.
fn likeness(one: &str, other: &str) -> (usize, usize) {
    let words: Vec<&str> = one.split('_').collect();
    let shared = other.split('_').filter(|word| words.contains(word)).count();
    let alike = one.chars().zip(other.chars()).take_while(|(one, other)| one == other).count();
    // A letter or two in common are chance.
    (shared, if alike < 3 { 0 } else { alike })
}

impl Table {
    /// The value that a name means: the keys of its row, then the name of its column, with its unit or without. A key that has points of
    /// its own, such as 22.5 or `No. 1`, may come in several parts.
    ///
    /// # Errors
    /// What there is in its place.
    pub fn named(&self, keys: &[&str], column: &str) -> Result<Single, NotNamed> {
        let rows = self.having_keys(keys)?;
        let is_meant = |other: &&Column| {
            let name = other.name();
            name == column || without_unit(name, other.unit()) == column || other.stem() == column
        };
        let (keys, values) = self.columns().split_at(self.keys());
        let found = values.iter().chain(keys).find(is_meant).ok_or_else(|| {
            let mut there: Vec<String> = values.iter().map(Column::stem).collect();
            there.sort_by_key(|name| Reverse(likeness(column, name)));
            NotNamed::Column(column.to_owned(), there)
        })?;
        let single = |row: usize| found.values().of_rows(row..row + 1);
        let (first, others) = rows.split_first().ok_or_else(NotNamed::nothing)?;
        let of = values.iter().find(|column| column.name() == "of");
        let part = |row: &usize| Some(of?.values().get(*row)?.to_string());
        let parts: Vec<String> = rows.iter().filter_map(part).collect();
        // A row of no part stands before its parts.
        let is_whole = of.is_some() && part(first).is_none();
        match found.values().get(*first) {
            None if is_whole && parts.len() > 1 => Err(NotNamed::Parts(parts)),
            _ if is_whole || others.iter().all(|other| single(*other) == single(*first)) => {
                Ok(Single { unit: found.unit(), about: found.about(), values: single(*first) })
            }
            _ => Err(NotNamed::Several(rows.len())),
        }
    }

    /// The places of the rows with these keys, at least one.
    fn having_keys(&self, keys: &[&str]) -> Result<Vec<usize>, NotNamed> {
        let columns = &self.columns()[..self.keys()];
        let more = keys.len().checked_sub(columns.len()).filter(|more| *more == 0 || !columns.is_empty());
        let more = more.ok_or_else(|| NotNamed::Keys(columns.iter().map(Column::stem).collect()))?;
        let all = || (0..self.rows()).collect::<Vec<usize>>();
        if let Some(rows) = fitting(columns, keys, all()).filter(|rows| !rows.is_empty()) {
            return Ok(rows);
        }
        // Which key fits no row is told of the first way to read them: what is too much belongs to the first key.
        let first = keys.get(..=more).unwrap_or_default().join(".");
        let keys = [first.as_str()].into_iter().chain(keys.iter().skip(more + 1).copied());
        let mut rows = all();
        for (column, asked) in columns.iter().zip(keys) {
            let fit = having(column, asked, &rows);
            if fit.is_empty() {
                let text = |row: &usize| column.values().get(*row).map(|value| value.to_string()).unwrap_or_default();
                let mut there: Vec<String> = rows.iter().map(text).collect();
                there.dedup();
                return Err(NotNamed::Row { key: column.stem(), asked: asked.to_owned(), there });
            }
            rows = fit;
        }
        Err(NotNamed::nothing())
    }
}

/// Those of the rows whose value in this column a key means.
fn having(column: &Column, key: &str, rows: &[usize]) -> Vec<usize> {
    let is_meant = |row: &&usize| column.values().get(**row).is_some_and(|value| value.is(key));
    rows.iter().filter(is_meant).copied().collect()
}

/// Those of the rows that all keys mean, each of one part or more.
fn fitting(columns: &[Column], parts: &[&str], rows: Vec<usize>) -> Option<Vec<usize>> {
    let Some((column, others)) = columns.split_first() else { return parts.is_empty().then_some(rows) };
    (1..=parts.len().checked_sub(others.len())?).find_map(|count| {
        let (key, rest) = parts.split_at(count);
        let fit = having(column, &key.join("."), &rows);
        if fit.is_empty() { None } else { fitting(others, rest, fit) }
    })
}
