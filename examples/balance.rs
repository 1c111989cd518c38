//! Which weights cancel the residual of an engine of the catalogue? `cargo run --example balance`

use std::error::Error;

use crankstar::remedy::{Request, remedy};

/// Each weight of the remedy of a cross-plane V8: where it is and how large it is.
pub fn run() -> Result<String, Box<dyn Error>> {
    let engine = crankstar::find("V8-crossplane").ok_or("it is in the catalogue")?.engine()?;
    let remedy = remedy(&engine, &Request { orders: vec![1, 2], ..Request::default() })?;
    let mut lines = format!("{}; balancer shafts: {}\n", engine.title().written(), remedy.shafts.len());
    for weight in remedy.weights() {
        // Without masses in the layout, in multiples of reciprocating mass times crank radius.
        let size = weight.modulus().map_or_else(String::new, |form| form.to_string());
        let [_, degrees] = weight.decimals(&remedy.subject).ok_or("its first order has no open coefficient")?;
        lines += &format!("at {}: {size} m r, turned {degrees:.1}°\n", weight.position);
    }
    // The sums of the engine with its weights, formed anew.
    lines += if remedy.holds() { "Residual: none, proved\n" } else { "There is a residual\n" };
    Ok(lines)
}

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", run()?);
    Ok(())
}
