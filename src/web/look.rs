//! What does a reader see: first the verdicts, then the engine with its stars in motion?

use serde_json::{Value, json};

use super::judged::Judged;
use super::mistake::Mistake;
use super::slider::Set;
use super::written::Written;
use crate::engine::Engine;
use crate::page::figure::Figure;
use crate::page::{self, Block, Document, Format, Language, Options, Table, text_in};
use crate::report::{self, moving};
use crate::text;
use crate::verdict::Judgement;

/// The verdicts in words, which a reader sees first.
pub(super) fn verdicts(judged: &Judged) -> Value {
    let (title, summary, answer) = match judged {
        Judged::Known { engine, judged, .. } => {
            let mut answer = report::engine_answer(engine, judged);
            // The page has the box by itself.
            answer.blocks.retain(|block| !matches!(block, Block::Answer(_)));
            (engine.title(), report::engine_summary(engine, judged), answer)
        }
        Judged::Open { family, orders } => {
            (family.title(), report::family_summary(family, orders), report::family_answer(family, orders))
        }
    };
    json!({
        "title": text::xml(&title.escaped(text::Format::Plain)),
        "summary": html(std::slice::from_ref(&summary)),
        "verdicts": html(&answer.blocks),
        "spoken": spoken(&answer),
    })
}

/// The verdicts, the engine in motion and its stars; with the text of the layout where a value was set in it.
pub(super) fn look(layout: Written, set: Option<&Set>) -> Result<Value, Mistake> {
    let layout = match set {
        None => layout,
        Some(set) => Written { text: set.within(&layout)?, ..layout },
    };
    let judged = layout.judged()?;
    let (scenes, stars) = match &judged {
        Judged::Known { engine, judged, family } => {
            let family = family.as_ref().map(|(family, orders)| (family.as_ref(), orders.as_slice()));
            let scene = moving::scene(engine, judged, family, report::Weighing::usual());
            (vec![scene], stars(engine, judged))
        }
        Judged::Open { family, orders } => {
            let numbers: Vec<u32> = orders.iter().map(|order| order.order).collect();
            (moving::open_scenes(family, &numbers), Vec::new())
        }
    };
    let fragment = |(index, scene): (usize, &moving::Scene)| {
        moving::moving_fragment(scene, &format!("scene-{}", index + 1), Language::En)
    };
    let mut look = verdicts(&judged);
    look["text"] = json!(set.map(|_| &layout.text));
    look["scenes"] = scenes.iter().enumerate().map(fragment).collect();
    look["stars"] = stars.into();
    Ok(look)
}

/// The star of each order in the size of a stamp, in the order in which a scene has them.
fn stars(engine: &Engine, judged: &Judgement) -> Vec<Value> {
    let star = |(order, figure): (u32, Figure)| {
        let name = format!("Order {order}");
        json!({ "svg": page::svg(&figure, &name), "name": name })
    };
    report::small_stars(engine, judged).into_iter().map(star).collect()
}

/// Blocks as parts of the page.
pub(super) fn html(blocks: &[Block]) -> String {
    page::blocks_in(blocks, Format::Html, &Options::default())
}

/// What a table of verdicts says, as sentences for those who hear the page.
fn spoken(answer: &Document) -> String {
    let tables = answer.blocks.iter().filter_map(|block| match block {
        Block::Table(table) => Some(sentences(table)),
        Block::Heading(..)
        | Block::Paragraph(_)
        | Block::Answer(_)
        | Block::Pictures(_)
        | Block::Formula(..)
        | Block::List(_)
        | Block::Folded(_)
        | Block::Note(_)
        | Block::Live(_)
        | Block::Verbatim(..) => None,
    });
    tables.collect::<Vec<_>>().join(" ")
}

fn sentences(table: &Table) -> String {
    let plain = |text: &page::Text| text_in(text, Format::PLAIN);
    let of_row = |row: &Vec<page::Text>| {
        let cells = table.header.iter().zip(row).map(|(head, cell)| format!("{} {}", plain(head), plain(cell)));
        cells.collect::<Vec<_>>().join(", ") + "."
    };
    table.rows.iter().map(of_row).collect::<Vec<_>>().join(" ")
}
