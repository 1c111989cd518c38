//! How do values of Python become a layout file? As the text that a person would write: nothing else is read as an engine.

use std::fmt::Write;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyMapping, PyString};

use super::error::told;

/// Lists with one value for each cylinder: the names in Python, the key of `[[cylinder]]`.
pub(super) const COLUMNS: [(&str, &str); 5] = [
    ("names", "name"),
    ("throws", "throw"),
    ("banks", "bank"),
    ("positions", "position"),
    ("masses", "reciprocating_mass"),
];

/// A layout file with these keys: those with a value stand before the tables. What is `None` is omitted.
pub(super) fn layout(keys: &Bound<'_, PyDict>) -> PyResult<String> {
    let (mut above, mut tables) = (String::new(), String::new());
    for (key, value) in keys {
        let name = key_name(&key)?;
        if value.is_none() {
            continue;
        }
        if let Ok(table) = value.cast::<PyMapping>() {
            tables += &section(&format!("[{name}]"), table)?;
        } else if let Some(list) = list_of_tables(&value)? {
            for table in list {
                tables += &section(&format!("[[{name}]]"), &table)?;
            }
        } else {
            above += &line(&name, &value)?;
        }
    }
    Ok(above + &tables)
}

/// `[[cylinder]]` tables of lists with one value for each cylinder; an in-line engine where there is nothing but throws and names.
pub(super) fn cylinders(columns: [Option<Bound<'_, PyAny>>; 5]) -> PyResult<String> {
    let [names, throws, banks, positions, masses] = &columns;
    if let (Some(throws), None, None, None) = (throws, banks, positions, masses) {
        let names = names.as_ref().map(|names| line("numbering", names)).transpose()?.unwrap_or_default();
        return Ok(format!("\n[inline]\n{}{names}", line("throws", throws)?));
    }
    let mut given = Vec::new();
    for ((plural, key), column) in COLUMNS.iter().zip(&columns) {
        if let Some(column) = column {
            given.push((*plural, *key, items(column).ok_or_else(|| not_a_list(plural))?));
        }
    }
    let Some((first, _, values)) = given.first() else { return Ok(String::new()) };
    if let Some((other, _, more)) = given.iter().find(|(_, _, more)| more.len() != values.len()) {
        let counts = format!("{} {first} and {} {other}", values.len(), more.len());
        return Err(told(format!("{counts}; each list has one value for each cylinder")));
    }
    if positions.is_none() {
        let right = "give `positions`, one for each cylinder, growing towards the free end of the crankshaft";
        return Err(told(format!("cylinders without positions; {right}")));
    }
    let mut text = String::new();
    for cylinder in 0..values.len() {
        text += "\n[[cylinder]]\n";
        for (_, key, values) in &given {
            text += &line(key, &values[cylinder])?;
        }
        if banks.is_none() {
            text += "bank = 0\n";
        }
    }
    Ok(text)
}

fn not_a_list(name: &str) -> PyErr {
    PyTypeError::new_err(format!("`{name}` is a list with one value for each cylinder"))
}

/// A table below its name.
fn section(heading: &str, table: &Bound<'_, PyMapping>) -> PyResult<String> {
    let mut text = format!("\n{heading}\n");
    for (key, value) in pairs(table)? {
        if !value.is_none() {
            text += &line(&key_name(&key)?, &value)?;
        }
    }
    Ok(text)
}

fn line(name: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
    Ok(format!("{name} = {}\n", written(value)?))
}

fn pairs<'py>(table: &Bound<'py, PyMapping>) -> PyResult<Vec<(Bound<'py, PyAny>, Bound<'py, PyAny>)>> {
    table.items()?.iter().map(|pair| pair.extract()).collect()
}

/// A key as TOML has it.
fn key_name(key: &Bound<'_, PyAny>) -> PyResult<String> {
    let Ok(text) = key.cast::<PyString>() else {
        return Err(PyTypeError::new_err(format!("a key of a layout is a str, not {}", key.get_type().name()?)));
    };
    let text = text.to_str()?.to_owned();
    let is_bare = |letter: u8| letter.is_ascii_alphanumeric() || b"_-".contains(&letter);
    Ok(if !text.is_empty() && text.bytes().all(is_bare) { text } else { quoted(&text) })
}

/// A value as TOML has it. Numbers are taken exactly as they are written: a float as Python shows it.
fn written(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_instance_of::<PyBool>() {
        return Ok(if value.extract()? { "true".to_owned() } else { "false".to_owned() });
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(quoted(text.to_str()?));
    }
    if value.is_instance_of::<PyInt>() {
        // TOML's whole numbers end at 64 bits; a layout takes longer ones as texts.
        let digits = value.py().get_type::<PyInt>().call_method1("__repr__", (value,))?.to_string();
        return Ok(if digits.parse::<i64>().is_ok() { digits } else { quoted(&digits) });
    }
    if value.is_instance_of::<PyFloat>() {
        return Ok(value.py().get_type::<PyFloat>().call_method1("__repr__", (value,))?.to_string());
    }
    if let Ok(table) = value.cast::<PyMapping>() {
        let pairs = pairs(table)?.into_iter().filter(|(_, value)| !value.is_none());
        let pairs = pairs.map(|(key, value)| Ok(format!("{} = {}", key_name(&key)?, written(&value)?)));
        return Ok(format!("{{ {} }}", pairs.collect::<PyResult<Vec<_>>>()?.join(", ")));
    }
    if value.hasattr("numerator")? && value.hasattr("denominator")? && !value.hasattr("item")? {
        return Ok(quoted(&format!("{}/{}", value.getattr("numerator")?, value.getattr("denominator")?)));
    }
    if value.hasattr("as_integer_ratio")? && value.hasattr("quantize")? {
        // A decimal of any length, exactly.
        return Ok(quoted(&value.str()?.to_string()));
    }
    // A number of NumPy.
    if value.hasattr("item")? && value.getattr("ndim").is_ok_and(|ndim| ndim.eq(0).unwrap_or(false)) {
        return written(&value.call_method0("item")?);
    }
    match items(value) {
        Some(items) => {
            let items: Vec<String> = items.iter().map(written).collect::<PyResult<_>>()?;
            Ok(format!("[{}]", items.join(", ")))
        }
        None => {
            let kind = value.get_type().name()?;
            let right = "a number, a str, a list, or a dict for a table";
            Err(PyTypeError::new_err(format!("a layout holds no {kind}; give {right}")))
        }
    }
}

/// A number as it is written: a str stands as it is, with its unit.
pub(super) fn number(value: &Bound<'_, PyAny>) -> PyResult<String> {
    match value.cast::<PyString>() {
        Ok(text) => Ok(text.to_str()?.to_owned()),
        Err(_) => Ok(written(value)?.trim_matches('"').to_owned()),
    }
}

/// One value, or a list of them, as they are written.
pub(super) fn numbers(value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    match items(value).filter(|_| !value.hasattr("item").unwrap_or(false) || value.len().is_ok()) {
        Some(items) => items.iter().map(number).collect(),
        None => Ok(vec![number(value)?]),
    }
}

/// The range of a sweep: "0..180:10", or from, to and step.
pub(super) fn range(name: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
    match (value.is_instance_of::<PyString>(), numbers(value)?.as_slice()) {
        (true, [text]) => Ok(text.clone()),
        (false, [from, to, step]) => Ok(format!("{from}..{to}:{step}")),
        _ => Err(told(format!("the range of `{name}`; write \"0..180:10\", or (0, 180, 10): from, to, step"))),
    }
}

/// The values of a list, a tuple, a range or an array; none of anything else.
fn items<'py>(value: &Bound<'py, PyAny>) -> Option<Vec<Bound<'py, PyAny>>> {
    if value.is_instance_of::<PyString>() || value.cast::<PyMapping>().is_ok() {
        return None;
    }
    value.try_iter().ok()?.collect::<PyResult<Vec<_>>>().ok()
}

/// The tables of a list that holds nothing else; none of other lists.
fn list_of_tables<'py>(value: &Bound<'py, PyAny>) -> PyResult<Option<Vec<Bound<'py, PyMapping>>>> {
    let Some(items) = items(value) else { return Ok(None) };
    let tables: Vec<Bound<'py, PyMapping>> =
        items.iter().filter_map(|item| item.cast::<PyMapping>().ok().cloned()).collect();
    Ok((!items.is_empty() && tables.len() == items.len()).then_some(tables))
}

/// A text in quotes, with nothing in it that TOML would obey.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => out.extend(['\\', letter]),
            // Writing to a string cannot fail.
            letter if letter.is_control() => drop(write!(out, "\\u{:04X}", u32::from(letter))),
            letter => out.push(letter),
        }
    }
    out + "\""
}
