//! Why could a command not be answered?

use std::fmt;

use crankstar::file::LayoutError;
use crankstar::text::harmless_lines;

/// A message for standard error; the exit status is 1.
#[derive(Debug)]
pub struct Failure(String);

impl Failure {
    /// A failure told in one line; what it repeats of the input does nothing to a terminal.
    pub fn new(message: impl fmt::Display) -> Self {
        Failure(harmless_lines(&format!("error: {message}")))
    }

    /// The message without what marks it as an error.
    pub fn message(&self) -> &str {
        self.0.strip_prefix("error: ").unwrap_or(&self.0)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<LayoutError> for Failure {
    fn from(error: LayoutError) -> Self {
        Failure(error.to_string())
    }
}
