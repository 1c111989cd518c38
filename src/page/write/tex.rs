//! How does a formula read where there is no TeX? As plain text: `2√10`, `P₂⁺ = 0`, `½(|P⁺| + |P⁻|)`.

use crate::page::symbols::letters::{accent, letter};
use crate::text::SUPERSCRIPTS;

/// A formula of this program as plain text.
pub(super) fn plain(tex: &str) -> String {
    let letters: Vec<char> = tex.chars().collect();
    let mut reader = Reader { letters: &letters, at: 0 };
    let text = reader.until(None);
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

struct Reader<'a> {
    letters: &'a [char],
    at: usize,
}

impl Reader<'_> {
    fn next(&mut self) -> Option<char> {
        let letter = self.letters.get(self.at).copied();
        self.at += 1;
        letter
    }

    fn until(&mut self, end: Option<char>) -> String {
        let mut out = String::new();
        while let Some(letter) = self.next() {
            match letter {
                _ if Some(letter) == end => break,
                '\\' => out.push_str(&self.command()),
                '{' => out.push_str(&self.until(Some('}'))),
                '^' => out.push_str(&raised(&self.argument())),
                '_' => out.push_str(&lowered(&self.argument())),
                '&' => {}
                '-' => out.push('−'),
                '~' => out.push(' '),
                other => out.push(other),
            }
        }
        out
    }

    /// What a command takes: a group, a command or a letter.
    fn argument(&mut self) -> String {
        match self.next() {
            Some('{') => self.until(Some('}')),
            Some('\\') => self.command(),
            Some('-') => "−".to_owned(),
            Some(' ') => self.argument(),
            Some(other) => other.to_string(),
            None => String::new(),
        }
    }

    fn command(&mut self) -> String {
        let start = self.at;
        while self.letters.get(self.at).is_some_and(char::is_ascii_alphabetic) {
            self.at += 1;
        }
        if self.at == start {
            // A sign: `\,`, `\\`, `\{`.
            return match self.next() {
                Some('!') | None => String::new(),
                Some(sign @ ('{' | '}' | '%' | '_' | '#' | '&' | '$')) => sign.to_string(),
                Some(_) => " ".to_owned(),
            };
        }
        let name: String = self.letters[start..self.at].iter().collect();
        // A space ends the command before letters and digits; before a sign it is one to be read.
        let follows = |ahead: usize| self.letters.get(self.at + ahead).copied();
        let ends =
            follows(0) == Some(' ') && follows(1).is_some_and(|letter| letter.is_alphanumeric() || letter == '\\');
        self.at += usize::from(ends);
        self.named(&name)
    }

    fn named(&mut self, name: &str) -> String {
        let sign = match name {
            "frac" | "tfrac" | "dfrac" => {
                let (above, below) = (self.argument(), self.argument());
                return if (above.as_str(), below.as_str()) == ("1", "2") {
                    "½".to_owned()
                } else {
                    format!("{}/{}", bracketed(&above), bracketed(&below))
                };
            }
            "binom" => {
                let (above, below) = (self.argument(), self.argument());
                return format!("({above} over {below})");
            }
            "sqrt" => return format!("√{}", bracketed(&self.argument())),
            "text" | "textbf" | "operatorname" => return self.argument(),
            "ddot" => return format!("{}\u{308}", self.argument()),
            "tag" => return format!("  ({})", self.argument()),
            "pmod" => return format!(" (mod {})", self.argument()),
            "begin" | "end" => {
                self.argument();
                return " ".to_owned();
            }
            "left" | "right" => return self.argument().replace('.', ""),
            "sum" => "Σ",
            "int" => "∫",
            "cdot" => "·",
            "times" => "×",
            "pm" => "±",
            "circ" => "°",
            "ne" | "neq" => " ≠ ",
            "le" => " ≤ ",
            "ge" => " ≥ ",
            "equiv" => " ≡ ",
            "approx" => " ≈ ",
            "mapsto" => " ↦ ",
            "to" => " → ",
            "nmid" => " ∤ ",
            "mid" => " | ",
            "lvert" | "rvert" | "vert" => "|",
            "parallel" => "∥",
            "perp" => "⊥",
            "dots" | "ldots" | "cdots" => "…",
            "quad" | "qquad" => "   ",
            "not" => return format!(" ≢ {}", self.argument().replace('≡', "").trim()),
            "cos" | "sin" | "arctan" | "arccos" => {
                return format!("{name}{}", if self.letters.get(self.at) == Some(&'(') { "" } else { " " });
            }
            // An open and a closed phi are one letter here.
            "phi" => "φ",
            "epsilon" => "ε",
            other => match accent(other) {
                Some(sign) => return format!("{}{sign}", self.argument()),
                None => letter(other).unwrap_or(other),
            },
        };
        sign.to_owned()
    }
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
    let sign = |letter: char| match letter {
        '+' => Some('⁺'),
        '−' => Some('⁻'),
        '°' => Some('°'),
        digit => digit.to_digit(10).map(|digit| SUPERSCRIPTS[digit as usize]),
    };
    match text.chars().map(sign).collect::<Option<String>>() {
        Some(signs) => signs,
        None => format!("^{}", bracketed(text)),
    }
}

fn lowered(text: &str) -> String {
    let sign = |letter: char| {
        let digit = letter.to_digit(10)?;
        char::from_u32(u32::from('₀') + digit)
    };
    match text.chars().map(sign).collect::<Option<String>>() {
        Some(signs) => signs,
        None => format!("_{}", bracketed(text)),
    }
}
