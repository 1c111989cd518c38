//! Of which form is a document? As JSON Schemas, for editors and for programs that read documents.
//!
//! `documents.txt` has the formats; the checkers (`src/kernel/proof`) and the tables of data have the last word, and tests hold the schemas to both.

mod grammar;

use serde_json::{Map, Value, json};

use super::data::TABLES;
use crate::file;

/// What there is a schema of: `layout`, the layout file, and the documents of `--json` by their names.
pub fn schema_names() -> Vec<&'static str> {
    let written: Vec<&str> =
        grammar::lines().map(|(name, _)| name).take_while(|name| name.starts_with(char::is_lowercase)).collect();
    let mut names: Vec<&str> = std::iter::once("layout").chain(written.iter().copied()).collect();
    names.extend(TABLES.iter().map(|(question, _)| *question).filter(|question| !written.contains(question)));
    names
}

/// The schema of this name (JSON Schema, draft 2020-12); none where there is no such name.
pub fn schema(name: &str) -> Option<Value> {
    match name {
        "layout" => Some(file::schema()),
        name => schema_names().contains(&name).then(|| of_document(name)),
    }
}

fn of_document(name: &str) -> Value {
    let document = grammar::definition(name);
    let mut definitions = Map::new();
    let mut wanted: Vec<String> = names(&document);
    while let Some(name) = wanted.pop() {
        if !definitions.contains_key(&name) {
            let definition = grammar::definition(&name);
            wanted.extend(names(&definition));
            definitions.insert(name, definition);
        }
    }
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!(format!("crankstar {name}")));
    if let Value::Object(document) = document {
        schema.extend(document);
    }
    schema.insert("$defs".to_owned(), Value::Object(definitions));
    Value::Object(schema)
}

fn names(schema: &Value) -> Vec<String> {
    grammar::names_in(schema).into_iter().map(str::to_owned).collect()
}
