//! How is a document walked? Each block is set by the template of its kind, each piece of a text by the signs of the format.

use num_rational::BigRational;
use serde::Serialize;

use super::super::block::{Block, Document, Fold, Live, Picture, Table};
use super::super::language::has_comma;
use super::super::markup::{Mark, marks};
use super::super::number::{self, Number};
use super::super::text::{Piece, Setting, Text};
use super::super::{Unit, Units, block::in_si_units};
use super::columns::{Caption, Cells, Letters};
use super::decimals::lacking;
use super::filled::{Drawn, Folded, Heading, PageContext, fence, id};
use super::labels::{Labels, short};
use super::notation::plain;
use super::options::Options;
use super::templates;
use super::writer::{File, Writer};
use crate::numbers::float;
use crate::text;

/// Writes one document.
pub(super) struct Composer<'a> {
    pub writer: &'a dyn Writer,
    pub options: &'a Options,
    /// Files that are beside the main one.
    pub files: Vec<File>,
    /// What was folded, for formats that have it at the end.
    folds: Vec<Folded>,
    /// Headings so far.
    headings: Vec<Heading>,
    /// What a fragment is referred to by.
    pub labels: Labels,
    /// What parts that move look like, and what moves them, each once.
    styles: Vec<&'static str>,
    scripts: Vec<&'static str>,
}

/// What the letters of a multiple mean.
const MULTIPLES: &str =
    "m: reciprocating mass of a cylinder; r: crank radius; ω: speed in radians per second; a: unit of the positions";

impl<'a> Composer<'a> {
    pub fn new(writer: &'a dyn Writer, options: &'a Options) -> Self {
        Composer {
            writer,
            options,
            files: Vec::new(),
            folds: Vec::new(),
            headings: Vec::new(),
            labels: Labels::default(),
            styles: Vec::new(),
            scripts: Vec::new(),
        }
    }

    fn fill(&self, template: &str, values: &impl Serialize) -> String {
        templates::fill(self.writer.templates(), template, values)
    }

    /// The main file.
    pub fn document(&mut self, document: &Document) -> String {
        if self.options.fragment && self.writer.has_labels() {
            self.labels = Labels::of_fragment(document, self.text(&document.title), self.options);
        }
        let first = document.blocks.iter().position(|block| matches!(block, Block::Heading(..)));
        let (before, rest) = document.blocks.split_at(first.unwrap_or(document.blocks.len()));
        let mut before = self.blocks(before);
        if self.options.units == Units::Inch && in_si_units(&document.blocks) {
            before += &self.blocks(&[Block::Note(IN_SI.into())]);
        }
        let body = self.blocks(rest);
        let listed = |heading: &&Heading| document.has_contents && heading.level == 1;
        let whole = PageContext {
            title: self.writer.paragraph(self.text(&document.title)),
            plain_title: self.writer.words(&self.plain(&document.title)),
            contents: self.headings.iter().filter(listed).collect(),
            before,
            body,
            folds: &self.folds,
            stamp: self.options.stamp.as_ref().map(|stamp| self.writer.words(stamp)),
            fragment: self.options.fragment,
            siunitx: self.options.siunitx,
            language: self.options.language.code(),
            hyphenation: self.options.language.hyphenation(),
            styles: &self.styles,
            scripts: self.scripts.iter().map(|script| self.options.symbols.in_letters(script)).collect(),
        };
        self.fill("document", &whole)
    }

    /// Some blocks, one after the other.
    pub fn blocks(&mut self, blocks: &[Block]) -> String {
        let set = |block| {
            let set = self.block(block);
            self.labels.lead(matches!(block, Block::Paragraph(_)).then_some(&set));
            set
        };
        blocks.iter().map(set).collect()
    }

    fn block(&mut self, block: &Block) -> String {
        #[derive(Serialize)]
        struct Words {
            text: String,
        }
        #[derive(Serialize)]
        struct Items {
            items: Vec<String>,
            language: &'static str,
        }
        let words = |composer: &Self, text: &Text| Words { text: composer.writer.paragraph(composer.text(text)) };
        let language = self.options.language.code();
        match block {
            Block::Heading(level, text) => {
                let name = plain(text, &Options::default());
                let shown = plain(text, &self.options.in_language());
                let (text, number) = (self.writer.paragraph(self.text(text)), self.headings.len() + 1);
                self.labels.topic(&text, name.clone());
                let label = self.labels.label("sec", &name);
                let heading = Heading { level: *level, text, id: self.free_id(&shown), number, label };
                self.headings.push(heading.clone());
                self.fill("heading", &heading)
            }
            Block::Paragraph(text) => self.fill("paragraph", &words(self, text)),
            Block::Note(text) => self.fill("note", &words(self, text)),
            Block::Formula(tex, number) => {
                let text = self.display(tex, *number);
                self.fill("paragraph", &Words { text })
            }
            Block::Answer(lines) => {
                let items = lines.iter().map(|text| self.writer.paragraph(self.text(text))).collect();
                self.fill("answer", &Items { items, language })
            }
            Block::List(items) => {
                let items = items.iter().map(|text| self.writer.item(self.text(text))).collect();
                self.fill("list", &Items { items, language })
            }
            Block::Table(table) => {
                let caption = self.labels.caption();
                self.table(table, caption)
            }
            Block::Pictures(pictures) => self.pictures(pictures),
            Block::Folded(fold) => self.folded(fold),
            Block::Live(live) => self.live(live),
            Block::Verbatim(language, file) => {
                #[derive(Serialize)]
                struct Verbatim<'a> {
                    language: &'a str,
                    lines: Vec<String>,
                    fence: String,
                }
                let file = text::harmless_lines(file.written()).replace('\t', "    ");
                let lines: Vec<String> = file.lines().map(|line| self.writer.line(line)).collect();
                let fence = fence(&lines);
                self.fill("verbatim", &Verbatim { language, lines, fence })
            }
        }
    }

    /// The name of a heading, with a number behind it where it is not the first of that name.
    fn free_id(&self, heading: &str) -> String {
        let id = id(heading);
        let taken = self.headings.iter().filter(|other| other.text == heading || other.id == id).count();
        if taken == 0 { id } else { format!("{id}-{taken}") }
    }

    fn table(&self, table: &Table, caption: Option<Caption>) -> String {
        let set = |cells: &[Text]| cells.iter().map(|cell| self.text(cell)).collect::<Vec<_>>();
        let mut rows: Vec<Vec<String>> = table.rows.iter().map(|row| set(row)).collect();
        let mut letters: Vec<Vec<Letters>> = [&table.header]
            .into_iter()
            .chain(&table.rows)
            .map(|row| row.iter().map(|cell| Letters::of(&self.unbroken(cell))).collect())
            .collect();
        self.align(table, &mut rows, &mut letters[1..]);
        let cells = Cells {
            header: set(&table.header),
            rows,
            caption,
            zeros: table.rows.iter().map(|row| row.iter().map(Text::is_zero).collect()).collect(),
            letters,
        };
        self.writer.table(&cells).unwrap_or_else(|| self.fill("table", &cells))
    }

    /// Pushes decimals so that their points are below each other, where the format has a space as wide as a digit.
    fn align(&self, table: &Table, rows: &mut [Vec<String>], letters: &mut [Vec<Letters>]) {
        let Some(space) = self.writer.digit_space() else { return };
        for column in 0..table.header.len() {
            let plain: Vec<String> =
                table.rows.iter().map(|row| row.get(column).map(|cell| self.plain(cell)).unwrap_or_default()).collect();
            for ((row, letters), digits) in rows.iter_mut().zip(letters.iter_mut()).zip(lacking(&plain)) {
                if let (Some(cell), Some(letters)) = (row.get_mut(column), letters.get_mut(column)) {
                    cell.insert_str(0, &space.repeat(digits));
                    letters.widen(digits);
                }
            }
        }
    }

    fn pictures(&mut self, pictures: &[Picture]) -> String {
        #[derive(Serialize)]
        struct Beside {
            pictures: Vec<Drawn>,
        }
        let mut drawn = Vec::new();
        for picture in pictures {
            let picture = &picture.counted_in(self.options.units);
            let renamed = self.options.symbols.in_picture(&self.options.language.picture(picture));
            // Where it is not seen it is called by the first sentence.
            let called = self.plain(&picture.caption);
            let called = called.split_inclusive(". ").next().unwrap_or(&called).trim_end();
            let (body, file) = self.writer.picture(&renamed, called);
            // A picture that stands twice is one file.
            self.files.extend(file.filter(|file| self.files.iter().all(|other| other.name != file.name)));
            let label = self.labels.label("fig", &picture.name);
            let caption = self.text(&picture.caption);
            drawn.push(Drawn {
                body,
                short: short(&caption).map(str::to_owned),
                caption,
                label,
                spread: renamed.figure.is_spread(),
            });
        }
        self.fill("pictures", &Beside { pictures: drawn })
    }

    fn live(&mut self, live: &Live) -> String {
        if !self.writer.has_scripts() {
            return String::new();
        }
        if !self.scripts.contains(&live.script) {
            self.styles.push(live.style);
            self.scripts.push(live.script);
        }
        self.options.symbols.in_plain_words(&live.part.body(self.options.language))
    }

    fn folded(&mut self, fold: &Fold) -> String {
        let (summary, name) = (self.text(&fold.summary), plain(&fold.summary, &Options::default()));
        let label = self.labels.label("sec", &name);
        self.labels.enter(&summary, name);
        let body = self.blocks(&fold.blocks);
        self.labels.leave();
        // What is folded inside has its number by now.
        let place = if label.is_some() { "section" } else { "appendix" };
        let place = [place, "page"].map(|words| self.text(&words.into()));
        let folded = Folded { summary, body, number: self.folds.len() + 1, label, place };
        let here = self.fill("folded", &folded);
        if self.writer.is_print() {
            self.folds.push(folded);
        }
        here
    }

    /// A text in the signs of the format.
    pub fn text(&self, text: &Text) -> String {
        let set: Vec<String> = text.pieces().iter().map(|piece| self.piece(piece)).collect();
        let between = self.options.language.separator();
        if between == COMMA || !set.iter().any(|piece| has_comma(piece)) {
            return set.concat();
        }
        // Where commas are those of decimals, others stand between the values.
        let piece = |(piece, set): (&Piece, String)| match piece {
            Piece::Phrase(words, _) if words == COMMA => self.words(between),
            _ => set,
        };
        text.pieces().iter().zip(set).map(piece).collect()
    }

    fn piece(&self, piece: &Piece) -> String {
        let (writer, language, figures) = (self.writer, self.options.language, self.options.figures);
        match piece {
            Piece::Phrase(words, values) => self.phrase(&language.words(words), values),
            Piece::Label(label) => self.words(&language.label(label)),
            Piece::Person(words) => writer.person(&language.title(words).unwrap_or_else(|| words.clone())),
            Piece::Number(number) => match number {
                Number::Zero => writer.zero(),
                Number::Exact(value) => self.numbers(&number::number(value)),
                Number::Closed(form, decimal) => {
                    let exact = self.exact(&form.tex(), &form.to_string());
                    format!("{exact} {}", self.numbers(&figures.approximate(*decimal)))
                }
                Number::Decimal(decimal) => self.numbers(&figures.approximate(*decimal)),
            },
            Piece::Form(form) => self.exact(&form.tex(), &form.to_string()),
            Piece::Bearing(bearing) => match bearing.arctangent() {
                Some([tex, plain]) => format!("{} {}", self.exact(&tex, &plain), self.numbers(&bearing.degrees())),
                None => self.numbers(&bearing.degrees()),
            },
            Piece::Quantity(value, unit) | Piece::AtMost(value, unit) => {
                let (value, unit) = self.options.units.of(*value, *unit);
                let (value, unit) = unit.at_sight(value);
                let number = match piece {
                    Piece::AtMost(..) => number::at_most(value),
                    // Of either sign.
                    _ if value == 0.0 => "0".to_owned(),
                    _ => figures.set(value, number::sensible),
                };
                let unit = Unit { name: language.fixed(unit.name), ..unit };
                let set = self.options.siunitx.then(|| writer.quantity(&number, unit)).flatten();
                set.unwrap_or_else(|| self.numbers(&format!("{number}{}", number::behind(unit))))
            }
            Piece::Measured(value, unit, setting) => {
                let value = self.options.units.of(*value, *unit).0;
                self.numbers(&match setting {
                    Setting::About => figures.approximate(value),
                    Setting::Usual(set) => figures.set(value, *set),
                    Setting::Fixed(set) => set(value),
                })
            }
            Piece::Closed(form, value, unit) => match self.options.units.instead_of(*unit) {
                Some((_, size)) => self.numbers(&figures.approximate(value / float(&size))),
                None => self.piece(&Piece::Number(Number::Closed(form.clone(), *value))),
            },
            Piece::InUnit(text, unit) => match self.options.units.instead_of(*unit) {
                Some(_) => String::new(),
                None => self.text(text),
            },
            Piece::Exactly(value, unit) => self.numbers(&self.in_units(value, *unit, number::is_rounded)),
            Piece::Shortly(value, unit) => self.numbers(&self.in_units(value, *unit, number::is_long)),
            Piece::Unit(unit) => {
                let unit = self.options.units.of(0.0, *unit).1;
                let name = self.words(&language.label(unit.name));
                if unit.suffix.starts_with("mr") { writer.explained(name, language.fixed(MULTIPLES)) } else { name }
            }
            Piece::Formula(tex) => self.formula(tex),
            Piece::Code(text) => writer.code(text),
            Piece::Choice(_) => String::new(),
            Piece::Link(text, target) => writer.link(&self.text(text), target),
        }
    }

    /// An exact number in the units of the reader: in decimals where it is too long, or converted to a fraction.
    fn in_units(&self, value: &BigRational, unit: Unit, is_long: fn(&BigRational) -> bool) -> String {
        let converted = self.options.units.instead_of(unit).map(|(_, size)| value / size);
        let value = converted.as_ref().unwrap_or(value);
        let is_fraction = converted.is_some() && !number::terminates(value);
        match is_fraction || is_long(value) {
            true => self.options.figures.approximate(float(value)),
            false => number::number(value),
        }
    }

    fn phrase(&self, words: &str, values: &[Text]) -> String {
        let mut following = values.iter();
        let mut out = String::new();
        let mut bold: Option<String> = None;
        for mark in marks(words) {
            let set = match mark {
                Mark::Words(words) => self.words(words),
                Mark::Formula(tex) => self.formula(tex),
                Mark::Place(place) => {
                    let value = place.value.map_or_else(|| following.next(), |value| values.get(value));
                    let chosen = value.and_then(Text::choice).and_then(|choice| place.chosen(choice));
                    match chosen {
                        Some(words) => self.words(words),
                        None => value.map(|text| self.text(text)).unwrap_or_default(),
                    }
                }
                Mark::Bold => match bold.take() {
                    Some(inside) => {
                        out.push_str(&self.writer.strong(&inside));
                        continue;
                    }
                    None => {
                        bold = Some(String::new());
                        continue;
                    }
                },
            };
            bold.as_mut().unwrap_or(&mut out).push_str(&set);
        }
        out + &bold.unwrap_or_default()
    }
}

/// What is said where formulas have numbers in them that are not converted.
const IN_SI: &str = "Numbers are put into the formulas in SI units.";
/// Between values in English.
const COMMA: &str = ", ";
