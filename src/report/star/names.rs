//! What are the vectors of a ray called, in full and beside their arrow?

use super::Ray;
use super::scale::LETTERS;
use crate::engine::Engine;
use crate::order::Source;
use crate::page::figure::text_width;
use crate::report::typeset;

/// More masses that turn than this have no room beside a vector.
const MOST_LABELLED: usize = 2;
/// Longer words than this, in millimetres, are cut.
const LONGEST_WORD: f64 = 24.0;
/// Widths that a label may be broken to, in millimetres.
const WIDTHS: [f64; 3] = [30.0, 18.0, 10.0];

/// What sources are called: cylinders by their names, then what turns.
pub(in crate::report) fn source_names(engine: &Engine, sources: impl Iterator<Item = Source>) -> String {
    listed(engine, sources, |others| others.iter().map(|source| source.name(engine)).collect())
}

/// Cylinders by their names, then what turns, in the words given.
fn listed(
    engine: &Engine,
    sources: impl Iterator<Item = Source>,
    turning: impl Fn(&[Source]) -> Vec<String>,
) -> String {
    let (pistons, others): (Vec<Source>, Vec<Source>) = sources.partition(|source| source.piston().is_some());
    let pistons: Vec<String> = pistons.into_iter().map(|source| source.name(engine)).collect();
    let cylinders = typeset::names(&pistons.iter().map(String::as_str).collect::<Vec<_>>());
    typeset::listed((!cylinders.is_empty()).then_some(cylinders).into_iter().chain(turning(&others)))
}

/// The same in little room: `1, 4–7`, `1, rod 1`, `1–4, +6`.
pub(in crate::report) fn short_names(engine: &Engine, sources: impl Iterator<Item = Source>) -> String {
    listed(engine, sources, |others| match others.len() {
        0..=MOST_LABELLED => others.iter().map(|source| source.label(engine)).collect(),
        many => vec![format!("+{many}")],
    })
}

impl Ray {
    /// Whether its masses that turn are counted, for there are too many to be named.
    pub fn counts_turning(&self) -> bool {
        self.turning().count() > MOST_LABELLED
    }

    /// Its members beside the pistons.
    pub fn turning(&self) -> impl Iterator<Item = Source> {
        self.members.iter().map(|(source, _)| *source).filter(|source| source.piston().is_none())
    }

    /// The same in little room, broken into lines in several ways, the widest first: `1, 5, rod 1`, `1, 5, +6 (8 ×)`.
    pub fn labels(&self, engine: &Engine, counts: &[usize], letters: f64) -> Vec<Vec<String>> {
        let members = self.members.iter().map(|(source, _)| *source);
        let names = self.name.clone().unwrap_or_else(|| short_names(engine, members));
        let counts: Vec<String> = counts.iter().filter(|count| **count > 1).map(|count| format!("{count} ×")).collect();
        let counted = (!counts.is_empty()).then(|| format!("({})", counts.join(" + ")));
        let words = names.split(' ').filter(|word| !word.is_empty()).map(|word| cut(word, LONGEST_WORD, letters));
        let words: Vec<String> = words.chain(counted).collect();
        let mut ways: Vec<Vec<String>> = WIDTHS.iter().map(|width| broken(&words, *width, letters)).collect();
        ways.dedup();
        ways
    }
}

/// In lines of at most this width, as far as words allow.
fn broken(words: &[String], width: f64, letters: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), letters) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.clone()),
        }
    }
    lines
}

/// A name for above a column of stars: of one that is too long what tells it from others, behind a comma, stays whole.
pub(in crate::report) fn shortened(name: &str, width: f64) -> String {
    // Bold letters are wider.
    let width = width / 1.1;
    let Some((engine, part)) = name.split_once(", ") else { return cut(name, width, LETTERS) };
    let left = width - text_width(&format!(", {part}"), LETTERS);
    match text_width(name, LETTERS) > width && left >= text_width("m…", LETTERS) {
        true => format!("{}, {part}", cut(engine, left, LETTERS)),
        false => cut(name, width, LETTERS),
    }
}

/// A text, cut where it is wider than this in millimetres.
fn cut(text: &str, width: f64, letters: f64) -> String {
    if text_width(text, letters) <= width {
        return text.to_owned();
    }
    let mut short = String::from("…");
    for letter in text.chars() {
        let at = short.len() - '…'.len_utf8();
        short.insert(at, letter);
        if text_width(&short, letters) > width {
            short.remove(at);
            break;
        }
    }
    short
}
