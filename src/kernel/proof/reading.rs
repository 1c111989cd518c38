//! Is a document said as this program says it?
//!
//! What is read is written again and compared, so that no key and no number is passed over: unknown keys, keys that stand
//! where they mean nothing, numbers in another spelling.

use std::fmt;

use serde::de::{DeserializeOwned, Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};

use super::fraction::MOST_DIGITS;

/// Larger documents are not read.
pub const LARGEST_DOCUMENT: usize = 4 << 20;

/// Why a text is no document.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unreadable {
    /// More bytes than are read.
    #[error("it has {0} bytes; up to {LARGEST_DOCUMENT} (4 MiB) are read")]
    TooLarge(usize),
    /// More digits than are read.
    #[error("a number has {0} digits; up to {MOST_DIGITS} are read")]
    TooManyDigits(usize),
    /// Not JSON, or a key that stands twice.
    #[error("{0}")]
    NotJson(String),
    /// It names no format.
    #[error("it names no format; the first key is \"format\", such as \"format\": \"crankstar classify 2\"")]
    NoFormat,
    /// The format that it names is none of those that are known.
    #[error(
        "the format {0} is not known; known are \"crankstar classify 2\", \"crankstar family 2\", \
         \"crankstar remedy 2\", \"crankstar firing 1\", \"crankstar loads 4\" and \"crankstar compare 4\""
    )]
    Format(String),
    /// Not said as the format has it.
    #[error("{0}")]
    Malformed(String),
}

/// Reads a document that says nothing else and nothing in another way.
pub(super) fn typed<T: DeserializeOwned + Serialize>(tree: &Value) -> Result<T, Unreadable> {
    let malformed = |error: serde_json::Error| Unreadable::Malformed(error.to_string());
    let document: T = T::deserialize(tree).map_err(malformed)?;
    let again = serde_json::to_value(&document).map_err(malformed)?;
    match difference("", tree, &again) {
        None => Ok(document),
        Some(at) => {
            let Difference { place, found, right } = at;
            let words = match (found, right) {
                (Some(_), None) => format!("{place}: nothing is known of this key"),
                (None, _) => format!("{place}: is missing"),
                (Some(found), Some(right)) => format!("{place}: {found} is written {right}"),
            };
            Err(Unreadable::Malformed(words))
        }
    }
}

/// Where two values differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The path, as in `cylinders[2].throw`.
    pub place: String,
    /// What the first says there.
    pub found: Option<Value>,
    /// What the second says there.
    pub right: Option<Value>,
}

pub(super) fn difference(place: &str, found: &Value, right: &Value) -> Option<Difference> {
    let at = |place: String, a: Option<&Value>, b: Option<&Value>| match (a, b) {
        (Some(a), Some(b)) => difference(&place, a, b),
        (None, None) => None,
        (a, b) => Some(Difference { place, found: a.cloned(), right: b.cloned() }),
    };
    match (found, right) {
        (Value::Object(a), Value::Object(b)) => {
            let keys = a.keys().chain(b.keys().filter(|key| !a.contains_key(*key)));
            let dot = if place.is_empty() { "" } else { "." };
            keys.into_iter().find_map(|key| at(format!("{place}{dot}{key}"), a.get(key), b.get(key)))
        }
        (Value::Array(a), Value::Array(b)) => {
            (0..a.len().max(b.len())).find_map(|index| at(format!("{place}[{index}]"), a.get(index), b.get(index)))
        }
        // 2 and 2.0 are the same decimal.
        (Value::Number(a), Value::Number(b)) if a.as_f64() == b.as_f64() => None,
        (a, b) if a == b => None,
        (a, b) => Some(Difference { place: place.to_owned(), found: Some(a.clone()), right: Some(b.clone()) }),
    }
}

/// The length of a number that is too long to be read; titles and names may be long.
pub(super) fn too_many_digits(tree: &Value) -> Option<usize> {
    let is_number = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit() || b"-+/".contains(&byte));
    match tree {
        Value::String(text) => (text.len() > MOST_DIGITS && is_number(text)).then_some(text.len()),
        Value::Array(list) => list.iter().find_map(too_many_digits),
        Value::Object(map) => map.values().find_map(too_many_digits),
        Value::Null | Value::Bool(_) | Value::Number(_) => None,
    }
}

/// JSON in which no key stands twice.
pub(super) struct Tree(pub Value);

impl<'de> Deserialize<'de> for Tree {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Builder).map(Tree)
    }
}

struct Builder;

impl<'de> Visitor<'de> for Builder {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    #[expect(clippy::disallowed_types, reason = "the decimals of a document are read, and computed with exactly")]
    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut values = Vec::new();
        while let Some(Tree(value)) = list.next_element()? {
            values.push(value);
        }
        Ok(Value::Array(values))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let mut values = Map::new();
        while let Some((key, Tree(value))) = map.next_entry::<String, Tree>()? {
            if values.contains_key(&key) {
                return Err(A::Error::custom(format!("the key `{key}` is given twice")));
            }
            values.insert(key, value);
        }
        Ok(Value::Object(values))
    }
}
