//! How does an editor know the keys of a layout file? By a JSON Schema, made of the list of tables and keys, `keys.txt`.
//!
//! A table begins with `[its name] a sentence`; the top of the file has no name. Each key is a line, `name: kind = a sentence`, with `!` after the
//! name of a key that is needed. `as table.key` stands for a key of another table, `as table` for all keys of one. The readers of the tables are the
//! structures beside this folder; `tests/suite/schemas.rs` asks them for their keys and holds the list to them.

mod kind;

use std::sync::LazyLock;

use serde_json::{Map, Value, json};

/// The forms of engine: a file has one of them.
pub(super) const FORMS: [&str; 14] = [
    "cylinder",
    "inline",
    "vee",
    "flat",
    "boxer",
    "fan",
    "vr",
    "w",
    "radial",
    "opposed_piston",
    "u",
    "square_four",
    "h",
    "delta",
];

const KEYS: &str = include_str!("keys.txt");

/// A table of the file: its name, which is in its brackets there, a sentence, and its keys.
struct Table {
    name: &'static str,
    about: &'static str,
    keys: Vec<Key>,
}

/// A key of a table.
#[derive(Clone, Copy)]
struct Key {
    name: &'static str,
    is_needed: bool,
    kind: &'static str,
    about: &'static str,
}

impl Key {
    fn read(line: &'static str) -> Option<Key> {
        let (name, rest) = line.split_once(": ")?;
        let (kind, about) = rest.split_once(" = ")?;
        Some(Key { name: name.trim_end_matches('!'), is_needed: name.ends_with('!'), kind, about })
    }

    /// What an editor shows of it: the sentence, and then the unit, which the kind knows.
    fn schema(&self) -> Value {
        let mut schema = kind::schema(self.kind);
        if let Value::Object(schema) = &mut schema {
            let unit = schema.remove("description");
            let unit = unit.as_ref().and_then(Value::as_str).map(|unit| format!(" In {unit}."));
            schema.insert("description".to_owned(), json!(format!("{}{}", self.about, unit.unwrap_or_default())));
        }
        schema
    }
}

/// Every table; the first is the top of the file.
static TABLES: LazyLock<Vec<Table>> = LazyLock::new(read);

fn read() -> Vec<Table> {
    let mut tables: Vec<Table> = Vec::new();
    for line in KEYS.lines() {
        if let Some((name, about)) = line.strip_prefix('[').and_then(|rest| rest.split_once("] ")) {
            tables.push(Table { name, about, keys: Vec::new() });
            continue;
        }
        let keys = match line.strip_prefix("as ") {
            Some(other) => keys_of(&tables, other),
            None => Key::read(line).into_iter().collect(),
        };
        tables.last_mut().into_iter().for_each(|table| table.keys.extend(&keys));
    }
    tables
}

/// The keys of a table above, or the one that is named behind a point.
fn keys_of(tables: &[Table], named: &str) -> Vec<Key> {
    let (table, wanted) = named.split_once('.').map_or((named, None), |(table, key)| (table, Some(key)));
    let of = tables.iter().filter(|known| known.name == table).flat_map(|table| &table.keys);
    of.filter(|key| wanted.is_none_or(|wanted| wanted == key.name)).copied().collect()
}

/// What the number behind this key of a layout file is: `speed`, `angle`; none of a table whose keys are not listed.
pub fn number_kind(path: &str) -> Option<&'static str> {
    let names: Vec<&str> = path.split('.').filter(|part| part.parse::<usize>().is_err()).collect();
    let (name, table) = names.split_last()?;
    if let (["values"], "phi" | "delta") = (table, *name) {
        return Some("angle");
    }
    // One of several crankshafts has keys of its own.
    let is_geared = path.split('.').nth(1).is_some_and(|part| part.parse::<usize>().is_ok());
    let table = if table == ["crankshaft"] && is_geared { "crankshaft.geared".to_owned() } else { table.join(".") };
    let of = TABLES.iter().find(|known| known.name == table)?;
    let kind = of.keys.iter().find(|known| known.name == *name)?.kind;
    // One value for all, or a list of such.
    Some(kind.split(" | ").next()?.trim_matches(['[', ']']))
}

/// The JSON Schema (draft 2020-12) of layout files, whose tables editors take for objects. It refuses nothing that is read.
#[must_use]
pub fn schema() -> Value {
    let tables = &*TABLES;
    let definitions = tables.iter().skip(1).map(|table| (table.name.to_owned(), object(table)));
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!("crankstar layout file"));
    if let Some(Value::Object(top)) = tables.first().map(object) {
        schema.extend(top);
    }
    let one_form: Vec<Value> = FORMS.iter().map(|form| json!({ "required": [form] })).collect();
    schema.insert("oneOf".to_owned(), Value::Array(one_form));
    schema.insert("$defs".to_owned(), Value::Object(definitions.collect()));
    Value::Object(schema)
}

/// The tables by their names in the file (that of its top is empty, `crankshaft.geared` is that of one of several), and the keys of each.
pub fn tables() -> impl Iterator<Item = (&'static str, Vec<&'static str>)> {
    TABLES.iter().map(|table| (table.name, table.keys.iter().map(|key| key.name).collect()))
}

fn object(table: &Table) -> Value {
    let properties: Map<String, Value> = table.keys.iter().map(|key| (key.name.to_owned(), key.schema())).collect();
    let required: Vec<&str> = table.keys.iter().filter(|key| key.is_needed).map(|key| key.name).collect();
    json!({
        "description": table.about,
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}
