//! `classify`: does force or moment vanish, order by order?

use crankstar::engine::{Draft, Effects, Engine, Family};
use crankstar::file::Layout;
use crankstar::page::Document;
use crankstar::report::{self, data};
use crankstar::{family, loads, verdict};

use super::answer::DataAnswer;
use super::failure::Failure;
use super::firing::{self, ModeShape};
use super::language::LanguageArgs;
use super::masses::Masses;
use super::measures::Measures;
use super::orders::EngineAndOrders;
use super::pages::shown;
use super::verify::proved;
use super::weigh::{DATA_HAS_ALL, OF_KNOWN, Weigh};
use super::{layouts, write};

/// Arguments of `classify`.
#[derive(clap::Args)]
pub struct Classify {
    #[command(flatten)]
    about: EngineAndOrders,
    #[command(flatten)]
    masses: Masses,
    /// Print the verdicts with their certificates as JSON
    #[arg(long, conflicts_with = "format")]
    json: bool,
    /// Prove what vanishes at every order: adds the statements with one period of verdicts to JSON and Coq
    #[arg(long)]
    all_orders: bool,
    /// Decide the inertia torque too
    #[arg(long)]
    torque: bool,
    /// Decide the firing stars, the orders of the gas torque, instead; in a four-stroke engine half orders too
    #[arg(long, conflicts_with_all = ["torque", "masses"])]
    firing: bool,
    #[command(flatten)]
    weigh: Weigh,
    #[command(flatten)]
    mode: ModeShape,
    #[command(flatten)]
    data: DataAnswer,
    #[command(flatten)]
    measures: Measures,
    #[command(flatten)]
    language: LanguageArgs,
}

const UNKNOWNS_IN_COQ: &str =
    "a file of Coq states numbers, and this engine has unknowns; give them values below [values]";

/// The engine as a file has it that asks for the inertia torque: its size is told beside the forces.
fn with_torque(engine: Engine) -> Result<Engine, Failure> {
    let effects = Effects { torque: true, ..engine.effects() };
    Draft { effects, ..engine.into_draft() }.build().map_err(Failure::new)
}

impl Classify {
    /// Prints the verdicts.
    pub fn run(&self) -> Result<(), Failure> {
        let wanted = self.data.wanted("classify", &self.measures)?;
        if self.all_orders && !self.is_json() && !self.data.is_coq() {
            return Err(Failure::misuse("--all-orders adds to the JSON document; add --json, or --format coq"));
        }
        if wanted.is_some() || self.is_json() || self.data.is_coq() {
            self.weigh.are_omitted(DATA_HAS_ALL)?;
        }
        if self.firing {
            self.weigh.are_omitted("are about orders of force and moment; omit them, or --firing")?;
            return self.run_firing(wanted.is_some());
        }
        if self.mode.is_given() {
            return Err(Failure::misuse("--mode-shape weighs firing stars; add --firing"));
        }
        let (layout, orders) = self.about.read()?;
        let engine = match layout {
            Layout::Known(engine, _) => engine,
            Layout::Open(_) if wanted.is_some() => {
                return Err(Failure::new("tables need an engine without unknowns; give them values below [values]"));
            }
            Layout::Open(_) if self.data.is_coq() => {
                return Err(Failure::new(UNKNOWNS_IN_COQ));
            }
            Layout::Open(family) => return self.run_open(&family, &orders),
        };
        if self.torque {
            loads::Missing::unless_torque_is_judged(&engine, "verdicts on the inertia torque").map_err(Failure::new)?;
        }
        let engine = if self.torque { with_torque(*engine)? } else { *engine };
        let weighing = self.weigh.read(&engine, self.about.are_asked())?;
        let quantities = verdict::quantities(&engine, self.torque);
        let judged = self.masses.judge(&engine, &orders, &quantities)?;
        if let Some(wanted) = wanted {
            if self.torque {
                wanted.tell_what_is_in("torque", "--torque");
            }
            let document = report::document(&engine, judged.masses, &judged.orders, &quantities, None);
            return wanted.give(data::classify(&engine, &judged, &document));
        }
        if !self.is_json() && !self.data.is_coq() {
            return self.show(&report::engine_answer_weighed(&engine, &judged, &weighing));
        }
        let theorem = self.all_orders.then(|| verdict::every_order(&engine, judged.masses));
        let theorem = theorem.transpose().map_err(Failure::new)?;
        let document = report::document(&engine, judged.masses, &judged.orders, &quantities, theorem.as_ref());
        if self.data.is_coq() {
            return self.data.show_coq("classify", &report::coq_file(&document).map_err(Failure::new)?);
        }
        self.data.show_json("classify", proved(&document)?)
    }

    fn is_json(&self) -> bool {
        self.json || self.data.is_json()
    }

    fn show(&self, answer: &Document) -> Result<(), Failure> {
        write::to_stdout(&shown(answer, &self.measures.options(self.language.language())))
    }

    fn run_firing(&self, as_tables: bool) -> Result<(), Failure> {
        if as_tables {
            return Err(Failure::misuse(
                "`classify` has no tables of firing stars, `crankstar firing` has them; omit --firing, or take --json",
            ));
        }
        let engine = match layouts::read(&self.about.layout)? {
            Layout::Known(engine, _) => engine,
            Layout::Open(family) => return self.run_open_firing(&family),
        };
        let study = firing::study(&engine, &self.about.orders, &self.mode)?;
        if !self.is_json() && !self.data.is_coq() {
            return self.show(&report::firing_answer(&study));
        }
        if self.all_orders && self.data.is_coq() {
            study.pattern().map_err(Failure::new)?;
        }
        let document = report::firing_document(&study, self.all_orders);
        if self.data.is_coq() {
            return self.data.show_coq("classify", &report::coq_file_of_firing(&document).map_err(Failure::new)?);
        }
        self.data.show_json("classify", proved(&document)?)
    }

    fn run_open_firing(&self, family: &Family) -> Result<(), Failure> {
        if self.is_json() {
            return Err(Failure::new(
                "--json of firing stars needs an engine without unknowns; give them values below [values], or leave --json out",
            ));
        }
        if self.data.is_coq() {
            return Err(Failure::new(UNKNOWNS_IN_COQ));
        }
        let study = firing::open_study(family, &self.about.orders, &self.mode)?;
        self.show(&report::open_firing_answer(&study))
    }

    fn run_open(&self, family: &Family, orders: &[u32]) -> Result<(), Failure> {
        if self.torque || self.all_orders || self.masses.are_given() {
            return Err(Failure::new(
                "--torque, --all-orders and --masses need an engine without unknowns; give them values below [values]",
            ));
        }
        self.weigh.are_omitted(OF_KNOWN)?;
        family::comparable(family).map_err(Failure::new)?;
        let verdicts = family::classify(family, orders).map_err(Failure::new)?;
        match self.is_json() {
            true => self.data.show_json("classify", proved(&report::open_document(family, &verdicts))?),
            false => self.show(&report::family_answer(family, &verdicts)),
        }
    }
}
