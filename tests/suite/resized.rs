//! Are weights that an engine has resized by its remedy, and is no weight added beside one that it takes away again?

use std::collections::BTreeMap;
use std::fs;

use crankstar::BigRational;
use crankstar::engine::Engine;
use crankstar::exact::Turn;
use crankstar::file::FileResolver;
use crankstar::order;
use crankstar::page;
use crankstar::proof::{Planar, Sense};
use crankstar::remedy::{Remedy, Request, corrected_file, remedy};
use crankstar::report;
use proptest::prelude::*;

use crate::support::program::{program, scratch};
use crate::support::written::engine as read;

fn request(orders: &[u32]) -> Request {
    Request { orders: orders.to_vec(), ..Request::default() }
}

fn corrected(found: &Remedy) -> (String, Engine) {
    let file = corrected_file(found, "corrected.toml", FileResolver::nothing());
    let text = file.unwrap_or_else(|error| panic!("{error}\n{}", found.subject.engine().file().written())).text;
    let engine = read(&text);
    (text, engine)
}

fn answer(found: &Remedy) -> String {
    let text = &page::write(&report::remedy_answer(found), page::Format::PLAIN, &page::Options::default())[0].text;
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The crankshaft or a shaft, a plane of it, and what its weight stands before.
type Place = (Option<(u32, Sense)>, BigRational, Option<usize>);

/// The directions of all weights on each shaft in each plane.
fn directions(engine: &Engine) -> BTreeMap<Place, Vec<Turn>> {
    let mut directions: BTreeMap<Place, Vec<Turn>> = BTreeMap::new();
    let crankshaft = engine.crankshaft();
    for weight in &crankshaft.counterweights {
        let place = (None, weight.position.clone(), None);
        directions.entry(place).or_default().push(weight.angle.clone());
    }
    for shaft in &crankshaft.balancers {
        let place = (Some((shaft.order, shaft.sense)), shaft.position.clone(), shaft.coefficient_of);
        directions.entry(place).or_default().push(shaft.angle.clone());
    }
    directions
}

/// The corrected file of an engine leaves nothing, has no weight beside its opposite, and needs no remedy.
fn assert_cured(text: &str, request: &Request) -> (String, Engine) {
    let engine = read(text);
    let found = remedy(&engine, request).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(found.holds(), "{text}");
    let (written, cured) = corrected(&found);
    for order in &request.orders {
        for quantity in Planar::BOTH {
            for sense in [Sense::Direct, Sense::Reverse] {
                assert!(order::all_masses(&cured, quantity, *order, sense).vanishes(), "{order}\n{text}\n{written}");
            }
        }
    }
    for (place, directions) in directions(&cured) {
        for one in &directions {
            let opposite = one.opposite();
            assert!(!directions.contains(&opposite), "{place:?} has a weight and one opposite:\n{text}\n{written}");
        }
    }
    let again = remedy(&cured, &Request { orders: request.orders.clone(), ..Request::default() }).expect("a remedy");
    assert!(again.weights().is_empty() && again.left_out.is_empty(), "{written}");
    assert!(answer(&again).contains("no weight is needed"), "{}", answer(&again));
    (written, cured)
}

const SINGLE: &str = "[inline]\nthrows = [0]\n[mechanism]\nreciprocating_mass = 0.5\nrotating_mass = 0.3\ncrank_radius = 0.05\nrod_ratio = 0.3\n";

#[test]
fn a_counterweight_that_is_too_heavy_becomes_lighter_and_no_second_one_is_added() {
    // What is needed is 0.3 + ½·0.5 = 0.55 kg at the crank radius.
    let text = format!("{SINGLE}[[counterweight]]\nangle = 180\nmass = 0.8\nradius = 0.05\nposition = 0\n");
    let engine = read(&text);
    let found = remedy(&engine, &request(&[1])).expect("a remedy");
    let told = answer(&found);
    assert!(told.contains("resized") && told.contains("40") && told.contains("27.5"), "{told}");
    let (_, cured) = assert_cured(&text, &request(&[1]));
    let [weight] = cured.crankshaft().counterweights.as_slice() else { panic!("{:?}", cured.crankshaft()) };
    assert_eq!(weight.mass_radius(), BigRational::new(11.into(), 400.into()));
    assert!((found.crankshaft_mass().expect("masses") - 1.1).abs() < 1e-12, "{:?}", found.crankshaft_mass());
}

#[test]
fn a_weight_that_nothing_needs_is_taken_away() {
    // Two pistons against each other, of one mass: nothing turns with the crank but the weight of the file.
    let text = "[inline]\nthrows = [0, 180, 180, 0]\n[[counterweight]]\nangle = 30\nmass_radius = '1/3 m r'\nposition = 0.5\n[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '1/4 m r'\nangle = 10\nposition = 0\n";
    let (written, cured) = assert_cured(text, &request(&[1]));
    assert!(cured.crankshaft().counterweights.is_empty() && cured.crankshaft().balancers.is_empty(), "{written}");
    let told = answer(&remedy(&read(text), &request(&[1])).expect("a remedy"));
    assert!(told.contains("nothing"), "{told}");
}

#[test]
fn a_weight_without_mass_keeps_the_place_of_what_is_found() {
    let text = format!(
        "{SINGLE}[[counterweight]]\nangle = 0\nmass_radius = '0 m r'\nposition = 0\n[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '0 m r'\nangle = 0\nposition = 0\n[[counterweight]]\nangle = 0\nmass_radius = '0 m r'\nposition = 2\n"
    );
    let (written, cured) = assert_cured(&text, &request(&[1]));
    assert_eq!(cured.crankshaft().counterweights.len(), 2, "{written}");
    assert_eq!(cured.crankshaft().balancers.len(), 1, "{written}");
}

#[test]
fn a_pair_of_balancers_is_resized_in_its_planes_and_keeps_its_axes() {
    let text = "[inline]\nthrows = [0, 180, 180, 0]\n[mechanism]\nreciprocating_mass = 0.5\nrotating_mass = 0\ncrank_radius = 0.05\nrod_ratio = 0.3\n\
                [[balancer]]\norder = 2\nsense = 'with'\nmass_radius = 0.001\nangle = 180\nposition = 1.5\nheight = 0.1\noffset = 0.04\n\
                [[balancer]]\norder = 2\nsense = 'with'\nmass_radius = 0.001\nangle = 180\nposition = -1\nheight = 0.1\n\
                [[balancer]]\norder = 4\nsense = 'with'\nmass_radius = 0.00001\nangle = 90\nposition = 0.25\nheight = -0.2\n";
    let (written, cured) = assert_cured(text, &request(&[1, 2]));
    let balancers = &cured.crankshaft().balancers;
    let of =
        |order: u32, sense: Sense| balancers.iter().filter(move |shaft| (shaft.order, shaft.sense) == (order, sense));
    let planes: Vec<String> = of(2, Sense::Direct).map(|shaft| shaft.position.to_string()).collect();
    assert!(planes.contains(&"3/2".to_owned()) && planes.contains(&"-1".to_owned()) && planes.len() == 2, "{written}");
    let [tenth, part] = [10, 25].map(|below| BigRational::new(1.into(), below.into()));
    assert!(
        of(2, Sense::Direct).all(|shaft| shaft.axis.as_ref().is_some_and(|axis| axis.height == tenth)),
        "{written}"
    );
    assert!(of(2, Sense::Direct).any(|shaft| shaft.axis.as_ref().is_some_and(|axis| axis.offset == part)), "{written}");
    // What is not asked about stays as it is.
    assert_eq!(of(4, Sense::Direct).collect::<Vec<_>>(), [&read(text).crankshaft().balancers[2]]);
}

#[test]
fn balance_factors_are_of_all_that_stands_at_a_throw() {
    let text = format!("{SINGLE}[[counterweight]]\nthrow = 1\nmass = 0.8\nradius = 0.05\n");
    let half = BigRational::new(1.into(), 2.into());
    let request = Request { factors: vec![half.clone()], orders: vec![2], ..Request::default() };
    let (written, cured) = corrected(&remedy(&read(&text), &request).expect("a remedy"));
    let [weight] = cured.crankshaft().counterweights.as_slice() else { panic!("{written}") };
    assert_eq!(weight.mass_radius(), BigRational::new(11.into(), 800.into()), "{written}");
    // Once more it has it already.
    let again = remedy(&cured, &request).expect("a remedy");
    assert!(again.bays.is_empty(), "{:?}", again.bays);
}

#[test]
fn the_command_says_what_was_there_and_writes_it_resized() {
    let folder = scratch("resized");
    let text = format!("{SINGLE}[[counterweight]] # too heavy\nangle = 180\nmass = 0.8\nradius = 0.05\nposition = 0\n");
    fs::write(folder.join("a.toml"), text).expect("a file");
    let run = |arguments: &[&str]| {
        let run = program().current_dir(&folder).args(arguments).output().expect("it starts");
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        String::from_utf8_lossy(&run.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let told = run(&["remedy", "a.toml", "--orders", "1", "--write", "b.toml"]);
    assert!(told.contains("resized"), "{told}");
    let written = fs::read_to_string(folder.join("b.toml")).expect("a file");
    assert!(written.matches("[[counterweight]]").count() == 1 && written.contains("before 1.6"), "{written}");
    assert!(run(&["remedy", "b.toml", "--orders", "1"]).contains("no weight is needed"));
}

fn angle() -> impl Strategy<Value = BigRational> {
    (0..24_i64, prop::sample::select(vec![4_i64, 5, 7, 12, 24])).prop_map(|(n, d)| BigRational::new(n.into(), d.into()))
}

prop_compose! {
    fn cylinder()(throw in angle(), bank in angle(), position in -6..6_i64, mass in 0..4_i64) -> String {
        format!("[[cylinder]]\nthrow = '{throw} turn'\nbank = '{bank} turn'\nposition = {position}\nreciprocating_mass = '{mass}/2'\n")
    }
}

prop_compose! {
    fn counterweight()(position in -6..6_i64, angle in angle(), size in 0..9_i64) -> (i64, String) {
        (position, format!("[[counterweight]]\nangle = '{angle} turn'\nmass_radius = '{size}/4 m r'\nposition = {position}\n"))
    }
}

prop_compose! {
    fn balancer()(
        order in prop::sample::select(vec![1_u32, 2, 4]),
        sense in prop::sample::select(vec!["with", "against"]),
        position in -6..6_i64,
        angle in angle(),
        size in 1..9_i64,
        coefficient in any::<bool>(),
    ) -> ((u32, &'static str, i64), String) {
        let coefficient = if coefficient { "coefficient_of = '1'\n" } else { "" };
        let text = format!("[[balancer]]\norder = {order}\nsense = '{sense}'\nmass_radius = '{size}/8 m r'\n{coefficient}angle = '{angle} turn'\nposition = {position}\n");
        ((order, sense, position), text)
    }
}

/// One of each place, so that no file has a weight and its opposite to begin with.
fn once<K: Ord>(list: Vec<(K, String)>) -> String {
    list.into_iter().collect::<BTreeMap<K, String>>().into_values().collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn engines_with_weights_of_their_own_are_cured_once_and_for_all(
        cylinders in prop::collection::vec(cylinder(), 1..6),
        counterweights in prop::collection::vec(counterweight(), 0..4),
        balancers in prop::collection::vec(balancer(), 0..4),
        orders in prop::sample::select(vec![vec![1_u32], vec![1, 2], vec![2], vec![1, 2, 4]]),
    ) {
        let text = cylinders.concat() + &once(counterweights) + &once(balancers);
        assert_cured(&text, &request(&orders));
    }
}
