//! Which signs does Typst use? Formulas in its own notation, pictures as SVG beside the page.

use super::super::block::Picture;
use super::super::svg::svg;
use super::templates;
use super::tex::{self, Node, Space};
use super::writer::{File, Writer};
use crate::text::{Format, Untrusted};

/// Typst, for its compiler.
pub(super) struct Typst;

impl Writer for Typst {
    fn digit_space(&self) -> Option<&'static str> {
        Some("#hide[0]")
    }

    fn ending(&self) -> &'static str {
        "typ"
    }

    fn templates(&self) -> &'static templates::Set {
        templates::set!("typst", None)
    }

    fn words(&self, words: &str) -> String {
        escaped(words, |sign| "\\#$*_`@<>~[]/\"'".contains(sign))
    }

    /// A reader's symbol is taken as a sign, for its TeX may be any.
    fn reads_tex(&self) -> bool {
        false
    }

    fn person(&self, words: &Untrusted) -> String {
        escaped(&words.escaped(Format::Plain), |sign| sign.is_ascii_punctuation())
    }

    fn formula(&self, tex: &str) -> String {
        format!("${}$", formula(tex))
    }

    fn display(&self, tex: &str, number: Option<u32>) -> String {
        let number = number.map_or_else(|| "none".to_owned(), |number| format!("_ => [({number})]"));
        format!("#math.equation(block: true, numbering: {number}, $ {} $)", formula(tex))
    }

    fn strong(&self, inside: &str) -> String {
        format!("#strong[{inside}];")
    }

    fn code(&self, text: &str) -> String {
        format!("#raw({});", string(text))
    }

    fn line(&self, line: &str) -> String {
        string(line)
    }

    fn picture(&self, picture: &Picture, caption: &str) -> (String, Option<File>) {
        let name = format!("{}.svg", picture.name);
        let text = svg(&picture.figure, caption);
        let set = format!("#drawing({}, {:.1}mm, {})", string(&name), picture.figure.width, string(caption));
        (set, Some(File { name, text }))
    }

    fn is_print(&self) -> bool {
        true
    }
}

/// Text in which some signs are no more than signs, nor those that would make a line an entry of a list or a heading.
fn escaped(text: &str, acts: fn(char) -> bool) -> String {
    let begin = text.len() - text.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == ' ').len();
    let set = |(at, sign): (usize, char)| match acts(sign) || at == begin && "=+-.".contains(sign) {
        true => format!("\\{sign}"),
        false => sign.to_string(),
    };
    text.char_indices().map(set).collect()
}

/// A text as a value of Typst's language.
fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A formula in the notation of Typst.
fn formula(tex: &str) -> String {
    printed(&tex::read(tex)).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Letters apart, for two together would be a name, and no sign that acts.
fn printed(nodes: &[Node]) -> String {
    let mut out = String::new();
    for node in nodes {
        let set = match node {
            Node::Raised(inside) | Node::Lowered(inside) => {
                out.truncate(out.trim_end().len());
                script(&out, node, inside)
            }
            Node::Sign(digit) if digit.is_ascii_digit() || *digit == '.' => digit.to_string(),
            Node::Sign(sign) => format!(" {} ", self::sign(*sign)),
            Node::Relation(sign) => format!(" {sign} "),
            Node::Function(name) => format!(" op({}) ", string(name)),
            Node::Blank => " ".to_owned(),
            Node::Space(Space::Thin) => " thin ".to_owned(),
            Node::Space(Space::Word) => " med ".to_owned(),
            Node::Space(Space::Thick) => " thick ".to_owned(),
            Node::Space(Space::Quad) => " quad ".to_owned(),
            Node::Space(Space::Wide) => " wide ".to_owned(),
            Node::Column => " & ".to_owned(),
            Node::Line => " \\ ".to_owned(),
            Node::Fraction { small: false, above, below } => format!(" frac({}, {}) ", inner(above), inner(below)),
            Node::Fraction { small: true, above, below } => {
                format!(" inline(frac({}, {})) ", inner(above), inner(below))
            }
            Node::Binomial(above, below) => format!(" binom({}, {}) ", inner(above), inner(below)),
            Node::Root(inside) => format!(" sqrt({}) ", inner(inside)),
            Node::Upright(inside) => format!(" upright({}) ", inner(inside)),
            Node::Accent(accent, inside) => {
                format!(" accent({}, \"\\u{{{:x}}}\") ", inner(inside), u32::from(*accent))
            }
            Node::Fenced(open, inside, close) => {
                format!(" lr({}{}{}) ", self::sign(*open), printed(inside), self::sign(*close))
            }
            Node::Modulo(inside) => format!(" med med \\( mod {} \\) ", printed(inside)),
        };
        out.push_str(&set);
    }
    out
}

/// What is above or below: degrees are a sign of their own, and a script with nothing before it hangs on nothing.
fn script(before: &str, node: &Node, inside: &[Node]) -> String {
    let base = if before.is_empty() || before.ends_with(['\\', '&']) { "\"\"" } else { "" };
    match (node, inside) {
        (Node::Raised(_), [Node::Sign('°')]) => "°".to_owned(),
        (Node::Lowered(_), _) => format!("{base}_({}) ", inner(inside)),
        _ => format!("{base}^({}) ", inner(inside)),
    }
}

/// What a function takes: nothing as an empty text, which it may not lack.
fn inner(nodes: &[Node]) -> String {
    let set = printed(nodes);
    if set.trim().is_empty() { "\"\"".to_owned() } else { set.trim().to_owned() }
}

/// A sign that is no more than a sign.
fn sign(sign: char) -> String {
    match sign {
        '+' | '=' => sign.to_string(),
        _ if sign.is_ascii_punctuation() => format!("\\{sign}"),
        _ => sign.to_string(),
    }
}
