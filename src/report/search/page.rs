//! What is on the page of a search, and on the terminal? The best stars, pictures of the first, how they were found.

use num_bigint::BigUint;
use num_traits::Signed;

use super::super::residual;
use super::front::front_picture;
use super::pictures::pictures;
use super::table::{firing_order, left, stars, throws};
use crate::numbers;
use crate::page::{Block, Document, Number, Piece, Text, Unit, number, phrase};
use crate::report::stars;
use crate::report::texts::search as text;
use crate::search::{self, Front, Limit, Problem};
use crate::text::Untrusted;

/// So many stars are drawn.
const MOST_DRAWN: usize = 3;

/// The short answer: the stars.
pub fn search_answer(front: &Front) -> Document {
    let mut answer = Document::new("search", title(front));
    answer.blocks.extend(best(front).into_iter().map(Block::Paragraph));
    if !front.stars.is_empty() {
        answer.push(stars(front));
        answer.push(Block::List(legend(front)));
    }
    answer.blocks.extend(told(&front.problem));
    answer.push(Block::Paragraph(judged(front)));
    answer
}

/// The page, with pictures and layout files of the first stars.
pub fn search_page(front: &Front) -> Document {
    let is_found = !front.stars.is_empty();
    let first_stars = (1..).zip(front.stars.iter().take(MOST_DRAWN)).flat_map(|(number, star): (usize, _)| {
        let layout = Untrusted::new(star.layout_file(&front.problem));
        [
            Block::Heading(2, phrase!("Star {}", number)),
            Block::Pictures(pictures(&front.problem, star, number)),
            Block::folded(text::layout_file(number), vec![Block::Verbatim("toml", layout)]),
        ]
    });
    text::Page {
        title: title(front),
        best: Block::Answer(best(front)).into(),
        stars: is_found.then(|| stars(front)).into(),
        legend: if is_found { legend(front) } else { Vec::new() }.into(),
        front: front_picture(front).into(),
        first_stars: first_stars.collect(),
        theorems: told(&front.problem).into(),
        evaluated: judged(front).into(),
    }
    .document()
}

fn title(front: &Front) -> Text {
    let problem = &front.problem;
    let engine = match &problem.bank_angle {
        Some(angle) => phrase!("V{}, {}", problem.cylinders, number::angle(angle)),
        None => phrase!("In-line {}", problem.cylinders),
    };
    text::title(engine, problem.cycle)
}

/// How many are best, and the first of them.
fn best(front: &Front) -> Vec<Text> {
    let compared = front.compared();
    let (all, limits) = (number::grouped(&compared.to_string()), &front.limits.limits);
    let counted = front.stars.iter().map(|star| star.stars).sum::<Option<u64>>();
    let how_many = match front.stars.len() {
        0 if !limits.is_empty() => text::no_star_in_limits(limits_of(front)),
        1 if !limits.is_empty() => text::one_in_limits(front.limits.of, limits_of(front)),
        kept if !limits.is_empty() => text::several_in_limits(kept, front.limits.of, limits_of(front)),
        0 if front.all == BigUint::from(1_u8) => text::only_star_not_balanced(),
        0 => text::no_balanced_star(number::grouped(&front.all.to_string())),
        // Where firing orders are compared too, a crank star counts once for each.
        sets => match (sets, counted.filter(|several| BigUint::from(*several) <= compared)) {
            (1, Some(1)) if compared == BigUint::from(1_u8) => text::only_star(),
            (1, Some(1)) => text::one_best(all),
            (1, Some(several)) => text::alike(number::grouped(&several.to_string()), all),
            (1, None) => text::none_better(all),
            (_, Some(several)) => text::several_best(number::grouped(&several.to_string()), all, sets),
            (_, None) => text::sets_of_values(all, sets),
        },
    };
    let first = front.stars.first().map(|star| match (firing_order(star), left(star)) {
        (Some(order), Some(left)) => text::first(order, throws(star), left),
        (Some(order), None) => text::first_balanced(order, throws(star)),
        (None, Some(left)) => text::first_uneven(throws(star), left),
        (None, None) => text::first_uneven_balanced(throws(star)),
    });
    let condition = front.balanced.filter(|balanced| *balanced > 0).map(|balanced| {
        text::balanced_alone(number::grouped(&balanced.to_string()), number::grouped(&front.all.to_string()))
    });
    let orders = text::compared(residual::orders_in_words(&front.problem.orders));
    let minor = number::listed(&front.problem.minor_orders);
    let minor = (!minor.is_empty()).then(|| text::minor_orders_compared(minor));
    [how_many].into_iter().chain(first).chain(condition).chain([orders]).chain(minor).collect()
}

/// `order 2: 30 kN·m`.
fn limits_of(front: &Front) -> Text {
    let limit = |limit: &Limit| match limit.in_newton_metres {
        true => phrase!("order {}: {}", limit.order, Piece::Quantity(numbers::float(&limit.most), Unit::NEWTON_METRE)),
        false => phrase!("order {}: {} $m\\,r\\,\\omega^2 c\\,a$", limit.order, number::given(&limit.most)),
    };
    Text::joined(front.limits.limits.iter().map(limit), ", ")
}

fn legend(front: &Front) -> Vec<Text> {
    let problem = &front.problem;
    let equal = if front.counts_whole_classes() { text::equal_stars() } else { text::equal_stars_in_part() };
    let mut lines = vec![text::moments()];
    lines.extend(problem.orders.iter().any(|order| order % 2 == 1 && *order > 1).then(text::odd_orders));
    lines.extend(problem.bank_angle.as_ref().map(|_| text::vectors()));
    lines.push(text::throws());
    lines.extend(problem.neighbours.then(text::neighbours));
    lines.extend((!problem.minor_orders.is_empty()).then(text::minor_orders));
    lines.extend([equal, text::masses()]);
    lines.extend(banks(front));
    lines
}

/// How the pins of a V are split, and its banks offset.
fn banks(front: &Front) -> Vec<Text> {
    let problem = &front.problem;
    let split = problem.pin_split.as_ref().map(|split| {
        let degrees = number::signed_degrees(split);
        text::pin_split(number::degrees(&degrees.abs()), degrees.is_negative())
    });
    let offset = problem.bank_offset.as_ref().map(|offset| text::bank_offset(Number::exact(offset)));
    split.into_iter().chain(offset).collect()
}

/// What is known before anything is searched.
pub fn search_theorems(problem: &Problem) -> Document {
    Document { blocks: told(problem), ..Document::new("search", Text::default()) }
}

/// What theorems say of what is compared.
fn told(problem: &Problem) -> Vec<Block> {
    let sentences = stars::told(&search::theorems(problem));
    if sentences.is_empty() { Vec::new() } else { vec![Block::List(sentences)] }
}

fn judged(front: &Front) -> Text {
    if front.described.is_some() {
        return text::not_searched();
    }
    text::evaluated(number::grouped(&front.judged.to_string()), number::grouped(&front.cut.to_string()))
}
