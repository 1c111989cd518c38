//! What is on the page of stars, and on the terminal?

use super::proofs::THEOREMS;
use super::study::{Shown, StarsStudy, golden};
use super::tables::{self, every, first};
use crate::order::Masses;
use crate::page::number::Amount;
use crate::page::{Block, Document, File, Text, phrase};
use crate::report::search::star_pictures;
use crate::report::theorem_words;
use crate::text::Untrusted;
use crate::verdict::{self, EveryOrderTheorem};

const TITLE: &str = "Crank stars: which moments can vanish, and which cannot";
const READING: &str = "A star says where each throw along the shaft points. Engines in line, two-stroke (four-stroke with an odd number of cylinders too), evenly firing, one spacing apart, equal masses and rods, no pin offset: of the odd orders only order 1 exists. Yes: for some star the moments of all these orders vanish. No, with a prime q: throws 1/q of a turn apart would coincide. Stars are counted with cylinder 1 at 0°.";
const A_STAR: &str = "A star: the directions of its throws from the free end, in steps of 1/n turn, n the number of cylinders. Of the stars with the least moment of order 1 it has the least of order 2.";
const SOURCES: [&str; 4] = [
    "**Known.** That a moment of order 1 is zero says that an equiangular polygon has the sides 1, 2, …, n in some order. R. Dawson, Arithmetic polygons, American Mathematical Monthly 119 (2012) 695–698, says when there is one; that coprime factors suffice is a competition problem.",
    "**Known.** Which sums of roots of unity vanish: L. Rédei, N. G. de Bruijn, I. J. Schoenberg; T. Y. Lam and K. H. Leung, On vanishing sums of roots of unity, Journal of Algebra 224 (2000) 91–109. That 0, …, pq − 1 is a sum of two sets in two ways alone is de Bruijn's.",
    "**New**, as far as a short search shows: the theorem for sets of orders, so 12, 15 and 30; the residual beside a vanished order; the counts; the least moments; and what follows for engines.",
    "**Open.** How many stars of thirty have no moment of order 1, and how fast the least moment falls with a prime number of cylinders.",
];

fn answer_box() -> Vec<Text> {
    vec![
        "Of engines of several cylinders whose throws stand one in each of n evenly spread directions (every evenly firing two-stroke in line, four-strokes with an odd number of cylinders):".into(),
        "**Five cylinders cannot be without a first-order couple, and six can.** The moment of order 1 can be zero where the number of cylinders is not a power of a prime, and only there.".into(),
        phrase!(
            "**The moments of orders 1 and 2 can vanish together with {} cylinders and no fewer, those of orders 1, 2 and 4 with {} and no fewer.**",
            first(|_| vec![1, 2]),
            first(|_| vec![1, 2, 4])
        ),
        phrase!(
            "**With {} cylinders, and no fewer, an evenly firing two-stroke engine in line can be free of the moments of every order that exists without a pin offset.** Its force begins at order {}.",
            first(every),
            first(every)
        ),
        "**No bank angle removes the first-order couple** of a V8 whose four pins stand a quarter turn apart (cross-plane), or of a V10 on five pins a fifth apart: what turns with the crank is left to counterweights.".into(),
    ]
}

/// The short answer: what each number of cylinders can lose.
pub fn stars_answer(study: &StarsStudy) -> Document {
    let mut answer = Document::new("stars", TITLE);
    answer.push(Block::List(answer_box()));
    answer.push(tables::fates(&study.counts));
    answer.push(Block::Note(READING.into()));
    answer.push(tables::best(&study.best, false));
    answer.push(Block::Note(A_STAR.into()));
    answer
}

/// The page, with its engines drawn.
pub fn stars_page(study: &StarsStudy) -> Document {
    let mut page = Document { has_contents: true, ..Document::new("README", TITLE) };
    page.push(Block::Answer(answer_box()));
    page.section("Which moments can vanish, by number of cylinders", READING);
    page.push(tables::fates(&study.counts));
    page.push(Block::Heading(1, "Theorems and proofs".into()));
    for (index, [heading, theorem, proof]) in THEOREMS.into_iter().enumerate() {
        page.push(Block::Heading(2, heading.into()));
        page.push(Block::Paragraph(theorem.into()));
        page.push(phrase!("**Proof.** {} ∎", Text::from(proof)));
        page.blocks.extend(example(study, index));
    }
    page.section("The best stars", tables::best(&study.best, true));
    page.push(Block::Note(A_STAR.into()));
    page.push(Block::Note(phrase!(
        "Lengths are exact, in $m r \\omega^2 c_k a$, $a$ the spacing; where ≈ stands alone, the exact length is too long to be written. Up to 12 cylinders the program examines all stars when it writes this page; 14 and 15 follow from the theorems. Of 13, 16, 17 and 18 the moments are those of a star that was found once, by {} or, of 18, among the covers by sums of two and three places. That no star has less is computed by the tests in another way, in whole numbers with a bound of what rounding does; for 17 in a longer run of the tests.",
        Text::code("crankstar search")
    )));
    page.push(Block::Heading(1, "Engines to try".into()));
    for shown in &study.engines {
        page.blocks.extend(engine(shown));
    }
    page.section("Sources", Block::List(SOURCES.map(Text::from).into()));
    page
}

/// What the program computes to a theorem.
fn example(study: &StarsStudy, theorem: usize) -> Vec<Block> {
    match theorem {
        6 => vec![tables::four_stroke().into()],
        7 => {
            let [first, second] = [1, 2].map(golden);
            let golden = phrase!(
                "Five cylinders in the golden ratio, decided by the program: order 1 leaves {}, order 2 leaves {}.",
                Amount::of(&first),
                Amount::of(&second)
            );
            vec![tables::spaced().into(), Block::Paragraph(golden)]
        }
        8 => vec![tables::vees(&study.best).into()],
        _ => Vec::new(),
    }
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
        blocks.push(Block::Paragraph("Of every order, proved by the program:".into()));
        blocks.push(Block::List(theorem_words::statements(engine, &theorem)));
    }
    // Where no moment is left there is no sum to show.
    let number = problem.cylinders as usize;
    blocks.push(Block::Pictures(star_pictures(problem, star, number, shown.first_left())));
    let file = name(shown);
    blocks.push(Block::Paragraph(phrase!(
        "To try: {}, or {}.",
        Text::code(format!("crankstar classify {file} --all-orders --json")),
        Text::link(Text::label(file.clone()), file.clone())
    )));
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
