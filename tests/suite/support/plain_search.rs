//! All stars by a plain loop: each a real layout, each pair compared by the decision procedure.

use std::cmp::Ordering;

use crankstar::engine::{Cycle, Engine};
use crankstar::exact::{PhasorSum, Turn};
use crankstar::numbers::evaluate;
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use crankstar::search::Problem;

/// Squared moments, their decimals, and how many stars have them.
pub struct Star {
    squares: Vec<(PhasorSum, f64)>,
    pub count: u64,
}

impl Star {
    pub fn new(squares: Vec<PhasorSum>, count: u64) -> Self {
        let with_decimal = |square: PhasorSum| {
            let decimal = evaluate(&square).re;
            (square, decimal)
        };
        Star { squares: squares.into_iter().map(with_decimal).collect(), count }
    }

    pub fn has_values_of(&self, other: &Star) -> bool {
        self.signs(other).all(|sign| sign == Ordering::Equal)
    }

    /// No worse in anything, and better in something.
    pub fn beats(&self, other: &Star) -> bool {
        self.signs(other).all(Ordering::is_le) && self.signs(other).any(Ordering::is_lt)
    }

    pub fn rank(&self, other: &Star) -> Ordering {
        self.signs(other).find(|sign| *sign != Ordering::Equal).unwrap_or(Ordering::Equal)
    }

    fn signs(&self, other: &Star) -> impl Iterator<Item = Ordering> {
        self.squares.iter().zip(&other.squares).map(|(own, theirs)| compare(own, theirs))
    }
}

/// Decimals good to 15 digits tell numbers below 10^6 apart that differ by a millionth; all others are decided.
fn compare((one, decimal): &(PhasorSum, f64), (other, other_decimal): &(PhasorSum, f64)) -> Ordering {
    if (decimal - other_decimal).abs() > 1e-6 {
        return decimal.total_cmp(other_decimal);
    }
    let difference = one.minus(other);
    match difference.vanishes() {
        true => Ordering::Equal,
        false => evaluate(&difference).re.total_cmp(&0.0),
    }
}

/// Directions of all even stars with cylinder 1 at 0, and how many directions make a turn.
pub fn of_even_throws(cylinders: u32, cycle: Cycle) -> (Vec<Vec<i64>>, i64) {
    let twice = cycle == Cycle::FourStroke && cylinders.is_multiple_of(2);
    let count = i64::from(cylinders) / if twice { 2 } else { 1 };
    let mut supply: Vec<i64> = (0..i64::from(cylinders)).map(|index| index % count).collect();
    supply.sort_unstable();
    let mut stars = Vec::new();
    arrange(&mut vec![0], &supply[1..], &mut stars);
    (stars, count)
}

/// All different arrangements of what is left, after what is placed.
pub fn arrange(placed: &mut Vec<i64>, left: &[i64], stars: &mut Vec<Vec<i64>>) {
    if left.is_empty() {
        return stars.push(placed.clone());
    }
    for (at, &throw) in left.iter().enumerate() {
        if at > 0 && left[at - 1] == throw {
            continue;
        }
        placed.push(throw);
        arrange(placed, &[&left[..at], &left[at + 1..]].concat(), stars);
        placed.pop();
    }
}

fn layout(cylinders: usize) -> Engine {
    let throws = vec!["0"; cylinders].join(", ");
    let text = format!("title = \"star\"\n[inline]\nthrows = [{throws}]\n");
    crankstar::file::parse("star.toml", &text).expect("a layout")
}

fn with_throws(layout: &Engine, star: &[i64], directions: i64) -> Engine {
    let mut draft = layout.clone().into_draft();
    for (cylinder, &throw) in draft.cylinders.iter_mut().zip(star) {
        cylinder.throw = Turn::fraction(throw, directions);
    }
    draft.build().expect("it holds together")
}

fn squares(layout: &Engine, orders: &[u32]) -> Vec<PhasorSum> {
    let sum = |&order: &u32| order::star(layout, Quantity::MOMENT, order, Some(Sense::Direct)).squared_modulus();
    orders.iter().map(sum).collect()
}

/// The distinct values of these stars, those with unbalanced first-order force left out where a grid asks for it.
pub fn all_stars(problem: &Problem, stars: Vec<Vec<i64>>, directions: i64) -> Vec<Star> {
    let bare = layout(problem.cylinders as usize);
    let mut distinct: Vec<Star> = Vec::new();
    for star in stars {
        let layout = with_throws(&bare, &star, directions);
        let force = order::star(&layout, Quantity::FORCE, 1, Some(Sense::Direct));
        if problem.grid.is_some() && !force.vanishes() {
            continue;
        }
        let star = Star::new(squares(&layout, &problem.orders), 1);
        match distinct.binary_search_by(|known| known.rank(&star)) {
            Ok(at) => distinct[at].count += 1,
            Err(at) => distinct.insert(at, star),
        }
    }
    distinct
}
