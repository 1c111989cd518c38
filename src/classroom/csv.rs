//! How is a table of several students read from a spreadsheet? Fields between commas, semicolons or tabs, in quotes where need be.

/// A line of the file: its number from 1, and its fields.
type Line = (usize, Vec<String>);

/// The lines with something on them. What separates fields is what the first line has most of.
pub(super) fn lines(text: &str) -> Vec<Line> {
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().next().unwrap_or_default();
    let count = |separator: &char| first.matches(*separator).count();
    // Of equally many the first counts: a comma.
    let separator = [';', '\t', ','].into_iter().max_by_key(count).unwrap_or(',');
    let mut lines: Vec<Line> = Vec::new();
    let (mut fields, mut field, mut quoted) = (Vec::new(), String::new(), false);
    let (mut number, mut begun) = (1, 1);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                letters.next();
                field.push('"');
            }
            '"' if quoted => quoted = false,
            '"' if field.trim().is_empty() => {
                field.clear();
                quoted = true;
            }
            '\n' => {
                number += 1;
                if quoted {
                    field.push(' ');
                    continue;
                }
                fields.push(std::mem::take(&mut field));
                lines.push((begun, std::mem::take(&mut fields)));
                begun = number;
            }
            letter if letter == separator && !quoted => fields.push(std::mem::take(&mut field)),
            letter => field.push(letter),
        }
    }
    fields.push(field);
    lines.push((begun, fields));
    lines.iter_mut().flat_map(|(_, fields)| fields).for_each(|field| *field = field.trim().to_owned());
    lines.retain(|(_, fields)| fields.iter().any(|field| !field.is_empty()));
    lines
}
