//! Which directions do the outer throws take? Every choice up to rotation and mirror image, with what carries it to itself.

use super::super::problem::MOST_THROWS;
use super::super::space::Space;

// The images that can carry a choice to itself are given by the bits of a number: rotations, mirrored or not, and reversed or not.
const _: () = assert!(4 * MOST_THROWS <= u128::BITS);

/// How the directions are shared out: how often each is taken by the outer throws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in super::super) struct Outer {
    /// For each direction the number of outer throws that take it.
    pub counts: Vec<usize>,
}

/// A star seen otherwise: mirrored or not, turned, and shaft end for end or not.
#[derive(Clone, Copy, Debug)]
pub(super) struct Image {
    turn: usize,
    mirrored: bool,
    reversed: bool,
}

impl Image {
    /// The image of a direction.
    pub fn of(self, direction: usize, directions: usize) -> usize {
        let direction = if self.mirrored { directions - direction } else { direction };
        (direction + self.turn) % directions
    }

    /// The image of a pair of places symmetric about the mid-plane.
    pub fn of_pair(self, (a, b): (usize, usize), directions: usize) -> (usize, usize) {
        let (a, b) = (self.of(a, directions), self.of(b, directions));
        if self.reversed { (b, a) } else { (a, b) }
    }
}

/// Pairs that the outer group has: about half of all throws, so that neither group has many more orders than the other.
pub(super) fn pairs(space: &Space) -> usize {
    space.pairs().min((space.places + 2) / 4)
}

/// One choice of each class of rotation and mirror image, the least of it, in rising order.
pub(in super::super) fn all(space: &Space, supply: usize) -> Vec<Outer> {
    let mut counts = vec![0; space.directions];
    let mut found = Vec::new();
    choose(&mut counts, 0, 2 * pairs(space), supply, &mut found);
    found
}

fn choose(counts: &mut Vec<usize>, at: usize, left: usize, supply: usize, found: &mut Vec<Outer>) {
    if at == counts.len() {
        if left == 0 && is_least(counts) {
            found.push(Outer { counts: counts.clone() });
        }
        return;
    }
    let later = (counts.len() - at - 1) * supply;
    for count in left.saturating_sub(later)..=supply.min(left) {
        counts[at] = count;
        choose(counts, at + 1, left - count, supply, found);
    }
    counts[at] = 0;
}

fn is_least(counts: &[usize]) -> bool {
    images(counts.len()).all(|image| image_of(counts, image).ge(counts.iter().copied()))
}

/// The choice that the image of a star makes: a direction is taken as often as the one that it is the image of.
fn image_of(counts: &[usize], image: Image) -> impl Iterator<Item = usize> {
    let from = move |direction: usize| {
        let turned = direction + counts.len() - image.turn;
        if image.mirrored { (2 * counts.len() - turned) % counts.len() } else { turned % counts.len() }
    };
    (0..counts.len()).map(move |direction| counts[from(direction)])
}

/// Rotations and mirror images; reversal leaves the choice alone.
fn images(directions: usize) -> impl Iterator<Item = Image> {
    let mirrored = [false, true].into_iter();
    mirrored.flat_map(move |mirrored| (0..directions).map(move |turn| Image { turn, mirrored, reversed: false }))
}

impl Outer {
    /// What carries stars of this choice to stars of it, but for looking at them as they are.
    pub(super) fn symmetries(&self) -> Vec<Image> {
        let keeps = |image: &Image| image_of(&self.counts, *image).eq(self.counts.iter().copied());
        let both = |image: Image| [image, Image { reversed: true, ..image }];
        images(self.counts.len()).filter(keeps).flat_map(both).skip(1).collect()
    }

    /// Whether a star is, up to rotation and mirror image, one of this choice.
    pub(in super::super) fn holds(&self, space: &Space, throws: &[u16]) -> bool {
        let mut counts = vec![0; space.directions];
        for place in space.sequence.iter().take(2 * pairs(space)) {
            counts[usize::from(throws[*place])] += 1;
        }
        images(counts.len()).any(|image| image_of(&counts, image).eq(self.counts.iter().copied()))
    }
}
