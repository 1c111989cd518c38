//! In which language is a page written? English words are the keys of one list per language; what a list lacks stays English.
//!
//! A list says what the language is called and how it writes decimals, then gives its words: `[words]` for phrases of the program, with the same places
//! `{}` (or `{1}`, `{2}` in another order) and the same `$formulas$`; `[labels]` for names in drawings and the like, which are
//! finished signs when they come here and are compared with the patterns of the list; `[titles]` for the engines of the catalogue.

mod decimals;
mod pattern;

use std::borrow::Cow;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::sync::OnceLock;

use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::text::Untrusted;
pub(super) use decimals::has_comma;
use pattern::Pattern;

// `Language`, a variant for each list in `templates/words`, and their `FILES`.
include!(concat!(env!("OUT_DIR"), "/languages.rs"));

/// The list of a language as its file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    #[serde(rename = "name")]
    _name: IgnoredAny,
    decimal: String,
    separator: String,
    hyphenation: String,
    words: BTreeMap<String, String>,
    labels: BTreeMap<String, String>,
    #[serde(default)]
    titles: BTreeMap<String, String>,
}

struct List {
    written: Written,
    patterns: Vec<Pattern<'static>>,
}

/// The lists are part of the program, so that a mistake in one is a mistake of ours.
const OURS: &str = "a list of words of the program";

/// Words with places, formulas or bold words have one of these.
const MARKUP: [char; 3] = ['{', '$', '*'];

/// In the order of [`Language`]; a list is read where it is used.
static LISTS: [OnceLock<List>; FILES.len()] = [const { OnceLock::new() }; FILES.len()];

fn read(file: &'static str) -> List {
    let written: Written = toml::from_str(file).expect(OURS);
    let owned = |text: &String| -> &'static str { Box::leak(text.clone().into_boxed_str()) };
    let mut labels: Vec<(&String, &String)> = written.labels.iter().collect();
    // The pattern that says the most comes first.
    labels.sort_by_key(|(key, _)| Reverse(key.len()));
    let patterns = labels.into_iter().map(|(key, words)| Pattern::new(owned(key), owned(words))).collect();
    List { written, patterns }
}

impl Language {
    fn list(self) -> &'static List {
        LISTS[self as usize].get_or_init(|| read(FILES[self as usize].2))
    }

    /// As `lang` in HTML has it.
    pub fn code(self) -> &'static str {
        FILES[self as usize].0
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        FILES[self as usize].1
    }

    /// What LaTeX calls its patterns of hyphenation.
    pub(super) fn hyphenation(self) -> &'static str {
        &self.list().written.hyphenation
    }

    /// The language of a code.
    pub fn of_code(code: &str) -> Option<Self> {
        Language::ALL.into_iter().find(|language| language.code() == code)
    }

    /// Whether these words need no translation or have one, sentence by sentence.
    pub fn knows(self, english: &str) -> bool {
        let one = |sentence: &str| self.whole(sentence).or_else(|| self.sentence(sentence)).is_some();
        let is_listed = || self.list().written.words.contains_key(english);
        // What has places is looked up as it stands.
        let is_plain = !english.contains(MARKUP);
        let is_read = || is_plain && english.split_inclusive(". ").all(|sentence| one(sentence.trim_end()));
        self == Language::En || is_listed() || is_read()
    }

    /// The entries of its list: English words and its own.
    pub fn entries(self) -> impl Iterator<Item = (&'static str, &'static str)> {
        let written = &self.list().written;
        written.words.iter().chain(&written.labels).map(|(key, words)| (key.as_str(), words.as_str()))
    }

    /// The title of an engine of the catalogue; none of what somebody else wrote.
    pub fn title(self, english: &Untrusted) -> Option<Untrusted> {
        let own = self.list().written.titles.get(english.written()).filter(|_| english.is_of_catalogue());
        own.map(|own| Untrusted::new(own.as_str()))
    }

    /// A fixed word of the program.
    pub fn fixed(self, english: &str) -> &str {
        self.list().written.words.get(english).map_or(english, String::as_str)
    }

    /// Words of the program: a phrase of the list, or sentences that follow its patterns.
    pub fn words(self, english: &str) -> Cow<'_, str> {
        match self.list().written.words.get(english) {
            Some(words) => Cow::Borrowed(words),
            None if english.contains(MARKUP) => Cow::Borrowed(english),
            None => self.label(english),
        }
    }

    /// Signs that are finished: a name in a drawing, numbers in a row, a note beside what moves.
    pub fn label<'a>(self, english: &'a str) -> Cow<'a, str> {
        match self {
            Language::En => Cow::Borrowed(english),
            _ => Cow::Owned(self.signs(english)),
        }
    }

    pub(super) fn signs(self, english: &str) -> String {
        let known = self.whole(english).or_else(|| self.sentences(english)).or_else(|| self.sentence(english));
        known.or_else(|| self.with_place(english)).unwrap_or_else(|| self.numbers(english))
    }

    /// A name with the place in a list behind it, `throws 2`.
    fn with_place(self, english: &str) -> Option<String> {
        let (name, place) = english.rsplit_once(' ').filter(|(_, place)| place.parse::<usize>().is_ok())?;
        Some(format!("{} {place}", self.whole(name)?))
    }

    /// What the list has as it stands.
    fn whole(self, english: &str) -> Option<String> {
        let words = self.list().written.labels.get(english).or_else(|| self.list().written.words.get(english))?;
        (!words.contains(MARKUP)).then(|| words.clone())
    }

    /// Sentence by sentence.
    fn sentences(self, english: &str) -> Option<String> {
        let sentences: Vec<&str> = english.split_inclusive(". ").collect();
        let one = |sentence: &&str| self.signs(sentence.trim_end());
        (sentences.len() > 1).then(|| sentences.iter().map(one).collect::<Vec<_>>().join(" "))
    }

    /// Piece by piece between commas, where the list knows every one that has letters.
    fn pieces(self, english: &str) -> Option<String> {
        let pieces: Vec<&str> = english.split(", ").collect();
        let known = |piece: &str| self.whole(piece).or_else(|| self.pattern(piece, |inside| self.signs(inside)));
        // A letter by itself is a symbol, `λ = 0.2`, and one beside a digit a name, `2CAe`.
        let is_word = |word: &str| word.chars().nth(1).is_some() && word.chars().all(char::is_alphabetic);
        let has_words = |piece: &str| piece.split(|letter: char| !letter.is_alphanumeric()).any(is_word);
        let bare = |piece: &str| (!has_words(piece)).then(|| self.numbers(piece));
        let one = |piece: &&str| known(piece).or_else(|| bare(piece));
        if pieces.len() < 2 || !english.contains(char::is_alphabetic) {
            return None;
        }
        let set = pieces.iter().map(one).collect::<Option<Vec<String>>>()?;
        let between = if set.iter().any(|piece| has_comma(piece)) { self.separator() } else { ", " };
        Some(set.join(between))
    }

    /// A pattern that has commas itself, else piece by piece between them, else any pattern.
    fn sentence(self, english: &str) -> Option<String> {
        let inside = |inside: &str| self.signs(inside);
        let long = self.list().patterns.iter().filter(|pattern| pattern.has_commas());
        let known = long.into_iter().find_map(|pattern| pattern.filled(english, &inside));
        known.or_else(|| self.pieces(english)).or_else(|| self.pattern(english, inside))
    }

    fn pattern(self, english: &str, inside: impl Fn(&str) -> String) -> Option<String> {
        let list = self.list();
        list.patterns.iter().find_map(|pattern| pattern.filled(english, &inside))
    }

    /// Decimals as the language writes them, and what stands between them.
    pub(super) fn numbers(self, text: &str) -> String {
        let written = &self.list().written;
        let changed = decimals::with(text, &written.decimal);
        if changed != text { changed.replace(", ", &written.separator) } else { changed }
    }

    /// What stands between values where some are decimals.
    pub(super) fn separator(self) -> &'static str {
        &self.list().written.separator
    }

    /// A formula in TeX: a decimal sign that is no point is no punctuation either.
    pub(super) fn formula(self, tex: &str) -> String {
        match self.list().written.decimal.as_str() {
            "." => tex.to_owned(),
            sign => decimals::with(tex, &format!("{{{sign}}}")),
        }
    }

    /// What is drawn as prose with `$formulas$`.
    pub(super) fn prose(self, prose: &str) -> String {
        let part = |(index, part): (usize, &str)| match index % 2 {
            0 => self.signs(part),
            _ => format!("${}$", self.formula(part)),
        };
        match self.whole(prose).or_else(|| self.pattern(prose, |inside| self.prose(inside))) {
            Some(words) => words,
            None => prose.split('$').enumerate().map(part).collect(),
        }
    }
}
