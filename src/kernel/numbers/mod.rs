//! How large is it? Closed forms, and decimals for reading: no verdict is made from a decimal.

mod banks;
mod budget;
mod closed;
mod cosines;
mod cost;
mod direction;
mod evaluate;
mod form;
mod known;
mod largest;
mod memory;
mod nested;
mod products;
mod quadratic;
mod radicals;
mod rational_direction;
mod speed;
mod star;
mod trace;
mod weighted;
mod written;

pub use crate::motion::float;
pub use budget::Budget;
pub use closed::{modulus, modulus_by_roots, modulus_within, plainer, real, real_within};
pub use direction::{Direction, direction_of};
pub use evaluate::{degrees, direction, enclose, enclose_in_units, evaluate, length, length_of, sign};
pub use form::{Form, Root};
pub use known::known_cosine;
pub use largest::half_of_lengths;
pub use radicals::{as_sum, number, square_as_sum};
pub use speed::angular_speed;
pub use trace::mean_of_conjugates;
pub use weighted::enclose_weighted;

/// Floats that differ by less than this part of their size are one for all that their roundings tell, and a sum of floats that is
/// longer than this part of its terms is not zero: roundings are far less, with as many cylinders as are read.
pub const ALIKE: f64 = 1e-9;
