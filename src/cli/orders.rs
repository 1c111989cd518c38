//! Which engine is a command about, and which of its orders?

use std::path::PathBuf;

use crankstar::engine::{CycleOrder, Family, HIGHEST_ORDER, ORDERS};
use crankstar::family::{self, OpenOrder};
use crankstar::file::Layout;
use crankstar::loads::{usual_bearing_orders, usual_orders};
use crankstar::report::rising;

use super::failure::Failure;
use super::layouts;

/// The engine and the orders that a command is about.
#[derive(clap::Args)]
pub struct EngineAndOrders {
    /// A name of the catalogue, or the path of a layout file
    pub layout: PathBuf,
    /// The orders to decide [default: those of the layout file, else 1,2,4,6 and other large ones]
    #[arg(long, value_delimiter = ',')]
    pub orders: Vec<CycleOrder>,
}

impl EngineAndOrders {
    /// The orders that were asked for.
    pub fn asked(&self) -> Result<Vec<u32>, Failure> {
        self.orders.iter().map(|&order| whole(order)).collect()
    }

    /// Whether orders were asked for.
    pub fn are_asked(&self) -> bool {
        !self.orders.is_empty()
    }

    /// What the layout describes, and the orders to examine, rising, each once.
    pub fn read(&self) -> Result<(Layout, Vec<u32>), Failure> {
        self.read_or(usual_orders)
    }

    /// The same for what the main bearings feel, which has orders of its own.
    pub fn read_for_bearings(&self) -> Result<(Layout, Vec<u32>), Failure> {
        self.read_or(usual_bearing_orders)
    }

    fn read_or(&self, usual: fn(&crankstar::engine::Engine) -> Vec<u32>) -> Result<(Layout, Vec<u32>), Failure> {
        let layout = layouts::read(&self.layout)?;
        let orders = match (self.orders.as_slice(), &layout) {
            ([], Layout::Known(engine, _)) => usual(engine),
            ([], Layout::Open(family)) => family.orders().to_vec(),
            (_, _) => self.asked()?,
        };
        Ok((layout, rising(orders)))
    }
}

/// An order of forces and moments; blanks may stand around it, as behind the comma of a list.
pub fn whole_order(text: &str) -> Result<u32, String> {
    let order = text.trim().parse().ok().filter(|order| ORDERS.contains(order));
    order.ok_or_else(|| format!("an order is a whole number from 1 to {HIGHEST_ORDER}"))
}

/// Half orders are those of the gas torque.
fn whole(order: CycleOrder) -> Result<u32, Failure> {
    match order.is_whole() {
        true => Ok(order.halves() / 2),
        false => Err(Failure::misuse(format!(
            "order {order} is one of the gas torque, which `classify --firing` and `firing` decide; forces and moments have whole orders"
        ))),
    }
}

/// The family of an engine whose file gives values to symbols, judged at these orders.
pub fn classified<'a>(
    family: Option<&'a Family>,
    orders: &[u32],
) -> Result<Option<(&'a Family, Vec<OpenOrder>)>, Failure> {
    // Where the rods differ nothing is said of other values than those given.
    let family = family.filter(|family| family::comparable(family).is_ok());
    let judged = family.map(|family| Ok((family, family::classify(family, orders).map_err(Failure::new)?)));
    judged.transpose()
}
