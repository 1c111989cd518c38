//! How is a formula read? The TeX that this program writes becomes a small tree, which a format without TeX prints in its own signs.

mod plain;

pub(super) use plain::plain;

use crate::page::symbols::letters::{accent, is_font, letter};

/// A part of a formula.
pub(super) enum Node<'a> {
    /// A letter, a digit, a sign.
    Sign(char),
    /// A sign between two sides.
    Relation(char),
    /// The name of a function.
    Function(&'a str),
    /// A space of the source, which formats that set formulas omit.
    Blank,
    /// A space that is set.
    Space(Space),
    /// Where the lines of a formula stand under each other.
    Column,
    /// A new line.
    Line,
    /// A fraction; small where it is among full letters.
    Fraction { small: bool, above: Vec<Node<'a>>, below: Vec<Node<'a>> },
    /// A binomial coefficient.
    Binomial(Vec<Node<'a>>, Vec<Node<'a>>),
    /// A square root.
    Root(Vec<Node<'a>>),
    /// Letters that stand upright: a unit, a name.
    Upright(Vec<Node<'a>>),
    /// Something under an accent, which is a combining character.
    Accent(char, Vec<Node<'a>>),
    /// Above and behind what stands before it.
    Raised(Vec<Node<'a>>),
    /// Below and behind what stands before it.
    Lowered(Vec<Node<'a>>),
    /// Between two signs as high as itself.
    Fenced(char, Vec<Node<'a>>, char),
    /// By which number remainders are taken.
    Modulo(Vec<Node<'a>>),
}

/// How wide a space is.
pub(super) enum Space {
    /// A sixth of an em.
    Thin,
    /// As between words.
    Word,
    /// As round a relation.
    Thick,
    /// An em.
    Quad,
    /// Two ems.
    Wide,
}

/// The parts of a formula.
pub(super) fn read(tex: &str) -> Vec<Node<'_>> {
    Reader { rest: tex }.until("")
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    /// A command with its backslash, or one sign.
    fn token(&mut self) -> Option<&'a str> {
        let first = self.rest.chars().next()?;
        let behind = &self.rest[first.len_utf8()..];
        let name = behind.len() - behind.trim_start_matches(|letter: char| letter.is_ascii_alphabetic()).len();
        let length = match first {
            '\\' if name > 0 => name,
            '\\' => behind.chars().next().map_or(0, char::len_utf8),
            _ => 0,
        };
        let (token, rest) = self.rest.split_at(first.len_utf8() + length);
        self.rest = rest;
        // A space ends a command before letters and digits; before a sign it is one to be read.
        if first == '\\' && name > 0 {
            let ended = rest.strip_prefix(' ');
            let ended = ended.filter(|next| next.starts_with(|next: char| next.is_alphanumeric() || next == '\\'));
            self.rest = ended.unwrap_or(rest);
        }
        Some(token)
    }

    fn until(&mut self, end: &str) -> Vec<Node<'a>> {
        let mut nodes = Vec::new();
        while let Some(token) = self.token().filter(|token| *token != end) {
            self.part(token, &mut nodes);
        }
        nodes
    }

    /// What a command takes: a group, a command or a sign.
    fn argument(&mut self) -> Vec<Node<'a>> {
        let mut nodes = Vec::new();
        while let Some(token) = self.token() {
            if token != " " {
                self.part(token, &mut nodes);
                break;
            }
        }
        nodes
    }

    /// The sign of a bracket.
    fn bracket(&mut self) -> char {
        self.token().and_then(|token| token.chars().last()).unwrap_or('|')
    }

    fn part(&mut self, token: &'a str, nodes: &mut Vec<Node<'a>>) {
        nodes.push(match token {
            "{" => return nodes.extend(self.until("}")),
            "\\begin" | "\\end" => {
                self.argument();
                Node::Blank
            }
            "^" => Node::Raised(self.argument()),
            "_" => Node::Lowered(self.argument()),
            "&" => Node::Column,
            "\\\\" => Node::Line,
            " " | "\n" => Node::Blank,
            "~" | "\\ " => Node::Space(Space::Word),
            "\\," => Node::Space(Space::Thin),
            "\\;" => Node::Space(Space::Thick),
            "\\quad" => Node::Space(Space::Quad),
            "\\qquad" => Node::Space(Space::Wide),
            "\\frac" => self.fraction(false),
            "\\tfrac" => self.fraction(true),
            "\\binom" => Node::Binomial(self.argument(), self.argument()),
            "\\sqrt" => Node::Root(self.argument()),
            // Here an open and a closed phi are one letter.
            "\\phi" => Node::Sign('φ'),
            "\\text" => Node::Upright(self.argument()),
            "\\pmod" => Node::Modulo(self.argument()),
            "\\lvert" => Node::Fenced('|', self.until("\\rvert"), '|'),
            "\\left" => Node::Fenced(self.bracket(), self.until("\\right"), self.bracket()),
            "\\not" => {
                self.argument();
                Node::Relation('≢')
            }
            other => {
                let name = other.strip_prefix('\\').unwrap_or_default();
                match (accent(name), letter(name)) {
                    (Some(sign), _) => Node::Accent(sign, self.argument()),
                    (None, Some(letter)) => Node::Sign(letter),
                    (None, None) if is_font(name) => Node::Upright(self.argument()),
                    (None, None) => named(other),
                }
            }
        });
    }

    fn fraction(&mut self, small: bool) -> Node<'a> {
        Node::Fraction { small, above: self.argument(), below: self.argument() }
    }
}

/// A sign, or a command that stands for one; a name that is not known here stands as a name.
fn named(token: &str) -> Node<'_> {
    Node::Sign(match token {
        "-" => '−',
        "\\sum" => '∑',
        "\\int" => '∫',
        "\\cdot" => '·',
        "\\times" => '×',
        "\\pm" => '±',
        "\\mp" => '∓',
        "\\circ" => '°',
        "\\parallel" => '∥',
        "\\perp" => '⊥',
        "\\dots" | "\\cdots" => '…',
        "\\ne" => return Node::Relation('≠'),
        "\\le" => return Node::Relation('≤'),
        "\\ge" => return Node::Relation('≥'),
        "\\equiv" => return Node::Relation('≡'),
        "\\approx" => return Node::Relation('≈'),
        "\\mapsto" => return Node::Relation('↦'),
        "\\to" => return Node::Relation('→'),
        "\\nmid" => return Node::Relation('∤'),
        "\\mid" => return Node::Relation('∣'),
        other => match (other.strip_prefix('\\'), other.chars().last()) {
            (Some(name), _) if name.starts_with(|letter: char| letter.is_ascii_alphabetic()) => {
                return Node::Function(name);
            }
            (_, Some(sign)) => sign,
            (_, None) => return Node::Blank,
        },
    })
}
