//! What does a text in `templates/pages` say? The page as it is read, then the sentences that its rooms choose among.
//!
//! ```text
//! # {engine}: main bearings          the title, with a place for a value
//! {peaks}                            a place for blocks: tables, pictures, paragraphs
//! ## Crankpins                       a section; left out where all its places for blocks are empty
//! Load of each {crank:pin|throw}:    a paragraph; `crank` chooses one of the words
//! - The shaft is straight.           a list; `- {items}` is a place for several
//! > Weight is neglected.             a remark
//! ---
//! largest: The largest is {force}.   a sentence, in Rust the function `largest(force)`
//! assumptions:                       a list of them, in Rust `assumptions()`
//! - The shaft is straight.
//! ```
//!
//! A paragraph or an item with an empty value is left out. In formulas, `$c_{2}$`, braces are TeX.

use std::fmt::Write;

/// What is wrong: the number of the line, and what would be right.
type Mistake = String;

/// The module of a text: `struct Page`, where it has a page, and a function for each sentence.
pub fn module(name: &str, text: &str) -> Result<String, Mistake> {
    let (page, sentences) = split(text);
    let mut code = format!("/// `templates/pages/{name}.md`.\npub(crate) mod {} {{\n", name.replace('-', "_"));
    code += "#[allow(unused_imports)]\nuse super::{Blocks, Choice, Document, Items, Skeleton, Text};\n";
    if !page.is_empty() {
        code += &page_code(name, &page)?;
    }
    for sentence in grouped(&sentences)? {
        code += &sentence_code(&sentence)?;
    }
    Ok(code + "}\n")
}

/// A line with its number, counted from 1.
type Line<'a> = (usize, &'a str);

/// The lines of the page and those of the sentences, without empty ones and comments.
fn split(text: &str) -> (Vec<Line<'_>>, Vec<Line<'_>>) {
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim_end()));
    let lines: Vec<Line<'_>> = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with("<!--")).collect();
    let has_page = lines.first().is_some_and(|(_, line)| line.starts_with("# "));
    let end = lines.iter().position(|(_, line)| *line == "---");
    let (page, sentences) = match end {
        Some(end) => (&lines[..end], &lines[end + 1..]),
        None if has_page => (&lines[..], &[][..]),
        None => (&[][..], &lines[..]),
    };
    (page.to_vec(), sentences.to_vec())
}

/// What a place takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// A value in words.
    Text,
    /// Which of its words are said.
    Choice,
    /// Blocks of a page.
    Blocks,
    /// Several items of a list, or several remarks.
    Items,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Kind::Text => "Text",
            Kind::Choice => "Choice",
            Kind::Blocks => "Blocks",
            Kind::Items => "Items",
        }
    }
}

/// A place by its name.
type Place = (String, Kind);

/// Words with places: their values by name, in order, and the words as `page::Text` has them.
struct Words {
    places: Vec<Place>,
    phrase: String,
}

impl Words {
    /// `The largest is {force}.` is `The largest is {}.`, with `force`.
    fn read((number, text): Line<'_>) -> Result<Words, Mistake> {
        let wrong = |inside: &str| {
            format!(
                "{number}: {{{inside}}} is no place; write {{name}} for a value, or {{name:one|other}} where it chooses words"
            )
        };
        let (mut places, mut pieces) = (Vec::<Place>::new(), Vec::new());
        for (index, part) in text.split('$').enumerate() {
            if index % 2 == 1 {
                pieces.push((format!("${part}$"), None));
                continue;
            }
            let mut rest = part;
            while let Some((before, after)) = rest.split_once('{') {
                let (inside, after) = after.split_once('}').ok_or_else(|| wrong(after))?;
                let (name, words) = match inside.split_once(':') {
                    Some((name, words)) if words.contains('|') => (name, Some(words)),
                    _ => (inside, None),
                };
                if !is_name(name) {
                    return Err(wrong(inside));
                }
                let kind = if words.is_some() { Kind::Choice } else { Kind::Text };
                let at = places.iter().position(|(known, _)| known == name).unwrap_or_else(|| {
                    places.push((name.to_owned(), kind));
                    places.len() - 1
                });
                if places[at].1 != kind {
                    return Err(format!("{number}: {name} is a value in one place and chooses words in another"));
                }
                pieces.push((before.to_owned(), Some((at, words))));
                rest = after;
            }
            pieces.push((rest.to_owned(), None));
        }
        // In their order, each once: without numbers.
        let in_order = pieces.iter().filter_map(|(_, place)| place.as_ref()).map(|(at, _)| *at).eq(0..places.len());
        let mut phrase = String::new();
        for (before, place) in pieces {
            phrase += &before;
            match place {
                None => {}
                Some((_, words)) if in_order => phrase += &format!("{{{}}}", words.unwrap_or("")),
                Some((at, None)) => phrase += &format!("{{{}}}", at + 1),
                Some((at, Some(words))) => phrase += &format!("{{{}:{words}}}", at + 1),
            }
        }
        Ok(Words { places, phrase })
    }

    /// The text in Rust, with each value as `value` writes it.
    fn code(&self, value: impl Fn(&Place) -> String) -> String {
        let values: Vec<String> = self.places.iter().map(value).collect();
        format!("Text::phrase({:?}, vec![{}])", self.phrase, values.join(", "))
    }
}

fn is_name(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_lowercase())
        && name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_')
}

/// The name of a place that a line is no more than.
fn alone(line: &str) -> Option<&str> {
    line.strip_prefix('{')?.strip_suffix('}').filter(|name| is_name(name))
}

/// `struct Page` with a field for each place, and the document that it fills.
fn page_code(name: &str, lines: &[Line<'_>]) -> Result<String, Mistake> {
    let (mut fields, mut steps) = (Vec::<Place>::new(), String::new());
    let mut field = |number: usize, place: Place| {
        let known = fields.iter().find(|(known, _)| *known == place.0);
        match known {
            Some((_, kind)) if *kind != place.1 || matches!(kind, Kind::Blocks | Kind::Items) => {
                Err(format!("{number}: the place {} is on this page before", place.0))
            }
            Some(_) => Ok(()),
            None => {
                fields.push(place);
                Ok(())
            }
        }
    };
    for &(number, line) in lines {
        let (step, text) = match line {
            _ if line.starts_with("# ") => ("title", &line[2..]),
            _ if line.starts_with("## ") => ("section", &line[3..]),
            _ if line.starts_with("### ") => ("subsection", &line[4..]),
            _ if line.starts_with("- ") => ("item", &line[2..]),
            _ if line.starts_with("> ") => ("note", &line[2..]),
            _ => ("paragraph", line),
        };
        let several = match step {
            // A title of several forms, which Rust chooses.
            "title" => Some(("new", Kind::Text)),
            "paragraph" => Some(("blocks", Kind::Blocks)),
            "item" => Some(("items", Kind::Items)),
            "note" => Some(("notes", Kind::Items)),
            _ => None,
        };
        if let (Some(place), Some((step, kind))) = (alone(text), several) {
            field(number, (place.to_owned(), kind))?;
            let _ = match step {
                "new" => writeln!(steps, "let mut page = Skeleton::new({name:?}, self.{place});"),
                _ => writeln!(steps, "page.{step}(self.{place});"),
            };
            continue;
        }
        let words = Words::read((number, text))?;
        for place in &words.places {
            field(number, place.clone())?;
        }
        let text = words.code(|(place, kind)| match kind {
            Kind::Choice => format!("Text::from(self.{place})"),
            _ => format!("self.{place}.clone()"),
        });
        match step {
            "title" => {
                let _ = writeln!(steps, "let mut page = Skeleton::new({name:?}, {text});");
            }
            "item" | "note" => {
                let _ = writeln!(steps, "page.{step}s(Items::from([{text}]));");
            }
            _ => {
                let _ = writeln!(steps, "page.{step}({text});");
            }
        }
    }
    let fields: String = fields.iter().map(|(name, kind)| format!("pub(crate) {name}: {},\n", kind.name())).collect();
    Ok(format!(
        "/// What the page has places for.\npub(crate) struct Page {{\n{fields}}}\nimpl Page {{\n\
         /// The page, without what is empty.\npub(crate) fn document(self) -> Document {{\n{steps}page.done()\n}}\n}}\n"
    ))
}

/// A sentence, or a list of sentences, by its name.
struct Sentence<'a> {
    number: usize,
    name: &'a str,
    is_list: bool,
    lines: Vec<Line<'a>>,
}

fn grouped<'a>(lines: &[Line<'a>]) -> Result<Vec<Sentence<'a>>, Mistake> {
    let mut sentences: Vec<Sentence<'a>> = Vec::new();
    for &(number, line) in lines {
        if let Some(item) = line.strip_prefix("- ") {
            let list = sentences.last_mut().filter(|sentence| sentence.is_list);
            let list = list.ok_or_else(|| format!("{number}: an item of no list; write `name:` above it"))?;
            list.lines.push((number, item));
            continue;
        }
        let (name, text) = line.split_once(':').filter(|(name, _)| is_name(name)).ok_or_else(|| {
            format!("{number}: a sentence has a name: `name: words`, the name in small letters, digits and _")
        })?;
        let text = text.strip_prefix(' ').unwrap_or(text);
        let (is_list, lines) = if text.is_empty() { (true, Vec::new()) } else { (false, vec![(number, text)]) };
        sentences.push(Sentence { number, name, is_list, lines });
    }
    Ok(sentences)
}

/// `fn largest(force: impl Into<Text>) -> Text`; of a list without places, `fn assumptions() -> [Text; 4]`.
fn sentence_code(sentence: &Sentence<'_>) -> Result<String, Mistake> {
    let name = sentence.name;
    let words = sentence.lines.iter().map(|line| Words::read(*line)).collect::<Result<Vec<_>, _>>()?;
    if sentence.is_list {
        if words.is_empty() || words.iter().any(|words| !words.places.is_empty()) {
            return Err(format!("{}: the list {name} has items, and these have no places", sentence.number));
        }
        let items: Vec<String> = words.iter().map(|words| words.code(|_| String::new())).collect();
        return Ok(format!("pub(crate) fn {name}() -> [Text; {}] {{\n[{}]\n}}\n", items.len(), items.join(",\n")));
    }
    let [words] = &words[..] else { unreachable!("a sentence has one line") };
    let parameters: Vec<String> =
        words.places.iter().map(|(name, kind)| format!("{name}: impl Into<{}>", kind.name())).collect();
    let text = words.code(|(name, kind)| match kind {
        Kind::Choice => format!("Text::from({name}.into())"),
        _ => format!("{name}.into()"),
    });
    let told = sentence.lines[0].1.replace('[', "\\[").replace('<', "\\<");
    Ok(format!("/// {told}\npub(crate) fn {name}({}) -> Text {{\n{text}\n}}\n", parameters.join(", ")))
}
