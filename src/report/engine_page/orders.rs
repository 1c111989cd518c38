//! How is each order proved? Its star, what is left, and the argument for each vector.

use num_traits::{One, Signed};

use super::super::residual_words::{sentence, whole_sentence};
use super::super::star::{
    WholeStars, short_names_in_tables, sized_star_figure, star_figure, star_legend, whole_legend, whole_star_figure,
};
use super::super::{argument, example, mechanism_words, residual, table};
use super::weighing::{Weighed, WeighedParts};
use crate::engine::{Cylinder, DOES_NOT_EXIST, Engine, WHY_NOT};
use crate::exact::Turn;
use crate::order::MassGroup;
use crate::page::{Block, Fold, Picture, Text, phrase};
use crate::proof::{Quantity, Sense};
use crate::report::texts::{engine as text, theorem};
use crate::verdict::{Balance, Judgement, OrderBalance, OrderVerdict, Verdict};

/// An order as a report shows it: with its stars and its proofs.
pub(super) struct StarOf<'a> {
    order: &'a OrderVerdict,
    /// Whether it is of the pistons, where the engine as it is built is shown too.
    pistons_alone: bool,
    /// The sizes of these masses, where they are known.
    weighed: Option<&'a Weighed<'a>>,
}

/// The orders that a report shows: each, then that of the pistons alone where those differ.
pub(super) fn stars<'a>(judged: &'a Judgement, weighed: &'a WeighedParts<'a>) -> Vec<StarOf<'a>> {
    let mut all = Vec::new();
    for order in &judged.orders {
        all.push(StarOf { order, pistons_alone: false, weighed: weighed.as_judged.as_ref() });
        let pistons = judged.differing().filter(|pistons| pistons.order == order.order);
        let pistons = pistons.map(|order| StarOf { order, pistons_alone: true, weighed: weighed.pistons.as_ref() });
        all.extend(pistons);
    }
    all
}

impl<'a> StarOf<'a> {
    /// Whether some vector of it is left, or may be.
    pub fn is_left(&self) -> bool {
        self.order.exists() && !(self.order.force.is_balanced() && self.order.moment.is_balanced())
    }

    /// The one exact star of the order; none where its parts have coefficients of their own.
    fn only(&self) -> Option<&'a OrderBalance> {
        match self.order.parts.as_slice() {
            [only] if only.class.is_none() => Some(only),
            _ => None,
        }
    }

    /// `Order 2`, `Order 1, the pistons alone`.
    fn title(&self) -> Text {
        let words = if self.pistons_alone { "Order {}, the pistons alone" } else { "Order {}" };
        phrase!(words, self.order.order)
    }

    /// Its drawing; none where the coefficients of its parts are not known.
    pub fn picture(&self, engine: &Engine) -> Option<Picture> {
        let number = self.order.order;
        let (figure, legend) = match (self.only(), self.weighed) {
            (Some(only), Some(weighed)) => {
                let size = |quantity, units| weighed.together(number, quantity, units);
                (sized_star_figure(engine, only, size), star_legend(engine, only))
            }
            (Some(only), None) => (star_figure(engine, only), star_legend(engine, only)),
            (None, Some(weighed)) => {
                let stars = WholeStars::new(weighed);
                (whole_star_figure(&stars, number), whole_legend(&stars, number))
            }
            (None, None) => return None,
        };
        let caption = text::stars(self.title(), legend);
        let name = if self.pistons_alone { format!("order-{number}-pistons") } else { format!("order-{number}") };
        Some(Picture::new(name, caption, figure))
    }
}

const FORCE: &str = "F_k(\\theta) = \\tfrac12\\, m\\, r\\, \\omega^2 c_k \\left( P_k^{+} e^{ik\\theta} + P_k^{-} e^{-ik\\theta} \\right)";
const PHASES: &str = "P_k^{+} = \\sum_j w_j\\, e^{i(k\\beta_j - (k-1)\\alpha_j)}, \\qquad P_k^{-} = \\sum_j w_j\\, e^{i(-k\\beta_j + (k+1)\\alpha_j)}";
fn has_offset_below_zero(engine: &Engine) -> bool {
    engine.mechanisms().iter().filter_map(|mechanism| mechanism.rod()).any(|rod| rod.offset.is_negative())
}

/// Whether all cylinders have one weight that is not 1.
fn has_other_unit(engine: &Engine) -> bool {
    let mut weights = engine.cylinders().iter().map(Cylinder::weight);
    weights.next().is_some_and(|first| !first.is_one() && weights.all(|other| other == first))
}

/// The proofs, order by order.
pub(super) fn proofs(engine: &Engine, stars: &[StarOf]) -> Vec<Block> {
    let has_banks = engine.cylinders().iter().any(|cylinder| cylinder.bank != Turn::zero());
    let first = stars.iter().take(1).flat_map(|star| &star.order.parts).take(1);
    let mut blocks: Vec<Block> = first.flat_map(|part| example::worked(engine, part)).collect();
    blocks.extend([
        text::force_vectors().into(),
        Block::Formula(FORCE.to_owned(), Some(1)),
        Block::Formula(PHASES.to_owned(), Some(2)),
        text::moment_vectors(!has_other_unit(engine)).into(),
    ]);
    let sources = || stars.iter().flat_map(|star| &star.order.parts).flat_map(table::sources);
    if sources().any(|source| source.group() != MassGroup::Reciprocating) {
        blocks.push(text::turning_weights().into());
    }
    blocks.extend(short_names_in_tables(engine, sources()).map(Block::Paragraph));
    let offset = has_offset_below_zero(engine).then(text::offset_below_zero);
    let banks = (has_banks && engine.faster_crank().is_none()).then(text::bank_phases);
    let speeds = engine.faster_crank().map(|_| text::own_orders());
    blocks.extend(offset.into_iter().chain(banks).chain(speeds).map(Block::Paragraph));
    for star in stars {
        blocks.extend(proof(engine, star));
    }
    blocks
}

fn proof(engine: &Engine, star: &StarOf) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(2, star.title())];
    blocks.extend(star.picture(engine).map(Block::from));
    if let Some(only) = star.only() {
        blocks.extend(sum_proved(engine, only));
        let summary = text::certificates(star.title());
        blocks.push(Block::Folded(Fold { summary, blocks: vec![certificates(only)] }));
        return blocks;
    }
    let order = star.order;
    blocks.push(Block::Paragraph(mechanism_words::why_several(engine)));
    blocks.extend(star.weighed.map(|weighed| table::whole_star(engine, &WholeStars::new(weighed), order.order).into()));
    let both = [("Force", &order.force), ("Moment", &order.moment)];
    blocks.extend(both.map(|(name, of)| Block::Paragraph(whole_sentence(name, order.order, of))));
    let mut evidence = Vec::new();
    for part in &order.parts {
        evidence.push(Block::Heading(2, phrase!("Order {}", residual::order_name(part))));
        evidence.extend(sum_proved(engine, part));
        evidence.push(certificates(part));
    }
    let summary = text::exact_sums(star.title());
    blocks.push(Block::Folded(Fold { summary, blocks: evidence }));
    blocks
}

/// The terms of one exact sum, and why it is zero or not.
fn sum_proved(engine: &Engine, order: &OrderBalance) -> Vec<Block> {
    let mut blocks = vec![table::vector_star(engine, order).into()];
    let force_left = theorem::force(if order.exists { sentence(&order.force) } else { missing(order) });
    for (balance, left) in [(&order.force, force_left), (&order.moment, moment_left(engine, order))] {
        blocks.push(Block::Paragraph(left));
        blocks.push(Block::List(balance.verdicts().map(|verdict| argued(engine, verdict)).into()));
    }
    blocks
}

fn certificates(order: &OrderBalance) -> Block {
    Block::List([&order.force, &order.moment].into_iter().flat_map(Balance::verdicts).map(certified).collect())
}

/// Of a star without an order.
fn missing(order: &OrderBalance) -> Text {
    text::any_sums(order.order, DOES_NOT_EXIST, WHY_NOT)
}

fn moment_left(engine: &Engine, order: &OrderBalance) -> Text {
    let kind = || match order.moment_is_couple() {
        true if order.moment.is_balanced() => text::moment_vanishes(),
        true => text::free_couple(),
        false => text::depends_on_plane(table::place(engine, engine.reference_plane())),
    };
    if order.exists { text::moment(sentence(&order.moment), kind()) } else { theorem::moment(missing(order)) }
}

/// `P_2⁺`, `C_2⁻`, `Q_2`.
pub(in crate::report) fn symbol(verdict: &Verdict) -> String {
    let letter = match verdict.quantity {
        Quantity::FORCE => "P",
        Quantity::MOMENT => "C",
        Quantity::TORQUE => "Q",
        Quantity::ROLL => "R",
    };
    match verdict.sense {
        Some(Sense::Direct) => format!("{letter}_{{{}}}^{{+}}", verdict.order),
        Some(Sense::Reverse) => format!("{letter}_{{{}}}^{{-}}", verdict.order),
        None => format!("{letter}_{{{}}}", verdict.order),
    }
}

/// That a sum vanishes, or how long it is and where it points.
pub(super) fn value(verdict: &Verdict) -> Text {
    residual::value(&symbol(verdict), verdict)
}

/// A verdict with its argument.
fn argued(engine: &Engine, verdict: &Verdict) -> Text {
    let (value, argument) = (value(verdict), argument::argument(engine, verdict));
    match verdict.sense {
        Some(Sense::Direct) => text::direct(value, argument),
        Some(Sense::Reverse) => text::reverse(value, argument),
        None => phrase!("{}. {}", value, argument),
    }
}

/// A verdict with its certificate.
pub(super) fn certified(verdict: &Verdict) -> Text {
    phrase!("{}: {}", Text::formula(symbol(verdict)), argument::certificate(verdict))
}
