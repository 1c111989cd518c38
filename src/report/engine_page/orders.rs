//! How is each order proved? Its star, what is left, and the argument for each vector.

use super::super::star::{star_figure, star_legend};
use super::super::{argument, example, residual, table};
use crate::engine::{DOES_NOT_EXIST, Engine, WHY_NOT};
use crate::exact::Turn;
use crate::page::{Block, Fold, Picture, Text, phrase};
use crate::proof::{Quantity, Sense};
use crate::verdict::{Balance, Judgement, OrderBalance, OrderVerdict, Verdict};

/// A sum of an order as a report shows it: with its star and its proofs.
pub(super) struct StarOf<'a> {
    balance: &'a OrderBalance,
    /// Whether it is of the pistons, where the engine as it is built is shown too.
    pistons_alone: bool,
    /// The name of its drawing.
    file: String,
    /// Of the last sum of an order that has several: the order as a whole.
    whole: Option<&'a OrderVerdict>,
}

/// The sums that a report shows: of each order, then of the pistons alone where those differ.
pub(super) fn stars(judged: &Judgement) -> Vec<StarOf<'_>> {
    let mut all = Vec::new();
    for order in &judged.orders {
        all.extend(of_order(order, false));
        let pistons = judged.differing().filter(|pistons| pistons.order == order.order);
        all.extend(pistons.flat_map(|pistons| of_order(pistons, true)));
    }
    all
}

fn of_order(order: &OrderVerdict, pistons_alone: bool) -> Vec<StarOf<'_>> {
    let several = order.parts.len() > 1;
    let name = if pistons_alone { "-pistons" } else { "" };
    let star = |(index, balance)| StarOf {
        balance,
        pistons_alone,
        file: match several {
            true => format!("order-{}{name}-class-{}", order.order, index + 1),
            false => format!("order-{}{name}", order.order),
        },
        whole: (several && index + 1 == order.parts.len()).then_some(order),
    };
    order.parts.iter().enumerate().map(star).collect()
}

impl StarOf<'_> {
    /// Whether some vector of it is left.
    pub fn is_left(&self) -> bool {
        self.balance.exists && !(self.balance.force.is_balanced() && self.balance.moment.is_balanced())
    }

    /// `2`, `2 (cylinders 1–3, λ = 0.25)`, `1, the pistons alone`.
    fn title(&self) -> Text {
        let name = residual::order_name(self.balance);
        if self.pistons_alone { phrase!("Order {}, the pistons alone", name) } else { phrase!("Order {}", name) }
    }

    /// Its drawing.
    pub fn picture(&self, engine: &Engine) -> Picture {
        let caption = phrase!("{}: vector stars. {}", self.title(), star_legend(engine, self.balance));
        Picture { name: self.file.clone(), caption, figure: star_figure(engine, self.balance) }
    }
}

const FORCE: &str =
    "F_k(\\theta) = \\tfrac12\\, r\\, \\omega^2 c_k \\left( P_k^{+} e^{ik\\theta} + P_k^{-} e^{-ik\\theta} \\right)";
const PHASES: &str = "P_k^{+} = \\sum_j m_j\\, e^{i(k\\beta_j - (k-1)\\alpha_j)}, \\qquad P_k^{-} = \\sum_j m_j\\, e^{i(-k\\beta_j + (k+1)\\alpha_j)}";
const BANKS: &str = "Between two banks an angle φ apart the direct phases of order k differ by (k − 1)φ and the reverse \
                     ones by (k + 1)φ: by 0 and 2φ at order 1, φ and 3φ at order 2, 3φ and 5φ at order 4, 5φ and 7φ at order 6.";

const SPEEDS: &str = "A crankshaft that turns ν times while the reference turns once has its own order k/ν at order k of the engine: in its terms k/ν stands for k, with \
                      ν² before them. What turns on it has order ν, with ν² times the weight.";

/// The proofs, order by order.
pub(super) fn section(engine: &Engine, stars: &[StarOf]) -> Vec<Block> {
    let has_banks = engine.cylinders().iter().any(|cylinder| cylinder.bank != Turn::zero());
    let paragraph = |words: &'static str| Block::Paragraph(words.into());
    let mut blocks = vec![Block::Heading(1, "Proofs, order by order".into())];
    blocks.extend(stars.iter().take(1).flat_map(|star| example::worked(engine, star.balance)));
    blocks.extend([
        paragraph("The force of order k is a vector that turns with the crank and one that turns against it:"),
        Block::Formula(FORCE.to_owned(), Some(1)),
        Block::Formula(PHASES.to_owned(), Some(2)),
        paragraph("The moment has the same sums with each term multiplied by its arm z; they are called C."),
    ]);
    blocks.extend((has_banks && engine.faster_crank().is_none()).then(|| paragraph(BANKS)));
    blocks.extend(engine.faster_crank().map(|_| paragraph(SPEEDS)));
    for star in stars {
        blocks.extend(proof(engine, star));
    }
    blocks
}

fn proof(engine: &Engine, star: &StarOf) -> Vec<Block> {
    let order = star.balance;
    let mut blocks = vec![Block::Heading(2, star.title()), star.picture(engine).into()];
    blocks.push(table::vector_star(engine, order).into());
    for (balance, left) in [(&order.force, force_left(order)), (&order.moment, moment_left(engine, order))] {
        blocks.push(Block::Paragraph(left));
        blocks.push(Block::List(balance.verdicts().map(|verdict| argued(engine, verdict)).into()));
    }
    if let Some(whole) = star.whole {
        let both = [("Force", &whole.force), ("Moment", &whole.moment)];
        let sentence = both.map(|(name, of)| residual::whole_sentence(name, whole.order, of));
        blocks.extend(sentence.map(Block::Paragraph));
    }
    let certificates = [&order.force, &order.moment].into_iter().flat_map(Balance::verdicts).map(certified).collect();
    let summary = phrase!("{}: the certificates", star.title());
    blocks.push(Block::Folded(Fold { summary, blocks: vec![Block::List(certificates)] }));
    blocks
}

fn force_left(order: &OrderBalance) -> Text {
    match order.exists {
        true => phrase!("**Force.** {}", residual::sentence(&order.force)),
        false => phrase!("**Force.** {}", missing(order)),
    }
}

/// Of a star without an order.
fn missing(order: &OrderBalance) -> Text {
    phrase!("Whatever the sums are, order {} {}. {}", order.order, DOES_NOT_EXIST, WHY_NOT)
}

fn moment_left(engine: &Engine, order: &OrderBalance) -> Text {
    let kind = || match order.moment_is_couple() {
        true => "The force of this order vanishes, so the moment is a free couple: the same about every plane.".into(),
        false => phrase!(
            "The force of this order does not vanish, so the moment depends on the reference plane, here z = {}.",
            table::place(engine, engine.reference_plane())
        ),
    };
    match order.exists {
        true => phrase!("**Moment.** {} {}", residual::sentence(&order.moment), kind()),
        false => phrase!("**Moment.** {}", missing(order)),
    }
}

/// `P_2⁺`, `C_2⁻`, `Q_2`.
fn symbol(verdict: &Verdict) -> String {
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
    let symbol = symbol(verdict);
    match verdict.vanishes() {
        true => Text::formula(format!("{symbol} = 0")),
        false => phrase!(
            "{}, length {}, angle {}",
            Text::formula(format!("{symbol} \\ne 0")),
            residual::modulus(verdict),
            residual::bearing(&verdict.sum)
        ),
    }
}

/// A verdict with its argument.
fn argued(engine: &Engine, verdict: &Verdict) -> Text {
    let words = match verdict.sense {
        Some(Sense::Direct) => "**Direct:** {}. {}",
        Some(Sense::Reverse) => "**Reverse:** {}. {}",
        None => "{}. {}",
    };
    phrase!(words, value(verdict), argument::argument(engine, verdict))
}

/// A verdict with its certificate.
pub(super) fn certified(verdict: &Verdict) -> Text {
    phrase!("{}: {}", Text::formula(symbol(verdict)), argument::certificate(verdict))
}
