//! What do knuckle pins, master rods and their pistons feel, as a person reads it? Tables, polar diagrams, columns.

use super::super::calculation::Unit;
use super::super::plot::{Curve, PointMark, Polar};
use super::super::torque::names;
use super::amounts;
use super::columns::peak;
use super::plots::{largest_at, tip};
use crate::engine::Engine;
use crate::loads::{self, Circle, KnuckleLoad, LinkLoads, MasterLoad, Waveform, link_loads};
use crate::page::{self, Block, Picture, Text, phrase};
use crate::report::calculation::data::Units;
use crate::report::data::Filling;
use crate::report::texts::bearings as text;
use crate::table::Table;
use crate::text::Untrusted;

/// Steps of a revolution: half a degree each.
const STEPS: usize = 720;
/// Of more links on a master rod those of one side are drawn, as many as these.
const MOST_LINKS: usize = 4;

/// Tables and drawings; none where no rod is a link.
pub(in crate::report) fn blocks(engine: &Engine) -> Vec<Block> {
    let Some(links) = link_loads(engine) else { return Vec::new() };
    let unit = Unit::of_force(loads::scale(engine).as_ref());
    vec![
        masters(engine, &links, unit).into(),
        knuckles(engine, &links, unit).into(),
        Block::Pictures(links.masters.iter().flat_map(|master| drawn(engine, &links, master, unit)).collect()),
    ]
}

/// What stands first of the master rods.
pub(in crate::report) fn answer(engine: &Engine) -> Option<Text> {
    let links = link_loads(engine)?;
    let unit = Unit::of_force(loads::scale(engine).as_ref());
    let most = |one: &&MasterLoad, other: &&MasterLoad| one.crankpin.value.total_cmp(&other.crankpin.value);
    let master = links.masters.iter().max_by(most)?;
    let knuckle = links.knuckles.iter().max_by(|one, other| one.peak.value.total_cmp(&other.peak.value))?;
    Some(text::articulated(
        names(engine, &[master.cylinder]),
        amounts::size(&master.crankpin, unit),
        unit.label(),
        names(engine, &[knuckle.cylinder]),
        amounts::size(&knuckle.peak, unit),
        amounts::size(&master.side, unit),
        amounts::size(&master.own_side, unit),
    ))
}

fn masters(engine: &Engine, links: &LinkLoads, unit: Unit) -> page::Table {
    page::Table::of(&links.masters)
        .column("Master rod", |master| names(engine, &[master.cylinder]))
        .column("Links of cylinders", |master| names(engine, &master.links))
        .column(phrase!("Load of the crankpin in {}", unit.label()), |master| amounts::size(&master.crankpin, unit))
        .column("at θ", |master| amounts::angle(&master.crankpin, unit))
        .column(phrase!("Side force in {}", unit.label()), |master| amounts::size(&master.side, unit))
        .column("at θ", |master| amounts::angle(&master.side, unit))
        .column(phrase!("Without links in {}", unit.label()), |master| amounts::size(&master.own_side, unit))
        .done()
}

fn knuckles(engine: &Engine, links: &LinkLoads, unit: Unit) -> page::Table {
    page::Table::of(&links.knuckles)
        .column("Link of cylinder", |knuckle| names(engine, &[knuckle.cylinder]))
        .column("Master rod", |knuckle| names(engine, &[knuckle.master]))
        .column(phrase!("Load of the knuckle pin in {}", unit.label()), |knuckle| amounts::size(&knuckle.peak, unit))
        .column("at θ", |knuckle| amounts::angle(&knuckle.peak, unit))
        .column(phrase!("Side force on the master's piston in {}", unit.label()), |knuckle| {
            amounts::size(&knuckle.side, unit)
        })
        .column("at θ", |knuckle| amounts::angle(&knuckle.side, unit))
        .done()
}

/// The path of a load, and its tip where it is largest.
fn path(load: &Waveform, unit: Unit) -> (Vec<(f64, f64)>, PointMark) {
    let forces = load.sample(&Circle::new(STEPS)).into_iter();
    let mut tips: Vec<(f64, f64)> = forces.map(|force| tip(force * unit.factor)).collect();
    tips.extend(tips.first().copied());
    let peak = load.peak();
    (tips, largest_at(tip(peak.vector * unit.factor), peak.angle.unwrap_or_default()))
}

fn drawn(engine: &Engine, links: &LinkLoads, master: &MasterLoad, unit: Unit) -> [Picture; 2] {
    let called = &engine.cylinders()[master.cylinder].name;
    let (tips, largest) = path(&master.on_the_crank, unit);
    let mut pin = Polar::new(
        format!("Crankpin of master rod {called}"),
        "Force in {}; 0° is outward along the throw",
        vec![Curve::new(0, "", tips.clone())],
    )
    .counted_in(unit.unit);
    pin.mark_quarters(&tips, STEPS);
    pin.marks.push(largest);
    let own = links.knuckles.iter().filter(|knuckle| knuckle.master == master.cylinder).take(MOST_LINKS);
    let curve = |(place, knuckle): (usize, &KnuckleLoad)| {
        let (tips, _) = path(&knuckle.on_the_rod, unit);
        Curve::new(place, format!("link {}", engine.cylinders()[knuckle.cylinder].name), tips)
    };
    let pins = Polar::new(
        format!("Knuckle pins of master rod {called}"),
        "Force in {}; 0° is away from the crankpin",
        own.enumerate().map(curve).collect(),
    )
    .counted_in(unit.unit);
    [
        Picture::new(
            format!("master-{}-crankpin", master.cylinder + 1),
            text::crankpin(names(engine, &[master.cylinder])),
            pin.figure(),
        ),
        Picture::new(
            format!("master-{}-knuckles", master.cylinder + 1),
            text::knuckle_pins(names(engine, &[master.cylinder]), MOST_LINKS),
            pins.figure(),
        ),
    ]
}

/// The tables `knuckles` and `masters`.
pub(super) fn table(engine: &Engine, units: Units, called: &str) -> Option<Table> {
    let links = link_loads(engine)?;
    let person = |index: usize| Some(Untrusted::new(&*engine.cylinders()[index].name));
    let load = ["force_zero_to_peak_{unit}", "theta_{unit}"];
    let side = ["side_zero_to_peak_{unit}", "side_theta_{unit}"];
    Some(match called {
        "knuckles" => {
            let mut table = Filling::new("bearings.knuckles", &links.knuckles);
            table.person("cylinder", |knuckle| person(knuckle.cylinder));
            table.person("master", |knuckle| person(knuckle.master));
            peak(&mut table, load, units, |knuckle| &knuckle.peak);
            peak(&mut table, side, units, |knuckle| &knuckle.side);
            table.done()
        }
        _ => {
            let mut table = Filling::new("bearings.masters", &links.masters);
            table.person("cylinder", |master| person(master.cylinder));
            table.whole("links", |master| master.links.len());
            peak(&mut table, load, units, |master| &master.crankpin);
            peak(&mut table, side, units, |master| &master.side);
            peak(&mut table, ["own_side_zero_to_peak_{unit}", "own_side_theta_{unit}"], units, |master| {
                &master.own_side
            });
            table.done()
        }
    })
}
