//! How large is it, in decimals? Approximate values, for reading only: no verdict is made from them.

mod evaluate;
mod fixed;

pub use evaluate::{direction, evaluate};
