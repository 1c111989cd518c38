//! Why could a command not be answered?

use std::fmt;

use crankstar::file::LayoutError;
use crankstar::text::harmless_lines;

/// A message for standard error, with the exit status.
#[derive(Clone, Debug)]
pub struct Failure {
    text: String,
    status: u8,
}

/// The input is wrong, or a certificate fails.
const WRONG: u8 = 1;
/// The program was called wrongly.
const MISUSED: u8 = 2;

impl Failure {
    /// A failure told in one line; what it repeats of the input does nothing to a terminal.
    pub fn new(message: impl fmt::Display) -> Self {
        Failure { text: harmless_lines(&format!("error: {message}")), status: WRONG }
    }

    /// The same of options that do not go together.
    pub fn misuse(message: impl fmt::Display) -> Self {
        Failure { status: MISUSED, ..Failure::new(message) }
    }

    /// The exit status of the program.
    pub fn status(&self) -> u8 {
        self.status
    }

    /// The message without what marks it as an error.
    pub fn message(&self) -> &str {
        self.text.strip_prefix("error: ").unwrap_or(&self.text)
    }

    /// What is wrong, and where in a file, without the drawing of the place.
    pub fn in_one_line(&self) -> String {
        let mut lines = self.message().lines();
        let first = lines.next().unwrap_or_default();
        match lines.find_map(|line| line.trim_start().strip_prefix("--> ")) {
            Some(place) => format!("{place}: {first}"),
            None => first.to_owned(),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl From<LayoutError> for Failure {
    fn from(error: LayoutError) -> Self {
        Failure { text: error.to_string(), status: WRONG }
    }
}
