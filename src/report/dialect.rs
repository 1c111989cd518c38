//! How does the same text read in Markdown and in LaTeX?
//!
//! Prose is written once, as plain text with `$formulas$` in TeX and `**bold**`, and put into a dialect here.

use crate::page;
use crate::text::{self, Format, Untrusted};

/// The language that a report is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// Markdown as code-hosting pages render it: formulas as `` $`…`$ ``.
    GithubMarkdown,
    /// Markdown for pandoc, Quarto and Jupyter: formulas as `$…$`.
    DollarMarkdown,
    /// LaTeX for pdflatex.
    Latex,
}

impl Dialect {
    /// Prose of this program: text, `$formulas$`, `**bold**`.
    pub fn prose(self, text: &str) -> String {
        let pieces = text.split('$').enumerate();
        pieces.map(|(index, piece)| if index % 2 == 1 { self.formula(piece) } else { self.bold(piece) }).collect()
    }

    /// A text of a page.
    pub fn text(self, text: &page::Text) -> String {
        page::text_in(
            text,
            match self {
                Dialect::GithubMarkdown => page::Format::GITHUB,
                Dialect::DollarMarkdown => page::Format::Markdown(page::Math::Dollars),
                Dialect::Latex => page::Format::Latex,
            },
        )
    }

    /// A person's text: nothing in it is markup.
    pub fn quoted(self, text: &Untrusted) -> String {
        text.escaped(match self {
            Dialect::Latex => Format::Latex,
            Dialect::GithubMarkdown | Dialect::DollarMarkdown => Format::Markdown,
        })
    }

    /// Plain text that may hold a person's words: nothing in it is markup.
    pub fn literal(self, text: &str) -> String {
        self.quoted(&Untrusted::new(text))
    }

    /// A line of a person's file, spaces and signs as they stand.
    pub fn verbatim(self, line: &str) -> String {
        let line = &text::harmless_lines(line).replace('\t', "    ");
        match self {
            Dialect::Latex => {
                if line.is_empty() {
                    return "~".to_owned();
                }
                let begin = line.len() - line.trim_start().len();
                let quotes: Vec<String> = line[begin..].split('"').map(text::latex).collect();
                format!("{}{}", "~".repeat(begin), quotes.join("\\textquotedbl{}").replace("  ", "~~"))
            }
            Dialect::GithubMarkdown | Dialect::DollarMarkdown => line.clone(),
        }
    }

    /// A formula in the line.
    fn formula(self, tex: &str) -> String {
        match self {
            Dialect::GithubMarkdown => format!("$`{tex}`$"),
            Dialect::DollarMarkdown | Dialect::Latex => format!("${tex}$"),
        }
    }

    /// A formula on a line of its own.
    pub fn display(self, tex: &str) -> String {
        match self {
            Dialect::GithubMarkdown => format!("```math\n{tex}\n```"),
            Dialect::DollarMarkdown => format!("$$\n{tex}\n$$"),
            Dialect::Latex => format!("\\[\n{tex}\n\\]"),
        }
    }

    fn bold(self, text: &str) -> String {
        match self {
            Dialect::Latex => {
                let pieces = text.split("**").enumerate();
                let set = |(index, piece): (usize, &str)| match index % 2 {
                    1 => format!("\\textbf{{{}}}", text::latex(piece)),
                    _ => text::latex(piece),
                };
                pieces.map(set).collect()
            }
            _ => text.to_owned(),
        }
    }
}
