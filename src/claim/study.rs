//! Is it true, what is said about a family of engines? A study: families with their sweeps, statements with checks.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use serde::Deserialize;

use super::answer::Answer;
use super::grammar::parse_statement;
use super::statement::Statement;
use crate::layout::written::{Text, read};
use crate::layout::{Engine, Key, Layout, LayoutError, Template, parse_number, throws};
use crate::numbers::Form;
use crate::proof::{Quantity, Sense};
use crate::remedy::{self, Subject};
use crate::sweep::{self, Geometry, Parameter, Point, Sweep, Zeros};
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
    pub in_line: Option<(Untrusted, Point)>,
    /// End view times length in cubes of the crank radius: of the engine in line, where there is one, and of each point.
    pub volumes: Vec<Option<f64>>,
}

/// A statement, and what was checked for it.
#[derive(Clone, Debug)]
pub struct Said {
    /// The statement.
    pub text: Untrusted,
    /// Where it stands.
    pub place: Untrusted,
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
    /// The least or the greatest difference of firing intervals on the grid in turns, and where it is met.
    Firing {
        /// The difference.
        difference: BigRational,
        /// The values of the grid.
        at: Vec<BigRational>,
    },
    /// `m_cw ρ b` in multiples of m r a, in closed form.
    Counterweight(Option<Form>),
    /// The largest volume of the family as a part of that of the engine in line.
    Volume(f64),
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
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementTable {
    text: Text,
    place: Text,
    conclusion: Text,
    check: Vec<CheckTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CheckTable {
    /// A family, or the path of a layout file.
    engine: Text,
    /// The value of the family's parameter that `says` is about.
    at: Option<Text>,
    /// A claim about one engine.
    says: Option<Text>,
    /// `moment 2 along`: what vanishes at the values `only_at` of the range, and nowhere else in it.
    vanishes: Option<Text>,
    /// `moment 1`: what has constant length at the values `only_at`, and nowhere else.
    constant: Option<Text>,
    /// `least` or `most` even firing of the grid is met at `only_at`, and nowhere else on it.
    firing: Option<Text>,
    only_at: Option<Vec<Text>>,
    /// `m_cw ρ b` in multiples of m r a.
    counterweight: Option<Text>,
    /// The factor that no volume of the family reaches, of that of the engine in line.
    volume_below: Option<Text>,
}

/// Reads a study and answers its checks; `read_file` gives the text of a file beside it.
///
/// # Errors
/// What cannot be read, in one line.
pub fn study(name: &str, source: &str, read_file: &dyn Fn(&str) -> Result<String, String>) -> Result<Study, String> {
    let file: File = read(source).map_err(|error: LayoutError| error.in_file(name, source).to_string())?;
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
            Ok::<_, String>((volume(&layout), layout.title.clone(), point))
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
        });
        texts.push(text);
    }
    let statements = file.statement.iter().map(|said| {
        let check = |check: &CheckTable| checked(check, &families, &texts, read_file);
        Ok(Said {
            text: said.text.get_ref().untrusted(),
            place: said.place.get_ref().untrusted(),
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
fn volume(layout: &Layout) -> Option<f64> {
    let geometry = Geometry::default();
    Some(sweep::section(layout, &geometry)? * sweep::envelope(layout, &geometry)?.length?)
}

fn known(template: &Template, values: &[(&Key, &str)]) -> Result<Layout, String> {
    match template.engine(values).map_err(|error| error.to_string())? {
        Engine::Known(layout, _) => Ok(*layout),
        Engine::Open(_) => Err("an engine with unknowns has no single answer".to_owned()),
    }
}

fn checked(
    check: &CheckTable,
    families: &[Studied],
    texts: &[String],
    read_file: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Checked, String> {
    let engine = check.engine.get_ref().0.clone();
    let family = families.iter().position(|family| family.name == engine);
    let of_family = || family.map(|index| &families[index]).ok_or_else(|| format!("there is no family `{engine}`"));
    let text = match family {
        Some(index) => texts[index].clone(),
        None => read_file(&engine)?,
    };
    let template = Template::new(&engine, &text).map_err(|error| error.to_string())?;
    let layout = || match (&check.at, family) {
        (Some(at), Some(index)) => {
            let key = &families[index].sweep.parameters[0].key;
            known(&template, &[(key, &at.get_ref().0)])
        }
        _ => known(&template, &[]),
    };
    let at_words = check.at.as_ref().map_or_else(String::new, |at| format!("at {}°: ", at.get_ref().0));
    let values = || {
        let texts = check.only_at.iter().flatten();
        let value = |text: &Text| parse_number(&text.get_ref().0).map_err(|error| error.to_string());
        texts.map(value).collect::<Result<Vec<_>, String>>()
    };
    if let Some(says) = &check.says {
        let says = &says.get_ref().0;
        let statement = parse_statement(says).map_err(|mistake| format!("{}; {}", mistake.message, mistake.right))?;
        let answer = super::answer(&layout()?, &statement, None);
        return Ok(Checked {
            claim: Untrusted::new(format!("{at_words}{says}")),
            engine: Untrusted::new(engine),
            holds: answer.status.holds(),
            found: Found::Claim(Box::new((statement, answer))),
        });
    }
    if let Some(expected) = &check.counterweight {
        let expected = &expected.get_ref().0;
        let form = Form::parse(expected).ok_or_else(|| format!("`{expected}` is no closed form"))?;
        let found = couple(&layout()?);
        return Ok(Checked {
            claim: Untrusted::new(format!("{at_words}m_cw ρ b = {expected} m r a")),
            engine: Untrusted::new(engine),
            holds: found.as_ref() == Some(&form),
            found: Found::Counterweight(found),
        });
    }
    if let Some(limit) = &check.volume_below {
        let limit = &limit.get_ref().0;
        let below = parse_number(limit).map_err(|error| error.to_string())?.to_f64();
        let volumes = &of_family()?.volumes;
        let in_line = volumes.first().copied().flatten();
        let largest = volumes.iter().skip(1).flatten().copied().reduce(f64::max);
        let Some(part) = largest.zip(in_line).map(|(largest, in_line)| largest / in_line) else {
            return Err(format!("`{engine}` has no volumes"));
        };
        let claim = format!("every volume is below {limit} times that in line");
        return Ok(Checked {
            claim: Untrusted::new(claim),
            engine: Untrusted::new(engine),
            holds: below.is_some_and(|below| part < below),
            found: Found::Volume(part),
        });
    }
    if let Some(which) = &check.firing {
        let which = &which.get_ref().0;
        let (difference, at) = extreme(&of_family()?.sweep, which == "most").ok_or("the cycle is not given")?;
        let claim = format!("the {which} uneven firing of the grid is that {}", listed(&values()?));
        return Ok(Checked {
            claim: Untrusted::new(claim),
            engine: Untrusted::new(engine),
            holds: at == values()?,
            found: Found::Firing { difference, at },
        });
    }
    let family = of_family()?;
    let (words, constant) = match (&check.vanishes, &check.constant) {
        (Some(words), None) => (&words.get_ref().0, false),
        (None, Some(words)) => (&words.get_ref().0, true),
        _ => return Err(format!("a check of `{engine}` that says nothing, or two things")),
    };
    let (quantity, order, of) = named(words, constant)?;
    let sets = family.sweep.zeros.iter().flatten().filter(|set| set.quantity == quantity && set.order == order);
    let set = |of: Zeros| sets.clone().find(|set| set.of == of).ok_or_else(|| format!("`{words}` was not computed"));
    let (mut at, everywhere, complete) = if constant {
        // Of constant length where exactly one of the two vectors is left.
        let (direct, reverse, both) = (set(Zeros::Direct)?, set(Zeros::Reverse)?, set(Zeros::Largest)?);
        let at: Vec<BigRational> =
            direct.at.iter().chain(&reverse.at).filter(|value| !both.at.contains(value)).cloned().collect();
        (at, false, direct.complete && reverse.complete)
    } else {
        let set = set(of)?;
        (set.at.clone(), set.everywhere, set.complete)
    };
    at.sort();
    let wanted = values()?;
    let claim = match (constant, check.only_at.is_some()) {
        (true, _) => format!("{words} is of constant length {}", listed(&wanted)),
        (false, true) => format!("{words} vanishes {}", listed(&wanted)),
        (false, false) => format!("{words} vanishes everywhere"),
    };
    let holds = if check.only_at.is_some() { at == wanted && !everywhere && complete } else { everywhere };
    Ok(Checked {
        engine: Untrusted::new(engine),
        claim: Untrusted::new(claim),
        holds,
        found: Found::Values { at, everywhere, complete },
    })
}

fn listed(values: &[BigRational]) -> String {
    let texts: Vec<String> = values.iter().map(|value| format!("{value}°")).collect();
    if texts.is_empty() { "nowhere".to_owned() } else { format!("only at {}", texts.join(", ")) }
}

/// `moment 2 along`, `force 1`.
fn named(words: &str, constant: bool) -> Result<(Quantity, u32, Zeros), String> {
    let parts: Vec<&str> = words.split_whitespace().collect();
    let quantity = match parts.first() {
        Some(&"moment") => Some(Quantity::Moment),
        Some(&"force") => Some(Quantity::Force),
        _ => None,
    };
    let order = parts.get(1).and_then(|text| text.parse().ok());
    let of = match parts.get(2) {
        None => Some(Zeros::Largest),
        Some(&"along") => Some(Zeros::Along),
        Some(&"across") => Some(Zeros::Across),
        Some(&"direct") => Some(Zeros::Direct),
        Some(&"reverse") => Some(Zeros::Reverse),
        Some(_) => None,
    };
    match (quantity, order, of, parts.len()) {
        (Some(quantity), Some(order), Some(of), 2..=3) if !constant || parts.len() == 2 => Ok((quantity, order, of)),
        _ => Err(format!("cannot read `{words}`; such as `moment 2 along`")),
    }
}

/// `m_cw ρ b` of two counterweights in the outermost throws, in multiples of m r and the unit of the positions.
fn couple(layout: &Layout) -> Option<Form> {
    let subject = Subject::new(layout).ok()?;
    let throws = throws(subject.layout());
    let ends = [throws.iter().map(|t| &t.position).max()?.clone(), throws.iter().map(|t| &t.position).min()?.clone()];
    let apart = (&ends[0] - &ends[1]).abs();
    let (force, moment) = (subject.force(1, Sense::Direct), subject.moment(1, Sense::Direct));
    let weights = remedy::two_planes(1, Sense::Direct, &force, &moment, &ends);
    Some(weights.first()?.modulus()?.scaled(&apart))
}

/// The least or greatest difference of firing intervals on the grid, and where it is met.
fn extreme(sweep: &Sweep, most: bool) -> Option<(BigRational, Vec<BigRational>)> {
    let differences: Vec<(BigRational, BigRational)> = sweep
        .points
        .iter()
        .filter_map(|point| Some((point.values.first()?.clone(), point.evenness.as_ref()?.unevenness())))
        .collect();
    let all = differences.iter().map(|(_, difference)| difference);
    let found = if most { all.max()?.clone() } else { all.min()?.clone() };
    let met = differences.into_iter().filter(|(_, difference)| *difference == found);
    let at = met.map(|(value, _)| value).collect();
    Some((found, at))
}
