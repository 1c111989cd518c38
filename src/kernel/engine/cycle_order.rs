//! Which orders does the torque of the gas have? Half orders and whole ones in a four-stroke engine, whole ones in a two-stroke.

use std::fmt;
use std::str::FromStr;

use num_rational::BigRational;

use super::cycle::Cycle;
use super::order::HIGHEST_ORDER;
use crate::exact::Turn;

/// An order κ of what repeats once per working cycle, in multiples of the crank speed: ½, 1, 1½, …
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::engine::CycleOrder;
/// let order: CycleOrder = "3/2".parse().unwrap();
/// assert_eq!(order.to_string(), "1½");
/// assert_eq!("1.5".parse(), Ok(order));
/// assert_eq!(" 3/2".parse(), Ok(order));
/// assert!("1.25".parse::<CycleOrder>().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CycleOrder {
    halves: u32,
}

impl CycleOrder {
    /// So many halves: 3 is the order 1½. None for what is no order, 0 and what is higher than [`HIGHEST_ORDER`].
    pub fn of_halves(halves: u32) -> Option<Self> {
        (1..=2 * HIGHEST_ORDER).contains(&halves).then_some(CycleOrder { halves })
    }

    /// How many halves it is.
    pub fn halves(self) -> u32 {
        self.halves
    }

    /// Whether it is a whole number.
    pub fn is_whole(self) -> bool {
        self.halves.is_multiple_of(2)
    }

    /// The number itself.
    pub fn exact(self) -> BigRational {
        BigRational::new(self.halves.into(), 2.into())
    }

    /// Whether what repeats once per cycle has this order: every one in a four-stroke engine, whole ones in a two-stroke.
    pub fn exists_in(self, cycle: Cycle) -> bool {
        self.halves.is_multiple_of(cycle.lowest_order().halves)
    }

    /// Where the vector of a cylinder that fires at a crank angle of the cycle, in turns, is in the firing star: `−κφ`.
    pub fn phase(self, fires: &BigRational) -> Turn {
        -&self.times(fires)
    }

    /// `κ` times a crank angle of the cycle, in turns.
    pub fn times(self, angle: &BigRational) -> Turn {
        Turn::new(self.exact() * angle)
    }
}

impl Cycle {
    /// The order of what happens once per cycle: ½ in a four-stroke engine, 1 in a two-stroke.
    pub fn lowest_order(self) -> CycleOrder {
        CycleOrder {
            halves: match self {
                Cycle::TwoStroke => 2,
                Cycle::FourStroke => 1,
            },
        }
    }
}

impl fmt::Display for CycleOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.halves / 2, self.is_whole()) {
            (whole, true) => write!(f, "{whole}"),
            (0, false) => f.write_str("½"),
            (whole, false) => write!(f, "{whole}½"),
        }
    }
}

/// A text that is no order of a cycle.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{}` is not an order; an order is a whole number from 1 to {HIGHEST_ORDER}, or of the gas torque a multiple of 1/2, such as 1/2 or 1.5",
    crate::text::harmless(.0)
)]
pub struct NotACycleOrder(String);

impl FromStr for CycleOrder {
    type Err = NotACycleOrder;

    fn from_str(text: &str) -> Result<Self, NotACycleOrder> {
        let refused = || NotACycleOrder(text.to_owned());
        let text = text.trim();
        let halves = match text.strip_suffix('½').or_else(|| text.strip_suffix(".5")) {
            Some("") => Some(1),
            Some(whole) => whole_number(whole).and_then(|whole| whole.checked_mul(2)?.checked_add(1)),
            None => match text.strip_suffix("/2") {
                Some(halves) => whole_number(halves),
                None => whole_number(text.strip_suffix(".0").unwrap_or(text)).and_then(|whole| whole.checked_mul(2)),
            },
        };
        halves.and_then(CycleOrder::of_halves).ok_or_else(refused)
    }
}

/// A number of digits alone: no sign, no space.
fn whole_number(text: &str) -> Option<u32> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}
