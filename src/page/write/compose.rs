//! How is a document walked? Each block is set by the template of its kind, each piece of a text by the signs of the format.

use serde::Serialize;

use super::super::block::{Block, Document, Fold, Live, Picture, Table};
use super::super::language::has_comma;
use super::super::markup::{Mark, marks};
use super::super::number::{self, Number};
use super::super::text::{Piece, Text};
use super::columns::{Cells, Letters};
use super::terminal::Terminal;
use super::{File, Options, Writer, templates};

/// Writes one document.
pub(super) struct Composer<'a> {
    writer: &'a dyn Writer,
    options: &'a Options,
    /// Files that stand beside the main one.
    pub files: Vec<File>,
    /// What was folded, for formats that have it at the end.
    folds: Vec<Folded>,
    /// Headings so far.
    headings: Vec<Heading>,
    /// What parts that move look like, and what moves them, each once.
    styles: Vec<&'static str>,
    scripts: Vec<&'static str>,
}

#[derive(Clone, Serialize)]
struct Heading {
    level: u8,
    text: String,
    /// The name that links lead to.
    id: String,
    number: usize,
}

#[derive(Serialize)]
struct Folded {
    number: usize,
    summary: String,
    body: String,
}

#[derive(Serialize)]
struct Whole<'a> {
    title: String,
    plain_title: String,
    contents: Vec<&'a Heading>,
    before: String,
    body: String,
    folds: &'a [Folded],
    stamp: Option<String>,
    fragment: bool,
    language: &'static str,
    hyphenation: &'static str,
    styles: &'a [&'static str],
    scripts: &'a [&'static str],
}

#[derive(Serialize)]
struct Drawn {
    body: String,
    caption: String,
}

impl<'a> Composer<'a> {
    pub fn new(writer: &'a dyn Writer, options: &'a Options) -> Self {
        Composer {
            writer,
            options,
            files: Vec::new(),
            folds: Vec::new(),
            headings: Vec::new(),
            styles: Vec::new(),
            scripts: Vec::new(),
        }
    }

    fn fill(&self, template: &str, values: &impl Serialize) -> String {
        templates::fill(self.writer.templates(), template, values)
    }

    /// The main file.
    pub fn document(&mut self, document: &Document) -> String {
        let first = document.blocks.iter().position(|block| matches!(block, Block::Heading(..)));
        let (before, rest) = document.blocks.split_at(first.unwrap_or(document.blocks.len()));
        let before = self.blocks(before);
        let body = self.blocks(rest);
        let listed = |heading: &&Heading| document.has_contents && heading.level == 1;
        let whole = Whole {
            title: self.writer.paragraph(self.text(&document.title)),
            plain_title: self.writer.words(&self.plain(&document.title)),
            contents: self.headings.iter().filter(listed).collect(),
            before,
            body,
            folds: &self.folds,
            stamp: self.options.stamp.as_ref().map(|stamp| self.writer.words(stamp)),
            fragment: self.options.fragment,
            language: self.options.language.code(),
            hyphenation: self.options.language.hyphenation(),
            styles: &self.styles,
            scripts: &self.scripts,
        };
        self.fill("document", &whole)
    }

    fn blocks(&mut self, blocks: &[Block]) -> String {
        blocks.iter().map(|block| self.block(block)).collect()
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
                let id = self.free_id(&self.plain(text));
                let text = self.writer.paragraph(self.text(text));
                let heading = Heading { level: *level, text, id, number: self.headings.len() + 1 };
                self.headings.push(heading.clone());
                self.fill("heading", &heading)
            }
            Block::Paragraph(text) => self.fill("paragraph", &words(self, text)),
            Block::Note(text) => self.fill("note", &words(self, text)),
            Block::Formula(tex, number) => self.fill("paragraph", &Words { text: self.display(tex, *number) }),
            Block::Answer(lines) => {
                let items = lines.iter().map(|text| self.writer.paragraph(self.text(text))).collect();
                self.fill("answer", &Items { items, language })
            }
            Block::List(items) => {
                let items = items.iter().map(|text| self.writer.paragraph(self.text(text))).collect();
                self.fill("list", &Items { items, language })
            }
            Block::Table(table) => self.table(table),
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
                let lines = self.writer.verbatim(file);
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

    fn table(&self, table: &Table) -> String {
        let set = |cells: &[Text]| cells.iter().map(|cell| self.text(cell)).collect::<Vec<_>>();
        let cells = Cells {
            header: set(&table.header),
            rows: table.rows.iter().map(|row| set(row)).collect(),
            zeros: table.rows.iter().map(|row| row.iter().map(Text::is_zero).collect()).collect(),
            letters: [&table.header]
                .into_iter()
                .chain(&table.rows)
                .map(|row| row.iter().map(|cell| Letters::of(&self.unbroken(cell))).collect())
                .collect(),
        };
        match self.writer.table(&cells) {
            Some(set) => set,
            None => self.fill("table", &cells),
        }
    }

    fn pictures(&mut self, pictures: &[Picture]) -> String {
        #[derive(Serialize)]
        struct Beside {
            pictures: Vec<Drawn>,
        }
        let mut drawn = Vec::new();
        for picture in pictures {
            let picture = &Picture { figure: self.options.language.figure(&picture.figure), ..picture.clone() };
            let (body, file) = self.writer.picture(picture, first_sentence(&self.plain(&picture.caption)));
            self.files.extend(file);
            drawn.push(Drawn { body, caption: self.text(&picture.caption) });
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
        live.part.body(self.options.language)
    }

    fn folded(&mut self, fold: &Fold) -> String {
        let folded = Folded {
            summary: self.text(&fold.summary),
            body: self.blocks(&fold.blocks),
            // What is folded inside has its number by now.
            number: self.folds.len() + 1,
        };
        let here = self.fill("folded", &folded);
        if self.writer.folds_at_end() {
            self.folds.push(folded);
        }
        here
    }

    fn display(&self, tex: &str, number: Option<u32>) -> String {
        self.writer.display(&self.options.language.formula(tex), number)
    }

    /// A text without colours, as it is measured and searched.
    fn plain(&self, text: &Text) -> String {
        self.measured(text, false)
    }

    /// The same with what a line is not broken at as one word: the formulas.
    fn unbroken(&self, text: &Text) -> String {
        self.measured(text, true)
    }

    fn measured(&self, text: &Text, unbroken: bool) -> String {
        let terminal = Terminal { width: usize::MAX, colour: false, unbroken };
        let options = Options { language: self.options.language, ..Options::default() };
        Composer::new(&terminal, &options).text(text)
    }

    /// A text in the signs of the format.
    pub fn text(&self, text: &Text) -> String {
        let set: Vec<String> = text.pieces().iter().map(|piece| self.piece(piece)).collect();
        let language = self.options.language;
        let between = language.separator();
        if between == COMMA || !set.iter().any(|piece| has_comma(piece)) {
            return set.concat();
        }
        // Where commas are those of decimals, others stand between the values.
        let piece = |(piece, set): (&Piece, String)| match piece {
            Piece::Phrase(words, _) if words == COMMA => self.writer.words(between),
            _ => set,
        };
        text.pieces().iter().zip(set).map(piece).collect()
    }

    fn piece(&self, piece: &Piece) -> String {
        let (writer, language) = (self.writer, self.options.language);
        let numbers = |text: &str| writer.words(&language.numbers(text));
        let exact = |tex: &str, plain: &str| writer.exact(&language.formula(tex), &language.numbers(plain));
        match piece {
            Piece::Phrase(words, values) => self.phrase(&language.words(words), values),
            Piece::Label(label) => writer.words(&language.label(label)),
            Piece::Person(words) => writer.person(words),
            Piece::Number(number) => match number {
                Number::Zero => writer.zero(),
                Number::Exact(value) => numbers(&number::number(value)),
                Number::Closed(form, decimal) => {
                    let exact = exact(&form.tex(), &form.to_string());
                    format!("{exact} {}", numbers(&number::approximate(*decimal)))
                }
                Number::Decimal(decimal) => numbers(&number::approximate(*decimal)),
            },
            Piece::Form(form) => exact(&form.tex(), &form.to_string()),
            Piece::Bearing(bearing) => match bearing.arctangent() {
                Some([tex, plain]) => format!("{} {}", exact(&tex, &plain), numbers(&bearing.degrees())),
                None => numbers(&bearing.degrees()),
            },
            Piece::Quantity(value, unit) => numbers(&format!("{}{}", number::sensible(*value), number::behind(*unit))),
            Piece::Formula(tex) => writer.formula(&language.formula(tex)),
            Piece::Code(text) => writer.code(text),
            Piece::Link(text, target) => writer.link(&self.text(text), target),
        }
    }

    fn phrase(&self, words: &str, values: &[Text]) -> String {
        let mut following = values.iter();
        let mut out = String::new();
        let mut bold: Option<String> = None;
        for mark in marks(words) {
            let set = match mark {
                Mark::Words(words) => self.writer.words(words),
                Mark::Formula(tex) => self.writer.formula(&self.options.language.formula(tex)),
                Mark::Place(place) => {
                    let value = place.map_or_else(|| following.next(), |place| values.get(place));
                    value.map(|text| self.text(text)).unwrap_or_default()
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

/// Between values in English.
const COMMA: &str = ", ";

/// What a picture is called where it is not seen.
fn first_sentence(caption: &str) -> &str {
    caption.split_inclusive(". ").next().unwrap_or(caption).trim_end()
}

/// The name of a heading, as code-hosting pages make it.
fn id(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

/// Backticks that no run in the file is as long as.
fn fence(lines: &[String]) -> String {
    let runs = lines.iter().flat_map(|line| line.split(|letter| letter != '`'));
    let longest = runs.map(str::len).max().unwrap_or(0);
    "`".repeat((longest + 1).max(3))
}
