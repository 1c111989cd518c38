//! What is on the page of a sweep, and on the terminal? What is zero and what is greatest first, then the plots and every point.

use super::amounts::{self, counted, in_newtons, unit, value};
use super::findings::{Finding, findings};
use super::sentences::{firing_sentences, gone_sentence};
use super::{firing, observed, plots, tables};
use crate::loads::Arm;
use crate::page::{Block, Document, Text};
use crate::proof::Planar;
use crate::report::texts::sweep as text;
use crate::sweep::{Geometry, Parameter, Sweep};

/// More points than this are left to the table in CSV.
const MOST_ROWS: usize = 200;
/// More forces and moments than this are left to the table below the answer.
const MOST_SENTENCES: usize = 4;

/// The short answer: what is zero, what is greatest, and where.
pub fn sweep_answer(sweep: &Sweep) -> Document {
    let sweep = &counted(sweep);
    let (found, gone) = findings(sweep);
    let mut answer = Document::new("sweep", title(sweep));
    answer.blocks.extend(swept(sweep));
    answer.blocks.extend(sentences(sweep, &found, &gone).into_iter().map(Block::Paragraph));
    answer.blocks.extend(others(sweep, &found));
    answer.blocks.extend(zeros(sweep));
    answer.blocks.extend(firing::answer(sweep));
    answer
}

/// The page, with a picture of each order that is not zero everywhere.
pub fn sweep_page(sweep: &Sweep) -> Document {
    let sweep = &counted(sweep);
    let (found, gone) = findings(sweep);
    let points = match sweep.points.len() {
        ..=MOST_ROWS => tables::points(sweep).into(),
        count => {
            let command = Text::code("crankstar sweep … --format csv");
            text::points_in_file(count, Text::code("sweep.csv"), command).into()
        }
    };
    let Geometry { bore, rod_ratio, half_width, above_pin, crankcase, spacing, ends } = &sweep.geometry;
    text::Page {
        title: title(sweep),
        answer: Block::Answer(sentences(sweep, &found, &gone)).into(),
        swept: swept(sweep).collect(),
        orders: others(sweep, &found).into(),
        plots: plots::drawings(sweep).into(),
        zeros: zeros(sweep).into(),
        firing: firing::section(sweep).into(),
        points,
        // Beside the table of zeros it is reported already.
        vectors: sweep.zeros.is_none().then(text::vectors).into(),
        units: units(sweep).into(),
        bore: bore.to_string().into(),
        rod_ratio: rod_ratio.to_string().into(),
        width: (2.0 * half_width).to_string().into(),
        above_pin: above_pin.to_string().into(),
        crankcase: crankcase.to_string().into(),
        ends: ends.to_string().into(),
        spacing: spacing.to_string().into(),
    }
    .document()
}

fn title(sweep: &Sweep) -> Text {
    match &sweep.parameters[..] {
        [one, other] => text::title_of_two(&sweep.title, amounts::name(sweep, one), amounts::name(sweep, other)),
        [one, ..] => text::title(&sweep.title, one.label.clone()),
        [] => text::title_alone(&sweep.title),
    }
}

/// What runs from where to where, and what all of it is counted in where the engines have different m and r.
fn swept(sweep: &Sweep) -> impl Iterator<Item = Block> {
    let of_others = sweep.multiples.as_ref().and(sweep.observed.as_ref()).map(|_| text::own_multiples());
    [ranges(sweep)].into_iter().chain(amounts::one_unit(sweep)).chain(of_others).map(Block::Paragraph)
}

fn ranges(sweep: &Sweep) -> Text {
    let range = |(parameter, is_angle): (&Parameter, bool)| {
        let show = |at| value(parameter, at, is_angle);
        let key = Text::code(parameter.key.to_string());
        let range = &parameter.range;
        match range.count() {
            1 => text::one_value(key, show(&range.value(0))),
            count => text::range(key, show(&range.value(0)), show(&range.last()), count),
        }
    };
    let ranges = Text::joined(sweep.axes().map(range), "; ");
    let [force, moment] = Planar::BOTH.map(|quantity| unit(sweep, quantity));
    text::swept(ranges, force, moment)
}

fn sentences(sweep: &Sweep, found: &[Finding], gone: &[(Planar, u32)]) -> Vec<Text> {
    let told = found.iter().take(MOST_SENTENCES).map(|finding| finding.sentence(sweep));
    let rest = (found.len() > MOST_SENTENCES).then(text::other_orders);
    let values = observed::sentences(sweep);
    told.chain(rest).chain(gone_sentence(gone)).chain(firing_sentences(sweep)).chain(values).collect()
}

/// All forces and moments in a table, where there are more than the sentences tell.
fn others(sweep: &Sweep, found: &[Finding]) -> Option<Block> {
    (found.len() > MOST_SENTENCES).then(|| tables::extremes(sweep, found).into())
}

/// Where each vector vanishes, where the parameter is an angle.
fn zeros(sweep: &Sweep) -> Vec<Block> {
    match (&sweep.parameters[..], sweep.zeros.as_deref()) {
        ([one], Some(sets)) if !sets.is_empty() => {
            let complete = sets.iter().all(|set| set.complete);
            let about = if complete { text::all_zeros() } else { text::some_zeros() };
            vec![about.into(), tables::zeros(one, sets).into(), Block::Note(text::vectors())]
        }
        ([one], None) if one.unit() == "°" => vec![text::no_zeros().into()],
        _ => Vec::new(),
    }
}

/// The signs in the units.
fn units(sweep: &Sweep) -> impl Iterator<Item = Text> {
    let multiples = !in_newtons(sweep);
    let signs = [
        multiples.then(|| if sweep.multiples.is_none() { text::multiples() } else { text::multiples_of_one() }),
        (multiples && !sweep.rods_known).then(text::coefficient),
        (sweep.arm == Arm::Spacing).then(text::spacing),
    ];
    signs.into_iter().flatten()
}
