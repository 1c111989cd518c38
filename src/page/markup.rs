//! Where are the formulas, the bold words and the places for values in words of the program?
//!
//! Words are written once, as plain text with `$formulas$` in TeX, `**bold**` and `{}` where a value comes. Another language may
//! name the places, `{1}` and `{2}`, to have them in another order. `{with|against}` is a place whose value chooses one of these words;
//! named, `{1:with|against}`.

/// A part of such words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Mark<'a> {
    /// Plain words.
    Words(&'a str),
    /// A formula in TeX.
    Formula(&'a str),
    /// Bold begins, or ends.
    Bold,
    /// Where a value comes.
    Place(Place<'a>),
}

/// Where a value comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place<'a> {
    /// Which value, counted from 0; the next one if none.
    pub value: Option<usize>,
    /// The words of which the value chooses one, with `|` between them.
    words: Option<&'a str>,
}

impl<'a> Place<'a> {
    /// A place by what is between its braces; none of other braces.
    fn of(inside: &'a str) -> Option<Self> {
        let number = |name: &str| name.parse::<usize>().ok().map(|place| place.saturating_sub(1));
        if !inside.contains('|') {
            let is_place = inside.bytes().all(|byte| byte.is_ascii_digit());
            return is_place.then(|| Place { value: number(inside), words: None });
        }
        let named = inside.split_once(':').and_then(|(name, words)| Some((Some(number(name)?), words)));
        let (value, words) = named.unwrap_or((None, inside));
        Some(Place { value, words: Some(words) })
    }

    /// The words that a value chooses here.
    pub fn chosen(&self, choice: usize) -> Option<&'a str> {
        self.words?.split('|').nth(choice)
    }
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
pub(super) fn places(words: &str) -> Vec<(&str, Option<Place<'_>>)> {
    let mut out = Vec::new();
    let (mut rest, mut from) = (words, 0);
    while let Some(begin) = rest[from..].find('{').map(|begin| from + begin) {
        let inside = rest[begin + 1..].split_once('}').map(|(inside, _)| inside);
        let Some((inside, place)) = inside.and_then(|inside| Some((inside, Place::of(inside)?))) else {
            from = begin + 1;
            continue;
        };
        out.push((&rest[..begin], Some(place)));
        (rest, from) = (&rest[begin + inside.len() + 2..], 0);
    }
    out.push((rest, None));
    out
}
