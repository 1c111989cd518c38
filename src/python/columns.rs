//! How does a table become columns of Python? A dict of NumPy arrays and lists, as pandas and polars take it.

use pyo3::exceptions::PyModuleNotFoundError;
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyDict, PyList};

use crate::table::{Table, Values};

/// A table as a dict: the name of each column with its values.
///
/// Decimals are a float64 array, `nan` where there is nothing to say. Whole numbers and truths are arrays where every row has one, else
/// lists with None. Texts are lists.
pub(super) fn columns<'py>(py: Python<'py>, table: &Table) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for column in table.columns() {
        dict.set_item(column.name(), values(py, column.values())?)?;
    }
    Ok(dict)
}

/// The columns of the first table.
pub(super) fn main<'py>(py: Python<'py>, tables: &[Table]) -> PyResult<Bound<'py, PyDict>> {
    tables.first().map_or_else(|| Ok(PyDict::new(py)), |table| columns(py, table))
}

/// The columns of all tables by their names.
pub(super) fn all<'py>(py: Python<'py>, tables: &[Table]) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for table in tables {
        dict.set_item(table.name(), columns(py, table)?)?;
    }
    Ok(dict)
}

/// What each column of each table is counted in and means: `{table: {column: (unit, meaning)}}`.
pub(super) fn about<'py>(py: Python<'py>, tables: &[Table]) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for table in tables {
        let columns = PyDict::new(py);
        for column in table.columns() {
            columns.set_item(column.name(), (column.unit().name, column.about()))?;
        }
        dict.set_item(table.name(), columns)?;
    }
    Ok(dict)
}

fn values<'py>(py: Python<'py>, values: &Values) -> PyResult<Bound<'py, PyAny>> {
    match values {
        Values::Words(values) | Values::Exact(values) => Ok(PyList::new(py, values)?.into_any()),
        Values::Person(values) => {
            let written = values.iter().map(|text| text.as_ref().map(|text| text.written()));
            Ok(PyList::new(py, written)?.into_any())
        }
        Values::Integer(values) => match whole(values, |value| value.to_ne_bytes()) {
            Some(bytes) => array(py, &bytes, "int64"),
            None => Ok(PyList::new(py, values)?.into_any()),
        },
        Values::Truth(values) => match whole(values, |value| [u8::from(*value)]) {
            Some(bytes) => array(py, &bytes, "bool"),
            None => Ok(PyList::new(py, values)?.into_any()),
        },
        Values::Decimal(values) => floats(py, values.iter().map(|value| value.unwrap_or(f64::NAN))),
    }
}

/// The bytes of a column in which every row has a value.
fn whole<T, const N: usize>(values: &[Option<T>], bytes: fn(&T) -> [u8; N]) -> Option<Vec<u8>> {
    let rows: Option<Vec<[u8; N]>> = values.iter().map(|value| value.as_ref().map(bytes)).collect();
    Some(rows?.concat())
}

/// A float64 array.
pub(super) fn floats<'py>(py: Python<'py>, values: impl Iterator<Item = f64>) -> PyResult<Bound<'py, PyAny>> {
    let bytes: Vec<u8> = values.flat_map(f64::to_ne_bytes).collect();
    array(py, &bytes, "float64")
}

/// An array of NumPy that may be written to.
fn array<'py>(py: Python<'py>, bytes: &[u8], kind: &str) -> PyResult<Bound<'py, PyAny>> {
    let numpy = py.import("numpy").map_err(|error| match error.is_instance_of::<PyModuleNotFoundError>(py) {
        true => {
            PyModuleNotFoundError::new_err("columns are arrays of NumPy; install it: pip install 'crankstar[numpy]'")
        }
        false => error,
    })?;
    numpy.call_method1("frombuffer", (PyByteArray::new(py, bytes), kind))
}
