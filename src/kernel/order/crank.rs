//! Which motion does a crank of an engine have?

use crate::engine::{Mechanism, Rod};
use crate::motion::SliderCrank;

/// The motion of a crank with a rod of its own that an engine has: it turns round. None of a link.
pub fn crank(mechanism: &Mechanism) -> Option<SliderCrank> {
    match mechanism {
        Mechanism::SliderCrank(rod) => Some(crank_of(rod)),
        Mechanism::Link(_) => None,
    }
}

/// The motion of a crank with this rod.
pub fn crank_of(rod: &Rod) -> SliderCrank {
    match SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) {
        Ok(crank) => crank,
        Err(_) => unreachable!("an engine's mechanisms turn round"),
    }
}
