//! What does accuracy cost? The same peak load by several methods, each with its error and its time.
//!
//! Orders and samples in floats are fast and come with a bound or none; intervals and fractions are slow and certain. The most
//! accurate of them is the yardstick of all.
//!
//! ```standalone_crate
//! # use crankstar_kernel as crankstar;
//! use crankstar::accuracy::{self, Method, Timing};
//! use crankstar::proof::Quantity;
//! use num_rational::BigRational;
//!
//! let i4 = crankstar::file::find("I4").unwrap().engine().unwrap();
//! let i4 = accuracy::with_rod_ratio(&i4, &BigRational::new(3.into(), 10.into())).unwrap();
//! let force = accuracy::study(&i4, Quantity::FORCE, Timing::Off).unwrap();
//! let second_order = force.rows.iter().find(|row| row.method == Method::Orders(2)).unwrap();
//! assert!(0.02 < second_order.error && second_order.error < second_order.bound.unwrap());
//! ```

mod bearing;
mod bodies;
mod branch;
mod fixed;
mod front;
mod interval;
mod jet;
mod largest;
mod method;
mod orders;
mod real;
mod reference;
mod sample;
mod timing;

use num_rational::BigRational;
use num_traits::Zero;

pub use bearing::{PeakRow, bearings};
pub use front::front;
pub use largest::{Largest, LargestLoads, SURE, largest};
pub use method::{Method, Own, Row, Study, study};
pub use timing::{Timing, measured};

use crate::engine::{BuildError, Engine, Mechanism, Rod};

/// The same engine with this rod ratio λ at every cylinder.
///
/// The cranks stay as they are, so an offset δ = e/l grows with λ = r/l. An engine without rods gets rods without offset.
///
/// # Errors
/// A rod that is too short.
pub fn with_rod_ratio(engine: &Engine, ratio: &BigRational) -> Result<Engine, BuildError> {
    engine.only_rods().map_err(|with| BuildError::OfRodsAlone(with, "another rod ratio"))?;
    let mut draft = engine.clone().into_draft();
    for cylinder in &mut draft.cylinders {
        let offset = match cylinder.rod() {
            Some(rod) if !rod.ratio.is_zero() => &rod.offset * ratio / &rod.ratio,
            Some(rod) => rod.offset.clone(),
            None => BigRational::zero(),
        };
        cylinder.mechanism = Some(Mechanism::SliderCrank(Rod { ratio: ratio.clone(), offset }));
    }
    draft.build()
}
