//! How does an answer look in a notebook?

use super::pages;
use crate::page::{Document, Format, Options, Text, text_in};

/// A page as a piece of HTML.
pub(super) fn html(page: &Document) -> String {
    pages::text(page, Format::Html, &Options { fragment: true, ..Options::default() })
}

/// What is left in a cell of a formula.
pub(super) fn tex(text: &Text) -> String {
    match text.is_zero() {
        true => "\\mathbf{0}".to_owned(),
        // MathJax would show a tie as it is.
        false => format!("\\text{{{}}}", text_in(text, Format::Latex).replace('~', " ")),
    }
}
