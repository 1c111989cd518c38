//! How is a front written as JSON?

use serde::Serialize;

use crate::proof::Sense;

use super::answer::Front;
use super::found::{self, FoundStar, Moment};

/// A front for other programs to read.
#[derive(Clone, Debug, Serialize)]
pub struct FrontDocument {
    /// The engine: `In-line 6`, `V8, 90°`.
    pub engine: String,
    /// `two-stroke` or `four-stroke`.
    pub cycle: &'static str,
    /// The orders compared.
    pub orders: Vec<u32>,
    /// Whether neighbours that fire in succession count.
    pub neighbours: bool,
    /// Stars with cylinder 1 at 0 that there are.
    pub all_stars: String,
    /// Stars judged one by one.
    pub judged: u64,
    /// Starts left out with all their completions.
    pub cut: u64,
    /// The front.
    pub stars: Vec<StarDocument>,
}

/// A star of the front.
#[derive(Clone, Debug, Serialize)]
pub struct StarDocument {
    /// Cylinders in firing order, `1-3-4-2`; missing where the engine cannot fire evenly.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub firing_order: Option<String>,
    /// Angles of the throws in turns.
    pub throws: Vec<String>,
    /// The moments of the orders.
    pub moments: Vec<MomentDocument>,
    /// Pairs of neighbours that fire in succession.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub neighbours: Option<usize>,
    /// Stars of equal values, up to rotation, mirror and reversal.
    pub classes: u64,
    /// Stars of equal values with cylinder 1 at 0.
    pub stars: u64,
    /// The engine as a layout file.
    pub layout: String,
}

/// The moment of an order.
#[derive(Clone, Debug, Serialize)]
pub struct MomentDocument {
    /// The order.
    pub order: u32,
    /// `direct` or `reverse`, for a V.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sense: Option<Sense>,
    /// The length in closed form, where one is short enough to read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exact: Option<String>,
    /// The length in decimals.
    pub decimal: f64,
}

/// The front as a document.
pub fn document(front: &Front) -> FrontDocument {
    let problem = &front.problem;
    let moment = |moment: &Moment| MomentDocument {
        order: moment.order,
        sense: moment.sense,
        exact: moment.modulus().map(|form| form.to_string()),
        decimal: moment.decimal,
    };
    let star = |star: &FoundStar| StarDocument {
        firing_order: star.firing_order.as_deref().map(found::dashed),
        throws: star.throws.iter().map(|throw| throw.turns().to_string()).collect(),
        moments: star.moments.iter().map(moment).collect(),
        neighbours: star.neighbours,
        classes: star.classes,
        stars: star.stars,
        layout: star.layout_file(problem),
    };
    FrontDocument {
        engine: found::name(problem),
        cycle: found::cycle(problem),
        orders: problem.orders.clone(),
        neighbours: problem.neighbours,
        all_stars: front.all.to_string(),
        judged: front.judged,
        cut: front.cut,
        stars: front.stars.iter().map(star).collect(),
    }
}
