//! What is left of each order, and of each of its sums, for documents and tables?

use serde::{Serialize, Serializer};

use super::residual;
use super::typeset::Amount;
use crate::proof::{Planar, Shape};
use crate::verdict::{OrderBalance, OrderVerdict};

/// An order of an engine as it is judged.
#[derive(Clone, Debug, Serialize)]
pub(super) struct RemainingOrder {
    pub order: u32,
    /// Whether some mass has the order: centric cranks have order 1 and the even ones.
    #[serde(skip)]
    pub exists: bool,
    pub force: Remaining,
    pub moment: Remaining,
    #[serde(skip)]
    pub moment_is_couple: bool,
    /// Whose sum it is, of a part.
    #[serde(skip)]
    pub of: Option<String>,
    /// Its sums, where what they are multiplied by differs.
    #[serde(skip)]
    pub parts: Vec<RemainingOrder>,
}

/// What is left of a force or a moment.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Remaining {
    #[serde(skip)]
    pub shape: Shape,
    /// The largest value through a revolution in m r ω² c_k, moments times the unit of the positions; none of several sums that are not zero together.
    #[serde(serialize_with = "decimal")]
    pub largest: Option<Amount>,
}

fn decimal<S: Serializer>(largest: &Option<Amount>, serializer: S) -> Result<S::Ok, S::Error> {
    largest.as_ref().map(|largest| largest.decimal).serialize(serializer)
}

impl RemainingOrder {
    pub fn new(judged: &OrderVerdict) -> Self {
        let whole = |quantity: Planar| match judged.parts.as_slice() {
            [only] => Remaining::of_sum(only, quantity),
            _ if !judged.exists() => Remaining::of_none(),
            _ => {
                let whole = judged.whole(quantity);
                Remaining { shape: whole.shape, largest: whole.is_balanced().then(Amount::zero) }
            }
        };
        RemainingOrder {
            order: judged.order,
            exists: judged.exists(),
            force: whole(Planar::Force),
            moment: whole(Planar::Moment),
            moment_is_couple: judged.moment_is_couple(),
            of: None,
            parts: judged.parts.iter().filter_map(RemainingOrder::part).collect(),
        }
    }

    fn part(part: &OrderBalance) -> Option<Self> {
        Some(RemainingOrder {
            order: part.order,
            exists: part.exists,
            force: Remaining::of_sum(part, Planar::Force),
            moment: Remaining::of_sum(part, Planar::Moment),
            moment_is_couple: !part.exists || part.moment_is_couple(),
            of: Some(residual::class_sources(part.class.as_ref()?)),
            parts: Vec::new(),
        })
    }
}

impl Remaining {
    fn of_sum(sum: &OrderBalance, quantity: Planar) -> Self {
        let balance = sum.balance(quantity);
        match sum.exists {
            true => Remaining { shape: balance.shape, largest: Some(residual::largest(balance)) },
            false => Remaining::of_none(),
        }
    }

    /// Of an order that does not exist, whatever its sums are.
    fn of_none() -> Self {
        Remaining { shape: Shape::DoesNotExist, largest: Some(Amount::zero()) }
    }

    /// The largest value as a closed form.
    pub fn exact(&self) -> Option<String> {
        self.largest.as_ref()?.exact.as_ref().map(ToString::to_string)
    }
}
