//! Are open bank angles, pin splits and lengths solved rightly, and completely?

use std::collections::{BTreeMap, BTreeSet};

use crankstar::engine::{DELTA, Family, PHI};
use crankstar::exact::Turn;
use crankstar::family::{self, NotComparable, OpenVerdict, Remaining, When};
use crankstar::file::{self, Layout};
use crankstar::numbers::Form;
use crankstar::page::{Format, Math};
use crankstar::proof::{ConditionClaim, Planar, Quantity};
use crankstar::{order, report};
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::pages;
use crate::support::written::fraction;
use crate::true_sentences::said;

const V_TWIN: &str = "vee = { bank_angle = 'phi', throws = [0] }";
const V4: &str = "vee = { bank_angle = 'phi', throws = [0, 180] }";
const V6: &str = "cycle = 'four-stroke'\nvee = { bank_angle = 'phi', throws = [0, 120, 240] }";
const V6_SPLIT: &str = "vee = { bank_angle = 'phi', throws = [0, 120, 240], pin_split = 'delta' }";
const V8: &str = "vee = { bank_angle = 'phi', throws = [0, 270, 90, 180] }";
const W: &str = "fan = { banks = ['-phi', 0, 'phi'], throws = [0, 180], positions = [0, 1] }";
const UNEQUAL: &str = "
    cylinder = [{ throw = 0, bank = '-phi/2', position = 0 },
                { throw = 0, bank = 'phi/2', position = 1, reciprocating_mass = '3/2' }]";

fn open(text: &str) -> Family {
    match file::parse_layout("test", text).expect("it reads") {
        Layout::Open(family) => *family,
        Layout::Known(..) => panic!("nothing is open in {text}"),
    }
}

fn at(values: &[(&str, BigRational)]) -> BTreeMap<String, BigRational> {
    values.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect()
}

/// Whether the verdict's sum vanishes when the unknowns have these values.
fn vanishes_at(family: &Family, verdict: &OpenVerdict, values: &BTreeMap<String, BigRational>) -> bool {
    let engine = family.with(values).expect("it is built").only().expect("nothing else is open").expect("it is built");
    order::star(&engine, verdict.quantity, verdict.order, Some(verdict.sense)).vanishes()
}

fn verdicts(family: &Family) -> Vec<OpenVerdict> {
    let orders = family::classify(family, &[1, 2, 4, 6, 8]).expect("orders");
    orders.into_iter().flat_map(|order| order.force.into_iter().chain(order.moment)).collect()
}

fn degrees(angles: &BTreeSet<Turn>) -> Vec<String> {
    angles.iter().map(|angle| angle.degrees().to_string()).collect()
}

#[test]
fn every_bank_angle_of_a_grid_vanishes_exactly_where_it_is_listed() {
    for text in [V_TWIN, V4, V6, V8, W, UNEQUAL] {
        let family = open(text);
        for verdict in verdicts(&family) {
            let listed = verdict.bank_angles();
            let grid = (1..180).map(|step| Turn::fraction(step, 180));
            let grid: BTreeSet<Turn> = grid.chain(listed.clone().unwrap_or_default()).collect();
            for phi in grid {
                let expected = verdict.always() || listed.as_ref().is_some_and(|listed| listed.contains(&phi));
                let found = vanishes_at(&family, &verdict, &at(&[(PHI, phi.turns().clone())]));
                assert_eq!(found, expected, "{text} order {} at {phi:?}", verdict.order);
            }
        }
    }
}

#[test]
fn every_pair_of_angles_of_a_grid_vanishes_exactly_on_the_lines() {
    let family = open(V6_SPLIT);
    for verdict in verdicts(&family) {
        for (phi, delta) in (0..24).flat_map(|phi| (0..24).map(move |delta| (fraction(phi, 24), fraction(delta, 24)))) {
            let on_line = verdict.sums.iter().all(|sum| match &sum.when {
                When::Always => true,
                When::Where(angles) => angles.alternatives.iter().any(|together| {
                    together
                        .conditions
                        .iter()
                        .all(|line| (&line.phi * &phi + &line.delta * &delta - &line.turn).is_integer())
                }),
                other => panic!("{other:?}"),
            });
            let found = vanishes_at(&family, &verdict, &at(&[(PHI, phi.clone()), (DELTA, delta.clone())]));
            assert_eq!(found, on_line, "order {} at {phi}, {delta}", verdict.order);
        }
    }
}

#[test]
fn v_twin_loses_its_reverse_first_order_at_90_and_its_reverse_second_order_at_60_degrees() {
    let orders = family::classify(&open(V_TWIN), &[1, 2]).expect("orders");
    let angles = |verdict: &OpenVerdict| degrees(&verdict.bank_angles().expect("solved"));
    assert!(orders[0].force[0].never());
    assert_eq!(angles(&orders[0].force[1]), ["90", "270"]);
    assert_eq!(angles(&orders[1].force[0]), ["180"]);
    assert_eq!(angles(&orders[1].force[1]), ["60", "180", "300"]);
}

#[test]
fn throws_over_a_large_denominator_cancel_at_the_same_bank_angles() {
    let family = open("vee = { bank_angle = 'phi', throws = [0, '1/2003 turn', '5/10007 turn'] }");
    let reverse = &family::classify(&family, &[1]).expect("orders")[0].force[1];
    assert_eq!(degrees(&reverse.bank_angles().expect("solved")), ["90", "270"]);
}

#[test]
fn banks_of_unequal_mass_never_cancel() {
    let orders = family::classify(&open(UNEQUAL), &[1, 2]).expect("orders");
    assert!(orders.iter().all(|order| order.force.iter().all(OpenVerdict::never)));
}

#[test]
fn v6_on_three_shared_pins_fires_evenly_at_120_and_240_degrees() {
    assert_eq!(degrees(&family::even_firing(&open(V6)).expect("the cycle is given")), ["120", "240"]);
    assert_eq!(family::even_firing(&open(V_TWIN)), None);
}

#[test]
fn even_firing_is_found_wherever_a_grid_finds_it() {
    for (throws, cycle) in
        [("0", "two-stroke"), ("0", "four-stroke"), ("0, 180", "four-stroke"), ("0, 270, 90, 180", "four-stroke")]
    {
        let family = open(&format!("cycle = '{cycle}'\nvee = {{ bank_angle = 'phi', throws = [{throws}] }}"));
        let listed = family::even_firing(&family).expect("the cycle is given");
        for phi in (1..720).map(|half_degrees| Turn::fraction(half_degrees, 720)) {
            let engine = family
                .with(&at(&[(PHI, phi.turns().clone())]))
                .expect("it is built")
                .only()
                .expect("known")
                .expect("it is built");
            let count = engine.cylinders().len() as i64;
            let turns = if cycle == "four-stroke" { 2 } else { 1 };
            let first = engine.cylinders()[0].top_dead_centre();
            let mut centres: Vec<Turn> = engine.cylinders().iter().map(|c| &c.top_dead_centre() - &first).collect();
            let mut even: Vec<Turn> = (0..count).map(|j| Turn::fraction(j * turns, count)).collect();
            centres.sort();
            even.sort();
            assert_eq!(listed.contains(&phi), centres == even, "{throws} at {phi:?}");
        }
    }
}

#[test]
fn even_firing_in_two_angles_is_found_wherever_a_grid_finds_it() {
    let vee = |bank: &str, throws: &str, split: &str| {
        format!("cycle = 'four-stroke'\nvee = {{ bank_angle = '{bank}', throws = [{throws}], pin_split = '{split}' }}")
    };
    let texts = [
        (vee("phi", "0, 120, 240", "delta"), "φ − δ"),
        (vee("phi", "0, 180", "2delta"), "φ − 2δ"),
        (vee("60", "0, 120, 240", "delta"), "δ"),
        (vee("2phi", "0, 0, 180, 180", "-4delta"), "2φ + 4δ"),
        (vee("2phi", "10, 47", "-delta"), "2φ + δ"),
    ];
    let mut fires = 0;
    for (text, shown) in texts {
        let family = open(&text);
        let even = family::even_firing_lines(&family).expect("the cycle is given");
        let page = pages::text(&report::family_answer(&family, &[]), Format::PLAIN);
        let says = if even.turns.is_empty() { "It cannot fire evenly at any bank angle and pin split" } else { shown };
        assert!(page.contains(says), "{page}");
        for (i, j) in (0..24).flat_map(|i| (0..24).map(move |j| (i, j))) {
            let [phi, delta] = [fraction(i, 24), fraction(j, 24)];
            let centres = family.cylinders().iter().map(|cylinder| {
                let centre = cylinder.bank.minus(&cylinder.throw);
                centre.known() + centre.coefficient(PHI) * &phi + centre.coefficient(DELTA) * &delta
            });
            let centres: Vec<BigRational> = centres.collect();
            let count = centres.len() as i64;
            let mut found: Vec<Turn> = centres.iter().map(|centre| Turn::new(centre - &centres[0])).collect();
            let mut wanted: Vec<Turn> = (0..count).map(|at| Turn::fraction(2 * at, count)).collect();
            found.sort();
            wanted.sort();
            let told = even.turns.contains(&Turn::new(&even.phi * &phi + &even.delta * &delta));
            assert_eq!(told, found == wanted, "{text} at {i}, {j}");
            fires += usize::from(told);
        }
    }
    assert!(fires > 100, "{fires}");
    // Each pin with a split of its own: two angles turn the centres, or none.
    let mixed = "[[cylinder]]\nthrow = 'delta'\nbank = 0\nposition = 0\n[[cylinder]]\nthrow = 'phi'\nbank = 0\nposition = 1\n\
                 [[cylinder]]\nthrow = 0\nbank = 0\nposition = 2\n";
    assert_eq!(family::even_firing_lines(&open(&format!("cycle = 'four-stroke'\n{mixed}"))), None);
    assert_eq!(family::even_firing_lines(&open(mixed)), None);
}

#[test]
fn the_cross_plane_v8_of_the_thesis_leaves_root_ten_times_its_lengths() {
    // Stabile 2019, section 5.4.2: √10 (2a + b + 2c) at −18.43°, direct; ½ · 2√10 here.
    let family =
        open("vee = { bank_angle = 90, throws = [0, 270, 90, 180], spacing = '2a + b + 2c', bank_offset = 'b' }");
    let order = &family::classify(&family, &[1]).expect("orders")[0];
    let Remaining::Factored { factor, lengths, degrees, .. } = family::remaining(&order.moment[0]) else {
        panic!("not factored")
    };
    assert_eq!((factor, lengths.to_string().as_str()), (Form::parse("2√10").expect("a number"), "2a + b + 2c"));
    assert_eq!(format!("{degrees:.4}"), "-18.4349");
    assert!(order.moment[1].always());
}

#[test]
fn the_flat_plane_v8_of_the_thesis_keeps_second_order_moments_only_through_its_bank_offset() {
    let text = "vee = { bank_angle = 90, throws = [0, 180, 180, 0], spacing = '2a + b + 2c', bank_offset = 'b' }";
    let order = &family::classify(&open(text), &[2]).expect("orders")[0];
    for verdict in &order.moment {
        let Remaining::Factored { factor, lengths, .. } = family::remaining(verdict) else { panic!("not factored") };
        assert_eq!((factor, lengths.to_string().as_str()), (Form::parse("2√2").expect("a number"), "b"));
    }
    let without = text.replace(", bank_offset = 'b'", "");
    assert!(family::classify(&open(&without), &[2]).expect("orders")[0].moment.iter().all(OpenVerdict::always));
}

#[test]
fn what_factors_out_agrees_with_the_sum_at_any_lengths() {
    let texts = [
        "vee = { bank_angle = 90, throws = [0, 270, 90, 180], spacing = '2a + b + 2c', bank_offset = 'b' }",
        "vee = { bank_angle = 60, throws = [0, 120, 240], spacing = 'a', bank_offset = 'b' }",
        "vee = { bank_angle = 90, throws = [0, 180], spacing = 'a', bank_offset = 'b' }",
        "inline = { throws = [0, 120, 240], positions = ['a', 0, '-b'] }",
        "inline = { throws = [0, 180, 180, 0], positions = ['a', 'b', 'c', 'd'] }",
    ];
    for text in texts {
        let family = open(text);
        for verdict in verdicts(&family).iter().filter(|verdict| verdict.quantity == Planar::Moment) {
            let values =
                at(&[("a", fraction(7, 3)), ("b", fraction(2, 5)), ("c", fraction(11, 7)), ("d", fraction(13, 9))]);
            let engine = family.with(&values).expect("it is built").only().expect("known").expect("it is built");
            let sum = order::star(&engine, Quantity::MOMENT, verdict.order, Some(verdict.sense));
            match family::remaining(verdict) {
                Remaining::Nothing => assert!(sum.vanishes() && verdict.always()),
                Remaining::Factored { factor, lengths, .. } => {
                    let value = lengths.with(&values).as_known().expect("known").clone();
                    let expected = factor.scaled(&num_traits::abs(value));
                    assert_eq!(crankstar::numbers::modulus(&sum).expect("small"), expected, "{text}");
                }
                Remaining::Apart => assert!(!verdict.always()),
                Remaining::Open => panic!("no angle is open"),
            }
        }
    }
}

#[test]
fn values_close_a_family_and_keep_it_beside() {
    let text = "values = { a = '22 mm', b = '16 mm', c = '30 mm' }\n\
                vee = { bank_angle = 90, throws = [0, 180, 180, 0], spacing = '2a + b + 2c', bank_offset = 'b' }";
    let Layout::Known(engine, Some(family)) = file::parse_layout("v8", text).expect("it reads") else { panic!("open") };
    assert_eq!(engine.cylinders()[0].position.to_string(), "47/250");
    assert_eq!(family.unknowns().into_iter().collect::<Vec<_>>(), ["a", "b", "c"]);
    assert_eq!(file::parse("v8", text).expect("it is known").cylinders(), engine.cylinders());
}

#[test]
fn mistakes_about_unknowns_are_told() {
    let message = |text: &str| file::parse("test", text).expect_err(text).to_string();
    assert!(message(V_TWIN).contains("leaves phi open"));
    assert!(message("values = { d = 1 }\ninline.throws = [0]").contains("no unknown `d`"));
    assert!(
        message("values = { phi = 'x' }\nvee = { bank_angle = 'phi', throws = [0] }")
            .contains("cannot read the angle `x`")
    );
    assert!(message("vee = { bank_angle = 'psi', throws = [0] }").contains("cannot read the angle `psi`"));
    assert!(
        message(&format!("cycle = 'four-stroke'\nfiring_order = '1-3'\n{V_TWIN}"))
            .contains("names `3`, which is not a cylinder")
    );
    assert!(message(&format!("firing_order = '1-2'\n{V_TWIN}")).contains("depends on the cycle, which is missing"));
}

#[test]
fn reports_on_families_are_written_in_every_format() {
    for text in [V_TWIN, V6_SPLIT, W, UNEQUAL] {
        let family = open(text);
        let orders = family::classify(&family, family.orders()).expect("orders");
        let page = report::family_page(&family, &orders, false);
        for format in [Format::GITHUB, pages::DOLLARS, Format::Latex, Format::Html, Format::PLAIN] {
            let written = pages::text(&page, format);
            assert!(written.contains("Free parameter") && written.contains("opposite") || text == UNEQUAL || text == W);
        }
    }
}

#[test]
fn a_family_whose_rods_differ_or_weigh_nothing_is_not_judged_as_one_star() {
    let vee = "[vee]\nbank_angle = \"phi\"\nthrows = [0]\n[mechanism]\n";
    let of = |mechanism: &str| family::comparable(&open(&format!("{vee}{mechanism}")));
    assert_eq!(of("rod_ratio = 0.3"), Ok(()));
    assert_eq!(of("rod_ratio = [0.25, 0.3]"), Err(NotComparable::RodsDiffer));
    assert_eq!(of("rod_ratio = 0.3\noffset_ratio = [0.1, -0.1]"), Err(NotComparable::RodsDiffer));
    assert_eq!(of("reciprocating_mass = 0"), Err(NotComparable::NoMass));
}

#[test]
fn three_parts_of_which_two_are_mirror_images_vanish_where_a_cosine_says_so() {
    // A middle bank of mass m between two of mass 1: reverse of order 1 is m + 2 cos 2φ, or with a throw turned, m + 2 cos(2φ + 60°).
    for (mass, turned) in [("1/2", 0), ("3/2", 0), ("2/3", 30), ("7/5", 30)] {
        let text = format!(
            "cylinder = [{{ throw = -{turned}, bank = '-phi', position = 0 }}, {{ throw = 0, bank = 0, position = 0, reciprocating_mass = '{mass}' }},
                         {{ throw = {turned}, bank = phi, position = 0 }}]"
        )
        .replace("bank = phi", "bank = 'phi'");
        let family = open(&text);
        let reverse = &family::classify(&family, &[1]).expect("orders")[0].force[1];
        let [sum] = reverse.sums.as_slice() else { panic!("{reverse:?}") };
        let When::Cosine(found) = &sum.when else { panic!("{text}: {:?}", sum.when) };
        let float = |value: &BigRational| value.to_f64().expect("a number");
        // At the angles of the condition the sum is 0 in decimals; between them it is not.
        let mass = float(&crankstar::file::parse_number(mass).expect("a mass"));
        for sign in [1.0, -1.0] {
            let argument = sign * float(&found.cosine).acos() - std::f64::consts::TAU * float(&found.turn);
            let phi = argument / float(&found.phi);
            let star = mass + 2.0 * (2.0 * phi - f64::from(turned).to_radians()).cos();
            assert!(star.abs() < 1e-12, "{text}: {star}");
        }
    }
}

#[test]
fn an_order_that_no_piston_has_is_said_to_be_missing_and_is_nowhere_large() {
    let text = |rods: &str| {
        let layout = format!("vee = {{ bank_angle = \"phi\", throws = [0, 120, 240] }}\nmechanism = {{ {rods} }}\n");
        let family = open(&layout);
        let orders = family::classify(&family, &[1, 3, 4]).expect("orders");
        let told = pages::text(&report::family_answer(&family, &orders), Format::PLAIN);
        (orders, told)
    };
    for rods in ["rod_ratio = 0.3", "scotch_yoke = true"] {
        let (orders, told) = text(rods);
        assert!(orders[1].force.iter().chain(&orders[1].moment).all(OpenVerdict::always), "{rods}");
        assert_eq!(told.matches("does not exist").count(), if rods.contains("yoke") { 8 } else { 4 }, "{rods}: {told}");
        assert!(!told.contains("at order 3") && !told.contains("(order 3)"), "{rods}: {told}");
    }
    let (orders, told) = text("crank_radius = 1, rod_length = 4, pin_offset = 0.5");
    assert!(!orders[1].force[0].always() && !told.contains("does not exist"), "{told}");
}

#[test]
fn a_moment_of_several_lengths_vanishes_in_words_only_where_the_moment_of_any_lengths_does() {
    let throws = ["0, 90, 120", "0, 180", "0, 120, 240", "0, 90, 270, 180", "0"];
    let mut joined = 0;
    for text in throws.map(|throws| {
        format!("vee = {{ bank_angle = 60, pin_split = \"delta\", throws = [{throws}], bank_offset = \"b\" }}")
    }) {
        let family = open(&text);
        let orders = family::classify(&family, &[1, 2, 4, 6]).expect("orders");
        for verdict in orders.iter().flat_map(|order| order.moment.iter()) {
            let lengths = [(1, 7), (3, 5)].map(|(over, under)| ("b", fraction(over, under)));
            let zeros = (0..360).map(|degrees| fraction(degrees, 360)).filter(|delta| {
                let both = |(name, length): &(&str, BigRational)| {
                    vanishes_at(&family, verdict, &at(&[(*name, length.clone()), (DELTA, delta.clone())]))
                };
                lengths.iter().all(both)
            });
            let zeros: BTreeSet<Turn> = zeros.map(Turn::new).collect();
            joined += usize::from(verdict.sums.len() > 1 && !zeros.is_empty());
            assert_eq!(verdict.always(), zeros.len() == 360, "{text} order {}", verdict.order);
            let never = verdict.never() || verdict.meeting().is_some_and(|met| met.is_empty());
            assert_eq!(never, zeros.is_empty(), "{text} order {}", verdict.order);
        }
        let told = pages::text(&report::family_answer(&family, &orders), Format::PLAIN);
        assert!(!told.contains("; and 0"), "{told}");
    }
    assert!(joined > 2, "{joined}");
}

#[test]
fn conditions_on_both_angles_that_exclude_each_other_are_never_met() {
    // The force of two lengths: 2φ − δ ≡ 180° of one, 2φ − δ ≡ 0° of the other.
    let text = "cylinder = [
        { throw = 0, bank = '-phi', position = 'a' }, { throw = 'delta', bank = 'phi', position = 'a' },
        { throw = 0, bank = '-phi', position = 'b' }, { throw = 'delta + 180', bank = 'phi', position = 'b' },
        { throw = 0, bank = 0, position = 0 }]
        reference_plane = 0";
    let family = open(text);
    let orders = family::classify(&family, &[1]).expect("an order");
    for verdict in &orders[0].moment {
        assert_eq!(verdict.meeting(), Some(Vec::new()), "{:?}", verdict.sums);
    }
    let page = pages::text(&report::family_page(&family, &orders, false), Format::Markdown(Math::Dollars));
    assert!(page.contains("No angles meet the conditions of all lengths at once."), "{page}");
}

#[test]
fn counterweights_cancel_order_1_only_where_it_remains() {
    let told = |form: &str| {
        let family = open(&format!("{form}\nmechanism = {{ rod_ratio = 0.25 }}"));
        let orders = family::classify(&family, &[1, 2]).expect("orders");
        pages::text(&report::family_answer(&family, &orders), Format::PLAIN).replace('\n', " ")
    };
    let twin = told("u = { throws = [0, 180], sense = 'against', phase = 'phi', distance = 3 }");
    assert!(twin.contains("At φ = 180° order 1 vanishes; order 2 remains: force 4"), "{twin}");
    let vee = told(V_TWIN);
    assert!(vee.contains("counterweights cancel order 1") && !vee.contains("order 1 vanishes"), "{vee}");
}

#[test]
fn a_family_with_masses_that_turn_says_that_it_is_about_the_pistons() {
    let told = |masses: &str| {
        let family = open(&format!("{V4}\nmechanism = {{ reciprocating_mass = 1{masses} }}"));
        let orders = family::classify(&family, &[1, 2]).expect("orders");
        pages::text(&report::family_answer(&family, &orders), Format::PLAIN)
    };
    let says = "The pistons alone.";
    assert!(!told("").contains(says) && !told(", rotating_mass = 0").contains(says));
    assert!(told(", rotating_mass = [0, 0, 0, '1/3']").contains(says));
}

#[test]
fn the_largest_value_is_that_of_angles_in_the_range_where_fractions_of_them_enter() {
    let banks = |splits: &str| {
        format!(
            "fan = {{ banks = ['-phi/2', 0, 'phi/2'], pin_splits = [{splits}], throws = [0] }}\nmechanism = {{ rod_ratio = 0.25 }}"
        )
    };
    let quarter = "reference_plane = 0\nmechanism = { rod_ratio = 0.25 }\ncylinder = [{ throw = 0, bank = 0, position = 0 }, { throw = '90 + phi/4', bank = 0, position = 1 }]";
    for (text, order, largest) in [
        // At 0° and at 360°: c₂ = 0.254 of two vectors of length 2.
        (banks("30, 0, -30"), 2, "0.508 m r ω² (order 2)"),
        (banks("60, 0, -60"), 2, "0.508 m r ω² (order 2)"),
        // √2, at 0°: beyond it the two throws come opposite.
        (quarter.to_owned(), 1, "1.41 m r ω² (order 1)"),
    ] {
        let family = open(&text);
        let orders = family::classify(&family, &[order]).expect("an order");
        let told = pages::text(&report::family_answer(&family, &orders), Format::PLAIN).replace('\n', " ");
        assert!(told.contains(largest), "{told}");
    }
}

#[test]
fn a_third_condition_on_both_angles_is_asked_of_where_the_first_two_meet() {
    let condition = |phi: i64, delta: i64, turn: BigRational| ConditionClaim {
        phi: fraction(phi, 1),
        delta: fraction(delta, 1),
        turn,
    };
    let (sixth, quarter) = (fraction(1, 6), fraction(1, 4));
    let both = [condition(1, 0, sixth.clone()), condition(0, 1, quarter.clone())];
    for (third, expected) in [(&sixth + &quarter, true), (fraction(1, 3), false)] {
        let all = [both.as_slice(), &[condition(1, 1, third)]].concat();
        assert_eq!(family::in_range(&all).is_some(), expected);
    }
}

#[test]
fn the_conditions_of_several_lengths_are_told_once_each_and_lists_of_alternatives_in_brackets() {
    let vee = "orders = [1]\nvee = { bank_angle = 'phi', throws = [0, 'delta'], SIZES, bank_offset = 'b' }\n";
    let text = |sizes: &str| said("report", &vee.replace("SIZES", sizes), &["--format", "markdown"]);
    let apart = text("spacing = 'a'");
    let told = "(0 where δ ≡ 0°; 0 where 2φ ≡ 180°) and at once (0 where δ ≡ 180°; 0 where 2φ ≡ 0°) for all lengths";
    assert!(apart.contains(told), "{apart}");
    let placed = text("positions = ['a+c', '-d']");
    assert!(placed.contains("| 0 where δ ≡ 0° for all lengths |"), "{placed}");
}

#[test]
fn throws_that_are_open_are_called_angles_and_no_pin_split() {
    let throws = said("report", "orders = [1]\ninline = { throws = ['phi', 'delta', 0] }\n", &["--format", "markdown"]);
    assert!(throws.contains("Largest value of order 1 over the angles φ and δ, "), "{throws}");
    let throw = said("report", "orders = [1]\ninline = { throws = [0, 'delta'] }\n", &["--format", "markdown"]);
    assert!(throw.contains("over the angle δ.") && !throw.contains("the pin split δ"), "{throw}");
    assert!(said("report", V6_SPLIT, &["--format", "markdown"]).contains("over bank angle and pin split, "));
}

#[test]
fn a_difference_of_lengths_is_told_by_its_size_and_where_it_turns_round() {
    let two =
        said("report", "orders = [1]\ninline = { throws = [0, 180], positions = ['a', 'b'] }\n", &["--format", "text"]);
    assert!(two.contains("length |a − b|, angle 0°, turned by 180° where a − b is negative."), "{two}");
}

/// A condition may hold at an end of the range alone: φ/2 ≡ 180° is φ = 360°.
#[test]
fn angles_are_called_complete_in_their_range_and_not_those_in_it() {
    let told = said("report", V_TWIN, &["--format", "markdown"]);
    assert!(told.contains("Angles are complete for unknowns in (0°, 360°), and exact unless marked ≈;"), "{told}");
}
