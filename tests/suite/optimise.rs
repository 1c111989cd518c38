//! Are the counterweights that `optimise` finds the best, exact, and written as it says?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite optimise::the_ -- --test-threads=1` writes the pages in `reports/optimise` anew, one
//! after the other. They hold the figures of the stored layout files, measured: so they are the same on every machine, though the
//! last digit of a solver may not be. The tests solve anew and hold the stored points to that.

use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::{env, fs};

use crankstar::beam::Beam;
use crankstar::data::exact_number;
use crankstar::engine::{Draft, Engine};
use crankstar::file::{FileResolver, parse};
use crankstar::journal::{bearing_peaks, cycle_loads};
use crankstar::loads::{Circle, Method, Outcome, Scale, Waveform, bearing_loads, loads, usual_bearing_orders};
use crankstar::optimise::{
    Couple, Front, OptimiseError, Optimum, Place, Request, Residual, Uniform, front, measure, places, uniform,
};
use crankstar::page::Format;
use crankstar::{page, report};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::Zero;

use crate::support::dice::Dice;
use crate::support::german::phrases;
use crate::support::program::scratch;
use crate::support::written::float;

const ENGINES: [&str; 3] = ["thesis-i3", "thesis-v8-flatplane", "thesis-v8-crossplane"];
const POINTS: usize = 9;

fn folder(engine: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("reports/optimise").join(engine)
}

fn read(engine: &str, file: &str) -> Engine {
    let text = fs::read_to_string(folder(engine).join(file)).unwrap_or_else(|error| panic!("{engine}/{file}: {error}"));
    parse(file, &text).unwrap_or_else(|error| panic!("{error}"))
}

pub fn request(layout: &Engine, couple: Couple, points: usize) -> Request {
    Request { couple, points, orders: usual_bearing_orders(layout) }
}

pub fn solved(layout: &Engine, couple: Couple, points: usize) -> Front {
    front(layout, &request(layout, couple, points), FileResolver::nothing())
        .unwrap_or_else(|refused| panic!("{refused}"))
}

pub fn whole(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

fn newtons(point: &Optimum) -> f64 {
    point.design.peak() * point.design.scale.as_ref().map_or(1.0, Scale::force)
}

/// The front as it is stored, measured once for all tests, unless they write it anew.
fn stored(engine: &str) -> Front {
    if renews() {
        return measured(engine);
    }
    static FRONTS: [OnceLock<Front>; 3] = [const { OnceLock::new() }; 3];
    let place = ENGINES.iter().position(|name| *name == engine).expect("an engine of these pages");
    FRONTS[place].get_or_init(|| measured(engine)).clone()
}

/// The front as it is stored: its layout files, measured.
fn measured(engine: &str) -> Front {
    let layout = read(engine, "layout.toml");
    let (places, orders) = (places(&layout), usual_bearing_orders(&layout));
    let point = |file: &str| {
        let layout = read(engine, file);
        let design = measure(&layout, &places, &orders).expect("a design");
        Optimum { engine: layout, design, least: 0.0 }
    };
    let compared = |(over, under): (i64, i64)| {
        let factor = BigRational::new(over.into(), under.into());
        let uniform = uniform(&layout, &factor).expect("counterweights on every throw");
        let design = measure(&uniform, &places, &orders).expect("a design");
        // What no crankshaft that keeps the conditions reaches has no file.
        let beside = |as_what: &str| {
            let file = format!("as-{as_what}-as-{}.toml", float(&factor));
            folder(engine).join(&file).exists().then(|| point(&file))
        };
        Uniform { design, best: beside("heavy"), lightest: beside("calm"), factor }
    };
    Front {
        points: (1..=POINTS).map(|number| point(&format!("point-{number}.toml"))).collect(),
        uniform: [(0, 1), (13, 20), (1, 1)].map(compared).into(),
        places,
    }
}

fn renews() -> bool {
    env::var_os("CRANKSTAR_RENEW").is_some()
}

#[track_caller]
pub fn assert_close(one: f64, other: f64, part: f64, what: &str) {
    assert!((one - other).abs() <= part * one.abs().max(other.abs()), "{what}: {one} and {other}");
}

/// Every crankshaft of a front that was found.
fn all(front: &Front) -> impl Iterator<Item = &Optimum> {
    front.points.iter().chain(front.uniform.iter().flat_map(|uniform| uniform.best.iter().chain(&uniform.lightest)))
}

/// The page, its drawing, and the layout files beside it.
fn files(layout: &Engine, front: &Front) -> Vec<page::File> {
    let document = report::optimise_page(layout, front, &Couple::Zero);
    let written = page::write(&document, page::Format::GITHUB, &page::Options::default());
    written.into_iter().chain(report::optimise_layouts(front)).collect()
}

/// Solves anew, compares with the stored points, and the stored page with what their files measure.
fn compare(engine: &str) {
    let layout = read(engine, "layout.toml");
    let found = solved(&layout, Couple::Zero, POINTS);
    for point in all(&found) {
        // The bound is weak duality of any multipliers: that the two meet proves both.
        let peak = point.design.peak();
        assert!(point.least <= peak * (1.0 + 1e-9) && peak <= point.least * 1.0001, "{engine}: {peak} {}", point.least);
        assert_eq!((point.design.force, point.design.couple), (Residual::Zero, Residual::Zero));
    }
    if renews() {
        for file in files(&layout, &found) {
            fs::write(folder(engine).join(file.name), file.text).expect("a file");
        }
    }
    let mut kept = stored(engine);
    assert_eq!(all(&kept).count(), all(&found).count(), "{engine}");
    let uniform = kept.uniform.iter_mut().flat_map(|uniform| uniform.best.iter_mut().chain(&mut uniform.lightest));
    for (kept, found) in kept.points.iter_mut().chain(uniform).zip(all(&found)) {
        assert_close(kept.design.peak(), found.design.peak(), 1e-4, "peak");
        assert_close(float(&kept.design.mass), float(&found.design.mass), 1e-4, "mass");
        kept.least = found.least;
    }
    for file in files(&layout, &kept) {
        let text = fs::read_to_string(folder(engine).join(&file.name)).expect("a stored file");
        assert!(text == file.text, "{engine}/{} is not as stored", file.name);
    }
}

#[test]
fn the_front_of_the_three_is_as_stored_and_within_their_bounds() {
    compare("thesis-i3");
}

#[test]
fn the_front_of_the_flat_plane_v8_is_as_stored_and_within_their_bounds() {
    compare("thesis-v8-flatplane");
}

#[test]
fn the_front_of_the_cross_plane_v8_is_as_stored_and_within_their_bounds() {
    compare("thesis-v8-crossplane");
}

const INTRODUCTION: &str = "The thesis of {} (Politecnico di Torino, 2019) ends with a wish: an optimisation that weighs balance, bearing loads and the mass of the \
    crankshaft. {} is that. For its in-line three and its two 90° V8s, with two counterweights per throw in the planes of the webs, these pages show \
    the least load of the main bearings for each mass of the crankshaft, beside one balance factor for all throws (0, 0.65 and 1, as in the thesis). \
    Every best crankshaft is without first-order force and couple that turn with the crank, exactly; one balance factor below 1 leaves a couple in the three and \
    in the cross-plane V8. Loads are those of orders 1, 2, 4 and 6 with exact coefficients at 6000 revolutions a minute, on a continuous beam; the thesis has orders 1 \
    and 2 with λ for $c_2$, which changes the worst bearing a little.";

/// The answer, the picture of the front, which stands in the folder of the engine, and the comparison: what its page has above its first heading.
fn summary_of(layout: &Engine, engine: &str) -> Vec<page::Block> {
    let page = report::optimise_page(layout, &stored(engine), &Couple::Zero).blocks.into_iter();
    let first = page.take_while(|block| !matches!(block, page::Block::Heading(..)));
    let block = |block| match block {
        page::Block::Answer(lines) => lines.into_iter().map(page::Block::Paragraph).collect(),
        page::Block::Pictures(mut pictures) => {
            pictures.iter_mut().for_each(|picture| picture.name = format!("{engine}/{}", picture.name));
            vec![page::Block::Pictures(pictures)]
        }
        other => vec![other],
    };
    first.flat_map(block).collect()
}

#[test]
fn the_summary_of_all_three_is_as_stored() {
    let mut summary = page::Document::new("README", "The best crankshafts of the thesis");
    let thesis = page::Text::link("L. Stabile", "../examples");
    let introduction = page::Text::phrase(INTRODUCTION, vec![thesis, page::Text::code("crankstar optimise")]);
    summary.push(page::Block::Paragraph(introduction));
    for engine in ENGINES {
        let layout = read(engine, "layout.toml");
        summary.push(page::Block::Heading(1, layout.title().into()));
        summary.blocks.extend(summary_of(&layout, engine));
        let more =
            page::Text::link("The front, its counterweights, and how they are found", format!("{engine}/optimise.md"));
        summary.push(page::Block::Paragraph(more));
    }
    let written = page::write(&summary, page::Format::GITHUB, &page::Options::default());
    for drawing in &written[1..] {
        let stored = fs::read_to_string(folder(&drawing.name)).expect("a drawing beside the page of its engine");
        assert!(renews() || stored == drawing.text, "reports/optimise/{} is not as stored", drawing.name);
    }
    let path = folder("README.md");
    if renews() {
        fs::write(&path, &written[0].text).expect("the page");
    }
    assert!(
        fs::read_to_string(path).expect("the page") == written[0].text,
        "reports/optimise/README.md is not as stored"
    );
}

#[test]
fn every_stored_point_is_proved_balanced_by_the_verdict_of_all_its_masses() {
    for engine in ENGINES {
        let front = stored(engine);
        for point in all(&front) {
            let loads = loads(&point.engine, &[1]).expect("loads");
            let [order] = loads.orders.as_slice() else { panic!("one order") };
            assert_eq!(order.force.direct.outcome, Outcome::Zero, "{engine}");
            assert_eq!(order.moment.direct.outcome, Outcome::Zero, "{engine}");
        }
    }
}

#[test]
fn parts_of_a_weight_weigh_what_it_weighs_and_stand_within_its_radius() {
    for engine in ENGINES {
        for point in stored(engine).points {
            for weight in &point.design.weights {
                let least = weight.mass_radius.norm() / float(&weight.place.radius);
                let mass = float(&weight.mass);
                assert!(mass >= least - 1e-12 && mass <= least + 1.001e-6, "{engine}: {mass} for {least}");
            }
            let of_weights: BigRational = point.design.weights.iter().map(|weight| &weight.mass).sum();
            assert_eq!(
                point.engine.with_counterweights(Vec::new()).expect("it holds").crankshaft_mass().expect("a mass")
                    + of_weights,
                point.design.mass
            );
        }
    }
}

/// Two outer counterweights alone: 0.0825√3/0.24 kg of the three (thesis, scheme of section 4.2.1, with the planes of table
/// 6.4), 0.0725 · 4√10 · 0.12/0.42 kg of the cross-plane V8 opposite to −arctan(1/3).
#[test]
fn the_lightest_crankshafts_have_two_outer_counterweights_along_30_and_minus_18_43_degrees() {
    for (engine, mass, skew) in [("thesis-i3", 3.665_785, 30.0), ("thesis-v8-crossplane", 8.420_173, -18.434_95)] {
        let lightest = stored(engine).points.remove(0);
        assert_close(float(&lightest.design.mass), mass, 2e-5, engine);
        let weights = &lightest.design.weights;
        let [first, last] = [weights.first().expect("weights"), weights.last().expect("weights")];
        assert_close(first.skew.expect("a skew"), skew, 1e-3, engine);
        assert!((first.mass_radius + last.mass_radius).norm() < 1e-4 * first.mass_radius.norm());
        let inner: f64 = weights[1..weights.len() - 1].iter().map(|weight| weight.mass_radius.norm()).sum();
        assert!(inner < 1e-2 * first.mass_radius.norm(), "{engine}: {inner}");
    }
}

/// Worst bearing of the thesis's engines with exact kinematics and side forces, computed apart from this program.
#[test]
fn uniform_balance_factors_load_the_worst_bearing_as_an_independent_computation_has_it() {
    let of = |engine: &str, place: usize| {
        let uniform = stored(engine).uniform.remove(place);
        uniform.design.peak() * uniform.design.scale.as_ref().expect("a scale").force()
    };
    assert_close(of("thesis-i3", 0), 18745.69, 1e-4, "I3 without counterweights");
    assert_close(of("thesis-v8-flatplane", 0), 43602.60, 1e-4, "flat-plane V8 without counterweights");
    assert_close(of("thesis-v8-flatplane", 2), 8206.10, 1e-4, "flat-plane V8, balance factor 1");
    assert_close(of("thesis-v8-crossplane", 0), 28315.07, 1e-4, "cross-plane V8 without counterweights");
    assert_close(of("thesis-v8-crossplane", 2), 7824.46, 1e-4, "cross-plane V8, balance factor 1");
}

#[test]
fn beside_a_uniform_balance_factor_the_best_are_no_heavier_or_no_worse_loaded() {
    for engine in ENGINES {
        for uniform in stored(engine).uniform {
            let (mass, peak) = (float(&uniform.design.mass), uniform.design.peak());
            if let Some(best) = uniform.best {
                assert!(float(&best.design.mass) <= mass * 1.00002, "{engine}: {} kg", best.design.mass);
                assert!(best.design.peak() <= peak * 1.0001, "{engine}: {} {peak}", best.design.peak());
            }
            if let Some(lightest) = uniform.lightest {
                assert!(lightest.design.peak() <= peak * 1.0001, "{engine}: {} {peak}", lightest.design.peak());
            }
        }
    }
}

/// Largest load over bearings and crank angles, from the beam's parts and samples alone.
struct Felt {
    bare: Vec<Vec<Complex<f64>>>,
    parts: Vec<Vec<f64>>,
    turning: Vec<Complex<f64>>,
}

impl Felt {
    fn new(layout: &Engine, places: &[Place]) -> Self {
        let circle = Circle::new(720);
        let bare = bearing_loads(
            &layout.with_counterweights(Vec::new()).expect("it holds"),
            &usual_bearing_orders(layout),
            Method::Continuous,
        )
        .expect("loads");
        let beam = Beam::new(layout.bearings().to_vec()).expect("a beam");
        let shares: Vec<Vec<f64>> =
            places.iter().map(|at| beam.influence(&at.position).iter().map(float).collect()).collect();
        Felt {
            parts: (0..layout.bearings().len()).map(|j| shares.iter().map(|share| share[j]).collect()).collect(),
            bare: bare.bearings.iter().map(|bearing| bearing.waveform.sample(&circle)).collect(),
            turning: (0..720).map(|step| Complex::cis(f64::from(step).to_radians() / 2.0)).collect(),
        }
    }

    fn largest(&self, weights: &[Complex<f64>]) -> f64 {
        let of_bearing = |(bare, parts): (&Vec<Complex<f64>>, &Vec<f64>)| {
            let added: Complex<f64> = parts.iter().zip(weights).map(|(part, weight)| weight * part).sum();
            bare.iter().zip(&self.turning).map(|(load, turn)| (load + added * turn).norm_sqr()).fold(0.0, f64::max)
        };
        self.bare.iter().zip(&self.parts).map(of_bearing).fold(0.0, f64::max).sqrt()
    }
}

#[test]
fn a_random_search_among_balanced_crankshafts_of_the_same_mass_finds_nothing_better() {
    let mut dice = Dice::new(5);
    for engine in ENGINES {
        let layout = read(engine, "layout.toml");
        let places = places(&layout);
        let felt = Felt::new(&layout, &places);
        let unit = 0.65 * 0.045;
        let positions: Vec<f64> = places.iter().map(|place| float(&place.position)).collect();
        let front = stored(engine);
        let vectors = |point: &Optimum| -> Vec<Complex<f64>> {
            point.design.weights.iter().map(|weight| weight.mass_radius / unit).collect()
        };
        let mass = |weights: &[Complex<f64>]| weights.iter().map(|weight| weight.norm()).sum::<f64>();
        let lightest = vectors(&front.points[0]);
        for number in [3, 6, 9] {
            let point = &front.points[number - 1];
            let start = vectors(point);
            let (most, first) = (mass(&start), felt.largest(&start));
            assert_close(first, point.design.peak(), 1e-4, engine);
            let (mut best, mut least) = (start, first);
            for round in 0..400 {
                let size = 0.3 * 0.97_f64.powi(round);
                let mut roll = || (dice.below(2001) as f64 / 1000.0 - 1.0) * size;
                let mut step: Vec<Complex<f64>> = positions.iter().map(|_| Complex::new(roll(), roll())).collect();
                // Without force and couple: what stands along the vectors of ones and of positions is taken out.
                let mean = step.iter().sum::<Complex<f64>>() / step.len() as f64;
                step.iter_mut().for_each(|part| *part -= mean);
                let along: Complex<f64> = step.iter().zip(&positions).map(|(part, z)| part * z).sum();
                let squares: f64 = positions.iter().map(|z| z * z).sum();
                step.iter_mut().zip(&positions).for_each(|(part, z)| *part -= along * (z / squares));
                let moved: Vec<Complex<f64>> = best.iter().zip(&step).map(|(a, b)| a + b).collect();
                // Too heavy a crankshaft goes towards the lightest one until it is light enough.
                let between = |part: f64| -> Vec<Complex<f64>> {
                    moved.iter().zip(&lightest).map(|(a, b)| a * (1.0 - part) + b * part).collect()
                };
                let halved = (0..40).fold((0.0, 1.0), |(low, high), _| {
                    let middle = (low + high) / 2.0;
                    if mass(&between(middle)) <= most { (low, middle) } else { (middle, high) }
                });
                let next = if mass(&moved) <= most { moved.clone() } else { between(halved.1) };
                assert!(mass(&next) <= most * (1.0 + 1e-9));
                let load = felt.largest(&next);
                if load < least {
                    (best, least) = (next, load);
                }
            }
            assert!(least >= first * (1.0 - 1e-4), "{engine} {number}: {least} is better than {first}");
        }
    }
}

#[test]
fn no_uniform_balance_factor_comes_below_the_front_of_the_flat_plane_v8() {
    let engine = "thesis-v8-flatplane";
    let (layout, front) = (read(engine, "layout.toml"), stored(engine));
    let curve: Vec<[f64; 2]> = front.points.iter().map(|p| [float(&p.design.mass), p.design.peak()]).collect();
    for tenths in 1..=13 {
        let uniform = uniform(&layout, &BigRational::new(tenths.into(), 10.into())).expect("counterweights");
        let design = measure(&uniform, &front.places, &usual_bearing_orders(&layout)).expect("a design");
        let mass = float(&design.mass);
        // The front is convex, so that its chords lie above it.
        let chord = curve.windows(2).find(|pair| pair[0][0] <= mass && mass <= pair[1][0]);
        let best = chord.map_or(curve[POINTS - 1][1], |pair| {
            let part = (mass - pair[0][0]) / (pair[1][0] - pair[0][0]);
            pair[0][1] + part * (pair[1][1] - pair[0][1])
        });
        assert!(design.peak() >= best * (1.0 - 1e-4), "balance factor {tenths}/10: {} below {best}", design.peak());
    }
}

/// An engine with two counterweights a throw.
pub fn engine(throws: &str, bearings: &str, more: &str) -> Engine {
    let text = format!(
        "speed = 6000\nbearings = {bearings}\norders = [1, 2]\n[inline]\nthrows = {throws}\nspacing = 0.1\n[mechanism]\nreciprocating_mass = 0.65\n\
         rotating_mass = 0.5\ncrank_radius = '45 mm'\nrod_ratio = 0.25\n{more}"
    );
    parse("engine.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

pub const WEBS: &str = "[crankshaft]\nbalance_factor = 0\ncounterweight_radius = 0.05\nweb_offset = 0.02";

#[test]
fn a_bounded_couple_is_kept_and_makes_a_lighter_crankshaft() {
    let i3 = engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", WEBS);
    let zero = solved(&i3, Couple::Zero, 2);
    let bounded = solved(&i3, Couple::AtMost(whole(200)), 2);
    for point in &bounded.points {
        assert_eq!(point.design.force, Residual::Zero);
        let Residual::Between(low, high) = point.design.couple else { panic!("a couple remains") };
        assert!(0.0 < low && low <= high && high <= 200.0, "{low} {high}");
        assert!(high - low < 1e-8, "{low} {high}");
        let left = loads(&point.engine, &[1]).expect("loads");
        let newton_metres = left.orders[0].moment.direct.value.norm() / 2.0 * left.scale.expect("a scale").force();
        assert!((low..=high).contains(&newton_metres), "{newton_metres}");
    }
    let Residual::Between(_, high) = bounded.points[0].design.couple else { panic!("a couple remains") };
    assert!(high > 199.0, "the lightest uses its bound: {high}");
    assert!(float(&bounded.points[0].design.mass) < float(&zero.points[0].design.mass) - 0.01);
    assert!(newtons(&bounded.points[1]) < newtons(&zero.points[1]) * (1.0 + 1e-4));
}

/// The solver leaves room for rounding: crankshafts of a slightly larger bound use it, and none of them is below the least possible of this one.
#[test]
fn no_crankshaft_that_keeps_the_bounded_couple_is_below_the_least_possible() {
    let i3 = engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", WEBS);
    let of_one_mass = |tenths: i64| {
        let front = solved(&i3, Couple::AtMost(BigRational::new(tenths.into(), 10.into())), 1);
        front.uniform.into_iter().map(|uniform| uniform.best).collect::<Vec<_>>()
    };
    let bounded = of_one_mass(2000);
    let mut compared = 0;
    for (wider, own) in (2001..=2003).flat_map(|tenths| of_one_mass(tenths).into_iter().zip(&bounded)) {
        let (Some(wider), Some(own)) = (wider, own) else { continue };
        if matches!(wider.design.couple, Residual::Between(_, high) if high <= 200.0) {
            let load = wider.design.peak();
            assert!(load >= own.least * (1.0 - 1e-9), "{load} for at least {}", own.least);
            compared += 1;
        }
    }
    assert!(compared > 2, "{compared}");
}

#[test]
fn a_bound_below_what_rounding_leaves_is_kept_by_no_couple_at_all() {
    let i3 = engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", WEBS);
    for most in [whole(0), BigRational::new(1.into(), 1_000_000.into())] {
        assert_eq!(solved(&i3, Couple::AtMost(most), 1).points[0].design.couple, Residual::Zero);
    }
}

/// Two planes leave no choice: the two-plane correction of the theory, section 7, which is 0.0825√3/0.24 kg each.
#[test]
fn two_planes_leave_one_point() {
    let planes = "[[counterweight]]\nthrow = 1\nmass = 0\nradius = 0.045\nposition = 0.12\n\
                  [[counterweight]]\nthrow = 3\nmass = 0\nradius = 0.045\nposition = -0.12\n";
    let front = solved(&engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", planes), Couple::Zero, 5);
    let [point] = front.points.as_slice() else { panic!("{} points", front.points.len()) };
    for weight in &point.design.weights {
        assert_close(float(&weight.mass), 0.0825 * 3.0_f64.sqrt() / 0.24, 1e-5, "mass");
    }
    assert!(front.uniform.is_empty(), "throw 2 has no place for a counterweight");
}

#[test]
fn throws_of_a_pentagon_or_an_uneven_pair_are_balanced_exactly_too() {
    let five = "[0.25, 0.15, 0.05, -0.05, -0.15, -0.25]";
    for (throws, bearings) in [
        ("[0, 72, 288, 144, 216]", five),
        ("[0, 100]", "[0.1, 0, -0.1]"),
        ("[0, 1]", "[0.1, -0.1]"),
        ("[30, 180, 75]", "[0.15, 0.05, -0.05, -0.15]"),
    ] {
        let front = solved(&engine(throws, bearings, WEBS), Couple::Zero, 1);
        let [point] = front.points.as_slice() else { panic!("one point") };
        assert_eq!((point.design.force, point.design.couple), (Residual::Zero, Residual::Zero), "{throws}");
        assert!(point.design.peak() <= point.least * 1.001, "{throws}: {} {}", point.design.peak(), point.least);
    }
}

#[test]
fn listed_counterweights_give_planes_and_radii_and_are_replaced() {
    let listed = "[crankshaft]\npin_mass = 0.1\nbalance_factor = [\n 0.5,  # first\n 0.5, 0.5]\ncounterweight_radius = [0.04, 0.05, 0.06]\n";
    let i3 = engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", listed);
    let from_factors = solved(&i3, Couple::Zero, 1);
    let tables = "[crankshaft]\npin_mass = 0.1\n[[counterweight]]\nthrow = 1\nmass = 1\nradius = 0.04\n\n# kept\n[[counterweight]]\nthrow = 2\nmass = 0\nradius = 0.05\n\
                  [[counterweight]]\nthrow = 3\nmass = 9\nradius = 0.06\n";
    let from_tables = solved(&engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", tables), Couple::Zero, 1);
    let [one, other] = [&from_factors.points[0].design, &from_tables.points[0].design];
    assert_eq!((&one.mass, &one.peaks), (&other.mass, &other.peaks));
    let radii: Vec<String> = from_tables.places.iter().map(|place| place.radius.to_string()).collect();
    assert_eq!(radii, ["1/25", "1/20", "3/50"]);
}

/// A four with counterweights and gas.
fn four_with_gas() -> String {
    let gas = crate::journal::four();
    format!("{gas}{WEBS}\n")
}

#[test]
fn with_gas_the_least_load_is_that_of_gas_and_masses_and_no_other_crankshaft_comes_below() {
    let text = four_with_gas();
    let four = parse("four.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let with_gas = solved(&four, Couple::Zero, 3);
    for point in all(&with_gas) {
        let loads = cycle_loads(&point.engine).expect("loads");
        let [bearings, _] = loads.bearings.as_ref().expect("bearings");
        let scale = point.design.scale.as_ref().map_or(1.0, Scale::force);
        for (peak, bearing) in point.design.peaks.iter().zip(&bearings.bearings) {
            assert_close(peak * scale, bearing.peak.value, 1e-12, "one truth");
        }
        assert_eq!(point.design.worst, bearings.worst);
        assert_eq!((point.design.force, point.design.couple), (Residual::Zero, Residual::Zero));
        assert!(point.least <= point.design.peak() && point.least > 0.999 * point.design.peak());
    }
    // Those that are best for the masses alone are no better with gas than the best of their own mass.
    let of_masses = parse("four.toml", &text.replace("effects = ['gas']\n", "")).expect("it reads");
    let of_masses = solved(&of_masses, Couple::Zero, 3);
    let of_gas = with_gas.points.iter().map(newtons).fold(f64::INFINITY, f64::min);
    for point in all(&of_masses) {
        let worst = bearing_peaks(&point.engine).expect("peaks").iter().map(|[all, _]| all.value).fold(0.0, f64::max);
        assert!(worst > of_gas * (1.0 - 1e-4), "{worst} {of_gas}");
    }
    for uniform in &with_gas.uniform {
        if let Some(best) = &uniform.best {
            assert!(
                newtons(best) <= uniform.design.peak() * best.design.scale.as_ref().map_or(1.0, Scale::force) * 1.001
            );
        }
    }
    let page = report::optimise_page(&four, &with_gas, &Couple::Zero);
    let written = page::write(&page, Format::GITHUB, &page::Options::default()).remove(0).text;
    assert!(written.contains("of gas and masses together") && !written.contains("in a revolution, all orders"));
    let missing: Vec<&str> =
        phrases(&page).into_iter().filter(|words| words.contains("gas") && !page::Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn a_gas_that_is_asked_for_and_cannot_be_had_is_told() {
    let refused = |text: &str| {
        let layout = parse("four.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        front(&layout, &request(&layout, Couple::Zero, 1), FileResolver::nothing())
            .err()
            .map(|refused| refused.to_string())
            .unwrap_or_default()
    };
    let text = four_with_gas();
    assert!(
        refused(&text.replace("firing_order = '1-3-4-2'\n", ""))
            .contains("effects ask for the gas: the layout does not say when")
    );
    assert!(refused(&text.replace("speed = 3000\n", "")).contains("speed"));
    assert!(refused(&text.replace("speed = 3000", "speed = 0")).contains("speed"));
}

#[test]
fn what_is_missing_is_named() {
    let beam = "[0.15, 0.05, -0.05, -0.15]";
    let refused = |layout: &Engine, couple: Couple, points: usize| {
        front(layout, &request(layout, couple, points), FileResolver::nothing())
            .err()
            .map(|refused| refused.to_string())
            .unwrap_or_default()
    };
    let i3 = engine("[0, 120, 240]", beam, WEBS);
    assert_eq!(refused(&i3, Couple::Zero, 0), OptimiseError::Points(0).to_string());
    let no_first = front(&i3, &Request { couple: Couple::Zero, points: 1, orders: vec![2] }, FileResolver::nothing());
    assert_eq!(no_first.err(), Some(OptimiseError::NoFirstOrder));
    let no_bearings = Draft { bearings: Vec::new(), ..i3.clone().into_draft() }.build().expect("it holds");
    assert!(refused(&no_bearings, Couple::Zero, 1).contains("main bearings"));
    assert_eq!(refused(&engine("[0, 120, 240]", beam, ""), Couple::Zero, 1), OptimiseError::NoPlaces.to_string());
    let one = "[[counterweight]]\nthrow = 2\nmass = 1\nradius = 0.05";
    assert!(
        refused(&engine("[0, 120, 240]", beam, one), Couple::Zero, 1)
            .contains("all counterweights of a crankshaft are at 0")
    );
    let no_speed = parse("no-speed.toml", &i3.file().written().replace("speed = 6000\n", "")).expect("it reads");
    assert_eq!(refused(&no_speed, Couple::AtMost(whole(5)), 1), OptimiseError::NoSpeed.to_string());
    assert_eq!(refused(&no_speed, Couple::Zero, 1), "");
    let inline = "crankshaft = { balance_factor = 1, counterweight_radius = 0.05, web_offset = 0.02 }\n";
    let text = format!("{inline}{}", engine("[0, 120, 240]", beam, "").file().written());
    let layout = parse("inline.toml", &text).expect("it reads");
    assert!(refused(&layout, Couple::Zero, 1).contains("tables of their own"), "{}", refused(&layout, Couple::Zero, 1));
}

fn crankstar(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_crankstar")).args(arguments).output().expect("the program starts")
}

#[test]
fn the_command_writes_page_and_points_that_read_and_json_that_holds_them() {
    let directory = scratch("optimise");
    let file = directory.join("i3.toml");
    fs::write(&file, engine("[0, 120, 240]", "[0.15, 0.05, -0.05, -0.15]", WEBS).file().written()).expect("a file");
    let (file, out) = (file.to_str().expect("UTF-8"), directory.join("out"));
    let run = crankstar(&["optimise", file, "--points", "2", "--output", out.to_str().expect("UTF-8")]);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let mut names: Vec<String> = fs::read_dir(&out)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    let beside = ["as-calm-as-0.65.toml", "as-calm-as-0.toml", "as-calm-as-1.toml"];
    let heavy = ["as-heavy-as-0.65.toml", "as-heavy-as-1.toml"];
    let expected = [&beside[..], &heavy, &["front.svg", "optimise.md", "point-1.toml", "point-2.toml"]].concat();
    assert_eq!(names, expected);
    let text = String::from_utf8(run.stdout).expect("UTF-8");
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("N; the one with the least load has"), "{text}");
    assert!(words.contains("0 is exact and proved"), "{text}");
    for command in ["classify", "loads", "bearings"] {
        let run = crankstar(&[command, out.join("point-2.toml").to_str().expect("UTF-8")]);
        assert!(run.status.success(), "{command}: {}", String::from_utf8_lossy(&run.stderr));
    }
    let run = crankstar(&["optimise", file, "--points", "1", "--couple", "50 N·m", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
    let point = &json["points"][0];
    assert_eq!(point["force_1_direct_vanishes"], true);
    assert!(point["couple_1_direct_zero_to_peak_N_m"].as_f64().expect("a number") <= 50.0);
    assert!(point["largest_load_at_least_N"].as_f64() <= point["largest_load_N"].as_f64());
    let layout = parse("point.toml", point["layout"].as_str().expect("a file")).expect("it reads");
    let mass = exact_number(&layout.crankshaft_mass().expect("a mass"));
    assert_eq!(mass, point["mass_exact_kg"].as_str().expect("a number"));
    let bearings = json["bearings"].as_array().expect("a table").len();
    assert_eq!(bearings, layout.bearings().len());
    let csv = crankstar(&["optimise", file, "--points", "1", "--format", "csv", "--table", "counterweights"]);
    let csv = String::from_utf8(csv.stdout).expect("UTF-8");
    assert_eq!(csv.lines().count(), 1 + json["counterweights"].as_array().expect("a table").len(), "{csv}");
}

#[test]
fn the_command_refuses_what_is_no_bound() {
    for (couple, reason) in [("much", "not a bound of a couple"), ("-1", "not a bound of a couple")] {
        let run = crankstar(&["optimise", "I3", &format!("--couple={couple}")]);
        assert_eq!(run.status.code(), Some(1), "{couple}");
        assert!(String::from_utf8_lossy(&run.stderr).contains(reason));
    }
}

#[test]
fn a_crankshaft_that_is_balanced_already_needs_no_counterweights_to_be_lightest() {
    let i4 = engine("[0, 180, 180, 0]", "[0.2, 0.1, 0, -0.1, -0.2]", WEBS);
    let front = solved(&i4, Couple::Zero, 2);
    assert!(front.points[0].engine.crankshaft().counterweights.iter().all(|weight| weight.mass.is_zero()));
    assert_eq!(
        front.points[0].design.mass,
        i4.with_counterweights(Vec::new()).expect("it holds").crankshaft_mass().expect("a mass")
    );
    let waveform = |point: &Optimum| -> Vec<Waveform> {
        let loads = bearing_loads(&point.engine, &[1, 2], Method::Continuous).expect("loads");
        loads.bearings.into_iter().map(|bearing| bearing.waveform).collect()
    };
    let peaks: Vec<f64> = waveform(&front.points[1]).iter().map(|waveform| waveform.peak().value).collect();
    assert_eq!(peaks, front.points[1].design.peaks);
}

#[test]
fn with_offsets_what_rounding_leaves_of_the_first_order_is_proved_to_be_slight_and_the_bound_holds() {
    let mut dice = Dice::new(29);
    for case in 0..6 {
        let offset = (10 + dice.below(120)) as f64 / 1000.0 * if case % 2 == 0 { 1.0 } else { -1.0 };
        let throws = ["[0, 120, 240]", "[0, 90, 230]", "[0, 144, 288, 72]"][dice.below(3) as usize];
        let webs = WEBS.replace("[crankshaft]", &format!("offset_ratio = {offset}\n[crankshaft]"));
        let layout = engine(throws, "[0.25, 0.05, -0.05, -0.25]", &webs);
        let found = solved(&layout, Couple::Zero, 2);
        for point in &found.points {
            let newtons = point.design.scale.as_ref().expect("a scale").force();
            for left in [point.design.force, point.design.couple] {
                let high = if let Residual::Between(_, high) = left { high } else { 0.0 };
                assert!(high <= 1e-9 * newtons * 4.0, "{offset} {left:?}");
            }
            // The direct first order of the forces of pistons and shaft, by another room.
            let left = loads(&point.engine, &[1]).expect("loads");
            assert!(left.orders[0].force.direct.value.norm() < 1e-8, "{offset}");
            assert!(left.orders[0].moment.direct.value.norm() < 1e-8, "{offset}");
            assert!(point.least > 0.999 * point.design.peak() && point.least < point.design.peak() * (1.0 + 1e-6));
        }
        let page = report::optimise_page(&layout, &found, &Couple::Zero);
        assert!(phrases(&page).iter().any(|words| words.contains("irrational")));
    }
}

#[test]
fn opposed_offsets_leave_an_exact_first_order_for_the_counterweights() {
    let webs = WEBS.replace("[crankshaft]", "offset_ratio = [0.05, -0.05]\n[crankshaft]");
    let layout = engine("[0, 0]", "[0.15, 0, -0.15]", &webs.replace("balance_factor = 0", "balance_factor = 0.5"));
    let found = solved(&layout, Couple::AtMost(whole(100_000)), 1);
    assert_eq!(found.points[0].design.force, Residual::Zero);
}
