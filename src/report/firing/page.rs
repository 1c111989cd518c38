//! What is on the page of the firing stars, and on the terminal?

use super::super::star::{firing_figure, legend_of_one_scale};
use super::super::{argument, dead_centres, residual};
use super::words::names_of;
use super::{FiringStudy, tables, words};
use crate::engine::Engine;
use crate::firing::{FiringStar, StarOrder, Weights};
use crate::page::{Block, Document, Picture, Text, phrase};
use crate::report::texts::firing as text;
use crate::verdict::JudgedStar;

/// At most this many stars are drawn.
const MOST_DRAWN: usize = 12;

const STAR: &str = "S_\\kappa = \\sum_j r_j\\, e^{-i\\kappa\\varphi_j}";
const STAR_OF_A_MODE: &str = "S_\\kappa = \\sum_j \\Delta_j\\, r_j\\, e^{-i\\kappa\\varphi_j}";

/// What shakes the crankshaft: how evenly it fires, which orders vanish, which is the strongest.
fn answer(study: &FiringStudy) -> Vec<Text> {
    let mut lines: Vec<Text> = words::evenness(&study.engine).into_iter().collect();
    lines.extend(dead_centres::counted(&study.engine));
    if study.engine.gas().is_some_and(|gas| !gas.is_shared()) {
        lines.push(text::unlike_gas(Text::code("crankstar torque")));
    }
    match study.pattern() {
        Ok(pattern) => {
            let orders = words::statement(pattern);
            lines.push(match (study.weights.is_mode_shape(), study.is_of_one_class()) {
                (true, _) => text::work_on_mode(orders),
                (false, true) => text::gas_torque(orders),
                (false, false) => text::gas_torque_of_classes(orders),
            });
            lines.extend(words::major(pattern));
            lines.extend(words::strongest(pattern));
        }
        Err(why) => lines.push(words::no_pattern(why)),
    }
    lines
}

/// The short answer.
pub fn firing_answer(study: &FiringStudy) -> Document {
    let mut page = Document::new("firing", study.engine.title());
    page.push(tables::orders(study));
    page.blocks.extend(answer(study).into_iter().map(Block::Paragraph));
    page
}

/// The page, with the stars that are left and the proof of each.
pub fn firing_page(study: &FiringStudy) -> Document {
    let is_of_a_mode = study.weights.is_mode_shape();
    text::Page {
        engine: study.engine.title().into(),
        answer: Block::Answer(answer(study)).into(),
        picture: picture(study).into(),
        orders: tables::orders(study).into(),
        meaning: meaning(is_of_a_mode).into_iter().collect(),
        firings: tables::firings(study).into(),
        every_order: study.pattern().ok().map(words::why).into(),
        proofs: Block::List(each(study, argued)).into(),
        certificates: Block::folded("Firing stars: the certificates", vec![Block::List(each(study, certified))]).into(),
        assumptions: assumed(is_of_a_mode).into(),
    }
    .document()
}

/// What the report of an engine shows of its firing stars, where the file asks for them; none where it does not.
pub(in crate::report) fn firing_section(engine: &Engine) -> Vec<Block> {
    if !engine.effects().firing {
        return Vec::new();
    }
    let heading = Block::Heading(1, "Firing stars".into());
    match FiringStudy::new(engine, &[], Weights::Rigid) {
        Err(why) => vec![heading, Block::Paragraph(text::no_stars(why.to_string()))],
        Ok(study) => {
            let [meaning, formula] = meaning(false);
            let proofs = vec![Block::List(each(&study, argued)), Block::List(each(&study, certified))];
            vec![
                heading,
                Block::List(answer(&study)),
                picture(&study).into(),
                tables::orders(&study).into(),
                meaning,
                formula,
                Block::folded("Firing stars: the proofs", proofs),
                Block::List(assumed(false)),
            ]
        }
    }
}

/// What a star is.
pub(super) fn meaning(of_a_mode: bool) -> [Block; 2] {
    let (meaning, formula) =
        if of_a_mode { (text::meaning_of_a_mode(), STAR_OF_A_MODE) } else { (text::meaning(), STAR) };
    [meaning.into(), Block::Formula(formula.to_owned(), None)]
}

/// What the verdicts rest on.
pub(super) fn assumed(with_mode_shape: bool) -> Vec<Text> {
    text::assumptions().into_iter().chain((!with_mode_shape).then(text::rigid)).collect()
}

/// The stars of the first orders, all of them up to this many.
fn picture(study: &FiringStudy) -> Picture {
    let is_single = study.is_of_one_class();
    let heading = |order: &StarOrder, star: &FiringStar| match (is_single, star.sources.len()) {
        (true, _) => format!("Order {}", order.order),
        (false, 1) => format!("Order {} (cylinder {})", order.order, names_of(&study.engine, star)),
        (false, _) => format!("Order {} (cylinders {})", order.order, names_of(&study.engine, star)),
    };
    let stars = || study.orders.iter().flat_map(|order| order.stars.iter().map(move |star| (order, star)));
    let headed: Vec<(String, JudgedStar<'_>)> =
        stars().take(MOST_DRAWN).map(|(order, star)| (heading(order, star), star.into())).collect();
    let drawn: Vec<JudgedStar<'_>> = headed.iter().map(|(_, star)| *star).collect();
    let legend = legend_of_one_scale(&study.engine, &drawn);
    let caption = match stars().count() {
        all if all > MOST_DRAWN => text::first_stars(MOST_DRAWN, all, legend),
        _ => phrase!("Firing stars. {}", legend),
    };
    Picture::new("firing-stars", caption, firing_figure(&study.engine, headed))
}

/// A line per star.
fn each(study: &FiringStudy, line: fn(&FiringStudy, &StarOrder, &FiringStar) -> Text) -> Vec<Text> {
    study.orders.iter().flat_map(|order| order.stars.iter().map(move |star| line(study, order, star))).collect()
}

/// A star with its argument.
pub(super) fn argued(study: &FiringStudy, order: &StarOrder, star: &FiringStar) -> Text {
    let argument = argument::argument(&study.engine, star);
    let name = order.order.to_string();
    let value = residual::value(&symbol(order), star);
    match order.only() {
        Some(_) => phrase!("**Order {}:** {}. {}", name, value, argument),
        None => phrase!("**Order {} ({}):** {}. {}", name, names_of(&study.engine, star), value, argument),
    }
}

fn certified(_: &FiringStudy, order: &StarOrder, star: &FiringStar) -> Text {
    phrase!("{}: {}", Text::formula(symbol(order)), argument::certificate_of(&star.sum, &star.certificate))
}

/// `S_{3/2}`.
fn symbol(order: &StarOrder) -> String {
    format!("S_{{{}}}", order.order.exact())
}
