//! Which signs does Markdown use?

use super::super::block::Picture;
use super::super::svg::svg;
use super::templates;
use super::writer::{File, Writer};
use crate::text::{self, Format, Untrusted};

/// How formulas are marked in Markdown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[non_exhaustive]
pub enum Math {
    /// Dollars with backticks, as code-hosting pages read it.
    Github,
    /// Dollars alone, as pandoc, Quarto and Jupyter read it.
    Dollars,
}

/// Markdown with formulas marked in one of two ways.
pub(super) struct Markdown {
    pub math: Math,
}

impl Writer for Markdown {
    fn ending(&self) -> &'static str {
        "md"
    }

    fn templates(&self) -> &'static templates::Set {
        templates::set!("markdown", None)
    }

    fn words(&self, words: &str) -> String {
        words.replace('|', "\\|").replace('<', "&lt;").replace('*', "\\*")
    }

    fn person(&self, words: &Untrusted) -> String {
        words.escaped(Format::Markdown)
    }

    fn formula(&self, tex: &str) -> String {
        match self.math {
            Math::Github => format!("$`{tex}`$"),
            Math::Dollars => format!("${tex}$"),
        }
    }

    fn display(&self, tex: &str, number: Option<u32>) -> String {
        let tag = number.map_or_else(String::new, |number| format!(" \\tag{{{number}}}"));
        match self.math {
            Math::Github => format!("```math\n{tex}{tag}\n```"),
            Math::Dollars => format!("$$\n{tex}{tag}\n$$"),
        }
    }

    fn strong(&self, inside: &str) -> String {
        format!("**{inside}**")
    }

    fn code(&self, text: &str) -> String {
        format!("`{text}`")
    }

    fn link(&self, inside: &str, target: &str) -> String {
        format!("[{inside}]({target})")
    }

    fn line(&self, line: &str) -> String {
        line.to_owned()
    }

    fn picture(&self, picture: &Picture, caption: &str) -> (String, Option<File>) {
        let name = format!("{}.svg", picture.name);
        let text = svg(&picture.figure, caption);
        (format!("![{}]({name})", text::markdown(caption)), Some(File { name, text }))
    }
}
