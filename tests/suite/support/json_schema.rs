//! What does a JSON Schema refuse? The words that the schemas of this program use; any other is a panic, so that none is passed over.

use serde_json::Value;

/// The place of the first value that the schema refuses, and by which word; none where it refuses nothing.
pub fn refused(schema: &Value, value: &Value) -> Option<String> {
    refused_by(schema, schema, value, "$")
}

fn refused_by(root: &Value, schema: &Value, value: &Value, at: &str) -> Option<String> {
    let words = schema.as_object().unwrap_or_else(|| panic!("{schema} is not a schema"));
    words.iter().find_map(|(word, said)| {
        let child = |schema: &Value, value: &Value, step: &str| refused_by(root, schema, value, &format!("{at}{step}"));
        let list = || said.as_array().expect("a list");
        let inner = match (word.as_str(), value) {
            ("$schema" | "title" | "description" | "$defs" | "properties", _) => {
                return inside(words, word, value, &child);
            }
            ("$ref", _) => {
                let name = said.as_str().and_then(|to| to.strip_prefix("#/$defs/")).expect("a reference");
                return refused_by(root, &root["$defs"][name], value, at);
            }
            ("type", _) => {
                said.as_array().map_or_else(|| is(value, said), |types| types.iter().any(|one| is(value, one)))
            }
            ("enum", _) => list().contains(value),
            ("anyOf", _) => list().iter().any(|schema| child(schema, value, "").is_none()),
            ("oneOf", _) => list().iter().filter(|schema| child(schema, value, "").is_none()).count() == 1,
            ("required", Value::Object(map)) => list().iter().all(|key| map.contains_key(key.as_str().expect("a key"))),
            ("additionalProperties", Value::Object(map)) => {
                let known = words.get("properties").and_then(Value::as_object);
                let mut others = map.iter().filter(|(key, _)| !known.is_some_and(|known| known.contains_key(*key)));
                match said {
                    Value::Bool(false) => others.next().is_none(),
                    said => return others.find_map(|(key, value)| child(said, value, &format!(".{key}"))),
                }
            }
            ("items", Value::Array(items)) => {
                return items.iter().enumerate().find_map(|(index, item)| child(said, item, &format!("[{index}]")));
            }
            ("minItems", Value::Array(items)) => items.len() as u64 >= said.as_u64().expect("a number"),
            ("maxItems", Value::Array(items)) => items.len() as u64 <= said.as_u64().expect("a number"),
            ("minimum", Value::Number(number)) => number.as_f64() >= said.as_f64(),
            ("maximum", Value::Number(number)) => number.as_f64() <= said.as_f64(),
            ("pattern", Value::String(text)) => fits(said.as_str().expect("a pattern"), text),
            (
                "required"
                | "additionalProperties"
                | "items"
                | "minItems"
                | "maxItems"
                | "minimum"
                | "maximum"
                | "pattern",
                _,
            ) => true,
            (word, _) => panic!("the schema says {word} at {at}"),
        };
        (!inner).then(|| format!("{at}: {word} {said}"))
    })
}

/// What `properties` refuses; the other words here say nothing.
fn inside(
    words: &serde_json::Map<String, Value>,
    word: &str,
    value: &Value,
    child: &dyn Fn(&Value, &Value, &str) -> Option<String>,
) -> Option<String> {
    let (Some(known), Some(map)) = (words.get(word).and_then(Value::as_object), value.as_object()) else { return None };
    match word {
        "properties" => known.iter().find_map(|(key, schema)| child(schema, map.get(key)?, &format!(".{key}"))),
        _ => None,
    }
}

fn is(value: &Value, kind: &Value) -> bool {
    match kind.as_str().expect("the name of a type") {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("no type is called {other}"),
    }
}

/// The two patterns that are in use, read by hand.
fn fits(pattern: &str, text: &str) -> bool {
    let is_number = |text: &str| {
        !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit()) && (text == "0" || !text.starts_with('0'))
    };
    match pattern {
        "^-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?$" => {
            let (above, below) = text.split_once('/').unwrap_or((text, "1"));
            is_number(above.strip_prefix('-').unwrap_or(above)) && is_number(below) && below != "0"
        }
        "^\\s*\\+?[0-9]" => {
            let text = text.trim_start();
            text.strip_prefix('+').unwrap_or(text).starts_with(|letter: char| letter.is_ascii_digit())
        }
        other => panic!("the pattern {other} is not known"),
    }
}
