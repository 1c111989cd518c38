//! What does a layout of the page describe, with its verdicts?

use super::mistake::Mistake;
use crate::engine::{Engine, Family};
use crate::family::OpenOrder;
use crate::file::Layout;
use crate::report::rising;
use crate::verdict::{self, Judgement};
use crate::{family, loads};

/// What a layout describes, with its verdicts.
pub(super) enum Judged {
    /// An engine, and the family that it is a member of, judged at the same orders.
    Known { engine: Box<Engine>, judged: Judgement, family: Option<(Box<Family>, Vec<OpenOrder>)> },
    /// A family.
    Open { family: Box<Family>, orders: Vec<OpenOrder> },
}

impl Judged {
    /// As the commands judge it where nothing else is asked for.
    pub fn of(layout: Layout) -> Result<Self, Mistake> {
        match layout {
            Layout::Known(engine, family) => {
                let orders = rising(loads::usual_orders(&engine));
                let quantities = verdict::quantities(&engine, false);
                let judged = Judgement::new(&engine, &orders, &quantities).map_err(Mistake::of)?;
                // Where the rods differ nothing is said of other values than those given.
                let family = family.filter(|family| family::comparable(family).is_ok());
                let open = |family: Box<Family>| {
                    let orders = family::classify(&family, &orders).map_err(Mistake::of)?;
                    Ok::<_, Mistake>((family, orders))
                };
                Ok(Judged::Known { engine, judged, family: family.map(open).transpose()? })
            }
            Layout::Open(family) => {
                family::comparable(&family).map_err(Mistake::of)?;
                let orders = rising(family.orders().iter().copied());
                let orders = family::classify(&family, &orders).map_err(Mistake::of)?;
                Ok(Judged::Open { family, orders })
            }
        }
    }
}
