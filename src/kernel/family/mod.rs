//! For which angles and spacings does it vanish? Sums with an open bank angle φ, pin split δ, and open lengths.
//!
//! An angle `q + jφ + lδ` puts the factor `e^{i(jφ + lδ)}` before its term, and an arm `Σ c_s s` splits the sum by its
//! symbols. So every sum is `Σ_s s Σ_{j,l} e^{i(jφ + lδ)} S_{s,j,l}` with phasor sums S without unknowns: it vanishes for
//! all values of the symbols iff each `Σ_{j,l}` does, and for all angles iff every S does (theory, section 5).

mod angles;
mod circle;
mod classify;
mod comparable;
mod component;
mod firing;
mod part;
mod plane;
mod range;
mod remaining;
mod solve;
mod torque;
mod verdict;
mod when;
mod zeros;

pub use angles::Angles;
pub use circle::{Circle, Closed, Polynomial};
pub use classify::{classify, phase};
pub use comparable::{NotComparable, comparable};
pub use component::{Component, component_zeros};
pub use firing::{EvenFiring, even_firing, even_firing_lines};
pub use part::Part;
pub use plane::{Boxes, Classes, Corner, Quadratic, Root, Triangle};
pub use range::{Place, in_range, is_in_range};
pub use remaining::{Remaining, remaining};
pub use torque::{NoOpenStar, OpenStar, SpanStar, firing_stars};
pub use verdict::{OpenOrder, OpenSum, OpenVerdict};
pub use when::{Never, Product, When};
pub use zeros::{Solutions, Zeros};
