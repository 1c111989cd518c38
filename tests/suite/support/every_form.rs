//! Which engines do tests try? Pseudo-random layout files of every form, the same every time.

use super::dice::Dice;

/// A layout file without unknowns, with rods, masses and weights as it happens.
pub fn known(dice: &mut Dice) -> String {
    let (form, cylinders, throws) = match dice.below(10) {
        0 => inline(dice),
        1 => vee(dice),
        2 => fan(dice),
        3 => radial(dice),
        4 => opposed(dice),
        5 => geared(dice),
        6 => two_pistons(dice),
        7 => narrow(dice),
        8 => several(dice),
        _ => general(dice),
    };
    format!("{}\n{}\n{}", form, mechanism(dice, cylinders), crankshaft(dice, throws))
}

/// A layout file with an open angle or length.
pub fn open(dice: &mut Dice) -> String {
    let count = 1 + dice.below(4) as usize;
    let throws = list(count, || angle(dice));
    let spacing = ["", "spacing = 'a'", "positions = ['a']"][if count == 1 { 2 } else { dice.below(2) as usize }];
    match dice.below(5) {
        0 => format!("vee = {{ bank_angle = 'phi', throws = [{throws}] }}"),
        1 => format!("[vee]\nbank_angle = 'phi'\npin_split = 'delta'\nthrows = [{throws}]\n{spacing}"),
        2 => format!("[vee]\nbank_angle = {}\npin_split = 'delta'\nthrows = [{throws}]\n{spacing}", angle(dice)),
        3 => format!(
            "fan = {{ banks = ['-phi', {}, 'phi'], throws = [0], positions = ['a'], bank_offsets = ['b', 0, '-b'] }}",
            dice.below(2) * 60
        ),
        _ => {
            let cylinder = |dice: &mut Dice, at: usize| {
                let (throw, mass) = (angle(dice), 1 + dice.below(4));
                format!(
                    "[[cylinder]]\nthrow = {throw}\nbank = '{}phi/2'\nposition = '{}a + {at}b'\nreciprocating_mass = '{mass}/3'\n",
                    ["", "-"][at % 2],
                    1 + dice.below(3)
                )
            };
            (0..=count).map(|at| cylinder(dice, at)).collect()
        }
    }
}

fn angle(dice: &mut Dice) -> String {
    match dice.below(8) {
        0 => format!("'{}/7 turn'", dice.below(7)),
        1 => format!("'{}/1000003 turn'", dice.below(1_000_003)),
        2 => format!("{}", dice.below(360)),
        3 => format!("'{}.5'", dice.below(360)),
        _ => {
            format!("{}", [0, 30, 45, 60, 72, 90, 120, 135, 144, 180, 216, 240, 270, 288, 315][dice.below(15) as usize])
        }
    }
}

fn list(count: usize, mut one: impl FnMut() -> String) -> String {
    (0..count).map(|_| one()).collect::<Vec<_>>().join(", ")
}

/// Often even throws, where much vanishes.
fn throws(dice: &mut Dice, count: usize) -> String {
    if dice.below(2) == 0 {
        return list(count, || angle(dice));
    }
    let mut at = 0;
    list(count, || {
        at += 1;
        format!("'{}/{count} turn'", (at - 1) * 2 % count)
    })
}

type Layout = (String, usize, usize);

fn inline(dice: &mut Dice) -> Layout {
    let count = 2 + dice.below(6) as usize;
    (format!("inline.throws = [{}]", throws(dice, count)), count, count)
}

fn vee(dice: &mut Dice) -> Layout {
    let count = 1 + dice.below(4) as usize;
    let split = if dice.below(2) == 0 { String::new() } else { format!("pin_split = {}\n", angle(dice)) };
    let offset = if dice.below(2) == 0 { "" } else { "bank_offset = '1/7'\n" };
    let bank = 1 + dice.below(178);
    let own_pins = if split.is_empty() { count } else { 0 };
    (format!("[vee]\nbank_angle = {bank}\n{split}{offset}throws = [{}]", throws(dice, count)), 2 * count, own_pins)
}

fn fan(dice: &mut Dice) -> Layout {
    let (banks, count) = (2 + dice.below(2) as usize, 1 + dice.below(3) as usize);
    let angles = list(banks, || format!("{}", dice.below(360)));
    (format!("[fan]\nbanks = [{angles}]\nthrows = [{}]", throws(dice, count)), banks * count, count)
}

fn radial(dice: &mut Dice) -> Layout {
    let count = 3 + dice.below(7) as usize;
    (format!("radial.cylinders = {count}"), count, 1)
}

fn opposed(dice: &mut Dice) -> Layout {
    let count = 1 + dice.below(3) as usize;
    let form = ["flat", "boxer"][dice.below(2) as usize];
    (format!("{form}.throws = [{}]", throws(dice, count)), 2 * count, 0)
}

fn geared(dice: &mut Dice) -> Layout {
    let count = 1 + dice.below(3) as usize;
    let (form, banks) = [("u", 2), ("h", 4)][dice.below(2) as usize];
    let sense = ["with", "against"][dice.below(2) as usize];
    let (phase, distance) = (angle(dice), 1 + dice.below(9));
    let text = format!(
        "[{form}]\nsense = '{sense}'\nphase = {phase}\ndistance = '{distance}/2'\nthrows = [{}]",
        throws(dice, count)
    );
    (text, banks * count, 0)
}

/// Crankshafts by name, some of them faster than the first.
fn several(dice: &mut Dice) -> Layout {
    let cranks = 2 + dice.below(2) as usize;
    let crank = |dice: &mut Dice, index: usize| {
        let sense = if index == 0 { "with" } else { ["with", "against"][dice.below(2) as usize] };
        let speed = if index == 0 { 1 } else { 1 + dice.below(3) };
        format!(
            "[[crankshaft]]\nname = 'c{index}'\nsense = '{sense}'\nspeed = {speed}\noffset = '{}/2'\n",
            dice.below(9)
        )
    };
    let count = 2 + dice.below(4) as usize;
    let cylinder = |dice: &mut Dice| {
        let (crank, throw, bank) = (dice.below(cranks as u64), angle(dice), angle(dice));
        let position = dice.below(9);
        format!("[[cylinder]]\ncrankshaft = 'c{crank}'\nthrow = {throw}\nbank = {bank}\nposition = '{position}/3'\n")
    };
    let cranks: String = (0..cranks).map(|index| crank(dice, index)).collect();
    (cranks + &(0..count).map(|_| cylinder(dice)).collect::<String>(), count, 0)
}

fn two_pistons(dice: &mut Dice) -> Layout {
    let count = 1 + dice.below(3) as usize;
    match dice.below(2) {
        0 => {
            let (lead, sense) = (dice.below(25), ["with", "against"][dice.below(2) as usize]);
            let text =
                format!("[opposed_piston]\nlead = {lead}\nsense = '{sense}'\nthrows = [{}]", throws(dice, count));
            (text, 2 * count, 0)
        }
        _ => {
            let against = ["", "against = ['B']\n", "against = ['A', 'C']\n", "against = []\n"][dice.below(4) as usize];
            (format!("[delta]\ncircumradius = 6\n{against}rows = [{}]", throws(dice, count)), 6 * count, 0)
        }
    }
}

fn narrow(dice: &mut Dice) -> Layout {
    let count = 1 + dice.below(6) as usize;
    let (bank, splay) = (10 + dice.below(12), dice.below(25));
    if dice.below(3) == 0 {
        let (wide, split) = (60 + dice.below(31), angle(dice));
        let keys = format!("bank_angle = {wide}\nnarrow_angle = {bank}\npin_split = {split}\npin_splay = {splay}");
        return (format!("[w]\n{keys}\nthrows = [{}]", throws(dice, count)), 2 * count, 0);
    }
    (format!("[vr]\nbank_angle = {bank}\npin_splay = {splay}\nthrows = [{}]", throws(dice, count)), count, 0)
}

fn general(dice: &mut Dice) -> Layout {
    let count = 2 + dice.below(5) as usize;
    let cylinder = |dice: &mut Dice| {
        let (throw, bank) = (angle(dice), angle(dice));
        format!("[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{}/3'\n", dice.below(20))
    };
    ((0..count).map(|_| cylinder(dice)).collect(), count, 0)
}

/// One value for all cylinders, one per cylinder, or none.
fn column(dice: &mut Dice, cylinders: usize, key: &str, values: &[&str]) -> Option<String> {
    let mut one = || values[dice.below(values.len() as u64) as usize].to_owned();
    match (one(), list(cylinders, &mut one)) {
        (value, _) if dice.below(3) == 0 => Some(format!("{key} = {value}\n")),
        (_, values) if dice.below(2) == 0 => Some(format!("{key} = [{values}]\n")),
        _ => None,
    }
}

fn mechanism(dice: &mut Dice, cylinders: usize) -> String {
    let mut keys: Vec<Option<String>> = vec![
        column(dice, cylinders, "reciprocating_mass", &["1", "'3/2'", "0.45", "'1/3'"]),
        column(dice, cylinders, "crank_radius", &["'40 mm'", "'45 mm'"]),
        column(dice, cylinders, "rotating_mass", &["'1/2'", "0.2"]),
    ];
    if let Some(ratio) = column(dice, cylinders, "rod_ratio", &["0.25", "'1/3'"]) {
        keys.extend([Some(ratio), column(dice, cylinders, "offset_ratio", &["0.05", "-0.05", "0"])]);
    }
    format!("[mechanism]\n{}", keys.into_iter().flatten().collect::<String>())
}

/// Counterweights and a balancer shaft beside the engine.
fn crankshaft(dice: &mut Dice, throws: usize) -> String {
    if throws == 0 || dice.below(3) > 0 {
        return String::new();
    }
    let (angle, position) = (angle(dice), dice.below(5));
    format!("[[counterweight]]\nangle = {angle}\nmass_radius = '1/5'\nposition = {position}\n")
}
