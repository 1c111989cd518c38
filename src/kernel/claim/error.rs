//! Why are words no claim, and what would be right?

/// Why words are no claim: what is wrong, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClaimError {
    /// What cannot be read.
    pub message: String,
    /// What would be right.
    pub right: String,
}

impl ClaimError {
    pub(super) fn new(message: impl Into<String>, right: impl Into<String>) -> Self {
        ClaimError { message: message.into(), right: right.into() }
    }
}

/// A sentence that may mean two things.
pub(super) fn asked(words: &str, question: &str) -> ClaimError {
    ClaimError::new(format!("`{words}` may mean two things"), question)
}
