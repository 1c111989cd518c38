//! What stands in the tables of the page on V engines, as the program's solver has it? Classes of stars, their points, even firing.

use std::collections::{BTreeMap, BTreeSet};

use crankstar::exact::Turn;
use crankstar::family::{self, OpenOrder};
use num_rational::BigRational;

use super::pin_stars::{ORDERS, Pins, Vanishing, shafts, stars};
use super::torus::{Line, Place, Places, balanced, line, meetings};

/// The most pins.
pub const MOST: usize = 6;
/// The cycles.
pub const CYCLES: [&str; 2] = ["four-stroke", "two-stroke"];

/// The stars of one class.
pub struct Class {
    /// The first star with the fewest pins.
    pub first: Pins,
    /// How many stars there are of 1, 2, … pins.
    pub counts: [usize; MOST],
    /// Where the force of each order vanishes, of the first star.
    pub places: [Places; 3],
    /// The angles φ − δ at which a star of it fires evenly.
    pub even: BTreeSet<Turn>,
}

/// Stars of one number of pins that fire evenly at the same angles φ − δ.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct EvenKind {
    pub pins: usize,
    pub cycle: &'static str,
    pub vanishing: Vanishing,
    pub turns: BTreeSet<Turn>,
}

/// Shafts of stars that fire evenly: which sums of forces, and of moments, vanish.
pub type ShaftKind = (usize, Vanishing, Vanishing);

/// All that the page says.
pub struct Found {
    pub classes: BTreeMap<Vanishing, Class>,
    pub even: BTreeMap<EvenKind, Vec<Pins>>,
    pub shafts: BTreeMap<ShaftKind, Vec<Pins>>,
}

/// The verdicts on the V with these pins.
pub fn verdicts(pins: &Pins) -> Vec<OpenOrder> {
    family::classify(&pins.family(None), &ORDERS).expect("orders")
}

fn forces(pins: &Pins) -> [Places; 3] {
    let orders = verdicts(pins);
    [0, 1, 2].map(|at: usize| balanced(&orders[at].force))
}

/// Goes through all stars, and the shafts of those that can fire evenly.
pub fn found() -> Found {
    let mut found = Found { classes: BTreeMap::new(), even: BTreeMap::new(), shafts: BTreeMap::new() };
    for star in (1..=MOST).flat_map(stars) {
        let vanishing = star.forces();
        let class = found.classes.entry(vanishing).or_insert_with(|| Class {
            first: star.clone(),
            counts: [0; MOST],
            places: forces(&star),
            even: BTreeSet::new(),
        });
        class.counts[star.count() - 1] += 1;
        let mut fires = false;
        for cycle in CYCLES {
            let turns = star.even(cycle);
            if turns.is_empty() {
                continue;
            }
            fires = true;
            class.even.extend(turns.iter().cloned());
            let kind = EvenKind { pins: star.count(), cycle, vanishing, turns };
            found.even.entry(kind).or_default().push(star.clone());
        }
        for shaft in if fires { shafts(&star) } else { BTreeSet::new() } {
            found.shafts.entry((star.count(), vanishing, shaft.moments())).or_default().push(shaft);
        }
    }
    found
}

/// Where orders 1 and 2, and where 1, 2 and 4, vanish together.
pub fn together([one, two, four]: &[Places; 3]) -> [Places; 2] {
    let both = one.and(two);
    [both.clone(), both.and(four)]
}

/// The lines on which direct and reverse force of an order vanish, of one pin.
pub fn lines() -> [[Line; 2]; 3] {
    let one = stars(1).into_iter().next().expect("a star of one pin");
    let orders = verdicts(&one);
    [0, 1, 2].map(|at: usize| orders[at].force.each_ref().map(|verdict| line(verdict).expect("M is 1")))
}

/// The line φ − δ ≡ turn, on which a V fires evenly.
pub fn even_line(turn: &Turn) -> Line {
    let one = BigRational::from_integer(1.into());
    Line { phi: one.clone(), delta: -one, turn: turn.turns().clone() }
}

/// φ − δ.
pub fn apart([phi, delta]: &Place) -> Turn {
    Turn::new(phi - delta)
}

/// The point at which a line meets that of even firing.
pub fn meeting(line: &Line, turn: &Turn) -> Place {
    let mut all = meetings(line, &even_line(turn)).into_iter();
    let (Some(only), None) = (all.next(), all.next()) else { panic!("{line:?} and φ − δ meet once") };
    only
}
