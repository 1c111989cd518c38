//! Where are the formulas, the bold words and the places for values in words of the program?
//!
//! Words are written once, as plain text with `$formulas$` in TeX, `**bold**` and `{}` where a value comes.

/// A part of such words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Mark<'a> {
    /// Plain words.
    Words(&'a str),
    /// A formula in TeX.
    Formula(&'a str),
    /// Bold begins, or ends.
    Bold,
    /// The next value.
    Place,
}

/// The parts in their order.
pub(super) fn marks(words: &str) -> Vec<Mark<'_>> {
    let mut marks = Vec::new();
    for (index, piece) in words.split('$').enumerate() {
        if index % 2 == 1 {
            marks.push(Mark::Formula(piece));
            continue;
        }
        for (index, piece) in piece.split("**").enumerate() {
            marks.extend((index > 0).then_some(Mark::Bold));
            for (index, piece) in piece.split("{}").enumerate() {
                marks.extend((index > 0).then_some(Mark::Place));
                marks.extend((!piece.is_empty()).then_some(Mark::Words(piece)));
            }
        }
    }
    marks
}
