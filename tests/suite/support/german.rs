//! What of a phrase is to be translated?

/// What stands in a phrase outside of its formulas.
pub fn outside(words: &str) -> impl Iterator<Item = &str> {
    words.split('$').step_by(2)
}

/// Whether a phrase has words, and not only places and signs.
pub fn has_words(words: &str) -> bool {
    outside(words).any(|part| part.contains(char::is_alphabetic))
}
