//! What is wrong with a file that a person wrote? The place, what was written, what would be right.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::engine::BuildError;
use crate::text::{harmless, of_equal_length};

/// A mistake in a layout file or a file of claims, told with the place where it is; unknown keys are reported all at once.
#[derive(Clone, Debug)]
pub struct LayoutError {
    message: String,
    right: String,
    span: Option<Range<usize>>,
    file: Box<str>,
    source: Box<str>,
    /// Other mistakes of the same file.
    others: Box<[LayoutError]>,
}

impl LayoutError {
    /// A mistake with what would be right, at a byte range of the file.
    pub fn new(message: impl Into<String>, right: impl Into<String>, span: Option<Range<usize>>) -> Self {
        let (message, right, others) = (message.into(), right.into(), Box::default());
        LayoutError { message, right, span, file: Box::default(), source: Box::default(), others }
    }

    /// Tells others after this one.
    pub(crate) fn and(mut self, others: impl IntoIterator<Item = LayoutError>) -> Self {
        self.others = self.others.into_iter().chain(others).collect();
        self
    }

    /// Names the file and keeps its text, so that the message can show the line; a mistake that already names a file keeps it.
    pub fn in_file(mut self, file: &str, source: &str) -> Self {
        if !self.file.is_empty() {
            return self;
        }
        self.file = file.into();
        self.source = source.into();
        self.others = self.others.into_iter().map(|other| other.in_file(file, source)).collect();
        self
    }

    /// What is wrong, in one line.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What would be right.
    pub fn right(&self) -> &str {
        &self.right
    }

    /// The name of the file that the message is about.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Line and column where the mistake stands, both from 1 on, the column in characters; none where the whole file is meant.
    pub fn place(&self) -> Option<(usize, usize)> {
        let before = self.source.get(..self.span.as_ref()?.start)?;
        let line = before.rfind('\n').map_or(before, |end| &before[end + 1..]);
        Some((before.matches('\n').count() + 1, line.chars().count() + 1))
    }

    /// Bytes of the file that the message is about.
    pub fn span(&self) -> Option<Range<usize>> {
        self.span.clone()
    }

    /// The message with its line of the file, as an error or a warning.
    pub(super) fn shown(&self, level: &Level<'_>) -> String {
        let (message, right, file) = (harmless(&self.message), harmless(&self.right), harmless(&self.file));
        let source = of_equal_length(&self.source);
        let title = level.clone().primary_title(message.as_str());
        // A span that is empty, or ends inside a character, still has to point at something.
        let span = self.span.clone().filter(|span| self.source.get(span.clone()).is_some());
        let group = match span {
            Some(span) => {
                let annotation = AnnotationKind::Primary.span(span).label(right.as_str());
                title.element(Snippet::source(source.as_str()).path(file.as_str()).annotation(annotation))
            }
            None => title.element(Level::HELP.message(format!("{file}: {right}"))),
        };
        Renderer::plain().render(&[group])
    }
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.shown(&Level::ERROR))?;
        self.others.iter().try_for_each(|other| write!(f, "\n{other}"))
    }
}

impl std::error::Error for LayoutError {}

/// What the keys do not keep from happening, in the words of the builder.
pub(super) fn built<E>(engine: Result<E, BuildError>) -> Result<E, LayoutError> {
    engine.map_err(|error| LayoutError::new(error.to_string(), "all that a file says has to fit together", None))
}
