//! What does `classify --json` say?

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::audit::{Reason, demand};
use super::engine::{Cylinder, Masses, TurningMassClaim, rods};
use super::format::Format;
use super::fraction;
use super::quantity::Quantity;
use super::recurrence::RecurrenceClaim;
use super::rod::RodClaim;
use super::shape::ShapeClaim;
use super::theorem::TheoremClaim;
use super::verdict::VerdictClaim;
use super::whole_sum::WholeClaim;

/// The verdicts on one engine, each with its certificate: the JSON document of `classify --json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// `crankstar classify 2`.
    pub format: Format,
    /// Title of the layout: free text.
    pub title: String,
    /// Whose masses the verdicts are about.
    pub masses: Masses,
    /// The orders that were asked for, rising.
    pub orders: Vec<u32>,
    /// The quantities that were asked for, in the order force, moment, torque.
    pub quantities: Vec<Quantity>,
    /// Whether the statements on every order were asked for.
    pub all_orders: bool,
    /// Position along the crankshaft that the moments are taken about, in metres (or multiples of the spacing).
    #[serde(with = "fraction")]
    pub reference_plane: BigRational,
    /// The cylinders of the engine, also where the verdicts are not about their masses.
    pub cylinders: Vec<Cylinder>,
    /// The masses that turn and that the verdicts are about.
    pub turning_masses: Vec<TurningMassClaim>,
    /// One verdict per order, quantity, coefficient and sense, in this order.
    pub verdicts: Vec<VerdictClaim>,
    /// One statement per order, quantity and sense that has sums before several coefficients, in this order.
    pub wholes: Vec<WholeClaim>,
    /// The shape of the residual, one per order of force and moment.
    pub shapes: Vec<ShapeClaim>,
    /// The statements on every order, one per quantity and sense, where they were asked for.
    pub theorems: Vec<TheoremClaim>,
    /// The same class by class, where no order is a single sum, odd orders exist, or the pattern is long; then no theorem is above.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub recurrences: Vec<RecurrenceClaim>,
}

impl Document {
    /// The rods, where the engine names them.
    pub(super) fn rods(&self) -> Result<Option<Vec<&RodClaim>>, Reason> {
        rods(self.cylinders.iter().map(|cylinder| &cylinder.rod))
    }

    pub(super) fn has_links(&self) -> bool {
        self.cylinders.iter().any(|cylinder| cylinder.rod.link().is_some())
    }

    /// Checks that what turns does so with the crank, and every crankshaft equally fast: as statements on every order need it.
    pub(super) fn check_turning(&self) -> Result<(), &'static str> {
        if self.turning_masses.iter().any(|mass| mass.order > 1) {
            return Err("a statement on every order needs masses that turn with the crank, or none");
        }
        let is_alike = self.cylinders.iter().all(|cylinder| cylinder.speed == 1);
        demand(is_alike, "a statement on every order needs crankshafts that turn equally fast")
    }

    pub(super) fn has_equal_centric_rods(&self) -> bool {
        let are_equal = self.cylinders.windows(2).all(|pair| pair[0].rod == pair[1].rod);
        are_equal && self.cylinders.iter().all(|cylinder| cylinder.rod.is_centric()) && self.rods().is_ok()
    }
}
