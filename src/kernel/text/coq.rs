//! How is a text written in a comment of Coq? Nothing in it begins or ends a comment or a string.

/// Plain text, anywhere in a comment: a star or a quote is shown as `[U+002A]`, and so comments cannot end or nest in it.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::text::coq_comment;
/// assert_eq!(coq_comment("V8 *) Axiom false : \"x\""), "V8 [U+002A]) Axiom false : [U+0022]x[U+0022]");
/// ```
pub fn coq_comment(text: &str) -> String {
    let mut out = String::new();
    for letter in super::harmless(text).chars() {
        match letter {
            '*' | '"' => out.push_str(&format!("[U+{:04X}]", u32::from(letter))),
            letter => out.push(letter),
        }
    }
    out
}
