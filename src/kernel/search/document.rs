//! How is a front written as JSON?

use serde::Serialize;

use super::answer::Front;
use super::found::{self, FoundStar, Moment};
use super::mode_shape;
use super::theorems::theorems;
use super::torsion::{RankedOrder, Torsion};
use crate::engine::CycleOrder;
use crate::exact::PhasorSum;
use crate::numbers;
use crate::proof::Sense;

/// A front for other programs to read.
#[derive(Clone, Debug, Serialize)]
pub struct FrontDocument {
    /// `crankstar search 1`.
    pub format: &'static str,
    /// The engine: `In-line 6`, `V8, 90°`.
    pub engine: String,
    /// `two-stroke` or `four-stroke`.
    pub cycle: &'static str,
    /// The orders compared.
    pub orders: Vec<u32>,
    /// Whether neighbours that fire in succession count.
    pub neighbours: bool,
    /// How far ahead of the pin of bank 1 that of bank 2 stands, in turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pin_split: Option<String>,
    /// How far bank 1 stands towards the free end of bank 2, in spacings.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bank_offset: Option<String>,
    /// The deflections that weigh the minor orders, where they are compared.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub mode_shape: Vec<String>,
    /// Stars with cylinder 1 at 0 that there are.
    pub all_stars: String,
    /// How many of them have balanced first-order force, where only these are compared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balanced_stars: Option<u64>,
    /// Stars judged one by one.
    pub judged: u64,
    /// Starts omitted with all their completions.
    pub cut: u64,
    /// Orders whose moments no star loses together, by a theorem.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub impossible: Vec<Vec<u32>>,
    /// How many stars lose the moments of all orders compared, with cylinder 1 at 0, where a theorem counts them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stars_that_lose_all: Option<String>,
    /// Whether a theorem gave the star of the front, and nothing was searched.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub by_theorem: bool,
    /// The limits that its stars keep: `2=1.5` in m r ω² c a, `2=30000 N m`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<String>,
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
    /// The minor orders that are compared, in this firing order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub minor_orders: Vec<PhaseSumDocument>,
    /// Pairs of neighbours that fire in succession.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub neighbours: Option<usize>,
    /// Stars of equal values, up to rotation, mirror and reversal; missing where nobody counted them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub classes: Option<u64>,
    /// Stars of equal values with cylinder 1 at 0; missing where nobody counted them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stars: Option<u64>,
    /// The firing orders that are best in a mode of torsional vibration, where they are asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub torsion: Vec<FiringOrderDocument>,
    /// The engine as a layout file.
    pub layout: String,
}

/// A firing order, and the lengths of its phase-vector sums.
#[derive(Clone, Debug, Serialize)]
pub struct FiringOrderDocument {
    /// Cylinders in firing order, `1-3-4-2`.
    pub firing_order: String,
    /// The minor orders up to the middle of a period.
    pub sums: Vec<PhaseSumDocument>,
}

/// The phase-vector sum of an order of the cycle.
#[derive(Clone, Debug, Serialize)]
pub struct PhaseSumDocument {
    /// The order, `3/2`.
    pub order: String,
    /// The length in closed form, where one is short enough to read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exact: Option<String>,
    /// The length in decimals.
    pub decimal: f64,
    /// Whether it is proved to be zero.
    pub proved_zero: bool,
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

impl FrontDocument {
    /// The same with the best firing orders of each star in a mode of torsional vibration.
    pub fn with_torsion(mut self, torsion: &Torsion) -> Self {
        for (star, judged) in self.stars.iter_mut().zip(&torsion.stars) {
            let ranked = |ranked: &RankedOrder| FiringOrderDocument {
                firing_order: ranked.name(),
                sums: torsion.orders.iter().zip(&ranked.sums).map(|(order, sum)| phase_sum(*order, sum)).collect(),
            };
            star.torsion = judged.best.iter().map(ranked).collect();
        }
        self
    }
}

fn phase_sum(order: CycleOrder, sum: &PhasorSum) -> PhaseSumDocument {
    let proved_zero = sum.vanishes();
    let exact = if proved_zero { Some("0".to_owned()) } else { numbers::modulus(sum).map(|form| form.to_string()) };
    let decimal = if proved_zero { 0.0 } else { numbers::evaluate(sum).norm() };
    PhaseSumDocument { order: order.exact().to_string(), exact, decimal, proved_zero }
}

/// The front as a document.
pub fn document(front: &Front) -> FrontDocument {
    let problem = &front.problem;
    let theorems = theorems(problem);
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
        minor_orders: star.minor.iter().map(|(order, sum)| phase_sum(*order, sum)).collect(),
        neighbours: star.neighbours,
        classes: star.classes,
        stars: star.stars,
        torsion: Vec::new(),
        layout: star.layout_file(problem),
    };
    let shape = match problem.minor_orders.is_empty() {
        true => Vec::new(),
        false => mode_shape::deflections(problem, problem.mode_shape.clone()).unwrap_or_default(),
    };
    FrontDocument {
        format: "crankstar search 1",
        engine: found::name(problem),
        cycle: problem.cycle.word(),
        orders: problem.orders.clone(),
        neighbours: problem.neighbours,
        pin_split: problem.pin_split.as_ref().map(|split| split.turns().to_string()),
        bank_offset: problem.bank_offset.as_ref().map(ToString::to_string),
        mode_shape: shape.iter().map(ToString::to_string).collect(),
        all_stars: front.all.to_string(),
        balanced_stars: front.balanced,
        judged: front.judged,
        cut: front.cut,
        impossible: theorems.never.into_iter().map(|never| never.orders).collect(),
        stars_that_lose_all: theorems.count.map(|count| count.stars.to_string()),
        by_theorem: front.described.is_some(),
        limits: front.limits.limits.iter().map(ToString::to_string).collect(),
        stars: front.stars.iter().map(star).collect(),
    }
}
