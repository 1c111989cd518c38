//! Does the sum vanish nowhere? A Bézout identity modulo one prime shows it.
//!
//! With `|x| = 1` and `P(x) = 0` also `P*(x) = x^d conj(P(x)) = 0`, so that the resultant of P and P* is zero, and modulo every prime.
//! Where `UP + VP* ≡ 1` modulo a prime that keeps the leading coefficient of P it is not.

use num_traits::ToPrimitive;

use super::field::{Field, root_of_order};
use super::polynomial::Polynomial;
use crate::exact::modulo::primes;
use crate::proof::CoprimeClaim;

/// Longer identities are not written.
const HIGHEST_DEGREE: i64 = 64;
/// Primes for larger conductors are not looked for.
const LARGEST_CONDUCTOR: u64 = 1_000_000;
/// A small prime divides the resultant by accident.
const LEAST_PRIME: u64 = 10_000;
const PRIMES_TRIED: usize = 3;

/// The identity, if one of a few primes has it.
pub(super) fn prove(polynomial: &Polynomial) -> Option<CoprimeClaim> {
    let conductor = polynomial.conductor().to_u64().filter(|conductor| *conductor < LARGEST_CONDUCTOR)?;
    if polynomial.degree() > HIGHEST_DEGREE {
        return None;
    }
    let scale = polynomial.scale();
    primes(conductor, LEAST_PRIME).take(PRIMES_TRIED).find_map(|prime| {
        let root = root_of_order(conductor, prime)?;
        let field = Field { conductor, prime, root, scale: &scale };
        let [straight, mirrored] = field.images(polynomial);
        if straight.last().is_none_or(|leading| *leading == 0) {
            return None;
        }
        let (u, v) = field.bezout(straight, mirrored)?;
        let (phi, delta) = (polynomial.phi.clone(), polynomial.delta.clone());
        Some(CoprimeClaim { phi, delta, conductor, prime, root, scale: scale.clone(), u, v })
    })
}
