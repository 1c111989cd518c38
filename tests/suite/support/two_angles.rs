//! Which engines have two open angles, at random? V and W engines whose pins are split in either sense, or not.

use crankstar::engine::Family;
use crankstar::file::{self, Layout};
use crankstar::proof::OpenDocument;
use crankstar::{family, report};

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

/// A W engine, every pin of which may be split in either sense.
pub fn split_broad_arrow(dice: &mut Dice) -> String {
    engine(dice, &["-phi", "0", "phi"], &["", " + delta", " - delta"])
}

/// In the direct force of order 1 each cylinder has the phase of its throw.
fn throws(list: &[(&str, u32)]) -> String {
    let cylinder = |(throw, mass): &(&str, u32)| {
        format!("[[cylinder]]\nthrow = '{throw}'\nbank = 0\nposition = 0\nreciprocating_mass = {mass}\n")
    };
    list.iter().map(cylinder).collect()
}

/// Three classes of parts: at δ = 180° all of them vanish, the outer ones alone, and outer ones of one length meet a middle one that is
/// shorter than both, as long, and longer; at δ = 0 outer ones of different length meet a middle one as long as both.
pub fn quadratics() -> Vec<String> {
    let outer = [("0", 1), ("delta", 1), ("2phi", 2), ("2phi + delta", 2)];
    let with = |others: &[(&str, u32)]| throws(&[&outer, others].concat());
    let mirrored =
        |mass| throws(&[("0", 2), ("delta", 1), ("phi", mass), ("2phi", 1), ("2phi + delta", 2), ("2phi + 2delta", 2)]);
    vec![
        throws(&[("0", 1), ("delta", 1), ("2phi", 5), ("2phi + delta", 5), ("phi", 1), ("phi + 3delta", 1)]),
        with(&[("phi", 1), ("phi + 3delta", 2)]),
        mirrored(1),
        mirrored(2),
        mirrored(3),
        throws(&[("0", 1), ("phi", 2), ("phi + delta", 1), ("2phi + 3delta", 2)]),
    ]
}

/// Three classes that cancel along a curve: outer ones of one length with two turns for each δ, and `(1 + 2y + (2 + y) x) (3 + y + x)`, with
/// one.
pub fn curves() -> Vec<String> {
    vec![classes([[1, 1, 3], [1, 1, 1], [3, 1, 1]]), classes([[3, 7, 2], [7, 7, 1], [2, 1, 0]])]
}

/// Three classes of cylinders whose pins are split by 0, δ, 2δ and 3δ, by their masses.
fn classes<const N: usize>(masses: [[u32; N]; 3]) -> String {
    let each = ["0", "phi", "2phi"].into_iter().zip(masses).flat_map(|(throw, masses)| {
        let split = ["", " + delta", " + 2delta", " + 3delta"].into_iter().zip(masses).filter(|(_, mass)| *mass > 0);
        split.map(move |(split, mass)| (format!("{throw}{split}"), mass))
    });
    let each: Vec<(String, u32)> = each.collect();
    throws(&each.iter().map(|(throw, mass)| (throw.as_str(), *mass)).collect::<Vec<_>>())
}

/// Outer classes that are equally long for each δ, `A = 2 + y` and `C = 1 + 2y`. At cos δ = 1/4 and −1/4 they meet a middle one that is shorter
/// than both, and one that is longer; at no δ but 0, and at δ = 120° too.
pub fn twists() -> Vec<String> {
    [[5, 2, 2], [7, 6, 2], [1, 0, 0], [0, 0, 1]].map(|middle| classes([[2, 1, 0], middle, [1, 2, 0]])).into()
}

/// Both outer classes, and the middle one, times `2 + y + 2y²`: at cos δ = −1/4 all three vanish.
pub fn vanishing_twist() -> String {
    classes([[4, 4, 5, 2], [2, 1, 2, 0], [2, 5, 4, 4]])
}

/// Outer classes that are equally long for each δ, with a middle one at random.
pub fn random_twist(dice: &mut Dice) -> String {
    let outer = [(); 2].map(|()| (30 * dice.below(12), 1 + dice.below(5)));
    let against = 30 * dice.below(12);
    let mut text = String::new();
    let mut add = |angle: u64, class: u32, split: usize, mass: u64| {
        text += &format!(
            "[[cylinder]]\nthrow = '{} + {class}phi + {split}delta'\nbank = 0\nposition = 0\nreciprocating_mass = {mass}\n",
            angle % 360
        );
    };
    for (split, (angle, mass)) in outer.into_iter().enumerate() {
        add(angle, 0, split, mass);
        // The mirror image of the first.
        add(360 + against - angle, 2, 1 - split, mass);
    }
    for split in [0, 2, 3] {
        let (angle, mass) = (30 * dice.below(12), dice.below(6));
        if split == 2 || mass > 0 {
            add(angle, 1, split, 1 + mass);
        }
    }
    text
}

/// Four parts that no reduction fits: with rational zeros, some of them double; with others; and with none.
pub fn tori() -> Vec<String> {
    let with = |[a, b, c, d]: [u32; 4]| throws(&[("0", a), ("phi", b), ("delta", c), ("3phi + 5delta", d)]);
    vec![with([1, 1, 1, 1]), with([3, 2, 2, 4]), with([6, 1, 2, 1])]
}

/// Documents on engines whose torus is cut into boxes.
pub fn torus_documents() -> Vec<OpenDocument> {
    tori().iter().map(|text| document(text, &[1])).collect()
}

/// An engine with four banks of cylinders in a fan, the pins of which may be split by multiples of δ.
pub fn fan(dice: &mut Dice) -> String {
    let step = [60, 90, 120, 72][dice.below(4) as usize];
    let throw = step * dice.below(6) % 360;
    let cylinder = |bank: &&str| {
        let split = ["", " + delta", " + 2delta", " + 3delta"][dice.below(4) as usize];
        let mass = 1 + dice.below(3);
        format!("[[cylinder]]\nthrow = '{throw}{split}'\nbank = '{bank}'\nposition = 0\nreciprocating_mass = {mass}\n")
    };
    let first = "[[cylinder]]\nthrow = '90 + delta'\nbank = '-3phi/2'\nposition = 1\n";
    first.to_owned() + &["-3phi/2", "-phi/2", "phi/2", "3phi/2"].iter().map(cylinder).collect::<String>()
}

/// Four to eight cylinders, each of which φ and δ turn at random.
pub fn mixed(dice: &mut Dice) -> String {
    let cylinder = |dice: &mut Dice| {
        let (throw, place, mass) = (30 * dice.below(12), dice.below(4), 1 + dice.below(2));
        let split = ["", " + delta", " - delta", " + 2delta"][dice.below(4) as usize];
        let bank = ["-3phi/2", "-phi", "-phi/2", "0", "phi/2", "phi", "3phi/2"][dice.below(7) as usize];
        format!(
            "[[cylinder]]\nthrow = '{throw}{split}'\nbank = '{bank}'\nposition = {place}\nreciprocating_mass = {mass}\n"
        )
    };
    let first = "[[cylinder]]\nthrow = 'delta'\nbank = 'phi/2'\nposition = 1\n";
    let others = 3 + dice.below(5);
    first.to_owned() + &(0..others).map(|_| cylinder(dice)).collect::<String>()
}

/// Documents on engines whose answers are of every kind.
pub fn documents() -> Vec<OpenDocument> {
    let mut dice = Dice::new(7);
    let random = (0..8).map(|round| if round % 4 == 3 { broad_arrow(&mut dice) } else { vee(&mut dice) });
    // Triangles: flat, right-angled, none, of sides 2, 3 and 4. Both classes zero at δ = 180°. A product.
    let texts: Vec<String> = random
        .chain([
            throws(&[("0", 2), ("phi", 1), ("delta", 1)]),
            throws(&[("0", 1), ("90", 1), ("phi", 1), ("delta", 1)]),
            throws(&[("0", 3), ("phi", 1), ("delta", 1)]),
            throws(&[("0", 2), ("phi", 3), ("delta", 4)]),
            throws(&[("0", 1), ("delta", 1), ("phi", 1), ("phi + delta", 2), ("phi + 2delta", 1)]),
            throws(&[("0", 1), ("delta", 1), ("phi", 1), ("phi + delta", 1)]),
        ])
        .collect();
    texts.iter().map(|text| document(text, &[1, 2])).collect()
}

/// Documents on engines whose parts make three classes.
pub fn quadratic_documents() -> Vec<OpenDocument> {
    quadratics().iter().chain(&curves()).chain(&twists()).map(|text| document(text, &[1])).collect()
}

/// The document on an engine.
pub fn document(text: &str, orders: &[u32]) -> OpenDocument {
    let family = family(text);
    report::open_document(&family, &family::classify(&family, orders).expect("orders"))
}
