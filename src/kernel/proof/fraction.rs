//! How do exact numbers travel in JSON? As strings: `"-3/2"`, `"17"`.

use std::fmt::Display;
use std::str::FromStr;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

/// Longer numbers are not read: no engine whose file is read leads to them.
pub(super) const MOST_DIGITS: usize = 5_000;

/// For `#[serde(with = "fraction")]`: any exact number that prints and parses as text.
pub fn serialize<T: Display, S: Serializer>(number: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(number)
}

/// Reads what [`serialize`] wrote.
pub fn deserialize<'de, T: FromStr, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    let text = String::deserialize(deserializer)?;
    if text.len() > MOST_DIGITS {
        return Err(D::Error::custom(format!("a number of {} digits; at most {MOST_DIGITS} are read", text.len())));
    }
    text.parse().map_err(|_| D::Error::custom(format!("`{text}` is not an exact number such as \"3\" or \"-1/8\"")))
}
