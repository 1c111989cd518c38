//! How does a table fit a printed page? Columns as wide as their cells, else broken into lines, else a table after the other.

use std::collections::BTreeSet;

use serde::Serialize;

use super::templates;

/// What is above a table.
#[derive(Serialize)]
pub(super) struct Caption {
    pub text: String,
    pub label: String,
}

/// A table whose cells are finished strings, and how long they are.
#[derive(Serialize)]
pub(super) struct Cells {
    pub header: Vec<String>,
    pub rows: Vec<Vec<String>>,
    /// Above it, in a fragment.
    #[serde(skip)]
    pub caption: Option<Caption>,
    /// Which cells of the rows are no more than a proved zero.
    #[serde(skip)]
    pub zeros: Vec<Vec<bool>>,
    /// Of the header, then of each row.
    #[serde(skip)]
    pub letters: Vec<Vec<Letters>>,
}

/// How long a cell is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Letters {
    /// On one line.
    all: usize,
    /// Of what no line is broken at.
    longest: usize,
}

impl Letters {
    /// Of a text in which only spaces break lines.
    pub fn of(text: &str) -> Self {
        // Two of the widest letters take the room of three.
        let width = |word: &str| word.chars().count() + word.matches(['M', 'W', 'm', 'w']).count() / 2;
        Letters { all: text.chars().count(), longest: text.split(' ').map(width).max().unwrap_or(0) }
    }

    /// With this many more before it.
    pub fn widen(&mut self, letters: usize) {
        self.all += letters;
        self.longest += letters;
    }
}

/// A table that fits a printed page, for a template.
#[derive(Serialize)]
struct Part<'a> {
    /// Millimetres of each column whose cells are broken into lines; nothing where it is as wide as its cells.
    widths: Vec<Option<String>>,
    /// The size of the letters in points.
    size: u8,
    header: Vec<&'a str>,
    rows: Vec<Vec<&'a str>>,
    /// Of the first part.
    caption: Option<&'a Caption>,
    /// Whether it goes on with a table that has a caption.
    continued: bool,
    /// Whether it needs several pages.
    is_long: bool,
    /// Whether it is better moved to the next page whole than broken.
    is_short: bool,
}

/// A size of letters, with how many of them fit on a line.
struct Size {
    points: u8,
    capacity: usize,
}

const SMALL: Size = Size { points: 10, capacity: 84 };
const SMALLER: Size = Size { points: 9, capacity: 94 };
const SMALLEST: Size = Size { points: 8, capacity: 106 };

/// Width of the text in millimetres.
const TEXT_WIDTH: f64 = 166.0;
/// A table of more lines goes over several pages.
const MOST_LINES: usize = 36;
/// A table of this many lines, its header among them, is not broken: what it leaves empty on a page is little.
const SHORT: usize = 17;
/// More columns than this name no row.
const MOST_KEYS: usize = 3;
/// Letters that the space between two columns takes.
const GAP: usize = 3;

impl Cells {
    /// The table as print takes it: in as many tables as it needs to fit.
    pub fn printed(&self, set: &templates::Set) -> String {
        self.parts().iter().map(|part| templates::fill(set, "table", part)).collect()
    }

    /// The table in parts, each in the largest letters in which it fits.
    fn parts(&self) -> Vec<Part<'_>> {
        let bands = self.bands(|columns| self.part(columns).is_some());
        let set = |columns: Vec<usize>| {
            self.part(&columns).unwrap_or_else(|| self.set(&columns, &SMALLEST, &self.natural(&columns)))
        };
        let mut parts: Vec<Part> = bands.into_iter().map(set).collect();
        for (index, part) in parts.iter_mut().enumerate() {
            part.caption = self.caption.as_ref().filter(|_| index == 0);
            part.continued = self.caption.is_some() && index > 0;
        }
        parts
    }

    /// The columns of each part for a line of this many letters, and how wide they are; `gap` letters stand with each.
    pub fn lines(&self, width: usize, gap: usize) -> Vec<Vec<(usize, usize)>> {
        let room = |columns: &[usize]| width.saturating_sub(gap * columns.len());
        let bands = self.bands(|columns| self.least(columns).iter().sum::<usize>() <= room(columns));
        let set = |columns: Vec<usize>| {
            let widths = shared(&self.natural(&columns), &self.least(&columns), room(&columns));
            columns.into_iter().zip(widths).collect()
        };
        bands.into_iter().map(set).collect()
    }

    /// The first columns that tell every row from all others, where there are no more than three; else the first.
    fn keys(&self) -> usize {
        let is_key = |count: &usize| {
            let mut seen = BTreeSet::new();
            self.rows.iter().all(|row| row.get(..*count).is_some_and(|named| seen.insert(named)))
        };
        (1..=MOST_KEYS).find(is_key).unwrap_or(1)
    }

    /// The columns in parts that fit, each with those before it that name a row.
    fn bands(&self, fits: impl Fn(&[usize]) -> bool) -> Vec<Vec<usize>> {
        let all: Vec<usize> = (0..self.header.len()).collect();
        if all.len() < 2 || fits(&all) {
            return vec![all];
        }
        // A column that has no room beside all keys stands beside the first alone.
        let keys = self.keys();
        let has_room = |keys: usize| (keys..all.len()).all(|at| fits(&[&all[..keys], &[at]].concat()));
        let (named, mut rest) = all.split_at(if has_room(keys) { keys } else { 1 });
        let mut bands = Vec::new();
        while !rest.is_empty() {
            let with_keys = |count: usize| [named, &rest[..count]].concat();
            let count = (1..=rest.len()).rev().find(|&count| fits(&with_keys(count))).unwrap_or(1);
            bands.push(with_keys(count));
            rest = &rest[count..];
        }
        bands
    }

    /// Some columns in the largest letters in which they fit.
    fn part(&self, columns: &[usize]) -> Option<Part<'_>> {
        let (natural, least) = (self.natural(columns), self.least(columns));
        let room = |size: &Size| size.capacity.saturating_sub(GAP * columns.len());
        let whole = [&SMALL, &SMALLER, &SMALLEST].into_iter().find(|size| natural.iter().sum::<usize>() <= room(size));
        if let Some(size) = whole {
            return Some(self.set(columns, size, &natural));
        }
        let broken = [&SMALL, &SMALLER, &SMALLEST].into_iter().find(|size| least.iter().sum::<usize>() <= room(size));
        broken.map(|size| self.set(columns, size, &self.lowest(columns, room(size))))
    }

    /// Widths of broken columns that make the table low: from the least on, letters go where they save most lines.
    fn lowest(&self, columns: &[usize], room: usize) -> Vec<usize> {
        let (natural, least) = (self.natural(columns), self.least(columns));
        // A word of wide letters needs more than they count, a short one the more.
        let mut widths = least;
        let mut narrowest: Vec<usize> = (0..widths.len()).filter(|&at| widths[at] < natural[at]).collect();
        narrowest.sort_by_key(|&at| widths[at]);
        for at in narrowest.into_iter().take(room.saturating_sub(widths.iter().sum())) {
            widths[at] += 1;
        }
        let with = |widths: &[usize], at: usize, width: usize| {
            let mut widths = widths.to_vec();
            widths[at] = width;
            widths
        };
        loop {
            let left = room.saturating_sub(widths.iter().sum());
            let now = self.height(columns, &widths);
            let mut best: Option<(usize, usize, usize, usize)> = None;
            for at in 0..widths.len() {
                for width in widths[at] + 1..=natural[at].min(widths[at] + left) {
                    let saved = now.saturating_sub(self.height(columns, &with(&widths, at, width)));
                    let letters = width - widths[at];
                    if saved > 0 && best.is_none_or(|(most, of, ..)| saved * of > most * letters) {
                        best = Some((saved, letters, at, width));
                    }
                }
            }
            match best {
                Some((_, _, at, width)) => widths[at] = width,
                None => break,
            }
        }
        // What is over helps where letters are wider than most.
        while room > widths.iter().sum() {
            let narrow = (0..widths.len()).filter(|&at| widths[at] < natural[at]).min_by_key(|&at| widths[at]);
            match narrow {
                Some(at) => widths[at] += 1,
                None => break,
            }
        }
        widths
    }

    /// How high a table is: the lines of its rows above all, then those of each cell.
    fn height(&self, columns: &[usize], widths: &[usize]) -> usize {
        let of_cells: usize = self.letters.iter().flat_map(|row| lines_in(row, columns, widths)).sum();
        self.lines_of(columns, widths) * self.header.len() * 2 + of_cells
    }

    fn least(&self, columns: &[usize]) -> Vec<usize> {
        self.widest(columns, |letters| letters.longest)
    }

    fn natural(&self, columns: &[usize]) -> Vec<usize> {
        self.widest(columns, |letters| letters.all)
    }

    fn widest(&self, columns: &[usize], of: fn(&Letters) -> usize) -> Vec<usize> {
        let widest = |&column: &usize| self.letters.iter().map(|row| of(&row[column])).max().unwrap_or(0).max(1);
        columns.iter().map(widest).collect()
    }

    /// The lines of all rows, where the columns are so wide.
    fn lines_of(&self, columns: &[usize], widths: &[usize]) -> usize {
        self.letters.iter().map(|row| lines_in(row, columns, widths).max().unwrap_or(0).max(1)).sum()
    }

    fn set(&self, columns: &[usize], size: &Size, widths: &[usize]) -> Part<'_> {
        let natural = self.natural(columns);
        let lines = self.lines_of(columns, widths);
        let millimetres = TEXT_WIDTH / size.capacity as f64;
        let broken = |(width, natural): (&usize, &usize)| {
            (width < natural).then(|| format!("{:.1}", *width as f64 * millimetres))
        };
        Part {
            widths: widths.iter().zip(&natural).map(broken).collect(),
            size: size.points,
            header: columns.iter().map(|&at| self.header[at].as_str()).collect(),
            rows: self.rows.iter().map(|row| columns.iter().map(|&at| row[at].as_str()).collect()).collect(),
            caption: None,
            continued: false,
            is_long: lines > MOST_LINES,
            is_short: lines <= SHORT,
        }
    }
}

/// The lines of each cell of a row, where the columns are so wide.
fn lines_in(row: &[Letters], columns: &[usize], widths: &[usize]) -> impl Iterator<Item = usize> {
    columns.iter().zip(widths).map(|(&column, &width)| row[column].all.div_ceil(width.max(1)))
}

/// The room shared out: what is narrow stays whole, the rest is broken at one width, none below its longest word if those fit.
fn shared(natural: &[usize], least: &[usize], room: usize) -> Vec<usize> {
    let least = if least.iter().sum::<usize>() <= room { least } else { &vec![1; least.len()] };
    let at = |level: usize| -> Vec<usize> {
        natural.iter().zip(least).map(|(&natural, &least)| natural.min(level.max(least))).collect()
    };
    let level = (1..=room).rev().find(|&level| at(level).iter().sum::<usize>() <= room).unwrap_or(1);
    at(level)
}
