//! Which stars are the same but for looking at them? Rotation, mirror and reversal, and the first star of each class.
//!
//! Filled pair by pair, a star is `(a_0, b_0), (a_1, b_1), …` with `a_0 = 0`. Mirror, reversal and both, turned back so that
//! cylinder 1 is at 0 again, carry pairs to pairs:
//!
//! - mirror: `(−a, −b)`; reversal: `(b − b_0, a − b_0)`; both: `(b_0 − b, b_0 − a)`.
//!
//! So the first pairs of a star give the first pairs of its images, and a start whose image comes before it can be omitted
//! with all its completions. A star is the first of its class iff no image comes before it; then the class holds
//! `4 / (1 + images equal to it)` stars.

use std::cmp::Ordering;

/// For each image (mirror, reversal, both): whether it is the same as far as placed.
pub(super) type Same = [bool; 3];

/// The pair's images compared with the pair; `None` where one comes before it.
pub(super) fn compare_pair(same: Same, (a, b): (usize, usize), last: usize, directions: usize) -> Option<Same> {
    let minus = |x: usize, y: usize| (x + directions - y) % directions;
    let images = [(minus(0, a), minus(0, b)), (minus(b, last), minus(a, last)), (minus(last, b), minus(last, a))];
    compare(same, &(a, b), &images)
}

/// The same for the throw in the middle of an odd number.
pub(super) fn compare_middle(same: Same, throw: usize, last: usize, directions: usize) -> Option<Same> {
    let minus = |x: usize, y: usize| (x + directions - y) % directions;
    compare(same, &throw, &[minus(0, throw), minus(throw, last), minus(last, throw)])
}

fn compare<T: Ord>(same: Same, own: &T, images: &[T; 3]) -> Option<Same> {
    let mut left = same;
    for (same, image) in left.iter_mut().zip(images) {
        match (*same, image.cmp(own)) {
            (true, Ordering::Less) => return None,
            (true, Ordering::Greater) => *same = false,
            _ => {}
        }
    }
    Some(left)
}

/// Number of stars in the class of a star that is the first of it.
pub(super) fn class_size(same: Same) -> u64 {
    4 / (1 + same.iter().filter(|same| **same).count() as u64)
}

/// The first star of a class, which puts cylinder 1 at direction 0, and the number of stars in the class that do.
///
/// `throws` are directions by place.
pub(super) fn first_of_class(throws: &[u16], directions: usize) -> (Vec<u16>, u64) {
    let mut images = images(throws, directions);
    images.sort_by_cached_key(|star| filled(star));
    let different = 1 + images.windows(2).filter(|pair| pair[0] != pair[1]).count() as u64;
    let [first, ..] = images;
    (first, different)
}

/// All images keep the values of a star.
pub(super) const EVERY_IMAGE: Same = [true; 3];

/// The stars of a class that are different where only these images keep the values: the first of each part of the class, and how many
/// stars it has. The images that keep values are a group: all, one or none of them.
pub(super) fn variants(throws: &[u16], directions: usize, keeps: Same) -> Vec<(Vec<u16>, u64)> {
    let mut parts: Vec<Vec<Vec<u16>>> = Vec::new();
    for star in images(throws, directions) {
        if parts.iter().flatten().any(|known| *known == star) {
            continue;
        }
        let [own, others @ ..] = images(&star, directions);
        let mut part = vec![own];
        for (image, _) in others.into_iter().zip(keeps).filter(|(_, keeps)| *keeps) {
            if !part.contains(&image) {
                part.push(image);
            }
        }
        part.sort_by_cached_key(|star| filled(star));
        parts.push(part);
    }
    parts.sort_by_cached_key(|part| filled(&part[0]));
    let first = |mut part: Vec<Vec<u16>>| {
        let size = part.len() as u64;
        (part.swap_remove(0), size)
    };
    parts.into_iter().map(first).collect()
}

/// A star, its mirror image, its reversal and both, with cylinder 1 at 0.
fn images(throws: &[u16], directions: usize) -> [Vec<u16>; 4] {
    let turned_back = |star: &mut dyn Iterator<Item = usize>| {
        let star: Vec<usize> = star.collect();
        let first = star.first().copied().unwrap_or(0);
        star.iter().map(|throw| ((throw + directions - first) % directions) as u16).collect::<Vec<u16>>()
    };
    let own = || throws.iter().map(|&throw| usize::from(throw));
    let mirrored = || own().map(|throw| directions - throw);
    [
        turned_back(&mut own()),
        turned_back(&mut mirrored()),
        turned_back(&mut own().rev()),
        turned_back(&mut mirrored().rev()),
    ]
}

/// Directions in the order of filling.
fn filled(star: &[u16]) -> Vec<u16> {
    let places = (0..star.len()).map(|at| if at % 2 == 0 { at / 2 } else { star.len() - 1 - at / 2 });
    places.map(|place| star[place]).collect()
}
