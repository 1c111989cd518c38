//! Which tables does a report hold? Cells are finished strings of the dialect.

use num_rational::BigRational;
use num_traits::Zero;
use serde::Serialize;

use super::dialect::Dialect;
use super::left;
use super::typeset;
use crate::layout::{Cylinder, Layout, LengthUnit};
use crate::proof::Sense;
use crate::verdict::OrderBalance;

/// A table: every row has as many cells as the header.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// Headings of the columns.
    pub header: Vec<String>,
    /// The cells.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    fn new(dialect: Dialect, header: &[&str], rows: Vec<Vec<String>>) -> Self {
        let set = |cells: Vec<String>| cells.iter().map(|cell| dialect.prose(cell)).collect();
        Table {
            header: header.iter().map(|cell| dialect.prose(cell)).collect(),
            rows: rows.into_iter().map(set).collect(),
        }
    }
}

/// Orders × (force, moment): what is left, and whether the moment is a couple.
pub(super) fn summary(dialect: Dialect, orders: &[OrderBalance]) -> Table {
    let bold = |text: String| if text == "0" { "**0**".to_owned() } else { text };
    let row = |order: &OrderBalance| {
        vec![order.order.to_string(), bold(left::force_summary(order)), bold(left::moment_summary(order))]
    };
    Table::new(dialect, &["Order", "Force", "Moment"], orders.iter().map(row).collect())
}

/// One row a cylinder: throw, bank, position, and mass where they differ from 1.
pub(super) fn cylinders(dialect: Dialect, layout: &Layout) -> Table {
    let unit = position_unit(layout);
    let mut header = vec!["Cylinder".to_owned(), "Throw β".into(), "Bank α".into(), format!("Position z{unit}")];
    if !layout.has_unit_masses() {
        header.push("Reciprocating mass".into());
    }
    let row = |cylinder: &Cylinder| {
        let mut cells = vec![
            cylinder.name.clone(),
            typeset::angle(&cylinder.throw),
            typeset::degrees(&typeset::signed_degrees(&cylinder.bank)),
            typeset::number(&cylinder.position),
        ];
        if !layout.has_unit_masses() {
            cells.push(typeset::number(&cylinder.reciprocating_mass));
        }
        cells
    };
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    Table::new(dialect, &header, layout.cylinders.iter().map(row).collect())
}

/// ` (m)`, or nothing where positions are multiples of the spacing.
pub(super) fn position_unit(layout: &Layout) -> &'static str {
    match layout.length_unit {
        LengthUnit::Metre => " (m)",
        LengthUnit::Spacing => "",
    }
}

/// The vector-star table of order k: how each phase comes about, and the sums.
pub(super) fn vector_star(dialect: Dialect, layout: &Layout, order: &OrderBalance) -> Table {
    let k = i64::from(order.order);
    let has_banks = layout.cylinders.iter().any(|cylinder| cylinder.bank != crate::exact::Turn::zero());
    let with_mass = !layout.has_unit_masses();
    let arm = format!("Arm z{}", position_unit(layout));
    let mut header = vec!["Cylinder".to_owned(), "Throw β".into()];
    header.extend(has_banks.then(|| "Bank α".into()));
    header.push(arm);
    header.extend(with_mass.then(|| "Mass m".into()));
    header.push(format!("Direct phase {}", phase_formula(k, Sense::Direct, has_banks)));
    header.push(format!("Reverse phase {}", phase_formula(k, Sense::Reverse, has_banks)));
    let row = |cylinder: &Cylinder| {
        let bank = typeset::signed_degrees(&cylinder.bank);
        let mut cells = vec![cylinder.name.clone(), typeset::angle(&cylinder.throw)];
        cells.extend(has_banks.then(|| typeset::degrees(&bank)));
        cells.push(typeset::number(&layout.arm(cylinder)));
        cells.extend(with_mass.then(|| typeset::number(&cylinder.reciprocating_mass)));
        let throw = cylinder.throw.degrees();
        cells.push(phase(&[(k, &throw), (1 - k, &bank)]));
        cells.push(phase(&[(-k, &throw), (k + 1, &bank)]));
        cells
    };
    let mut rows: Vec<Vec<String>> = layout.cylinders.iter().map(row).collect();
    let blank = header.len() - 3;
    for (name, balance) in [("Σ force", &order.force), ("Σ moment", &order.moment)] {
        let mut cells = vec![format!("**{name}**")];
        cells.extend(vec![String::new(); blank]);
        cells.extend(balance.verdicts().map(|verdict| match verdict.vanishes() {
            true => "**0**".to_owned(),
            false => format!("{} at angle {}", left::modulus(verdict).related(), left::direction(verdict)),
        }));
        rows.push(cells);
    }
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    Table::new(dialect, &header, rows)
}

/// `2β − α`, `−2β + 3α`; without the bank where all banks are at 0.
pub(super) fn phase_formula(k: i64, sense: Sense, has_banks: bool) -> String {
    let times = |factor: i64, symbol: &str| match factor {
        1 => symbol.to_owned(),
        _ => format!("{factor}{symbol}"),
    };
    let bank = |sign: &str, factor: i64| match factor {
        0 => String::new(),
        _ if !has_banks => String::new(),
        _ => format!(" {sign} {}", times(factor, "α")),
    };
    match sense {
        Sense::Direct => format!("{}{}", times(k, "β"), bank("−", k - 1)),
        Sense::Reverse => format!("−{}{}", times(k, "β"), bank("+", k + 1)),
    }
}

/// A phase worked out: `2·270° + 45° = 585° ≡ 225°`.
fn phase(parts: &[(i64, &BigRational); 2]) -> String {
    let products: Vec<(bool, String)> =
        parts.iter().filter_map(|(factor, degrees)| typeset::multiple(*factor, degrees)).collect();
    let sum: BigRational =
        parts.iter().map(|(factor, degrees)| *degrees * BigRational::from_integer((*factor).into())).sum();
    let turn = crate::exact::Turn::from_degrees(&sum);
    let reduced = typeset::angle(&turn);
    if products.is_empty() {
        return reduced;
    }
    let mut text = String::new();
    for (index, (negative, product)) in products.iter().enumerate() {
        text.push_str(match (index, negative) {
            (0, false) => "",
            (0, true) => "−",
            (_, false) => " + ",
            (_, true) => " − ",
        });
        text.push_str(product);
    }
    let value = typeset::degrees(&sum);
    if value != text {
        text = format!("{text} = {value}");
    }
    let is_reduced = (&turn.degrees() - &sum).is_zero();
    if is_reduced { text } else { format!("{text} ≡ {reduced}") }
}
