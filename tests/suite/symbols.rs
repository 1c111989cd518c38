//! Are the symbols of a page those of the reader: in formulas, in words, in drawings, and nowhere the old ones?

use crankstar::file::{Layout, parse_layout};
use crankstar::page::{self, Document, Format, Options, Symbols};
use crankstar::{family, report};

use crate::support::pages::{DOLLARS, document};
use crate::support::program::{call, scratch};
use crate::support::written::engine;

/// Every symbol gets a letter that no page has.
const NOTATION: &str = r#"
[symbols]
alpha = "\\tau"
beta = "\\chi"
gamma = { tex = "\\hat\\kappa", text = "kap" }
delta = "\\eta"
theta = "\\vartheta"
lambda = "\\mu"
rho = "\\iota"
phi = "\\Phi"
psi = "\\xi"
omega = "\\Omega"
c_k = "b_k"
t_k = "\\zeta_k"
C_k = "\\Psi_{k}"
F_k = "\\mathbf{A}"
M_k = "B_k"
P_k = "\\Pi_k"
Q_k = "D_k"
V_k = "W_k"
"#;

/// Where an old symbol would be read, without the file of the person at the end and without certificates.
const OLD: [&str; 10] = ["α", "β", "γ", "δ", "θ", "λ", "ρ", "φ", "ψ", "ω"];
const OLD_TEX: [&str; 9] =
    ["\\alpha", "\\beta", "\\gamma", "\\delta", "\\theta", "\\lambda", "\\varphi", "\\psi", "\\omega"];
const OLD_INDEXED: [&str; 8] = ["c_k", "c_{", "P_k", "P_{", "Q_k", "V_k", "P⁺", "P^{+}"];

fn symbols(text: &str) -> Symbols {
    Symbols::read("symbols.toml", text).expect("it reads")
}

fn pages() -> Vec<Document> {
    let with_numbers = include_str!("../../reports/examples/v8-small-block/layout.toml");
    let with_torque = include_str!("../../reports/examples/marine-i4/layout.toml");
    let open = include_str!("../../reports/families/v6-split-pins/layout.toml");
    let Layout::Open(open) = parse_layout("layout.toml", open).expect("it reads") else { panic!("it is a family") };
    let verdicts = family::classify(&open, open.orders()).expect("orders");
    vec![document(&engine(with_numbers)), document(&engine(with_torque)), report::family_page(&open, &verdicts, true)]
}

/// A page up to the file of the person, which nobody renames.
fn without_file(mut page: Document) -> Document {
    page.blocks.retain(|block| !matches!(block, page::Block::Verbatim(..)));
    page
}

#[test]
fn no_old_symbol_is_left_on_a_page_in_any_format() {
    let options = Options { symbols: symbols(NOTATION), ..Options::default() };
    for page in pages().into_iter().map(without_file) {
        for format in [Format::GITHUB, DOLLARS, Format::Latex, Format::Html, Format::Typst, Format::PLAIN] {
            for file in page::write(&page, format, &options) {
                let place = |old: &str| {
                    let at = file.text.find(old)?;
                    Some(
                        file.text[..at].lines().last().unwrap_or_default().to_owned()
                            + &file.text[at..].chars().take(40).collect::<String>(),
                    )
                };
                for old in OLD.into_iter().chain(OLD_TEX).chain(OLD_INDEXED) {
                    assert_eq!(place(old), None, "{old} in {} as {format:?}", file.name);
                }
            }
        }
    }
}

#[test]
fn without_a_file_each_page_is_as_it_was() {
    for page in pages() {
        let same = Options { symbols: symbols("[symbols]\nbeta = \"\\\\beta\""), ..Options::default() };
        assert_eq!(page::write(&page, Format::Latex, &same), page::write(&page, Format::Latex, &Options::default()));
    }
}

#[test]
fn symbols_that_change_places_are_renamed_at_once() {
    let swapped = symbols("[symbols]\nalpha = \"\\\\beta\"\nbeta = \"\\\\alpha\"\n");
    let options = Options { symbols: swapped, ..Options::default() };
    let text = page::write(&pages().remove(0), DOLLARS, &options).remove(0).text;
    assert!(text.contains("e^{i(k\\alpha_j - (k-1)\\beta_j)}"), "{text}");
}

#[test]
fn a_name_in_words_may_be_given_by_itself() {
    let given = symbols("[symbols]\nlambda = { tex = \"\\\\mu\", text = \"mu\" }\n");
    let options = Options { symbols: given, ..Options::default() };
    let text = page::write(&pages().remove(0), Format::PLAIN, &options).remove(0).text;
    assert!(text.contains("mu/2 of m r ω²") || text.contains(" mu "), "{text}");
}

fn refused(text: &str) -> String {
    Symbols::read("symbols.toml", text).expect_err("it is refused").to_string()
}

#[test]
fn a_name_that_is_none_is_told_with_its_place() {
    let cases = [
        ("[symbols]\nbeta = \"\\\\input{x}\"", "`\\input{x}` cannot be the name of a symbol"),
        ("[symbols]\nbeta = \"$x$\"", "cannot be the name"),
        ("[symbols]\nbeta = \"\"", "cannot be the name"),
        ("[symbols]\nbeta = \"\\\\\"", "cannot be the name"),
        ("[symbols]\nbeta = \"\\\\hat{\"", "cannot be the name"),
        ("[symbols]\nbeta = \"bé\"", "cannot be the name"),
        ("[symbols]\nbeta = 5", "cannot be the name"),
        ("[symbols]\nbeta = { tex = \"\\\\chi\", text = \"<b>\" }", "cannot stand for a symbol in words"),
        ("[symbols]\nbeta = { tex = \"\\\\chi\", text = \"a very long name\" }", "at most eight letters"),
        ("[symbols]\nbeta = [1]", "expected a text in quotes"),
        ("[symbols]\nzeta = \"x\"", "unknown key `zeta`"),
        ("[names]\nbeta = \"x\"", "unknown key `names`"),
        ("[symbols", "unclosed table"),
    ];
    for (text, words) in cases {
        let told = refused(text);
        assert!(told.contains(words) && told.contains("symbols.toml"), "{text}\n{told}");
    }
}

#[test]
fn two_symbols_do_not_share_a_name() {
    let told = refused("[symbols]\nbeta = \"\\\\psi\"");
    assert!(told.contains("the name of beta and of psi") && told.contains("symbols.toml:2:8"), "{told}");
    assert!(refused("[symbols]\nalpha = \"\\\\chi\"\nbeta = \"\\\\chi\"").contains("alpha has it already"));
    assert!(refused("[symbols]\nbeta = \"r\"").contains("another quantity"));
    let both = symbols("[symbols]\nbeta = \"\\\\psi\"\npsi = \"\\\\chi\"");
    assert!(!both.is_empty());
}

#[test]
fn a_mistake_in_the_file_ends_the_command_and_a_right_one_reaches_terminal_and_figure() {
    let folder = scratch("symbols");
    let file = folder.join("symbols.toml");
    let name = file.to_str().expect("a path in UTF-8");
    std::fs::write(&file, "[symbols]\nbeta = 5").expect("a file");
    let told = call(&["report", "I4", "--symbols", name]);
    assert_eq!(told.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&told.stderr).contains("beta = 5"));
    std::fs::write(&file, "[symbols]\nomega = \"\\\\Omega\"\ntheta = \"\\\\vartheta\"").expect("a file");
    let report = call(&["report", "I4", "--symbols", name, "--format", "text"]);
    let report = String::from_utf8_lossy(&report.stdout).into_owned();
    assert!(report.contains('Ω') && !report.contains('ω'), "{report}");
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples/marine-i4/layout.toml");
    let figure = call(&["figure", layout, "force-along", "--symbols", name, "--format", "tikz"]);
    assert!(String::from_utf8_lossy(&figure.stdout).contains("Crank angle $\\vartheta$ in"));
}
