//! What do templates fill in: headings, folds, pictures, the document around them?

use serde::Serialize;

/// A heading.
#[derive(Clone, Serialize)]
pub(super) struct Heading {
    pub level: u8,
    pub text: String,
    /// The name that links lead to.
    pub id: String,
    pub number: usize,
    /// The label of a fragment.
    pub label: Option<String>,
}

/// What is folded.
#[derive(Serialize)]
pub(super) struct Folded {
    pub number: usize,
    pub summary: String,
    pub body: String,
    /// The label of a fragment.
    pub label: Option<String>,
    /// What print says before the numbers of where it is: `appendix`, of a fragment `section`, and `page`.
    pub place: [String; 2],
}

/// The document.
#[derive(Serialize)]
pub(super) struct PageContext<'a> {
    pub title: String,
    pub plain_title: String,
    pub contents: Vec<&'a Heading>,
    pub before: String,
    pub body: String,
    pub folds: &'a [Folded],
    pub stamp: Option<String>,
    pub fragment: bool,
    pub siunitx: bool,
    pub language: &'static str,
    pub hyphenation: &'static str,
    pub styles: &'a [&'static str],
    pub scripts: Vec<String>,
}

/// A picture.
#[derive(Serialize)]
pub(super) struct Drawn {
    pub body: String,
    pub caption: String,
    /// Its first sentence, where there are more.
    pub short: Option<String>,
    /// The label of a fragment.
    pub label: Option<String>,
    /// Whether its letters are too small in half of a page.
    pub spread: bool,
}

/// The name of a heading, as code-hosting pages make it.
pub(super) fn id(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

/// Backticks that no run in the file is as long as.
pub(super) fn fence(lines: &[String]) -> String {
    let runs = lines.iter().flat_map(|line| line.split(|letter| letter != '`'));
    let longest = runs.map(str::len).max().unwrap_or(0);
    "`".repeat((longest + 1).max(3))
}
