//! How large is each order of a family over two open angles? A map of both for each order of force and moment.

use super::picture::{axis_name, unit};
use super::sizes::Sizes;
use crate::engine::{DELTA, Family, PHI};
use crate::family::OpenOrder;
use crate::page::Picture;
use crate::page::plot::{Axis, Map};
use crate::proof::Planar;
use crate::report::texts::family as text;

/// Degrees from one point of the grid to the next, φ from 0°, and δ to both sides of 0°.
const STEP: i32 = 5;
const PHIS: i32 = 180;
const DELTAS: i32 = 90;
/// More maps of a quantity than this are not drawn.
const MOST: usize = 2;

/// A map for each of the largest orders; none where not both angles are open.
pub(super) fn maps(family: &Family, orders: &[OpenOrder]) -> Vec<Picture> {
    let unknowns = family.unknowns();
    let highest = orders.iter().map(|order| order.order).max();
    let sizes = highest.filter(|_| unknowns.contains(PHI) && unknowns.contains(DELTA));
    let Some(sizes) = sizes.and_then(|highest| Sizes::new(family, highest)) else { return Vec::new() };
    let is_vee = family.has_open_banks() && family.has_open_splits();
    let mut maps = Vec::new();
    for quantity in Planar::BOTH {
        let Some(unit) = unit(family, Some(&sizes), quantity) else { continue };
        for (order, _) in sizes.told(quantity, orders).0.into_iter().take(MOST) {
            let name = quantity.name();
            maps.push(Picture::new(
                format!("map-{name}-{order}"),
                text::map(order, is_vee, sizes.circumstances()),
                map(family, &sizes, quantity, order, &unit).figure(),
            ));
        }
    }
    maps
}

fn map(family: &Family, sizes: &Sizes, quantity: Planar, order: u32, unit: &str) -> Map {
    let size = sizes.size(quantity, order);
    let grid = |from: i32, to: i32| (from..=to).step_by(STEP as usize);
    let turns = |degrees: i32| f64::from(degrees) / 360.0;
    let row = |delta: i32| grid(0, PHIS).map(|phi| size([turns(phi), turns(delta)])).collect();
    // Cells reach half a step beyond the outer values.
    let axis = |name: &str, from: i32, to: i32| {
        Axis::degrees(name, f64::from(from) - f64::from(STEP) / 2.0, f64::from(to) + f64::from(STEP) / 2.0)
    };
    let (heading, value) = match quantity {
        Planar::Force => (format!("Force, order {order}"), format!("Force in {unit}")),
        Planar::Moment => (format!("Moment, order {order}"), format!("Moment in {unit}")),
    };
    Map {
        title: heading,
        x: axis(axis_name(family, PHI), 0, PHIS),
        y: axis(axis_name(family, DELTA), -DELTAS, DELTAS),
        value: Axis::amplitude(value),
        rows: grid(-DELTAS, DELTAS).map(row).collect(),
        curves: Vec::new(),
        marks: Vec::new(),
    }
}
