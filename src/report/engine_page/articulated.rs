//! What do links on a master rod change, and what does an engine hide that is taken to have none?

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::super::{residual, typeset};
use super::left::numbers;
use super::weighing::Weighed;
use crate::engine::{Cylinder, Draft, Engine, Form, Link, Mechanism, Rod};
use crate::exact::Turn;
use crate::loads::{self, Loads};
use crate::order;
use crate::page::{Block, Number, Piece, Table, Text, Unit};
use crate::proof::{Planar, Sense};
use crate::report::texts::engine as text;
use crate::verdict::{Judgement, OrderVerdict};

/// r : l : a of the master rod that a radial is compared with which names none.
const TYPICAL: [(i64, i64); 3] = [(1, 1), (19, 5), (9, 10)];

/// The first orders that a master rod leaves.
const COMPARED: [u32; 2] = [2, 4];

/// The links of an engine, and what is proved of them.
pub(super) fn section(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    if !engine.has_links() {
        return Vec::new();
    }
    let formula = |tex: &str| Block::Formula(tex.to_owned(), None);
    let mut blocks = vec![Block::Heading(1, "Articulated rods".into()), links(engine).into()];
    let mut of_engine = engine.cylinders().iter().filter_map(Cylinder::link);
    if !of_engine.all(Link::is_corrected) {
        let [coefficients, sums] = [text::link_coefficients(), text::link_sums()].map(Block::Paragraph);
        blocks.extend([text::link_motion().into(), formula(HARMONIC), coefficients, sums]);
    }
    if engine.has_corrected_links() {
        let [coefficients, sums] = [text::corrected_coefficients(), text::corrected_sums()].map(Block::Paragraph);
        blocks.extend([text::corrected_motion().into(), formula(CORRECTED_HARMONIC), coefficients, sums]);
    }
    let lines = in_line(engine, judged);
    if !lines.is_empty() {
        blocks.push(text::own_line(residual::orders_in_words(&lines)).into());
    }
    if engine.cylinders().iter().any(|cylinder| !cylinder.knuckle_mass.is_zero()) {
        let is_corrected = engine.has_corrected_links();
        let masses = if is_corrected { text::corrected_knuckle_masses() } else { text::knuckle_masses() };
        blocks.push(masses.into());
    }
    blocks.push(text::rods_as_masses().into());
    blocks
}

/// The coefficients of a piston on a link.
const HARMONIC: &str = "\\kappa\\, e^{ik\\Delta} c_k(\\lambda) + z^k g_k, \\qquad z^k = \\sum_{u=0}^{k} \\binom{k}{u} (-\\kappa)^u e^{iu\\Delta}";
/// The same where the knuckle pin is elsewhere than at the angle of its cylinder.
const CORRECTED_HARMONIC: &str = "c_k = [k=1] \\left(1 + \\tfrac{\\kappa}{2} e^{i(\\Delta-\\varepsilon)} - \\tfrac{\\kappa}{2} e^{i(\\Delta+\\varepsilon)}\\right) + \\tfrac{\\kappa}{2} \\left(e^{i(k\\Delta+\\varepsilon)} + e^{i(k\\Delta-\\varepsilon)}\\right) c_k(\\lambda) + h_k";

/// The links, with what they hang on.
fn links(engine: &Engine) -> Table {
    let with_mass = engine.cylinders().iter().any(|cylinder| !cylinder.knuckle_mass.is_zero());
    let angle = |angle: &Turn| typeset::degrees(&typeset::signed_degrees(angle));
    let links = engine.cylinders().iter().filter_map(|cylinder| Some((cylinder, cylinder.link()?)));
    Table::of(links)
        .column("Cylinder", |(cylinder, _)| cylinder.name.clone())
        .column("Master", |(cylinder, link)| {
            master_of(engine, cylinder, link).map(|master| master.name.clone()).unwrap_or_default()
        })
        .column("Δ", |(_, link)| angle(&link.angle))
        .column_if(engine.has_corrected_links(), "ε", |(_, link)| angle(&link.correction))
        .column("κ = a/l", |(_, link)| Number::exact(&link.knuckle))
        .column("λ = r/l", |(_, link)| Number::exact(&link.master))
        .column("r/L", |(_, link)| Number::exact(&link.ratio))
        .column_if(with_mass, "Knuckle mass / m", |(cylinder, _)| Number::exact(&cylinder.knuckle_mass))
        .done()
}

/// The cylinder whose rod a link hangs on.
fn master_of<'a>(engine: &'a Engine, cylinder: &Cylinder, link: &Link) -> Option<&'a Cylinder> {
    engine.cylinders().iter().find(|other| {
        let stands_there = other.pin == cylinder.pin && &other.bank + &link.angle == cylinder.bank;
        stands_there && other.rod() == Some(&link.master_rod())
    })
}

/// The orders above 1 whose vectors are left and proved to lie on the line of the first master's own.
fn in_line(engine: &Engine, judged: &Judgement) -> Vec<String> {
    let Some(master) = engine.cylinders().iter().find(|cylinder| cylinder.rod().is_some()) else { return Vec::new() };
    // Every number of such an engine is real.
    let is_its_mirror_image = |order: u32, quantity: Planar, sense: Sense| {
        let line = order::phase(master, order, Some(sense));
        order::all_masses(engine, quantity, order, sense).parts().values().all(|sum| {
            let turned = sum.turned(&-&line);
            turned.minus(&turned.conjugate()).vanishes()
        })
    };
    let lies = |one: &OrderVerdict| {
        let mut senses = Sense::BOTH.into_iter();
        senses.all(|sense| Planar::BOTH.into_iter().all(|of| is_its_mirror_image(one.order, of, sense)))
    };
    let is_left = |one: &OrderVerdict| one.exists() && (one.force.is_left() || one.moment.is_left());
    numbers(&judged.orders, |one| one.order > 1 && is_left(one) && lies(one))
}

/// What a radial hides whose rods are all taken to be on the crankpin, as a line of the headline; with the λ that is assumed beside it where the
/// file gives no rods.
pub(super) fn hidden(engine: &Engine, weighed: Option<&Weighed>) -> Option<Text> {
    if engine.form() != Form::Radial || engine.has_links() || engine.has_offset() {
        return None;
    }
    let [r, l, a] = TYPICAL.map(|(n, d)| BigRational::new(n.into(), d.into()));
    let (usual, knuckle) = (&r / &l, &a / &l);
    let assumed = weighed.and_then(|weighed| weighed.assumed.clone());
    let ratio = engine.rods().next().map_or(assumed.unwrap_or(usual), |rod| rod.ratio.clone());
    if !ratio.is_positive() {
        return None;
    }
    let concentric = loads_with(engine, &ratio, None).ok()?;
    let linked = loads_with(engine, &ratio, Some(&knuckle)).ok()?;
    let peak = |loads: &Loads, order: u32| {
        let mut left = loads.orders.iter().filter(|one| !one.force.vanishes());
        left.find(|one| one.order == order).map_or(0.0, |one| one.force.largest())
    };
    let order = COMPARED.into_iter().find(|order| (peak(&linked, *order) - peak(&concentric, *order)).abs() > 1e-9)?;
    let [before, after] = [&concentric, &linked].map(|loads| {
        let peak = peak(loads, order);
        if peak == 0.0 { Text::zero() } else { Text::from(Piece::Quantity(peak, Unit::MULTIPLE)) }
    });
    let lengths = [r.clone(), &r / &ratio, &knuckle / &ratio].map(|length| typeset::short(&length));
    Some(text::rods_on_the_crankpin(lengths.join(" : "), order, after, before))
}

/// The loads of the pistons of an engine with these rods, concentric or on the first master of each row.
fn loads_with(engine: &Engine, ratio: &BigRational, knuckle: Option<&BigRational>) -> Result<Loads, String> {
    let rod = Mechanism::SliderCrank(Rod { ratio: ratio.clone(), offset: BigRational::zero() });
    let mut draft = Draft { cylinders: engine.cylinders().to_vec(), ..Draft::new("") };
    let mut masters: Vec<(usize, Turn)> = Vec::new();
    for cylinder in &mut draft.cylinders {
        cylinder.rotating_mass = BigRational::zero();
        cylinder.mechanism = Some(rod.clone());
        let master = masters.iter().find(|(pin, _)| *pin == cylinder.pin).map(|(_, bank)| bank.clone());
        match (master, knuckle) {
            (Some(bank), Some(knuckle)) => {
                let one = BigRational::from_integer(1.into());
                cylinder.mechanism = Some(Mechanism::Link(Link {
                    master: ratio.clone(),
                    knuckle: knuckle.clone(),
                    angle: &cylinder.bank - &bank,
                    correction: Turn::zero(),
                    ratio: ratio / (one - knuckle),
                }));
            }
            (Some(_), None) => {}
            (None, _) => masters.push((cylinder.pin, cylinder.bank.clone())),
        }
    }
    let engine = draft.build().map_err(|error| error.to_string())?;
    loads::loads(&engine, &COMPARED).map_err(|error| error.to_string())
}
