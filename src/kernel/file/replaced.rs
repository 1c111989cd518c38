//! How does a layout file read with one value changed, and all else as its author wrote it?

use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::LayoutError;
use super::written;

/// A place in a text and what is there from now on.
type Change = (std::ops::Range<usize>, String);

/// The text of a layout file in which a key of a table, such as `vee.bank_angle`, has this value, as a file has it.
///
/// Comments and order stay. A key that the file lacks is added to its table, and the table too; one of `instead_of`, other keys of
/// the table that say the same in another way, gives way to it.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::file::with_value;
/// let text = "[vee]  # of 60°\nbank_angle = 60 # here\nthrows = [0]\n";
/// assert_eq!(with_value("v", text, "vee.bank_angle", "90", &[]).unwrap(), text.replace("= 60", "= 90"));
/// let split = with_value("v", text, "vee.pin_split", "-30", &[]).unwrap();
/// assert_eq!(split, "[vee]  # of 60°\npin_split = -30\nbank_angle = 60 # here\nthrows = [0]\n");
/// ```
///
/// # Errors
/// The text or the value is not TOML, or the key leads to no place that could be found.
pub fn with_value(
    name: &str,
    source: &str,
    key: &str,
    value: &str,
    instead_of: &[&str],
) -> Result<String, LayoutError> {
    let found = written::table(source).and_then(|table| {
        let (at, written) = change(table.get_ref(), source, key, value, instead_of).ok_or_else(|| misplaced(key))?;
        let text = format!("{}{written}{}", &source[..at.start], &source[at.end..]);
        let stands = written::table(&text).is_ok_and(|table| stands(table.get_ref(), key));
        if stands { Ok(text) } else { Err(misplaced(key)) }
    });
    found.map_err(|error| error.in_file(name, source))
}

fn misplaced(key: &str) -> LayoutError {
    let right = format!("write `{key}` into the file by hand; then it is changed in place");
    LayoutError::new(format!("no place for `{key}` was found in the file"), right, None)
}

/// Whether a key stands in a file.
pub(super) fn stands(all: &DeTable, key: &str) -> bool {
    let (table, name) = parts(key);
    match table {
        None => all.contains_key(name),
        Some(table) => {
            all.get(table).and_then(|keys| keys.get_ref().as_table()).is_some_and(|it| it.contains_key(name))
        }
    }
}

/// The table of a key, and its name there.
fn parts(key: &str) -> (Option<&str>, &str) {
    key.rsplit_once('.').map_or((None, key), |(table, name)| (Some(table), name))
}

fn change(all: &DeTable, source: &str, key: &str, value: &str, instead_of: &[&str]) -> Option<Change> {
    let (table, name) = parts(key);
    let Some(table) = table else {
        return match all.get(name) {
            Some(there) => Some((there.span(), value.to_owned())),
            // Above the first table.
            None => Some((0..0, format!("{name} = {value}\n"))),
        };
    };
    let Some(keys) = all.get(table) else {
        let apart = if source.is_empty() || source.ends_with('\n') { "" } else { "\n" };
        return Some((source.len()..source.len(), format!("{apart}\n[{table}]\n{name} = {value}\n")));
    };
    let inside = keys.get_ref().as_table()?;
    if let Some(there) = inside.get(name) {
        return Some((there.span(), value.to_owned()));
    }
    let same = inside.iter().find(|(other, _)| instead_of.contains(&other.get_ref().as_ref()));
    if let Some((other, there)) = same {
        return Some((other.span().start..there.span().end, format!("{name} = {value}")));
    }
    added(keys, inside, source, table, name, value)
}

/// A new key of a table that is there: below its heading, in its braces, or above the first of its dotted keys.
fn added(
    keys: &Spanned<DeValue>,
    inside: &DeTable,
    source: &str,
    table: &str,
    name: &str,
    value: &str,
) -> Option<Change> {
    let mut begin = 0;
    for line in source.split_inclusive('\n') {
        let end = begin + line.len();
        let bare = line.split('#').next().unwrap_or(line).trim();
        let heading = bare.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
        if heading.is_some_and(|heading| heading.trim() == table) {
            let apart = if line.ends_with('\n') { "" } else { "\n" };
            return Some((end..end, format!("{apart}{name} = {value}\n")));
        }
        begin = end;
    }
    let span = keys.span();
    if source.get(span.clone()).is_some_and(|text| text.starts_with('{')) {
        let comma = if inside.is_empty() { " " } else { "," };
        return Some((span.start + 1..span.start + 1, format!(" {name} = {value}{comma}")));
    }
    let first = inside.keys().map(|key| key.span().start).min()?;
    let line = source.get(..first)?.rfind('\n').map_or(0, |at| at + 1);
    Some((line..line, format!("{table}.{name} = {value}\n")))
}
