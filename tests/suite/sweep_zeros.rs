//! Are the exact zeros of a sweep those of its engines, all of them and no others?

use crankstar::engine::PHI;
use crankstar::family::{self, Component, component_zeros};
use crankstar::file::{Key, Layout, Template};
use crankstar::proof::{Planar, Quantity, Sense};
use crankstar::sweep::{self, Geometry, Parameter, Sweep, SweptEngine, Zeros};
use crankstar::{page, report};

use crate::support::dice;
use crate::support::written::fraction;
use crate::sweep::{V6, good, in_plain_text, run};

fn zeros(sweep: &Sweep, quantity: Planar, order: u32, of: Zeros) -> Vec<String> {
    let sets = sweep.zeros.as_ref().expect("an angle");
    let set = sets.iter().find(|set| set.quantity == quantity && set.order == order && set.of == of).expect("a set");
    assert!(set.complete, "{quantity:?} {order} {of:?}");
    match set.everywhere {
        true => vec!["everywhere".to_owned()],
        false => set.at.iter().map(ToString::to_string).collect(),
    }
}

#[test]
fn exact_zeros_of_the_six_with_shared_pins_lie_at_their_angles_and_not_on_the_grid() {
    let sweep = good(V6, &["vee.bank_angle=10..180:50"], &[1, 2, 4, 6]);
    let moment = |order, of| zeros(&sweep, Planar::Moment, order, of);
    assert!(moment(1, Zeros::Along).is_empty(), "this range ends at 160");
    let sweep = good(V6, &["vee.bank_angle=10..180:17"], &[1, 2, 4, 6]);
    let moment = |order, of| zeros(&sweep, Planar::Moment, order, of);
    assert_eq!(moment(1, Zeros::Along), ["180"]);
    assert_eq!(moment(1, Zeros::Reverse), ["90"]);
    assert!(moment(1, Zeros::Largest).is_empty() && moment(1, Zeros::Across).is_empty());
    assert_eq!(moment(2, Zeros::Along), ["90", "180"]);
    assert_eq!(moment(2, Zeros::Reverse), ["60", "180"]);
    assert_eq!(moment(2, Zeros::Largest), ["180"]);
    assert_eq!(moment(4, Zeros::Along), ["45", "135", "180"]);
    assert_eq!(moment(4, Zeros::Across), ["90", "180"]);
    assert_eq!(zeros(&sweep, Planar::Force, 6, Zeros::Reverse), ["180/7", "540/7", "900/7", "180"]);
    assert_eq!(zeros(&sweep, Planar::Force, 1, Zeros::Largest), ["everywhere"]);
    let on_curve = sweep.curve.iter().any(|point| point.values[0] == fraction(180, 7));
    assert!(on_curve, "the curve passes its exact zeros");
}

#[test]
fn a_range_that_holds_0_has_its_zero_there() {
    let sweep = good(V6, &["vee.bank_angle=0..30:10"], &[1, 2]);
    assert_eq!(zeros(&sweep, Planar::Moment, 1, Zeros::Across), ["0"]);
    let split = good(V6, &["vee.pin_split=-90..90:7"], &[1]);
    // The pins of a pair stand opposite at a split of half a turn, outside the first range and at both ends of the second.
    assert!(zeros(&split, Planar::Moment, 1, Zeros::Direct).is_empty());
    let split = good(V6, &["vee.pin_split=-1/2..1/2:1/3 turn"], &[1]);
    assert_eq!(zeros(&split, Planar::Moment, 1, Zeros::Direct), ["-1/2", "1/2"]);
}

#[test]
fn components_vanish_where_every_grid_of_whole_degrees_says_so() {
    for throws in ["[0, 240, 120]", "[0, 270, 90, 180]", "[0, 180]", "[0, 72, 144, 216, 288]"] {
        let text = format!("[vee]\nbank_angle = \"phi\"\nthrows = {throws}\n");
        let template = Template::new("v.toml", &text).expect("TOML");
        let Ok(Layout::Open(open)) = template.layout(&[]) else { panic!("it is open") };
        let key = Key::parse("vee.bank_angle").expect("a key");
        for order in [1, 2, 3, 4] {
            for (component, sign) in [(Component::Along, 1.0), (Component::Across, -1.0)] {
                let (none, turn) = (fraction(0, 1), fraction(1, 1));
                let found = component_zeros(&open, Planar::Moment, order, component, (PHI, [&none, &turn]));
                for degrees in (9..360).step_by(9).chain((15..360).step_by(15)) {
                    let Ok(Layout::Known(layout, _)) = template.layout(&[(&key, &degrees.to_string())]) else {
                        panic!("it is known")
                    };
                    let sum = |sense| {
                        crankstar::numbers::evaluate(&crankstar::order::star(
                            &layout,
                            Quantity::MOMENT,
                            order,
                            Some(sense),
                        ))
                    };
                    let value = sum(Sense::Direct) + sum(Sense::Reverse).conj() * sign;
                    let at = match &found {
                        family::Zeros::Everywhere => true,
                        family::Zeros::At(found) => found.exact.contains(&fraction(degrees, 360)),
                        family::Zeros::NotSolved => panic!("{throws} {order} is not solved"),
                    };
                    assert_eq!(at, value.norm() < 1e-12, "{throws} order {order} {component:?} at {degrees}");
                }
            }
        }
    }
}

#[test]
fn what_is_zero_at_a_point_stands_among_the_zeros() {
    let mut dice = dice::Dice::new(815);
    let mut zeros = 0;
    for round in 0..24 {
        let count = 1 + dice.below(4);
        let throws: Vec<String> = (0..count).map(|_| (30 * dice.below(12)).to_string()).collect();
        let masses =
            ["", "[mechanism]\nreciprocating_mass = 2\nrotating_mass = 1\n[crankshaft]\nbalance_factor = 0.5\n"];
        let text = format!(
            "[vee]\nbank_angle = 90\nthrows = [{}]\npin_split = {}\n{}",
            throws.join(", "),
            30 * dice.below(4),
            masses[round % 2]
        );
        let sweep = match run(&text, &["vee.bank_angle=0..180:15"], &[1, 2, 3]) {
            Ok(sweep) => sweep,
            // Counterweights of split pins are not sized so.
            Err(_) => continue,
        };
        let sets = sweep.zeros.as_ref().expect("an angle");
        for set in sets.iter().filter(|set| set.exists) {
            for point in &sweep.points {
                let order = point.orders.iter().find(|order| order.order == set.order).expect("the order");
                let part = if set.quantity == Planar::Force { order.force } else { order.moment };
                let is_zero = match set.of {
                    Zeros::Direct => part.direct,
                    Zeros::Reverse => part.reverse,
                    Zeros::Largest => part.largest,
                    Zeros::Along => part.along,
                    Zeros::Across => part.across,
                }
                .vanishes;
                let is_listed = set.everywhere || set.at.contains(&point.values[0]);
                assert_eq!(is_zero, is_listed, "{text}\n{set:?} at {}", point.values[0]);
                zeros += usize::from(is_zero);
            }
        }
    }
    assert!(zeros > 100, "{zeros}");
}

#[test]
fn irrational_zeros_are_listed_with_decimals_and_drawn_as_such() {
    // The reverse force is (x² − x/2 + 1)(x + 2) with x = e^{iφ}: 0 where cos φ = 1/4.
    let text = "values = { phi = 60 }\ncylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
        { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 0 }]";
    let sweep = good(text, &["values.phi=0..360:30"], &[1]);
    let sets = sweep.zeros.as_ref().expect("an angle");
    let set = sets.iter().find(|set| set.quantity == Planar::Force && set.of == Zeros::Reverse).expect("a set");
    assert!(set.complete && set.at.is_empty() && set.irrational.len() == 2, "{set:?}");
    let page = report::sweep_page(&sweep);
    let drawn: Vec<String> =
        page::write(&page, page::Format::GITHUB, &page::Options::default()).into_iter().map(|file| file.text).collect();
    let [markdown, svg] = drawn.as_slice() else { panic!("{} files", drawn.len()) };
    assert!(markdown.contains("≈ 75.52°, ≈ 284.5°"), "{markdown}");
    assert!(svg.contains("one vector zero, irrational") && svg.contains("≈ 75.52°"), "{svg}");
}

#[test]
fn a_vector_that_the_angle_does_not_turn_is_never_zero_or_always_beside_masses_that_turn() {
    let pistons = "[vee]\nbank_angle = 60\nthrows = [0, 180]\n[mechanism]\nreciprocating_mass = 2\nrod_ratio = 0.25\n";
    let set = |masses: &str, quantity, of| {
        let sweep = good(&format!("{pistons}{masses}"), &["vee.bank_angle=0..180:30"], &[1]);
        let sets = sweep.zeros.expect("an angle");
        sets.into_iter().find(|set| set.quantity == quantity && set.of == of).expect("it is asked for")
    };
    let unlike = "rotating_mass = [0.5, 0.25, 0.5, 0.25]\n";
    for of in [Zeros::Direct, Zeros::Largest] {
        for quantity in [Planar::Force, Planar::Moment] {
            let set = set(unlike, quantity, of);
            assert!(set.complete && set.at.is_empty() && !set.everywhere, "{set:?}");
        }
    }
    // Counterweights that cancel the moment of the direct vector do it at every bank angle.
    let balanced =
        "rotating_mass = 0.5\ncrank_radius = 0.05\n[crankshaft]\nbalance_factor = 1\ncounterweight_radius = 0.1\n";
    let direct = set(balanced, Planar::Moment, Zeros::Direct);
    assert!(direct.everywhere && direct.complete, "{direct:?}");
}

#[test]
fn an_order_that_no_piston_has_is_zero_in_a_sweep_without_rods_too() {
    for (text, key) in [
        ("vee = { bank_angle = 60, throws = [0, 90], bank_offset = \"1/5\" }", "vee.bank_angle=30..90:30"),
        ("boxer = { throws = [0, 90], spacing = 1, stagger = \"1/4\" }", "boxer.spacing=1..3:1"),
        ("[radial]\ncylinders = 3\n", "radial.cylinders=3..9:1"),
    ] {
        for rods in ["", "mechanism = { rod_ratio = 0.25 }\n"] {
            let sweep = good(&format!("{rods}{text}"), &[key], &[1, 2, 3]);
            for point in &sweep.points {
                let third = &point.orders[2];
                assert!(third.force.largest.vanishes && third.moment.largest.vanishes, "{rods}{text}: {third:?}");
            }
            let first =
                |point: &SweptEngine| point.orders[0].force.largest.vanishes && point.orders[0].moment.largest.vanishes;
            assert!(!sweep.points.iter().all(first), "{rods}{text}");
        }
    }
}

#[test]
fn beside_a_shaft_of_an_order_that_no_piston_has_the_other_vector_is_zero_everywhere() {
    let vee = "[vee]\nbank_angle = 60\nthrows = [0, 180]\nspacing = \"100 mm\"\n[mechanism]\ncrank_radius = \"40 mm\"\nrod_length = \"140 mm\"\nreciprocating_mass = 0.5\n";
    for (turns, other) in [("against", Zeros::Direct), ("with", Zeros::Reverse)] {
        let shaft = format!(
            "[[balancer]]\norder = 3\nsense = \"{turns}\"\nmass_radius = \"1 kg mm\"\nangle = 180\nposition = \"-50 mm\"\n"
        );
        let sweep = good(&format!("{vee}{shaft}"), &["vee.bank_angle=10..100:30"], &[3]);
        let sets = sweep.zeros.expect("an angle");
        let of_other: Vec<_> = sets.iter().filter(|set| set.of == other).collect();
        assert!(of_other.len() == 2 && of_other.iter().all(|set| set.exists && set.everywhere), "{of_other:?}");
        // Its own vector is the same at every angle: never zero, and nor is any part of the force.
        let of_force = sets.iter().filter(|set| set.quantity == Planar::Force && set.of != other);
        assert!(of_force.clone().count() == 4, "{sets:?}");
        assert!(of_force.clone().all(|set| set.complete && set.at.is_empty() && !set.everywhere), "{sets:?}");
    }
}

/// Forms that refuse a bank angle beyond their own, with masses that turn: half of the reciprocating masses and all that turn are cancelled on
/// each throw, so that the direct vectors of order 1 vanish at every angle, and the reverse ones alone decide.
#[test]
fn a_vector_that_masses_cancel_at_every_angle_vanishes_everywhere_in_forms_that_read_no_wide_angle() {
    let masses = "[mechanism]\nstroke = '86 mm'\nrod_length = '155 mm'\nreciprocating_mass = 0.61\nrotating_mass = 0.515\n[crankshaft]\n\
        counterweights = { rotating = 1, reciprocating = 0.5 }\ncounterweight_radius = '45 mm'\n";
    let w = "speed = 3000\n[w]\nbank_angle = 60\nnarrow_angle = 15\nthrows = [0, 120, 240]\npin_splay = 15\nspacing = '110 mm'\n";
    let vr = "speed = 3000\n[vr]\nbank_angle = 15\nthrows = [0, 120, 240]\nspacing = '110 mm'\n";
    for (form, key, ranges) in [
        (w, "w.bank_angle", ["40..160:40", "10..90:20", "30..130:7"]),
        (w, "w.narrow_angle", ["5..25:10", "2..30:4", "9..21:5"]),
        (vr, "vr.bank_angle", ["5..45:20", "5..25:5", "1..9:2"]),
    ] {
        for range in ranges {
            let sweep = good(&format!("{form}{masses}"), &[&format!("{key}={range}")], &[1]);
            let sets = sweep.zeros.as_ref().expect("an angle");
            let set = |of: Zeros| sets.iter().find(|set| set.quantity == Planar::Force && set.of == of).expect("a set");
            assert!(set(Zeros::Direct).everywhere, "{key}={range}: {:?}", set(Zeros::Direct));
            let (reverse, all) = (set(Zeros::Reverse), set(Zeros::Largest));
            assert_eq!((&reverse.at, reverse.complete), (&all.at, all.complete), "{key}={range}");
            for point in &sweep.points {
                let force = &point.orders[0].force;
                assert!(force.direct.vanishes, "{key}={range}");
                let is_listed = all.everywhere || all.at.contains(&point.values[0]);
                assert_eq!(force.largest.vanishes, is_listed, "{key}={range} at {}", point.values[0]);
            }
        }
    }
}

/// δ is solved for as φ is; other angles have their sign and, where nothing is solved, a word on that.
#[test]
fn every_angle_is_swept_in_degrees_and_delta_has_its_exact_zeros() {
    let file =
        "values = { phi = 60, delta = 30 }\n[vee]\nbank_angle = 'phi'\npin_split = 'delta'\nthrows = [0, 240, 120]\n";
    let of_delta = good(file, &["values.delta=-70..180:50"], &[1, 2]);
    let of_split = good(V6, &["vee.pin_split=-70..180:50"], &[1, 2]);
    assert_eq!(of_delta.zeros, of_split.zeros);
    assert_eq!(zeros(&of_delta, Planar::Moment, 2, Zeros::Reverse), ["0", "180"]);
    let stars = "cycle = 'four-stroke'\nfiring_order = '1-4-2-5-3-6'\n";
    let template = format!("{stars}{file}");
    let template = Template::new("test.toml", &template).expect("it is TOML");
    let swept = [Parameter::parse("values.delta=0..90:30").expect("a range")];
    let orders = ["3".parse().expect("an order")];
    let whole = sweep::Stream::new(&template, &swept, &[1], &orders, &Geometry::default()).expect("a sweep");
    whole.whole(&std::sync::atomic::AtomicBool::new(false)).expect("swept");
    let geared = "[[crankshaft]]\nname = 'A'\nsense = 'with'\n[[crankshaft]]\nname = 'B'\nsense = 'against'\nphase = 20\n\
        [[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\ncrankshaft = 'A'\n[[cylinder]]\nthrow = 0\nbank = 0\nposition = 1\ncrankshaft = 'B'\n";
    let links = format!(
        "{V6}[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = ['1', '2', '3']\nknuckle_ratio = 0.2\nlink_ratio = 0.3\nknuckle_correction = 2\n"
    );
    for (text, set, range) in [
        (file, "values.delta=0..90:45", "values.delta from 0° to 90°"),
        (geared, "crankshaft.2.phase=0..90:45", "crankshaft.2.phase from 0° to 90°"),
        (&links, "articulated.knuckle_correction=0..4:2", "articulated.knuckle_correction from 0° to 4°"),
    ] {
        let sweep = good(text, &[set], &[1]);
        let answer = in_plain_text(&report::sweep_answer(&sweep));
        assert!(answer.contains(range), "{answer}");
        assert_eq!(answer.contains("between them none are sought"), sweep.zeros.is_none(), "{answer}");
    }
}

/// What nothing moves, and what big ends alone turn.
#[test]
fn pistons_without_mass_have_no_zeros_of_their_own() {
    let text =
        "[vee]\nbank_angle = 60\nthrows = [0, 240, 120]\n[mechanism]\nrod_ratio = 0.25\nreciprocating_mass = 0\n";
    let rotating = format!("{text}rotating_mass = 0.3\n");
    for range in ["vee.bank_angle=0..180:30", "vee.throws.1=0..180:30"] {
        let nothing = good(text, &[range], &[1, 2, 4, 6]);
        assert!(nothing.zeros.expect("an angle").iter().all(|set| set.everywhere && set.complete), "{range}");
        let turning = good(&rotating, &[range], &[1, 2]);
        let sets = turning.zeros.as_ref().expect("an angle");
        assert!(sets.iter().all(|set| set.complete), "{range}");
        assert!(sets.iter().all(|set| set.everywhere || set.order == 1 && set.of != Zeros::Reverse), "{range}");
    }
    let of_throw = good(&rotating, &["vee.throws.1=0..180:50"], &[1]);
    assert_eq!(zeros(&of_throw, Planar::Force, 1, Zeros::Largest), ["0"]);
    assert_eq!(zeros(&of_throw, Planar::Moment, 1, Zeros::Largest), ["120"]);
    assert_eq!(zeros(&of_throw, Planar::Moment, 1, Zeros::Reverse), ["everywhere"]);
    let unequal = format!("{text}rotating_mass = [0.3, 0.3, 0.3, 0.3, 0.3, 0.4]\n");
    let sets = good(&unequal, &["vee.throws.1=0..180:50"], &[1]).zeros.expect("an angle");
    let force = sets.iter().find(|set| set.quantity == Planar::Force && set.of == Zeros::Largest).expect("a set");
    assert!(!force.everywhere && !force.at.contains(&fraction(0, 1)) && !force.complete);
}
