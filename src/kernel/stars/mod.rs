//! Which moments can the crank star of n throws lose, which never, and how many stars do?
//!
//! Throws are one spacing apart in evenly spread directions, masses and rods are equal: the star of an in-line engine that fires evenly, and of
//! each bank of a V on shared pins. Theorems answer without a search:
//!
//! ```
//! # use crankstar_kernel as crankstar;
//! use crankstar::stars::{self, Fate, Pins};
//!
//! // Seven is a prime: no star of seven loses its first-order moment. Fifteen is the first number that loses orders 1, 2 and 4.
//! assert!(matches!(stars::fate(Pins::once(7), &[1]), Fate::Never(_)));
//! let Fate::Lost(made) = stars::fate(Pins::once(15), &[1, 2, 4]) else { panic!() };
//! assert_eq!((made.star.loses(4), made.star.first_left()), (true, Some(6)));
//! assert_eq!(stars::count(Pins::once(15), &[1, 2, 4]).unwrap().stars, 96_u32.into());
//! ```
//!
#![doc = include_str!("README.md")]

mod count;
mod covers;
mod factors;
mod fate;
mod least;
mod made;
mod spaced;
mod star;

pub use count::{Count, Counted, count};
pub use factors::{PrimePower, prime_powers};
pub use fate::{Fate, MOST_THROWS, Made, Obstruction, Pins, fate};
pub use least::{Least, least};
pub use made::By;
pub use spaced::{Decomposition, decompositions, listed, stars_of};
pub use star::Star;
