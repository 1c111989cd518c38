//! What does the page of stars show? What every number of cylinders can lose, the best stars, and four engines.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::engine::Cycle;
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers;
use crate::search::{self, FoundStar, Front, Options, Problem, SearchError};
use crate::stars::{self, Count, Pins, Star};

/// The numbers of cylinders of the page.
pub(super) const CYLINDERS: std::ops::RangeInclusive<u32> = 2..=30;
/// Up to this many cylinders all stars are searched when the page is made.
const MOST_SEARCHED: u32 = 12;

/// Up to this many cylinders the best star is known.
const MOST_KNOWN: u32 = 18;

/// Up to this many stars of a theorem are gone through.
const MOST_LISTED: usize = 5000;

/// The stars with the least first-order moment, and then the least of order 2, that `crankstar search` found of more cylinders, with how many have that of order 1: directions by place.
/// The moments are those of these stars, exactly; that no other has less is computed by the tests, in another way.
const FOUND: [(u32, &[u32], u64); 4] = [
    (13, &[0, 1, 7, 5, 6, 9, 2, 8, 11, 12, 10, 3, 4], 2),
    (16, &[0, 5, 9, 10, 2, 13, 14, 6, 11, 3, 4, 15, 7, 8, 12, 1], 288),
    (17, &[0, 7, 2, 11, 10, 9, 1, 13, 5, 4, 16, 15, 14, 8, 6, 12, 3], 4),
    (18, &[0, 9, 1, 13, 7, 6, 15, 14, 5, 12, 3, 2, 11, 10, 4, 16, 8, 17], 3_620_736),
];

/// The best in-line star of a number of cylinders, two-stroke: the least moment of order 1, then of order 2.
pub(super) struct BestStar {
    pub cylinders: u32,
    pub star: Star,
    /// The moments of orders 1 and 2.
    pub moments: [PhasorSum; 2],
    /// How many stars have this moment of order 1.
    pub stars: Option<String>,
}

impl BestStar {
    fn new(star: Star, stars: Option<String>) -> Self {
        BestStar { cylinders: star.directions(), moments: [1, 2].map(|order| star.moment(order)), star, stars }
    }

    /// The engine as the text of a layout file.
    pub fn layout_file(&self) -> String {
        let quoted: Vec<String> =
            self.star.angles().iter().map(|throw| format!("\"{} turn\"", throw.turns())).collect();
        format!(
            "title = \"In-line {}, the least moment of order 1\"\ncycle = \"two-stroke\"\n\n[inline]\nthrows = [{}]\n",
            self.cylinders,
            quoted.join(", ")
        )
    }
}

/// An engine of the page.
pub(super) struct Shown {
    pub problem: Problem,
    pub star: FoundStar,
}

impl Shown {
    /// The first order of which a moment is left.
    pub fn first_left(&self) -> Option<u32> {
        star_of(self.problem.cylinders, &self.star).first_left()
    }
}

/// The star of an in-line engine by its directions.
fn star_of(cylinders: u32, found: &FoundStar) -> Star {
    let steps = |throw: &Turn| (throw.turns() * BigRational::from_integer(cylinders.into())).to_integer().to_u32();
    Star::new(cylinders, &found.throws.iter().filter_map(steps).collect::<Vec<_>>())
}

/// All that the page of stars shows.
pub struct StarsStudy {
    /// How many stars of each number of cylinders lose order 1, where a theorem counts them.
    pub(super) counts: Vec<(u32, Option<Count>)>,
    pub(super) best: Vec<BestStar>,
    pub(super) engines: Vec<Shown>,
}

impl StarsStudy {
    /// Searches what is searched for the page: seconds.
    ///
    /// # Errors
    /// If the search is stopped.
    pub fn new(options: &Options) -> Result<Self, SearchError> {
        let mut best = Vec::new();
        for cylinders in *CYLINDERS.start()..=MOST_SEARCHED {
            best.push(searched(cylinders, options)?);
        }
        best.extend((MOST_SEARCHED + 1..=MOST_KNOWN).filter_map(known));
        let six = search::best_in_line(6, Cycle::TwoStroke, options)?;
        let twelve = search::best_in_line(12, Cycle::TwoStroke, options)?;
        let searched = [six, twelve].into_iter().map(|best| (best.problem, best.stars));
        let described = [15, 30].into_iter().filter_map(|cylinders| {
            let Front { problem, stars, .. } =
                search::described(&Problem::inline(cylinders, Cycle::TwoStroke, &[1, 2]))?;
            Some((problem, stars))
        });
        let first =
            |(problem, stars): (Problem, Vec<FoundStar>)| stars.into_iter().next().map(|star| Shown { problem, star });
        let counts = CYLINDERS.map(|cylinders| (cylinders, stars::count(Pins::once(cylinders), &[1]))).collect();
        Ok(StarsStudy { counts, best, engines: searched.chain(described).filter_map(first).collect() })
    }
}

fn searched(cylinders: u32, options: &Options) -> Result<BestStar, SearchError> {
    let of = |orders: &[u32]| search::search(&Problem::inline(cylinders, Cycle::TwoStroke, orders), options);
    let (both, first) = (of(&[1, 2])?, of(&[1])?);
    let stars = first.stars.first().and_then(|star| star.stars).map(|stars| stars.to_string());
    let star = both.stars.first().map_or_else(|| Star::new(cylinders, &[]), |found| star_of(cylinders, found));
    Ok(BestStar::new(star, stars))
}

/// Of more cylinders: by a theorem, or as it was found.
fn known(cylinders: u32) -> Option<BestStar> {
    // Of the stars that a theorem lists the one with the least moment of order 2.
    let listed = stars::listed(cylinders, MOST_LISTED).into_iter();
    let length = |star: &Star| numbers::evaluate(&star.moment(2)).norm();
    let shortest = listed.min_by(|one, other| length(one).total_cmp(&length(other)));
    let counted = || stars::count(Pins::once(cylinders), &[1]).map(|count| count.stars.to_string());
    let found = || FOUND.iter().find(|(found, ..)| *found == cylinders);
    let (star, stars) = match shortest {
        Some(star) => (star, counted()),
        None => found().map(|(_, throws, stars)| (Star::new(cylinders, throws), Some(stars.to_string())))?,
    };
    Some(BestStar::new(star, stars))
}

/// Five throws with gaps 1 : φ : φ : 1: the moment of an order, of the arms sin(4πx/5) at the angles 2πx/5.
pub(super) fn golden(order: i64) -> PhasorSum {
    let half = BigRational::new(1.into(), 2.into());
    let term = |x: i64, sign: i64| Term {
        angle: &Turn::fraction((order + 2 * sign) * x, 5) - &Turn::fraction(sign, 4),
        weight: half.clone(),
    };
    PhasorSum::new((0..5).flat_map(|x| [term(x, 1), term(x, -1)]).collect())
}

/// How many stars of six throws lose order 1 where the middle gap is this many spacings.
pub(super) fn of_six(middle: &BigRational) -> usize {
    let place = |index: i64| {
        let wider = if index < 3 { BigRational::zero() } else { middle - BigRational::from_integer(1.into()) };
        BigRational::from_integer(index.into()) + wider
    };
    stars::stars_of(&(0..6).map(place).collect::<Vec<_>>()).len()
}
