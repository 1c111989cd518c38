//! How is a file read without losing a digit? Numbers stay the text that was written.

use std::marker::PhantomData;
use std::ops::Range;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{DeserializeOwned, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::LayoutError;
use super::schema::tables;
use crate::text::Untrusted;

/// A number or a text, as written.
#[derive(Clone, Debug)]
pub(crate) struct Written(pub String);

impl Written {
    /// The text, as what it is: a person's.
    pub fn untrusted(&self) -> Untrusted {
        Untrusted::new(self.0.as_str())
    }
}

/// A number or a text with its place in the file.
pub(crate) type Text = Spanned<Written>;

impl<'de> Deserialize<'de> for Written {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text;
        impl Visitor<'_> for Text {
            type Value = Written;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number or a text in quotes")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Written, E> {
                Ok(Written(text.to_owned()))
            }
        }
        deserializer.deserialize_str(Text)
    }
}

/// One value for all, or a list with one value for each.
#[derive(Clone, Debug)]
pub(crate) enum Values {
    /// The value of all.
    One(Written),
    /// One for each.
    Each(Vec<Text>),
}

/// [`Values`] with their place in the file.
pub(crate) type Column = Spanned<Values>;

impl<'de> Deserialize<'de> for Values {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrEach;
        impl<'de> Visitor<'de> for OneOrEach {
            type Value = Values;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number, a text in quotes, or a list of them")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Values, E> {
                Ok(Values::One(Written(text.to_owned())))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Values, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(list)).map(Values::Each)
            }
        }
        deserializer.deserialize_any(OneOrEach)
    }
}

/// What `T` reads from the keys of a table; a list of values is no table, though serde would take it for one.
#[derive(Clone, Debug)]
pub(crate) struct Table<T>(pub T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Table<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Keys<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Keys<T> {
            type Value = Table<T>;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("one table, its keys below a name such as [vee], or in braces such as { rotating = 1, reciprocating = 0.5 }")
            }
            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<Table<T>, A::Error> {
                T::deserialize(MapAccessDeserializer::new(keys)).map(Table)
            }
        }
        deserializer.deserialize_map(Keys(PhantomData))
    }
}

/// More unknown keys than this are not told at once.
const MOST_UNKNOWN: usize = 20;

/// Reads TOML into `T`, whose numbers are texts as written: a decimal never passes through a float. Unknown keys are reported all at once.
pub fn read<T: DeserializeOwned>(source: &str) -> Result<T, LayoutError> {
    let mut unknown: Vec<LayoutError> = Vec::new();
    loop {
        // Each time without the keys that are reported already.
        let mut table = table(source)?;
        let is_rest = unknown.iter().filter_map(LayoutError::span).all(|span| removed(table.get_mut(), &span));
        let error = match T::deserialize(toml::Deserializer::from(table)) {
            Ok(read) if unknown.is_empty() => return Ok(read),
            Ok(_) => None,
            Err(error) => Some(error),
        };
        match error {
            Some(error) if is_rest && is_unknown(&error) && unknown.len() < MOST_UNKNOWN => {
                unknown.push(toml_error(error))
            }
            Some(error) if unknown.is_empty() => return Err(toml_error(error)),
            // What is missing besides may be what the unknown keys mean.
            Some(_) | None => break,
        }
    }
    unknown.sort_by_key(|told| told.span().map(|span| span.start));
    let first = unknown.remove(0);
    Err(first.and(unknown))
}

fn is_unknown(error: &toml::de::Error) -> bool {
    error.message().starts_with("unknown field")
}

/// Takes the key at this place out of a table or of those in it; whether it was there.
fn removed(table: &mut DeTable<'_>, at: &Range<usize>) -> bool {
    let here = table.keys().find(|key| key.span() == *at).map(|key| key.get_ref().to_string());
    match here {
        Some(key) => table.remove(key.as_str()).is_some(),
        None => table.iter_mut().any(|(_, value)| removed_below(value.get_mut(), at)),
    }
}

fn removed_below(value: &mut DeValue<'_>, at: &Range<usize>) -> bool {
    match value {
        DeValue::Table(table) => removed(table, at),
        DeValue::Array(list) => list.iter_mut().any(|value| removed_below(value.get_mut(), at)),
        _ => false,
    }
}

/// The tables of a text, their numbers as they were written.
pub(super) fn table(source: &str) -> Result<Spanned<DeTable<'_>>, LayoutError> {
    let mut table = DeTable::parse(source).map_err(toml_error)?;
    let pairs = table.get_mut().iter_mut();
    for (_, value) in pairs {
        numbers_as_text(value.get_mut());
    }
    Ok(table)
}

/// Reads tables whose numbers are texts into `T`.
pub(super) fn read_table<T: DeserializeOwned>(table: Spanned<DeTable<'_>>) -> Result<T, LayoutError> {
    T::deserialize(toml::Deserializer::from(table)).map_err(toml_error)
}

fn numbers_as_text(value: &mut DeValue<'_>) {
    let text = match value {
        DeValue::Integer(integer) => integer.to_string(),
        DeValue::Float(float) => float.as_str().to_owned(),
        DeValue::Datetime(date) => date.to_string(),
        DeValue::Array(array) => {
            return array.iter_mut().for_each(|element| numbers_as_text(element.get_mut()));
        }
        DeValue::Table(table) => {
            return table.iter_mut().for_each(|(_, element)| numbers_as_text(element.get_mut()));
        }
        _ => return,
    };
    *value = DeValue::String(text.into());
}

/// What the reader says of text without quotes: it takes `two-stroke` for a beginning `true`, and `1-3-4-2` for a date.
const UNQUOTED: [&str; 3] = ["string values must be quoted", "invalid boolean", "invalid date"];

/// The reader's message in the words of this program.
fn toml_error(error: toml::de::Error) -> LayoutError {
    let message = error.message().lines().collect::<Vec<_>>().join("; ");
    let (what, expected) = message.split_once(", expected ").unwrap_or((&message, ""));
    let words = what.split_once(": ").map_or_else(|| what.split_once(" field "), Some);
    let (what, right) = match (words, expected) {
        (Some(("missing", key)), _) => (format!("the key {key} is missing"), "this table needs it".to_owned()),
        (Some(("unknown", key)), expected) => {
            (format!("unknown key {key}"), what_is_known(key.trim_matches('`'), expected))
        }
        (Some(("invalid type", "map")), "a sequence") => {
            ("a table in place of a list".to_owned(), "a list of tables has [[two brackets]]".to_owned())
        }
        (Some(("invalid type", found)), expected) => {
            (format!("{} is in the wrong place", value(found)), format!("expected {}", value(expected)))
        }
        _ if what == "duplicate key" => {
            (what.to_owned(), "this key is in the file before, perhaps as [key] beside [[key]]".to_owned())
        }
        _ if what.contains("recurs") => ("lists or tables nest too deeply".to_owned(), "no key needs that".to_owned()),
        _ if UNQUOTED.iter().any(|unquoted| what.starts_with(unquoted)) => (
            "this is neither a number nor a text in quotes".to_owned(),
            "text stands in quotes, and between the values of a list stand commas".to_owned(),
        ),
        _ if what == "unexpected key or value" => (
            "a value ends before this".to_owned(),
            "a line has one key and one value; a list stands in brackets, such as [1, 2], and decimals have a point"
                .to_owned(),
        ),
        _ if what == "invalid basic string" && expected == "`\"`" => {
            ("a text without its closing quote".to_owned(), "a text ends in its line, with \"".to_owned())
        }
        (_, "" | "nothing") => (what.to_owned(), "this is not TOML".to_owned()),
        (_, expected) => (what.to_owned(), format!("expected {expected}")),
    };
    LayoutError::new(what, right, error.span())
}

/// One slip of the hand for so many letters of a key is one: a letter too many, too few, another, or two exchanged.
const LETTERS_A_SLIP: usize = 3;

/// What may be meant by an unknown key: one that is nearly it, one of the file as a whole or of the tables that have it, or any of those that are expected.
fn what_is_known(unknown: &str, expected: &str) -> String {
    let keys: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    let near = keys.iter().map(|key| (strsim::osa_distance(unknown, key), key));
    let near = near.filter(|(slips, key)| slips * LETTERS_A_SLIP <= key.len()).min_by_key(|(slips, _)| *slips);
    let has = |is_meant: &dyn Fn(&str, &[&str]) -> bool| tables().any(|(table, own)| is_meant(table, &own));
    let is_of_a_layout = has(&|_, own| own == keys);
    let is_of_the_file = is_of_a_layout && has(&|table, own| table.is_empty() && own.contains(&unknown));
    let is_above_the_tables = has(&|table, own| table.is_empty() && own == keys);
    let owners: Vec<&str> =
        tables().filter(|(_, own)| is_of_a_layout && own.contains(&unknown)).map(|(table, _)| table).collect();
    match near {
        Some((_, key)) => format!("did you mean `{key}`?"),
        None if is_of_the_file => format!("`{unknown}` belongs above the first table"),
        // In a table, what it expects tells more than a list of other tables.
        None if owners.len() == 1 || is_above_the_tables && !owners.is_empty() => {
            format!("`{unknown}` is a key of `{}`", owners.join("`, `"))
        }
        None => format!("expected {expected}"),
    }
}

/// The name of a kind of value, as a person says it. A number has become text by now: it shows without quotes.
fn value(kind: &str) -> String {
    match kind.strip_prefix("string ") {
        Some(text) => format!("`{}`", text.trim_matches('"')),
        None if kind.ends_with("map") => "a table".to_owned(),
        None if kind.ends_with("sequence") => "a list in brackets".to_owned(),
        None => kind.replace("boolean ", ""),
    }
}

/// The place of a value in the file.
pub fn place<T>(value: &Spanned<T>) -> Option<Range<usize>> {
    Some(value.span())
}
