//! What is on the page of the main bearings, and on the terminal, where the layout asks for the gas?

use super::super::bearings::{by_orders, parts_of_a_load};
use super::super::torque::{has_assumed, warning};
use super::{plots, tables, words};
use crate::engine::{Convention, Engine};
use crate::journal::{CycleBearings, CycleLoads};
use crate::loads::{BearingLoads, Missing};
use crate::page::{Block, Document, Picture, Table, Text, phrase};

const RODS: &str = "The gas puts a rod in compression, the inertia of the piston puts it in tension. The pull of the big end on its crankpin, towards the piston, includes the rotating part of the rod: the cap bolts carry it, less the inertia of the cap itself. The side force acts between piston and wall.";

const PINS: &str = "Load of each crankpin by the rod of each cylinder through the cycle: gas and inertia of the piston, with the side force, and the rotating part of the rod.";

const SHARED: &str = "Load of a crankpin by all its rods, at each crank angle the sum of their forces. The rods peak at different times, so that the pin carries less than the sum of their largest loads; the bearing of each rod carries its own. The mass of the pin itself adds nothing.";

const KNUCKLES: &str = "A link pushes its knuckle pin along itself, and the mass at the knuckle pin moves with the master rod. The crankpin carries all of it; what the knuckle pins, which stand beside the master rod, turn the rod with presses the master's piston against the wall: its side force below includes this. The loads are computed from the exact motion, to the roundings of decimals.";

const ORDERS: &str = "The largest value of each order of the load, gas and masses together, zero to peak. Order κ of the gas is a harmonic of one cylinder times the stars $\\sum_j \\rho_j e^{i(\\alpha_j \\mp \\kappa\\varphi_j)}$, $\\rho_j$ the part that the bearing carries, $\\alpha_j$ the axis and $\\varphi_j$ the crank angle at which cylinder j fires: where both are 0, exactly, and the masses add nothing, the order is **0** for every pressure common to all cylinders. At whole orders gas and masses add as vectors; half orders are of the gas only.";

const FOUND: &str = "The piston pushes its rod with $F = F_g - F_{in}$ towards the crank, $F_g = (p - p_c)\\,A$ the gas and $F_{in} = -m\\ddot s$ the inertia; the rod is inclined by β and pushes its crankpin with $-F\\,(1 - i\\tan\\beta)\\,e^{i\\alpha}$, the piston the wall with $F\\tan\\beta$. Each bearing carries its parts of the pins, and of what turns with the shaft. Head, walls and bearings together take the shaking force of the masses alone: the gas adds none.";

const ALONE: &str = "The following is about the masses alone, order by order, exactly: the largest of their sum in one revolution is “without gas” above.";

/// The short answer: the largest load of every bearing and rod.
pub fn complete_bearings_answer(engine: &Engine, loads: &CycleLoads) -> Document {
    let mut answer = Document::new("bearings", engine.title());
    if let Some(bearings) = &loads.bearings {
        answer.push(tables::bearings(engine, bearings));
        answer.blocks.extend(words::answer(engine, loads, bearings).into_iter().map(Block::Paragraph));
    }
    answer.blocks.extend(notes(engine, loads));
    answer
}

/// A document on the masses alone that says why the gas, which the layout asks for, is not in it.
pub fn without_gas(mut document: Document, lack: &Missing) -> Document {
    let told = Block::Note(phrase!("Gas loads were asked for, but are missing: {}.", lack.to_string()));
    document.blocks.insert(1.min(document.blocks.len()), told);
    document
}

/// What a person should look at.
fn notes(engine: &Engine, loads: &CycleLoads) -> Vec<Block> {
    let odd = loads.warnings.iter().map(|(cylinders, odd)| Block::Note(warning(engine, cylinders, odd)));
    let mut notes: Vec<Block> = odd.collect();
    if has_assumed(engine) {
        let command = Text::code("crankstar torque --output");
        notes.push(Block::Note(phrase!("Some values of the gas are assumed: {} lists them.", command)));
    }
    notes
}

/// The page, with the loads of the masses alone by orders at its end.
pub fn complete_bearings_page(engine: &Engine, loads: &CycleLoads, masses: &BearingLoads) -> Document {
    let mut page = Document::new("bearings", phrase!("{}: main bearings", engine.title()));
    let section = |page: &mut Document, words: &'static str| page.push(Block::Heading(1, words.into()));
    if let Some(both) = &loads.bearings {
        page.push(Block::Answer(words::answer(engine, loads, both)));
        page.blocks.extend(notes(engine, loads));
        page.push(tables::bearings(engine, both));
        section(&mut page, "Through the cycle");
        bearings_drawn(&mut page, engine.convention(), loads, &both[0]);
    }
    let drawn = |page: &mut Document, heading, words: &'static str, table: Table, pictures: Vec<Picture>| {
        section(page, heading);
        page.blocks.extend([Block::Paragraph(words.into()), table.into(), Block::Pictures(pictures)]);
    };
    drawn(&mut page, "Crankpins", PINS, tables::pins(engine, loads), plots::pins(engine, loads));
    if !loads.shared_pins.is_empty() {
        let (table, pictures) = (tables::shared_pins(engine, loads), plots::shared_pins(engine, loads));
        drawn(&mut page, "Crankpins with several rods", SHARED, table, pictures);
    }
    if !loads.knuckles.is_empty() {
        let (table, pictures) = (tables::knuckles(engine, loads), plots::knuckles(engine, loads));
        drawn(&mut page, "Articulated rods", KNUCKLES, table, pictures);
    }
    section(&mut page, "Rods and side forces");
    page.push(Block::Paragraph(RODS.into()));
    page.push(tables::rods(engine, loads));
    if let Some([continuous, _]) = &loads.bearings {
        section(&mut page, "Order by order");
        page.push(Block::Paragraph(ORDERS.into()));
        page.push(tables::orders(continuous));
        page.push(Block::Paragraph(words::missed(loads, continuous)));
    }
    section(&mut page, "The masses alone");
    page.push(Block::Paragraph(ALONE.into()));
    page.blocks.extend(by_orders(engine, masses));
    section(&mut page, "Parts of a load");
    page.blocks.extend(parts_of_a_load(engine, masses));
    section(&mut page, "Method");
    page.push(Block::Paragraph(FOUND.into()));
    section(&mut page, "Assumptions");
    page.push(Block::List(words::assumptions(engine)));
    page
}

fn bearings_drawn(page: &mut Document, convention: Convention, loads: &CycleLoads, bearings: &CycleBearings) {
    for (bearing, pictures) in bearings.bearings.iter().zip(plots::bearings(convention, loads, bearings)) {
        page.push(Block::Heading(2, phrase!("Bearing {}", bearing.name.clone())));
        page.push(Block::Pictures(pictures.into()));
    }
}
