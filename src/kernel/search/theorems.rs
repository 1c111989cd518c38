//! What is known of a question before anything is searched, and which question needs no search?

use super::answer::{self, Front};
use super::front::StarValues;
use super::options::{Options, SearchError};
use super::pieces::search;
use super::problem::{MOST_THROWS, Problem};
use super::space::Space;
use super::tables::Tables;
use super::walk::Counts;
use super::{judged, symmetry};
use crate::stars::{self, Count, Fate, Least, Made, Obstruction, Star};

/// Up to this many throws all stars are searched where a theorem gives one without their count: that takes seconds.
const SEARCHED_AT_ONCE: u32 = 16;
/// Up to this many stars of a theorem are gone through for the first of them.
const MOST_LISTED: usize = 100_000;

/// What theorems say of a question.
#[derive(Clone, Debug, Default)]
pub struct Theorems {
    /// Orders whose moments no star loses together: first each that is alone, those of one kind in one row.
    pub never: Vec<Obstruction>,
    /// A star that loses the moments of all orders compared.
    pub lost: Option<Made>,
    /// How many do.
    pub count: Option<Count>,
    /// What is left of other orders where the first is lost; empty where it is not compared.
    pub least: Vec<Least>,
}

/// What theorems say of a question; nothing of a grid.
pub fn theorems(problem: &Problem) -> Theorems {
    let orders = compared(problem);
    let Some(pins) = problem.pins().filter(|_| !orders.is_empty()) else { return Theorems::default() };
    let mut never: Vec<Obstruction> = Vec::new();
    for &order in &orders {
        if let Fate::Never(alone) = stars::fate(pins, &[order]) {
            // An order of the same kind has the same reason.
            let same =
                |known: &&mut Obstruction| known.orders.first().is_some_and(|first| pins.is_one_kind(*first, order));
            match never.iter_mut().find(same) {
                Some(known) => known.orders.push(order),
                None => never.push(alone),
            }
        }
    }
    let (all, mut lost) = (stars::fate(pins, &orders), None);
    match all {
        Fate::Lost(made) => lost = Some(made),
        Fate::Never(together) if never.is_empty() => never.push(together),
        Fate::Never(_) | Fate::Open => {}
    }
    let first_is_lost = orders.contains(&1) && never.iter().all(|never| never.orders != [1]);
    let least = if first_is_lost { stars::least(pins, &orders) } else { Vec::new() };
    let count = lost.is_some().then(|| stars::count(pins, &orders)).flatten();
    Theorems { never, lost, count, least }
}

/// The orders whose moments differ from star to star.
fn compared(problem: &Problem) -> Vec<u32> {
    let Some(pins) = problem.pins() else { return Vec::new() };
    problem.orders.iter().copied().filter(|&order| !problem.is_settled(order) && !pins.is_lost_by_all(order)).collect()
}

/// The front, by a theorem where one gives it, else by a search.
///
/// # Errors
/// As those of [`search`].
pub fn answer(problem: &Problem, options: &Options) -> Result<Front, SearchError> {
    match described(problem) {
        Some(front) if options.resume.is_none() => Ok(front),
        _ => search(problem, options),
    }
}

/// The front of a question of which a theorem tells a star without any moment that is compared: nothing is better, so that it is the front.
///
/// Where few stars are to be searched, and no theorem counts those that are as good, they are left to the search.
pub fn described(problem: &Problem) -> Option<Front> {
    let alone = !problem.neighbours && problem.minor_orders.is_empty();
    let pins = problem.pins().filter(|pins| alone && pins.each == 1)?;
    let space = Space::of_any_size(problem).ok()?;
    let theorems = theorems(problem);
    let made = theorems.lost?;
    let throws = problem.throws();
    let in_line = problem.bank_angle.is_none();
    if throws > MOST_THROWS && !in_line || theorems.count.is_none() && throws <= SEARCHED_AT_ONCE {
        return None;
    }
    let of_class = |star: &Star| {
        let throws: Vec<u16> = star.throws().iter().map(|&throw| throw as u16).collect();
        symmetry::first_of_class(&throws, space.directions).0
    };
    let listed = match &theorems.count {
        Some(_) => stars::listed(pins.directions, MOST_LISTED),
        None => Vec::new(),
    };
    let throws = listed.iter().map(of_class).min().unwrap_or_else(|| of_class(&made.star));
    let counted = theorems.count.and_then(|count| {
        let classes = count.classes.and_then(|classes| u64::try_from(classes).ok())?;
        Some((classes, u64::try_from(count.stars).ok()?))
    });
    let (classes, stars) = counted.unwrap_or((0, 0));
    let points = judged::judge(&space, &Tables::new(&space), &throws);
    let points = points.into_iter().map(|point| StarValues { classes, stars, ..point }).collect();
    let mut front = answer::answer(problem, &space, points, Counts::default());
    front.stars.iter_mut().for_each(|star| star.by_theorem = true);
    Some(Front { described: Some(made.by), ..front })
}
