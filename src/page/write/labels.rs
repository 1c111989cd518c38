//! By which labels are the parts of a fragment referred to?

use std::collections::BTreeMap;

use super::super::block::Document;
use super::columns::Caption;
use super::notation::plain;
use super::options::Options;

/// The labels of a fragment, each once; none where no fragment is written.
#[derive(Default)]
pub(super) struct Labels {
    /// What stands before each name.
    prefix: Option<String>,
    taken: BTreeMap<String, usize>,
    /// What is spoken of: headings and folds around.
    topics: Vec<Topic>,
    /// The sentence that leads to a table, without its colon.
    leading: Option<String>,
}

/// What is spoken of, as it is written, and in plain words.
struct Topic {
    text: String,
    plain: String,
}

/// Longer sentences are no part of a caption.
const LONGEST_LEADING: usize = 160;

impl Labels {
    /// Of a document that is written as a fragment.
    pub fn of_fragment(document: &Document, text: String, options: &Options) -> Self {
        let plain = plain(&document.title, &Options::default());
        let slug = slug(&plain);
        let usual = if slug.is_empty() { document.name.to_owned() } else { slug };
        let prefix = options.label.clone().unwrap_or(usual);
        Labels { prefix: Some(prefix), topics: vec![Topic { text, plain }], ..Labels::default() }
    }

    /// `fig:i4-star`: of this kind and name; with a number behind it where it is not the first.
    pub fn label(&mut self, kind: &str, name: &str) -> Option<String> {
        let label = format!("{kind}:{}-{}", self.prefix.as_ref()?, slug(name));
        let count = self.taken.entry(label.clone()).or_default();
        *count += 1;
        Some(if *count == 1 { label } else { format!("{label}-{count}") })
    }

    /// A heading: what follows is about it.
    pub fn topic(&mut self, text: &str, plain: String) {
        self.topics.pop();
        self.enter(text, plain);
    }

    /// What is folded is about its summary, and what follows it about what was spoken of before.
    pub fn enter(&mut self, text: &str, plain: String) {
        self.topics.push(Topic { text: text.to_owned(), plain });
    }

    /// The end of what is folded.
    pub fn leave(&mut self) {
        self.topics.pop();
    }

    /// The paragraph before, if the last block was one.
    pub fn lead(&mut self, paragraph: Option<&str>) {
        let sentence = paragraph.and_then(|words| words.trim_end().strip_suffix(':'));
        self.leading = sentence.filter(|words| words.len() <= LONGEST_LEADING).map(str::to_owned);
    }

    /// The caption of the next table: what is spoken of, and the sentence that leads to it.
    pub fn caption(&mut self) -> Option<Caption> {
        let name = self.topics.last()?.plain.clone();
        let label = self.label("tab", &name)?;
        let topic = &self.topics.last()?.text;
        let text = match self.leading.take() {
            Some(leading) => format!("{topic}. {leading}"),
            None => topic.clone(),
        };
        Some(Caption { text, label })
    }
}

/// The first sentence of a caption, for a list of figures.
pub(super) fn short(caption: &str) -> Option<&str> {
    let (first, _) = caption.split_once(". ")?;
    let is_whole = first.matches('$').count() % 2 == 0 && first.matches('{').count() == first.matches('}').count();
    is_whole.then_some(first)
}

/// Letters and digits with hyphens between them.
fn slug(text: &str) -> String {
    let lower = text.to_lowercase();
    let words = lower.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}
