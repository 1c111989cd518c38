//! Which columns of a table are decimals, and how far are their points pushed to be below each other?

/// How many digits each cell of a column lacks before its point; 0 everywhere where the column has no two decimals.
pub(super) fn lacking(column: &[String]) -> Vec<usize> {
    let is_about = |cell: &String| cell.starts_with(ABOUT);
    match column.iter().any(is_about) {
        false => lacking_of(column),
        // An exact number beside decimals after ≈ stays where it is.
        true => lacking_of(
            &column.iter().map(|cell| cell.strip_prefix(ABOUT).unwrap_or_default().to_owned()).collect::<Vec<_>>(),
        ),
    }
}

/// What a rounded decimal begins with.
const ABOUT: &str = "≈\u{a0}";

fn lacking_of(column: &[String]) -> Vec<usize> {
    let before: Vec<Option<usize>> = column.iter().map(|cell| digits_before_the_point(cell)).collect();
    let points = column.iter().zip(&before).filter(|(cell, known)| known.is_some() && cell.contains(['.', ',']));
    let most = before.iter().flatten().max().copied().unwrap_or(0);
    match points.count() {
        0 | 1 => vec![0; column.len()],
        _ => before.into_iter().map(|digits| digits.map_or(0, |digits| most - digits)).collect(),
    }
}

/// The signs of a decimal before its point, its minus among them; none of what is no decimal. A unit may be behind it.
fn digits_before_the_point(cell: &str) -> Option<usize> {
    let unit =
        |(at, _): (usize, &str)| cell[at + '\u{202f}'.len_utf8()..].starts_with(char::is_alphabetic).then_some(at);
    let cell = cell.match_indices('\u{202f}').find_map(unit).map_or(cell, |at| &cell[..at]);
    let (number, power) = cell.split_once("·10").map_or((cell, ""), |(number, power)| (number, power));
    let (whole, part) = number.split_once(['.', ',']).unwrap_or((number, "0"));
    let is_digits = |text: &str| text.chars().all(|sign| sign.is_ascii_digit() || sign == '\u{202f}');
    let digits = whole.strip_prefix('−').unwrap_or(whole);
    let is_power = power.chars().all(|sign| sign == '⁻' || crate::text::SUPERSCRIPTS.contains(&sign));
    (!digits.is_empty() && is_digits(digits) && is_digits(part) && is_power).then(|| whole.chars().count())
}
