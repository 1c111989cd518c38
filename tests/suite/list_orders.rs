//! Does a list of values follow the order that the page of keys tells, in every form that takes one?

use crankstar::engine::{Engine, throws};

use crate::support::written::{engine as layout, float};

const CLOCKWISE: &str = "rotation = 'clockwise'\n";

/// A form with lists: the keys, and its cylinders in the order of the list, each with its angle as drawn and its crankshaft, as the page of
/// keys says them.
const LISTED: &[(&str, &str, &str)] = &[
    ("`[inline]`", "[inline]\nthrows = [0, 120]", "1 2"),
    ("`[vee]`", "[vee]\nbank_angle = 60\nthrows = [0, 120]", "−30: 1 2, 30: 3 4"),
    ("`[flat]`", "[flat]\nthrows = [0, 120]", "−90: 1 2, 90: 3 4"),
    ("`[boxer]`", "[boxer]\nstagger = 1\nthrows = [0, 120]", "−90: 1 2, 90: 3 4"),
    ("`[fan]`", "[fan]\nbanks = [40, -40, 0]\nthrows = [0, 120]", "40: 1 2, −40: 3 4, 0: 5 6"),
    ("`[vr]`", "[vr]\nbank_angle = 20\nthrows = [0, 120, 240]", "−10: 1, 10: 2, −10: 3"),
    ("`[w]`", "[w]\nbank_angle = 60\nnarrow_angle = 20\nthrows = [0, 120]", "−40: 1, −20: 2, 20: 3, 40: 4"),
    (
        "`[radial]`",
        "[radial]\ncylinders = 3\nrows = 2\nrow_rotation = 60\nrow_throw = 180",
        "0: 1, 120: 2, −120: 3, 60: 4, 180: 5, −60: 6",
    ),
    ("`[u]`", "[u]\nthrows = [0, 120]\nsense = 'against'\ndistance = 5", "left 0: 1 2, right 0: 3 4"),
    (
        "`[square_four]`",
        "[square_four]\nin_phase = 'sides'\nsense = 'against'\ndistance = 5",
        "left 0: 1 2, right 0: 3 4",
    ),
    (
        "`[h]`",
        "[h]\nthrows = [0, 120]\nsense = 'against'\ndistance = 5",
        "upper −90: 1 2, upper 90: 3 4, lower −90: 5 6, lower 90: 7 8",
    ),
    ("`[opposed_piston]`", "[opposed_piston]\nthrows = [0, 120]\nlead = 11", "lower 0: 1a 2a, upper 180: 1b 2b"),
    (
        "`[delta]`",
        "[delta]\nrows = [0, 120]\ncircumradius = 6",
        "A −30: 1ABe 2ABe, A 30: 1CAi 2CAi, B 90: 1BCe 2BCe, B 150: 1ABi 2ABi, C −150: 1CAe 2CAe, C −90: 1BCi 2BCi",
    ),
];

/// The cylinders of an engine in their order, as [`LISTED`] writes them.
fn listed(engine: &Engine) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for (index, cylinder) in engine.cylinders().iter().enumerate() {
        let drawn = float(&engine.convention().as_written(&cylinder.bank).degrees());
        let angle = if drawn > 180.0 { drawn - 360.0 } else { drawn };
        let crank = engine.crank_of(cylinder).map_or_else(String::new, |crank| format!("{} ", crank.name));
        let head = format!("{crank}{angle}").replace('-', "−");
        let name = if cylinder.name.is_empty() { (index + 1).to_string() } else { cylinder.name.clone() };
        match groups.last_mut() {
            Some((last, names)) if *last == head => names.push(name),
            _ => groups.push((head, vec![name])),
        }
    }
    let one = |(head, names): &(String, Vec<String>)| format!("{head}: {}", names.join(" "));
    groups.iter().map(one).collect::<Vec<_>>().join(", ")
}

#[test]
fn a_list_with_one_value_per_cylinder_follows_the_order_that_the_page_of_keys_tells() {
    let page = include_str!("../../src/kernel/file/README.md");
    for (form, text, order) in LISTED {
        let engine = layout(text);
        let found = listed(&engine);
        assert_eq!(found.strip_prefix("0: ").filter(|_| *form == "`[inline]`").unwrap_or(&found), *order, "{form}");
        assert!(page.contains(&format!("| {form} |")), "{form} is not in the table of the page of keys");
        let values: Vec<String> = (1..=engine.cylinders().len()).map(|value| value.to_string()).collect();
        let weighed = layout(&format!("{text}\n[mechanism]\nreciprocating_mass = [{}]", values.join(", ")));
        for (index, cylinder) in weighed.cylinders().iter().enumerate() {
            assert_eq!(float(&cylinder.reciprocating_mass), (index + 1) as f64, "{form}");
            assert_eq!(
                (&cylinder.bank, cylinder.crank),
                (&engine.cylinders()[index].bank, engine.cylinders()[index].crank)
            );
        }
    }
    // Whichever corner is the reference.
    let delta =
        |against: &str| listed(&layout(&format!("[delta]\nrows = [0]\ncircumradius = 6\nagainst = [{against}]")));
    assert!(["", "'A'", "'B'", "'C'", "'A', 'B'"].iter().all(|against| delta(against) == delta("'A'")));
    // Banks as drawn, also where the crank turns clockwise.
    for (form, text, order) in LISTED.iter().filter(|(form, ..)| !["`[delta]`", "`[radial]`"].contains(form)) {
        let found = listed(&layout(&format!("{CLOCKWISE}{text}")));
        assert_eq!(found.strip_prefix("0: ").filter(|_| *form == "`[inline]`").unwrap_or(&found), *order, "{form}");
    }
}

/// Throws by what stands on them: crankshaft after crankshaft, pin after pin from the free end, the parts of a split pin likewise, and where
/// these stand at one place in the order of their cylinders.
#[test]
fn a_list_with_one_value_per_throw_follows_the_pins_from_the_free_end() {
    for (text, right) in [
        ("[inline]\nthrows = [0, 120]", "1, 2"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]", "1 3, 2 4"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\npin_split = 30", "1, 3, 2, 4"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\npin_split = 30\nbank_offset = '-1/5'", "3, 1, 4, 2"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\nnumbering = [3, 4, 1, 2]\npin_split = 30", "1, 3, 2, 4"),
        ("[boxer]\nstagger = 1\nthrows = [0, 180]", "1, 3, 2, 4"),
        ("[boxer]\nstagger = 1\nthrows = [0, 180]\nnumbering = [2, 1, 4, 3]", "2, 4, 1, 3"),
        ("[fan]\nbanks = [-60, 0, 60]\nthrows = [0, 120]\npin_splits = [0, 0, 30]", "1 3, 5, 2 4, 6"),
        ("[h]\nthrows = [0, 180]\nsense = 'against'\ndistance = 5", "1 3, 2 4, 5 7, 6 8"),
        ("[opposed_piston]\nthrows = [0, 180]\nlead = 11", "1a, 2a, 1b, 2b"),
        ("[delta]\nrows = [0]\ncircumradius = 6", "1ABe 1CAi, 1BCe 1ABi, 1CAe 1BCi"),
        ("[delta]\nrows = [0]\ncircumradius = 6\nagainst = ['B']", "1ABe 1CAi, 1BCe 1ABi, 1CAe 1BCi"),
    ] {
        let engine = layout(text);
        let names = |index: &usize| engine.cylinders()[*index].name.clone();
        let one = |throw: &crankstar::engine::Throw| throw.cylinders.iter().map(names).collect::<Vec<_>>().join(" ");
        let all = throws(&engine);
        assert_eq!(all.iter().map(one).collect::<Vec<_>>().join(", "), right, "{text}");
        let values: Vec<String> = (1..=all.len()).map(|value| value.to_string()).collect();
        let weighed = layout(&format!("{text}\n[crankshaft]\npin_mass = [{}]", values.join(", ")));
        let masses: Vec<f64> = weighed.crankshaft().pins.iter().map(float).collect();
        assert!(masses.iter().enumerate().all(|(index, mass)| *mass == (index + 1) as f64), "{text}");
    }
}

/// The parts of a split pin stand on one disc.
#[test]
fn the_discs_of_crankpins_are_listed_pin_by_pin_a_split_one_once() {
    let torsion = "\n[torsion]\ninertias = [1, 1, 1, 1]\nstiffnesses = [1, 1, 1]\ncrankpins_at = [3, 1]";
    for (text, of_cylinders) in [
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\npin_split = 30", [3, 1, 3, 1]),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\nnumbering = 'alternating'\npin_split = 30", [3, 3, 1, 1]),
        ("[boxer]\nstagger = 1\nthrows = [0, 180]", [3, 1, 3, 1]),
        ("[flat]\nthrows = [0, 180]", [3, 1, 3, 1]),
    ] {
        let engine = layout(&format!("{text}{torsion}"));
        let shaft = engine.torsion().expect("a shaft");
        let discs: Vec<usize> = engine.cylinders().iter().map(|cylinder| shaft.pins[cylinder.pin] + 1).collect();
        assert_eq!(discs, of_cylinders, "{text}");
    }
}
