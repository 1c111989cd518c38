//! Is it true, what is said about a family of engines? A study: families with their sweeps, statements with checks.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use serde::Deserialize;

use super::answer::Answer;
use super::check::{Check, CheckTable, Firing, Part, Values};
use super::compare;
use super::flywheel::{FlywheelTable, Flywheels};
use super::grammar::parse_statement;
use super::provenance::{Keys, Provenance};
use super::statement::Statement;
use super::written_value::value;
use crate::engine::{Engine, throws};
use crate::exact::PhasorSum;
use crate::file::written::{Text, read};
use crate::file::{Key, Layout, LayoutError, Template, parse_number};
use crate::numbers::{self, Form};
use crate::proof::{Quantity, Sense};
use crate::remedy::{self, ComparableEngine};
use crate::sweep::{self, Geometry, Parameter, Sweep, SweptEngine, Zeros};
use crate::text::Untrusted;

/// A study, every family computed and every check answered.
#[derive(Clone, Debug)]
pub struct Study {
    /// Title of the page.
    pub title: Untrusted,
    /// What it is about.
    pub source: Untrusted,
    /// The families.
    pub families: Vec<Studied>,
    /// The statements.
    pub statements: Vec<Said>,
}

/// One family of engines.
#[derive(Clone, Debug)]
pub struct Studied {
    /// What the checks call it.
    pub name: String,
    /// Its sweep.
    pub sweep: Sweep,
    /// The same of its rotating masses alone.
    pub rotating: Option<Sweep>,
    /// The engine in line that stands for the value 0, with its title.
    pub in_line: Option<(Untrusted, SweptEngine)>,
    /// End view times length in cubes of the crank radius: of the engine in line, where there is one, and of each point.
    pub volumes: Vec<Option<f64>>,
    /// Its engines with gas, and their flywheels.
    pub flywheels: Option<Flywheels>,
}

/// A statement, and what was checked for it.
#[derive(Clone, Debug)]
pub struct Said {
    /// The statement.
    pub text: Untrusted,
    /// What the author of the file concludes.
    pub conclusion: Untrusted,
    /// The checks.
    pub checks: Vec<Checked>,
}

/// One check.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The engine.
    pub engine: Untrusted,
    /// Who says so, and where.
    pub provenance: Provenance,
    /// What is claimed, in words.
    pub claim: Untrusted,
    /// Whether it holds.
    pub holds: bool,
    /// What is the case.
    pub found: Found,
}

/// What is the case.
#[derive(Clone, Debug)]
pub enum Found {
    /// The answer to a claim about one engine.
    Claim(Box<(Statement, Answer)>),
    /// The values at which something vanishes, and whether they are all.
    Values {
        /// The values.
        at: Vec<BigRational>,
        /// Whether it vanishes everywhere.
        everywhere: bool,
        /// Whether these are proved to be all in the range.
        complete: bool,
    },
    /// Where on the grid the firing is as claimed, with the difference of its intervals in turns.
    Firing {
        /// The difference; none where steps were compared.
        difference: Option<BigRational>,
        /// The values of the grid.
        at: Vec<BigRational>,
    },
    /// `m_cw ρ b` in multiples of m r a, in closed form.
    Counterweight(Option<Form>),
    /// The largest volume of the family as a part of that of the engine in line.
    Volume(f64),
    /// Where on the grid the flywheel, or an order of the torque, is as claimed.
    Grid(Vec<BigRational>),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: Text,
    source: Text,
    orders: Vec<Text>,
    family: Vec<FamilyTable>,
    statement: Vec<StatementTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FamilyTable {
    name: Text,
    layout: Text,
    rotating: Option<Text>,
    in_line: Option<Text>,
    sweep: Text,
    flywheel: Option<FlywheelTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementTable {
    text: Text,
    kind: Option<Text>,
    place: Option<Text>,
    words: Option<Text>,
    conclusion: Text,
    check: Vec<CheckTable>,
}

/// Reads a study and answers its checks; `read_file` gives the text of a file beside it.
///
/// # Errors
/// What cannot be read, in one line.
pub fn study(
    name: &str,
    source_text: &str,
    read_file: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Study, String> {
    let file: File = read(source_text).map_err(|error: LayoutError| error.in_file(name, source_text).to_string())?;
    let number =
        |text: &Text| text.get_ref().0.parse::<u32>().map_err(|_| format!("`{}` is no order", text.get_ref().0));
    let orders = file.orders.iter().map(number).collect::<Result<Vec<_>, _>>()?;
    let mut families = Vec::new();
    let mut texts = Vec::new();
    for table in &file.family {
        let text = read_file(&table.layout.get_ref().0)?;
        let parameter = [Parameter::parse(&table.sweep.get_ref().0).map_err(|error| error.to_string())?];
        let run = |text: &str| {
            let template = Template::new(name, text).map_err(|error| error.to_string())?;
            sweep::sweep(&template, &parameter, &orders, &Geometry::default()).map_err(|error| error.to_string())
        };
        let in_line = |file: &Text| {
            let text = read_file(&file.get_ref().0)?;
            let template = Template::new(name, &text).map_err(|error| error.to_string())?;
            let layout = known(&template, &[])?;
            let point = sweep::judge(&layout, template.cycle(), &orders, &Geometry::default());
            let point = point.map_err(|error| error.to_string())?;
            Ok::<_, String>((volume(&layout), layout.title().clone(), point))
        };
        let in_line = table.in_line.as_ref().map(in_line).transpose()?;
        let template = Template::new(name, &text).map_err(|error| error.to_string())?;
        let of_family = parameter[0].range.values().map(|value| {
            let layout = known(&template, &[(&parameter[0].key, &value.to_string())])?;
            Ok(volume(&layout))
        });
        let first = in_line.iter().map(|(volume, ..)| Ok(*volume));
        let volumes = first.chain(of_family).collect::<Result<Vec<_>, String>>()?;
        families.push(Studied {
            name: file_name(&table.name.get_ref().0)?,
            sweep: run(&text)?,
            rotating: table.rotating.as_ref().map(|file| run(&read_file(&file.get_ref().0)?)).transpose()?,
            in_line: in_line.map(|(_, title, point)| (title, point)),
            volumes,
            flywheels: table
                .flywheel
                .as_ref()
                .map(|flywheel| flywheel.flywheels(name, &parameter[0], read_file))
                .transpose()?,
        });
        texts.push(text);
    }
    let statements = file.statement.iter().map(|said| {
        let (source, kind) = (Some(&file.source), said.kind.as_ref());
        let around = Keys { kind, source, place: said.place.as_ref(), words: said.words.as_ref() };
        let check = |check: &CheckTable| {
            let (kind, place, words) = (check.kind.as_ref(), check.place.as_ref(), check.words.as_ref());
            let keys = Keys { kind, source: None, place, words }.within(around);
            let provenance = keys.provenance().map_err(|error| error.in_file(name, source_text).to_string())?;
            checked(check, provenance, &families, &texts, read_file)
        };
        Ok(Said {
            text: said.text.get_ref().untrusted(),
            conclusion: said.conclusion.get_ref().untrusted(),
            checks: said.check.iter().map(check).collect::<Result<_, String>>()?,
        })
    });
    let statements = statements.collect::<Result<Vec<_>, String>>()?;
    Ok(Study {
        title: file.title.get_ref().untrusted(),
        source: file.source.get_ref().untrusted(),
        families,
        statements,
    })
}

/// The name of a family, which its files begin with.
fn file_name(name: &str) -> Result<String, String> {
    let fits = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-');
    match fits {
        true => Ok(name.to_owned()),
        false => Err(format!("cannot read the name of a family `{name}`: letters, digits and - name its files")),
    }
}

/// End view times length.
fn volume(layout: &Engine) -> Option<f64> {
    let geometry = Geometry::default();
    Some(sweep::section(layout, &geometry)? * sweep::envelope(layout, &geometry)?.length?)
}

pub(super) fn known(template: &Template, values: &[(&Key, &str)]) -> Result<Engine, String> {
    match template.layout(values).map_err(|error| error.to_string())? {
        Layout::Known(layout, _) => Ok(*layout),
        Layout::Open(_) => Err("an engine with unknowns has no single answer".to_owned()),
    }
}

fn flywheels(family: &Studied) -> Result<&Flywheels, String> {
    family.flywheels.as_ref().ok_or_else(|| format!("`{}` has no [family.flywheel]", family.name))
}

/// Where a part of a quantity of the family vanishes.
fn zeros<'a>(family: &'a Studied, part: &Part, of: Zeros) -> Result<&'a sweep::ZeroSet, String> {
    let sets = family.sweep.zeros.iter().flatten();
    let mut sets = sets.filter(|set| set.quantity == part.quantity && set.order == part.order && set.of == of);
    sets.next().ok_or_else(|| format!("`{}` was not computed", part.words))
}

fn checked(
    check: &CheckTable,
    provenance: Provenance,
    families: &[Studied],
    texts: &[String],
    read_file: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Checked, String> {
    let engine = check.engine.get_ref().0.clone();
    let family = families.iter().position(|family| family.name == engine);
    let of_family = || family.map(|index| &families[index]).ok_or_else(|| format!("there is no family `{engine}`"));
    let layout = || {
        let text = match family {
            Some(index) => texts[index].clone(),
            None => read_file(&engine)?,
        };
        let template = Template::new(&engine, &text).map_err(|error| error.to_string())?;
        match (&check.at, family) {
            (Some(at), Some(index)) => {
                let key = &families[index].sweep.parameters[0].key;
                known(&template, &[(key, &at.get_ref().0)])
            }
            (Some(_), None) => Err(format!("`{engine}` is no family, so it has no `at`")),
            (None, _) => known(&template, &[]),
        }
    };
    let at_words = check.at.as_ref().map_or_else(String::new, |at| format!("at {}°: ", at.get_ref().0));
    let (claim, holds, found) = match check.read()? {
        Check::Says(says) => {
            let statement =
                parse_statement(&says).map_err(|mistake| format!("{}; {}", mistake.message, mistake.right))?;
            let answer = super::answer(&layout()?, &statement, None);
            (format!("{at_words}{says}"), answer.status.holds(), Found::Claim(Box::new((statement, answer))))
        }
        Check::Counterweight(expected) => {
            let expected_value = value(&expected, false, Quantity::Force).map_err(|mistake| mistake.message)?;
            let sum = couple(&layout()?).ok_or_else(|| format!("`{engine}` needs no counterweights"))?;
            let (exact, decimal) = (numbers::modulus(&sum), numbers::evaluate(&sum).norm());
            let (status, _) = compare::length(&expected_value, [&sum, &sum], exact.as_ref(), decimal);
            (format!("{at_words}m_cw ρ b = {expected} m r a"), status.holds(), Found::Counterweight(exact))
        }
        Check::VolumeBelow(limit) => {
            let below = parse_number(&limit).map_err(|error| error.to_string())?.to_f64();
            let volumes = &of_family()?.volumes;
            let largest = volumes.iter().skip(1).flatten().copied().reduce(f64::max);
            let part = largest.zip(volumes.first().copied().flatten()).map(|(largest, in_line)| largest / in_line);
            let part = part.ok_or_else(|| format!("`{engine}` has no volumes"))?;
            let claim = format!("every volume is below {limit} times that in line");
            (claim, below.is_some_and(|below| part < below), Found::Volume(part))
        }
        Check::Flywheel { how, at } => {
            let found = flywheels(of_family()?)?.weigh(how);
            (format!("{} {}", how.in_words(), at.in_words()), at.are(&found, true), Found::Grid(found))
        }
        Check::TorqueVanishes { order, at } => {
            let found = flywheels(of_family()?)?.vanishing(order);
            let claim = format!("order {order} of the gas torque vanishes {}", at.in_words());
            (claim, at.are(&found, true), Found::Grid(found))
        }
        Check::Fires { how, at } => {
            let (difference, found) = fires(&of_family()?.sweep, how).ok_or("the cycle is not given")?;
            let claim = format!("{} {}", how.in_words(), at.in_words());
            (claim, at.are(&found, true), Found::Firing { difference, at: found })
        }
        Check::Vanishes { part, at } => {
            let set = zeros(of_family()?, &part, part.of)?;
            let mut found = set.at.clone();
            found.sort();
            let claim = at.as_ref().map_or_else(|| "everywhere".to_owned(), Values::in_words);
            let holds = match &at {
                None => set.everywhere,
                Some(Values::Among(_)) if set.everywhere => true,
                Some(values) => !set.everywhere && values.are(&found, set.complete),
            };
            let found = Found::Values { at: found, everywhere: set.everywhere, complete: set.complete };
            (format!("{} vanishes {claim}", part.words), holds, found)
        }
        Check::Constant { part, at } => {
            // Of constant length where exactly one of the two vectors is left.
            let set = |of| zeros(of_family()?, &part, of);
            let (direct, reverse, both) = (set(Zeros::Direct)?, set(Zeros::Reverse)?, set(Zeros::Largest)?);
            let one_left = direct.at.iter().chain(&reverse.at).filter(|value| !both.at.contains(value));
            let mut found: Vec<BigRational> = one_left.cloned().collect();
            found.sort();
            let complete = direct.complete && reverse.complete && !direct.everywhere && !reverse.everywhere;
            let claim = format!("{} is of constant length {}", part.words, at.in_words());
            (claim, at.are(&found, complete), Found::Values { at: found, everywhere: false, complete })
        }
    };
    let [engine, claim] = [engine, claim].map(Untrusted::new);
    Ok(Checked { engine, provenance, claim, holds, found })
}

/// `m_cw ρ b` of two counterweights in the outermost throws, in multiples of m r and the unit of the positions.
fn couple(layout: &Engine) -> Option<PhasorSum> {
    let subject = ComparableEngine::new(layout).ok()?;
    let throws = throws(subject.engine());
    let ends = [throws.iter().map(|t| &t.position).max()?.clone(), throws.iter().map(|t| &t.position).min()?.clone()];
    let apart = (&ends[0] - &ends[1]).abs();
    let (force, moment) = (subject.force(1, Sense::Direct), subject.moment(1, Sense::Direct));
    let weights = remedy::two_planes(1, Sense::Direct, &force, &moment, &ends);
    Some(weights.first()?.vector.only()?.1.scaled(&apart))
}

/// Where on the grid the firing is so, with the least or the greatest difference of its intervals.
fn fires(sweep: &Sweep, how: Firing) -> Option<(Option<BigRational>, Vec<BigRational>)> {
    let differences: Vec<(BigRational, BigRational)> = sweep
        .points
        .iter()
        .filter_map(|point| Some((point.values.first()?.clone(), point.evenness.as_ref()?.unevenness())))
        .collect();
    let all = differences.iter().map(|(_, difference)| difference);
    let met_by = |bound: &BigRational| {
        let met = differences.iter().filter(|(_, difference)| difference == bound);
        (Some(bound.clone()), met.map(|(value, _)| value.clone()).collect())
    };
    Some(match how {
        Firing::LeastUneven => met_by(all.min()?),
        Firing::MostUneven => met_by(all.max()?),
        Firing::MoreEvenThanBefore => {
            let steps = differences.windows(2).filter(|pair| pair[1].1 < pair[0].1);
            (None, steps.map(|pair| pair[1].0.clone()).collect())
        }
    })
}
