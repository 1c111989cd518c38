//! Is a formula the same where there is no TeX?

use crankstar::page::{Format, Text, text_in};

#[test]
fn formulas_read_the_same_in_plain_text_and_in_typst() {
    for (tex, plain, typst) in [
        (r"P_{2}^{+} = 0", "P₂⁺ = 0", "P_(2)^(+) = 0"),
        (r"\tfrac{3\sqrt{2} - 1}{4}", "(3√2 − 1)/4", "inline(frac(3 sqrt(2) − 1, 4))"),
        (r"\tfrac12\, r", "½ r", "inline(frac(1, 2)) thin r"),
        (r"\left|C_1\right|^2", "|C₁|²", r"lr(\| C_(1) \|)^(2)"),
        (r"\lvert a\rvert \ne 0", "|a| ≠ 0", r"lr(\| a \|) ≠ 0"),
        (r"\cos\left(2 \cdot 90^{\circ}\right)", "cos(2 ·90°)", r#"op("cos") lr(\(2 · 90°\))"#),
        (r"3 \not\equiv 0 \pmod{13}", "3 ≢ 0 (mod 13)", r"3 ≢ 0 med med \( mod 13 \)"),
        (r"\hat F_{1}\ \mathrm{N\,m}", "F\u{302}₁ N m", r#"accent(F, "\u{302}")_(1) med upright(N thin m)"#),
        (r"\binom{-1/2}{j}", "(−1/2 over j)", r"binom(− 1 \/ 2, j)"),
    ] {
        let text = Text::formula(tex);
        assert_eq!(text_in(&text, Format::PLAIN), plain, "{tex}");
        assert_eq!(text_in(&text, Format::Typst), format!("${typst}$"), "{tex}");
    }
}

/// Whatever is written, nothing in it ends the formula.
#[test]
fn no_sign_of_a_formula_acts_in_typst() {
    for tex in [
        "}",
        "{",
        "\\",
        "^",
        "_",
        "\\frac",
        "a^",
        "\\left",
        "\\sqrt{}",
        "$",
        "\"",
        "#x",
        "a, b; c: d",
        "'",
        "//",
        "\\unknown{x}",
    ] {
        let typst = text_in(&Text::formula(tex), Format::Typst);
        let plain = typst.trim_matches('$').replace("\\$", "").replace("\\#", "").replace("\\\"", "");
        assert!(!plain.contains(['$', '#']) && plain.matches('"').count().is_multiple_of(2), "{tex}: {typst}");
    }
}
