//! An engine without a file: built, judged, and its evidence checked. `cargo run --example build`

use std::error::Error;

use crankstar::{BigRational, Cylinder, Draft, Quantity, Sense, Turn, check_certificate, order};

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
    for quantity in [Quantity::Force, Quantity::Moment] {
        for number in engine.orders() {
            let sum = order::star(&engine, quantity, *number, Some(Sense::Direct));
            // The checker reads the terms and the evidence, and knows nothing of how it was found.
            check_certificate(&sum.vectors(), sum.vanishes(), &sum.certificate())?;
            let is = if sum.vanishes() { "is 0" } else { "is not 0" };
            lines += &format!("direct {} of order {number} {is}, proved\n", quantity.name());
        }
    }
    Ok(lines)
}

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", run()?);
    Ok(())
}
