//! Which document is this? Told by its `format` alone.

use serde::Serialize;
use serde_json::Value;

use super::audit::{Fault, refuse_if};
use super::checked::Checked;
use super::document::Document;
use super::document_check::check_document;
use super::evidence::EvidenceDocument;
use super::firing::FiringDocument;
use super::firing_check::check_firing_document;
use super::format::Format;
use super::open::OpenDocument;
use super::open_check::check_open_document;
use super::reading::{Difference, LARGEST_DOCUMENT, Tree, Unreadable, difference, too_many_digits, typed};
use super::remedy::RemedyDocument;
use super::remedy_check::check_remedy_document;

/// A document of one of the formats.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum AnyDocument {
    /// Verdicts on an engine.
    Classify(Document),
    /// Verdicts on a family of engines.
    Family(OpenDocument),
    /// A remedy.
    Remedy(RemedyDocument),
    /// Firing stars of an engine.
    Firing(FiringDocument),
    /// Numbers, with verdicts as their evidence.
    Evidence(EvidenceDocument),
}

/// Reads a document.
///
/// # Errors
/// Where it is too large, is no JSON, names no known format, or says something in another way than its format has it.
pub fn read_document(bytes: &[u8]) -> Result<AnyDocument, Unreadable> {
    refuse_if(bytes.len() > LARGEST_DOCUMENT, Unreadable::TooLarge(bytes.len()))?;
    let Tree(tree) = serde_json::from_slice(bytes).map_err(|error| Unreadable::NotJson(error.to_string()))?;
    if let Some(digits) = too_many_digits(&tree) {
        return Err(Unreadable::TooManyDigits(digits));
    }
    let format = tree.get("format").cloned();
    let name = format.as_ref().map(Value::to_string);
    let format = format.and_then(|format| serde_json::from_value(format).ok());
    let format = format.ok_or(name.map_or(Unreadable::NoFormat, Unreadable::Format))?;
    match format {
        Format::Classify => typed(&tree).map(AnyDocument::Classify),
        Format::Family => typed(&tree).map(AnyDocument::Family),
        Format::Remedy => typed(&tree).map(AnyDocument::Remedy),
        Format::Firing => typed(&tree).map(AnyDocument::Firing),
        Format::Loads => EvidenceDocument::of_loads(tree).map(AnyDocument::Evidence),
        Format::Compare => EvidenceDocument::of_comparison(tree).map(AnyDocument::Evidence),
    }
}

impl AnyDocument {
    /// The title of the layout; of a comparison that of each.
    pub fn titles(&self) -> Vec<&str> {
        match self {
            AnyDocument::Classify(document) => vec![&document.title],
            AnyDocument::Family(document) => vec![&document.title],
            AnyDocument::Remedy(document) => vec![&document.title],
            AnyDocument::Firing(document) => vec![&document.title],
            AnyDocument::Evidence(document) => document.titles(),
        }
    }

    /// Checks all that the document says.
    ///
    /// # Errors
    /// The first entry that does not hold.
    pub fn check(&self) -> Result<Checked, Fault> {
        match self {
            AnyDocument::Classify(document) => check_document(document),
            AnyDocument::Family(document) => check_open_document(document),
            AnyDocument::Remedy(document) => check_remedy_document(document),
            AnyDocument::Firing(document) => check_firing_document(document),
            AnyDocument::Evidence(document) => document.check(),
        }
    }

    /// Where the engines of two documents differ, and what both say there; none where they are the same.
    pub fn engine_difference(&self, other: &AnyDocument) -> Option<Difference> {
        let engine = |document: &AnyDocument| {
            let Ok(Value::Object(fields)) = serde_json::to_value(document) else { return Value::Null };
            let is_engine = |key: &str| ["cycle", "reference_plane", "cylinders", "turning_masses"].contains(&key);
            Value::Object(fields.into_iter().filter(|(key, _)| is_engine(key)).collect())
        };
        difference("", &engine(self), &engine(other))
    }
}
