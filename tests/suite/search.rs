//! Does the search find all stars, and the best of them exactly?

use crate::support::plain_search;
use crate::support::program::scratch;
use std::collections::BTreeSet;
use std::fs;
use std::ops::ControlFlow;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use crankstar::engine::{Cycle, Draft, ReferencePlane};
use crankstar::exact::Turn;
use crankstar::file;
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use crankstar::search::{
    FoundStar, Front, Options, Problem, SearchError, Standing, Way, document, every_value, search,
};
use crankstar::{page, report};
use num_bigint::BigUint;
use num_rational::BigRational;
use plain_search::{Star, all_stars, of_even_throws};

const CYCLES: [Cycle; 2] = [Cycle::TwoStroke, Cycle::FourStroke];

fn found(problem: &Problem) -> Front {
    search(problem, &Options::default()).expect("a front")
}

/// Firing order, closed forms, classes.
fn summary(star: &FoundStar) -> (Vec<String>, u64) {
    (
        star.moments.iter().map(|m| m.modulus().expect("a closed form").to_string()).collect(),
        star.classes.expect("counted"),
    )
}

fn json(front: &Front) -> String {
    serde_json::to_string(&document(front)).expect("a text")
}

/// The same values with the same numbers of stars, by a loop over all permutations of a real layout.
fn agrees_with_brute_force(problem: &Problem, stars: Vec<Vec<i64>>, directions: i64) {
    let brute = all_stars(problem, stars, directions);
    let every = every_value(problem).expect("a question");
    assert_eq!(every.stars.len(), brute.len(), "distinct values of {problem:?}");
    for star in &every.stars {
        let star = plain(star);
        let same: Vec<u64> = brute.iter().filter(|other| other.has_values_of(&star)).map(|other| other.count).collect();
        assert_eq!(same, [star.count], "{problem:?}");
    }
    let front = found(problem);
    let best: Vec<&Star> = brute.iter().filter(|star| !brute.iter().any(|other| other.beats(star))).collect();
    assert_eq!(front.stars.len(), best.len(), "the front of {problem:?}");
    for star in front.stars.iter().map(plain) {
        let is_there = best.iter().any(|other| other.has_values_of(&star) && other.count == star.count);
        assert!(is_there, "{problem:?}");
    }
}

fn plain(star: &FoundStar) -> Star {
    Star::new(star.moments.iter().map(|moment| moment.sum.squared_modulus()).collect(), star.stars.expect("counted"))
}

#[test]
fn values_counts_and_fronts_are_those_of_all_permutations_up_to_seven_cylinders() {
    for cycle in CYCLES {
        // With seven in line both cycles have the same stars.
        for cylinders in 1..=if cycle == Cycle::TwoStroke { 7 } else { 6 } {
            let (stars, directions) = of_even_throws(cylinders, cycle);
            agrees_with_brute_force(&Problem::inline(cylinders, cycle, &[1, 2]), stars, directions);
        }
        let (stars, directions) = of_even_throws(6, cycle);
        agrees_with_brute_force(&Problem::inline(6, cycle, &[1, 2, 3, 4]), stars, directions);
    }
}

#[test]
fn uneven_stars_are_all_on_the_grid_with_balanced_force() {
    for (cylinders, grid) in [(3, 12), (4, 6), (5, 6), (6, 4)] {
        let problem = Problem { grid: Some(grid), ..Problem::inline(cylinders, Cycle::FourStroke, &[1, 2]) };
        let count = (grid as usize).pow(cylinders - 1);
        let digits = |index: usize| {
            let mut rest = index;
            let next = (1..cylinders).map(|_| {
                let digit = rest % grid as usize;
                rest /= grid as usize;
                digit as i64
            });
            std::iter::once(0).chain(next).collect::<Vec<_>>()
        };
        agrees_with_brute_force(&problem, (0..count).map(digits).collect(), grid.into());
    }
}

/// Orbits under mirror and reversal of the stars with cylinder 1 at 0.
fn orbits(stars: &[Vec<i64>], directions: i64) -> usize {
    let turned_back =
        |star: Vec<i64>| -> Vec<i64> { star.iter().map(|throw| (throw - star[0]).rem_euclid(directions)).collect() };
    let mut left: BTreeSet<Vec<i64>> = stars.iter().cloned().collect();
    let mut count = 0;
    while let Some(star) = left.pop_first() {
        count += 1;
        let mirrored = turned_back(star.iter().map(|throw| -throw).collect());
        let reversed = turned_back(star.iter().rev().copied().collect());
        let both = turned_back(mirrored.iter().rev().copied().collect());
        [mirrored, reversed, both].iter().for_each(|image| {
            left.remove(image);
        });
    }
    count
}

#[test]
fn each_class_of_rotation_mirror_and_reversal_is_judged_once() {
    for cycle in CYCLES {
        for cylinders in 1..=7 {
            let problem = Problem::inline(cylinders, cycle, &[1]);
            let every = every_value(&problem).expect("a question");
            let (stars, directions) = of_even_throws(cylinders, cycle);
            assert_eq!(every.all, BigUint::from(stars.len()));
            assert_eq!(every.stars.iter().filter_map(|star| star.stars).sum::<u64>(), stars.len() as u64);
            assert_eq!(every.judged, orbits(&stars, directions) as u64, "{cylinders} cylinders, {cycle:?}");
            assert_eq!(every.stars.iter().filter_map(|star| star.classes).sum::<u64>(), every.judged);
        }
    }
}

#[test]
fn the_24_stars_of_five_cylinders_have_8_pairs_of_moments() {
    for cycle in CYCLES {
        let every = every_value(&Problem::inline(5, cycle, &[1, 2])).expect("a question");
        assert_eq!((every.all.clone(), every.stars.len()), (24_u32.into(), 8));
        let first = &every.stars[0];
        let rounded: Vec<String> = first.moments.iter().map(|m| format!("{:.4}", m.decimal)).collect();
        assert_eq!(rounded, ["0.4490", "4.9798"]);
        assert_eq!(summary(first).0, ["√(50 − 22√5)/2", "√(50 + 22√5)/2"]);
    }
}

#[test]
fn six_cylinders_two_stroke_without_first_order_couple_keep_2_root_3() {
    let front = found(&Problem::inline(6, Cycle::TwoStroke, &[1, 2]));
    let values: Vec<_> = front.stars.iter().map(summary).collect();
    let of = |m1: &str, m2: &str, classes| (vec![m1.to_owned(), m2.to_owned()], classes);
    assert_eq!(values, [of("0", "2√3", 1), of("√3", "3", 1), of("3", "√3", 2), of("2√3", "0", 1)]);
}

#[test]
fn four_stroke_engines_of_4_6_and_8_cylinders_have_mirror_stars_without_moments() {
    for (cylinders, classes) in [(4, 1), (6, 1), (8, 3)] {
        let front = found(&Problem::inline(cylinders, Cycle::FourStroke, &[1, 2]));
        assert_eq!(front.stars.iter().map(summary).collect::<Vec<_>>(), [(vec!["0".into(), "0".into()], classes)]);
        let star = &front.stars[0];
        assert!(star.throws.iter().eq(star.throws.iter().rev()) || cylinders == 8);
    }
}

#[test]
fn the_bound_loses_nothing_of_the_fronts_of_eight_cylinders() {
    for cycle in CYCLES {
        for neighbours in [false, true] {
            let problem = Problem { neighbours, ..Problem::inline(8, cycle, &[1, 2]) };
            let (front, every) = (found(&problem), every_value(&problem).expect("a question"));
            assert!(front.judged * 3 < every.judged, "{} of {} are decided", front.judged, every.judged);
            assert_eq!(every.cut, 0);
            for star in &front.stars {
                let same = every.stars.iter().find(|other| is_same(star, other)).expect("a value there is");
                assert_eq!((star.classes, star.stars, &star.throws), (same.classes, same.stars, &same.throws));
            }
            let best =
                every.stars.iter().filter(|star| !every.stars.iter().any(|other| beats(other, star, neighbours)));
            assert_eq!(best.count(), front.stars.len(), "{cycle:?}, neighbours {neighbours}");
        }
    }
}

fn is_same(one: &FoundStar, other: &FoundStar) -> bool {
    one.neighbours == other.neighbours && one.throws == other.throws
}

/// By decimals: unequal values of eight cylinders differ by more than 1e-9.
fn beats(one: &FoundStar, other: &FoundStar, neighbours: bool) -> bool {
    let values = |star: &FoundStar| {
        let count = star.neighbours.filter(|_| neighbours).map(|count| count as f64);
        star.moments.iter().map(|moment| moment.decimal).chain(count).collect::<Vec<_>>()
    };
    let pairs: Vec<(f64, f64)> = values(one).into_iter().zip(values(other)).collect();
    pairs.iter().all(|(a, b)| *a < b + 1e-9) && pairs.iter().any(|(a, b)| *a < b - 1e-9)
}

/// Throws in units of 1/n turn, for a firing order of a two-stroke engine.
fn two_stroke_throws(order: &[usize]) -> Vec<u16> {
    let place = |cylinder: usize| order.iter().position(|&fired| fired == cylinder).expect("each cylinder fires");
    (1..=order.len()).map(|cylinder| ((order.len() - place(cylinder)) % order.len()) as u16).collect()
}

#[test]
fn the_published_order_of_twelve_cylinders_leaves_no_moment_of_orders_1_and_2() {
    let front = found(&Problem::inline(12, Cycle::TwoStroke, &[1, 2]));
    assert_eq!(front.stars.iter().map(summary).collect::<Vec<_>>(), [(vec!["0".into(), "0".into()], 15)]);
    assert!(front.judged < 30_000, "{} of {} stars are decided", front.judged, front.all);
    let published = two_stroke_throws(&[1, 8, 12, 4, 2, 9, 10, 5, 3, 7, 11, 6]);
    assert_eq!(front.standing(&published), Ok(Standing::On));
    assert!(front.standing(&[0; 12]).is_err(), "no star");
}

#[test]
fn a_v6_and_a_v8_come_out_at_their_known_best() {
    let v6 = found(&Problem::vee(6, Cycle::FourStroke, Turn::fraction(1, 6), &[1, 2]));
    assert_eq!(
        v6.stars.iter().map(summary).collect::<Vec<_>>(),
        [(["2√3", "√3", "3", "0"].map(str::to_owned).to_vec(), 1)]
    );
    // The cross-plane crankshaft of the catalogue, which leaves no second-order couple.
    let right_angle = Turn::fraction(1, 4);
    let v8 = found(&Problem::vee(8, Cycle::FourStroke, right_angle.clone(), &[1, 2]));
    assert_eq!(v8.standing(&[0, 3, 1, 2]), Ok(Standing::On));
    let cross = v8.stars.iter().find(|star| star.moments[2].sum.vanishes()).expect("the cross-plane star");
    assert_eq!(summary(cross).0, ["2√10", "0", "0", "0"]);
    assert!(cross.firing_order.is_some(), "it fires evenly");
    // The flat-plane one leaves none at all.
    let flat = Problem { directions: Some(2), ..Problem::vee(8, Cycle::FourStroke, right_angle, &[1, 2]) };
    let flat = found(&flat);
    assert_eq!(summary(&flat.stars[0]), (vec!["0".into(); 4], 1));
    assert_eq!(flat.stars[0].throws, [0, 1, 1, 0].map(|half| Turn::fraction(half, 2)));
}

#[test]
fn a_found_star_is_an_engine_with_the_moments_it_claims() {
    let vee = Problem::vee(8, Cycle::FourStroke, Turn::fraction(1, 4), &[1, 2]);
    let grid = Problem { grid: Some(8), ..Problem::inline(5, Cycle::FourStroke, &[1, 2]) };
    for problem in
        [Problem::inline(7, Cycle::TwoStroke, &[1, 2, 4]), Problem::inline(6, Cycle::FourStroke, &[1]), vee, grid]
    {
        for star in found(&problem).stars {
            let layout = star.engine(&problem).expect("a layout that reads");
            let firing = layout.firing();
            assert_eq!(star.firing_order.is_some(), firing.is_some_and(|firing| firing.is_even()));
            for moment in &star.moments {
                let sense = Some(moment.sense.unwrap_or(Sense::Direct));
                let own = order::star(&layout, Quantity::MOMENT, moment.order, sense).squared_modulus();
                assert!(own.minus(&moment.sum.squared_modulus()).vanishes());
            }
            let force = order::star(&layout, Quantity::FORCE, 1, Some(Sense::Direct));
            assert!(force.vanishes());
        }
    }
}

#[test]
fn the_file_of_a_found_star_reads_as_its_engine() {
    let vee = |orders: &[u32]| Problem::vee(8, Cycle::FourStroke, Turn::fraction(1, 5), orders);
    let uneven = Problem { grid: Some(8), ..Problem::inline(4, Cycle::TwoStroke, &[2]) };
    let mut problems = vec![vee(&[1]), Problem { directions: Some(2), ..vee(&[1, 2]) }, uneven];
    let pin_split = Some(Turn::fraction(-1, 12));
    let offset = |grid| Problem { grid, bank_offset: Some(BigRational::new((-2).into(), 7.into())), ..vee(&[1, 2]) };
    problems.extend([Problem { pin_split, ..vee(&[1, 2]) }, offset(None), offset(Some(4))]);
    for cycle in [Cycle::TwoStroke, Cycle::FourStroke] {
        problems.extend((1..=7).map(|cylinders| Problem::inline(cylinders, cycle, &[1, 2])));
        problems.push(Problem { grid: Some(5), ..Problem::inline(5, cycle, &[1, 2]) });
    }
    for problem in problems {
        for star in found(&problem).stars {
            let engine = star.engine(&problem).expect("an engine");
            let read = file::parse("star.toml", &star.layout_file(&problem)).expect("a layout");
            assert_eq!(engine.reference_plane(), read.reference_plane());
            // One was read from a file, which may describe a family, and the other not.
            let file = engine.file().clone();
            let read = Draft { file, reference_plane: ReferencePlane::Middle, ..read.into_draft() };
            assert_eq!(engine, read.build().expect("the same engine"), "{problem:?}");
        }
    }
}

#[test]
fn a_search_stopped_and_resumed_gives_the_same_bytes_on_any_number_of_threads() {
    for way in [Way::Join, Way::Walk] {
        stopped_and_resumed(way);
    }
}

fn stopped_and_resumed(way: Way) {
    let problem = match way {
        Way::Join => Problem::inline(12, Cycle::TwoStroke, &[1, 2]),
        Way::Walk => Problem { neighbours: true, ..Problem::inline(9, Cycle::TwoStroke, &[1, 2]) },
    };
    let options = || Options { way, ..Options::default() };
    let whole = json(&search(&problem, &Options { threads: 1, ..options() }).expect("a front"));
    let file = scratch("search-resume").join("state.shard");
    for (after, threads) in [(1, 1), (2, 2), (7, 3), (20, 1)] {
        let told = AtomicUsize::new(0);
        let progress = |_| match told.fetch_add(1, Ordering::Relaxed) + 1 == after {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let stopped =
            search(&problem, &Options { threads, resume: Some(file.clone()), progress: &progress, ..options() });
        assert_eq!(stopped.err(), Some(SearchError::Stopped), "after {after} pieces");
    }
    let pieces = fs::read_to_string(&file).expect("a text").matches("piece ").count();
    assert!(pieces >= 30, "{pieces} pieces are kept");
    let resumed = search(&problem, &Options { resume: Some(file.clone()), ..options() }).expect("a front");
    assert_eq!(json(&resumed), whole);
    let again = search(&problem, &Options { resume: Some(file.clone()), threads: 3, ..options() });
    assert_eq!(json(&again.expect("a front")), whole);
    assert_eq!(json(&search(&problem, &Options { threads: 3, ..options() }).expect("a front")), whole);
    let names: Vec<_> = fs::read_dir(file.parent().expect("a folder")).expect("a folder").collect();
    assert_eq!(names.len(), 1, "nothing is left beside the file");
}

fn crankstar(arguments: &str) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_crankstar"))
        .arg("search")
        .args(arguments.split_whitespace())
        .output()
        .expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("a text");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_v_with_split_pins_is_not_called_one_on_shared_pins() {
    let asked = "--cylinders 6 --cycle four-stroke --bank-angle 60 --pin-split 60";
    let (_, told, _) = crankstar(asked);
    assert!(told.contains("Each throw has two pins") && !told.contains("shared"), "{told}");
    let odd = "--cylinders 7 --cycle four-stroke --bank-angle 60 --pin-split 60";
    let (_, _, told) = crankstar(odd);
    assert!(told.contains("7 is odd") && !told.contains("shared"), "{told}");
}

#[test]
fn impossible_questions_are_answered_with_words() {
    let questions = [
        ("--cylinders 0 --cycle two-stroke", 1, "without cylinders"),
        ("--cylinders 41 --cycle two-stroke", 1, "up to 20 cylinders in line"),
        ("--cylinders 42 --cycle four-stroke --bank-angle 60", 1, "up to 40 cylinders in V"),
        ("--cylinders 4 --cycle six-stroke", 2, "two-stroke, four-stroke"),
        ("--cylinders 7 --cycle four-stroke --bank-angle 60", 1, "7 is odd"),
        ("--cylinders 6 --cycle four-stroke --bank-angle 720", 2, "between 0 and 360"),
        ("--cylinders 6 --cycle four-stroke --bank-angle=-90", 2, "one of 90° with its banks exchanged"),
        ("--cylinders 6 --cycle four-stroke --bank-angle=-360", 2, "between 0 and 360"),
        ("--cylinders 6 --cycle four-stroke --bank-angle 0", 1, "between 0 and 360"),
        ("--cylinders 10 --cycle two-stroke --minor-orders 1,2,3,4", 1, "362880 firing orders"),
        ("--cylinders 10 --cycle four-stroke --minor-orders 1/2,1,3/2,2", 1, "give 3 or fewer"),
        ("--cylinders 6 --cycle four-stroke --bank-angle sixty", 2, "not a number"),
        ("--cylinders 6 --cycle four-stroke --bank-angle 60 --directions 2", 1, "cannot share 2 directions"),
        ("--cylinders 6 --cycle four-stroke --directions 3", 1, "fixes the directions"),
        ("--cylinders 6 --cycle four-stroke --bank-angle 180 --orders 2,4", 1, "vanish for every star"),
        ("--cylinders 6 --cycle four-stroke --grid 0", 1, "1 to 360 directions"),
        ("--cylinders 16 --cycle two-stroke --grid 360", 1, "up to 10^12"),
        ("--cylinders 6 --cycle two-stroke --orders 0", 2, "a whole number from 1 to 1000"),
        ("--cylinders 6 --cycle two-stroke --orders 1,2,3,4,5,6,7,8,9", 1, "1 to 8 orders"),
        ("--cylinders 13 --cycle four-stroke --grid 4 --neighbours", 1, "counted for up to 12"),
        ("--cylinders 6 --cycle two-stroke --bank-angle 60.12345678901234 --neighbours", 1, "round the bank angle"),
        ("--cylinders 6 --cycle two-stroke --pin-split 30", 2, "--bank-angle"),
        ("--cylinders 6 --cycle two-stroke --bank-offset 1/3", 2, "--bank-angle"),
        ("--cylinders 6 --cycle four-stroke --bank-angle 60 --bank-offset far", 2, "--bank-offset `far`"),
        ("--cylinders 6 --cycle four-stroke --bank-angle 60 --pin-split ahead", 2, "--pin-split `ahead`"),
        (
            "--cylinders 12 --cycle four-stroke --bank-angle 60 --bank-offset 1/3 --grid 24",
            1,
            "with a bank offset up to",
        ),
        (
            "--cylinders 6 --cycle four-stroke --bank-angle 61.2345 --bank-offset 1/3 --grid 6",
            1,
            "multiples of one angle",
        ),
        (
            "--cylinders 6 --cycle four-stroke --bank-angle 60 --bank-offset 1/1234567 --grid 6",
            1,
            "bank offset is too fine",
        ),
        ("--cylinders 6 --cycle four-stroke --bank-angle 60 --minor-orders 1/2", 1, "every star fires evenly"),
        ("--cylinders 6 --cycle four-stroke --grid 6 --minor-orders 1/2", 1, "every star fires evenly"),
        ("--cylinders 6 --cycle two-stroke --minor-orders 1/2", 1, "whole orders"),
        ("--cylinders 6 --cycle four-stroke --minor-orders 1,3", 1, "order 3 is a major one"),
        ("--cylinders 12 --cycle two-stroke --minor-orders 1", 1, "too many firing orders"),
        ("--cylinders 3 --cycle two-stroke --minor-orders 1 --mode-shape 1,2", 1, "2 values for 3 cylinders"),
        ("--cylinders 3 --cycle two-stroke --minor-orders 1 --mode-shape 1,2.00001,7.3", 1, "round the mode shape"),
        ("--cylinders 3 --cycle two-stroke --minor-orders 1 --mode-shape 0,0,0", 1, "without deflection"),
        ("--cylinders 3 --cycle two-stroke --torsion --mode-shape 0,0,0", 1, "without deflection"),
        ("--cylinders 3 --cycle two-stroke --mode-shape 1,2,3", 2, "add --torsion or --minor-orders"),
        ("--cylinders 6 --cycle two-stroke --resume /dev/null/state", 1, "cannot write"),
    ];
    for (arguments, status, words) in questions {
        let (code, out, err) = crankstar(arguments);
        assert_eq!((code, out.as_str()), (Some(status), ""), "{arguments}");
        assert!(err.contains(words), "{arguments}: {err}");
    }
}

#[test]
fn the_page_of_a_search_draws_its_first_stars_and_gives_them_as_layout_files() {
    let front = found(&Problem::inline(6, Cycle::TwoStroke, &[1, 2]));
    let page = report::search_page(&front);
    let files = page::write(&page, page::Format::GITHUB, &page::Options::default());
    let drawn = front.stars.len().min(3);
    assert_eq!(files.iter().filter(|file| file.name.ends_with(".svg")).count(), 1 + 2 * drawn);
    let stairs = files.iter().find(|file| file.name == "front.svg").expect("the front");
    assert_eq!(stairs.text.matches("<circle").count(), front.stars.len(), "a dot a star");
    // The first star leaves nothing of order 1, and is drawn at order 2.
    assert!(files.iter().any(|file| file.name == "star-1-order-2.svg"));
    for star in front.stars.iter().take(drawn) {
        assert!(files[0].text.contains(&star.layout_file(&front.problem)));
    }
    assert_eq!(files[0].text.matches("\n| ").count(), front.stars.len() + 2, "a row a star");
}

#[test]
fn each_star_of_the_front_is_a_layout_file_beside_the_page_that_report_reads() {
    let folder = scratch("search-output");
    let path = folder.to_str().expect("a path");
    let (code, out, err) = crankstar(&format!("--cylinders 6 --cycle two-stroke --output {path}"));
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert!(out.contains("Written"), "{out}");
    let front = found(&Problem::inline(6, Cycle::TwoStroke, &[1, 2]));
    for (number, star) in (1..).zip(&front.stars) {
        let layout = folder.join(format!("star-{number}.toml"));
        let text = fs::read_to_string(&layout).expect("a layout");
        assert_eq!(text, star.layout_file(&front.problem));
        let report =
            Command::new(env!("CARGO_BIN_EXE_crankstar")).arg("report").arg(&layout).output().expect("it starts");
        assert!(report.status.success(), "{}", String::from_utf8_lossy(&report.stderr));
        let order = star.firing_order.as_ref().expect("even").iter().map(|cylinder| (cylinder + 1).to_string());
        let order = order.collect::<Vec<_>>().join("-");
        assert!(String::from_utf8_lossy(&report.stdout).contains(&order), "the report of star {number} says {order}");
    }
    assert!(!folder.join("star-5.toml").exists());
}

#[test]
fn stars_of_a_grid_with_balanced_force_are_counted_as_a_plain_loop_counts_them() {
    for (cylinders, grid) in [(1, 5), (2, 6), (3, 12), (4, 9), (5, 12), (6, 8), (6, 10), (4, 30), (7, 6)] {
        let problem = Problem { grid: Some(grid), ..Problem::inline(cylinders, Cycle::TwoStroke, &[1]) };
        let is_balanced = |index: &u32| {
            let throw = |place: u32| u64::from(index / grid.pow(place) % grid);
            let terms: Vec<(u64, i64)> = (0..cylinders).map(|place| (throw(place), 1)).collect();
            crankstar::exact::vanishes(&u64::from(grid), &terms)
        };
        // Those whose first throw is at 0.
        let count = (0..grid.pow(cylinders)).step_by(grid as usize).filter(is_balanced).count();
        assert_eq!(found(&problem).balanced, Some(count as u64), "{cylinders} throws on {grid} directions");
    }
    assert_eq!(found(&Problem::inline(6, Cycle::TwoStroke, &[1])).balanced, None);
}

#[test]
fn an_answer_on_a_grid_tells_that_balanced_stars_alone_are_compared() {
    let (_, out, _) = crankstar("--cylinders 3 --cycle two-stroke --grid 6 --orders 3");
    assert!(out.contains("2 of the 2 crank stars are the best"), "{out}");
    assert!(out.contains("Only crank stars with balanced first-order force are compared: 2 of the 36"), "{out}");
    let (_, out, _) = crankstar("--cylinders 3 --cycle two-stroke --grid 6 --orders 3 --json");
    let document: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!((&document["all_stars"], &document["balanced_stars"]), (&"36".into(), &2.into()));
    let (_, out, _) = crankstar("--cylinders 3 --cycle two-stroke --grid 4");
    assert!(
        out.contains("None of the 16 crank stars has balanced first-order force") && !out.contains("Only"),
        "{out}"
    );
    let (_, out, _) = crankstar("--cylinders 8 --cycle four-stroke --bank-angle 90 --directions 2 --format markdown");
    assert!(out.contains("One star does, with cylinder 1 at 0°: the one that is its own mirror image"), "{out}");
    let (_, out, _) = crankstar("--cylinders 4 --cycle two-stroke --grid 1");
    assert!(out.contains("There is one crank star, and its first-order force is not balanced."), "{out}");
}

#[test]
fn a_front_of_one_star_or_one_order_has_no_picture_of_its_own() {
    for orders in [&[1][..], &[1, 2]] {
        let page = report::search_page(&found(&Problem::inline(4, Cycle::FourStroke, orders)));
        let files = page::write(&page, page::Format::GITHUB, &page::Options::default());
        assert!(files.iter().all(|file| file.name != "front.svg"));
    }
}

#[test]
fn the_program_prints_a_table_or_json_and_nothing_on_standard_error() {
    let (code, out, err) = crankstar("--cylinders 6 --cycle two-stroke");
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert!(out.contains("1-5-3-4-2-6") && out.contains("2√3 ≈ 3.464"), "{out}");
    let (_, out, _) = crankstar("--cylinders 6 --cycle two-stroke --json --orders 2,1,2");
    let document: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(document["stars"][0]["moments"][1]["exact"], "2√3");
    assert_eq!(document["stars"][0]["firing_order"], "1-5-3-4-2-6");
}
