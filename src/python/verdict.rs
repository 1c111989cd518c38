//! What is left of one quantity of an order, as an object of Python?

use std::hash::{DefaultHasher, Hash, Hasher};

use pyo3::prelude::*;
use pyo3::types::PyTuple;
use serde::{Deserialize, Serialize};

use super::again::{Reduced, maker};
use super::error::told;
use super::star::Star;
use crate::page::Text;
use crate::page::number::Amount;
use crate::proof::{Axial, Planar, Quantity, Shape};
use crate::report;
use crate::verdict::{OrderBalance, OrderVerdict, Outcome, TorqueVerdict, WholeOrder, both_vanish};

/// What is left of one quantity of one order: of all sums together, or, in `parts`, of one of several.
#[pyclass(frozen, get_all, module = "crankstar")]
#[derive(Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Verdict {
    /// "force", "moment", "torque" or "roll".
    pub(super) quantity: String,
    /// The order k: this many swings a revolution.
    pub(super) order: u32,
    /// Whether some mass of the engine has the order; else nothing of it is there whatever its stars are.
    exists: bool,
    /// True: proved zero; False: proved not zero; None: not decided, or it depends on rods of which nothing is known.
    vanishes: Option<bool>,
    /// "balanced", "rotating", "counter-rotating", "planar", "elliptical" or "not decided"; None for a torque and the roll moment.
    shape: Option<String>,
    /// The largest value of a revolution in closed form, `0` or `4√2`; None where none is known. Forces in m r ω² c_k, moments in that
    /// times the unit of the positions, torques in m r² ω² t_k.
    exact: Option<String>,
    /// The same in decimals, exactly 0.0 where it vanishes; None where several sums make it up, and it is not zero.
    #[serde(with = "super::bits")]
    value: Option<f64>,
    /// Whether a moment is a couple, the same about every plane: the force of its order vanishes. None for other quantities.
    is_couple: Option<bool>,
    /// Which masses it is about, where the order has several sums and this is one of them.
    of: Option<String>,
    /// As the command line shows it: `couple √10 ≈ 3.162, rotating`.
    text: String,
    /// The two vector stars, direct and reverse; one for a torque; none where several sums make it up.
    stars: Vec<Star>,
    /// The sums that make it up, where there are several.
    parts: Vec<Verdict>,
    /// The same text in TeX.
    pub(super) tex: String,
}

#[pymethods]
impl Verdict {
    fn __repr__(&self) -> String {
        let of = self.of.as_ref().map_or_else(String::new, |of| format!(" ({of})"));
        format!("<Verdict: {} of order {}{of}: {}>", self.quantity, self.order, self.text)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Verdict>().is_ok_and(|other| other.get() == self)
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        (&self.quantity, self.order, &self.of, &self.text).hash(&mut hasher);
        hasher.finish()
    }

    fn __copy__(itself: Py<Self>) -> Py<Self> {
        itself
    }

    fn __deepcopy__(itself: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        itself
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let state = serde_json::to_string(self).map_err(told)?;
        Ok((maker(py, "_verdict")?, PyTuple::new(py, [state])?))
    }
}

/// Makes the verdict of a pickle.
#[pyfunction]
pub(super) fn _verdict(state: &str) -> PyResult<Verdict> {
    serde_json::from_str(state).map_err(told)
}

/// The verdicts on one order: force, moment, and torque and roll moment where they were asked for.
pub(super) fn of_order(order: &OrderVerdict) -> Vec<Verdict> {
    let [force, moment] = report::force_and_moment_left(order);
    let one = |quantity, text| whole(order, quantity, text);
    let about_the_axis = [Axial::Torque, Axial::Roll].into_iter();
    let about_the_axis =
        about_the_axis.filter_map(|quantity| Some(of_torque(order, quantity, order.about_the_axis(quantity)?)));
    [one(Planar::Force, force), one(Planar::Moment, moment)].into_iter().chain(about_the_axis).collect()
}

impl Verdict {
    fn new(quantity: impl Into<Quantity>, order: u32, exists: bool, text: &Text) -> Self {
        Verdict {
            quantity: quantity.into().name().to_owned(),
            order,
            exists,
            vanishes: Some(true),
            shape: None,
            exact: None,
            value: None,
            is_couple: None,
            of: None,
            text: text.plain(),
            stars: Vec::new(),
            parts: Vec::new(),
            tex: super::notebook::tex(text),
        }
    }

    /// With the largest value, where it is known; nothing is there of an order that does not exist.
    fn sized(self, vanishes: Option<bool>, size: Option<Amount>) -> Self {
        let (vanishes, size) = if self.exists { (vanishes, size) } else { (Some(true), Some(Amount::zero())) };
        let value = size.as_ref().map(|size| size.decimal);
        Verdict { vanishes, exact: size.and_then(|size| Some(size.exact?.to_string())), value, ..self }
    }
}

/// The force or the moment of an order.
fn whole(order: &OrderVerdict, quantity: Planar, text: Text) -> Verdict {
    let is_couple = (quantity == Planar::Moment).then(|| order.moment_is_couple());
    match order.parts.as_slice() {
        [only] => Verdict { is_couple, ..part(only, quantity, &text) },
        several => {
            let whole = order.whole(quantity);
            let vanishes = is_zero(whole);
            let verdict = Verdict::new(quantity, order.order, order.exists(), &text)
                .sized(vanishes, (vanishes == Some(true)).then(Amount::zero));
            let parts = several.iter().map(|balance| {
                let text = match quantity {
                    Planar::Force => report::force_left(balance),
                    Planar::Moment => report::moment_left(balance),
                };
                Verdict { of: balance.class.as_ref().map(report::class_sources), ..part(balance, quantity, &text) }
            });
            Verdict {
                is_couple,
                shape: Some(report::shape_name(whole.shape).to_owned()),
                parts: parts.collect(),
                ..verdict
            }
        }
    }
}

fn part(order: &OrderBalance, quantity: Planar, text: &Text) -> Verdict {
    let balance = order.balance(quantity);
    let verdict = Verdict::new(quantity, order.order, order.exists, text);
    let shape = if order.exists { balance.shape } else { Shape::DoesNotExist };
    Verdict {
        shape: Some(report::shape_name(shape).to_owned()),
        is_couple: (quantity == Planar::Moment).then(|| order.moment_is_couple()),
        stars: balance.verdicts().map(Star::new).into(),
        ..verdict.sized(Some(balance.is_balanced()), Some(report::largest_length(balance)))
    }
}

/// Zero where both vectors are, not zero where one is not.
fn is_zero(whole: &WholeOrder) -> Option<bool> {
    let [direct, reverse] = whole.outcomes.each_ref().map(Outcome::vanishes);
    both_vanish(direct, reverse)
}

/// The inertia torque, or the roll moment.
fn of_torque(order: &OrderVerdict, quantity: Axial, torque: &TorqueVerdict) -> Verdict {
    let text = match quantity {
        Axial::Torque => report::torque_left(torque),
        Axial::Roll => report::roll_left(torque),
    };
    let verdict = Verdict::new(Quantity::Axial(quantity), order.order, torque.exists(), &text);
    match torque.parts.as_slice() {
        [only] => Verdict {
            stars: vec![Star::new(&only.verdict)],
            ..verdict.sized(torque.outcome.vanishes(), Some(report::star_length(&only.verdict)))
        },
        several => {
            let parts = several.iter().map(|part| {
                let text = report::torque_part_left(part);
                Verdict {
                    of: part.class.as_ref().map(report::class_sources),
                    stars: vec![Star::new(&part.verdict)],
                    ..Verdict::new(Quantity::Axial(quantity), order.order, part.exists, &text)
                        .sized(Some(part.verdict.vanishes()), Some(report::star_length(&part.verdict)))
                }
            });
            let vanishes = torque.outcome.vanishes();
            Verdict { parts: parts.collect(), ..verdict.sized(vanishes, (vanishes == Some(true)).then(Amount::zero)) }
        }
    }
}
