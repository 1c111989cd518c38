//! Which pin stars and shafts has a V engine of up to six pins, and which of their sums vanish? Each once, up to rotation, mirror image
//! and the shaft end for end.

use std::collections::BTreeSet;

use crankstar::engine::Family;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::family;
use crankstar::file::{self, Layout};
use num_rational::BigRational;

/// The orders of the page.
pub const ORDERS: [u32; 3] = [1, 2, 4];

/// For which of the orders a sum vanishes.
pub type Vanishing = [bool; 3];

/// n pins along the shaft at multiples of 180°/n, on which every star stands whose V can fire evenly.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Pins(Vec<i64>);

impl Pins {
    fn grid(&self) -> i64 {
        2 * self.0.len() as i64
    }

    /// How many pins.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// Their directions in degrees, along the shaft.
    pub fn degrees(&self) -> Vec<i64> {
        self.0.iter().map(|step| step * 360 / self.grid()).collect()
    }

    /// `[0, 120, 240]`, as a layout file has them.
    pub fn list(&self) -> String {
        format!("{:?}", self.degrees())
    }

    fn sum(&self, order: u32, weight: impl Fn(usize) -> i64) -> PhasorSum {
        let angle = |step: &i64| Turn::fraction(step * i64::from(order), self.grid());
        let weight = |place: usize| BigRational::from_integer(weight(place).into());
        let terms = self.0.iter().enumerate().map(|(place, step)| Term { angle: angle(step), weight: weight(place) });
        PhasorSum::new(terms.collect())
    }

    /// For which orders `M_k = Σ e^{ikβ}` vanishes.
    pub fn forces(&self) -> Vanishing {
        ORDERS.map(|order| self.sum(order, |_| 1).vanishes())
    }

    /// For which orders `Σ z e^{ikβ}` vanishes, z from the middle of the shaft.
    pub fn moments(&self) -> Vanishing {
        let middle = self.count() as i64 - 1;
        ORDERS.map(|order| self.sum(order, |place| middle - 2 * place as i64).vanishes())
    }

    /// The V with these pins, all split by δ, at bank angle φ.
    pub fn layout(&self, cycle: Option<&str>) -> String {
        let cycle = cycle.map_or_else(String::new, |cycle| format!("cycle = \"{cycle}\"\n"));
        let throws = self.list();
        format!("{cycle}[vee]\nbank_angle = \"phi\"\npin_split = \"delta\"\nthrows = {throws}\n")
    }

    /// The same, read.
    pub fn family(&self, cycle: Option<&str>) -> Family {
        match file::parse_layout("pins", &self.layout(cycle)) {
            Ok(Layout::Open(family)) => *family,
            Ok(Layout::Known(..)) => panic!("nothing is open"),
            Err(error) => panic!("{error}"),
        }
    }

    /// The angles φ − δ at which it fires evenly, as the program finds them.
    pub fn even(&self, cycle: &str) -> BTreeSet<Turn> {
        let even = family::even_firing_lines(&self.family(Some(cycle))).expect("the cycle is given");
        let one = BigRational::from_integer(1.into());
        assert_eq!([&even.phi, &even.delta], [&one, &-&one]);
        even.turns
    }

    /// The first of all its images: `sorted` forgets the places along the shaft.
    fn first_image(&self, sorted: bool) -> Pins {
        let grid = self.grid();
        let shafts = [self.0.clone(), self.0.iter().rev().copied().collect()];
        let senses = shafts.iter().flat_map(|shaft| [(shaft, 1), (shaft, -1)]);
        let images = senses.flat_map(|(shaft, sign)| (0..grid).map(move |by| (shaft, sign, by)));
        let image = |(shaft, sign, by): (&Vec<i64>, i64, i64)| {
            let mut steps: Vec<i64> = shaft.iter().map(|step| (sign * step + by).rem_euclid(grid)).collect();
            if sorted {
                steps.sort_unstable();
            }
            Pins(steps)
        };
        images.map(image).min().expect("there are images")
    }
}

/// All stars of n pins: how many pins have each direction, and not which.
pub fn stars(count: usize) -> BTreeSet<Pins> {
    let grid = 2 * count as i64;
    let mut all: Vec<Vec<i64>> = vec![vec![0]];
    for _ in 1..count {
        all = all
            .iter()
            .flat_map(|steps| (steps[steps.len() - 1]..grid).map(|next| [&steps[..], &[next]].concat()))
            .collect();
    }
    all.into_iter().map(|steps| Pins(steps).first_image(true)).collect()
}

/// All shafts with the pins of a star.
pub fn shafts(star: &Pins) -> BTreeSet<Pins> {
    let mut all: BTreeSet<Vec<i64>> = BTreeSet::from([Vec::new()]);
    for _ in 0..star.count() {
        let longer = |steps: &Vec<i64>| {
            let left = |step: &&i64| {
                let count = |list: &[i64]| list.iter().filter(|other| other == step).count();
                count(steps) < count(&star.0)
            };
            star.0.iter().filter(left).map(|step| [&steps[..], &[*step]].concat()).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all.into_iter().map(|steps| Pins(steps).first_image(false)).collect()
}
