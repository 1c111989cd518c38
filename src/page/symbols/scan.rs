//! Where are the symbols in a formula, and where in words?

use super::symbol::{SYMBOLS, Symbol};

/// A part of a formula, or of words.
pub(super) enum Part<'a> {
    /// A symbol that can have another name, as it is written.
    Symbol(Symbol, &'a str),
    /// Anything else.
    Other(&'a str),
}

/// The parts of a formula in TeX.
pub(super) fn formula(tex: &str) -> Vec<Part<'_>> {
    split(tex, |_, rest| match rest.strip_prefix('\\') {
        Some(command) => {
            let letters = command.bytes().take_while(u8::is_ascii_alphabetic).count();
            // φ is written in two ways.
            let name = if &command[..letters] == "phi" { "varphi" } else { &command[..letters] };
            let symbol = SYMBOLS.into_iter().find(|symbol| !symbol.has_index && symbol.tex == name);
            // A sign such as `\,` is no command, whatever it is.
            let sign = command.chars().next().map_or(0, char::len_utf8);
            (1 + letters.max(if letters == 0 { sign } else { 0 }), symbol)
        }
        None => one(rest, |behind| behind.trim_start().starts_with(['_', '^'])),
    })
}

/// The parts of words.
pub(super) fn words(words: &str) -> Vec<Part<'_>> {
    let is_index = |letter: char| "_⁺⁻ₖ".contains(letter) || ('₀'..='₉').contains(&letter);
    split(words, |before, rest| match before.chars().next_back().is_some_and(char::is_alphanumeric) {
        // Inside a word a letter is no symbol.
        true => one(rest, |_| false),
        false => one(rest, |behind| behind.starts_with(is_index)),
    })
}

/// The next letter, with its length; `has_index`: of what is behind it.
fn one(rest: &str, has_index: impl Fn(&str) -> bool) -> (usize, Option<Symbol>) {
    let Some(letter) = rest.chars().next() else { return (0, None) };
    let length = letter.len_utf8();
    let is_meant = |symbol: &Symbol| symbol.letter == letter && (!symbol.has_index || has_index(&rest[length..]));
    (length, SYMBOLS.into_iter().find(is_meant))
}

/// Cuts a text at what `step` finds in what stands before and behind each place: how long it is, and its symbol.
fn split(text: &str, step: impl Fn(&str, &str) -> (usize, Option<Symbol>)) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let (mut begin, mut at) = (0, 0);
    while at < text.len() {
        let (before, rest) = text.split_at(at);
        let (length, symbol) = step(before, rest);
        if let Some(symbol) = symbol {
            parts.extend((begin < at).then(|| Part::Other(&text[begin..at])));
            parts.push(Part::Symbol(symbol, &rest[..length]));
            begin = at + length;
        }
        at += length.max(1);
    }
    parts.extend((begin < text.len()).then(|| Part::Other(&text[begin..])));
    parts
}
