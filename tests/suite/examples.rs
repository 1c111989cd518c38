//! Do the examples build, and what do they print?

#[path = "../../examples/balance.rs"]
#[allow(dead_code)]
mod balance;
#[path = "../../examples/build.rs"]
#[allow(dead_code)]
mod build;
#[path = "../../examples/firing_orders.rs"]
#[allow(dead_code)]
mod firing_orders;

#[test]
fn an_engine_is_built_without_a_file() {
    let said = build::run().expect("an engine, and certificates that hold");
    let wanted = "\
In-line three
order 1: force is 0, moment is not 0, proved
order 2: force is 0, moment is not 0, proved
order 4: force is 0, moment is not 0, proved
order 6: force is not 0, moment is 0, proved
";
    assert_eq!(said, wanted);
}

#[test]
fn firing_orders_are_compared() {
    let wanted = "\
The best of 120 stars:
1-5-3-4-2-6  order 1: 0  order 2: 2√3  stars alike: 2
1-4-3-5-2-6  order 1: √3  order 2: 3  stars alike: 4
1-4-3-6-2-5  order 1: 3  order 2: √3  stars alike: 4
1-5-3-6-2-4  order 1: 2√3  order 2: 0  stars alike: 2
";
    assert_eq!(firing_orders::run().expect("a front"), wanted);
}

#[test]
fn an_engine_is_balanced() {
    let wanted = "\
V8, 90°, cross-plane crankshaft; balancer shafts: 0
at 3/2: √10/3 m r, turned 161.6°
at -3/2: √10/3 m r, turned -18.4°
Residual: none, proved
";
    assert_eq!(balance::run().expect("a remedy"), wanted);
}
