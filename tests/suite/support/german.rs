//! What is to be translated, and of what does the program speak?

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::loads::{Method, bearing_loads, usual_orders};
use crankstar::page::{Block, Document, Piece, Text};
use crankstar::remedy::{self, Request};
use crankstar::report::{self, Numbers};

use super::{page_texts, pages};

/// What stands in a phrase outside of its formulas.
pub fn outside(words: &str) -> impl Iterator<Item = &str> {
    words.split('$').step_by(2)
}

/// Whether a phrase has words, and not only places and signs.
pub fn has_words(words: &str) -> bool {
    outside(words).any(|part| part.contains(char::is_alphabetic))
}

/// The words of the program on a page, each as its English list has them: what a list of another language translates.
pub fn phrases(page: &Document) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    collect(&page.title, &mut found);
    page.blocks.iter().for_each(|block| collect_of_block(block, &mut found));
    found
}

fn collect_of_block<'a>(block: &'a Block, found: &mut BTreeSet<&'a str>) {
    match block {
        Block::Heading(_, text) | Block::Paragraph(text) | Block::Note(text) => collect(text, found),
        Block::Answer(texts) | Block::List(texts) => texts.iter().for_each(|text| collect(text, found)),
        Block::Table(table) => {
            table.header.iter().chain(table.rows.iter().flatten()).for_each(|cell| collect(cell, found));
        }
        Block::Pictures(pictures) => pictures.iter().for_each(|picture| collect(&picture.caption, found)),
        Block::Folded(fold) => {
            collect(&fold.summary, found);
            fold.blocks.iter().for_each(|block| collect_of_block(block, found));
        }
        Block::Formula(..) | Block::Live(_) | Block::Verbatim(..) => {}
        other => panic!("are there words in {other:?}?"),
    }
}

/// A value that chooses words finds them in its place, and a place with words has a value that chooses.
fn assert_chosen(words: &str, values: &[Text]) {
    for (value, count) in places(words) {
        let choice = match values[value - 1].pieces() {
            [Piece::Choice(choice)] => Some(*choice),
            _ => None,
        };
        assert!(choice.map_or(count == 1, |choice| choice < count && count > 1), "{words:?} with {values:?}");
    }
}

/// The places of a phrase: which value comes there, from 1, and among how many words it chooses (1 where it is said itself).
pub fn places(words: &str) -> BTreeSet<(usize, usize)> {
    let parts = outside(words).flat_map(|part| part.split('{').skip(1)).filter_map(|part| part.split_once('}'));
    let mut following = 1..;
    let place = |(inside, _): (&str, &str)| {
        let (name, words) = match inside.contains('|') {
            true => inside.split_once(':').filter(|(name, _)| name.parse::<usize>().is_ok()).unwrap_or(("", inside)),
            false => (inside, ""),
        };
        let value = name.parse().ok().or_else(|| following.next());
        (value.expect("a value"), words.split('|').count())
    };
    parts.map(place).collect()
}

/// The phrases in a text, and in their values.
fn collect<'a>(text: &'a Text, found: &mut BTreeSet<&'a str>) {
    for piece in text.pieces() {
        match piece {
            Piece::Phrase(words, values) => {
                assert_chosen(words, values);
                found.insert(words);
                values.iter().for_each(|value| collect(value, found));
            }
            Piece::Link(text, _) => collect(text, found),
            _ => {}
        }
    }
}

/// The report on an engine, with its remedy, and its loads and its bearings where it has any.
pub fn pages_of(engine: &Engine) -> Vec<Document> {
    let remedy = remedy::remedy(engine, &Request { orders: vec![1, 2], ..Request::default() });
    let solve = |method| bearing_loads(engine, engine.orders(), method).ok();
    let bearings = solve(Method::Continuous).zip(solve(Method::Determinate));
    let remedy = remedy.ok().map(|remedy| report::remedy_page(&remedy));
    let bearings = bearings.map(|(continuous, determinate)| report::bearings_page(engine, &continuous, &determinate));
    let numbers = Numbers::new(engine, &usual_orders(engine), None).ok();
    let loads = numbers.iter().flat_map(|numbers| {
        [report::loads_page(engine, numbers, None), report::loads_answer(engine, numbers, None, None)]
    });
    let answer = report::engine_answer(engine, &pages::judgement(engine));
    [Some(pages::document(engine)), Some(answer), remedy, bearings].into_iter().flatten().chain(loads).collect()
}

/// The pages on each engine of the catalogue, beside its name; made once, however many tests look at them.
pub fn pages_of_the_catalogue() -> &'static [(&'static str, Vec<Document>)] {
    static PAGES: LazyLock<Vec<(&str, Vec<Document>)>> = LazyLock::new(|| {
        let engines = file::catalogue().expect("the catalogue reads");
        engines.iter().map(|(entry, engine)| (entry.name, pages_of(engine))).collect()
    });
    &PAGES
}

/// The folders of layout files below this project, each with the pages on them; made once too.
pub fn pages_of_folders() -> &'static [(&'static str, Vec<Document>)] {
    static PAGES: LazyLock<Vec<(&str, Vec<Document>)>> = LazyLock::new(|| {
        ["reports/examples", "reports/families", "tests/pages"].map(|folder| (folder, pages_of_files(folder))).into()
    });
    &PAGES
}

fn pages_of_files(folder: &str) -> Vec<Document> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let files = files.map(|path| if path.is_dir() { path.join("layout.toml") } else { path });
    let texts = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let page = |path| match file::parse_layout("layout.toml", &fs::read_to_string(path).expect("a text")) {
        Ok(Layout::Known(engine, _)) => pages_of(&engine),
        Ok(Layout::Open(open)) => {
            let orders = family::classify(&open, open.orders()).expect("orders");
            vec![report::family_page(&open, &orders, false), report::family_answer(&open, &orders)]
        }
        Err(_) => Vec::new(),
    };
    texts.flat_map(page).collect()
}

/// Every text between quotes in the files of these folders, as it stands and with its places bare.
pub fn literals(folders: &[&str]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut waiting: Vec<_> = folders.iter().map(|folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).collect();
    while let Some(path) = waiting.pop() {
        if path.is_dir() {
            waiting.extend(fs::read_dir(path).expect("a folder").map(|entry| entry.expect("an entry").path()));
            continue;
        }
        let source = fs::read_to_string(&path).expect("a text");
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("rs") => found.extend(quoted(&source)),
            Some("toml") => {}
            Some("md") if path.parent().is_some_and(|folder| folder.ends_with("templates/pages")) => {
                found.extend(page_texts::said(&source));
            }
            // A sweep calls what it sweeps by the name of its key.
            Some("txt") if path.ends_with("schema/keys.txt") => found.extend(names_of_keys(&source)),
            // In a template quotes stand within quotes.
            _ => found.extend(source.split('"').map(str::to_owned)),
        }
    }
    let bare: Vec<String> = found.iter().map(|text| with_bare_places(text)).collect();
    found.extend(bare);
    found
}

/// The keys of this list as a sweep calls them, `pin split`.
pub fn names_of_keys(list: &str) -> impl Iterator<Item = String> + '_ {
    let keys = list.lines().filter_map(|line| line.split_once(": "));
    keys.map(|(key, _)| key.trim_end_matches('!').replace('_', " "))
}

/// The texts between quotes, outside of comments; a broken line goes on where its words do.
pub fn quoted(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut letters = source.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '/' if letters.peek() == Some(&'/') => drop(letters.by_ref().find(|letter| *letter == '\n')),
            // The letter of a quote is no quote.
            '\'' if letters.peek() == Some(&'"') => drop(letters.next()),
            '"' => found.push(text(&mut letters)),
            _ => {}
        }
    }
    found
}

/// The rest of a text, its closing quote taken.
fn text(letters: &mut std::iter::Peekable<std::str::Chars>) -> String {
    let mut out = String::new();
    while let Some(letter) = letters.next().filter(|letter| *letter != '"') {
        match letter {
            '\\' => match letters.next() {
                Some('\n') => while letters.next_if(|letter| letter.is_whitespace()).is_some() {},
                Some('n') => out.push('\n'),
                Some('u') => {
                    let code: String = letters.by_ref().skip(1).take_while(|letter| *letter != '}').collect();
                    out.extend(u32::from_str_radix(&code, 16).ok().and_then(char::from_u32));
                }
                other => out.extend(other),
            },
            letter => out.push(letter),
        }
    }
    out
}

/// `{size:.0}` as `{}`, as a list of words has it.
fn with_bare_places(text: &str) -> String {
    let (mut out, mut rest) = (String::new(), text);
    while let Some((before, after)) = rest.split_once('{') {
        let name = |name: &str| name.chars().all(|letter| letter.is_ascii_alphanumeric() || "_:.*$".contains(letter));
        match after.split_once('}').filter(|(inside, _)| name(inside)) {
            Some((_, after)) => {
                out += &format!("{before}{{}}");
                rest = after;
            }
            None => {
                out += &format!("{before}{{");
                rest = after;
            }
        }
    }
    out + rest
}

/// Whether these words stand among the texts, or are whole sentences of one.
pub fn is_said(texts: &BTreeSet<String>, words: &str) -> bool {
    let is_part = |text: &String| {
        text.match_indices(words).any(|(at, _)| {
            let (before, after) = (&text[..at], &text[at + words.len()..]);
            (before.is_empty() || before.ends_with(". "))
                && (after.is_empty() || words.ends_with('.') && after.starts_with(' '))
        })
    };
    texts.contains(words) || texts.iter().any(is_part)
}
