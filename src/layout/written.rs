//! How is a layout file read without losing a digit? Numbers stay the text that was written.

use std::ops::Range;

use serde::Deserialize;
use serde::de::{DeserializeOwned, Deserializer, Error, Visitor};
use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::LayoutError;

/// A number or a text, as written.
#[derive(Clone, Debug)]
pub(super) struct Written(pub String);

/// A number or a text with its place in the file.
pub(super) type Text = Spanned<Written>;

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

/// Reads TOML into `T`, whose numbers are [`Written`]: a decimal never passes through a float.
pub(super) fn read<T: DeserializeOwned>(source: &str) -> Result<T, LayoutError> {
    let mut table = DeTable::parse(source).map_err(toml_error)?;
    let pairs = table.get_mut().iter_mut();
    for (_, value) in pairs {
        numbers_as_text(value.get_mut());
    }
    T::deserialize(toml::Deserializer::from(table)).map_err(toml_error)
}

fn numbers_as_text(value: &mut DeValue<'_>) {
    let text = match value {
        DeValue::Integer(integer) => integer.to_string(),
        DeValue::Float(float) => float.as_str().to_owned(),
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

fn toml_error(error: toml::de::Error) -> LayoutError {
    let message = error.message().replace("a sequence", "a list in brackets");
    let (what, right) = message.split_once(", expected ").unwrap_or((&message, ""));
    let right = match (right, what.strip_prefix("missing field ")) {
        (_, Some(field)) => format!("this table needs a key {field}"),
        ("", None) => "this is not TOML as it is read here".to_owned(),
        (right, None) => format!("expected {right}"),
    };
    LayoutError::new(what.lines().collect::<Vec<_>>().join("; "), right, error.span())
}

/// The place of a value in the file.
pub(super) fn place<T>(value: &Spanned<T>) -> Option<Range<usize>> {
    Some(value.span())
}
