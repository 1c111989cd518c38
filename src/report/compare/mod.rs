//! How do engines compare? Side by side: sizes, cures, firing and main bearings first, exact verdicts below.

pub(super) mod data;
pub(super) mod document;
mod notes;
mod page;
mod question;
mod rows;

pub use document::{CompareDocument, compare_document, numbers_of};
pub use page::{compare_answer, compare_page};
pub use question::CompareStudy;

use super::{moments, rising};
use crate::engine::{Engine, NotAnOrder};
use crate::journal::{self, CyclePeak};
use crate::loads::{self, BearingLoads, Loads, Method, Missing};
use crate::proof::Quantity;
use crate::remedy::{self, Remedy, RemedyError, Request};
use crate::text::Untrusted;
use crate::torque::{self, GuideMoments};
use crate::verdict::{self, EveryOrderTheorem, Judgement, NoTheorem, OrderVerdict};

/// An engine of a comparison, judged.
#[derive(Clone, Debug)]
pub struct Compared {
    /// What it is called in the comparison.
    pub name: Untrusted,
    /// The engine.
    pub engine: Engine,
    /// The verdicts, rising by order; several an order where rods differ.
    pub judged: Judgement,
    /// The statements on every order.
    pub theorem: Result<EveryOrderTheorem, NoTheorem>,
    /// What cancels the orders that are compared.
    pub remedy: Result<Remedy, RemedyError>,
    /// What cancels orders 1 and 2, of those that are compared; all where neither is.
    pub cures: Result<Remedy, RemedyError>,
    /// The orders in newtons, where the layout has the numbers.
    pub loads: Result<Loads, Missing>,
    /// What the main bearings feel, where the layout names them: of the orders that `bearings` counts, whichever are compared.
    pub bearings: Result<BearingLoads, Missing>,
    /// The largest load of each main bearing of gas and masses together, and of the masses alone; none where the layout does not ask for the gas.
    pub with_gas: Option<Result<Vec<[CyclePeak; 2]>, Missing>>,
    /// The guide-force moments by order, of gas and masses; empty where the layout does not ask for the gas, or they are not known.
    pub guides: Vec<GuideMoments>,
}

impl Compared {
    /// Judges an engine at these orders.
    ///
    /// # Errors
    /// A number that is no order.
    pub fn new(name: Untrusted, engine: &Engine, orders: &[u32]) -> Result<Self, NotAnOrder> {
        let judged = Judgement::new(engine, orders, &Quantity::PLANAR)?;
        let low: Vec<u32> = orders.iter().copied().filter(|order| *order <= 2).collect();
        let cured = |orders: &[u32]| remedy::remedy(engine, &Request { orders: orders.to_vec(), ..Request::default() });
        Ok(Compared {
            name,
            engine: engine.clone(),
            theorem: verdict::every_order(engine, judged.masses),
            judged,
            remedy: cured(orders),
            cures: cured(if low.is_empty() { orders } else { &low }),
            loads: loads::loads(engine, orders),
            bearings: loads::bearing_loads(engine, &loads::usual_bearing_orders(engine), Method::Continuous),
            // What nobody asks for costs nothing.
            with_gas: engine.effects().gas.then(|| journal::bearing_peaks(engine)),
            guides: match engine.effects().gas {
                true => moments::guides(engine, torque::HIGHEST).map_or_else(|_| Vec::new(), |(moments, _)| moments),
                false => Vec::new(),
            },
        })
    }

    /// The verdicts on one order.
    fn at(&self, order: u32) -> Option<&OrderVerdict> {
        self.judged.orders.iter().find(|judged| judged.order == order)
    }

    /// The verdicts on one order of the pistons alone, where masses that turn have a part in it besides.
    fn pistons_at(&self, order: u32) -> Option<&OrderVerdict> {
        self.judged.differing().find(|judged| judged.order == order)
    }

    /// The main bearings with the largest load of gas and masses, by their indices, and that load; none where there is none.
    fn worst_with_gas(&self) -> Option<(Vec<usize>, CyclePeak)> {
        let peaks = self.with_gas.as_ref()?.as_ref().ok()?;
        let worst = journal::worst(peaks.iter().map(|[all, _]| all.value));
        let peak = peaks[*worst.first()?][0];
        Some((worst, peak))
    }
}

/// The orders that are compared, rising.
fn orders_of<'a>(engines: impl IntoIterator<Item = &'a Compared>) -> Vec<u32> {
    rising(engines.into_iter().flat_map(|engine| &engine.judged.orders).map(|order| order.order))
}
