//! Do limits of moments keep the best of all stars that keep them, exactly, and are newton-metres those of the layout?

use crankstar::engine::Cycle;
use crankstar::exact::Turn;
use crankstar::file::parse;
use crankstar::page::{Format, Options as PageOptions, write};
use crankstar::report::{self, ValueName};
use crankstar::search::{Front, Limit, Options, Problem, Sizes, document, search};

use crate::support::written::assert_near;

/// Six cylinders of a two-stroke: theory of the project guides, 3000 kg at 1 m, rods of 2.05 m, 0.85 m apart, 127 rpm.
const MARINE: &str = "title = 'six'\ncycle = 'two-stroke'\nfiring_order = '1-5-3-4-2-6'\nspeed = 127\n[inline]\nspacing = '0.85 m'\n[mechanism]\ncrank_radius = '1 m'\nrod_length = '2.05 m'\nreciprocating_mass = '3000 kg'\n";

fn front() -> Front {
    search(&Problem::inline(6, Cycle::TwoStroke, &[1, 2]), &Options::default()).expect("a front")
}

fn limit(text: &str) -> Limit {
    Limit::parse(text).unwrap_or_else(|right| panic!("{text}: {right}"))
}

fn moments(front: &Front) -> Vec<[f64; 2]> {
    front.stars.iter().map(|star| [star.moments[0].decimal, star.moments[1].decimal]).collect()
}

#[test]
fn a_limit_keeps_exactly_the_stars_of_the_front_below_it() {
    let all = moments(&front());
    assert!(all.len() > 1);
    for &[_, second] in &all {
        for (text, keeps) in [(format!("2={second}"), second), (format!("2={}", second / 2.0), second / 2.0)] {
            let limited = front().limited(vec![limit(&text)], None).expect("it is compared");
            let expected: Vec<[f64; 2]> =
                all.iter().copied().filter(|[_, moment]| *moment <= keeps * (1.0 + 1e-12)).collect();
            // A limit as a rounded decimal is just above or just below the moment itself.
            assert!(expected.len().abs_diff(limited.stars.len()) <= 1, "{text}");
            assert!(moments(&limited).iter().all(|[_, moment]| *moment <= keeps * (1.0 + 1e-12)));
        }
    }
    // The star 1-5-3-4-2-6 leaves 2√3 at order 2 and nothing at order 1: exactly zero keeps a limit of 0.
    let none = front().limited(vec![limit("1=0")], None).expect("it is compared");
    assert!(!none.stars.is_empty() && none.stars.iter().all(|star| star.moments[0].sum.vanishes()));
    assert_eq!(document(&none).limits, ["1=0"]);
    let nothing = front().limited(vec![limit("1=0"), limit("2=0")], None).expect("they are compared");
    assert!(nothing.stars.is_empty());
    let text = write(&report::search_answer(&nothing), Format::PLAIN, &PageOptions::default()).remove(0).text;
    assert!(text.contains("No crank star keeps these limits"), "{text}");
}

#[test]
fn newton_metres_are_those_of_the_layout() {
    let engine = parse("six.toml", MARINE).unwrap_or_else(|error| panic!("{error}"));
    let sizes = Sizes::new(&engine).expect("all is known");
    // The project guide's six has 813.382463 kN m at order 2, of the star 2√3.
    assert_near(2.0 * 3f64.sqrt() * sizes.newton_metres(2) / 1e3, 813.382_463, 1e-6);
    let kept = front().limited(vec![limit("2=813.3825 kN m")], Some(sizes.clone())).expect("sizes");
    assert!(kept.stars.iter().any(|star| star.moments[0].sum.vanishes()));
    let fewer = front().limited(vec![limit("1=0"), limit("2=813.3824 kN m")], Some(sizes)).expect("sizes");
    assert!(fewer.stars.is_empty());
    let text = write(&report::search_page(&kept), Format::PLAIN, &PageOptions::default()).remove(0).text;
    assert!(text.contains("N·m") && text.contains("keep these limits"), "{text}");
}

#[test]
fn what_does_not_fit_is_refused() {
    for text in ["2", "x=1", "2=-1", "2=3 kg", "=", "2="] {
        assert!(Limit::parse(text).is_err(), "{text}");
    }
    assert!(front().limited(vec![limit("4=1")], None).is_err());
    assert!(front().limited(vec![limit("2=1 N m")], None).is_err());
    let vee = Problem::vee(4, Cycle::FourStroke, Turn::fraction(1, 4), &[1]);
    let vee = search(&vee, &Options::default()).expect("a front");
    assert!(vee.limited(vec![limit("1=1")], None).is_err());
    let no_speed = parse("six.toml", &MARINE.replace("speed = 127\n", "")).expect("it reads");
    assert!(Sizes::new(&no_speed).expect_err("no speed").to_string().contains("speed"));
    let in_spacings = parse("six.toml", &MARINE.replace("spacing = '0.85 m'\n", "")).expect("it reads");
    assert!(Sizes::new(&in_spacings).expect_err("no spacing").to_string().contains("spacing"));
}

/// Seven cylinders of that size with these keys of the mechanism and the tables behind it.
fn seven(firing_order: &str, keys: &str) -> String {
    MARINE.replace("'six'", "'seven'").replace("1-5-3-4-2-6", firing_order) + "rotating_mass = '5200 kg'\n" + keys
}

#[test]
fn newton_metres_are_the_moments_of_the_star_with_all_that_turns_on_its_throws() {
    let front = search(&Problem::inline(7, Cycle::TwoStroke, &[1, 2]), &Options::default()).expect("a front");
    let names = ["1", "2"].map(|order| format!("loads.orders.{order}.moment").parse::<ValueName>().expect("a name"));
    for keys in [
        "",
        "pin_offset = '50 mm'\n",
        "[crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = '0.8 m'\n",
        "[crankshaft]\nbalance_factor = 1.4\ncounterweight_radius = '0.8 m'\n",
    ] {
        for star in &front.stars {
            let order: Vec<String> =
                star.firing_order.iter().flatten().map(|cylinder| (cylinder + 1).to_string()).collect();
            let engine = parse("seven.toml", &seven(&order.join("-"), keys));
            let engine = engine.unwrap_or_else(|error| panic!("{keys}: {error}"));
            let sizes = Sizes::new(&engine).unwrap_or_else(|error| panic!("{keys}: {error}"));
            for (moment, told) in star.moments.iter().zip(report::values_of(&engine, &names)) {
                let told = told.expect("a moment").value().expect("a value").to_string();
                let told: f64 = told.parse().expect("a number");
                let found = moment.decimal * sizes.newton_metres(moment.order);
                assert_near(found / told, 1.0, 1e-9);
            }
        }
    }
}

#[test]
fn masses_that_belong_to_one_star_are_refused_as_sizes_of_others() {
    for (keys, told) in [
        ("[[counterweight]]\nposition = '0 m'\nangle = 0\nmass_radius = '10 kg m'\n", "counterweights"),
        ("[[balancer]]\norder = 2\nsense = 'with'\nposition = '0 m'\nangle = 0\nmass_radius = '10 kg m'\n", "balancer"),
    ] {
        let engine = parse("seven.toml", &seven("1-7-2-5-4-3-6", keys)).unwrap_or_else(|error| panic!("{error}"));
        let error = Sizes::new(&engine).expect_err(told).to_string();
        assert!(error.contains(told), "{error}");
    }
}

/// Sizes are multiplied by the coefficient of one rod.
#[test]
fn rods_that_differ_have_no_common_sizes() {
    let unlike = MARINE.replace("rod_length = '2.05 m'", "rod_ratio = [0.4, 0.4, 0.4, 0.4, 0.4, 0.5]");
    let engine = parse("six.toml", &unlike).unwrap_or_else(|error| panic!("{error}"));
    let error = Sizes::new(&engine).expect_err("no common rod").to_string();
    assert!(error.contains("alike at all throws"), "{error}");
}
