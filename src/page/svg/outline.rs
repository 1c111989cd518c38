//! How is an outline written as data of a path? To a hundredth of a millimetre, a twentieth of a pixel: more is not seen.

use super::super::figure::Point;

/// A number in hundredths; 0 for what is none, and a kilometre at most.
fn hundredths(value: f64) -> i64 {
    if value.is_finite() { (value * 100.0).clamp(-1e8, 1e8).round() as i64 } else { 0 }
}

/// Hundredths as text: no zero that says nothing.
fn written(hundredths: i64) -> String {
    let size = hundredths.unsigned_abs();
    let (whole, part) = (size / 100, size % 100);
    let part = if part == 0 { String::new() } else { format!(".{part:02}").trim_end_matches('0').to_owned() };
    match (hundredths < 0, whole, part.as_str()) {
        (_, 0, "") => "0".to_owned(),
        (true, 0, _) => format!("-{part}"),
        (true, ..) => format!("-{whole}{part}"),
        (false, 0, _) => part,
        (false, ..) => format!("{whole}{part}"),
    }
}

/// A length or a place as text.
pub fn number(value: f64) -> String {
    written(hundredths(value))
}

/// A line through points, y upwards below this height, closed or not. Each point is written from the one before, which is shorter; they are
/// rounded first, so that errors do not add.
pub fn outline(points: &[Point], height: f64, is_closed: bool) -> String {
    let mut out = String::new();
    let mut before: Option<(i64, i64)> = None;
    for point in points {
        let (x, y) = (hundredths(point.re), hundredths(height - point.im));
        let (word, numbers) = match before {
            None => ('M', vec![x, y]),
            Some((_, at)) if at == y => ('h', vec![x - before.map_or(0, |(x, _)| x)]),
            Some((at, _)) if at == x => ('v', vec![y - before.map_or(0, |(_, y)| y)]),
            Some((from_x, from_y)) => ('l', vec![x - from_x, y - from_y]),
        };
        push(&mut out, word, &numbers);
        before = Some((x, y));
    }
    if is_closed {
        out.push('z');
    }
    out
}

/// A rectangle with its sides along the page.
pub fn rectangle(low: Point, high: Point, height: f64) -> String {
    let corners = [Point::new(low.re, high.im), high, Point::new(high.re, low.im), low];
    outline(&corners, height, true)
}

/// A command with its numbers; the word is omitted where it is that of the command before.
fn push(out: &mut String, word: char, numbers: &[i64]) {
    let last = out.rfind(|letter: char| letter.is_ascii_alphabetic()).map(|at| out[at..].chars().next());
    let is_same = last.flatten() == Some(word) && word != 'M';
    if !is_same {
        out.push(word);
    }
    for (place, value) in numbers.iter().enumerate() {
        if (is_same || place > 0) && *value >= 0 {
            out.push(' ');
        }
        out.push_str(&written(*value));
    }
}
