//! Is this sum of rotating vectors zero? Decided in exact arithmetic, with the evidence.
//!
//! A sum is `S = Σ w_j e^{2πi t_j}` with rational weights `w_j` and rational angles `t_j` (turns).
//! No float, no tolerance and no sampling enters here: floats do not compile in this room.

mod collected;
mod decide;
mod dense;
mod evidence;
mod fewest;
pub mod fraction;
mod minimal;
pub mod modulo;
mod polygons;
mod residue;
mod splitting;
mod sum;
mod term;
mod terms;
mod turn;
mod words;

pub use collected::IntegerSum;
pub use decide::vanishes;
pub use minimal::{MOST_VECTORS, MinimalStar, StarClass, StarPart, minimal_stars, taken_apart};
pub use sum::{PhasorSum, vanish_apart};
pub use term::Term;
pub use turn::Turn;
