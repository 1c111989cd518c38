//! What is known of an engine of the atlas? Its verdicts at orders 1 to 8, the first order that is left, the remedy.

use super::super::typeset::Amount;
use super::super::{engine_cells, residual, typeset};
use crate::engine::{BuildError, Cycle, Engine, LengthUnit};
use crate::order::Masses;
use crate::page::Text;
use crate::proof::{Quantity, Shape};
use crate::remedy::{self, Request};
use crate::search::{Best, FoundStar};
use crate::text::Untrusted;
use crate::verdict::{self, Balance, OrderBalance, OrderVerdict, WholeOrder};

/// Where an engine comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// The catalogue.
    Catalogue,
    /// The search of in-line stars.
    Found(Cycle),
}

/// The orders of the atlas.
const ORDERS: [u32; 8] = [1, 2, 3, 4, 5, 6, 7, 8];

/// The orders that the remedies are for.
pub(super) const REMEDIED: [u32; 2] = [1, 2];

/// One engine, judged.
pub(super) struct EngineRow {
    pub origin: Origin,
    /// Name in the catalogue, or number of cylinders.
    pub name: String,
    /// Where its report is, as a link from the page, if the reader says so.
    pub report: Option<String>,
    /// Title in the catalogue, or throws.
    pub title: Untrusted,
    /// `even, 180°`.
    pub firing: Text,
    /// Cylinders in the order in which they fire, where it is known.
    pub firing_order: String,
    /// How many stars are as good.
    pub ties: Option<Ties>,
    /// What is left at [`ORDERS`].
    pub orders: Vec<Order>,
    pub first_left: [Text; 2],
    pub remedy: Text,
    /// What positions are counted in.
    pub unit: LengthUnit,
}

/// Force and moment of one order.
pub(super) struct Order {
    pub order: u32,
    pub force: Remaining,
    pub moment: Remaining,
}

/// What is left of a force or a moment.
pub(super) struct Remaining {
    pub shape: Shape,
    /// The largest value through a revolution; none of an order that several sums make up, before different numbers.
    pub largest: Option<Amount>,
}

impl Remaining {
    fn new(judged: &OrderVerdict, whole: &WholeOrder, balance: fn(&OrderBalance) -> &Balance) -> Self {
        let largest = match judged.parts.as_slice() {
            [only] => Some(residual::largest(balance(only))),
            _ => None,
        };
        Remaining { shape: whole.shape, largest }
    }
}

/// Stars of equal moments.
pub(super) struct Ties {
    /// Those of these values, of this many.
    pub stars: u64,
    pub all: String,
    /// Where several classes leave no moment of orders 1 and 2: how many.
    pub tied: Option<u64>,
}

impl EngineRow {
    /// An engine of the catalogue.
    pub fn known(name: &str, layout: &Engine) -> Self {
        let title = layout.title().clone();
        EngineRow::judged(layout, Origin::Catalogue, name.to_owned(), title, None)
    }

    /// A star that was found.
    pub fn found(best: &Best, star: &FoundStar) -> Result<Self, BuildError> {
        let layout = star.engine(&best.problem)?;
        let ties = star.stars.map(|stars| Ties { stars, all: best.all.to_string(), tied: best.tied });
        let (name, title) = (best.problem.cylinders.to_string(), Untrusted::new(throws(&layout)));
        Ok(EngineRow::judged(&layout, Origin::Found(best.problem.cycle), name, title, ties))
    }

    fn judged(layout: &Engine, origin: Origin, name: String, title: Untrusted, ties: Option<Ties>) -> Self {
        let request = Request { orders: REMEDIED.to_vec(), ..Request::default() };
        EngineRow {
            origin,
            name,
            report: None,
            title,
            ties,
            firing: engine_cells::firing(layout.firing()),
            firing_order: layout.firing_order().unwrap_or_default(),
            orders: verdict::classify(layout, &ORDERS, Masses::Reciprocating, &Quantity::PLANAR)
                .unwrap_or_else(|number| unreachable!("the atlas asks for orders: {number}"))
                .iter()
                .map(|judged| Order {
                    order: judged.order,
                    force: Remaining::new(judged, &judged.force, |part| &part.force),
                    moment: Remaining::new(judged, &judged.moment, |part| &part.moment),
                })
                .collect(),
            first_left: engine_cells::first_left(layout, &verdict::every_order(layout, Masses::Reciprocating), &[]),
            remedy: engine_cells::remedy(&remedy::remedy(layout, &request)),
            unit: layout.length_unit(),
        }
    }
}

/// `0, 90, 270, 180°`; in multiples of `(360/7)°` where degrees do not end.
fn throws(layout: &Engine) -> String {
    let count = num_rational::BigRational::from_integer(layout.cylinders().len().into());
    let angles = layout.cylinders().iter().map(|cylinder| cylinder.throw.degrees());
    let degrees: Vec<String> = angles.map(|angle| typeset::number(&angle)).collect();
    if degrees.iter().all(|text| !text.contains(['/', '≈'])) {
        return format!("throws {}°", degrees.join(", "));
    }
    let steps = layout.cylinders().iter().map(|cylinder| typeset::number(&(cylinder.throw.turns() * &count)));
    let unit = typeset::turns(&count.recip());
    format!("throws {} times {unit}", typeset::listed(steps))
}
