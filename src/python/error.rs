//! What does Python raise? A `ValueError` with the place and the message of the command line.

use std::fmt::Display;

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::file;
use crate::proof::Fault;
use crate::text::harmless_lines;

create_exception!(
    crankstar,
    CrankstarError,
    PyValueError,
    "The request cannot be answered; the message says what would be right."
);
create_exception!(
    crankstar,
    LayoutError,
    CrankstarError,
    "A layout that cannot be read.

Its text is that of the command line: the line of the file, what is wrong in it, what would be right.

Attributes: `message` and `right`, a line each; `file`; `line` and `column`, from 1 on, or None where the whole file is meant."
);
create_exception!(
    crankstar,
    ProofError,
    CrankstarError,
    "A document that the checker rejects.\n\nAttribute `place`: where in the document, such as `verdicts[3].certificate`; None where it cannot be read at all."
);

/// A mistake that is reported in one line, in the words of Python; what it repeats of the input does nothing to a terminal.
pub(super) fn told(error: impl Display) -> PyErr {
    CrankstarError::new_err(harmless_lines(&in_python(&error.to_string())))
}

/// Options that Python has no keyword for: advice on them is omitted.
const OF_THE_COMMAND_LINE: [&str; 3] = ["--format", "--output", "--shard"];

/// A message of the library, in which options of the command line stand as `--bank-angle`, with the keywords of Python.
fn in_python(message: &str) -> String {
    let clauses =
        message.split("; ").filter(|clause| !OF_THE_COMMAND_LINE.iter().any(|option| clause.contains(option)));
    let respelled = |clause: &str| -> String {
        let words = clause.split(' ').filter(|word| *word != "--set").map(keyword);
        words.collect::<Vec<_>>().join(" ")
    };
    clauses.map(respelled).collect::<Vec<_>>().join("; ")
}

/// `--pin-split` is `pin_split`, and `KEY=0..10:1`, which is behind `--set`, an entry of `ranges`.
fn keyword(word: &str) -> String {
    match (word.strip_prefix("KEY="), word.strip_prefix("--")) {
        (Some(range), _) => format!("ranges={{\"KEY\": \"{range}\"}}"),
        (None, Some(name)) => name.replace('-', "_"),
        (None, None) => word.to_owned(),
    }
}

/// A mistake in a layout, with its place.
pub(super) fn layout(error: &file::LayoutError) -> PyErr {
    let raised = LayoutError::new_err(error.to_string());
    let (line, column) = error.place().unzip();
    with(raised, |value| {
        value.setattr("message", error.message())?;
        value.setattr("right", error.right())?;
        value.setattr("file", error.file())?;
        value.setattr("line", line)?;
        value.setattr("column", column)
    })
}

/// What the checker says, with the place in the document.
pub(super) fn fault(fault: &Fault) -> PyErr {
    proof(fault, Some(&fault.place))
}

/// A document that is none, or does not hold.
pub(super) fn proof(error: impl Display, place: Option<&str>) -> PyErr {
    with(ProofError::new_err(harmless_lines(&error.to_string())), |value| value.setattr("place", place))
}

/// An error with attributes; what keeps them from being set is raised instead.
fn with(error: PyErr, set: impl Fn(&Bound<'_, PyAny>) -> PyResult<()>) -> PyErr {
    Python::attach(|py| match set(error.value(py).as_any()) {
        Ok(()) => error,
        Err(other) => other,
    })
}
