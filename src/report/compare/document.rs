//! What does `compare --json` hold? Each engine with its verdicts, exact and in decimals, remedy, firing and bearings.

use num_rational::BigRational;
use num_traits::Zero;
use serde::Serialize;
use serde_json::{Value, json};

use super::super::loads_document::{ScaleEntry, size, units};
use super::super::remaining::RemainingOrder;
use super::super::{document, engine_cells};
use super::{Compared, orders_of};
use crate::engine::Engine;
use crate::loads::{self, BearingLoads, Loads, OrderLoads, Scale, Swing};
use crate::numbers;
use crate::proof::{COMPARE_NOT_CHECKED, Document, Format, Quantity};

/// Engines side by side, as data. In JSON it holds the verdicts once, with their certificates, and numbers beside them; what else is said of
/// an engine here is in tables.
#[derive(Clone, Debug, Serialize)]
pub struct CompareDocument {
    /// Dispatches it among the documents that `verify` reads.
    format: Format,
    orders: Vec<u32>,
    amplitudes: &'static str,
    pub(in crate::report) engines: Vec<EngineEntry>,
    /// The numbers that nothing is compared with.
    not_checked: [&'static str; COMPARE_NOT_CHECKED.len()],
    /// The verdicts on each engine, with their certificates.
    evidence: Vec<Document>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct EngineEntry {
    pub(in crate::report) title: String,
    #[serde(skip)]
    pub(in crate::report) cylinders: usize,
    pub(in crate::report) position_unit: &'static str,
    pub(in crate::report) firing: Option<Firing>,
    pub(in crate::report) orders: Vec<RemainingOrder>,
    /// Lowest order of force and moment that is left, in words.
    #[serde(skip)]
    pub(in crate::report) first_force_left: String,
    #[serde(skip)]
    pub(in crate::report) first_moment_left: String,
    #[serde(skip)]
    pub(in crate::report) remedy: String,
    /// What `newtons` are counted with.
    scale: Option<ScaleEntry>,
    /// Forces in N and moments in N·m; null where the layout lacks numbers.
    pub(in crate::report) newtons: Option<Vec<Newtons>>,
    pub(in crate::report) worst_bearings: Option<Worst>,
    /// Of gas and masses together, where the layout asks for the gas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::report) worst_bearing_with_gas: Option<Worst>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Firing {
    #[serde(skip)]
    pub(in crate::report) even: bool,
    pub(in crate::report) intervals_deg: Vec<f64>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Newtons {
    pub(in crate::report) order: u32,
    pub(in crate::report) force: f64,
    pub(in crate::report) moment: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Worst {
    /// Numbers from 1.
    pub(in crate::report) bearings: Vec<usize>,
    pub(in crate::report) peak: f64,
    pub(in crate::report) unit: &'static str,
}

impl CompareDocument {
    /// The same without its proofs, which `verify` then does not take.
    pub fn without_evidence(self) -> Self {
        CompareDocument { evidence: Vec::new(), ..self }
    }
}

/// The comparison as data.
pub fn compare_document(engines: &[Compared]) -> CompareDocument {
    let quantities = Quantity::PLANAR;
    let evidence = |engine: &Compared| {
        let judged = &engine.judged;
        document::document(&engine.engine, judged.masses, &judged.orders, &quantities, None)
    };
    CompareDocument {
        format: Format::Compare,
        orders: orders_of(engines),
        amplitudes: "zero-to-peak",
        not_checked: COMPARE_NOT_CHECKED,
        engines: engines.iter().map(engine).collect(),
        evidence: engines.iter().map(evidence).collect(),
    }
}

fn engine(engine: &Compared) -> EngineEntry {
    let first_left = engine_cells::first_left(&engine.engine, &engine.theorem, &engine.judged.orders);
    let [first_force_left, first_moment_left] = first_left.map(|text| text.plain());
    EngineEntry {
        title: engine.engine.title().written().to_owned(),
        cylinders: engine.engine.cylinders().len(),
        position_unit: engine.engine.length_unit().name(),
        firing: firing(&engine.engine),
        orders: engine.judged.orders.iter().map(RemainingOrder::new).collect(),
        first_force_left,
        first_moment_left,
        remedy: engine_cells::remedy(&engine.remedy).plain(),
        scale: moving(engine).map(|(_, scale)| ScaleEntry::of(scale)),
        newtons: newtons(engine),
        worst_bearings: engine.bearings.as_ref().ok().map(worst),
        worst_bearing_with_gas: engine.worst_with_gas().map(|(worst, peak)| Worst {
            bearings: worst.iter().map(|index| index + 1).collect(),
            peak: peak.value,
            unit: "N",
        }),
    }
}

fn firing(engine: &Engine) -> Option<Firing> {
    let degrees = |turns: &BigRational| numbers::float(&(turns * BigRational::from_integer(360.into())));
    let intervals = |firing: &crate::engine::Firing| firing.intervals().iter().map(degrees).collect();
    engine.firing().map(|firing| Firing { even: firing.is_even(), intervals_deg: intervals(firing) })
}

/// What loads and comparisons say of a layout beside its verdicts, for the comparison of a document with it.
pub fn numbers_of(engine: &Engine) -> Value {
    let scale = loads::scale(engine);
    let units = units(engine, scale.as_ref());
    json!({ "scale": scale.as_ref().map(ScaleEntry::of), "units": units, "position_unit": engine.length_unit().name(), "firing": firing(engine) })
}

/// None at rest: all newtons would be 0, whatever the engine is.
fn moving(engine: &Compared) -> Option<(&Loads, &Scale)> {
    let loads = engine.loads.as_ref().ok()?;
    Some((loads, loads.scale.as_ref().filter(|scale| !scale.speed.is_zero())?))
}

fn newtons(engine: &Compared) -> Option<Vec<Newtons>> {
    let (loads, scale) = moving(engine)?;
    let unit = scale.force();
    let newtons = |swing: &Swing| size(swing.largest(), unit, swing.direct.vanishes() && swing.reverse.vanishes());
    let order = |order: &OrderLoads| Newtons {
        order: order.order,
        force: newtons(&order.force),
        moment: newtons(&order.moment),
    };
    Some(loads.orders.iter().map(order).collect())
}

fn worst(loads: &BearingLoads) -> Worst {
    let scale = loads.scale.as_ref();
    let peak = loads.worst.first().map_or(0.0, |index| loads.bearings[*index].peak.value);
    Worst {
        bearings: loads.worst.iter().map(|index| index + 1).collect(),
        peak: peak * scale.map_or(1.0, |scale| scale.force()),
        unit: if scale.is_some() { "N" } else { "m r ω²" },
    }
}
