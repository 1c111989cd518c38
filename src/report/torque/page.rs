//! What is on the page of the torque, and on the terminal?

use super::{TorqueStudy, plots, settings, tables, words};
use crate::engine::Engine;
use crate::page::{Block, Document, Fold, phrase};
use crate::torque::guide_moments;

const ORDERS: &str = "Order κ of the torque is the harmonic of one cylinder times the firing star $S_\\kappa = \\sum_j e^{-i\\kappa\\varphi_j}$, $\\varphi_j$ the crank angle at which cylinder j fires: where the star is 0, exactly, the order vanishes for every pressure common to all cylinders. At whole orders gas and inertia add as vectors; half orders are of the gas only. Zero to peak.";

const GUIDES: &str = "The couple of a cylinder's guide and crank forces is its torque: H is the order of the torque, which rocks the frame about the shaft; X is \
    the sum of the couples, each times its distance from the middle, over the rod length, and twists it.";

const SHAFTS: &str = "The torque on each crankshaft is positive in the sense in which it turns. With the flywheel at the first crankshaft the gears carry the torque of the others to it, reversals and all; where each has a flywheel of its own that keeps its speed, their means alone. The torque of this page is that of all together at the first.";

const LINKS: &str = "A piston on a link moves with the knuckle pin K on the master rod: $s = \\mathrm{Re}\\,K + \\sqrt{L^2 - \\mathrm{Im}^2 K}$, along its axis. The mass μ at a knuckle pin adds $-\\tfrac12 \\mu\\,(|K'|^2)'\\,\\omega^2$, and its angular momentum about the shaft a roll moment on the frame. Each link is in a class of its own, but for copies on other crankpins: an order is 0, proved, where the star of every class is. What of the others cancels by numbers alone is shown as it is computed.";

/// What H and X are of links.
pub(in crate::report) const LINKED_GUIDES: &str = "The guides of links and their master rod are counted together, at the length of that rod, and with what the masses at the knuckle pins change of their angular momentum.";

const FLYWHEEL: &str = "At a constant load $J = \\Delta W / (\\delta\\,\\omega^2)$, δ the largest less the smallest speed over their mean: exact, with the inertia torque at the mean speed. The reciprocating masses add nearly the mean of $\\sum m\\,s'^2$ to J; the balance of energy $\\tfrac12 (J + \\sum m\\,s'^2)\\,\\omega^2 = E_0 + \\int (T_g - \\bar T)\\,d\\theta$ contains them completely.";

const FOUND: &str = "The gas acts with $F_g = (p - p_c)\\,A$ on the piston and turns the crank with $T = -F_g\\,s'$, s the piston's displacement outward, the prime $d/d\\psi$; the mass m adds $-m\\,s'\\,s''\\,\\omega^2$. Mean and orders are integrals over the smooth pieces of the pressure, each by itself; largest, smallest and the work of the flywheel are taken from the torque itself, not from its series. A harmonic is at most $2\\,\\mathrm{Var}(T')/(\\Psi\\kappa^2)$, Ψ the cycle.";

/// The short answer.
pub(super) fn answer(TorqueStudy { engine, torque }: &TorqueStudy) -> Document {
    let mut answer = Document::new("torque", engine.title());
    answer.blocks.extend(words::answer(engine, torque).into_iter().map(Block::Paragraph));
    answer.push(tables::orders(torque));
    if !torque.shafts.is_empty() {
        answer.push(tables::shafts(engine, torque));
    }
    answer.blocks.extend(words::warnings(engine, torque).into_iter().map(Block::Note));
    if has_assumed(engine) {
        answer.push(Block::Note("Some values of the gas are assumed: the page, with --output, lists them.".into()));
    }
    answer
}

/// What the report of an engine shows of its torque, where the file asks for the gas; none where it does not.
pub(in crate::report) fn torque_section(engine: &Engine) -> Vec<Block> {
    if !engine.effects().gas {
        return Vec::new();
    }
    let heading = Block::Heading(1, "Torque of gas and inertia".into());
    match crate::torque::torque(engine) {
        Err(lack) => vec![heading, Block::Paragraph(phrase!("No torque: {}.", lack.to_string()))],
        Ok(torque) => {
            let mut blocks = vec![heading, Block::List(words::answer(engine, &torque))];
            blocks.extend(words::warnings(engine, &torque).into_iter().map(Block::Note));
            blocks.push(plots::torque(&torque).into());
            blocks.push(Block::Paragraph(ORDERS.into()));
            blocks.push(tables::orders(&torque).into());
            blocks.push(Block::Paragraph(words::roll(engine, &torque)));
            blocks.push(Block::Folded(Fold {
                summary: "Gas: what is given and assumed".into(),
                blocks: vec![settings::table(engine, &torque).into(), Block::List(words::assumptions(engine))],
            }));
            blocks
        }
    }
}

/// The page, with its pictures.
pub(super) fn page(TorqueStudy { engine, torque }: &TorqueStudy) -> Document {
    let mut page = Document::new("torque", phrase!("{}: torque", engine.title()));
    let section = |page: &mut Document, words: &'static str| page.push(Block::Heading(1, words.into()));
    page.push(Block::Answer(words::answer(engine, torque)));
    page.blocks.extend(words::warnings(engine, torque).into_iter().map(Block::Note));
    page.push(plots::torque(torque));
    section(&mut page, "Order by order");
    page.push(Block::Paragraph(ORDERS.into()));
    page.push(tables::orders(torque));
    page.push(Block::Paragraph(words::roll(engine, torque)));
    if !torque.shafts.is_empty() {
        section(&mut page, "Crankshafts");
        page.push(tables::shafts(engine, torque));
        page.push(Block::Paragraph(SHAFTS.into()));
    }
    section(&mut page, "Pressure");
    page.push(Block::Pictures(plots::pressure(engine, torque).into()));
    page.push(tables::classes(engine, torque));
    page.push(settings::table(engine, torque));
    if let Some(evenness) = &torque.evenness {
        section(&mut page, "Flywheel");
        page.push(tables::flywheel(evenness));
        page.push(Block::Paragraph(FLYWHEEL.into()));
    }
    if let Some(moments) = guide_moments(engine, torque).filter(|_| engine.cylinders().len() > 1) {
        page.push(Block::Folded(Fold {
            summary: "Guide-force moments".into(),
            blocks: [GUIDES]
                .into_iter()
                .chain(engine.has_links().then_some(LINKED_GUIDES))
                .map(|text| Block::Paragraph(text.into()))
                .chain([tables::guides(&moments).into()])
                .collect(),
        }));
    }
    section(&mut page, "Method");
    page.push(Block::Paragraph(FOUND.into()));
    page.blocks.extend(engine.has_links().then(|| Block::Paragraph(LINKS.into())));
    page.push(Block::Paragraph(tables::accuracy(torque)));
    section(&mut page, "Assumptions");
    page.push(Block::List(words::assumptions(engine)));
    page
}

/// Whether some value of the gas was not given.
pub(in crate::report) fn has_assumed(engine: &Engine) -> bool {
    use crate::engine::PressureLaw;
    let Some(gas) = engine.gas() else { return false };
    let of_law = |law: &PressureLaw| match law {
        PressureLaw::Table(_) => false,
        PressureLaw::Cycle(ideal) => !ideal.assumed.is_empty(),
        PressureLaw::Stage(stage) => !stage.assumed.is_empty(),
    };
    gas.chambers.iter().any(|chamber| chamber.crankcase_assumed) || gas.laws.iter().any(of_law)
}
