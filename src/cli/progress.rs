//! How is a person told that a long command still works? On a terminal only, on standard error.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of so many pieces with the time left.
pub fn bar(pieces: &str) -> ProgressBar {
    with_style(&format!("{{bar:40}} {{pos}}/{{len}} {pieces}, {{eta}} left"))
}

/// What is being done, and for how long, where no number of pieces is known.
pub fn spinner(words: &'static str) -> ProgressBar {
    let spinner = with_style("{spinner} {msg}, {elapsed}").with_message(words);
    if !spinner.is_hidden() {
        spinner.enable_steady_tick(Duration::from_millis(200));
    }
    spinner
}

fn with_style(template: &str) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(template);
    style.map_or_else(|_| ProgressBar::new(0), |style| ProgressBar::new(0).with_style(style))
}
