//! What may be behind a key, and how does JSON Schema say it?
//!
//! `'a word' | text | angle | … | 1..1000 | table name | [of each]`. A schema refuses nothing that is read: numbers may be texts, with a unit or an
//! unknown in them, which no pattern says better than the reader.

use serde_json::{Value, json};

/// The schema of what is written behind a key; other tables are referred to.
pub(super) fn schema(kind: &str) -> Value {
    let (words, others): (Vec<&str>, Vec<&str>) = alternatives(kind).into_iter().partition(|one| one.starts_with('\''));
    let words: Vec<&str> = words.into_iter().map(|word| word.trim_matches('\'')).collect();
    let words = (!words.is_empty()).then(|| json!({ "enum": words }));
    let mut all: Vec<Value> = words.into_iter().chain(others.into_iter().map(one)).collect();
    match all.len() {
        1 => all.remove(0),
        _ => json!({ "anyOf": all }),
    }
}

/// What stands between strokes, outside brackets.
fn alternatives(kind: &str) -> Vec<&str> {
    let mut depth = 0_i32;
    let at_strokes = kind.split(|letter| {
        depth += i32::from(letter == '[') - i32::from(letter == ']');
        letter == '|' && depth == 0
    });
    at_strokes.map(str::trim).collect()
}

fn one(kind: &str) -> Value {
    if let Some(of) = kind.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        return json!({ "type": "array", "items": schema(of) });
    }
    if let Some(name) = kind.strip_prefix("table ") {
        return json!({ "$ref": format!("#/$defs/{name}") });
    }
    if let Some((from, to)) = kind.split_once("..") {
        let [from, to] = [from, to].map(|end| end.parse::<u32>().ok());
        return json!({
            "anyOf": [{ "type": "integer", "minimum": from, "maximum": to }, { "type": "string", "pattern": "^\\s*\\+?[0-9]" }]
        });
    }
    named(kind)
}

fn named(kind: &str) -> Value {
    let number = |unit: &str| json!({ "type": ["number", "string"], "description": unit });
    match kind {
        "text" => json!({ "type": ["string", "number"] }),
        "string" => json!({ "type": "string" }),
        "truth" => json!({ "type": "boolean" }),
        "angle" => number("degrees; with a unit as a text: \"1/12 turn\", \"2/3 pi rad\""),
        "length" => number("metres; with a unit as a text: \"90 mm\", \"3.5 in\""),
        "mass" => number("kilograms; with a unit as a text: \"650 g\", \"1.4 lb\""),
        "mass-radius" => number("kilogram metres; with a unit as a text: \"18.6 kg mm\", \"1/4 m r\""),
        "speed" => number("revolutions a minute; with a unit as a text: \"100 Hz\""),
        "pressure" => number("with its unit, as a text: \"0.9 bar\""),
        "inertia" => number("kg m²; with a unit as a text: \"300 kg cm^2\""),
        "stiffness" => number("N m/rad; with a unit as a text: \"1 MN m/rad\""),
        "spring" => number("N/m; with a unit as a text: \"220 kN/m\", \"220 N/mm\""),
        "damping" => number("N s/m; with a unit as a text: \"0.35 N s/mm\""),
        "torsional-damping" => number("N m s/rad; with a unit as a text: \"60 kN m s/rad\""),
        "torque" => number("N m; with a unit as a text: \"63.6 kN m\""),
        "stress" => number("Pa; with a unit as a text: \"80 GPa\", \"560 MPa\""),
        "heat" => number("with its unit, as a text"),
        "number" => number("a number, or a fraction as a text: \"1/4\""),
        "rows of two" => json!({
            "type": "array",
            "items": { "type": "array", "items": { "type": ["number", "string"] }, "minItems": 2, "maxItems": 2 },
        }),
        "values by names" => json!({ "type": "object", "additionalProperties": { "type": ["number", "string"] } }),
        _ => unreachable!("keys.txt: `{kind}` is not a kind"),
    }
}
