//! How is a table of several students read from a spreadsheet? Fields between commas, semicolons or tabs, in quotes where need be.

/// A row of the table: its number in the file, from 1, and its fields.
pub(super) type Row = (usize, Vec<String>);

/// The rows of a text with something on them. What separates fields is what the first line has most of.
///
/// A quotation ends on its own line, so that a quote without a partner costs no other row.
pub(super) fn rows(text: &str) -> Vec<Row> {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    // A first line that tells a spreadsheet what separates fields.
    let lines = || (1..).zip(text.lines()).skip(usize::from(text.starts_with("sep=")));
    let first = lines().next().map_or("", |(_, line)| line);
    let count = |separator: &char| first.matches(*separator).count();
    // Of equally many the first counts: a comma.
    let separator = [';', '\t', ','].into_iter().max_by_key(count).unwrap_or(',');
    filled(lines().map(|(number, line)| (number, fields(line, separator))))
}

/// The rows with something on them, without spaces round their fields.
pub(super) fn filled(rows: impl Iterator<Item = Row>) -> Vec<Row> {
    let trimmed = |fields: Vec<String>| fields.iter().map(|field| field.trim().to_owned()).collect::<Vec<_>>();
    let rows = rows.map(|(number, fields)| (number, trimmed(fields)));
    rows.filter(|(_, fields)| fields.iter().any(|field| !field.is_empty())).collect()
}

/// The fields of a line.
fn fields(line: &str, separator: char) -> Vec<String> {
    let mut fields = Vec::new();
    let mut rest = Some(line);
    while let Some(text) = rest {
        let (field, behind) = quotation(text, separator).unwrap_or_else(|| match text.split_once(separator) {
            Some((field, behind)) => (field.to_owned(), Some(behind)),
            None => (text.to_owned(), None),
        });
        fields.push(field);
        rest = behind;
    }
    fields
}

/// A field in quotes, and what is behind its separator; none where no quote closes it, which then is a sign like others.
fn quotation(text: &str, separator: char) -> Option<(String, Option<&str>)> {
    let mut rest = text.trim_start_matches(' ').strip_prefix('"')?;
    let mut field = String::new();
    loop {
        let (before, behind) = rest.split_once('"')?;
        field.push_str(before);
        if let Some(behind) = behind.strip_prefix('"') {
            field.push('"');
            rest = behind;
            continue;
        }
        let (tail, behind) = match behind.split_once(separator) {
            Some((tail, behind)) => (tail, Some(behind)),
            None => (behind, None),
        };
        return Some((field + tail, behind));
    }
}
