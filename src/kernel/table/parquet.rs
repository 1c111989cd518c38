//! How is a table written as Parquet? Each column with its type, and empty where there is nothing to say.

use std::io::Write;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical, ZstdLevel};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};

use super::unwritable::Unwritable;
use super::{Column, Kind, Table, Values};
use crate::text::{self, Format};

/// The table as a file; its metadata tell the unit and the meaning of each column.
pub(super) fn parquet(table: &Table) -> Result<Vec<u8>, Unwritable> {
    file(table).map_err(|why| Unwritable::Refused(text::harmless(&why.to_string())))
}

fn file(table: &Table) -> Result<Vec<u8>, ParquetError> {
    let mut groups = Groups::new(table, Vec::new())?;
    groups.add(table)?;
    groups.finish()
}

/// A file that is written group after group of rows.
pub(super) struct Groups<W: Write + Send> {
    writer: SerializedFileWriter<W>,
}

impl<W: Write + Send> Groups<W> {
    /// A file with the columns of this table.
    pub fn new(like: &Table, sink: W) -> Result<Self, ParquetError> {
        let fields = like.columns().iter().map(field).collect::<Result<Vec<TypePtr>, _>>()?;
        let schema = Type::group_type_builder(like.name()).with_fields(fields).build()?;
        let properties = WriterProperties::builder()
            .set_compression(Compression::ZSTD(ZstdLevel::default()))
            .set_created_by(concat!("crankstar ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(metadata(like)))
            .build();
        Ok(Groups { writer: SerializedFileWriter::new(sink, Arc::new(schema), Arc::new(properties))? })
    }

    /// Adds the rows of a table with the same columns.
    pub fn add(&mut self, table: &Table) -> Result<(), ParquetError> {
        let mut rows = self.writer.next_row_group()?;
        for column in table.columns() {
            let Some(mut writer) = rows.next_column()? else {
                return Err(ParquetError::General("a column of the schema has no writer".to_owned()));
            };
            write(&mut writer, column.values())?;
            writer.close()?;
        }
        rows.close().map(drop)
    }

    /// Ends the file.
    pub fn finish(self) -> Result<W, ParquetError> {
        self.writer.into_inner()
    }
}

fn field(column: &Column) -> Result<TypePtr, ParquetError> {
    let (physical, logical) = match column.values().kind() {
        Kind::Words | Kind::Person | Kind::Exact => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        Kind::Integer => (Physical::INT64, None),
        Kind::Decimal => (Physical::DOUBLE, None),
        Kind::Truth => (Physical::BOOLEAN, None),
    };
    let field = Type::primitive_type_builder(column.name(), physical)
        .with_logical_type(logical)
        .with_repetition(Repetition::OPTIONAL);
    Ok(Arc::new(field.build()?))
}

/// `table` with what a row is, and for each column its unit and meaning.
fn metadata(table: &Table) -> Vec<KeyValue> {
    let told = |name: String, words: &str| KeyValue::new(name, words.to_owned());
    let columns = table.columns().iter().flat_map(|column| {
        let unit = told(format!("unit:{}", column.name()), column.unit().name);
        [unit, told(format!("meaning:{}", column.name()), column.about())]
    });
    [told("table".to_owned(), table.about())].into_iter().chain(columns).collect()
}

fn write(writer: &mut SerializedColumnWriter<'_>, values: &Values) -> Result<(), ParquetError> {
    match values {
        Values::Words(values) | Values::Exact(values) => {
            let bytes = |words: &String| ByteArray::from(words.as_str());
            put::<ByteArrayType, _>(writer, values, bytes)
        }
        Values::Person(values) => {
            put::<ByteArrayType, _>(writer, values, |words| ByteArray::from(words.escaped(Format::Plain).into_bytes()))
        }
        Values::Integer(values) => put::<Int64Type, _>(writer, values, |number| *number),
        Values::Decimal(values) => put::<DoubleType, _>(writer, values, |number| *number),
        Values::Truth(values) => put::<BoolType, _>(writer, values, |truth| *truth),
    }
}

/// The values that there are, and which rows have one.
fn put<T: DataType, V>(
    writer: &mut SerializedColumnWriter<'_>,
    values: &[Option<V>],
    written: impl Fn(&V) -> T::T,
) -> Result<(), ParquetError> {
    let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
    let known: Vec<T::T> = values.iter().flatten().map(written).collect();
    writer.typed::<T>().write_batch(&known, Some(&levels), None)?;
    Ok(())
}
