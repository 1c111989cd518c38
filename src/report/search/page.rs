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
use crate::search::{self, Front, Limit, Problem};
use crate::text::Untrusted;

/// So many stars are drawn.
const MOST_DRAWN: usize = 3;

const MOMENTS: &str = "Moments are about the mid-plane of the engine, in multiples of $m r \\omega^2 c_k a$: $m$ the reciprocating mass of a cylinder, $r$ the crank \
    radius, $\\omega$ the speed of the crank, $c_k$ the coefficient of order k, $a$ the spacing of neighbouring throws.";
const OF_VEES: &str = "$C_k^+$ and $C_k^-$ are the direct and the reverse vector of the moment of order k, which turn with the crank and against it: the largest moment is half the sum of \
    their lengths.";
const EQUAL: &str =
    "Equal stars: the number that share these values. Stars that differ by rotation, mirror or reversal count as one.";
const EQUAL_IN_PART: &str = "Equal stars: the number that share these values. Stars count as one if they differ by rotation, or by a mirror or reversal that changes no value; here at least one of these changes some.";
const NEIGHBOURS: &str =
    "Neighbours: pairs of cylinders on neighbouring throws of one bank that fire in succession or at once.";
const MINOR: &str = "Minor orders: the length of the sum of phase vectors, the firing star of this firing order weighed by the deflections of the throws in a mode of \
    torsional vibration. Each firing order of a star is compared by itself.";
const THROWS: &str = "Throws: the angles of the crankpins, from the free end.";
const MASSES: &str = "Masses and rods are equal, and the throws are at equal distances.";

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
    let mut page = Document::new("search", title(front));
    page.push(Block::Answer(best(front)));
    if !front.stars.is_empty() {
        page.push(stars(front));
        page.push(Block::List(legend(front)));
        page.blocks.extend(front_picture(front).map(|picture| Block::Pictures(vec![picture])));
        page.push(Block::Heading(1, "Pictures of the first stars".into()));
    }
    for (index, star) in front.stars.iter().take(MOST_DRAWN).enumerate() {
        let number = index + 1;
        page.push(Block::Heading(2, phrase!("Star {}", number)));
        page.push(Block::Pictures(pictures(&front.problem, star, number)));
        let layout = Untrusted::new(star.layout_file(&front.problem));
        page.push(Block::folded(
            phrase!("Star {} as a layout file, which every other command reads", number),
            vec![Block::Verbatim("toml", layout)],
        ));
    }
    let theorems = told(&front.problem);
    if !theorems.is_empty() {
        page.push(Block::Heading(1, "What theorems say".into()));
        page.blocks.extend(theorems);
    }
    page.section("Method", Block::Paragraph(judged(front)));
    page
}

fn title(front: &Front) -> Text {
    let problem = &front.problem;
    let engine = match &problem.bank_angle {
        Some(angle) => phrase!("V{}, {}", problem.cylinders, number::angle(angle)),
        None => phrase!("In-line {}", problem.cylinders),
    };
    phrase!("{}, {two-stroke|four-stroke}: the crank stars that balance best", engine, problem.cycle)
}

/// How many are best, and the first of them.
fn best(front: &Front) -> Vec<Text> {
    let (all, limits) = (number::grouped(&front.all.to_string()), &front.limits.limits);
    let orders = phrase!("Compared: the moments of {}.", residual::orders_in_words(&front.problem.orders));
    let counted = front.stars.iter().map(|star| star.stars).sum::<Option<u64>>();
    let how_many = match front.stars.len() {
        0 if !limits.is_empty() => phrase!("**No crank star keeps these limits:** {}.", limits_of(front)),
        1 if !limits.is_empty() => phrase!(
            "**One of the {} crank stars of the front keeps these limits:** {}. It is the best of all that do.",
            front.limits.of,
            limits_of(front)
        ),
        kept if !limits.is_empty() => phrase!(
            "**{} crank stars of the {} of the front keep these limits:** {}. They are the best of all that do.",
            kept,
            front.limits.of,
            limits_of(front)
        ),
        0 => phrase!("None of the {} crank stars has balanced first-order force.", all),
        // Where firing orders are compared too, a crank star counts once for each.
        sets => match (sets, counted.filter(|several| BigUint::from(*several) <= front.all)) {
            (1, Some(1)) => phrase!("**One of the {} crank stars is the best** in all values compared.", all),
            (1, Some(several)) => phrase!(
                "**{} of the {} crank stars are the best** in all values compared, and have the same values.",
                number::grouped(&several.to_string()),
                all
            ),
            (1, None) => phrase!("**None of the {} crank stars is better** than this one in any value compared.", all),
            (_, Some(several)) => phrase!(
                "**{} of the {} crank stars are the best,** with {} different sets of values: no other is as good as one of them in all values compared and better in one.",
                number::grouped(&several.to_string()),
                all,
                sets
            ),
            (_, None) => phrase!(
                "**The best of the {} crank stars have {} different sets of values:** no other is as good as one of them in all values compared and better in one.",
                all,
                sets
            ),
        },
    };
    let first = front.stars.first().map(|star| match (firing_order(star), left(star)) {
        (Some(order), Some(left)) => {
            phrase!("**The first:** firing order {}, throws at {}°; residual moments: {}.", order, throws(star), left)
        }
        (Some(order), None) => {
            phrase!(
                "**The first:** firing order {}, throws at {}°; no moment of these orders remains.",
                order,
                throws(star)
            )
        }
        (None, Some(left)) => {
            phrase!("**The first:** throws at {}°; it does not fire evenly; residual moments: {}.", throws(star), left)
        }
        (None, None) => {
            phrase!(
                "**The first:** throws at {}°; it does not fire evenly; no moment of these orders remains.",
                throws(star)
            )
        }
    });
    let minor = number::listed(&front.problem.minor_orders);
    let minor =
        (!minor.is_empty()).then(|| phrase!("Also compared: these minor orders of torsional vibration: {}.", minor));
    [how_many].into_iter().chain(first).chain([orders]).chain(minor).collect()
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
    let of_vees = front.problem.bank_angle.as_ref().map(|_| OF_VEES);
    let neighbours = front.problem.neighbours.then_some(NEIGHBOURS);
    let minor = (!front.problem.minor_orders.is_empty()).then_some(MINOR);
    let equal = if front.counts_whole_classes() { EQUAL } else { EQUAL_IN_PART };
    let words =
        [MOMENTS].into_iter().chain(of_vees).chain([THROWS]).chain(neighbours).chain(minor).chain([equal, MASSES]);
    words.map(Text::from).chain(banks(front)).collect()
}

/// How the pins of a V are split, and its banks offset.
fn banks(front: &Front) -> Vec<Text> {
    let problem = &front.problem;
    let split = problem.pin_split.as_ref().map(|split| {
        let degrees = number::signed_degrees(split);
        phrase!(
            "Each throw has two pins: that of bank 2 is {} {behind|ahead}. The throws are those of bank 1.",
            number::degrees(&degrees.abs()),
            degrees.is_negative()
        )
    });
    let offset = problem
        .bank_offset
        .as_ref()
        .map(|offset| phrase!("Bank 1 is {} spacings towards the free end of bank 2.", Number::exact(offset)));
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
        return "No search was needed: all compared moments vanish.".into();
    }
    phrase!(
        "Stars evaluated one by one, of those that differ by rotation, mirror or reversal one each: {}. Partial stars pruned, since none of their completions can be among the best: {}.",
        number::grouped(&front.judged.to_string()),
        number::grouped(&front.cut.to_string())
    )
}
