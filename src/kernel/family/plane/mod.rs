//! For which φ and δ does a sum vanish in which both enter on their own? A triangle, or two classes of parts.
//!
//! Where the multiples of all parts lie on one line the sum has one unknown ([`super::circle`]). Three parts else make a triangle; some sums
//! are products; parts on two parallel lines make two classes, as those of every V engine do (theory, section 17). Three classes that are
//! equally far apart, as those of a W engine, make a quadratic; else the torus
//! is cut into boxes ([`boxes`]).

pub(super) mod boxes;
pub(super) mod classes;
mod laurent;
pub(super) mod product;
pub(super) mod quadratic;
mod roots;
mod split;
pub(super) mod triangle;

pub use boxes::Boxes;
pub use classes::Classes;
pub use quadratic::Quadratic;
pub use roots::Root;
pub use triangle::{Corner, Triangle};
