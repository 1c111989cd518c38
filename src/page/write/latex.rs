//! Which signs does LaTeX use?

use super::super::block::Picture;
use super::super::tikz::tikz;
use super::super::{Unit, number};
use super::siunitx::siunitx;
use super::templates;
use super::writer::{File, Writer};
use crate::text::{self, Format, Untrusted};

/// LaTeX for pdflatex.
pub(super) struct Latex;

impl Writer for Latex {
    fn digit_space(&self) -> Option<&'static str> {
        Some("\\phantom{0}")
    }

    fn ending(&self) -> &'static str {
        "tex"
    }

    fn templates(&self) -> &'static templates::Set {
        templates::set!("latex", Some(templates::angles()), "alone", "colours")
    }

    fn words(&self, words: &str) -> String {
        // A number stays with its sign.
        let words = &words.replace("≈ ", "≈\u{a0}");
        // Elsewhere an `a` behind it may be a word.
        match words.strip_suffix("m r ω² a") {
            Some(before) => text::latex(before) + "$m\\,r\\,\\omega^2\\,a$",
            None => text::latex(words),
        }
    }

    /// Fonts of text lack most letters of formulas.
    fn symbol(&self, tex: &str, _plain: &str) -> String {
        format!("${tex}$")
    }

    fn person(&self, words: &Untrusted) -> String {
        words.escaped(Format::Latex)
    }

    fn formula(&self, tex: &str) -> String {
        format!("${tex}$")
    }

    fn display(&self, tex: &str, number: Option<u32>) -> String {
        let tag = number.map_or_else(String::new, |number| format!(" \\tag{{{number}}}"));
        format!("\\[\n{tex}{tag}\n\\]")
    }

    fn strong(&self, inside: &str) -> String {
        format!("\\textbf{{{inside}}}")
    }

    fn code(&self, text: &str) -> String {
        // Two hyphens would be printed as a dash.
        format!("\\texttt{{{}}}", text::latex(text).replace("--", "-{}-"))
    }

    fn line(&self, line: &str) -> String {
        self::line(line)
    }

    fn picture(&self, picture: &Picture, _caption: &str) -> (String, Option<File>) {
        (tikz(&picture.figure), None)
    }

    fn quantity(&self, number: &str, unit: Unit) -> Option<String> {
        siunitx(&unit).map(|commands| format!("\\qty{{{}}}{{{commands}}}", number::in_ascii(number)))
    }

    fn has_labels(&self) -> bool {
        true
    }

    fn is_print(&self) -> bool {
        true
    }
}

/// A line of a file, spaces and quotes as they stand.
fn line(line: &str) -> String {
    if line.is_empty() {
        return "~".to_owned();
    }
    let begin = line.len() - line.trim_start().len();
    let quotes: Vec<String> = line[begin..].split('"').map(|part| text::breakable(part, text::latex)).collect();
    format!("{}{}", "~".repeat(begin), quotes.join("\\textquotedbl{}").replace("  ", "~~"))
}
