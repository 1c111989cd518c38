//! In which sentences does a theorem on stars stand?

use num_rational::BigRational;

use crate::engine::Cycle;
use crate::exact::PhasorSum;
use crate::page::Text;
use crate::page::number::grouped;
use crate::report::residual;
use crate::report::texts::stars as text;
use crate::search::{self, Options, Problem, Theorems};
use crate::stars::{By, Count, Counted, Least, Obstruction};

/// The least moment of more throws is not searched for a sentence.
const MOST_SEARCHED: u32 = 7;

/// What theorems say of a question, a sentence or two each.
pub(in crate::report) fn told(theorems: &Theorems) -> Vec<Text> {
    let never = theorems.never.iter().map(never);
    let lost = theorems.lost.as_ref().map(|made| how(&made.by, made.star.directions()));
    let count = theorems.count.as_ref().and_then(counted);
    never.chain(lost).chain(count).chain(theorems.least.iter().map(least)).collect()
}

/// Why no star loses these moments.
pub(in crate::report) fn never(obstruction: &Obstruction) -> Text {
    let Obstruction { throws, prime, power, orders } = obstruction;
    let listed = residual::orders_in_words(orders);
    match power == throws {
        true => text::impossible(*throws, listed, *prime),
        false => text::impossible_together(*throws, listed, *prime),
    }
}

/// How a star was made, and why it loses what it does.
pub(in crate::report) fn how(by: &By, throws: u32) -> Text {
    match by {
        By::MixedRadix(powers) => text::by_remainders(throws, place(powers)),
        By::EveryMoment { two, odd } => text::by_halves(throws, *two, *odd),
        By::Mirrored => text::by_mirrored_halves(),
        By::MirrorImage => text::by_mirror_image(),
    }
}

/// `x_3 + 3 x_5`, of remainders.
fn place(powers: &[u32]) -> Text {
    let mut scale = 1;
    let mut terms = Vec::new();
    for power in powers {
        let digit = format!("x_{{{power}}}");
        terms.push(if scale == 1 { digit } else { format!("{scale}\\,{digit}") });
        scale *= power;
    }
    Text::formula(terms.join(" + "))
}

/// How many stars lose the moments asked for.
fn counted(count: &Count) -> Option<Text> {
    let stars = grouped(&count.stars.to_string());
    let formula = match &count.by {
        Counted::None => return None,
        Counted::Sums([p, q]) => Text::formula(format!("2\\,({p}-1)!\\,({q}-1)!")),
        Counted::Covers([p, q], covers) => {
            return Some(text::counted_covers(stars, *p, *q, grouped(&covers.to_string())));
        }
        Counted::MirrorImages if count.stars == 1_u8.into() => return Some(text::counted_mirror_image()),
        Counted::MirrorImages => return Some(text::counted_mirror_images(stars)),
    };
    Some(match &count.classes {
        Some(classes) => text::counted_classes(stars, formula, grouped(&classes.to_string())),
        None => text::counted(stars, formula),
    })
}

/// The least moment of another order where the first is 0, as a sum; none of more throws than are searched for a sentence.
pub(super) fn least_moment(Least { factor, of, .. }: &Least) -> Option<PhasorSum> {
    let problem = Problem::inline(*of, Cycle::TwoStroke, &[1]);
    let options = Options { threads: 1, ..Options::default() };
    let front = (*of <= MOST_SEARCHED).then(|| search::search(&problem, &options))?.ok()?;
    Some(front.stars.first()?.moments.first()?.sum.scaled(&BigRational::from_integer((*factor).into())))
}

/// What is left of another order.
fn least(least: &Least) -> Text {
    let Least { order, factor, of } = least;
    match least_moment(least) {
        Some(sum) => text::residual(*order, *factor, *of, residual::modulus_of(&sum)),
        None => text::residual_bound(*order, *factor, *of),
    }
}
