//! Which sum of rotating vectors is an order of the force, the moment, the torque?
//!
//! Order k of force and moment is `½ω²(P_k⁺ e^{ikθ} + P_k⁻ e^{−ikθ})` (theory, section 3). Every source of force adds a term
//! to one or both sums ([`contributions`]), which is multiplied by a number of the motion ([`Factor`]). The terms multiplied by one
//! number are one exact phasor sum; sums with different multipliers are kept apart ([`OrderSum`]).

mod coefficients;
mod comparable;
mod contribution;
mod corrected;
mod crank;
mod factor;
mod group;
mod lengths;
mod link;
mod masses;
mod missing_arm;
mod parts;
mod path;
mod phase;
mod pin;
mod roll;
mod source;
mod sum;
mod turning;

pub use crate::proof::Masses;
pub use coefficients::{Coefficients, exactly_one};
pub use comparable::{NotComparable, comparable};
pub use contribution::{
    Contribution, Sources, all_masses, contributions, crankshaft_contributions, groups_of, lever, masses_as_built,
    power, roll, star, torque,
};
pub use corrected::Corrected;
pub use crank::{crank, crank_of};
pub use factor::Factor;
pub use group::{Group, OrderTerms};
pub use lengths::difference_of_squares;
pub use link::Linkage;
pub use masses::MassGroup;
pub use missing_arm::{MissingArm, roll_lacks};
pub use parts::rays;
pub use path::Path;
pub use phase::{multiples, phase, phase_of};
pub use pin::{has_constant_pin_loads, pin_contributions, shaft_contributions};
pub use source::Source;
pub use sum::{OrderSum, by_factor};
pub use turning::{TurningMass, big_end, mass_radius, shaft_parts, turning_masses};
