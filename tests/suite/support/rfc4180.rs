//! A table in CSV, read as RFC 4180 says, by no line of the program.

/// The first record and those that follow; each has as many fields.
pub fn read(text: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let mut records = vec![vec![String::new()]];
    let mut letters = text.chars().peekable();
    let mut quoted = false;
    while let Some(letter) = letters.next() {
        let record = records.last_mut().expect("a record");
        let field = record.last_mut().expect("a field");
        match letter {
            '"' if quoted && letters.next_if_eq(&'"').is_some() => field.push('"'),
            '"' if quoted => {
                quoted = false;
                assert!(matches!(letters.peek(), None | Some(',' | '\r' | '\n')), "a quote inside of a field");
            }
            '"' => {
                assert!(field.is_empty(), "a quote inside of a field");
                quoted = true;
            }
            ',' if !quoted => record.push(String::new()),
            '\r' if !quoted => assert_eq!(letters.peek(), Some(&'\n'), "a line ends half"),
            '\n' if !quoted => records.push(vec![String::new()]),
            _ => field.push(letter),
        }
    }
    assert!(!quoted, "a quote is not closed");
    // What ends with a line has no record after it.
    if records.last().is_some_and(|last| last == &[""]) {
        records.pop();
    }
    let header = records.remove(0);
    assert!(records.iter().all(|record| record.len() == header.len()), "a record has too few fields, or too many");
    (header, records)
}
