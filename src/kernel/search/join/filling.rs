//! In which ways do directions go on a group of throws, and what do they add to each moment?

use super::super::space::Space;
use super::super::tables::{AXES, Tables};
use super::outer::Image;

/// Fills the pairs of a group in every way, and its throw in the middle if it has one.
pub(super) struct Filling<'a, V> {
    space: &'a Space,
    tables: &'a Tables,
    /// What is omitted: an arrangement of which one of these images comes before it.
    images: &'a [Image],
    /// The last pair of the group.
    last: usize,
    /// Whether the throw in the middle belongs to the group.
    with_middle: bool,
    left: Vec<usize>,
    throws: Vec<usize>,
    /// Sums `x, y` of every order after each pair.
    sums: Vec<i64>,
    visit: V,
}

/// An arrangement: the directions in the order of filling, the sums `x, y` of every order, and the images that leave it as it is.
pub(super) struct Arrangement<'a> {
    pub throws: &'a [usize],
    pub sums: &'a [i64],
    pub same: u128,
}

/// Throws that are filled together.
pub(super) struct Group {
    /// The first of its pairs, from the outside.
    pub first: usize,
    /// The first pair after it.
    pub end: usize,
    /// Whether it has the throw in the middle.
    pub with_middle: bool,
}

impl<'a, V: FnMut(&Arrangement)> Filling<'a, V> {
    /// Visits every way to put these directions on the throws of a group.
    pub fn all(
        (space, tables): (&'a Space, &'a Tables),
        Group { first, end, with_middle }: Group,
        counts: Vec<usize>,
        images: &'a [Image],
        visit: V,
    ) {
        let sums = vec![0; (end - first + 1) * 2 * space.orders.len()];
        let throws = Vec::with_capacity(space.places);
        let mut filling = Filling { space, tables, images, last: end, with_middle, left: counts, throws, sums, visit };
        filling.pair(first, 0, every(images));
    }

    fn pair(&mut self, at: usize, depth: usize, same: u128) {
        if at == self.last {
            return self.middle(depth, same);
        }
        for a in 0..self.space.directions {
            if self.left[a] == 0 {
                continue;
            }
            self.left[a] -= 1;
            for b in 0..self.space.directions {
                if self.left[b] == 0 {
                    continue;
                }
                let image = |image: Image| image.of_pair((a, b), self.space.directions);
                let Some(same) = still_same(same, self.images, &(a, b), image) else { continue };
                self.left[b] -= 1;
                self.throws.extend([a, b]);
                self.add(at, depth, a, b);
                self.pair(at + 1, depth + 1, same);
                self.throws.truncate(2 * depth);
                self.left[b] += 1;
            }
            self.left[a] += 1;
        }
    }

    /// The arms of a pair are opposite.
    fn add(&mut self, at: usize, depth: usize, a: usize, b: usize) {
        let (width, weight) = (2 * self.space.orders.len(), self.space.weights[at]);
        let (before, after) = self.sums[depth * width..].split_at_mut(width);
        for row in 0..self.space.orders.len() {
            let (first, second) = (self.tables.projections(row, a), self.tables.projections(row, b));
            after[2 * row] = before[2 * row] + weight * (first[0] - second[0]);
            after[2 * row + 1] = before[2 * row + 1] + weight * (first[AXES / 2] - second[AXES / 2]);
        }
    }

    /// A throw in the middle has no arm, and adds nothing.
    fn middle(&mut self, depth: usize, same: u128) {
        if !self.with_middle {
            return self.visit(depth, same);
        }
        for throw in 0..self.space.directions {
            if self.left[throw] == 0 {
                continue;
            }
            let image = |image: Image| image.of(throw, self.space.directions);
            if let Some(same) = still_same(same, self.images, &throw, image) {
                self.throws.push(throw);
                self.visit(depth, same);
                self.throws.pop();
            }
        }
    }

    fn visit(&mut self, depth: usize, same: u128) {
        let width = 2 * self.space.orders.len();
        let sums = &self.sums[depth * width..(depth + 1) * width];
        (self.visit)(&Arrangement { throws: &self.throws, sums, same });
    }
}

/// All images, one bit each.
pub(super) fn every(images: &[Image]) -> u128 {
    (0..images.len()).fold(0, |bits, at| bits | 1 << at)
}

/// Of the images that were the same so far those that still are; none where one comes before.
pub(super) fn still_same<T: Ord>(same: u128, images: &[Image], own: &T, of: impl Fn(Image) -> T) -> Option<u128> {
    let (mut open, mut left) = (same, same);
    while open != 0 {
        let at = open.trailing_zeros() as usize;
        open &= open - 1;
        match of(images[at]).cmp(own) {
            std::cmp::Ordering::Less => return None,
            std::cmp::Ordering::Equal => {}
            std::cmp::Ordering::Greater => left &= !(1 << at),
        }
    }
    Some(left)
}
