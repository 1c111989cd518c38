//! Which motion does a crank of an engine have?

use crate::engine::{Mechanism, Rod};
use crate::motion::SliderCrank;

/// The motion of a crank with a rod of its own that an engine has: it turns round. None of a link.
pub fn crank(mechanism: &Mechanism) -> Option<SliderCrank> {
    mechanism.rod().map(crank_of)
}

/// The motion of a crank with this rod.
pub fn crank_of(rod: &Rod) -> SliderCrank {
    match SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) {
        Ok(crank) => crank,
        Err(_) => unreachable!("an engine's mechanisms turn round"),
    }
}
