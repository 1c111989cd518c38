//! How are the formats of documents written down? `documents.txt` has a line for each, in types of JSON:
//!
//! `name = 'a word' | text | exact | decimal | whole | truth | null | Name | [of each] | { of any key } | { key: needed, key?: not needed,
//! ...Name with its keys, @question with its tables }`

use serde_json::{Map, Value, json};

use crate::report::data;

const FORMATS: &str = include_str!("documents.txt");

/// The lines, each a name with its type.
pub(super) fn lines() -> impl Iterator<Item = (&'static str, &'static str)> {
    FORMATS.lines().filter_map(|line| line.split_once(" = "))
}

/// The schema of a line; of a question without a line, whose document is its tables.
pub(super) fn definition(name: &str) -> Value {
    match lines().find(|(known, _)| *known == name) {
        Some((_, text)) => Reader { rest: text }.one_of(),
        None => Reader { rest: &format!("{{ format: 'crankstar {name} 2', title?: text, @{name} }}") }.one_of(),
    }
}

/// The names that a schema refers to.
pub(super) fn names_in(schema: &Value) -> Vec<&str> {
    match schema {
        Value::Object(map) => {
            let own = map.get("$ref").and_then(Value::as_str).and_then(|to| to.strip_prefix("#/$defs/"));
            own.into_iter().chain(map.values().flat_map(names_in)).collect()
        }
        Value::Array(list) => list.iter().flat_map(names_in).collect(),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => Vec::new(),
    }
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    /// Types with strokes between them.
    fn one_of(&mut self) -> Value {
        let mut words = Vec::new();
        let mut others = Vec::new();
        loop {
            if self.takes("'") {
                words.push(json!(self.until('\'')))
            } else {
                others.push(self.one())
            }
            if !self.takes("|") {
                break;
            }
        }
        if !words.is_empty() {
            others.insert(0, json!({ "enum": words }));
        }
        match others.len() {
            1 => others.remove(0),
            _ => json!({ "anyOf": others }),
        }
    }

    fn one(&mut self) -> Value {
        if self.takes("[") {
            let items = self.one_of();
            self.wants("]");
            return json!({ "type": "array", "items": items });
        }
        if self.takes("{") {
            return self.object();
        }
        match self.name() {
            "text" => json!({ "type": "string" }),
            // In lowest terms, as it is printed.
            "exact" => json!({ "type": "string", "pattern": "^-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?$" }),
            "decimal" => json!({ "type": "number" }),
            "whole" => json!({ "type": "integer", "minimum": 0 }),
            "truth" => json!({ "type": "boolean" }),
            "null" => json!({ "type": "null" }),
            name => json!({ "$ref": format!("#/$defs/{name}") }),
        }
    }

    fn object(&mut self) -> Value {
        let mut properties = Map::new();
        let mut required = Vec::new();
        while !self.takes("}") {
            if self.takes("...") {
                let Value::Object(mut other) = definition(self.name()) else { unreachable!("a schema is an object") };
                if let Some(Value::Object(keys)) = other.remove("properties") {
                    properties.extend(keys);
                }
                if let Some(Value::Array(keys)) = other.remove("required") {
                    required.extend(keys);
                }
            } else if self.takes("@") {
                let tables = data::tables_of(self.name()).iter();
                properties.extend(tables.map(|table| ((*table).to_owned(), table_of_data())));
            } else {
                let key = self.name();
                let is_needed = !self.takes("?");
                if !self.takes(":") {
                    // No key, but the type of what any key has.
                    let any = Reader { rest: key }.one();
                    self.wants("}");
                    return json!({ "type": "object", "additionalProperties": any });
                }
                properties.insert(key.to_owned(), self.one_of());
                if is_needed {
                    required.push(json!(key));
                }
            }
            self.takes(",");
        }
        json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
    }

    fn name(&mut self) -> &'a str {
        self.rest = self.rest.trim_start();
        let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
        let end = self.rest.find(|letter| !is_part(letter)).unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(end);
        assert!(!name.is_empty(), "documents.txt: a name is missing before `{rest}`");
        self.rest = rest;
        name
    }

    fn until(&mut self, end: char) -> &'a str {
        let (text, rest) = self.rest.split_once(end).unwrap_or((self.rest, ""));
        self.rest = rest;
        text
    }

    fn takes(&mut self, sign: &str) -> bool {
        let rest = self.rest.trim_start();
        match rest.strip_prefix(sign) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn wants(&mut self, sign: &str) {
        assert!(self.takes(sign), "documents.txt: {sign} is missing before `{}`", self.rest);
    }
}

/// A table: an object of its one row, or its rows; `docs/data.md` has the columns.
fn table_of_data() -> Value {
    let row = json!({ "type": "object", "additionalProperties": { "type": ["string", "number", "boolean", "null"] } });
    json!({ "anyOf": [row, { "type": "array", "items": row }] })
}
