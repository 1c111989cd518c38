//! How evenly do the cylinders fire?

use num_rational::BigRational;
use num_traits::ToPrimitive;
use smallvec::SmallVec;

use super::integers::IntegerEngine;
use crate::engine::{Cycle, Engine, Firing, Rod, Shot};
use crate::exact::fraction;
use crate::numbers::float;

/// The longest and the shortest interval between firings, in turns of the crank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Evenness {
    /// The longest.
    pub longest: BigRational,
    /// The shortest; 0 where two cylinders fire together.
    pub shortest: BigRational,
    /// Whether this is the firing order of the file; else the most even one that the throws allow.
    pub of_the_file: bool,
}

impl Evenness {
    /// The longest less the shortest.
    pub fn unevenness(&self) -> BigRational {
        fraction::minus(&self.longest, &self.shortest)
    }
}

/// Engines with more cylinders have too many orders to try.
const MOST_CYLINDERS: usize = 12;

/// The intervals of the file's firing order; without one those of the most even order of this cycle.
///
/// In a four-stroke engine each cylinder fires at every other of its top dead centres: all choices are tried for up to 12
/// cylinders, and of those with the least difference the one with the shortest longest interval is taken. None where two pistons share a
/// cylinder: it is not each piston that fires.
///
/// The whole numbers of the engine may be known already.
pub(super) fn evenness(engine: &Engine, cycle: Option<Cycle>, known: Option<&IntegerEngine>) -> Option<Evenness> {
    if let Some(firing) = engine.firing() {
        let intervals = firing.intervals();
        let (longest, shortest) = (intervals.iter().max()?.clone(), intervals.iter().min()?.clone());
        return Some(Evenness { longest, shortest, of_the_file: true });
    }
    let cycle = cycle.filter(|_| !engine.has_opposed_pistons())?;
    let (whole, length) = match known {
        Some(known) => known.top_dead_centres(),
        None => top_dead_centres(engine)?,
    };
    let (longest, shortest) = Choices::new(&whole, length, cycle)?.most_even()?;
    let turns = |each: i64| fraction::ratio(each, length);
    Some(Evenness { longest: turns(longest), shortest: turns(shortest), of_the_file: false })
}

/// When the cylinders fire by the file; without it each of the most even orders.
pub fn most_even_firings(engine: &Engine, cycle: Option<Cycle>) -> Vec<Firing> {
    if let Some(firing) = engine.firing() {
        return vec![firing.clone()];
    }
    let firings = || {
        let cycle = cycle.filter(|_| !engine.has_opposed_pistons())?;
        let (whole, length) = top_dead_centres(engine)?;
        let choices = Choices::new(&whole, length, cycle)?;
        let best = choices.most_even()?;
        let even = (0..choices.count).filter(|&choice| choices.intervals(choice) == best);
        let angle = |at: i64| BigRational::new(at.into(), length.into());
        let firing = |choice: usize| {
            let angles: Vec<BigRational> = choices.firings(choice).map(angle).collect();
            Firing::from_angles(&angles, cycle, engine.cylinders()).ok()
        };
        Some(even.filter_map(firing).collect())
    };
    firings().unwrap_or_default()
}

/// The shortest and the longest interval from one top dead centre at which a cylinder fires to the next, in degrees, where offsets move these
/// apart, so that they are not the intervals of the firing angles; none where they do not, or nothing says when the cylinders fire.
pub fn dead_centre_intervals(engine: &Engine) -> Option<[f64; 2]> {
    let firing = engine.firing().filter(|_| engine.has_dead_centres_apart())?;
    // By how many degrees after its pin is in line with its axis a piston stands highest: `arcsin(e/(r + l))`.
    let after = |rod: &Rod| float(&rod.highest_after()).asin().to_degrees();
    let highest = |shot: &Shot| {
        let rod = engine.cylinders()[shot.cylinder].rod();
        360.0 * float(&shot.angle) + rod.map_or(0.0, after)
    };
    let mut angles: Vec<f64> = firing.shots.iter().map(highest).collect();
    angles.sort_by(f64::total_cmp);
    let again = angles.first()? + 360.0 * float(&firing.cycle.turns());
    let ends = (f64::INFINITY, 0.0_f64);
    let intervals = angles.iter().skip(1).chain([&again]).zip(&angles).map(|(next, angle)| next - angle);
    let (least, most) = intervals.fold(ends, |(least, most), one| (least.min(one), most.max(one)));
    Some([least, most])
}

/// At which of its top dead centres each cylinder fires: all that a cycle allows.
struct Choices<'a> {
    whole: &'a [i64],
    length: i64,
    revolutions: i64,
    count: usize,
}

impl<'a> Choices<'a> {
    fn new(whole: &'a [i64], length: i64, cycle: Cycle) -> Option<Self> {
        let (revolutions, count) = match cycle {
            Cycle::TwoStroke => (1, 1),
            Cycle::FourStroke if whole.len() <= MOST_CYLINDERS => (2, 1_usize << (whole.len() - 1)),
            Cycle::FourStroke => return None,
        };
        Some(Choices { whole, length, revolutions, count })
    }

    /// Where each cylinder fires: the first at 0, the others in this revolution or in the next.
    fn firings(&self, choice: usize) -> impl Iterator<Item = i64> {
        // Engines with more cylinders than bits have one choice, in which none is late.
        let is_late = move |index: u32| (choice << 1).checked_shr(index).is_some_and(|bits| bits & 1 == 1);
        let at = move |(index, centre): (u32, &i64)| centre + if is_late(index) { self.length } else { 0 };
        (0..).zip(self.whole).map(at)
    }

    /// The longest and the shortest interval.
    fn intervals(&self, choice: usize) -> (i64, i64) {
        let mut firings: Vec<i64> = self.firings(choice).collect();
        firings.sort_unstable();
        let last = firings[0] + self.revolutions * self.length - firings[firings.len() - 1];
        let between = firings.windows(2).map(|pair| pair[1] - pair[0]);
        between.fold((last, last), |(longest, shortest), gap| (longest.max(gap), shortest.min(gap)))
    }

    /// Those of the choice with the least difference, and of those the shortest longest one.
    ///
    /// With the top dead centres rising, the cylinders of the first revolution fire in that order, then those of the second: no choice
    /// has to be sorted. The first cylinder, whose centre is 0, fires first.
    fn most_even(&self) -> Option<(i64, i64)> {
        if self.count == 1 {
            return Some(self.intervals(0));
        }
        let mut rising: SmallVec<[i64; MOST_CYLINDERS]> = self.whole.iter().copied().collect();
        rising.sort_unstable();
        let (first, others) = rising.split_first()?;
        let turn = self.revolutions * self.length;
        let all = self.count - 1;
        let intervals = |choice: usize| {
            let (mut last, mut longest, mut shortest) = (*first, 0, turn);
            let mut fires = |at: i64| {
                (longest, shortest) = (longest.max(at - last), shortest.min(at - last));
                last = at;
            };
            // A bit for each that fires in this revolution, then for each in the next.
            for (mut left, late) in [(!choice & all, 0), (choice, self.length)] {
                while left != 0 {
                    fires(others[left.trailing_zeros() as usize] + late);
                    left &= left - 1;
                }
            }
            fires(first + turn);
            (longest, shortest)
        };
        (0..self.count).map(intervals).min_by_key(|(longest, shortest)| (longest - shortest, *longest))
    }
}

/// Top dead centres after that of the first cylinder over their common denominator, which is a turn; none where a crankshaft turns faster
/// than the reference, whose cylinders have several in a revolution.
fn top_dead_centres(engine: &Engine) -> Option<(Vec<i64>, i64)> {
    if engine.faster_crank().is_some() {
        return None;
    }
    let first = engine.cylinders().first()?.top_dead_centre();
    let centres: Vec<BigRational> =
        engine.cylinders().iter().map(|cylinder| (&cylinder.top_dead_centre() - &first).turns().clone()).collect();
    let turn = fraction::common_denominator(&centres);
    let whole = |centre: &BigRational| (centre.numer() * (&turn / centre.denom())).to_i64();
    let whole = centres.iter().map(whole).collect::<Option<_>>()?;
    Some((whole, turn.to_i64().filter(|turn| *turn < i64::MAX / 4)?))
}
