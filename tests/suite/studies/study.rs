//! Is it true, what is said about a family of engines? A study: families with their sweeps, statements with checks.

use crankstar::claim::{Answer, Provenance, Quote, Statement};
use crankstar::engine::Engine;
use crankstar::file::{Key, Layout, Template};
use crankstar::numbers::Form;
use crankstar::sweep::{self, Geometry, Parameter, Sweep, SweptEngine};
use crankstar::text::Untrusted;
use num_rational::BigRational;
use serde::Deserialize;

use super::check::CheckTable;
use super::checked::checked;
use super::flywheels::{FlywheelTable, Flywheels};
use super::section::section;

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
    title: Word,
    source: Word,
    orders: Vec<Word>,
    family: Vec<FamilyTable>,
    statement: Vec<StatementTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FamilyTable {
    name: Word,
    layout: Word,
    rotating: Option<Word>,
    in_line: Option<Word>,
    sweep: Word,
    flywheel: Option<FlywheelTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementTable {
    text: Word,
    kind: Option<Word>,
    place: Option<Word>,
    words: Option<Word>,
    conclusion: Word,
    check: Vec<CheckTable>,
}

/// A number or a text, as written.
#[derive(Clone, Deserialize)]
#[serde(from = "toml::Value")]
pub(super) struct Word(pub String);

impl From<toml::Value> for Word {
    fn from(value: toml::Value) -> Self {
        match value {
            toml::Value::String(text) => Word(text),
            number => Word(number.to_string()),
        }
    }
}

impl Word {
    fn untrusted(&self) -> Untrusted {
        Untrusted::new(self.0.as_str())
    }
}

impl StatementTable {
    /// Who says what is checked: the source, at the place of the check or else of the statement, or nobody.
    fn provenance(&self, check: &CheckTable, source: &Word) -> Provenance {
        let of = |own: &Option<Word>, around: &Option<Word>| own.as_ref().or(around.as_ref()).map(Word::untrusted);
        let kind = check.kind.as_ref().or(self.kind.as_ref().filter(|_| check.place.is_none()));
        let quote = of(&check.place, &self.place).zip(of(&check.words, &self.words));
        match (kind.map(|kind| kind.0.as_str()), quote) {
            (Some("own"), _) | (None, None) => Provenance::Own,
            (None, Some((place, words))) => Provenance::Quoted(Quote { source: source.untrusted(), place, words }),
            (kind, _) => panic!("a check of `{}` of the kind {kind:?}", check.engine.0),
        }
    }
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
    let file: File = toml::from_str(source_text).map_err(|error| error.to_string())?;
    let number = |text: &Word| text.0.parse::<u32>().map_err(|_| format!("`{}` is not an order", text.0));
    let orders = file.orders.iter().map(number).collect::<Result<Vec<_>, _>>()?;
    let mut families = Vec::new();
    let mut texts = Vec::new();
    for table in &file.family {
        let text = read_file(&table.layout.0)?;
        let parameter = [Parameter::parse(&table.sweep.0).map_err(|error| error.to_string())?];
        let run = |text: &str| {
            let template = Template::new(name, text).map_err(|error| error.to_string())?;
            sweep::sweep(&template, &parameter, &orders, &Geometry::default()).map_err(|error| error.to_string())
        };
        let in_line = |file: &Word| {
            let text = read_file(&file.0)?;
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
            name: file_name(&table.name.0)?,
            sweep: run(&text)?,
            rotating: table.rotating.as_ref().map(|file| run(&read_file(&file.0)?)).transpose()?,
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
        let check = |check: &CheckTable| {
            let provenance = said.provenance(check, &file.source);
            checked(check, provenance, &families, &texts, read_file)
        };
        Ok(Said {
            text: said.text.untrusted(),
            conclusion: said.conclusion.untrusted(),
            checks: said.check.iter().map(check).collect::<Result<_, String>>()?,
        })
    });
    let statements = statements.collect::<Result<Vec<_>, String>>()?;
    Ok(Study { title: file.title.untrusted(), source: file.source.untrusted(), families, statements })
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
    Some(section(layout, &geometry)? * sweep::envelope(layout, &geometry)?.length?)
}

pub(super) fn known(template: &Template, values: &[(&Key, &str)]) -> Result<Engine, String> {
    match template.layout(values).map_err(|error| error.to_string())? {
        Layout::Known(layout, _) => Ok(*layout),
        Layout::Open(_) => Err("an engine with unknowns has no single answer".to_owned()),
    }
}
