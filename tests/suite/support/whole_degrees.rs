//! Which small files are engines? Layouts of every form at whole degrees, pseudo-random, the same every time.

use super::dice::Dice;

/// The forms that a layout file can have.
pub const FORMS: [&str; 7] = ["inline", "vee", "flat", "boxer", "fan", "radial", "cylinders"];

/// A layout file of this form with at most this many cylinders.
pub fn file(dice: &mut Dice, form: &str, most: u64) -> String {
    let body = match form {
        "inline" => format!("[inline]\nthrows = {}\n", throws(dice, most)),
        "vee" => {
            let (angle, split) = (dice.below(180) + 1, dice.below(2) * dice.below(120));
            let offset = dice.below(2) * dice.below(60);
            let throws = throws(dice, most / 2);
            format!(
                "[vee]\nbank_angle = {angle}\nthrows = {throws}\npin_split = -{split}\nbank_offset = \"{offset}/100\"\n"
            )
        }
        "flat" => format!("[flat]\nthrows = {}\n", throws(dice, most / 2)),
        "boxer" => format!("[boxer]\nthrows = {}\nstagger = \"1/2\"\n", throws(dice, most / 2)),
        "fan" => fan(dice, most),
        "radial" => {
            let rows = dice.below(4) + 1;
            let cylinders = dice.below(most / rows - 1) + 2;
            let (rotation, throw) = (dice.below(120), dice.below(360));
            let turned = format!("row_rotation = {rotation}\nrow_throw = {throw}\nrow_spacing = 1\n");
            let turned = if rows > 1 { turned } else { String::new() };
            format!("[radial]\ncylinders = {cylinders}\nrows = {rows}\n{turned}")
        }
        _ => (0..dice.below(most) + 1).map(|_| cylinder(dice)).collect(),
    };
    numbers(dice, &body)
}

/// Even throws in any order, even steps in order, or any whole degrees.
fn throws(dice: &mut Dice, most: u64) -> String {
    let count = dice.below(most) + 1;
    let divisors: Vec<u64> = (1..=count).filter(|parts| 360_u64.is_multiple_of(*parts)).collect();
    let even = divisors[dice.below(divisors.len() as u64) as usize];
    let make = dice.below(3);
    let step = dice.below(360);
    let angle = |index: u64, dice: &mut Dice| match make {
        0 => dice.below(even) * 360 / even,
        1 => index * step % 360,
        _ => dice.below(360),
    };
    let angles: Vec<String> = (0..count).map(|index| angle(index, dice).to_string()).collect();
    format!("[{}]", angles.join(", "))
}

fn fan(dice: &mut Dice, most: u64) -> String {
    let banks = dice.below(3) + 2;
    let throws = throws(dice, most / banks);
    let (tilt, splits) = (dice.below(90) + 1, dice.below(2));
    let list = |of: &mut dyn FnMut(u64) -> String| (0..banks).map(of).collect::<Vec<_>>().join(", ");
    let axes = list(&mut |bank| (bank * tilt).to_string());
    let splits = list(&mut |bank| (bank * splits * 15).to_string());
    format!("[fan]\nbanks = [{axes}]\nthrows = {throws}\npin_splits = [{splits}]\n")
}

fn cylinder(dice: &mut Dice) -> String {
    let (throw, bank, mass) = (dice.below(360), dice.below(8) * 45, dice.below(3) + 1);
    let position = dice.below(40);
    format!(
        "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = \"{position}/4\"\nreciprocating_mass = \"{mass}/2\"\n"
    )
}

/// Half of the files have a rod, some of these a pin offset, a speed and every effect.
fn numbers(dice: &mut Dice, body: &str) -> String {
    let ratio = dice.below(60) + 1;
    let mass = if body.contains("reciprocating_mass") { "" } else { "reciprocating_mass = 0.65\n" };
    match dice.below(4) {
        0 => format!("{body}[mechanism]\nrod_ratio = 0.{ratio:02}\n"),
        1 => {
            let offset = dice.below(2) * dice.below(5);
            format!(
                "speed = 6000\neffects = [\"torque\", \"remedy\"]\n{body}\
                 [mechanism]\ncrank_radius = \"45 mm\"\nrod_length = \"150 mm\"\npin_offset = \"{offset} mm\"\n{mass}rotating_mass = 0.4\n"
            )
        }
        _ => body.to_owned(),
    }
}
