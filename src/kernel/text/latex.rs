//! How is a text written in LaTeX? Its special characters as what they look like, and none that pdflatex would stop at.

use super::letters::TEX_LETTERS;

/// Longer words may be broken, after one of these signs.
const LONGEST_WORD: usize = 40;
const ENDS_OF_PARTS: [char; 6] = ['/', '.', '_', '-', '&', '='];

/// A person's text: signs that end a row or open an argument are no more than signs.
pub(super) fn quoted(text: &str) -> String {
    breakable(text, in_braces)
}

/// A text as it is written so, with places where a line may end in words, such as addresses, that are as long as a line.
pub fn breakable(text: &str, written: impl Fn(&str) -> String) -> String {
    let is_long = |word: &&str| word.chars().count() > LONGEST_WORD;
    let (mut out, mut rest) = (String::new(), text);
    // What stands between long words is written as a whole: it may hold formulas.
    while let Some(word) = rest.split(' ').find(is_long) {
        let (before, after) = rest.split_once(word).unwrap_or((rest, ""));
        out.push_str(&written(before));
        out.push_str(&word.split_inclusive(ENDS_OF_PARTS).map(&written).collect::<Vec<_>>().join("\\allowbreak{}"));
        rest = after;
    }
    out + &written(rest)
}

fn in_braces(text: &str) -> String {
    let mut out = String::new();
    for piece in text.split_inclusive(['[', ']', '*', '`']) {
        let sign = piece.chars().next_back().filter(|sign| "[]*`".contains(*sign));
        match sign {
            Some(sign) => out.push_str(&format!("{}{{{sign}}}", latex(&piece[..piece.len() - 1]))),
            None => out.push_str(&latex(piece)),
        }
    }
    out
}

/// The digits as exponents.
pub const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Letters beyond ÿ that the fonts of the encoding T1 have.
const OF_T1: &str = "ĂăĄąĆćČčĎďĐđĘęĚěĞğİıĹĺĽľŁłŃńŇňŊŋŐőŒœŔŕŘřŚśŞşŠšŢţŤťŮůŰűŸŹźŻżŽž";

/// Products of symbols, which are formulas in a text; what begins another stands after it.
const FORMULAS: [(&str, &str); 3] = [
    ("m r ω² c_k", "$m\\,r\\,\\omega^2 c_k$"),
    ("m r ω²", "$m\\,r\\,\\omega^2$"),
    ("m r² ω²", "$m\\,r^2\\,\\omega^2$"),
];

/// Plain text for pdflatex: its special characters, the signs that the reports use, and its formulas.
pub fn latex(text: &str) -> String {
    with_formulas(text, &FORMULAS)
}

fn with_formulas(text: &str, formulas: &[(&str, &str)]) -> String {
    match formulas {
        [] => signs(text),
        [(plain, set), others @ ..] => {
            text.split(plain).map(|part| with_formulas(part, others)).collect::<Vec<_>>().join(set)
        }
    }
}

fn signs(text: &str) -> String {
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
        if let Some((command, _)) = TEX_LETTERS.iter().find(|(_, sign)| *sign == letter) {
            out.push_str(&format!("$\\{command}$"));
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
            '\u{a0}' => "~",
            '≤' => "$\\le$",
            '≥' => "$\\ge$",
            '⁻' => "\\textsuperscript{--}",
            '→' => "$\\to$",
            '…' => "\\dots{}",
            '–' => "--",
            '—' => "\\textemdash{}",
            '€' => "\\texteuro{}",
            '∎' => "$\\blacksquare$",
            '„' => "\\quotedblbase{}",
            '“' => "``",
            '”' => "''",
            '‘' => "`",
            '’' => "'",
            '<' => "\\textless{}",
            '>' => "\\textgreater{}",
            '"' => "''",
            '∞' => "$\\infty$",
            '∥' => "$\\parallel$",
            '⊥' => "$\\perp$",
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                out.extend(['\\', letter]);
                continue;
            }
            _ if matches!(letter, ' '..='~' | '¡'..='ÿ') || OF_T1.contains(letter) => {
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
