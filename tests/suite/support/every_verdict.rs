//! Which verdicts do tests of words try? All on the catalogue, and on engines of every form at random.

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::verdict::{Balance, Verdict};

use super::dice::Dice;
use super::{engines, verdicts};

const ORDERS: [u32; 6] = [1, 2, 3, 4, 6, 8];

/// The catalogue, and engines of every form at random.
pub fn all_engines() -> Vec<Engine> {
    let mut all: Vec<Engine> = file::catalogue().expect("it reads").into_iter().map(|(_, engine)| engine).collect();
    let mut dice = Dice::new(12);
    for form in engines::FORMS.iter().filter(|form| **form != "open") {
        for _ in 0..12 {
            all.extend(file::parse("layout.toml", &format!("title = 'engine'\n{}", engines::file(&mut dice, form))));
        }
    }
    all
}

/// Every verdict on an engine.
pub fn all_verdicts(engine: &Engine) -> Vec<Verdict> {
    let of = |balance: &Balance| balance.verdicts().map(Clone::clone);
    let orders = verdicts::judged(engine, &ORDERS, true);
    let parts = orders.iter().flat_map(|order| &order.parts);
    let mut all: Vec<Verdict> = parts.flat_map(|part| [of(&part.force), of(&part.moment)].concat()).collect();
    let torques = orders.iter().filter_map(|order| order.torque.as_ref()).flat_map(|torque| &torque.parts);
    all.extend(torques.map(|part| part.verdict.clone()));
    all
}
