//! For which φ and δ does a sum vanish in which both enter on their own? A triangle, or two classes of parts.
//!
//! Where the multiples of all parts lie on one line the sum has one unknown ([`super::circle`]). Three parts else make a triangle; some sums
//! are products; parts on two parallel lines make two classes, as those of every V engine do (theory, section 17). Three classes that are
//! equally far apart, as those of a W engine, make a quadratic; else the torus
//! is cut into boxes ([`boxes`]).

mod boxes;
mod classes;
mod laurent;
mod product;
mod quadratic;
mod roots;
mod split;
mod triangle;

pub use boxes::{BoxZero, Boxes};
pub use classes::{Classes, Meeting};
pub use product::Product;
pub use quadratic::{Quadratic, Twist};
pub use roots::{Root, Roots};
pub use triangle::{Corner, Shape, Triangle};

use super::{Part, When};

/// When three parts at least vanish, which do not lie on one line; `None` where that is not solved.
pub(super) fn when(parts: &[&Part]) -> Option<When> {
    match parts {
        [first, second, third] => triangle::when([first, second, third]),
        more => product::when(more)
            .or_else(|| classes::when(more))
            .or_else(|| quadratic::when(more))
            .or_else(|| boxes::when(more)),
    }
}
