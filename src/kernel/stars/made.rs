//! Which stars do the theorems describe?

use super::factors::prime_powers;
use super::star::Star;

/// By which construction a star was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum By {
    /// Lemma 3: places count in a mixed radix over these powers of primes.
    MixedRadix(Vec<u32>),
    /// Theorem 4: mirrored at 180°, of a power of two and an odd number that is no power of a prime.
    EveryMoment {
        /// The power of two.
        two: u32,
        /// The odd number.
        odd: u32,
    },
    /// Theorem 7: throws at 180° are mirrored about the middle.
    Mirrored,
    /// Theorem 8: the shaft is its own mirror image.
    MirrorImage,
}

/// The place of each direction in the star of lemma 3.
fn mixed_radix(count: u32) -> Vec<u32> {
    let powers = prime_powers(count);
    let place = |direction: u32| {
        let digits = powers.iter().scan(1, |scale, power| {
            let digit = *scale * (direction % power.value());
            *scale *= power.value();
            Some(digit)
        });
        digits.sum()
    };
    (0..count).map(place).collect()
}

/// The star of lemma 3.
pub(super) fn of_mixed_radix(count: u32) -> (By, Star) {
    let powers = prime_powers(count).into_iter().map(|power| power.value()).collect();
    (By::MixedRadix(powers), Star::of_places(&mixed_radix(count)))
}

/// The star of theorem 4, without any moment; none where the number has no two different odd primes, or is odd.
pub(super) fn without_any(count: u32) -> Option<(By, Star)> {
    let two = 1 << count.trailing_zeros();
    let odd = count / two;
    if two == 1 || prime_powers(odd).len() < 2 {
        return None;
    }
    let half = mixed_radix(odd);
    let mut places = vec![0; count as usize];
    for direction in 0..count {
        let (i, y) = (direction % two, direction % odd);
        if i < two / 2 {
            let place = count / 2 + i + two / 2 * half[y as usize];
            places[direction as usize] = place;
            places[((direction + count / 2) % count) as usize] = count - 1 - place;
        }
    }
    Some((By::EveryMoment { two, odd }, Star::of_places(&places)))
}

/// A star of theorem 7, without any moment of an even order; none of an odd number.
pub(super) fn mirrored(count: u32) -> Option<(By, Star)> {
    let half = count / 2;
    let place = |direction| if direction < half { direction } else { count - 1 - (direction - half) };
    let places: Vec<u32> = (0..count).map(place).collect();
    (half > 0 && count.is_multiple_of(2)).then(|| (By::Mirrored, Star::of_places(&places)))
}

/// A star of theorem 8: each direction an even number of times, the second half of the shaft the mirror image of the first.
pub(super) fn mirror_image(directions: u32, each: u32) -> Option<(By, Star)> {
    let half: Vec<u32> = (0..directions * (each / 2)).map(|place| place % directions).collect();
    let throws: Vec<u32> = half.iter().chain(half.iter().rev()).copied().collect();
    (directions > 0 && each > 0 && each.is_multiple_of(2)).then(|| (By::MirrorImage, Star::new(directions, &throws)))
}
