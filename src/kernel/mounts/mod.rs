//! How does an engine shake on its mounts? Six modes, the motion that each order makes, what the mounts pass on.
//!
//! The engine is one rigid body on springs and dampers (theory, section 18): `M = diag(m, I)` about the centre of gravity, and
//! `K = Σ Bᵀ Q k Qᵀ B` with `B = [1, −[r − r_G]×]` for a mount at r. Order κ of force F and moment M at the speed ω moves it by
//! `Z q = (F, M)`, `Z = K(1 + iη) + iΩC − Ω²M`, `Ω = κω`. Whether an order leaves it still is exact: Z is invertible, so it does where
//! force, moment and roll moment of that order vanish.

mod body;
mod excitation;
mod missing;
mod roll_axis;

pub use body::{Body, Mode, Motion};
pub use excitation::{Excitation, OrderExcitation, Still, excitation, usual_orders};
pub use missing::NoExcitation;
pub use roll_axis::{RollAxis, roll_axis};

use num_complex::Complex;

/// Along x, y and z, in the sense of rotation.
pub type Phasors = [Complex<f64>; 3];
