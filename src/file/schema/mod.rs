//! How does an editor know the keys of a layout file? By a JSON Schema, made of the list of tables and keys.

mod kind;
mod tables;

use serde_json::{Map, Value, json};

pub(super) use tables::FORMS;
use tables::{Key, Keys, TABLES};

/// The JSON Schema (draft 2020-12) of layout files, whose tables editors take for objects. It refuses nothing that is read.
#[must_use]
pub fn schema() -> Value {
    let definitions = TABLES.iter().skip(1).map(|table| (table.name.to_owned(), object(table)));
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!("crankstar layout file"));
    if let Some(Value::Object(top)) = TABLES.first().map(object) {
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

fn object(table: &Keys) -> Value {
    let property = |key: &Key| {
        let mut schema = key.kind.schema();
        if let Value::Object(schema) = &mut schema {
            // The sentence about the key, and then the unit, which the kind knows.
            let unit = schema.remove("description");
            let unit = unit.as_ref().and_then(Value::as_str).map(|unit| format!(" In {unit}."));
            schema.insert("description".to_owned(), json!(format!("{}{}", key.about, unit.unwrap_or_default())));
        }
        (key.name.to_owned(), schema)
    };
    let properties: Map<String, Value> = table.keys.iter().map(property).collect();
    let required: Vec<&str> = table.keys.iter().filter(|key| key.is_needed).map(|key| key.name).collect();
    json!({
        "description": table.about,
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}
