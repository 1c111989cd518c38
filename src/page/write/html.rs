//! Which signs does HTML use? Formulas as MathML, pictures as SVG inside the page.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

use super::super::block::Picture;
use super::super::svg::svg;
use super::templates;
use super::writer::{File, Writer};
use crate::text::{self, Format, Untrusted};

/// One page for a browser, with nothing beside it.
pub(super) struct Html;

impl Writer for Html {
    fn digit_space(&self) -> Option<&'static str> {
        Some("&#8199;")
    }

    fn ending(&self) -> &'static str {
        "html"
    }

    fn templates(&self) -> &'static templates::Set {
        templates::set!("html", None)
    }

    fn words(&self, words: &str) -> String {
        text::xml(words)
    }

    fn person(&self, words: &Untrusted) -> String {
        text::xml(&words.escaped(Format::Plain))
    }

    fn formula(&self, tex: &str) -> String {
        let formula = mathml(tex, DisplayMode::Inline);
        // What is wider than a phone is moved under the finger.
        if tex.len() > LONG { format!("<span class=\"long\">{formula}</span>") } else { formula }
    }

    fn display(&self, tex: &str, number: Option<u32>) -> String {
        let number = number.map_or_else(String::new, |number| format!("<span class=\"number\">({number})</span>"));
        format!("<span class=\"formula\">{}{number}</span>", mathml(tex, DisplayMode::Block))
    }

    fn strong(&self, inside: &str) -> String {
        format!("<strong>{inside}</strong>")
    }

    fn zero(&self) -> String {
        "<strong class=\"zero\">0</strong>".to_owned()
    }

    fn code(&self, text: &str) -> String {
        format!("<code>{}</code>", text::xml(text))
    }

    fn explained(&self, words: String, meaning: &str) -> String {
        format!("<abbr title=\"{}\">{words}</abbr>", text::xml(meaning))
    }

    fn link(&self, inside: &str, target: &str) -> String {
        format!("<a href=\"{}\">{inside}</a>", text::xml(target))
    }

    fn line(&self, line: &str) -> String {
        text::xml(line)
    }

    fn has_scripts(&self) -> bool {
        true
    }

    fn picture(&self, picture: &Picture, caption: &str) -> (String, Option<File>) {
        let least = format!("<svg style=\"--least:{:.0}px\" ", picture.figure.least_pixels());
        (svg(&picture.figure, caption).replacen("<svg ", &least, 1), None)
    }
}

/// Longer formulas may be wider than a narrow page.
const LONG: usize = 60;

/// How the tag of a bar ends, without space about it: one that keeps its height, one that grows.
const TIGHT: &str = "y=\"false\" lspace=\"0em\" rspace=\"0em\">|</mo>";
const TALL: &str = "y=\"true\" lspace=\"0em\" rspace=\"0em\">|</mo>";

/// A thin space.
const THIN: &str = "<mspace width=\"0.1667em\" />";

/// A formula of this program in MathML; as its TeX where the library does not know a command.
fn mathml(tex: &str, display_mode: DisplayMode) -> String {
    let storage = Storage::new();
    let mut out = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    match push_mathml(&mut out, Parser::new(tex, &storage), config) {
        // Browsers take a bar that is no fence by its side for an operator, and set space about it.
        Ok(()) if !out.contains("<merror") => {
            let out = out.replace("y=\"false\">|</mo>", TIGHT).replace("y=\"true\">|</mo>", TALL);
            // The space before the name of a function is no part of what is raised.
            out.replace(&format!("<msup>{THIN}"), &format!("{THIN}<msup>"))
        }
        Ok(()) | Err(_) => format!("<code>{}</code>", text::xml(tex)),
    }
}
