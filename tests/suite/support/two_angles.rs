//! Which engines have two open angles, at random? V and W engines whose pins are split in either sense, or not.

use crankstar::engine::Family;
use crankstar::file::{self, Layout};

use super::dice::Dice;

/// A family from a layout file.
pub fn family(text: &str) -> Family {
    match file::parse_layout("test", text) {
        Ok(Layout::Open(family)) => *family,
        Ok(Layout::Known(..)) => panic!("nothing is open in {text}"),
        Err(error) => panic!("{text}: {error}"),
    }
}

fn cylinder(dice: &mut Dice, throw: u64, bank: &str, senses: &[&str]) -> String {
    let split = senses[dice.below(senses.len() as u64) as usize];
    let (place, mass) = (dice.below(5), 2 + dice.below(8) / 6);
    format!(
        "[[cylinder]]\nthrow = '{throw}{split}'\nbank = '{bank}'\nposition = {place}\nreciprocating_mass = '{mass}/2'\n"
    )
}

fn engine(dice: &mut Dice, banks: &[&str], senses: &[&str]) -> String {
    let pins = 2 + dice.below(3);
    let step = [60, 90, 120, 72, 45][dice.below(5) as usize];
    let pin = |dice: &mut Dice| {
        let throw = step * dice.below(6) % 360;
        banks.iter().map(|bank| cylinder(dice, throw, bank, senses)).collect::<String>()
    };
    // One pin at least is split, or none of the angles would be open.
    let first = format!("[[cylinder]]\nthrow = 'delta'\nbank = '{}'\nposition = 1\n", banks[0]);
    first + &(0..pins).map(|_| pin(dice)).collect::<String>()
}

/// A V engine, every pin of which may be split in either sense, on either bank.
pub fn vee(dice: &mut Dice) -> String {
    engine(dice, &["-phi/2", "phi/2"], &["", " + delta", " - delta"])
}

/// A V engine whose pins are split alike on both banks, or in opposite senses, between equal pistons: products, and curves.
pub fn regular_vee(dice: &mut Dice) -> String {
    let (pins, opposite) = (2 + dice.below(3), dice.below(2) == 1);
    let step = [60, 90, 120, 72][dice.below(4) as usize];
    let pin = |place: u64| {
        let throw = step * dice.below(6) % 360;
        let senses = if dice.below(2) == 0 || place == 0 { [" + delta", " - delta"] } else { ["", ""] };
        let second = senses[usize::from(opposite)];
        let cylinder = |split: &str, bank: &str| {
            format!("[[cylinder]]\nthrow = '{throw}{split}'\nbank = '{bank}'\nposition = {place}\n")
        };
        cylinder(senses[0], "-phi/2") + &cylinder(second, "phi/2")
    };
    (0..pins).map(pin).collect()
}

/// A W engine whose pins are split in one sense, or not.
pub fn broad_arrow(dice: &mut Dice) -> String {
    engine(dice, &["-phi", "0", "phi"], &["", " + delta"])
}
