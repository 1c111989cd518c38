//! How does the same text read in Markdown and in LaTeX?
//!
//! Prose is written once, as plain text with `$formulas$` in TeX and `**bold**`, and put into a dialect here.

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

    /// A person's text: nothing in it is markup.
    pub fn quoted(self, text: &str) -> String {
        let one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        match self {
            Dialect::Latex => latex_text(&one_line),
            _ => markdown_escape(&one_line),
        }
    }

    /// A line of a file, word for word: spaces and signs as they stand.
    pub fn verbatim(self, line: &str) -> String {
        match self {
            Dialect::Latex => {
                if line.is_empty() {
                    return "~".to_owned();
                }
                let begin = line.len() - line.trim_start().len();
                let quotes: Vec<String> = line[begin..].split('"').map(latex_text).collect();
                format!("{}{}", "~".repeat(begin), quotes.join("\\textquotedbl{}").replace("  ", "~~"))
            }
            _ => line.to_owned(),
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
                    1 => format!("\\textbf{{{}}}", latex_text(piece)),
                    _ => latex_text(piece),
                };
                pieces.map(set).collect()
            }
            _ => text.to_owned(),
        }
    }
}

fn markdown_escape(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '|' | '$' | '~' | '!' | '&' => {
                out.push('\\');
                out.push(letter);
            }
            _ => out.push(letter),
        }
    }
    out
}

/// The digits as exponents.
pub(super) const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Plain text for pdflatex: its special characters, and the signs that the reports use.
pub(super) fn latex_text(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        if let Some(digit) = SUPERSCRIPTS.iter().position(|sign| *sign == letter) {
            out.push_str(&format!("\\textsuperscript{{{digit}}}"));
            continue;
        }
        if let Some(digit) = ('₀'..='₉').position(|sign| sign == letter) {
            out.push_str(&format!("\\textsubscript{{{digit}}}"));
            continue;
        }
        let sign = match letter {
            '\\' => "\\textbackslash{}",
            '~' => "\\textasciitilde{}",
            '^' => "\\textasciicircum{}",
            '°' => "\\textdegree{}",
            '·' => "$\\cdot$",
            '−' => "$-$",
            '±' => "$\\pm$",
            '≡' => "$\\equiv$",
            '≈' => "$\\approx$",
            '≠' => "$\\ne$",
            '×' => "$\\times$",
            '√' => "$\\surd$",
            '½' => "\\textonehalf{}",
            '⁺' => "\\textsuperscript{+}",
            '\u{202f}' => "\\,",
            '≤' => "$\\le$",
            '≥' => "$\\ge$",
            '⁻' => "\\textsuperscript{--}",
            '→' => "$\\to$",
            '…' => "\\dots{}",
            '–' => "--",
            '<' => "\\textless{}",
            '>' => "\\textgreater{}",
            '"' => "''",
            'α' => "$\\alpha$",
            'β' => "$\\beta$",
            'δ' => "$\\delta$",
            'γ' => "$\\gamma$",
            'λ' => "$\\lambda$",
            'ψ' => "$\\psi$",
            'θ' => "$\\theta$",
            'φ' => "$\\varphi$",
            'ω' => "$\\omega$",
            'Σ' => "$\\Sigma$",
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(letter);
                continue;
            }
            _ if letter.is_ascii_graphic() || letter == ' ' || ('¡'..='ÿ').contains(&letter) => {
                out.push(letter);
                continue;
            }
            // pdflatex would stop at a letter that it has no font for.
            _ => {
                out.push_str(&format!("[U+{:04X}]", u32::from(letter)));
                continue;
            }
        };
        out.push_str(sign);
    }
    out
}
