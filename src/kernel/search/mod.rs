//! Which crank star balances best? All stars of an engine, up to their symmetries, and the exact front of the best.
//!
//! ```standalone_crate
//! # use crankstar_kernel as crankstar;
//! use crankstar::engine::Cycle;
//! use crankstar::search::{Options, Problem, search};
//! let six = Problem::inline(6, Cycle::TwoStroke, &[1, 2]);
//! let front = search(&six, &Options::default()).unwrap();
//! let first = &front.stars[0];
//! let lengths: Vec<String> = first.moments.iter().map(|m| m.modulus().unwrap().to_string()).collect();
//! println!("{lengths:?}"); // no first-order couple, and then at least this of the second order
//! // ["0", "2√3"]
//! # assert_eq!(lengths, ["0", "2√3"]);
//! ```
//!
#![doc = include_str!("README.md")]

mod answer;
mod balanced;
mod best;
mod clock;
mod document;
mod entangled;
mod firing;
mod found;
mod front;
mod join;
mod judged;
mod limit;
mod mode_shape;
mod options;
mod piece;
mod pieces;
mod plan;
mod problem;
mod roots;
mod sizes;
mod space;
mod symmetry;
mod tables;
mod theorems;
mod torsion;
mod twist;
mod value;
mod vee;
mod walk;
mod written;

pub use answer::{Front, every_value};
pub use best::{Best, best_in_line};
pub use document::{FiringOrderDocument, FrontDocument, MomentDocument, PhaseSumDocument, StarDocument, document};
pub use found::{FoundStar, Moment, Standing};
pub use limit::{Limit, Limits};
pub use mode_shape::mode_shape;
pub use options::{Options, Progress, SearchError};
pub use pieces::{Pieces, search};
pub use plan::Way;
pub use problem::{FINEST_GRID, MOST_GRID_STARS, MOST_ORDERS, MOST_THROWS, Problem, ProblemError, bank_angle};
pub use sizes::Sizes;
pub use theorems::{Theorems, answer, described, theorems};
pub use torsion::{MOST_TORSION_STARS, RankedOrder, StarTorsion, Torsion, torsion};
