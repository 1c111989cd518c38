//! Where are pins and pistons at θ = 0, seen from the free end? To scale, in millimetres around the shaft.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::super::figure::Point;
use super::super::star::towards;
use super::super::typeset;
use crate::engine::{AxisLeftOut, Cylinder, Engine, Form, GearedCrank, Link, Mechanism};
use crate::exact::Turn;
use crate::page::{Unit, Units};
use crate::proof::Sense;

/// The rod ratio that is drawn where the engine has none.
pub(super) const USUAL_RATIO: f64 = 1.0 / 3.5;
/// Between the axes of opposed pistons where the file gives no distance, in crank radii.
const USUAL_DISTANCE: f64 = 11.0;
/// Longer rods, against their crank radius, are drawn so long.
const LONGEST_ROD: f64 = 6.0;
/// From the shaft to the farthest piston pin, in millimetres.
const REACH: f64 = 41.0;

/// The piston, from its pin: down and up; and how far the cylinder reaches over the piston at top dead centre.
pub(super) const SKIRT: f64 = 1.7;

pub(super) const CROWN: f64 = 2.6;

pub(super) const HEAD: f64 = 1.2;

/// A piston with its rod and its crankpin; cylinders that coincide in this view are one.
pub(super) struct Linkage<'a> {
    pub names: Vec<&'a str>,
    pub bank: &'a Turn,
    /// Direction of the cylinder axis, and the one 90° ahead of it.
    pub along: Point,
    pub across: Point,
    /// Where the crankpin stands.
    pub pin: Point,
    /// Where the rod begins: at the crankpin, or that of a link at its knuckle pin on the master rod.
    pub joint: Point,
    /// Where the piston pin stands.
    pub piston: Point,
    /// The point of the cylinder axis that is nearest to the shaft.
    pub foot: Point,
    /// Heights of the piston pin over the foot at both dead centres.
    pub stroke: (f64, f64),
    /// Of a radial with several rows: which, from the free end.
    pub row: usize,
    /// How far the axis passes the shaft, in millimetres or inches where the engine gives lengths, else against the rod length; none
    /// where it meets the shaft.
    pub dimension: Option<String>,
    /// Which of several crankshafts: all points are seen from its axis.
    pub crank: usize,
}

/// All linkages, and where the axes of the crankshafts stand.
pub(super) struct Linkages<'a> {
    pub all: Vec<Linkage<'a>>,
    /// One in the middle where there is one crankshaft.
    pub axes: Vec<Point>,
}

impl Linkage<'_> {
    /// Height of the piston pin over the foot of its axis.
    pub fn height(&self) -> f64 {
        ((self.piston - self.foot) * self.along.conj()).re
    }
}

/// The rod of a cylinder for its crank radius: its length and the offset of the axis, both against the crank radius.
fn rod(cylinder: &Cylinder) -> (f64, f64) {
    let Some(rod) = cylinder.rod() else { return (1.0 / USUAL_RATIO, 0.0) };
    let length = drawn(&rod.ratio);
    (length, rod.offset.to_f64().unwrap_or(0.0) * length)
}

/// `e = 12.5 mm`, `e/l = 0.08`; its sign says on which side.
fn dimension(engine: &Engine, cylinder: &Cylinder, units: Units) -> Option<String> {
    let rod = cylinder.rod().filter(|rod| !rod.offset.is_zero())?;
    let thousand = BigRational::from_integer(1000.into());
    Some(match engine.dimensions().crank_radius.as_ref().filter(|_| !rod.ratio.is_zero()) {
        Some(unit) => {
            let offset = &rod.offset * unit * &cylinder.crank_radius / &rod.ratio * thousand;
            let (offset, unit) = units.of_exact(&offset, Unit::MILLIMETRE);
            let offset = match units {
                Units::Si => typeset::short(&offset),
                Units::Inch => typeset::in_decimals(&offset),
            };
            format!("e {} {}", equals(&offset), unit.name)
        }
        None => format!("e/l {}", equals(&typeset::short(&rod.offset))),
    })
}

/// `= 12.5`; what is rounded has its own sign.
fn equals(number: &str) -> String {
    if number.starts_with('≈') { number.to_owned() } else { format!("= {number}") }
}

/// From the crankpin to the piston pin where both are on the axis, against the crank radius.
fn reach(cylinder: &Cylinder) -> f64 {
    match cylinder.link() {
        None => rod(cylinder).0,
        Some(link) => length(&link.knuckle) * drawn(&link.master) + drawn(&link.ratio),
    }
}

/// The length of a rod of this ratio against the crank radius, as it is drawn.
fn drawn(ratio: &BigRational) -> f64 {
    ratio.to_f64().unwrap_or(USUAL_RATIO).recip().clamp(1.0, LONGEST_ROD)
}

/// Where the knuckle pin of a link stands, the master rod as it lies.
fn knuckle_pin(link: &Link, along: Point, pin: Point, radius: f64) -> Point {
    let turned = |angle: &Turn| Point::from_polar(1.0, length(angle.turns()) * std::f64::consts::TAU);
    let (master, rod) = (along * turned(&link.angle).conj(), drawn(&link.master) * radius);
    let aside = (pin * master.conj()).im;
    let towards_its_piston = master * Point::new(leg(rod, aside), -aside) / rod;
    pin + towards_its_piston * turned(&link.knuckle_angle()) * (length(&link.knuckle) * rod)
}

/// The other leg of a right triangle.
fn leg(hypotenuse: f64, aside: f64) -> f64 {
    (hypotenuse * hypotenuse - aside * aside).max(0.0).sqrt()
}

/// Whether some rod is too long to be drawn.
pub(super) fn is_shortened(engine: &Engine) -> bool {
    engine.rods().any(|rod| rod.ratio.to_f64().is_none_or(|ratio| ratio * LONGEST_ROD < 1.0))
}

/// The rows of a radial, from the free end; of other engines none.
pub(super) fn rows(engine: &Engine) -> Vec<&BigRational> {
    let positions: BTreeSet<&BigRational> = engine.cylinders().iter().map(|cylinder| &cylinder.position).collect();
    let has_rows = engine.form() == Form::Radial && positions.len() > 1;
    if has_rows { positions.into_iter().rev().collect() } else { Vec::new() }
}

/// What distinguishes a linkage in this view.
type Outline<'a> = ([usize; 2], &'a Turn, &'a Turn, &'a BigRational, &'a Option<Mechanism>);

/// All linkages: by crankshafts and rows, then banks, then throws; lengths beside them in these units.
pub(super) fn linkages(engine: &Engine, units: Units) -> Linkages<'_> {
    let rows = rows(engine);
    let mut seen: BTreeMap<Outline, Vec<&Cylinder>> = BTreeMap::new();
    for cylinder in engine.cylinders() {
        let row = rows.iter().position(|row| **row == cylinder.position).unwrap_or(0);
        let key = ([cylinder.crank, row], &cylinder.bank, &cylinder.throw, &cylinder.crank_radius, &cylinder.mechanism);
        seen.entry(key).or_default().push(cylinder);
    }
    let radius = |cylinder: &Cylinder| cylinder.crank_radius.to_f64().unwrap_or(1.0).abs();
    let reaches = seen.values().map(|cylinders| radius(cylinders[0]) * (1.0 + reach(cylinders[0])));
    let farthest = reaches.fold(0.0, f64::max);
    let scale = if farthest > 0.0 { REACH / farthest } else { 1.0 };
    let placed = seen.into_iter().map(|(([crank, row], bank, ..), cylinders)| {
        let radius = radius(cylinders[0]) * scale;
        let (length, offset) = rod(cylinders[0]);
        let side = match engine.sense_of(cylinders[0]) {
            Sense::Direct => 1.0,
            // The rod is that of the equivalent crank, which lies on the other side.
            Sense::Reverse => -1.0,
        };
        let (length, offset) = (length * radius, offset * radius * side);
        let (along, pin) = (towards(bank), towards(&engine.pin_angle(cylinders[0])) * radius);
        let across = along * Point::i();
        let (joint, length, reach) = match cylinders[0].link() {
            None => (pin, length, length),
            Some(link) => {
                (knuckle_pin(link, along, pin, radius), drawn(&link.ratio) * radius, reach(cylinders[0]) * radius)
            }
        };
        // The joint in the frame of the cylinder: along its axis, and across it on the side of ψ = 90°.
        let turned = joint * along.conj();
        let height = turned.re + leg(length, turned.im - offset);
        let foot = across * offset;
        Linkage {
            names: cylinders.iter().map(|cylinder| cylinder.name.as_str()).collect(),
            bank,
            along,
            across,
            pin,
            joint,
            piston: foot + along * height,
            foot,
            stroke: (leg(reach - radius, offset), leg(reach + radius, offset)),
            row,
            dimension: dimension(engine, cylinders[0], units),
            crank,
        }
    });
    Linkages { all: placed.collect(), axes: axes(engine).into_iter().map(|axis| axis * scale).collect() }
}

/// Where the axes of the crankshafts are drawn, in crank radii: one in the middle where there is one.
pub(in crate::report) fn axes(engine: &Engine) -> Vec<Point> {
    let axis = |crank: &GearedCrank| match &crank.left_out {
        Some(AxisLeftOut::Distance(term)) => towards(&term.angle) * length(&term.weight) * USUAL_DISTANCE,
        Some(AxisLeftOut::Place) | None => {
            crank.axis.iter().map(|term| towards(&term.angle) * length(&term.weight)).sum()
        }
    };
    let axes: Vec<Point> = engine.geared_cranks().iter().map(axis).collect();
    if axes.is_empty() { vec![Point::default()] } else { axes }
}

fn length(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(0.0)
}
