//! Which engines have angles that no short fraction of a turn tells? Those of the other makers, with a tail of one to twelve decimals or a fraction
//! over a large prime on many of their angles, the same on each of them, so that as much cancels as before.

use super::dice::Dice;

/// The keys of angles that may be any number.
const ANGLES: [&str; 12] = [
    "throws",
    "rows",
    "banks",
    "bank_angle",
    "pin_split",
    "pin_splits",
    "throw",
    "bank",
    "phase",
    "angle",
    "row_throw",
    "row_rotation",
];
/// Primes whose multiples are conductors above a million, and above what a machine word holds.
const PRIMES: [u64; 4] = [1_000_003, 15_485_863, 2_147_483_647, 67_280_421_310_721];

/// The layout file with the same tail on many of its angles in whole degrees.
pub fn fine(text: &str, dice: &mut Dice) -> String {
    let tail = tail(dice);
    text.lines().map(|line| of_line(line, &tail, dice) + "\n").collect()
}

/// What is added to a whole number of degrees: as a decimal, or as a fraction of a turn.
enum Tail {
    Decimals(String),
    OverPrime(u64, u64),
}

fn tail(dice: &mut Dice) -> Tail {
    if dice.below(4) == 0 {
        let prime = PRIMES[dice.below(PRIMES.len() as u64) as usize];
        return Tail::OverPrime(1 + dice.below(prime / 400), prime);
    }
    let decimals = 1 + dice.below(12) as usize;
    let digits: String = (1..decimals).map(|_| dice.below(10).to_string()).collect();
    Tail::Decimals(format!("{digits}{}", 1 + dice.below(9)))
}

impl Tail {
    fn after(&self, degrees: u64) -> String {
        match self {
            Tail::Decimals(digits) => format!("'{degrees}.{digits}'"),
            Tail::OverPrime(part, prime) => {
                let (part, prime) = (u128::from(*part), u128::from(*prime));
                format!("'{}/{} turn'", u128::from(degrees) * prime + 360 * part, 360 * prime)
            }
        }
    }
}

fn of_line(line: &str, tail: &Tail, dice: &mut Dice) -> String {
    let Some((key, value)) = line.split_once(" = ") else { return line.to_owned() };
    let key = key.rsplit('.').next().unwrap_or(key).trim();
    let list = value.trim_start_matches('[').trim_end_matches(']');
    // The rows of a radial are a number.
    if !ANGLES.contains(&key) || key == "rows" && !value.starts_with('[') {
        return line.to_owned();
    }
    let one = |angle: &str| match angle.trim().parse::<u64>() {
        Ok(degrees) if dice.below(4) > 0 => tail.after(degrees),
        _ => angle.to_owned(),
    };
    let angles = list.split(',').map(one).collect::<Vec<_>>().join(", ");
    let whole = if value.starts_with('[') { format!("[{angles}]") } else { angles };
    line.replace(value, &whole)
}
