//! Which engines can be written? Layout files of every form with angles of any denominator, unequal masses, radii and rods.

use super::dice::Dice;

/// The forms of [`file`].
pub const FORMS: [&str; 10] = ["inline", "vee", "flat", "boxer", "fan", "radial", "vr", "w", "cylinder", "open"];

/// Denominators of the angles of one engine, in fractions of a turn; the oracle needs them below some hundreds.
const DENOMINATORS: [u64; 20] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 18, 20, 24, 30, 36];

/// A layout file of this form: many of its orders vanish, and many nearly do.
pub fn file(dice: &mut Dice, form: &str) -> String {
    let of = DENOMINATORS[dice.below(DENOMINATORS.len() as u64) as usize];
    let angle = |dice: &mut Dice| format!("\"{}/{of} turn\"", dice.below(of));
    let (pins, cylinders, body) = match form {
        "inline" => {
            let pins = dice.below(9) + 1;
            (pins, pins, format!("throws = {}\n", throws(dice, pins, of)))
        }
        "vee" => {
            let pins = dice.below(6) + 1;
            let split = if dice.below(2) == 0 { angle(dice) } else { "0".to_owned() };
            let (bank, throws, offset) = (angle(dice), throws(dice, pins, of), dice.below(3));
            let body =
                format!("bank_angle = {bank}\nthrows = {throws}\npin_split = {split}\nbank_offset = \"{offset}/5\"\n");
            (pins, 2 * pins, body)
        }
        "flat" => {
            let (pins, offset) = (dice.below(6) + 1, dice.below(3));
            (pins, 2 * pins, format!("throws = {}\nbank_offset = \"{offset}/7\"\n", throws(dice, pins, of)))
        }
        "boxer" => {
            let pins = dice.below(5) + 1;
            (2 * pins, 2 * pins, format!("throws = {}\nstagger = \"1/3\"\n", throws(dice, pins, of)))
        }
        "fan" => {
            let (pins, banks) = (dice.below(3) + 1, dice.below(4) + 1);
            let list = |dice: &mut Dice| (0..banks).map(|_| angle(dice)).collect::<Vec<_>>().join(", ");
            let (axes, splits) = (list(dice), list(dice));
            let offsets: Vec<String> = (0..banks).map(|bank| format!("\"{}/9\"", bank * dice.below(3))).collect();
            let body = format!(
                "banks = [{axes}]\npin_splits = [{splits}]\nbank_offsets = [{}]\nthrows = {}\n",
                offsets.join(", "),
                throws(dice, pins, of)
            );
            (pins, banks * pins, body)
        }
        "radial" => {
            let (row, rows) = (dice.below(9) + 1, dice.below(3) + 1);
            let body = format!("cylinders = {row}\nrows = {rows}\n");
            let turned =
                format!("row_rotation = {}\nrow_throw = {}\nrow_spacing = \"3/2\"\n", angle(dice), angle(dice));
            (0, row * rows, if rows > 1 { body + &turned } else { body })
        }
        "vr" | "w" => return narrow(dice, form, of),
        "cylinder" => {
            let count = dice.below(8) + 1;
            let table = |dice: &mut Dice| {
                let (throw, bank) = (angle(dice), angle(dice));
                let (position, mass) = (dice.below(9), dice.below(4));
                format!(
                    "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = \"{position}/2\"\nreciprocating_mass = \"{mass}/3\"\n"
                )
            };
            return (0..count).map(|_| table(dice)).collect();
        }
        _ => return open(dice, of),
    };
    let positions = match dice.below(4) {
        0 if pins > 0 && form != "boxer" => {
            let list: Vec<String> = (0..pins).map(|pin| format!("\"{}/4\"", 8 * pin + dice.below(7))).collect();
            format!("positions = [{}]\n", list.join(", "))
        }
        _ => String::new(),
    };
    format!("[{form}]\n{body}{positions}{}", mechanism(dice, cylinders))
}

/// Narrow banks, whose axes meet the crankshaft or pass it.
fn narrow(dice: &mut Dice, form: &str, of: u64) -> String {
    let count = dice.below(6) + 1;
    let bank = [20, 24, 30, 60][dice.below(4) as usize];
    let splay = if dice.below(3) == 0 { "0".to_owned() } else { format!("\"{}/{of} turn\"", dice.below(of)) };
    let throws = throws(dice, count, of);
    let (cylinders, own) = match form {
        "vr" => (count, format!("[vr]\nbank_angle = {bank}\n")),
        _ => {
            let (wide, split) = ([60, 72, 90][dice.below(3) as usize], dice.below(of));
            let offset = dice.below(3);
            let own = format!(
                "[w]\nbank_angle = {wide}\nnarrow_angle = {bank}\npin_split = \"{split}/{of} turn\"\nbank_offset = \"{offset}/5\"\n"
            );
            (2 * count, own)
        }
    };
    let form = format!("{own}throws = {throws}\npin_splay = {splay}\n");
    match dice.below(4) {
        0 => format!("{form}pin_offset = \"1/100\"\n[mechanism]\ncrank_radius = \"1/20\"\nrod_length = \"1/5\"\n"),
        _ => form + &mechanism(dice, cylinders),
    }
}

/// Even throws in any order, mirrored ones, or any.
fn throws(dice: &mut Dice, count: u64, of: u64) -> String {
    let (make, step) = (dice.below(4), dice.below(of) + 1);
    let angle = |pin: u64, dice: &mut Dice| match make {
        0 => (pin * step % count, count),
        1 => (pin.min(count - 1 - pin) * step % count, count),
        2 => (pin * step % of, of),
        _ => (dice.below(of), of),
    };
    let list: Vec<String> =
        (0..count).map(|pin| angle(pin, dice)).map(|(n, of)| format!("\"{n}/{of} turn\"")).collect();
    format!("[{}]", list.join(", "))
}

/// Masses of one size or of several, and rods of one size or of two.
fn mechanism(dice: &mut Dice, cylinders: u64) -> String {
    let list = |sizes: [&str; 2], dice: &mut Dice| {
        let one_of = |dice: &mut Dice| format!("\"{}\"", sizes[usize::from(dice.below(3) == 0)]);
        let list: Vec<String> = (0..cylinders).map(|_| one_of(dice)).collect();
        format!("[{}]", list.join(", "))
    };
    match dice.below(6) {
        0 => format!("[mechanism]\nreciprocating_mass = {}\n", list(["1/2", "3/4"], dice)),
        1 => format!("[mechanism]\nrod_ratio = {}\n", list(["1/4", "1/3"], dice)),
        2 => {
            let masses = list(["0.5", "0.45"], dice);
            format!(
                "[mechanism]\nreciprocating_mass = {masses}\noffset_ratio = {}\nrod_ratio = 0.3\n",
                list(["0", "1/50"], dice)
            )
        }
        _ => String::new(),
    }
}

/// A V, a fan or an in-line engine with an open angle, an open length, or both.
fn open(dice: &mut Dice, of: u64) -> String {
    let pins = dice.below(4) + 1;
    let throws = throws(dice, pins, of);
    let turn = dice.below(of);
    let positions: Vec<String> = (0..pins).map(|pin| format!("\"{}a + {}b\"", pin + 1, dice.below(3))).collect();
    let positions = positions.join(", ");
    match dice.below(4) {
        0 => format!("[vee]\nbank_angle = \"phi\"\nthrows = {throws}\n"),
        1 => format!(
            "[vee]\nbank_angle = \"phi\"\npin_split = \"delta\"\nthrows = {throws}\npositions = [{positions}]\n"
        ),
        2 => format!("[inline]\nthrows = {throws}\npositions = [{positions}]\n"),
        _ => format!("[fan]\nbanks = [\"-phi\", \"{turn}/{of} turn\", \"phi/2\"]\nthrows = {throws}\n"),
    }
}
