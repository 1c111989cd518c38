//! What may stand behind a key, and how does JSON Schema say it?
//!
//! A schema refuses nothing that is read: numbers may be texts, with a unit or an unknown in them, which no pattern says better than the reader.

use serde_json::{Value, json};

/// What stands behind a key.
pub(super) enum Kind {
    /// A person's text.
    Text,
    Angle,
    Length,
    Mass,
    MassRadius,
    Speed,
    Pressure,
    Inertia,
    Stiffness,
    /// A heat with its unit.
    Quantity,
    /// A number without a unit.
    Number,
    /// A whole number from here to there.
    Integer(u32, u32),
    /// `true` or `false`.
    Truth,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// One of these words, or a list.
    OneOfOrEach(&'static [&'static str], &'static Kind),
    /// A text, or a list.
    TextOrEach(&'static Kind),
    /// A list.
    Each(&'static Kind),
    /// One value for all, or a list.
    Column(&'static Kind),
    /// Rows of two values.
    Rows,
    /// Values of unknowns, by their names.
    Values,
    /// A table, by its name in the list of tables.
    Table(&'static str),
    /// A list of tables: `[[name]]`.
    Tables(&'static str),
    /// A list of tables of the first name, or one of the second.
    TableOrTables(&'static str, &'static str),
}

impl Kind {
    /// As a schema; other tables are referred to.
    pub fn schema(&self) -> Value {
        let table = |name: &str| json!({ "$ref": format!("#/$defs/{name}") });
        let list = |of: Value| json!({ "type": "array", "items": of });
        match self {
            Kind::Text => json!({ "type": ["string", "number"] }),
            Kind::Angle => number("degrees; with a unit as a text: \"1/12 turn\", \"2/3 pi rad\""),
            Kind::Length => number("metres; with a unit as a text: \"90 mm\", \"3.5 in\""),
            Kind::Mass => number("kilograms; with a unit as a text: \"650 g\", \"1.4 lb\""),
            Kind::MassRadius => number("kilogram metres; with a unit as a text: \"18.6 kg mm\", \"1/4 m r\""),
            Kind::Speed => number("revolutions a minute; with a unit as a text: \"100 Hz\""),
            Kind::Pressure => number("with its unit, as a text: \"0.9 bar\""),
            Kind::Inertia => number("kg m²; with a unit as a text: \"300 kg cm^2\""),
            Kind::Stiffness => number("N m/rad; with a unit as a text: \"1 MN m/rad\""),
            Kind::Quantity => number("with its unit, as a text"),
            Kind::Number => number("a number, or a fraction as a text: \"1/4\""),
            Kind::Integer(from, to) => json!({
                "anyOf": [{ "type": "integer", "minimum": from, "maximum": to }, { "type": "string", "pattern": "^\\s*\\+?[0-9]" }]
            }),
            Kind::Truth => json!({ "type": "boolean" }),
            Kind::OneOf(words) => json!({ "enum": words }),
            Kind::OneOfOrEach(words, of) => json!({ "anyOf": [{ "enum": words }, list(of.schema())] }),
            Kind::TextOrEach(of) => json!({ "anyOf": [{ "type": "string" }, list(of.schema())] }),
            Kind::Each(of) => list(of.schema()),
            Kind::Column(of) => json!({ "anyOf": [of.schema(), list(of.schema())] }),
            Kind::Rows => list(
                json!({ "type": "array", "items": { "type": ["number", "string"] }, "minItems": 2, "maxItems": 2 }),
            ),
            Kind::Values => json!({
                "type": "object",
                "additionalProperties": { "type": ["number", "string"] },
            }),
            Kind::Table(name) => table(name),
            Kind::Tables(name) => list(table(name)),
            Kind::TableOrTables(several, one) => json!({ "anyOf": [table(one), list(table(several))] }),
        }
    }
}

fn number(unit: &str) -> Value {
    json!({ "type": ["number", "string"], "description": unit })
}
