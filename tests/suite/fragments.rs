//! Is a fragment of LaTeX a piece that an author can input: captions and labels, and nothing of a document around it?

use std::collections::BTreeSet;

use crankstar::file::parse;
use crankstar::page::{self, Format, Options};

use crate::support::pages::document;
use crate::support::program::call;

fn fragment(options: Options) -> String {
    fragment_in(Format::Latex, options)
}

fn fragment_in(format: Format, options: Options) -> String {
    let text = include_str!("../../reports/examples/v8-small-block/layout.toml");
    let page = document(&parse("layout.toml", text).expect("it reads"));
    page::write(&page, format, &Options { fragment: true, ..options }).remove(0).text
}

fn between<'a>(text: &'a str, begin: &str) -> Vec<&'a str> {
    text.split(begin).skip(1).filter_map(|rest| rest.split('}').next()).collect()
}

#[test]
fn a_fragment_has_no_preamble_and_names_what_it_needs() {
    let text = fragment(Options::default());
    for word in ["\\documentclass", "\\begin{document}", "\\end{document}", "\\appendix", "\\newcommand{\\csfit}"] {
        assert!(!text.contains(word), "{word}");
    }
    let comments: Vec<&str> = text.lines().take_while(|line| line.starts_with('%')).collect();
    for package in ["booktabs", "longtable", "amsmath", "tikz", "arrows.meta"] {
        assert!(comments.iter().any(|line| line.contains(package)), "{package} in {comments:?}");
    }
}

#[test]
fn each_label_stands_once_and_each_reference_has_its_label() {
    let text = fragment(Options { label: Some("sb".to_owned()), ..Options::default() });
    let labels = between(&text, "\\label{");
    let once: BTreeSet<&str> = labels.iter().copied().collect();
    assert_eq!(once.len(), labels.len(), "{labels:?}");
    for kind in ["fig:sb-", "tab:sb-", "eq:sb-", "sec:sb-"] {
        assert!(labels.iter().any(|label| label.starts_with(kind)), "{kind} in {labels:?}");
    }
    assert!(labels.iter().all(|label| label.split_once(':').is_some_and(|(_, name)| name.starts_with("sb-"))));
    for reference in between(&text, "\\ref{").into_iter().chain(between(&text, "\\pageref{")) {
        assert!(once.contains(reference), "{reference}");
    }
    assert!(between(&fragment(Options::default()), "\\label{").iter().all(|label| label.contains(":small-block-v8")));
}

#[test]
fn each_figure_and_each_table_has_a_caption_and_its_label() {
    let text = fragment(Options::default());
    let kinds = ["figure", "table", "longtable"].map(|kind| (format!("\\begin{{{kind}}}"), format!("\\end{{{kind}}}")));
    for (begin, end) in kinds.iter().filter(|(begin, _)| text.contains(begin)) {
        let whole = text.split(begin.as_str()).skip(1).map(|rest| rest.split(end.as_str()).next().unwrap_or_default());
        let (with, without): (Vec<&str>, Vec<&str>) = whole.partition(|part| part.contains("\\caption"));
        assert!(!with.is_empty() && with.iter().all(|part| part.contains("\\label{")), "{begin}");
        // Only a table that goes on in another stands without one.
        assert!(without.is_empty() || begin.contains("table"), "{begin}");
    }
    assert!(text.contains("\\toprule") && text.contains("\\begin{table}"));
}

#[test]
fn quantities_are_left_to_siunitx_only_where_that_is_asked_for() {
    assert!(!fragment(Options::default()).contains("\\qty"));
    let text = fragment(Options { siunitx: true, ..Options::default() });
    assert!(text.contains("\\qty{9862}{\\newton\\metre}") && text.contains("siunitx"), "{text}");
}

#[test]
fn a_prefix_is_one_that_latex_takes() {
    let told = call(&["report", "I4", "--format", "latex", "--fragment", "--label", "a_b"]);
    assert_eq!(told.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&told.stderr).contains("letters, digits"));
    let without = call(&["report", "I4", "--format", "latex", "--label", "ab"]);
    assert_eq!(without.status.code(), Some(2));
}

#[test]
fn a_fragment_of_html_stands_in_a_page_that_is_there() {
    let text = fragment_in(Format::Html, Options::default());
    assert!(text.starts_with("<div class=\"crankstar\""), "{}", &text[..60]);
    for word in ["<!DOCTYPE", "<html", "<head", "<body", "<h1"] {
        assert!(!text.contains(word), "{word}");
    }
    assert_eq!(text.matches("<div").count(), text.matches("</div>").count());
    // What it looks like is of its own parts alone.
    let rules = text.split_once("<style>").and_then(|(_, rest)| rest.split_once("</style>")).expect("a style").0;
    let rules = rules.lines().filter(|line| !line.trim().is_empty());
    assert!(rules.clone().count() > 5);
    assert_eq!(rules.filter(|line| !line.contains(".crankstar")).collect::<Vec<_>>(), Vec::<&str>::new());
}
