//! What stands on the page of a study? How many checks hold and which do not, the statements, the families, what was assumed.

use crankstar::page::{Block, Document, File, Fold, Table, Text};
use crankstar::report::{data, sweep_page};
use crankstar::sweep::{Sweep, SweptEngine};
use crankstar::table::csv;
use num_rational::BigRational;
use num_traits::Zero;

use super::study::{Checked, Studied, Study};
use super::{phrase, study_checks as checks, study_flywheels as flywheel, study_plots as plots};

/// Digits of the tables, which are to be the same on every machine.
const DIGITS: usize = 10;

const ZEROS: &str = "Where each vector vanishes in the range of the V; the lists are exact and complete:";
const PARTS: &str = "Along is vertical, across horizontal; largest and smallest are the greatest and the least length of the resultant in a revolution; \
    direct and reverse are the vectors that turn with the crank and against it.";
const WORDS: &str = "The statements are in the words of this page; a source's own words are in quotation marks. What is in bold below a statement is a conclusion from the answers in its tables.";
const ASSUMED: [&str; 6] = [
    "Amplitudes are zero to peak; those of order k are multiples of $m r \\omega^2 c_k$, and moments of that times the spacing $a$.",
    "There are two counterweights, in the planes of the outermost throws. They cancel the part of order 1 that turns with the crank; the larger one is shown, as its mass-radius in multiples of $m r$. The masses of the rods at the crankpin are not in it.",
    "The firing intervals are those of the most even order that the throws allow, in line those of the firing order.",
    "The volume is the area of the end view, banks and crankcase together, times the length.",
    "The paper's mass adds flywheel and counterweights to a main part that follows the size by a formula that it does not give: the plots show the volume, and the \
     flywheel and the counterweights in kilograms where a family has gas, each by itself.",
    "A flywheel of a family is found for the most even order that its throws allow, of several equally even ones for that with the least ΔW, at a constant load. It has all the inertia that turns, in a ring; crankshaft \
     and clutch would make it lighter by the same at each engine.",
];

/// The page of a study, which leads to its [`study_tables`].
pub fn study_page(study: &Study) -> Document {
    let mut page = Document::new("README", &study.title);
    page.has_contents = true;
    page.push(Block::Answer(answer(study)));
    page.push(Block::Paragraph(phrase!("Source: {}.", &study.source)));
    page.push(Block::Paragraph(WORDS.into()));
    page.push(Block::Heading(1, "What the source says, and what holds".into()));
    for said in &study.statements {
        page.push(Block::Heading(2, (&said.text).into()));
        page.push(Block::Paragraph(phrase!("**{}**", &said.conclusion)));
        page.blocks.extend(checks::checks(&said.checks, &study.source));
    }
    study.families.iter().for_each(|family| page.blocks.extend(of_family(family)));
    page.push(Block::Heading(1, "What was assumed".into()));
    page.push(Block::List(ASSUMED.map(Text::from).into()));
    page.push(Block::Paragraph("Length, breadth and height are those of a simple geometry:".into()));
    // The page of a sweep ends with them.
    page.blocks.extend(study.families.first().and_then(|family| sweep_page(&family.sweep).blocks.pop()));
    page
}

/// How many checks hold, and which do not.
fn answer(study: &Study) -> Vec<Text> {
    let checks = || study.statements.iter().flat_map(|said| &said.checks);
    let count = |claimed: bool| {
        let of = || checks().filter(move |check| check.provenance.is_claimed() == claimed);
        [of().count(), of().filter(|check| check.holds).count(), of().filter(|check| !check.holds).count()]
    };
    let [claims, hold, fail] = count(true);
    let [own, own_hold, _] = count(false);
    let counted = [
        phrase!("**Checks of what the source says:** {}, of which {} hold and {} do not.", claims, hold, fail),
        phrase!("**Our own cross-checks:** {}, of which {} hold.", own, own_hold),
    ];
    let failing = checks().filter(|check| !check.holds && check.provenance.is_claimed());
    let told = |check: &Checked| {
        phrase!("**Does not hold:** {}: {}. Finding: {}", &check.engine, &check.claim, checks::found(&check.found))
    };
    counted.into_iter().chain(failing.map(told)).collect()
}

fn of_family(family: &Studied) -> Vec<Block> {
    let sweep = &family.sweep;
    let (whole, csv) = (with_in_line(family), table_name(family));
    let in_line = family.in_line.as_ref();
    let mut blocks = vec![Block::Heading(1, (&sweep.title).into())];
    blocks
        .extend(in_line.map(|(title, _)| Block::Paragraph(phrase!("The value 0 is an engine of its own: {}.", title))));
    blocks.push(Block::Pictures(plots::pictures(family, &whole)));
    let found = sweep_page(&whole).blocks;
    blocks.push(Block::Paragraph(ZEROS.into()));
    blocks.push(zeros(&found).clone().into());
    blocks.push(Block::Note(PARTS.into()));
    blocks.extend(flywheel::blocks(family));
    blocks.push(Block::Paragraph(phrase!("All values: {}.", Text::link(Text::label(csv.clone()), csv))));
    let points = found.into_iter().filter_map(|block| if let Block::Folded(fold) = block { Some(fold) } else { None });
    let points =
        points.flat_map(|fold| [Block::Paragraph(phrase!("**{}:**", fold.summary))].into_iter().chain(fold.blocks));
    blocks.push(Block::Folded(Fold { summary: phrase!("{}: every point", &sweep.title), blocks: points.collect() }));
    blocks
}

/// Where each vector vanishes: the table in front of what its columns mean.
fn zeros(sweep_page: &[Block]) -> &Table {
    let mut behind = sweep_page.iter().skip_while(
        |block| !matches!(block, Block::Heading(_, words) if words.plain() == "Where each vector vanishes"),
    );
    let table = behind.find_map(|block| if let Block::Table(table) = block { Some(table) } else { None });
    table.expect("the zeros of an angle")
}

fn table_name(family: &Studied) -> String {
    format!("{}.csv", family.name)
}

/// The points of each family as a table in CSV, the engine in line first.
pub fn study_tables(study: &Study) -> Vec<File> {
    let table = |family| File {
        name: table_name(family),
        text: csv(&data::sweep_points(&with_in_line(family)).rounded(DIGITS)),
    };
    study.families.iter().map(table).collect()
}

/// The sweep with the engine in line for the value 0.
fn with_in_line(family: &Studied) -> Sweep {
    let mut whole = family.sweep.clone();
    if let Some((_, point)) = &family.in_line {
        whole.points.insert(0, SweptEngine { values: vec![BigRational::zero()], ..point.clone() });
    }
    whole
}
