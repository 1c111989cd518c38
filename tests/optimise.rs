//! Are the counterweights that `optimise` finds the best, exact, and written as it says?

#![allow(clippy::disallowed_types)]

use crankstar::layout::{Layout, parse};
use crankstar::optimise::{Couple, Front, Left, Wish, front};

fn thesis(engine: &str) -> Layout {
    let path = format!("{}/reports/optimise/thesis-{engine}/layout.toml", env!("CARGO_MANIFEST_DIR"));
    parse("layout.toml", &std::fs::read_to_string(path).expect("a layout file")).expect("it reads")
}

fn found(engine: &str, points: usize) -> Front {
    let layout = thesis(engine);
    let wish = Wish { couple: Couple::Zero, points, orders: layout.orders.clone() };
    front(&layout, &wish).unwrap_or_else(|refused| panic!("{refused}"))
}

#[test]
fn probe() {
    for engine in ["i3", "v8-flatplane", "v8-crossplane"] {
        let now = std::time::Instant::now();
        let front = found(engine, 9);
        let newtons = front.points[0].design.scale.as_ref().unwrap().force();
        for point in &front.points {
            println!(
                "{engine} {} {:.3} least {:.3} {:?} {:?}",
                point.design.mass,
                point.design.peak() * newtons,
                point.least * newtons,
                point.design.worst,
                (point.design.force, point.design.couple)
            );
        }
        for u in &front.uniform {
            println!(
                "{} {} {:.3} {:?} best {:?}",
                u.factor,
                u.design.mass,
                u.design.peak() * newtons,
                u.design.couple,
                u.best.as_ref().map(|b| b.design.peak() * newtons)
            );
        }
        println!("{}", front.points[4].layout.file);
        println!("{:?}", now.elapsed());
    }
}
