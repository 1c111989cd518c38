//! Do all sentences of pages stand in `templates/pages`, each with its German, and is a slip there told with its line?

use std::collections::BTreeSet;

use crankstar::page::Language;

use crate::support::german::{has_words, literals};
use crate::support::page_texts::{all, module, said};

#[test]
fn every_sentence_of_every_branch_has_german() {
    let texts = all();
    let phrases: BTreeSet<String> = texts.iter().flat_map(|(_, text)| said(text)).collect();
    assert!(phrases.len() > 1000, "{}", phrases.len());
    // Words of a drawing are among its labels.
    let german: BTreeSet<&str> = Language::De.entries().map(|(english, _)| english).collect();
    let is_known = |words: &str| Language::De.knows(words) || german.contains(words);
    let missing: Vec<&String> = phrases.iter().filter(|words| has_words(words) && !is_known(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

#[test]
fn no_sentence_stands_in_the_code_of_the_pages() {
    let german: BTreeSet<&str> = Language::De.entries().map(|(english, _)| english).collect();
    let in_code = literals(&["src/report"]);
    let sentences: Vec<&String> =
        in_code.iter().filter(|words| german.contains(words.as_str()) && is_sentence(words)).collect();
    assert!(sentences.is_empty(), "templates/pages is the place of {sentences:#?}");
    assert!(is_sentence("The orders vanish because {}.") && is_sentence("{with|against} the crank"));
    assert!(!is_sentence("Force in {}") && !is_sentence("Largest load of the crankpin in {}"));
}

/// Ten words, or four with a full stop or a colon, or words that a value chooses: less is a label.
fn is_sentence(words: &str) -> bool {
    let letters = |word: &&str| word.chars().count() > 1;
    let count = words.split(|letter: char| !letter.is_ascii_alphabetic()).filter(letters).count();
    let chooses =
        words.split('{').skip(1).any(|place| place.split('}').next().is_some_and(|words| words.contains('|')));
    count >= 10 || count >= 4 && words.trim_end().ends_with(['.', ':']) || chooses
}

#[test]
fn a_text_is_a_page_with_places_and_sentences_with_names() {
    let text = "# {engine}: pins\n\nThe {sense:with|against} of {engine}, $c_{2}$:\n{table}\n## More\n- {notes}\n---\nlargest: It is {force}.\n";
    let code = module("crank-pins", text).expect("it reads");
    for line in [
        "pub(crate) mod crank_pins {",
        "pub(crate) engine: Text,\npub(crate) sense: Choice,\npub(crate) table: Blocks,\npub(crate) notes: Items,\n",
        "Text::phrase(\"The {with|against} of {}, $c_{2}$:\", vec![Text::from(self.sense), self.engine.clone()])",
        "page.blocks(self.table);\npage.section(Text::phrase(\"More\", vec![]));\npage.items(self.notes);",
        "pub(crate) fn largest(force: impl Into<Text>) -> Text {\nText::phrase(\"It is {}.\", vec![force.into()])",
    ] {
        assert!(code.contains(line), "{line}\nis not in\n{code}");
    }
}

#[test]
fn a_slip_in_a_text_is_told_with_its_line() {
    for (text, told) in [
        ("# Pins\n\nThe {Force} of pins:\n", "3: {Force} is no place"),
        ("# Pins\nThe {force of pins:\n", "2: {force of pins:} is no place"),
        ("# Pins\n{force}\n\nThe {force}:\n", "4: the place force is on this page before"),
        ("largest: The {sense} turns {sense:with|against} it.\n", "1: sense is a value in one place"),
        ("largest: The largest.\n- one more\n", "2: an item of no list"),
        ("The largest is large.\n", "1: a sentence has a name"),
        ("The largest: large.\n", "1: a sentence has a name"),
        ("assumptions:\n- The {shaft} is straight.\n", "1: the list assumptions"),
        ("assumptions:\nlargest: The largest.\n", "1: the list assumptions"),
    ] {
        let mistake = module("pins", text).expect_err(text);
        assert!(mistake.starts_with(told), "{text:?} is told as {mistake:?}");
    }
}
