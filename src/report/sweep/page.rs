//! What is on the page of a sweep, and on the terminal? What is zero and what is greatest first, then the plots and every point.

use super::amounts::{counted, in_newtons, unit, value};
use super::assumptions::assumptions;
use super::findings::{Finding, findings};
use super::sentences::{firing_sentence, gone_sentence};
use super::{firing, observed, plots, tables};
use crate::loads::Arm;
use crate::page::{Block, Document, Text, phrase};
use crate::proof::Planar;
use crate::sweep::{Parameter, Sweep, ZeroSet};

/// More points than this are left to the table in CSV.
const MOST_ROWS: usize = 200;
/// More forces and moments than this are left to the table below the answer.
const MOST_SENTENCES: usize = 4;

const ALL_ZEROS: &str = "The exact values inside the range, on the grid of the sweep or between its points. The lists are complete: nowhere else in the \
    range does one of these vanish.";
const SOME_ZEROS: &str = "The exact values inside the range, on the grid of the sweep or between its points. The lists are complete but for those that \
    say otherwise.";
const PARTS: &str = "Direct and reverse are the two vectors of an order, which turn with the crank and against it. All: both vanish, and with them the \
    whole force or moment. Along is the part in the reference direction, which for a V is the bisector of its banks; across is the \
    part at right angles to it.";
const SIZES: &str =
    "All amplitudes are from zero to peak. Largest and smallest: the greatest and the least length in a revolution.";
const EXACT: &str = "Zeros are decided exactly; amplitudes are decimals.";
const MULTIPLES: &str = "$m$ is the reciprocating mass of a cylinder, $r$ the crank radius, $\\omega$ the speed of the crank in radians a second.";
const COEFFICIENT: &str = "$c_k$ is the coefficient of order k, which the rod decides; the layout gives no rod.";
const SPACING: &str = "$a$ is the spacing of neighbouring cylinders, which the layout does not give as a length.";
const COUNTERWEIGHTS: &str = "There are two counterweights, in the planes of the outermost throws. They cancel the part of order 1 that turns with the crank; the larger one is shown.";
const FIRING: &str = "Firing intervals count where crankpins are in line with their cylinders: offsets move the top dead centres. Where the layout gives no firing order, they are those of the most even order that the throws allow.";

/// The short answer: what is zero, what is greatest, and where.
pub fn sweep_answer(sweep: &Sweep) -> Document {
    let sweep = &counted(sweep);
    let (found, gone) = findings(sweep);
    let mut answer = Document::new("sweep", title(sweep));
    answer.push(Block::Paragraph(swept(sweep)));
    answer.blocks.extend(sentences(sweep, &found, &gone).into_iter().map(Block::Paragraph));
    answer.blocks.extend(others(sweep, &found));
    answer.blocks.extend(zeros(sweep).into_iter().flatten());
    answer.blocks.extend(firing::answer(sweep));
    answer
}

/// The page, with a picture of each order that is not zero everywhere.
pub fn sweep_page(sweep: &Sweep) -> Document {
    let sweep = &counted(sweep);
    let (found, gone) = findings(sweep);
    let mut page = Document::new("sweep", title(sweep));
    page.push(Block::Answer(sentences(sweep, &found, &gone)));
    page.push(Block::Paragraph(swept(sweep)));
    page.blocks.extend(others(sweep, &found));
    let pictures = plots::drawings(sweep);
    if !pictures.is_empty() {
        page.section("Plots", Block::Pictures(pictures));
    }
    if let Some(zeros) = zeros(sweep) {
        page.push(Block::Heading(1, "Where each vector vanishes".into()));
        page.blocks.extend(zeros);
    }
    page.blocks.extend(firing::section(sweep));
    page.push(Block::Heading(1, "Every point".into()));
    match sweep.points.len() <= MOST_ROWS {
        true => page.blocks.extend(tables::points(sweep)),
        false => page.push(phrase!(
            "The {} points are in {}, which {} prints.",
            sweep.points.len(),
            Text::code("sweep.csv"),
            Text::code("crankstar sweep … --format csv")
        )),
    }
    page.section("How to read it", Block::List(conventions(sweep)));
    page.push("Length, breadth and height are those of a simple geometry:");
    page.push(Block::List(assumptions(&sweep.geometry).into()));
    page
}

fn title(sweep: &Sweep) -> Text {
    match &sweep.parameters[..] {
        [one, other] => phrase!("{}: {} and {} swept", &sweep.title, one.label.clone(), other.label.clone()),
        [one, ..] => phrase!("{}: {} swept", &sweep.title, one.label.clone()),
        [] => phrase!("{}: a sweep", &sweep.title),
    }
}

/// What runs from where to where.
fn swept(sweep: &Sweep) -> Text {
    let range = |(parameter, is_angle): (&Parameter, bool)| {
        let show = |at| value(parameter, at, is_angle);
        let key = Text::code(parameter.key.to_string());
        let range = &parameter.range;
        if range.count() == 1 {
            return phrase!("{} at {} alone", key, show(&range.value(0)));
        }
        phrase!("{} from {} to {}, {} values", key, show(&range.value(0)), show(&range.last()), range.count())
    };
    let ranges = Text::joined(sweep.axes().map(range), "; ");
    let [force, moment] = Planar::BOTH.map(|quantity| unit(sweep, quantity));
    phrase!("Swept: {}. Forces are in {}, moments in {}.", ranges, force, moment)
}

fn sentences(sweep: &Sweep, found: &[Finding], gone: &[(Planar, u32)]) -> Vec<Text> {
    let told = found.iter().take(MOST_SENTENCES).map(|finding| finding.sentence(sweep));
    let rest = (found.len() > MOST_SENTENCES).then(|| "The other orders are in the table below.".into());
    let values = observed::sentences(sweep);
    told.chain(rest).chain(gone_sentence(gone)).chain(firing_sentence(sweep)).chain(values).collect()
}

/// All forces and moments in a table, where there are more than the sentences tell.
fn others(sweep: &Sweep, found: &[Finding]) -> Option<Block> {
    (found.len() > MOST_SENTENCES).then(|| tables::extremes(sweep, found).into())
}

/// Where each vector vanishes, where the parameter is an angle.
fn zeros(sweep: &Sweep) -> Option<[Block; 3]> {
    let sets: &[ZeroSet] = sweep.zeros.as_deref().filter(|sets| !sets.is_empty())?;
    let parameter = sweep.parameters.first()?;
    let complete = sets.iter().all(|set| set.complete);
    Some([
        Block::Paragraph(if complete { ALL_ZEROS } else { SOME_ZEROS }.into()),
        tables::zeros(parameter, sets).into(),
        Block::Note(PARTS.into()),
    ])
}

fn conventions(sweep: &Sweep) -> Vec<Text> {
    let multiples = !in_newtons(sweep);
    let of_units = [
        multiples.then_some(MULTIPLES),
        (multiples && !sweep.rods_known).then_some(COEFFICIENT),
        (sweep.arm == Arm::Spacing).then_some(SPACING),
    ];
    // Beside the table of zeros it is reported already.
    let parts = sweep.zeros.is_none().then_some(PARTS);
    let words = [SIZES, EXACT].into_iter().chain(parts).chain(of_units.into_iter().flatten());
    words.chain([COUNTERWEIGHTS, FIRING]).map(Text::from).collect()
}
