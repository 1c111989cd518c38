//! An engine without a file: built, judged, and its evidence checked. `cargo run --example build`

use std::error::Error;

use crankstar::{BigRational, Cylinder, Draft, Masses, Quantity, Turn, check_certificate, classify};

/// Three cylinders in a row, their throws 120° apart: the lines that say how they balance.
pub fn run() -> Result<String, Box<dyn Error>> {
    let mut draft = Draft::new("In-line three");
    for place in 0..3_i32 {
        let throw = Turn::fraction(place.into(), 3);
        let position = BigRational::from_integer(place.into());
        draft.cylinders.push(Cylinder::new(throw, Turn::zero(), position, place as usize));
    }
    let engine = draft.build()?;
    let mut lines = format!("{}\n", engine.title().written());
    for judged in classify(&engine, engine.orders(), Masses::All, &Quantity::PLANAR)? {
        let balances = judged.parts.iter().flat_map(|part| [&part.force, &part.moment]);
        for verdict in balances.flat_map(|balance| balance.verdicts()) {
            // The checker reads the terms and the evidence, and knows nothing of how it was found.
            check_certificate(&verdict.sum.vectors(), verdict.vanishes(), &verdict.certificate)?;
        }
        let is = |balanced| if balanced { "is 0" } else { "is not 0" };
        let [force, moment] = [&judged.force, &judged.moment].map(|whole| is(whole.is_balanced()));
        lines += &format!("order {}: force {force}, moment {moment}, proved\n", judged.order);
    }
    Ok(lines)
}

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", run()?);
    Ok(())
}
