//! Does a finished text follow a pattern of the list, and how does it read in the other language?

use super::super::markup::{Place, places};

/// English words with places, and the same in another language.
pub(super) struct Pattern<'a> {
    between: Vec<&'a str>,
    words: &'a str,
}

impl<'a> Pattern<'a> {
    pub fn new(english: &'a str, words: &'a str) -> Self {
        Pattern { between: english.split("{}").collect(), words }
    }

    /// Whether commas are in it.
    pub fn has_commas(&self) -> bool {
        self.between.iter().any(|words| words.contains(", "))
    }

    /// The other words, with what is in the places put through `inside`.
    pub fn filled(&self, text: &str, inside: &impl Fn(&str) -> String) -> Option<String> {
        let values: Vec<String> = self.values(text)?.into_iter().map(inside).collect();
        let mut following = 0..;
        let set = |(words, place): (&str, Option<Place>)| {
            let value = place.map(|place| place.value.or_else(|| following.next()).and_then(|at| values.get(at)));
            format!("{words}{}", value.flatten().map_or("", String::as_str))
        };
        Some(places(self.words).into_iter().map(set).collect())
    }

    /// What is in the places, none of them empty.
    fn values<'t>(&self, text: &'t str) -> Option<Vec<&'t str>> {
        let (first, rest) = self.between.split_first()?;
        let mut text = text.strip_prefix(first)?;
        let mut values = Vec::new();
        for (index, words) in rest.iter().enumerate() {
            let end = if index + 1 == rest.len() { text.strip_suffix(words)?.len() } else { text.find(words)? };
            if end == 0 {
                return None;
            }
            values.push(&text[..end]);
            text = text.get(end + words.len()..)?;
        }
        text.is_empty().then_some(values)
    }
}
