//! Where on the whole circle does a sum with one unknown vanish? Complete, and proved.
//!
//! All parts that are left turn by whole multiples of one `u = pφ + qδ`, so that the sum is a polynomial in `x = e^{iu}` with
//! phasor sums as its coefficients. A Bézout identity modulo one prime shows that it has no zero on the circle; else the circle is
//! cut into arcs, each with its evidence: free, around a rational zero, or crossed once at an irrational one. A sum that is not its own
//! mirror image is divided first, as is one with multiple zeros (theory, section 16).

mod answer;
mod arcs;
mod closed;
mod curve;
mod factor;
mod field;
mod images;
mod never;
mod polynomial;
mod rational;
mod settled;

pub use arcs::Circle;
pub use closed::Closed;
pub use polynomial::Polynomial;

use super::part::Part;
use crate::proof::CoprimeClaim;

/// What is known of a sum in one unknown.
#[derive(Clone, Debug)]
pub(super) enum Solved {
    /// It vanishes nowhere.
    Never(Box<CoprimeClaim>),
    /// It vanishes at the zeros of its arcs.
    Circle(Box<Circle>),
}

/// Solves a sum of two parts at least; `None` where two unknowns enter on their own, or one enters too many times.
pub(super) fn solve(parts: &[&Part]) -> Option<Solved> {
    let polynomial = Polynomial::of(parts)?;
    Some(match never::prove(&polynomial) {
        Some(coprime) => Solved::Never(Box::new(coprime)),
        None => Solved::Circle(Box::new(whole(polynomial))),
    })
}

/// The arcs of a sum; where some are open, those of the factor that has all its zeros on the circle, each once.
pub(super) fn whole(polynomial: Polynomial) -> Circle {
    let circle = arcs::cover(polynomial);
    if circle.is_complete() {
        return circle;
    }
    let Some((divided, polynomial)) = factor::split(&circle.polynomial) else { return circle };
    let mut of_factor = arcs::cover(polynomial);
    of_factor.claim.divided = Some(divided);
    if of_factor.open().count() < circle.open().count() { of_factor } else { circle }
}

/// The arcs of a polynomial that is known.
pub(super) fn arcs_of_polynomial(polynomial: Polynomial) -> Circle {
    arcs::cover(polynomial)
}

/// The arcs of a sum of two parts at least, also where it vanishes nowhere.
pub(super) fn arcs_of(parts: &[&Part]) -> Option<Circle> {
    Polynomial::of(parts).map(arcs::cover)
}
