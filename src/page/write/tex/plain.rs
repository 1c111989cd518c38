//! How does a formula read where there is no TeX? As plain text: `2√10`, `P₂⁺ = 0`, `½(|P⁺| + |P⁻|)`.

use super::Node;
use crate::text::SUPERSCRIPTS;

/// A formula of this program as plain text.
pub(in super::super) fn plain(tex: &str) -> String {
    printed(&super::read(tex)).split_whitespace().collect::<Vec<_>>().join(" ")
}

fn printed(nodes: &[Node]) -> String {
    let mut out = String::new();
    let mut rest = nodes.iter();
    while let Some(node) = rest.next() {
        match node {
            Node::Sign('∑') => out.push('Σ'),
            Node::Sign(sign) => out.push(*sign),
            Node::Relation('∣') => out.push_str(" | "),
            Node::Relation(sign) => out.extend([' ', *sign, ' ']),
            Node::Function(name) => {
                let bracket = matches!(rest.as_slice().first(), Some(Node::Sign('(') | Node::Fenced('(', ..)));
                out.push_str(name);
                out.push_str(if bracket { "" } else { " " });
            }
            Node::Blank | Node::Space(_) | Node::Line => out.push(' '),
            Node::Column => {}
            Node::Fraction { above, below, .. } => match (printed(above).as_str(), printed(below).as_str()) {
                ("1", "2") => out.push('½'),
                (above, below) => out.extend([&bracketed(above), "/", &bracketed(below)]),
            },
            Node::Binomial(above, below) => {
                out.extend(["(", &printed(above), " over ", &printed(below), ")"]);
            }
            Node::Root(inside) => out.extend(["√", &bracketed(&printed(inside))]),
            Node::Upright(inside) => out.push_str(&printed(inside)),
            Node::Accent(accent, inside) => {
                out.push_str(&printed(inside));
                out.push(*accent);
            }
            Node::Raised(inside) => out.push_str(&raised(&printed(inside))),
            Node::Lowered(inside) => out.push_str(&lowered(&printed(inside))),
            Node::Fenced(open, inside, close) => {
                out.push(*open);
                out.push_str(&printed(inside));
                out.push(*close);
            }
            Node::Modulo(inside) => out.extend([" (mod ", &printed(inside), ")"]),
        }
    }
    out
}

/// In brackets, where it is more than one number or sign.
fn bracketed(text: &str) -> String {
    let text = text.trim();
    match text.chars().count() == 1 || text.chars().all(|letter| letter.is_ascii_digit() || letter == '.') {
        true => text.to_owned(),
        false => format!("({text})"),
    }
}

fn raised(text: &str) -> String {
    scripted(text, '^', |letter| match letter {
        '+' => Some('⁺'),
        '−' => Some('⁻'),
        '°' => Some('°'),
        digit => digit.to_digit(10).map(|digit| SUPERSCRIPTS[digit as usize]),
    })
}

fn lowered(text: &str) -> String {
    scripted(text, '_', |digit| char::from_u32(u32::from('₀') + digit.to_digit(10)?))
}

/// In small signs; behind a mark where there is none for one of its letters.
fn scripted(text: &str, mark: char, sign: fn(char) -> Option<char>) -> String {
    let signs: Option<String> = text.chars().map(sign).collect();
    signs.unwrap_or_else(|| format!("{mark}{}", bracketed(text)))
}
