//! In which sentences does a theorem on stars stand?

use num_rational::BigRational;

use crate::engine::Cycle;
use crate::exact::PhasorSum;
use crate::page::number::grouped;
use crate::page::{Text, phrase};
use crate::report::residual;
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
        true => phrase!(
            "**Impossible.** With {} throws no moment of {} can vanish. The number of throws is a power of the prime {}: were the moment 0, throws 1/{} of a turn apart would coincide. No rational spacing changes that.",
            *throws,
            listed,
            *prime,
            *prime
        ),
        false => phrase!(
            "**Impossible.** With {} throws the moments of {} cannot vanish together. Throws 1/{} of a turn apart would coincide. No rational spacing changes that.",
            *throws,
            listed,
            *prime
        ),
    }
}

/// How a star was made, and why it loses what it does.
pub(in crate::report) fn how(by: &By, throws: u32) -> Text {
    match by {
        By::MixedRadix(powers) => phrase!(
            "**Possible, by a star that a theorem describes.** The throw at $x$ steps of 1/{} turn has the place {}, where $x_q$ is the remainder of $x$ divided by $q$. Each term repeats within a turn, so it adds 0 to the moments asked for.",
            throws,
            place(powers)
        ),
        By::EveryMoment { two, odd } => phrase!(
            "**Possible, by a star that a theorem describes.** {} = {} · {}: throws half a turn apart are mirrored about the middle of the shaft, which cancels every even order, and of each half the places are sums over the prime factors of {}, which cancels order 1. So no order has a moment.",
            throws,
            *two,
            *odd,
            *odd
        ),
        By::Mirrored => "**Possible, by a star that a theorem describes.** Throws half a turn apart are mirrored about the middle of the shaft: they have opposite arms, and at an even order one direction, so that they cancel.".into(),
        By::MirrorImage => "**Possible, by a star that a theorem describes.** The shaft is its own mirror image: two throws in one direction have opposite arms, at every order.".into(),
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
            return Some(phrase!(
                "**Counted.** {} stars do, with cylinder 1 at 0°: the places are cut into sums of {} and {} places in {} ways.",
                stars,
                *p,
                *q,
                grouped(&covers.to_string())
            ));
        }
        Counted::MirrorImages => {
            return Some(phrase!(
                "**Counted.** {} stars do, with cylinder 1 at 0°: those that are their own mirror image.",
                stars
            ));
        }
    };
    Some(match &count.classes {
        Some(classes) => phrase!(
            "**Counted.** {} stars do, with cylinder 1 at 0°: {}; up to rotation, mirror and reversal {}.",
            stars,
            formula,
            grouped(&classes.to_string())
        ),
        None => phrase!("**Counted.** {} stars do, with cylinder 1 at 0°: {}.", stars, formula),
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
        Some(sum) => phrase!(
            "**The residual then.** Where the moment of order 1 is 0, that of order {} is at least {} times the least first-order moment of {} throws: {}.",
            *order,
            *factor,
            *of,
            residual::modulus_of(&sum)
        ),
        None => phrase!(
            "**The residual then.** Where the moment of order 1 is 0, that of order {} is at least {} times the least first-order moment of {} throws.",
            *order,
            *factor,
            *of
        ),
    }
}
