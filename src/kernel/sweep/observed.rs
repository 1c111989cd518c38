//! Which values of other questions are beside the points of a sweep? Whoever sweeps says how they are found.

use super::SweepError;
use crate::engine::Engine;
use crate::table::Single;

/// The values of one engine, or why it has none.
pub type Observed = Vec<Result<Single, String>>;

/// What is looked for at each point.
pub struct Observer<'a> {
    /// What the values are called.
    pub names: Vec<String>,
    /// Finds them.
    pub find: Box<dyn Fn(&Engine) -> Observed + Sync + 'a>,
}

/// Values beside the points of a sweep.
#[derive(Clone, Debug)]
pub struct ObservedSweep {
    /// What the values are called.
    pub names: Vec<String>,
    /// Those of the first point: the others have their types and units.
    pub first: Vec<Single>,
    /// Those of each point.
    pub points: Vec<Observed>,
}

impl ObservedSweep {
    /// Without points.
    pub(super) fn new(observer: &Observer<'_>, engine: &Engine) -> Result<Self, SweepError> {
        let known = observer.names.iter().zip((observer.find)(engine));
        let first = known.map(|(name, value)| {
            value.map_err(|why| SweepError::new(format!("the first point of the sweep has no {name}: {why}")))
        });
        Ok(ObservedSweep {
            names: observer.names.clone(),
            first: first.collect::<Result<_, SweepError>>()?,
            points: Vec::new(),
        })
    }
}
