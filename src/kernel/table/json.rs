//! How are tables written as JSON? A table of one row as an object, any other as an array of its rows.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::{Table, Value, Values};

impl Serialize for Value<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::Words(text) | Value::Exact(text) => serializer.serialize_str(text),
            Value::Person(text) => serializer.serialize_str(text.written()),
            Value::Integer(number) => serializer.serialize_i64(*number),
            Value::Decimal(number) => serializer.serialize_f64(*number),
            Value::Truth(truth) => serializer.serialize_bool(*truth),
        }
    }
}

struct Row<'a>(&'a Table, usize);

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Row(table, row) = self;
        serializer.collect_map(table.columns().iter().map(|column| (column.name(), Values::get(column.values(), *row))))
    }
}

impl Serialize for Table {
    /// The names of its columns are the keys of each row; `null` where there is nothing to say.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.keys() {
            0 => Row(self, 0).serialize(serializer),
            _ => serializer.collect_seq((0..self.rows()).map(|row| Row(self, row))),
        }
    }
}

/// The tables of an answer, each below its name.
pub struct Named<'a>(pub &'a [Table]);

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for table in self.0 {
            map.serialize_entry(table.name(), table)?;
        }
        map.end()
    }
}
