//! Which frequencies and modes has a shaft of discs? By the signs of Holzer's residuals, and a bisection.
//!
//! H. Holzer, Die Berechnung der Drehschwingungen, 1921. The number of negative pivots of `K − ω²J` is that of the natural
//! frequencies below ω (Sylvester's law of inertia), so each is enclosed between neighbouring numbers.

use super::Shaft;

/// A way in which the shaft vibrates by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Angular frequency in radians a second.
    pub omega: f64,
    /// Deflection of each disc, 1 at the first; 1 at the largest where the first is a node.
    pub shape: Vec<f64>,
}

/// A first disc that moves less than this part of the largest deflection is taken for a node.
const NODE: f64 = 1e-9;

impl Mode {
    /// Frequency in oscillations a second.
    pub fn hertz(&self) -> f64 {
        self.omega / std::f64::consts::TAU
    }

    /// How many times the deflection changes its sign along the shaft.
    pub fn nodes(&self) -> usize {
        let signs: Vec<bool> = self.shape.iter().filter(|value| **value != 0.0).map(|value| *value > 0.0).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

/// The elastic modes, rising; that in which the shaft turns as a whole is omitted.
pub fn modes(shaft: &Shaft) -> Vec<Mode> {
    (1..shaft.inertias.len()).map(|number| mode(shaft, number)).collect()
}

/// The mode with so many others below it, the rigid one counted.
fn mode(shaft: &Shaft, below: usize) -> Mode {
    let (mut low, mut high) = (0.0, highest(shaft));
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        match below_square(shaft, middle) > below {
            true => high = middle,
            false => low = middle,
        }
    }
    Mode { omega: high.sqrt(), shape: shape(shaft, high) }
}

/// No square of a natural frequency is above this (Gershgorin).
fn highest(shaft: &Shaft) -> f64 {
    let at = |index: usize| 2.0 * (before(shaft, index) + after(shaft, index)) / shaft.inertias[index];
    (0..shaft.inertias.len()).map(at).fold(0.0, f64::max) * (1.0 + 1e-12)
}

fn before(shaft: &Shaft, disc: usize) -> f64 {
    if disc == 0 { 0.0 } else { shaft.stiffnesses[disc - 1] }
}

fn after(shaft: &Shaft, disc: usize) -> f64 {
    shaft.stiffnesses.get(disc).copied().unwrap_or(0.0)
}

/// The diagonal of `K − ω²J`.
fn diagonal(shaft: &Shaft, disc: usize, square: f64) -> f64 {
    before(shaft, disc) + after(shaft, disc) - square * shaft.inertias[disc]
}

/// A pivot of zero is taken for one as small as its rounding: the next is huge, and of the other sign.
fn not_zero(shaft: &Shaft, disc: usize, pivot: f64) -> f64 {
    if pivot == 0.0 { f64::EPSILON * (before(shaft, disc) + after(shaft, disc)) } else { pivot }
}

/// How many natural frequencies have a square below this one.
fn below_square(shaft: &Shaft, square: f64) -> usize {
    let mut negative = 0;
    let mut pivot = f64::INFINITY;
    for disc in 0..shaft.inertias.len() {
        pivot = not_zero(shaft, disc, diagonal(shaft, disc, square) - before(shaft, disc).powi(2) / pivot);
        negative += usize::from(pivot < 0.0);
    }
    negative
}

/// The deflections at the square of a natural frequency: from both ends to the disc at which the equations fit best.
fn shape(shaft: &Shaft, square: f64) -> Vec<f64> {
    let count = shaft.inertias.len();
    let pivots = |order: &mut dyn Iterator<Item = usize>, coupling: fn(&Shaft, usize) -> f64| {
        let mut pivots = vec![0.0; count];
        let mut last = f64::INFINITY;
        for disc in order {
            last = not_zero(shaft, disc, diagonal(shaft, disc, square) - coupling(shaft, disc).powi(2) / last);
            pivots[disc] = last;
        }
        pivots
    };
    let (forward, backward) = (pivots(&mut (0..count), before), pivots(&mut (0..count).rev(), after));
    let misfit = |disc: usize| (forward[disc] + backward[disc] - diagonal(shaft, disc, square)).abs();
    let twist = (0..count).min_by(|one, other| misfit(*one).total_cmp(&misfit(*other))).unwrap_or(0);
    let mut shape = vec![0.0; count];
    shape[twist] = 1.0;
    for disc in (0..twist).rev() {
        shape[disc] = after(shaft, disc) / forward[disc] * shape[disc + 1];
    }
    for disc in twist + 1..count {
        shape[disc] = before(shaft, disc) / backward[disc] * shape[disc - 1];
    }
    let largest =
        shape.iter().copied().fold(0.0_f64, |most, value| if value.abs() > most.abs() { value } else { most });
    let unit = if shape[0].abs() > NODE * largest.abs() { shape[0] } else { largest };
    shape.into_iter().map(|value| value / unit).collect()
}
