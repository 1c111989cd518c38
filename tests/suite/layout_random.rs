//! Does any text at all end in an engine or a message, and does every engine get the verdict that decimals suggest?
use crankstar::engine::{Cylinder, Engine};
use crankstar::exact::Turn;
use crankstar::file::{catalogue, parse};
use crankstar::proof::{Quantity, Sense};
use crankstar::verdict::{Balance, Verdict};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use crate::support::verdicts::judged;

/// An engine, or an error with something to show.
fn read(text: &str) {
    if let Err(error) = parse("layout.toml", text) {
        assert!(!error.message().is_empty());
        assert!(error.to_string().starts_with("error: "));
    }
}

/// Pieces of layout files and of mistakes.
const PIECES: &[&str] = &[
    "\n",
    " = ",
    "[",
    "]",
    "[[cylinder]]",
    "[vee]",
    "[inline]",
    "[crankshaft]",
    "[[counterweight]]",
    "[[balancer]]",
    "balance_factor",
    "mass_radius",
    "throws",
    "throw",
    "bank",
    "position",
    "cycle",
    "'",
    "\"",
    "0",
    "-1",
    "1e99",
    "nan",
    "1/0",
    "180",
    "1/3 turn",
    "mm",
    "{",
    "}",
    ",",
    ".",
    "four-stroke",
    "firing_order",
    "1-3-4-2",
    "°",
    "−",
    "\u{0}",
    "\u{feff}",
    "#",
    "=",
    "\r",
];

fn catalogue_files() -> Vec<&'static str> {
    catalogue().unwrap().into_iter().map(|(entry, _)| entry.text).collect()
}

/// The text with one stretch of it replaced.
fn spoil(text: &str, from: Index, length: usize, piece: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let from = from.index(letters.len() + 1);
    let to = (from + length).min(letters.len());
    let (before, after) = (&letters[..from], &letters[to..]);
    before.iter().copied().chain(piece.chars()).chain(after.iter().copied()).collect()
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        read(&text);
    }

    #[test]
    fn any_heap_of_pieces_is_read_or_refused(pieces in prop::collection::vec(select(PIECES), 0..40)) {
        read(&pieces.concat());
    }

    #[test]
    fn a_spoiled_catalogue_file_is_read_or_refused(
        text in select(catalogue_files()),
        spoils in prop::collection::vec((any::<Index>(), 0..6_usize, select(PIECES)), 1..4),
    ) {
        let spoil = |text: String, (from, length, piece): (Index, usize, &str)| spoil(&text, from, length, piece);
        read(&spoils.into_iter().fold(text.to_owned(), spoil));
    }
}

/// With such angles a sum may be small without being zero.
const LARGE_DENOMINATOR: &str = "1000003";

fn angle() -> impl Strategy<Value = String> {
    let denominator = select(vec![1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 24, 360, 1_000_003]);
    (0..360, denominator).prop_map(|(turns, of)| format!("\"{turns}/{of} turn\""))
}

/// Any cylinders.
fn general() -> impl Strategy<Value = String> {
    let cylinder = (angle(), angle(), -9..9_i32, 0..4).prop_map(|(throw, bank, position, mass)| {
        format!(
            "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = {position}\nreciprocating_mass = \"{mass}/3\"\n"
        )
    });
    prop::collection::vec(cylinder, 1..12).prop_map(|cylinders| cylinders.concat())
}

/// Even throws in any order, on any banks: engines where much vanishes.
fn regular() -> impl Strategy<Value = String> {
    let throws = (1..9_usize).prop_flat_map(|count| {
        let even: Vec<String> = (0..count).map(|index| format!("\"{index}/{count} turn\"")).collect();
        Just(even).prop_shuffle()
    });
    (throws, prop::collection::vec(angle(), 1..4))
        .prop_map(|(throws, banks)| format!("[fan]\nthrows = [{}]\nbanks = [{}]", throws.join(", "), banks.join(", ")))
}

/// The sum of a verdict in plain decimals, from the definition (theory, section 3).
fn in_decimals(layout: &Engine, verdict: &Verdict) -> Complex<f64> {
    let decimal = |number: &BigRational| number.to_f64().unwrap();
    let radians = |angle: &Turn| std::f64::consts::TAU * decimal(angle.turns());
    let k = f64::from(verdict.order);
    let vector = |cylinder: &Cylinder| {
        let (throw, bank) = (radians(&cylinder.throw), radians(&cylinder.bank));
        // The force along the axis of the bank, at the cylinder's own crank angle.
        let angle = match verdict.sense {
            Some(Sense::Direct) => k * (throw - bank) + bank,
            Some(Sense::Reverse) => -k * (throw - bank) + bank,
            None => k * (throw - bank),
        };
        let arm = if verdict.quantity == Quantity::MOMENT { decimal(&layout.arm(cylinder)) } else { 1.0 };
        Complex::from_polar(decimal(&cylinder.reciprocating_mass), angle) * arm
    };
    layout.cylinders().iter().map(vector).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn exact_verdicts_agree_with_decimals(text in prop_oneof![general(), regular()]) {
        let layout = parse("layout.toml", &text).unwrap();
        for order in judged(&layout, &[1, 2, 3, 4, 6, 12], true) {
            let torque = order.torque.iter().flat_map(|torque| &torque.parts).map(|part| &part.verdict);
            let parts = order.parts.iter().flat_map(|part| [&part.force, &part.moment]).flat_map(Balance::verdicts);
            for verdict in parts.chain(torque) {
                let size = in_decimals(&layout, verdict).norm();
                let (quantity, order) = (verdict.quantity, verdict.order);
                let clear_cut = size > 1e-6 || !text.contains(LARGE_DENOMINATOR);
                if clear_cut {
                    let zero = size < 1e-9;
                    prop_assert_eq!(verdict.vanishes(), zero, "{:?} of order {}: {}\n{}", quantity, order, size, text);
                }
            }
        }
    }
}
