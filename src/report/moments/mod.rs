//! Which external moments and guide-force moments do engines have, side by side, as makers' project guides list them?
//!
//! Moments of the free forces by order, along direction 0 (V) and across it (H); each is zero by proof or a decimal. The guide-force
//! moments H and X are those of the torque (makers' project guides of large two-strokes, sections 17.04 to 17.07).

mod data;
mod page;

use super::question::question;
use crate::engine::{Crankshaft, CycleOrder, Engine, HIGHEST_ORDER};
use crate::loads::{self, Arm, Missing, OrderLoads};
use crate::order;
use crate::proof::{Planar, Sense};
use crate::report::texts::moments as texts;
use crate::text::{self, Untrusted};
use crate::torque::{self, GuideMoments};

/// The orders of forces and moments that a project guide lists.
pub(super) const ORDERS: [u32; 3] = [1, 2, 4];

/// Orders of H and X have columns up to this one.
const LAST_COLUMN: u32 = torque::HIGHEST;
/// The order above them of which makers list X too.
const LAST_TWISTING: u32 = 16;

/// An amplitude, zero to peak, in newtons or newton-metres; none where it is proved to be zero.
pub type Amplitude = Option<f64>;

/// One order of the external force or moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct External {
    /// The order.
    pub order: u32,
    /// Along direction 0 (V), and across it (H).
    pub components: [Amplitude; 2],
}

/// An engine with its external moments.
#[derive(Clone, Debug)]
pub struct MomentsRow {
    /// What it is called.
    pub name: Untrusted,
    /// The engine.
    pub engine: Engine,
    /// Whether its counterweights and balancer shafts are omitted.
    pub is_bare: bool,
    /// The forces.
    pub forces: Vec<External>,
    /// The moments about the reference plane.
    pub moments: Vec<External>,
    /// The first-order moment where counterweights cancel what turns with the crank: as large along as across.
    pub countered: Amplitude,
    /// The guide-force moments by order, and power in watts; or why there are none.
    pub guides: Result<(Vec<GuideMoments>, Option<f64>), String>,
}

/// Engines with their moments.
#[derive(Clone, Debug)]
pub struct MomentsStudy {
    /// A row an engine, and one more for an engine without its counterweights and balancer shafts where it has any.
    pub rows: Vec<MomentsRow>,
}

/// The name of an engine in a message.
fn plain(name: &Untrusted) -> String {
    name.escaped(text::Format::Plain)
}

/// Why an engine has no moments in newton-metres.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoMoments {
    /// No engine.
    #[error("no engine is named whose moments are wanted")]
    Nothing,
    /// No masses, crank radius or speed.
    #[error("{}: moments in kN·m need a speed above the first table, and reciprocating_mass and crank_radius below [mechanism]", plain(.0))]
    Scale(Untrusted),
    /// No positions in metres.
    #[error("{}: moments in kN·m need the spacing of the cylinders, such as spacing = \"0.85 m\"", plain(.0))]
    Positions(Untrusted),
    /// What else the layout lacks.
    #[error("{}: {1}", plain(.0))]
    Missing(Untrusted, Missing),
}

impl MomentsStudy {
    /// The moments of these engines.
    ///
    /// # Errors
    /// See [`NoMoments`].
    pub fn new(engines: &[(Untrusted, Engine)]) -> Result<Self, NoMoments> {
        if engines.is_empty() {
            return Err(NoMoments::Nothing);
        }
        let mut rows = Vec::new();
        for (name, engine) in engines {
            rows.push(MomentsRow::new(name, engine, false)?);
            let crankshaft = engine.crankshaft();
            if !(crankshaft.counterweights.is_empty() && crankshaft.balancers.is_empty()) {
                let bare = Crankshaft {
                    counterweights: Vec::new(),
                    balance_factors: Vec::new(),
                    balancers: Vec::new(),
                    ..crankshaft.clone()
                };
                // What is taken away fits whatever remains; a row that is not of it would be false.
                if let Ok(bare) = engine.with_crankshaft(bare) {
                    rows.push(MomentsRow::new(name, &bare, true)?);
                }
            }
        }
        Ok(MomentsStudy { rows })
    }

    /// The engines as they are built.
    fn built(&self) -> impl Iterator<Item = &MomentsRow> {
        self.rows.iter().filter(|row| !row.is_bare)
    }
}

impl MomentsRow {
    fn new(name: &Untrusted, engine: &Engine, is_bare: bool) -> Result<Self, NoMoments> {
        let scale = loads::scale(engine).ok_or_else(|| NoMoments::Scale(name.clone()))?;
        if Arm::of(engine) != Arm::Metre {
            return Err(NoMoments::Positions(name.clone()));
        }
        let missing = |what| NoMoments::Missing(name.clone(), what);
        let all = loads::loads_at(engine, &ORDERS, &[]).map_err(missing)?;
        let newtons = scale.force();
        let of = |quantity| all.orders.iter().map(move |order| external(engine, order, quantity, newtons)).collect();
        let reverse = order::all_masses(engine, Planar::Moment, 1, Sense::Reverse);
        let countered = all.orders.first().filter(|_| !reverse.vanishes());
        Ok(MomentsRow {
            name: name.clone(),
            is_bare,
            forces: of(Planar::Force),
            moments: of(Planar::Moment),
            countered: countered.map(|first| first.moment.reverse.value.norm() / 2.0 * newtons),
            guides: guides(engine, highest_of_guides(engine)),
            engine: engine.clone(),
        })
    }

    /// What the guide-force moments are of an order; none where there are none.
    pub(super) fn guide(&self, order: CycleOrder) -> Option<&GuideMoments> {
        self.guides.as_ref().ok()?.0.iter().find(|moments| moments.order == order)
    }

    /// The second-order moment over the power, in newton-metres a kilowatt: makers' measure of whether a compensator is needed.
    pub(super) fn per_kilowatt(&self) -> Option<f64> {
        let power = self.guides.as_ref().ok()?.1.filter(|power| *power > 0.0)?;
        let second = self.moments.iter().find(|moment| moment.order == 2)?;
        Some(second.components[0].unwrap_or_default() / (power / 1e3))
    }
}

/// Both components of an order: `P⁺ ± P̄⁻`, zero where the sums of all coefficients are.
fn external(engine: &Engine, order: &OrderLoads, quantity: Planar, newtons: f64) -> External {
    let [direct, reverse] = Sense::BOTH.map(|sense| order::all_masses(engine, quantity, order.order, sense));
    let mirrored = reverse.mirrored();
    let swing = order.swing(quantity);
    let along = (!direct.plus(&mirrored).vanishes()).then(|| swing.along() * newtons);
    let across = (!direct.minus(&mirrored).vanishes()).then(|| swing.across() * newtons);
    External { order: order.order, components: [along, across] }
}

/// The order of the firing frequency; none where cylinders do not fire evenly.
pub(super) fn order_of_firing(engine: &Engine) -> Option<CycleOrder> {
    let firing = engine.firing().filter(|firing| firing.is_even())?;
    let shots = u32::try_from(firing.shots.len()).ok()?;
    CycleOrder::of_halves(shots * firing.cycle.lowest_order().halves())
}

/// Makers list X up to order 16, and H up to three times the firing frequency.
fn highest_of_guides(engine: &Engine) -> u32 {
    let thrice = order_of_firing(engine).map_or(0, |order| (3 * order.halves()).div_ceil(2));
    thrice.clamp(LAST_TWISTING, HIGHEST_ORDER)
}

/// The guide-force moments by order up to this one, and the power; or why there are none.
pub(super) fn guides(engine: &Engine, highest: u32) -> Result<(Vec<GuideMoments>, Option<f64>), String> {
    let torque = torque::torque_up_to(engine, highest).map_err(|lack| lack.to_string())?;
    let moments = torque::guide_moments(engine, &torque).ok_or_else(|| texts::guides_known().plain())?;
    Ok((moments, torque.power))
}

question!(MomentsStudy, "moments", |_| None);
