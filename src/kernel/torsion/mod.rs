//! At which speeds does the crankshaft twist, and how far? Natural frequencies and modes of discs on shafts, the critical speeds of each order, and the
//! forced vibration with damping.
//!
//! `discs, shafts, gears → a tree at one speed → modes (Holzer) → firing star of each mode → critical speeds`, and
//! `(K(1+iη) + iΩC − Ω²J) Θ = M → amplitudes, torques, heat`. A train without damping is the one with η = c = 0 (theory, section 13). Mode shapes are
//! decimals, and so are their stars; the star of a rigid crankshaft is exact.

mod branch;
mod critical;
mod damper;
mod energy;
mod forced;
mod holzer;
mod limit;
mod mesh;
mod peak;
mod shapes;
mod synthesis;
mod train;

pub use critical::{Critical, CriticalSpeeds, critical_speeds};
pub use damper::{DamperInMode, DamperSetting, formula, in_first_mode, narrow_resonances, search};
pub use energy::{Resonance, half_width, resonance};
pub use forced::{Excitation, Heat, forced_twist, heat, shaft_torques};
pub use holzer::{Mode, Node, modes};
pub use limit::{HIGHEST_RATIO, StressLimit, UNBARRED, barred, stress};
pub use mesh::mesh_torques;
pub use peak::{beside, evenly, first_of_largest, highest, highest_among, peaks};
pub use synthesis::half_range;
pub use train::{Disc, Link, Train};
