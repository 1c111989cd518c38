//! What is on the page of stars, and on the terminal?

use super::study::{Shown, StarsStudy, golden};
use super::tables::{self, every, first};
use crate::order::Masses;
use crate::page::number::Amount;
use crate::page::{Block, Document, File, Text, phrase};
use crate::report::search::star_pictures;
use crate::report::texts::stars as text;
use crate::report::theorem_words;
use crate::text::Untrusted;
use crate::verdict::{self, EveryOrderTheorem};

fn answer_box() -> Vec<Text> {
    vec![
        text::scope(),
        text::five_and_six(),
        text::orders_together(first(|_| vec![1, 2]), first(|_| vec![1, 2, 4])),
        text::every_moment(first(every)),
        text::bank_angle(),
    ]
}

/// The short answer: what each number of cylinders can lose.
pub fn stars_answer(study: &StarsStudy) -> Document {
    let mut answer = Document::new("stars", text::title());
    answer.push(Block::List(answer_box()));
    answer.push(tables::fates(&study.counts));
    answer.push(Block::Note(text::reading()));
    answer.push(tables::best(&study.best, false));
    answer.push(Block::Note(text::a_star()));
    answer
}

/// The page, with its engines drawn.
pub fn stars_page(study: &StarsStudy) -> Document {
    let page = text::Page {
        title: text::title(),
        answer: Block::Answer(answer_box()).into(),
        reading: text::reading().into(),
        fates: tables::fates(&study.counts).into(),
        prime_power_proof: text::prime_power_proof(),
        remainders_proof: text::remainders_proof(),
        orders_together_proof: text::orders_together_proof(),
        every_moment_proof: text::every_moment_proof(),
        count_proof: text::count_proof(),
        second_order_proof: text::second_order_proof(),
        four_stroke_proof: text::four_stroke_proof(),
        four_stroke: tables::four_stroke().into(),
        spacings_proof: text::spacings_proof(),
        spaced: tables::spaced().into(),
        order_1: Amount::of(&golden(1)).into(),
        order_2: Amount::of(&golden(2)).into(),
        banks_proof: text::banks_proof(),
        vees: tables::vees(&study.best).into(),
        best: tables::best(&study.best, true).into(),
        a_star: [text::a_star()].into(),
        search: Text::code("crankstar search"),
        engines: study.engines.iter().flat_map(engine).collect(),
    };
    Document { name: "README", has_contents: true, ..page.document() }
}

fn name(shown: &Shown) -> String {
    format!("star-{}.toml", shown.problem.cylinders)
}

/// An engine, what is true of its every order, its pictures, and its layout file.
fn engine(shown: &Shown) -> Vec<Block> {
    let Shown { problem, star } = shown;
    let mut blocks = vec![Block::Heading(2, phrase!("{} cylinders", problem.cylinders))];
    let engine = star.engine(problem).ok();
    if let Some(engine) = &engine
        && let Ok(EveryOrderTheorem::Period(theorem)) = verdict::every_order(engine, Masses::Reciprocating)
    {
        blocks.push(text::each_order().into());
        blocks.push(Block::List(theorem_words::statements(engine, &theorem)));
    }
    // Where no moment is left there is no sum to show.
    let number = problem.cylinders as usize;
    blocks.push(Block::Pictures(star_pictures(problem, star, number, shown.first_left())));
    let file = name(shown);
    let command = Text::code(format!("crankstar classify {file} --all-orders --json"));
    blocks.push(text::to_try(command, Text::link(Text::label(file.clone()), file)).into());
    blocks.push(Block::folded(
        "The layout file",
        vec![Block::Verbatim("toml", Untrusted::new(star.layout_file(problem)))],
    ));
    blocks
}

/// The engines of the page and the best stars as layout files.
pub fn stars_layouts(study: &StarsStudy) -> Vec<File> {
    let file = |shown: &Shown| File { name: name(shown), text: shown.star.layout_file(&shown.problem) };
    let best = study.best.iter().map(|best| File { name: tables::best_name(best), text: best.layout_file() });
    study.engines.iter().map(file).chain(best).collect()
}
