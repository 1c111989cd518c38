//! How large is it? Closed forms, and decimals for reading: no verdict is made from a decimal.

mod closed;
mod evaluate;
mod fixed;
mod form;
mod written;

pub use closed::{Direction, direction_of, mean_of_conjugates, modulus, real};
pub use evaluate::{direction, enclose, evaluate};
pub use form::{Form, Root};
