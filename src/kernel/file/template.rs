//! Which engines does a layout file describe when some of its values are replaced? Parsed once, read for each.

use std::borrow::Cow;
use std::fmt;

use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::LayoutError;
use super::file_resolver::FileResolver;
use super::layout::{Layout, read_layout};
use super::replaced::stands;
use super::schema::FORMS;
use super::written;
use crate::engine::Cycle;

/// Longer paths than this are no keys of a layout file.
const DEEPEST: usize = 4;

/// The path of a value in a layout file: `vee.bank_angle`, `vee.throws.2` (the second of a list), `cylinder.3.throw`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key(Vec<String>);

impl Key {
    /// Reads a path.
    ///
    /// # Errors
    /// What a path looks like.
    pub fn parse(text: &str) -> Result<Self, String> {
        let parts: Vec<String> = text.split('.').map(|part| part.trim().to_owned()).collect();
        let named =
            |part: &String| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        let is_place = |part: &String| part.parse::<usize>().is_ok();
        match parts.len() <= DEEPEST && parts.iter().all(named) && !parts.first().is_some_and(is_place) {
            true => Ok(Key(parts)),
            false => Err(format!("cannot read the key `{text}`; such as vee.bank_angle, speed or vee.throws.2")),
        }
    }

    /// The last name of the path, without its place in a list.
    pub fn name(&self) -> &str {
        let names = self.0.iter().rev().filter(|part| part.parse::<usize>().is_err());
        names.map(String::as_str).next().unwrap_or_default()
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join("."))
    }
}

/// A layout file that is parsed, but not yet read as an engine.
#[derive(Clone, Debug)]
pub struct Template<'a> {
    name: &'a str,
    source: &'a str,
    beside: FileResolver<'a>,
    table: Spanned<DeTable<'a>>,
}

impl<'a> Template<'a> {
    /// Parses a layout file. `name` is the path that messages show.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::file::{Layout, Key, Template};
    /// let vee = Template::new("v.toml", "[vee]\nbank_angle = 60\nthrows = [0]").unwrap();
    /// let key = Key::parse("vee.bank_angle").unwrap();
    /// let Ok(Layout::Known(engine, _)) = vee.layout(&[(&key, "90")]) else { panic!() };
    /// assert_eq!(engine.cylinders()[1].bank.degrees().to_string(), "45");
    /// ```
    ///
    /// # Errors
    /// The text is not TOML.
    pub fn new(name: &'a str, source: &'a str) -> Result<Self, LayoutError> {
        let table = written::table(source).map_err(|error| error.in_file(name, source))?;
        Ok(Template { name, source, beside: FileResolver::nothing(), table })
    }

    /// The same file with what lies beside it.
    pub fn with_beside(self, beside: FileResolver<'a>) -> Self {
        Template { beside, ..self }
    }

    /// The form of engine that the file describes: `vee`, `inline`, …; none where it names none.
    pub fn form(&self) -> Option<&'static str> {
        FORMS.into_iter().find(|form| self.table.get_ref().contains_key(*form))
    }

    /// Two-stroke or four-stroke, where the file says so.
    pub fn cycle(&self) -> Option<Cycle> {
        Cycle::of(self.table.get_ref().get("cycle")?.get_ref().as_str()?)
    }

    /// Whether the file holds a key, of the form `speed` or `vee.throws`.
    pub fn has(&self, key: &str) -> bool {
        stands(self.table.get_ref(), key)
    }

    /// What the file holds at a key of the form `vee.bank_angle`, as written, where that is a number or a text.
    pub fn value(&self, key: &str) -> Option<String> {
        let (table, name) = key.split_once('.')?;
        let keys = self.table.get_ref().get(table)?.get_ref().as_table()?;
        keys.get(name)?.get_ref().as_str().map(str::to_owned)
    }

    /// The same file without some keys, of the form `speed` or `mechanism.rod_length`.
    pub fn without(&self, keys: &[&str]) -> Self {
        let mut rest = self.clone();
        for key in keys {
            let all = rest.table.get_mut();
            match key.split_once('.') {
                None => drop(all.remove(*key)),
                Some((table, name)) => {
                    if let Some(DeValue::Table(keys)) = all.get_mut(table).map(Spanned::get_mut) {
                        keys.remove(name);
                    }
                }
            }
        }
        rest
    }

    /// The engine of the file with these values, written as in the file, in place of its own; a key that the file lacks
    /// is added.
    ///
    /// # Errors
    /// What [`super::parse_layout`] says of such a file, or where a key leads nowhere.
    pub fn layout(&self, values: &[(&Key, &str)]) -> Result<Layout, LayoutError> {
        let mut table = self.table.clone();
        for (key, value) in values {
            set(table.get_mut(), key, value).map_err(|error| error.in_file(self.name, self.source))?;
        }
        read_layout(self.name, self.source, table, self.beside)
    }
}

/// Puts a text in the place of a value.
fn set<'a>(table: &mut DeTable<'a>, key: &Key, text: &str) -> Result<(), LayoutError> {
    let Some((first, rest)) = key.0.split_first() else { return Ok(()) };
    let new = |rest: &[String]| match rest {
        [] => DeValue::String(Cow::Borrowed("")),
        _ => DeValue::Table(DeTable::new()),
    };
    let start: Spanned<Cow<'a, str>> = Spanned::new(0..0, Cow::Owned(first.clone()));
    let mut place = table.entry(start).or_insert_with(|| Spanned::new(0..0, new(rest)));
    for (at, part) in rest.iter().enumerate() {
        let span = place.span();
        let refuse = |message: String, right: &str| Err(LayoutError::new(message, right, Some(span.clone())));
        place = match place.get_mut() {
            DeValue::Table(_) if part.parse::<usize>().is_ok() => {
                let right = "write the list into the file, with a value in its place";
                return refuse(format!("`{key}` leads nowhere: the file has no such list"), right);
            }
            DeValue::Table(keys) => {
                let name: Spanned<Cow<'a, str>> = Spanned::new(0..0, Cow::Owned(part.clone()));
                keys.entry(name).or_insert_with(|| Spanned::new(0..0, new(&rest[at + 1..])))
            }
            DeValue::Array(list) => {
                let count = list.len();
                let index = part.parse::<usize>().ok().filter(|index| (1..=count).contains(index));
                let found = index.and_then(|index| list.get_mut(index - 1));
                let Some(found) = found else {
                    return refuse(
                        format!("`{key}` leads nowhere: there is no `{part}` in a list of {count}"),
                        "they are numbered from 1",
                    );
                };
                found
            }
            _ => {
                let right = "only a list or a table has parts; write the value as a list first";
                return refuse(format!("`{key}` leads nowhere: `{part}` is sought in a single value"), right);
            }
        };
    }
    if matches!(place.get_ref(), DeValue::Table(_)) {
        let message = format!("`{key}` is a table, not a value");
        return Err(LayoutError::new(message, "name one of its keys, such as vee.bank_angle", Some(place.span())));
    }
    *place.get_mut() = DeValue::String(Cow::Owned(text.to_owned()));
    Ok(())
}
