//! What stands on a report, in which order? Finished strings for the templates.

use serde::Serialize;

use super::accuracy_page::{AccuracySection, accuracy_section};
use super::accuracy_words::AccuracyCase;
use super::calculation::{self, Calculation, Numbers};
use super::dialect::Dialect;
use super::figure::Figure;
use super::folder::File;
use super::open_page::OpenPage;
use super::remedy::remedy_section;
use super::star::{star_figure, torque_figure};
use super::svg;
use super::table::{self, Table};
use super::theorem::{self, first_survivors};
use super::views::{end_view, side_view};
use super::{argument, firmness, residual, tikz, typeset};
use crate::engine::{Cycle, DOES_NOT_EXIST, Engine, Family, Firing, WHY_NOT};
use crate::family::OpenOrder;
use crate::loads::{Missing, Needed};
use crate::order::{Masses, Source};
use crate::proof::Sense;
use crate::remedy::{self, Remedy, RemedyError, Wish};
use crate::verdict::{
    self, Balance, Judgement, NoTheorem, OrderBalance, OrderVerdict, Theorem, TorquePart, Verdict, WholeOrder,
};

/// Everything that the template of a report places.
#[derive(Clone, Debug, Serialize)]
pub struct Page {
    title: String,
    title_block: Option<Table>,
    objective: Option<String>,
    source: Option<String>,
    headline: Vec<String>,
    whose: Option<String>,
    summary: Table,
    pistons: Option<Table>,
    units: String,
    end_view: Drawing,
    side_view: Drawing,
    cylinders: Table,
    firing: Vec<String>,
    firmness: Option<firmness::Section>,
    conventions: Vec<String>,
    force_formula: String,
    phase_formulas: String,
    bank_remark: Option<String>,
    orders: Vec<Section>,
    open: Option<OpenPage>,
    torque: Option<TorqueSection>,
    every_order: theorem::Section,
    calculation: Option<Calculation>,
    remedy: Option<String>,
    accuracy: Option<AccuracySection>,
    file: Vec<String>,
    fence: String,
}

/// One order.
#[derive(Clone, Debug, Serialize)]
struct Section {
    heading: String,
    table: Table,
    stars: Drawing,
    force: Vec<Paragraph>,
    force_left: String,
    moment: Vec<Paragraph>,
    moment_left: String,
    /// After the last sum of an order that has several: what is known of all together.
    whole: Vec<String>,
}

/// The inertia torque: its star at each order, with the proofs.
#[derive(Clone, Debug, Serialize)]
struct TorqueSection {
    formula: String,
    stars: Drawing,
    orders: Vec<Paragraph>,
}

/// A verdict with its proof.
#[derive(Clone, Debug, Serialize)]
struct Paragraph {
    lead: String,
    proof: String,
    certificate: String,
}

/// A drawing as the template needs it: the name of its file, or the TikZ code itself.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Drawing {
    caption: String,
    body: String,
}

/// What a report shows of an engine.
#[derive(Clone, Copy)]
pub struct Contents<'a> {
    /// The engine.
    pub engine: &'a Engine,
    /// The verdicts on it.
    pub judged: &'a Judgement,
    /// The family that it is a member of, judged, where the file gives values to symbols.
    pub family: Option<(&'a Family, &'a [OpenOrder])>,
    /// The choice of the orders, where it was made by an accuracy.
    pub needed: Option<&'a Needed>,
    /// The errors of the methods for the peak loads, where they are asked for.
    pub accuracy: Option<&'a AccuracyCase>,
}

impl Contents<'_> {
    /// The remedy for orders 1 and 2, where the file asks for it.
    pub(super) fn remedy(&self) -> Option<Result<Remedy, RemedyError>> {
        let orders = [1, 2].into_iter().filter(|order| self.judged.orders.iter().any(|judged| judged.order == *order));
        let wish = Wish { orders: orders.collect(), ..Wish::default() };
        self.engine.effects().remedy.then(|| remedy::remedy(self.engine, &wish))
    }

    /// The numbers of the engine, where its file gives any.
    pub(super) fn numbers(&self) -> Option<Result<Numbers, Missing>> {
        let orders: Vec<u32> = self.judged.orders.iter().map(|order| order.order).collect();
        calculation::numbers_of(self.engine, &orders, self.needed)
    }
}

/// A drawing with the file that it goes to.
pub(super) struct NamedFigure {
    pub name: String,
    pub caption: String,
    pub figure: Figure,
}

impl NamedFigure {
    /// The SVG file of the drawing.
    pub fn into_svg(self) -> File {
        File { text: svg(&self.figure, &self.caption), name: format!("{}.svg", self.name) }
    }
}

/// A sum of an order as a report shows it: with its star and its proofs.
struct StarOf<'a> {
    balance: &'a OrderBalance,
    /// `2`, `2 (cylinders 1–3, λ = 0.25)`, `1, the pistons alone`.
    title: String,
    /// The name of its drawing.
    file: String,
    /// Of the last sum of an order that has several: the order as a whole.
    whole: Option<&'a OrderVerdict>,
}

/// The sums that a report shows: of each order, then of the pistons alone where those differ.
fn stars(judged: &Judgement) -> Vec<StarOf<'_>> {
    let mut all = Vec::new();
    for order in &judged.orders {
        all.extend(of_order(order, "", ""));
        let pistons = judged.differing().filter(|pistons| pistons.order == order.order);
        all.extend(pistons.flat_map(|pistons| of_order(pistons, ", the pistons alone", "-pistons")));
    }
    all
}

/// How the masses that turn are called on a star.
const TURNING_LABELS: &str = " Beside the cylinders: rod, pin, webs and cw (counterweight) with their numbers, shaft for a balancer; +6 stands for six \
                              masses that turn.";

fn has_turning(balance: &OrderBalance) -> bool {
    let sources = balance.force.verdicts().into_iter().flat_map(|verdict| &verdict.sources);
    sources.into_iter().any(|source| !matches!(source, Source::Piston(_)))
}

fn of_order<'a>(order: &'a OrderVerdict, name: &str, file: &str) -> Vec<StarOf<'a>> {
    let several = order.parts.len() > 1;
    let star = |(index, balance): (usize, &'a OrderBalance)| StarOf {
        balance,
        title: format!("{}{name}", residual::order_name(balance)),
        file: match several {
            true => format!("order-{}{file}-class-{}", order.order, index + 1),
            false => format!("order-{}{file}", order.order),
        },
        whole: (several && index + 1 == order.parts.len()).then_some(order),
    };
    order.parts.iter().enumerate().map(star).collect()
}

/// All drawings of a report: the two views, then the stars of each order.
pub(super) fn figures(engine: &Engine, judged: &Judgement) -> Vec<NamedFigure> {
    let named = |name: String, caption: String, figure| NamedFigure { name, caption, figure };
    let mut figures = vec![
        named(
            "end-view".into(),
            "Seen from the free end at θ = 0, angle 0 upwards, angles anticlockwise: crankpins inside, cylinders outside.".into(),
            end_view(engine),
        ),
        named(
            "side-view".into(),
            "The crankshaft from the side with the throw angles below, the cylinders above, and the reference plane of the moments dashed.".into(),
            side_view(engine),
        ),
    ];
    figures.extend(stars(judged).into_iter().map(|star| {
        let caption = format!(
            "Vector stars of order {}, angle 0 upwards. Coloured polygons sum to zero; a red arrow is the resultant; a vector \
             with a negative arm is drawn turned by 180°.{}",
            star.title,
            if has_turning(star.balance) { TURNING_LABELS } else { "" }
        );
        named(star.file, caption, star_figure(engine, star.balance))
    }));
    figures
}

impl Page {
    /// Sets a report in a dialect.
    pub fn new(subject: Contents, numbers: Option<&Result<Numbers, Missing>>, dialect: Dialect) -> Self {
        let Contents { engine, judged, family, needed, accuracy } = subject;
        let mut drawings = figures(engine, judged).into_iter().map(|figure| drawing(figure, dialect));
        let mut next = || drawings.next().unwrap_or_else(|| unreachable!("one drawing a view and an order"));
        let (end_view, side_view) = (next(), next());
        let theorem = match verdict::theorem(engine, judged.masses) {
            // The pistons have a pattern even where a shaft has none.
            Err(NoTheorem::Shaft(_)) => verdict::theorem(engine, Masses::Reciprocating),
            other => other,
        };
        let calculation = numbers.map(|numbers| {
            let loads = numbers.as_ref().map(|numbers| &numbers.loads);
            let figures = loads.map_or_else(|_| Vec::new(), |loads| calculation::figures(engine, loads));
            let plots = figures.into_iter().map(|figure| drawing(figure, dialect)).collect();
            Calculation::new(engine, numbers, needed, plots, dialect)
        });
        let block = engine.title_block();
        let has_banks = engine.cylinders().iter().any(|cylinder| cylinder.bank != crate::exact::Turn::zero());
        Page {
            title: dialect.quoted(engine.title()),
            title_block: title_block(engine, dialect),
            objective: block.objective.as_ref().map(|objective| dialect.quoted(objective)),
            source: engine.source().map(|source| dialect.quoted(source)),
            headline: headlines(judged, theorem.as_ref().ok()).iter().map(|line| dialect.prose(line)).collect(),
            summary: table::summary(dialect, engine, &judged.orders, firmness_of(judged.masses)),
            whose: residual::whose_masses(engine, judged)
                .map(|words| {
                    [words.as_str()].into_iter().chain(residual::turning_unit(judged)).collect::<Vec<_>>().join(" ")
                })
                .map(|words| dialect.prose(&words)),
            pistons: judged
                .pistons
                .as_ref()
                .map(|pistons| table::summary(dialect, engine, pistons, table::Firmness::Shown)),
            units: dialect.prose(&units(engine)),
            end_view,
            side_view,
            cylinders: table::cylinders(dialect, engine),
            firing: firing(engine).iter().map(|line| dialect.prose(line)).collect(),
            firmness: (engine.mechanisms().len() < 2)
                .then(|| firmness::Section::new(dialect, engine, judged.pistons.as_ref().unwrap_or(&judged.orders)))
                .flatten(),
            conventions: conventions(engine).iter().map(|line| dialect.prose(line)).collect(),
            force_formula: dialect.display(FORCE),
            phase_formulas: dialect.display(PHASES),
            bank_remark: has_banks.then(|| dialect.prose(BANKS)),
            orders: stars(judged).iter().map(|star| Section::new(engine, star, dialect, next())).collect(),
            open: family.map(|(family, orders)| OpenPage::new(family, orders, dialect)),
            torque: torque_section(engine, judged, numbers, dialect),
            every_order: theorem::Section::new(engine, &theorem, dialect),
            calculation,
            remedy: subject.remedy().map(|remedy| match remedy {
                Ok(remedy) => remedy_section(&remedy, dialect),
                Err(refused) => dialect.prose(&format!("No remedy: {refused}.")),
            }),
            accuracy: accuracy.map(|case| accuracy_section(dialect, std::slice::from_ref(case))),
            file: engine.file().written().lines().map(|line| dialect.verbatim(line)).collect(),
            fence: fence(engine.file().written()),
        }
    }
}

/// The verdicts on the inertia torque, where the file asks for it: at the orders that it has numbers of, else at the first and
/// those of force and moment; one per mechanism where they differ.
pub(super) fn torque_verdicts(
    engine: &Engine,
    judged: &Judgement,
    numbers: Option<&Result<Numbers, Missing>>,
) -> Vec<TorquePart> {
    if !engine.effects().torque {
        return Vec::new();
    }
    let in_numbers = numbers.and_then(|numbers| numbers.as_ref().ok()?.loads.torque.as_ref());
    let orders: Vec<u32> = match in_numbers {
        Some(torque) => torque.orders.iter().map(|order| order.order).collect(),
        None => verdict::torque_orders(&judged.orders.iter().map(|order| order.order).collect::<Vec<_>>()),
    };
    let judged = verdict::torque(engine, &orders);
    let judged = judged.unwrap_or_else(|number| unreachable!("these orders were judged: {number}"));
    judged.into_iter().flat_map(|torque| torque.parts).collect()
}

/// The drawing of the stars of the inertia torque.
pub(super) fn torque_stars(engine: &Engine, parts: &[TorquePart]) -> NamedFigure {
    NamedFigure {
        name: "torque-stars".into(),
        caption: "Vector stars of the inertia torque, angle 0 upwards. Coloured polygons sum to zero; a red arrow is the resultant.".into(),
        figure: torque_figure(engine, &parts.iter().map(|part| &part.verdict).collect::<Vec<_>>()),
    }
}

fn torque_section(
    engine: &Engine,
    judged: &Judgement,
    numbers: Option<&Result<Numbers, Missing>>,
    dialect: Dialect,
) -> Option<TorqueSection> {
    let parts = torque_verdicts(engine, judged, numbers);
    let paragraph = |part: &TorquePart| {
        let of = part.class.as_ref().map(|class| format!(" ({})", residual::class_sources(class)));
        Paragraph::named(engine, &part.verdict, "Q", &of.unwrap_or_default(), dialect)
    };
    (!parts.is_empty()).then(|| TorqueSection {
        formula: dialect.display(TORQUE),
        stars: drawing(torque_stars(engine, &parts), dialect),
        orders: parts.iter().map(paragraph).collect(),
    })
}

const TORQUE: &str = "Q_k = \\sum_j m_j\\, r_j^2\\, e^{ik(\\beta_j - \\alpha_j)}";
const FORCE: &str = "F_k(\\theta) = \\tfrac12\\, r\\, \\omega^2 c_k \\left( P_k^{+} e^{ik\\theta} + P_k^{-} e^{-ik\\theta} \\right) \\tag{1}";
const PHASES: &str = "P_k^{+} = \\sum_j m_j\\, e^{i(k\\beta_j - (k-1)\\alpha_j)}, \\qquad P_k^{-} = \\sum_j m_j\\, e^{i(-k\\beta_j + (k+1)\\alpha_j)} \\tag{2}";
const BANKS: &str = "Between two banks an angle φ apart the direct phases of order k differ by (k − 1)φ and the reverse \
                     ones by (k + 1)φ: by 0 and 2φ at order 1, φ and 3φ at order 2, 3φ and 5φ at order 4, 5φ and 7φ at order 6.";

pub(super) fn drawing(named: NamedFigure, dialect: Dialect) -> Drawing {
    let body = match dialect {
        Dialect::Latex => tikz(&named.figure),
        _ => format!("{}.svg", named.name),
    };
    Drawing { caption: dialect.prose(&named.caption), body }
}

impl Section {
    fn new(engine: &Engine, star: &StarOf, dialect: Dialect, stars: Drawing) -> Self {
        let order = star.balance;
        let paragraphs = |balance: &Balance, symbol: &str| {
            let paragraph = |verdict: &Verdict| Paragraph::named(engine, verdict, symbol, "", dialect);
            balance.verdicts().into_iter().map(paragraph).collect()
        };
        let whole = star.whole.map(|order| {
            let whole = [("Force", &order.force), ("Moment", &order.moment)];
            whole.map(|(name, whole)| dialect.prose(&residual::whole_sentence(name, order.order, whole))).to_vec()
        });
        Section {
            heading: dialect.prose(&format!("Order {}", star.title)),
            table: table::vector_star(dialect, engine, order),
            stars,
            force: paragraphs(&order.force, "P"),
            force_left: dialect.prose(&match order.exists {
                true => residual::sentence(&order.force),
                false => missing(order),
            }),
            moment: paragraphs(&order.moment, "C"),
            moment_left: dialect.prose(&match order.exists {
                true => moment_left(engine, order),
                false => missing(order),
            }),
            whole: whole.unwrap_or_default(),
        }
    }
}

/// Of a star without an order.
fn missing(order: &OrderBalance) -> String {
    format!("Whatever the sums are, order {} {DOES_NOT_EXIST}. {WHY_NOT}", order.order)
}

fn moment_left(engine: &Engine, order: &OrderBalance) -> String {
    let kind = if order.moment_is_couple() {
        "The force of this order vanishes, so the moment is a free couple: the same about every plane.".to_owned()
    } else {
        let plane = typeset::number(engine.reference_plane());
        format!(
            "The force of this order does not vanish, so the moment depends on the reference plane, here z = {plane}."
        )
    };
    format!("{} {kind}", residual::sentence(&order.moment).replace("P_{", "C_{"))
}

impl Paragraph {
    /// `of` says whose sum it is, where that needs saying.
    fn named(engine: &Engine, verdict: &Verdict, symbol: &str, of: &str, dialect: Dialect) -> Self {
        let sense = match verdict.sense {
            Some(Sense::Direct) => "+",
            Some(Sense::Reverse) => "-",
            None => "",
        };
        let name =
            verdict.sense.map_or_else(|| format!("order {}{of}", verdict.order), |sense| sense.name().to_owned());
        let symbol = match verdict.sense {
            Some(_) => format!("{symbol}_{{{}}}^{{{sense}}}", verdict.order),
            None => format!("{symbol}_{{{}}}", verdict.order),
        };
        let lead = match verdict.vanishes() {
            true => format!("**{}:** ${symbol} = 0$.", capital(&name)),
            false => format!(
                "**{}:** ${symbol} \\ne 0$, length {}, angle {}.",
                capital(&name),
                residual::modulus(verdict).prose(),
                residual::bearing(&verdict.sum).prose()
            ),
        };
        Paragraph {
            lead: dialect.prose(&lead),
            proof: dialect.prose(&argument::argument(engine, verdict)),
            certificate: dialect.prose(&argument::certificate(verdict)),
        }
    }
}

fn title_block(engine: &Engine, dialect: Dialect) -> Option<Table> {
    let rows: Vec<Vec<String>> = engine
        .title_block()
        .rows
        .iter()
        .map(|(name, written)| vec![(*name).to_owned(), dialect.quoted(written)])
        .collect();
    (!rows.is_empty()).then(|| Table { header: vec![String::new(); 2], rows, size: "\\small" })
}

/// Backticks that no run in the file is as long as.
fn fence(file: &str) -> String {
    let longest = file.split(|letter| letter != '`').map(str::len).max().unwrap_or(0);
    "`".repeat((longest + 1).max(3))
}

pub(super) fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// What a designer reads first: which orders are balanced, which are left, and which of all orders is the first left.
fn headlines(judged: &Judgement, theorem: Option<&Theorem>) -> Vec<String> {
    let named = |name: &str, orders: &[OrderVerdict]| format!("**{name}.** {}", headline(orders).join(" "));
    let lines: Vec<String> = match &judged.pistons {
        None => headline(&judged.orders),
        Some(pistons) => vec![named(residual::AS_BUILT, &judged.orders), named(residual::PISTONS_ALONE, pistons)],
    };
    let mut missing: Vec<String> =
        judged.orders.iter().filter(|order| !order.exists()).map(|order| order.order.to_string()).collect();
    missing.dedup();
    let missing = (!missing.is_empty()).then(|| {
        let verb = if missing.len() == 1 { DOES_NOT_EXIST } else { "do not exist" };
        format!("{} of force and moment {verb}. {}", capital(&plural(&missing)), residual::why_not(judged.masses))
    });
    let survivors = theorem.map(|theorem| match theorem.masses == judged.masses {
        true => first_survivors(theorem),
        false => format!("Of the pistons alone: {}", first_survivors(theorem)),
    });
    lines.into_iter().chain(missing).chain(survivors).collect()
}

/// Where force and moment vanish, are left, and are not decided.
fn headline(orders: &[OrderVerdict]) -> Vec<String> {
    let orders: Vec<&OrderVerdict> = orders.iter().filter(|order| order.exists()).collect();
    let line = |name: &str, whole: fn(&OrderVerdict) -> &WholeOrder| {
        let list = |is_meant: &dyn Fn(&WholeOrder) -> bool| -> Vec<String> {
            orders.iter().filter(|order| is_meant(whole(order))).map(|order| order.order.to_string()).collect()
        };
        let zero = list(&WholeOrder::is_balanced);
        let left = list(&WholeOrder::is_left);
        let open = list(&|whole| !whole.is_balanced() && !whole.is_left());
        let words = match (zero.as_slice(), left.as_slice()) {
            (all, []) if open.is_empty() => format!("The {name} vanishes at every order judged: {}.", all.join(", ")),
            ([], none) if open.is_empty() => {
                format!("The {name} vanishes at none of the orders judged: {}.", none.join(", "))
            }
            ([], []) => String::new(),
            ([], rest) => format!("The {name} does not vanish at {}.", plural(rest)),
            (zero, []) => format!("The {name} vanishes at {}.", plural(zero)),
            (zero, rest) => format!("The {name} vanishes at {}, and not at {}.", plural(zero), plural(rest)),
        };
        let open =
            (!open.is_empty()).then(|| format!("Whether the {name} vanishes at {} is not decided.", plural(&open)));
        [words].into_iter().filter(|words| !words.is_empty()).chain(open).collect::<Vec<_>>().join(" ")
    };
    match orders.is_empty() {
        true => Vec::new(),
        false => vec![line("force", |order| &order.force), line("moment", |order| &order.moment)],
    }
}

/// Firmness is that of the pistons' zeros.
fn firmness_of(masses: Masses) -> table::Firmness {
    match masses {
        Masses::Reciprocating => table::Firmness::Shown,
        Masses::Rotating | Masses::Counterweights | Masses::All => table::Firmness::NotShown,
    }
}

fn plural(orders: &[String]) -> String {
    format!("order{} {}", if orders.len() == 1 { "" } else { "s" }, orders.join(", "))
}

fn units(engine: &Engine) -> String {
    let mass = if engine.has_unit_masses() { "m r ω² c_k" } else { "r ω² c_k · kg" };
    let arm = match engine.length_unit() {
        crate::engine::LengthUnit::Metre => "times metres",
        crate::engine::LengthUnit::Spacing => "times a, the unit of the positions (the cylinder spacing)",
    };
    let mass = mass.replace("c_k", "$c_k$");
    format!(
        "The number is the largest value through a revolution, $\\tfrac12(\\lvert P^{{+}}\\rvert + \\lvert P^{{-}}\\rvert)$: \
         forces in units of {mass}, moments in the same {arm}. **0** is exact and proved; = stands before exact numbers, ≈ before \
         decimals. A couple is the same about every plane; a moment is taken about the reference plane."
    )
}

fn firing(engine: &Engine) -> Vec<String> {
    let Some(firing) = engine.firing() else { return Vec::new() };
    let names: Vec<&str> = firing.shots.iter().map(|shot| engine.cylinders()[shot.cylinder].name.as_str()).collect();
    let cycle = match firing.cycle {
        Cycle::FourStroke => "four-stroke",
        Cycle::TwoStroke => "two-stroke",
    };
    vec![format!("Firing order {} ({cycle}).", names.join("–")), intervals(firing)]
}

/// Even or uneven, and which.
fn intervals(firing: &Firing) -> String {
    let intervals = firing.intervals();
    match intervals.as_slice() {
        [first, ..] if firing.is_even() => format!("It fires evenly, every {} of crank angle.", typeset::turns(first)),
        uneven => {
            let list: Vec<String> = uneven.iter().map(typeset::turns).collect();
            format!("It fires unevenly, at intervals of {}.", list.join(", "))
        }
    }
}

fn conventions(engine: &Engine) -> Vec<String> {
    let plane = typeset::number(engine.reference_plane());
    let unit = table::position_unit(engine).replace(['(', ')'], "");
    let why = if engine.reference_plane_given() { "as the layout file says" } else { "the middle of the cylinders" };
    vec![
        SEEN.to_owned(),
        CENTRES.to_owned(),
        FIRES.to_owned(),
        format!("Moments are taken about the plane z = {plane}{unit}, {why}."),
        assumed(engine),
    ]
}

/// What the verdicts rest on.
fn assumed(engine: &Engine) -> String {
    match (engine.mechanisms().len() > 1, engine.has_offset()) {
        (false, false) => ASSUMED.to_owned(),
        (unequal, offset) => format!(
            "Assumed: a rigid crankshaft at constant speed, rods in the plane of their cylinder; a radial's rods all on the crankpin itself. {}{}",
            if unequal {
                "The rods differ: cylinders with equal ones are judged together, for only they have a coefficient c_k in common. "
            } else {
                ""
            },
            if offset {
                "The cylinder axes miss the crankshaft, so that every order exists."
            } else {
                "Orders of a centric engine are 1 and the even ones."
            }
        ),
    }
}

pub(super) const SEEN: &str = "Seen from the free end of the crankshaft (+z towards the reader), angles grow anticlockwise from the \
                               reference direction, drawn upwards; for a V it is the bisector of the banks. The crank turns \
                               anticlockwise by θ.";
const CENTRES: &str =
    "Crankpin j stands at θ + β, the axis of cylinder j points to α; its piston is at top dead centre where θ + β = α.";
pub(super) const FIRES: &str = "A cylinder that fires later has its throw behind: β − α falls by the firing angle. (Books that let it \
                                grow draw the mirror image: the same verdicts and lengths, directions of the opposite sign.) The pin of \
                                the second bank of a V stands at the throw plus the pin split.";
pub(super) const ASSUMED: &str = "Assumed: a rigid crankshaft at constant speed, equal rods and no pin offset, rods in the plane of their \
                                  cylinder; a radial's rods all on the crankpin itself. Orders of a centric engine are 1 and the even ones.";
