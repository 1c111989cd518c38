//! Do the masses that are found balance the shaft, are they those of the theory, and is it said why there are none?

use crankstar::exact::{PhasorSum, Term};
use crankstar::file::{Rotor, parse_rotor};
use crankstar::numbers;
use crankstar::numbers::float;
use crankstar::page::{Document, Figures, Format, Options, Unit, Units};
use crankstar::report::{Question, RotorStudy};
use crankstar::rotor::{Answer, Found, Reason, balance, locomotive, secondary};
use num_complex::Complex;
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::pages;
use crate::support::program::{call, scratch};
use crate::support::written::{assert_near, fraction};

const SHAFT: &str = include_str!("../../examples/shaft.toml");

/// A file of masses: kilograms, millimetres, degrees, millimetres; `?` is wanted.
fn file(rows: &[[&str; 4]]) -> String {
    let one = |row: &[&str; 4]| {
        let keys = ["mass", "radius", "angle", "position"].into_iter().zip([" kg", " mm", "", " mm"]).zip(row);
        let known = keys.filter(|(_, value)| **value != "?");
        let lines: String = known.map(|((key, unit), value)| format!("{key} = '{value}{unit}'\n")).collect();
        format!("[[mass]]\n{lines}")
    };
    rows.iter().map(one).collect()
}

fn rotor(text: &str) -> Rotor {
    parse_rotor("shaft.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn solved(text: &str) -> Vec<Vec<Found>> {
    match balance(&rotor(text)).unwrap_or_else(|error| panic!("{text}\n{error}")) {
        Answer::Found(solutions) => solutions,
        other => panic!("{other:?}"),
    }
}

fn reason(text: &str) -> Reason {
    match balance(&rotor(text)).unwrap_or_else(|error| panic!("{text}\n{error}")) {
        Answer::Never(reason) | Answer::Many(reason) => reason,
        other => panic!("{other:?}"),
    }
}

/// Force and couple with what was found in its place, in decimals, by Newton's law alone.
fn left(rotor: &Rotor, solution: &[Found]) -> f64 {
    let (mut force, mut couple) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
    for (index, mass) in rotor.masses.iter().enumerate() {
        let found = solution.iter().find(|one| one.index == index);
        let known = |value: &Option<BigRational>| value.as_ref().map(numbers::float);
        let at = found
            .and_then(|one| one.position.as_ref())
            .map_or_else(|| known(&mass.position).expect("z"), |z| z.decimal);
        let vector = match found {
            Some(one) => Complex::from_polar(one.mass_radius.decimal.abs(), one.angle.to_radians()),
            None => {
                let all = known(&mass.mass).expect("m") + numbers::float(&(&rotor.share * &mass.reciprocating));
                let angle = mass.angle.as_ref().expect("an angle").degrees();
                Complex::from_polar(all * known(&mass.radius).expect("r"), numbers::float(&angle).to_radians())
            }
        };
        force += vector;
        couple += vector * at;
    }
    force.norm() + couple.norm()
}

#[test]
fn the_textbooks_four_masses_are_balanced_in_two_planes() {
    let solutions = solved(SHAFT);
    let [x, y] = solutions[0].as_slice() else { panic!("{solutions:?}") };
    for (found, mass, angle) in [(x, 352.972118655, 213.371323533), (y, 184.059023824, 347.197726208)] {
        assert_near(found.mass_radius.decimal / 0.1, mass, 1e-9);
        assert_near(found.angle, angle, 1e-9);
    }
}

#[test]
fn inner_cranks_are_roots_of_seven_and_thirteen() {
    let text = file(&[
        ["400", "1000", "0", "0"],
        ["?", "1000", "?", "450"],
        ["?", "1000", "?", "1200"],
        ["400", "1000", "120", "1800"],
    ]);
    let solutions = solved(&text);
    for (found, exact, mass, angle) in [
        (&solutions[0][0], "320√7", 846.640420, 160.893394649),
        (&solutions[0][1], "240√13", 865.332306, 313.897886248),
    ] {
        assert_eq!(found.mass_radius.exact.as_ref().expect("a closed form").to_string(), exact);
        assert_near(found.mass_radius.decimal, mass, 1e-6);
        assert_near(found.angle, angle, 1e-9);
    }
}

#[test]
fn angles_of_three_masses_are_found_with_their_mirror_image() {
    let rows =
        [["?", "100", "?", "0"], ["10", "125", "?", "600"], ["5", "200", "?", "1200"], ["4", "150", "?", "1800"]];
    let text = file(&rows);
    let solutions = solved(&text);
    assert_eq!(solutions.len(), 2);
    let [a, b, c, d] = solutions[0].as_slice() else { panic!("{solutions:?}") };
    assert_eq!((&b.cosine, b.angle), (&None, 0.0));
    assert_eq!((c.cosine.clone(), d.cosine.clone()), (Some(fraction(-929, 2000)), Some(fraction(-107, 600))));
    assert_near(c.angle, 117.677867708, 1e-9);
    assert_near(d.angle, 259.727303785, 1e-9);
    assert_eq!(a.mass_radius.exact.as_ref().expect("a root").scaled(&fraction(10, 1)).to_string(), "√219/2");
    assert_near(a.angle, 203.512131839, 1e-9);
    for (one, other) in solutions[0].iter().zip(&solutions[1]).skip(1) {
        assert_near((one.angle + other.angle).rem_euclid(360.0), 0.0, 1e-9);
    }
    for solution in &solutions {
        assert!(left(&rotor(&text), solution) < 1e-12);
    }
    let [a, b, c, _] = rows;
    assert_eq!(reason(&file(&[a, b, c, ["400", "150", "?", "1800"]])), Reason::NoTriangle);
    // Moments of 1, 2 and 3 lie in one plane: one solution.
    let flat =
        [["?", "100", "?", "0"], ["1", "100", "?", "1000"], ["1", "100", "?", "2000"], ["1", "100", "?", "3000"]];
    assert_eq!(solved(&file(&flat)).len(), 1);
}

#[test]
fn the_wanted_mass_may_have_the_angle_that_the_others_are_found_from() {
    let others = [["10", "125", "?", "600"], ["5", "200", "?", "1200"], ["4", "150", "?", "1800"]];
    let with = |angle: &'static str| {
        let [b, c, d] = others;
        file(&[["?", "100", angle, "0"], b, c, d])
    };
    let (free, text) = (solved(&with("?")), with("30"));
    let solutions = solved(&text);
    assert_eq!(solutions.len(), 2);
    for (solution, free) in solutions.iter().zip(&free) {
        assert!(left(&rotor(&text), solution) < 1e-12);
        let turned = 30.0 - free[0].angle;
        for (one, other) in solution.iter().zip(free) {
            assert_eq!(one.mass_radius.exact, other.mass_radius.exact);
            let apart = (one.angle - other.angle - turned).rem_euclid(360.0);
            assert!(apart.min(360.0 - apart) < 1e-9, "{solution:?}");
        }
    }
}

#[test]
fn masses_and_planes_in_given_directions_are_exact() {
    let text = file(&[
        ["10", "1000", "0", "0"],
        ["8", "1000", "90", "300"],
        ["?", "1000", "210", "?"],
        ["?", "1000", "300", "?"],
    ]);
    let solutions = solved(&text);
    let exact = |place: usize| solutions[0][place].mass_radius.exact.as_ref().expect("a closed form").to_string();
    assert_eq!([exact(0), exact(1)], ["4 + 5√3", "4√3 − 5"]);
    for (found, z) in
        solutions[0].iter().zip([(30.0 * 3f64.sqrt() - 24.0) / 295.0, (30.0 * 3f64.sqrt() + 72.0) / 115.0])
    {
        let position = found.position.as_ref().expect("a plane");
        assert_near(position.decimal, z, 1e-12);
        assert_near(position.exact.as_ref().expect("a closed form").to_float(), z, 1e-12);
    }
}

const LOCOMOTIVE: &str = "speed = 300\nshare = '2/3'\n\
    [[mass]]\nname = 'left wheel'\nradius = '600 mm'\nposition = '-750 mm'\n\
    [[mass]]\nmass = '150 kg'\nreciprocating_mass = '180 kg'\nradius = '300 mm'\nangle = 0\nposition = '-350 mm'\n\
    [[mass]]\nmass = '150 kg'\nreciprocating_mass = '180 kg'\nradius = '300 mm'\nangle = 90\nposition = '350 mm'\n\
    [[mass]]\nname = 'right wheel'\nradius = '600 mm'\nposition = '750 mm'\n";

#[test]
fn a_locomotive_has_the_values_of_the_theory() {
    let text = LOCOMOTIVE;
    let solutions = solved(text);
    assert_near(solutions[0][0].mass_radius.decimal / 0.6, 105.342299196, 1e-9);
    assert_near(solutions[0][0].angle, 199.983106522, 1e-9);
    let locomotive = locomotive(&rotor(text)).expect("two wheels");
    let omega = 10.0 * std::f64::consts::PI;
    let size = |sum: &PhasorSum| numbers::length(numbers::evaluate(sum)) * omega * omega;
    assert_near(size(&locomotive.hammer_blow[0]), 27724.98186, 1e-5);
    assert_near(size(&locomotive.hammer_blow[1]), 27724.98186, 1e-5);
    // The cranks are alike, so that the weight for the share is in one direction with the whole.
    for (place, blow) in [0, 1].into_iter().zip(&locomotive.hammer_blow) {
        let blow = numbers::evaluate(blow);
        let degrees = blow.im.atan2(blow.re).to_degrees().rem_euclid(360.0);
        assert_near(degrees, solutions[0][place].angle, 1e-9);
    }
    assert_near(size(&locomotive.tractive), 25123.91112, 1e-5);
    assert_near(size(&locomotive.swaying), 8793.368892, 1e-6);
}

#[test]
fn what_is_found_for_random_shafts_balances_them_and_exactly_so() {
    let mut dice = Dice::new(8);
    let mut found = 0;
    for round in 0..300 {
        let mut number = |most: u64| (1 + dice.below(most)).to_string();
        let mut rows: Vec<[String; 4]> = (0..3)
            .map(|_| {
                [number(90), number(300), (15 * number(24).parse::<u64>().expect("a number")).to_string(), number(900)]
            })
            .collect();
        let (one, other) = (number(900), number(900));
        let wanted = |angle: &str, position: &str| ["?", "100", angle, position].map(str::to_owned);
        match round % 4 {
            0 | 1 => rows.extend([wanted("?", &one), wanted("?", &other)]),
            2 => rows.extend([wanted("75", "?"), wanted("240", "?")]),
            _ => rows.push(wanted("?", "?")),
        }
        let rows: Vec<[&str; 4]> =
            rows.iter().map(|row| [&row[0], &row[1], &row[2], &row[3]].map(String::as_str)).collect();
        let text = file(&rows);
        let Ok(Answer::Found(solutions)) = balance(&rotor(&text)) else { continue };
        found += 1;
        for solution in &solutions {
            let farthest =
                solution.iter().filter_map(|one| one.position.as_ref()).map(|z| z.decimal.abs()).fold(1.0, f64::max);
            assert!(left(&rotor(&text), solution) < 1e-9 * farthest, "{text}{solution:?}");
        }
        if round % 4 < 2 {
            // The sums themselves: known masses and the vectors found.
            let all = rotor(&text);
            let known = all.masses[..3].iter().map(|mass| {
                let weight = mass.mass.clone().expect("m") * mass.radius.clone().expect("r");
                (
                    PhasorSum::new(vec![Term { angle: mass.angle.clone().expect("an angle"), weight }]),
                    mass.position.clone().expect("z"),
                )
            });
            let made = solutions[0]
                .iter()
                .map(|one| (one.vector.clone().expect("a sum"), all.masses[one.index].position.clone().expect("z")));
            let empty = || PhasorSum::new(Vec::new());
            let (force, couple) = known.chain(made).fold((empty(), empty()), |(force, couple), (vector, z)| {
                (force.plus(&vector), couple.plus(&vector.scaled(&z)))
            });
            assert!(force.vanishes() && couple.vanishes(), "{text}");
        }
    }
    assert!(found > 200, "{found}");
}

#[test]
fn the_reason_why_there_is_no_solution_is_the_right_one() {
    let a = ["10", "100", "0", "0"];
    let b = ["10", "100", "180", "500"];
    assert_eq!(reason(&file(&[a, ["?", "100", "?", "300"]])), Reason::Couple);
    assert_eq!(reason(&file(&[a, b, ["?", "100", "?", "?"]])), Reason::CoupleAlone);
    assert_eq!(reason(&file(&[a, ["10", "100", "90", "500"], ["?", "100", "?", "?"]])), Reason::NotParallel);
    assert_eq!(reason(&file(&[a, ["?", "100", "?", "300"], ["?", "100", "?", "300"]])), Reason::OnePlane);
    assert_eq!(reason(&file(&[a, ["?", "100", "90", "0"]])), Reason::Force);
    assert_eq!(reason(&file(&[a, ["?", "100", "30", "0"], ["?", "100", "210", "90"]])), Reason::Force);
    assert_eq!(reason(&file(&[a, ["?", "100", "0", "?"], ["?", "100", "180", "?"]])), Reason::OneLine);
    let couple =
        [a, ["10", "100", "90", "500"], ["10", "100", "270", "900"], ["?", "100", "0", "5"], ["?", "100", "0", "9"]];
    assert_eq!(reason(&file(&couple)), Reason::Couple);
    assert_eq!(reason(&file(&[a, ["?", "100", "120", "100"], ["?", "100", "240", "200"]])), Reason::Couple);
    let balanced = [a, ["20", "100", "180", "100"], ["10", "100", "0", "200"]];
    assert!(matches!(balance(&rotor(&file(&balanced))), Ok(Answer::Balanced)));
    let mut more = balanced.to_vec();
    more.push(["?", "100", "?", "?"]);
    assert_eq!(reason(&file(&more)), Reason::BalancedAlready);
    let Ok(Answer::Residual(sums)) = balance(&rotor(&file(&[a, b]))) else { panic!("a couple is left") };
    assert!(sums[0].vanishes() && !sums[1].vanishes());
    assert!(balance(&rotor(&file(&[a, ["?", "?", "?", "?"], ["?", "?", "?", "?"], ["?", "?", "?", "?"]]))).is_err());
}

#[test]
fn mistakes_in_a_file_of_masses_are_told_with_their_place() {
    let told = |text: &str| parse_rotor("shaft.toml", text).expect_err("a mistake").to_string();
    for (text, words) in [
        ("title = 'x'\n", "no masses on the shaft"),
        ("[[mass]]\nweight = 1\n", "weight"),
        ("[[mass]]\nmass = '-1 kg'\n", "mass"),
        ("[[mass]]\nradius = 0\n", "above 0"),
        ("share = 2\n[[mass]]\nmass = 1\n", "from 0 to 1"),
        ("[[mass]]\nmass = 1\nreciprocating_mass = 1\n", "without a share"),
        ("share = 1\n[[mass]]\nreciprocating_mass = 1\n", "that is wanted"),
        ("share = '2/3'\n[[mass]]\nmass = 1\nradius = 1\n", "a share without reciprocating masses"),
        ("[[mass]]\nname = 'A'\n[[mass]]\nname = 'A'\n", "masses 1 and 2 have the same name `A`"),
    ] {
        assert!(told(text).contains(words), "{}", told(text));
    }
}

#[test]
fn the_command_answers_and_shows_a_persons_names_harmlessly() {
    let out = call(&["rotor", concat!(env!("CARGO_MANIFEST_DIR"), "/examples/shaft.toml"), "--format", "csv"]);
    let csv = String::from_utf8_lossy(&out.stdout).into_owned();
    assert!(
        csv.contains("1,X,352.97211865") && csv.contains("213.3713235"),
        "{csv}{}",
        String::from_utf8_lossy(&out.stderr)
    );
    let layout = scratch("rotor").join("harm.toml");
    std::fs::write(&layout, "title = \"=cmd()\\u001b[31m<script>\"\n[[mass]]\nname = \"=1\\u001b[31m<script>|$x$\"\nradius = 1\nposition = 0\n[[mass]]\nmass = 1\nradius = 1\nangle = 1\nposition = 0\n").expect("a file");
    let layout = layout.to_str().expect("UTF-8");
    for format in ["csv", "json", "html", "markdown", "latex", "typst"] {
        let out = call(&["rotor", layout, "--format", format]);
        let text = String::from_utf8_lossy(&out.stdout).into_owned();
        assert!(out.status.success() && !text.contains('\u{1b}'), "{format} {text}");
        assert!(!matches!(format, "html") || !text.contains("<script>|"), "{text}");
    }
}

#[test]
fn parallel_masses_in_two_planes_are_found() {
    let text = file(&[["10", "100", "0", "0"], ["?", "100", "180", "300"], ["?", "100", "0", "500"]]);
    let solutions = solved(&text);
    let exact = |place: usize| solutions[0][place].mass_radius.exact.as_ref().and_then(numbers::Form::as_rational);
    assert_eq!([exact(0), exact(1)], [Some(fraction(5, 2)), Some(fraction(3, 2))]);
    assert!(left(&rotor(&text), &solutions[0]) < 1e-12);
}

/// The short answer, in one line.
fn said(text: &str) -> String {
    let study = RotorStudy::new(rotor(text)).expect("it is solved");
    let answer = crankstar::page::write(&study.answer(), Format::PLAIN, &Options::default());
    answer[0].text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn what_may_be_turned_about_the_shaft_is_said_to_be() {
    let text = file(&[
        ["?", "100", "?", "0"],
        ["10", "125", "?", "600"],
        ["5", "200", "?", "1200"],
        ["4", "150", "?", "1800"],
    ]);
    assert!(said(&text).contains("all others are these, turned about the shaft"), "{}", said(&text));
    let held = text.replacen("radius = '125 mm'\n", "radius = '125 mm'\nangle = 30\n", 1);
    assert!(said(&held).contains("mirror images of each other, and no other does"), "{}", said(&held));
    let page = RotorStudy::new(rotor(SHAFT)).expect("it is solved").page();
    let page = crankstar::page::write(&page, Format::PLAIN, &Options::default()).remove(0).text;
    assert!(page.contains("45°") && page.contains("235°"), "{page}");
}

#[test]
fn a_study_of_the_example_has_one_solution() {
    assert_eq!(RotorStudy::new(rotor(SHAFT)).expect("it is solved").solutions().len(), 1);
}

/// Outer cranks of 400 kg at 0° and 120°, planes 450, 750 and 600 mm apart: the second order is not balanced.
#[test]
fn inner_cranks_leave_the_second_order_that_newtons_law_gives() {
    let text = "secondary = true\n".to_owned()
        + &file(&[
            ["400", "1000", "0", "0"],
            ["?", "1000", "?", "450"],
            ["?", "1000", "?", "1200"],
            ["400", "1000", "120", "1800"],
        ]);
    let rotor = rotor(&text);
    let left = secondary(&rotor, &solved(&text)[0]).expect("all is known");
    assert_near(left.sums[0].norm(), 1_923.989_303, 1e-6);
    assert_near(left.sums[1].norm(), 1_899.509_359, 1e-6);
    assert!(left.exact.iter().all(Option::is_none));
    // All angles rational: exact sums.
    let known = "secondary = true\n".to_owned()
        + &file(&[
            ["1", "10", "0", "0"],
            ["1", "10", "180", "100"],
            ["1", "10", "180", "200"],
            ["1", "10", "0", "300"],
        ]);
    let study = RotorStudy::new(parse_rotor("shaft.toml", &known).expect("masses")).expect("it is solved");
    let left = study.secondary.expect("all is known");
    assert!(left.exact.iter().all(|sum| sum.as_ref().is_some_and(|sum| !sum.vanishes())));
    assert_near(left.sums[0].norm(), 0.04, 1e-12);
    let balanced = known.replace("angle = '180'", "angle = '90'");
    let study = RotorStudy::new(parse_rotor("shaft.toml", &balanced).expect("masses")).expect("it is solved");
    assert!(study.secondary.expect("all is known").exact[0].as_ref().expect("a sum").vanishes());
}

#[test]
fn four_cranks_balance_the_secondary_force_where_schlicks_condition_holds() {
    let mut dice = Dice::new(4);
    for _ in 0..40 {
        let inner = 100 + dice.below(700);
        let outer = inner + 50 + dice.below(900);
        let [z1, z2, z3, z4] = [1000 - outer as i64, 1000 - inner as i64, 1000 + inner as i64, 1000 + outer as i64];
        let text = "secondary = true\n".to_owned()
            + &file(&[
                ["400", "1000", "?", &z1.to_string()],
                ["?", "1000", "?", &z3.to_string()],
                ["?", "1000", "?", &z2.to_string()],
                ["400", "1000", "?", &z4.to_string()],
            ]);
        let solutions = solved(&text);
        assert_eq!(solutions.len(), 2);
        for solution in &solutions {
            // Newton's law for order 1, with the outer masses in their found angles, and for the force of order 2.
            let sum = |order: f64, arm: &dyn Fn(f64) -> f64| -> f64 {
                let places = [z1, z3, z2, z4];
                let terms = solution.iter().map(|one| {
                    let at = arm(places[one.index] as f64 / 1000.0);
                    Complex::from_polar(one.mass_radius.decimal * at, order * one.angle.to_radians())
                });
                terms.sum::<Complex<f64>>().norm()
            };
            assert!(sum(1.0, &|_| 1.0) < 1e-9 && sum(1.0, &|z| z) < 1e-9 && sum(2.0, &|_| 1.0) < 1e-9, "{text}");
            let [alpha, beta] = [solution[0].angle - solution[3].angle, solution[2].angle - solution[1].angle]
                .map(|between| between.to_radians() / 2.0);
            assert_near((2.0 * alpha.cos() * beta.cos()).abs(), 1.0, 1e-9);
            assert_near(
                solution[1].mass_radius.exact.as_ref().expect("a root").to_float(),
                solution[1].mass_radius.decimal,
                1e-9,
            );
        }
        let left = secondary(&rotor(&text), &solutions[0]).expect("all is known");
        assert!(left.exact[0].as_ref().is_some_and(PhasorSum::vanishes) && left.sums[1].norm() > 1e-3);
    }
    let mixed = |rows: &[[&str; 4]]| balance(&rotor(&("secondary = true\n".to_owned() + &file(rows))));
    let [a, b, c, d] = [["400", "1", "?", "0"], ["?", "1", "?", "3"], ["?", "1", "?", "7"], ["400", "1", "?", "10"]];
    assert!(mixed(&[a, b, c, d]).is_ok());
    assert!(mixed(&[a, b, c]).is_err() && mixed(&[a, b, c, ["401", "1", "?", "10"]]).is_err());
    assert!(mixed(&[a, b, ["?", "1", "?", "8"], d]).is_err());
    let both = "secondary = true\nshare = 1\n[[mass]]\nmass = 1\nreciprocating_mass = 1\n";
    assert!(parse_rotor("shaft.toml", both).expect_err("a mistake").to_string().contains("every mass reciprocates"));
}

/// The rows of the tables of answer and page by their cells; a heading stands before a row of dashes.
fn rows(study: &RotorStudy, units: Units) -> Vec<Vec<String>> {
    let options = Options { units, figures: Figures::new(10), ..Options::default() };
    let text = |document: &Document| crankstar::page::write(document, pages::DOLLARS, &options).remove(0).text;
    let text = text(&study.answer()) + &text(&study.page());
    let rows = text.lines().filter(|line| line.starts_with('|'));
    rows.map(|row| row.split('|').map(|cell| cell.replace(['\u{202f}', '\u{a0}'], " ")).collect()).collect()
}

/// The last number of a cell, or fraction: of a closed form its decimal.
fn last_number(cell: &str) -> Option<f64> {
    let cell = cell.replace('−', "-").replace(['*', '°'], " ");
    let number = |word: &str| match word.split_once('/') {
        Some((above, below)) => Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?),
        None => word.parse().ok(),
    };
    cell.split_whitespace().rev().find_map(number)
}

/// Masses, radii, products, positions, what is left of force, couple, second order, hammer blow, tractive force and swaying couple.
#[test]
fn every_number_in_inches_is_that_of_the_si_converted() {
    let known = [["20", "80", "0", "0"], ["10", "80", "0", "100"]];
    let files = [
        SHAFT.to_owned(),
        format!("speed = 600\n{}", file(&known)),
        format!("secondary = true\nspeed = 600\n{}", file(&known)),
        file(&[["3", "100", "0", "0"], ["4", "100", "90", "0"], ["?", "100", "?", "0"]]),
        file(&[["3", "100", "0", "0"], ["4", "100", "0", "300"], ["5", "?", "?", "?"]]),
        LOCOMOTIVE.to_owned(),
    ];
    let sizes = [
        (Unit::KILOGRAM, "lb"),
        (Unit::MILLIMETRE, "in"),
        (Unit::KILOGRAM_METRE, "oz·in"),
        (Unit::KILOGRAM_SQUARE_METRE, "lb·ft²"),
        (Unit::NEWTON, "lbf"),
        (Unit::KILONEWTON, "lbf"),
        (Unit::NEWTON_METRE, "lbf·ft"),
        (Unit::KILONEWTON_METRE, "lbf·ft"),
    ];
    for text in files {
        let study = RotorStudy::new(rotor(&text)).expect("it is solved");
        let (si, inch) = (rows(&study, Units::Si), rows(&study, Units::Inch));
        assert_eq!(si.len(), inch.len());
        // What a unit at the end of a cell or of a heading is in the unit of the inch.
        let ends_with = |cell: &str, unit: &str| {
            cell.trim().ends_with(&format!(" {unit}")) || cell.trim().ends_with(&format!("({unit})"))
        };
        let size = |cell: &str| {
            let unit = sizes.iter().find(|(unit, _)| ends_with(cell, unit.name));
            unit.map(|(unit, inch)| (float(&unit.inch().expect("an inch").1), *inch))
        };
        let mut converted = 0;
        for (place, (row, other)) in si.iter().zip(&inch).enumerate() {
            let is_heading = |place: usize| si.get(place + 1).is_some_and(|next| next[1].contains("---"));
            let heading = si[..place].iter().enumerate().rev().find(|(before, _)| is_heading(*before));
            for (column, (own, found)) in row.iter().zip(other).enumerate() {
                let unit = size(own).or_else(|| size(heading?.1.get(column)?).filter(|_| !is_heading(place)));
                let in_cell = size(own).is_none_or(|(_, inch)| ends_with(found, inch));
                let by = unit.map_or(1.0, |(by, _)| by);
                let (value, changed) = (last_number(own).unwrap_or(0.0), last_number(found).unwrap_or(0.0));
                assert!(in_cell && (changed * by - value).abs() <= 5e-4 * value.abs(), "{own} is not {found}: {by}");
                converted += usize::from(unit.is_some());
            }
        }
        assert!(converted > 0, "{text}");
    }
}

#[test]
fn what_may_be_omitted_is_said_as_it_is() {
    let alone = file(&[["3", "100", "0", "0"], ["?", "100", "?", "?"]]);
    assert!(balance(&rotor(&alone)).is_ok());
    let beside = file(&[["3", "100", "0", "0"], ["?", "100", "?", "?"], ["?", "100", "?", "300"]]);
    let told = balance(&rotor(&beside)).expect_err("too many unknowns").to_string();
    assert!(told.contains("of one or two masses, and of one that is wanted alone its position too"), "{told}");
}

#[test]
fn a_mass_that_belongs_opposite_to_its_direction_is_told_there_and_not_below_0() {
    let text = file(&[["5", "100", "0", "100"], ["?", "100", "0", "200"], ["?", "100", "180", "300"]]);
    let solutions = solved(&text);
    let told: Vec<[f64; 2]> = solutions[0].iter().map(|one| [one.mass_radius.decimal, one.angle]).collect();
    assert_eq!(told, [[1.0, 180.0], [0.5, 0.0]]);
    let said = said(&text);
    assert!(said.contains("Opposite to its given direction: 2, 3.") && !said.contains("≈ 180"), "{said}");
    assert!(left(&rotor(&text), &solutions[0]) < 1e-12);
}
