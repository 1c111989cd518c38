//! Which engines does a book draw? Even stars in any order, at whole degrees, pseudo-random, the same every time: in line, V, split pins, W, radial.

use super::dice::Dice;

/// The makes of the layouts.
pub const MAKES: [&str; 5] = ["in-line", "V", "split", "W", "radial"];

/// A layout file of this make.
pub fn file(dice: &mut Dice, make: &str) -> String {
    let most = if make == "in-line" { 8 } else { 5 };
    let throws = star(dice, most);
    let bank = 1 + dice.below(179);
    match make {
        "in-line" => format!("inline.throws = [{throws}]\n"),
        "V" => format!("vee = {{ bank_angle = {bank}, throws = [{throws}] }}\n"),
        "split" => {
            let split = 1 + dice.below(119);
            format!("vee = {{ bank_angle = {bank}, pin_split = -{split}, throws = [{throws}] }}\n")
        }
        "W" => {
            let tilt = 1 + dice.below(89);
            format!("fan = {{ banks = [-{tilt}, 0, {tilt}], throws = [{throws}] }}\n")
        }
        _ => {
            let (cylinders, rows) = ([3, 4, 5, 6, 8, 9][dice.below(6) as usize], 1 + dice.below(2));
            let (rotation, throw) = (dice.below(120), 15 * dice.below(24));
            let turned = format!("row_rotation = {rotation}\nrow_throw = {throw}\nrow_spacing = 1\n");
            let turned = if rows > 1 { turned } else { String::new() };
            format!("[radial]\ncylinders = {cylinders}\nrows = {rows}\n{turned}")
        }
    }
}

/// Even throws in any order, each once, or each twice.
fn star(dice: &mut Dice, most: u64) -> String {
    let parts: Vec<u64> = (1..=most).filter(|parts| 360_u64.is_multiple_of(*parts)).collect();
    let count = parts[dice.below(parts.len() as u64) as usize];
    let mut throws: Vec<u64> = (0..count).map(|at| at * 360 / count).collect();
    for at in (1..throws.len()).rev() {
        throws.swap(at, dice.below(at as u64 + 1) as usize);
    }
    if dice.below(4) == 0 {
        throws.extend(throws.clone().into_iter().rev());
    }
    throws.iter().map(u64::to_string).collect::<Vec<_>>().join(", ")
}
