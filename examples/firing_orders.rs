//! Which firing order leaves a two-stroke six the least? `cargo run --example firing_orders`

use std::error::Error;

use crankstar::Cycle;
use crankstar::search::{Options, Problem, search};

/// The crank stars that no other beats in the free moments of orders 1 and 2, best first order first.
pub fn run() -> Result<String, Box<dyn Error>> {
    let six = Problem::inline(6, Cycle::TwoStroke, &[1, 2]);
    let front = search(&six, &Options::default())?;
    let mut lines = format!("The best of {} stars:\n", front.all);
    for star in &front.stars {
        let order: Vec<String> = star.firing_order.iter().flatten().map(|place| (place + 1).to_string()).collect();
        lines += &order.join("-");
        for moment in &star.moments {
            // In closed form where one is short enough to read.
            let length = moment.modulus().map_or_else(|| format!("{:.4}", moment.decimal), |form| form.to_string());
            lines += &format!("  order {}: {length}", moment.order);
        }
        if let Some(stars) = star.stars {
            lines += &format!("  stars alike: {stars}\n");
        }
    }
    Ok(lines)
}

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", run()?);
    Ok(())
}
