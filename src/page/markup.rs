//! Where are the formulas, the bold words and the places for values in words of the program?
//!
//! Words are written once, as plain text with `$formulas$` in TeX, `**bold**` and `{}` where a value comes. Another language may
//! name the places, `{1}` and `{2}`, to have them in another order.

/// A part of such words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Mark<'a> {
    /// Plain words.
    Words(&'a str),
    /// A formula in TeX.
    Formula(&'a str),
    /// Bold begins, or ends.
    Bold,
    /// The next value, or that of a place counted from 0.
    Place(Option<usize>),
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
            for (words, place) in places(piece) {
                marks.extend((!words.is_empty()).then_some(Mark::Words(words)));
                marks.extend(place.map(Mark::Place));
            }
        }
    }
    marks
}

/// Plain words, each piece with the place behind it; the last has none.
pub(super) fn places(words: &str) -> Vec<(&str, Option<Option<usize>>)> {
    let mut out = Vec::new();
    let (mut rest, mut from) = (words, 0);
    while let Some(begin) = rest[from..].find('{').map(|begin| from + begin) {
        let inside = &rest[begin + 1..];
        let digits = inside.bytes().take_while(u8::is_ascii_digit).count();
        if !inside[digits..].starts_with('}') {
            from = begin + 1;
            continue;
        }
        let named = inside[..digits].parse::<usize>().ok().map(|place| place.saturating_sub(1));
        out.push((&rest[..begin], Some(named)));
        (rest, from) = (&inside[digits + 1..], 0);
    }
    out.push((rest, None));
    out
}
