//! The examples of a Markdown page: blocks of `console`, in which a line after `$ ` is a command, and what follows is what it prints.

use crate::support::program;

/// A command, and what the page says that it prints; a line `...` stands for any lines.
pub struct Example {
    pub command: String,
    pub printed: String,
}

/// The examples of a page, in the order in which they stand.
pub fn examples(page: &str) -> Vec<Example> {
    let mut found: Vec<Example> = Vec::new();
    for block in page.split("\n```console\n").skip(1) {
        let block = block.split_once("\n```").expect("a block ends").0;
        assert!(block.starts_with("$ "), "a block of console starts with its command: {block}");
        for line in block.lines() {
            match (line.strip_prefix("$ "), found.last_mut()) {
                (Some(command), _) => found.push(Example { command: command.to_owned(), printed: String::new() }),
                (None, Some(last)) => last.printed += &format!("{line}\n"),
                (None, None) => unreachable!("a block starts with a command"),
            }
        }
    }
    found
}

impl Example {
    /// The words after the name of the program; quotes hold words together.
    pub fn arguments(&self) -> Vec<String> {
        let rest = self.command.strip_prefix("crankstar ").expect("an example calls crankstar");
        let mut words = vec![String::new()];
        let mut quote = None;
        for letter in rest.chars() {
            match (letter, quote) {
                ('\'' | '"', None) => quote = Some(letter),
                (_, Some(open)) if open == letter => quote = None,
                (' ', None) => words.push(String::new()),
                _ => words.last_mut().expect("a word").push(letter),
            }
        }
        words.retain(|word| !word.is_empty());
        words
    }

    /// What the program prints, which has to end well.
    pub fn run(&self) -> String {
        let output = program::call(&self.arguments());
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "$ {}\n{errors}", self.command);
        String::from_utf8(output.stdout).expect("UTF-8") + &errors
    }
}

/// Whether a text has the lines of a pattern, in which `...` stands for any lines. Spaces at ends of lines and empty last lines are as good as none.
pub fn matches(pattern: &str, text: &str) -> bool {
    let lines = |text: &str| text.trim_end().lines().map(|line| line.trim_end().to_owned()).collect::<Vec<_>>();
    fn fits(pattern: &[String], text: &[String]) -> bool {
        match pattern.split_first() {
            None => text.is_empty(),
            Some((any, rest)) if any == "..." => (0..=text.len()).any(|from| fits(rest, &text[from..])),
            Some((line, rest)) => text.first() == Some(line) && fits(rest, &text[1..]),
        }
    }
    fits(&lines(pattern), &lines(text))
}
