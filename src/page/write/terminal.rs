//! Which signs does a terminal show? Plain text in lines that fit, tables ruled under their head, zeros in colour where there are colours.

use comfy_table::{Cell, ColumnConstraint, ContentArrangement, LineStyle, Table, TableStyle, Width};

use super::super::block::Picture;
use super::columns::Cells;
use super::writer::{File, Writer};
use super::{templates, tex};
use crate::text::{Format, Untrusted};

/// Plain text of this many columns.
pub(super) struct Terminal {
    pub width: usize,
    pub colour: bool,
    /// Whether formulas hold together as one word: for measuring.
    pub unbroken: bool,
}

/// Blank columns beside the words of a cell.
const PADDING: usize = 2;
/// Columns that a column takes beside its words: one more than those, where it meets the next.
const GAP: usize = PADDING + 1;

impl Terminal {
    /// Some columns of a table, each of the width that is given with it.
    fn part(&self, cells: &Cells, columns: &[(usize, usize)]) -> String {
        let mut table = Table::new();
        table.load_style(RULE_UNDER_HEAD);
        table.set_header(columns.iter().map(|&(at, _)| &cells.header[at]));
        for (row, zeros) in cells.rows.iter().zip(&cells.zeros) {
            table.add_row(columns.iter().map(|&(at, _)| match zeros[at] && self.colour {
                true => green(Cell::new(&row[at])),
                false => Cell::new(&row[at]),
            }));
        }
        let width = |letters: usize| Width::Fixed(u16::try_from(letters + PADDING).unwrap_or(u16::MAX));
        table.set_constraints(columns.iter().map(|&(_, letters)| ColumnConstraint::Absolute(width(letters))));
        table.set_content_arrangement(ContentArrangement::Dynamic);
        table.set_width(u16::try_from(self.width).unwrap_or(u16::MAX));
        colour(&mut table, self.colour);
        table.lines().map(|line| line.replace('\u{a0}', " ").trim_end().to_owned()).collect::<Vec<_>>().join("\n")
    }

    fn joined(&self, formula: String) -> String {
        if self.unbroken { formula.replace(' ', "\u{a0}") } else { formula }
    }
}

#[cfg(feature = "cli")]
fn green(cell: Cell) -> Cell {
    cell.fg(comfy_table::Color::Green)
}

/// Who has no terminal has no colours.
#[cfg(not(feature = "cli"))]
fn green(cell: Cell) -> Cell {
    cell
}

#[cfg(feature = "cli")]
fn colour(table: &mut Table, wanted: bool) {
    // The space behind a word has no colour, so that it can be cut off.
    table.style_text_only();
    if wanted {
        table.enforce_styling();
    } else {
        table.force_no_tty();
    }
}

#[cfg(not(feature = "cli"))]
fn colour(_table: &mut Table, _wanted: bool) {}

impl Writer for Terminal {
    fn digit_space(&self) -> Option<&'static str> {
        // At the begin of a cell an ordinary space would be lost.
        Some("\u{a0}")
    }

    fn ending(&self) -> &'static str {
        "txt"
    }

    fn templates(&self) -> &'static templates::Set {
        templates::set!("terminal", None)
    }

    fn words(&self, words: &str) -> String {
        if self.unbroken { words.to_owned() } else { words.replace('\u{a0}', " ") }
    }

    fn reads_tex(&self) -> bool {
        false
    }

    fn person(&self, words: &Untrusted) -> String {
        words.escaped(Format::Plain)
    }

    fn formula(&self, formula: &str) -> String {
        self.joined(tex::plain(formula))
    }

    fn exact(&self, _tex: &str, plain: &str) -> String {
        self.joined(plain.to_owned())
    }

    fn display(&self, formula: &str, number: Option<u32>) -> String {
        let number = number.map_or_else(String::new, |number| format!("  ({number})"));
        format!("    {}{number}", tex::plain(formula))
    }

    fn strong(&self, inside: &str) -> String {
        inside.to_owned()
    }

    fn code(&self, text: &str) -> String {
        text.to_owned()
    }

    fn line(&self, line: &str) -> String {
        line.to_owned()
    }

    fn picture(&self, _picture: &Picture, _caption: &str) -> (String, Option<File>) {
        (String::new(), None)
    }

    fn table(&self, cells: &Cells) -> Option<String> {
        let parts = cells.lines(self.width, GAP);
        Some(parts.iter().map(|columns| self.part(cells, columns) + "\n\n").collect())
    }

    fn paragraph(&self, text: String) -> String {
        wrapped(&text, self.width)
    }

    fn item(&self, text: String) -> String {
        let mark = "- ".len();
        wrapped(&text, self.width.saturating_sub(mark)).replace('\n', &format!("\n{:mark$}", ""))
    }
}

/// No rule but one under the head.
const RULE_UNDER_HEAD: TableStyle = TableStyle::new().header_separator(LineStyle::none().fill('─').junction('─'));

/// Lines of at most this many letters, broken at spaces.
pub fn wrapped(text: &str, width: usize) -> String {
    let mut out = String::new();
    for (index, line) in text.split('\n').enumerate() {
        out.push_str(if index > 0 { "\n" } else { "" });
        let begin = line.len() - line.trim_start().len();
        let mut length = begin;
        out.push_str(&line[..begin]);
        for (index, word) in line.split_whitespace().enumerate() {
            let letters = word.chars().count();
            if index > 0 && length + 1 + letters > width {
                out.push('\n');
                length = 0;
            } else if index > 0 {
                out.push(' ');
                length += 1;
            }
            out.push_str(word);
            length += letters;
        }
    }
    out
}
