//! Do the numbers stay right where floats are at their worst, and does a verdict never change with them?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite hard_cases` writes `reports/stability` anew.
use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

use crate::support::hard::{Ask, CASES, Case};
use crate::support::verdicts::{judged, pistons};
use crate::support::written::vectors;
use crankstar::engine::{Draft, Engine, ReferencePlane};
use crankstar::file::{self, parse_number};
use crankstar::loads::{self, Outcome};
use crankstar::motion::SliderCrank;
use crankstar::proof::{Shape, check_certificate};
use crankstar::verdict::OrderVerdict;
use num_rational::BigRational;
use num_traits::{Pow, Signed, ToPrimitive, Zero};

/// The rod's part of the way at λ = 10⁻⁸ and ψ = 1: `(√(1−λ² sin²1) − 1)/λ`, mpmath at 75 digits.
const RODS_PART: &str = "-3.5403670913678560301649162819543707143093212963456e-9";

fn decimal(text: &str) -> BigRational {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let exponent: i32 = exponent.parse().expect("an exponent");
    parse_number(digits).expect("digits") * BigRational::from_integer(10.into()).pow(exponent)
}

/// The engine of a case: at 3000 rpm, with 1 kg, r = 50 mm and λ = 1/4 where it says nothing else.
fn engine(case: &str) -> Engine {
    let mut text = String::new();
    if !case.contains("speed") {
        text += "speed = 3000\n";
    }
    if case == "500 cylinders" {
        text += "effects = [\"torque\"]\nmechanism = { crank_radius = \"50 mm\", rod_ratio = 0.25 }\n";
        for i in 0..500_u32 {
            let throw = format!("throw = \"{}/499 turn\"", i * i % 499);
            let mass = format!("reciprocating_mass = \"{}/1000\"", 1000 + i);
            writeln!(text, "[[cylinder]]\n{throw}\nbank = 0\nposition = \"{}/10\"\n{mass}", i).expect("a string");
        }
    } else {
        if !case.contains("mechanism") {
            text += "mechanism = { crank_radius = \"50 mm\", rod_ratio = 0.25, reciprocating_mass = 1 }\n";
        }
        text += case;
    }
    file::parse("case.toml", &text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn crank(ratio: &str, offset: &str) -> SliderCrank {
    SliderCrank::new(decimal(ratio), decimal(offset)).expect("a crank that turns")
}

fn computed(engine_text: &str, ask: Ask) -> f64 {
    let loads_at = |orders: &[u32]| {
        let loads = loads::loads(&engine(engine_text), orders).expect("numbers");
        let scale = loads.scale.clone().expect("a mass, a radius and a speed");
        (loads, scale)
    };
    match ask {
        Ask::Coefficient { ratio, offset, order } => {
            let c = crank(ratio, offset).coefficient(order);
            if order % 2 == 0 { c.re.to_float() } else { c.im.to_float() }
        }
        Ask::Position { ratio } => crank(ratio, "0").position(1.0),
        Ask::Acceleration { ratio } => crank(ratio, "0").acceleration(1.0),
        Ask::Force(order) => {
            let (loads, scale) = loads_at(&[order]);
            loads.orders[0].force.largest() * scale.force()
        }
        Ask::Moment(order) => {
            let (loads, scale) = loads_at(&[order]);
            loads.orders[0].moment.largest() * scale.force()
        }
        Ask::Torque(order) => {
            let (loads, scale) = loads_at(&[order]);
            let torque = loads.torque.expect("a torque");
            let order = torque.orders.iter().find(|found| found.order == order).expect("the order");
            order.vector.value.norm() * scale.torque()
        }
        Ask::ForcePeak(orders) => {
            let (loads, scale) = loads_at(orders);
            loads.force.peak().value * scale.force()
        }
        Ask::MomentPeak(orders) => {
            let (loads, scale) = loads_at(orders);
            loads.moment.peak().value * scale.force()
        }
        Ask::TorquePeak(orders) => {
            let (loads, scale) = loads_at(orders);
            let torque = loads.torque.expect("a torque");
            assert!(torque.orders.iter().map(|order| order.order).eq(orders.iter().copied()));
            torque.waveform.real_peak().value * scale.torque()
        }
    }
}

/// Distance from the reference in units in the last place of the float nearest it; of a zero, any distance is infinite.
fn error_in_ulps(value: f64, reference: &BigRational) -> f64 {
    let exact = BigRational::from_float(value).unwrap_or_else(|| panic!("{value} is not a number"));
    if exact == *reference {
        return 0.0;
    }
    let nearest = reference.abs().to_f64().expect("a float");
    let unit = BigRational::from_float(nearest.next_up() - nearest).expect("a unit");
    if reference.is_zero() { f64::INFINITY } else { ((exact - reference).abs() / unit).to_f64().expect("a float") }
}

fn measured((name, engine, ask, _, condition, bound, reference): &Case) -> (f64, f64) {
    let error = error_in_ulps(computed(engine, *ask), &decimal(reference));
    let bound = (*condition * *bound) as f64;
    assert!(error <= bound, "{name}: an error of {error} units in the last place; {bound} are allowed");
    (error, bound)
}

/// The next power of two, so that the last bits of a machine's cosine do not show.
fn class(error: f64) -> String {
    match error.max(1.0).log2().ceil() as u32 {
        _ if error == 0.0 => "0".to_owned(),
        power @ 0..=6 => format!("≤ {}", 1_u32 << power),
        power => format!("≤ 2^{power}"),
    }
}

fn quantity(ask: Ask) -> String {
    let peak = |what: &str, orders: &[u32]| {
        let last = orders.last().expect("an order");
        format!("peak of the {what}, orders up to {last}, {}", if what == "force" { "N" } else { "N·m" })
    };
    match ask {
        Ask::Coefficient { offset: "0", order, .. } => format!("c_{order}"),
        Ask::Coefficient { order, .. } => {
            format!("c_{order}, {} part", if order % 2 == 0 { "real" } else { "imaginary" })
        }
        Ask::Position { .. } => "way at ψ = 1, in r".to_owned(),
        Ask::Acceleration { .. } => "acceleration at ψ = 1, in r ω²".to_owned(),
        Ask::Force(order) => format!("force of order {order}, N"),
        Ask::Moment(order) => format!("moment of order {order}, N·m"),
        Ask::Torque(order) => format!("torque of order {order}, N·m"),
        Ask::ForcePeak(orders) => peak("force", orders),
        Ask::MomentPeak(orders) => peak("moment", orders),
        Ask::TorquePeak(orders) => peak("torque", orders),
    }
}

/// Twenty digits of a reference.
fn shown(reference: &str) -> String {
    let (digits, exponent) = reference.split_once('e').unwrap_or((reference, "0"));
    let wanted = 21 + usize::from(digits.starts_with('-'));
    let digits = digits.get(..wanted).unwrap_or(digits).replace('-', "−");
    match exponent.trim_start_matches('+') {
        "0" => digits,
        power => format!("{digits}·10^{}", power.replace('-', "−")),
    }
}

fn table(rows: impl Iterator<Item = String>) -> String {
    let head =
        "| Case | Quantity | Reference | Condition | Bound | Measured |\n| --- | --- | --- | --- | --- | --- |\n";
    rows.fold(head.to_owned(), |text, row| text + &row)
}

fn page() -> String {
    let mut name = "";
    let rows = CASES.iter().map(|case| {
        let (error, bound) = measured(case);
        name = if case.0 == "the same" { name } else { case.0 };
        let ask = match case.2 {
            Ask::Coefficient { ratio, offset, .. } if offset != "0" => {
                format!("{}, δ = {offset}", quantity(case.2)).replace("λ", ratio)
            }
            ask => quantity(ask),
        };
        let condition = if case.4 < 1000 { case.4.to_string() } else { format!("{:.1}·10^8", case.4 as f64 / 1e8) };
        format!(
            "| {name} | {ask} | {} | {condition} | {} | {} |\n",
            shown(case.6),
            if case.6 == "0" { "0".to_owned() } else { class(bound) },
            class(error)
        )
    });
    let table = table(rows);
    let mut recipes: Vec<(&str, Vec<&str>)> = Vec::new();
    for case in CASES {
        let kind = match case.2 {
            Ask::Coefficient { offset: "0", .. } => "c_k without an offset",
            Ask::Coefficient { .. } => "c_k with an offset",
            Ask::Position { .. } => "way",
            Ask::Acceleration { .. } => "acceleration",
            Ask::Force(_) => "force",
            Ask::Moment(_) => "moment",
            Ask::Torque(_) => "torque",
            Ask::ForcePeak(_) => "peak of the force",
            Ask::MomentPeak(_) => "peak of the moment",
            Ask::TorquePeak(_) => "peak of the torque",
        };
        match recipes.iter_mut().find(|(recipe, _)| *recipe == case.3) {
            Some((_, kinds)) if kinds.contains(&kind) => {}
            Some((_, kinds)) => kinds.push(kind),
            None => recipes.push((case.3, vec![kind])),
        }
    }
    // A bar would end the cell.
    let row =
        |(recipe, kinds): &(&str, Vec<&str>)| format!("| {} | {} |\n", kinds.join(", "), recipe.replace('|', "\\|"));
    let recipes: String = recipes.iter().map(row).collect();
    let naive = class(error_in_ulps(naive_rods_part(), &decimal(RODS_PART))).replace("≤ ", "up to ");
    format!(
        "# Hard cases\n\n\
         Each number of the table was computed by the program in floats and compared with a reference of 50 digits, of which 20 are\n\
         shown. Errors are counted in units in the last place of the reference, rounded up to a power of two. The bound is a few\n\
         units, times the condition number where one is shown: it says how much larger the terms of a sum are than the sum, where\n\
         the terms themselves are rounded. A reference of 0 is a number that is proved to vanish: it has to be 0 exactly. Sums of\n\
         rotating vectors are evaluated from exact ones, so that cancellation between them costs nothing.\n\n\
         Where a case says nothing else: 1 kg, r = 50 mm, λ = 1/4, 3000 rpm, cylinders 0.1 m apart.\n\n{table}\n\
         The rod's part of the piston's way, (√(1−λ² sin²ψ) − 1)/λ, computed as it is written here, is off by\n\
         {naive} units in the last place at λ = 10^−8 and ψ = 1, where it is {}.\n\n\
         ## How the references were computed\n\n\
         With mpmath at 75 digits and more, from the formulas of the theory and not by this program's methods.\n\n\
         | Quantity | Formula |\n| --- | --- |\n{recipes}\n\
         ## Verdicts\n\n\
         None of these numbers enters a verdict: `tests/suite/hard_cases.rs` turns engines by angles over primes of ten digits, gives them\n\
         masses of 30 digits, planes a kilometre away, rods of λ = 10^−8 and 1 − 10^−12, and finds the same verdicts, each with a\n\
         certificate that the checker accepts.\n",
        shown(RODS_PART)
    )
}

fn naive_rods_part() -> f64 {
    let (ratio, sin) = (1e-8_f64, 1.0_f64.sin());
    ((1.0 - ratio * ratio * sin * sin).sqrt() - 1.0) / ratio
}

#[test]
fn every_hard_case_keeps_its_bound_and_the_page_is_as_stored() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/stability");
    let written = page();
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::create_dir_all(&folder).expect("the folder");
        fs::write(folder.join("README.md"), &written).expect("the page");
    }
    let stored = fs::read_to_string(folder.join("README.md")).expect("the page");
    assert!(stored == written, "reports/stability/README.md differs:\n{written}");
}

#[test]
fn naive_root_loses_every_digit_where_the_closed_form_loses_none() {
    let reference = decimal(RODS_PART);
    assert!(error_in_ulps(naive_rods_part(), &reference) > 1e15, "{}", naive_rods_part());
    let centre = error_in_ulps(
        crank("1e-8", "0").position(1.0),
        &decimal("-4.596976976722273739669194227219396782220602936914e-1"),
    );
    assert!(centre <= 2.0);
}

const ORDERS: [u32; 5] = [1, 2, 3, 4, 6];

/// Shapes of force and moment and the torque's verdict, order by order; every certificate is checked.
fn verdicts(layout: &Engine) -> Vec<(Shape, Shape, bool)> {
    let judged = judged(layout, &ORDERS, true);
    let outcome = |verdict: OrderVerdict| {
        let torque = verdict.torque.expect("a torque").parts.remove(0).verdict;
        let order = verdict.parts.into_iter().next().expect("a sum");
        let all = order.force.verdicts().into_iter().chain(order.moment.verdicts()).chain([&torque]);
        for verdict in all {
            let checked = check_certificate(&vectors(&verdict.sum), verdict.vanishes(), &verdict.certificate);
            assert_eq!(
                checked,
                Ok(()),
                "{}: order {} of {:?}",
                layout.title().written(),
                order.order,
                verdict.quantity
            );
        }
        (order.force.shape, order.moment.shape, torque.vanishes())
    };
    judged.into_iter().map(outcome).collect()
}

const ENGINES: [&str; 7] = ["I4", "I5-12453", "I6", "V6-60-even", "V8-crossplane", "boxer-6", "radial-9"];

/// The engine with its numbers changed, and the reason for a message.
fn hostile(name: &str, change: impl Fn(&mut Draft)) -> Engine {
    let engine = file::find(name).expect("an engine").engine().expect("it reads");
    let reference_plane = ReferencePlane::Named(engine.reference_plane().clone());
    let mut draft = Draft { reference_plane, ..engine.into_draft() };
    change(&mut draft);
    draft.build().expect("it holds together")
}

#[test]
fn verdicts_do_not_change_with_weights_of_thirty_digits_or_angles_over_primes_of_ten() {
    let weight = parse_number("1.23456789012345678901234567891").expect("a number");
    let turn = crankstar::exact::Turn::new(BigRational::new(333_333_333.into(), 9_999_999_967_i64.into()));
    for name in ENGINES {
        let plain = verdicts(&hostile(name, |_| ()));
        let heavy = hostile(name, |layout| {
            layout.cylinders.iter_mut().for_each(|cylinder| cylinder.reciprocating_mass = weight.clone());
        });
        assert_eq!(verdicts(&heavy), plain, "{name} with heavy pistons");
        // Crank and cylinders turned together: every sum turns as a whole.
        let turned = hostile(name, |layout| {
            for cylinder in &mut layout.cylinders {
                cylinder.throw = &cylinder.throw + &turn;
                cylinder.bank = &cylinder.bank + &turn;
            }
        });
        assert_eq!(verdicts(&turned), plain, "{name} turned");
        let stretched = hostile(name, |layout| {
            let factor = parse_number("1000000000.000000001").expect("a number");
            layout.cylinders.iter_mut().for_each(|cylinder| cylinder.position = &cylinder.position * &factor);
            if let ReferencePlane::Named(plane) = &mut layout.reference_plane {
                *plane = &*plane * &factor;
            }
        });
        assert_eq!(verdicts(&stretched), plain, "{name} stretched");
    }
}

#[test]
fn a_couple_is_the_same_about_a_plane_a_kilometre_away() {
    for name in ENGINES {
        let near = pistons(&hostile(name, |_| ()), &ORDERS);
        let far = hostile(name, |layout| {
            layout.reference_plane = ReferencePlane::Named(BigRational::from_integer(1000.into()))
        });
        verdicts(&far);
        let far = pistons(&far, &ORDERS);
        for (near, far) in near.iter().zip(&far) {
            assert_eq!(near.force.shape, far.force.shape, "{name}, order {}", near.order);
            if near.moment_is_couple() {
                assert_eq!(near.moment.shape, far.moment.shape, "{name}, order {}", near.order);
            }
        }
    }
}

#[test]
fn one_part_in_ten_to_the_thirty_breaks_a_balance_and_is_proved_to() {
    for name in ENGINES {
        let plain = verdicts(&hostile(name, |_| ()));
        let more = parse_number("1.000000000000000000000000000001").expect("a number");
        let layout = hostile(name, |draft| draft.cylinders[0].reciprocating_mass *= &more);
        for (before, after) in plain.iter().zip(verdicts(&layout)) {
            assert!(before.0 != Shape::Balanced || after.0 != Shape::Balanced, "{name}: {before:?}");
        }
    }
}

/// Rods, masses and speed are no part of a verdict, and the numbers that have them agree with it.
#[test]
fn loads_vanish_where_the_verdicts_say_so_whatever_the_rod_the_mass_and_the_speed() {
    let mechanisms =
        [("0.00000001", 1, "3000"), ("0.999999999999", 1, "0"), ("0.3", 1_000_000, "1e6"), ("0.999", 3, "1e-30")];
    for name in ENGINES {
        let text = &file::find(name).expect("an engine").engine().expect("it reads").file().written().to_owned();
        for (ratio, mass, speed) in mechanisms {
            let mechanism =
                format!("mechanism = {{ crank_radius = 0.05, rod_ratio = \"{ratio}\", reciprocating_mass = {mass} }}");
            let layout = file::parse(name, &format!("speed = \"{speed}\"\n{mechanism}\n{text}")).expect("it reads");
            let plain = pistons(&layout, &ORDERS);
            let loads = loads::loads(&layout, &ORDERS).expect("numbers");
            for (verdict, loads) in plain.iter().zip(&loads.orders) {
                let swings = [(&verdict.force, &loads.force), (&verdict.moment, &loads.moment)];
                for (balance, swing) in swings {
                    let pairs = [(&balance.direct, &swing.direct), (&balance.reverse, &swing.reverse)];
                    for (verdict, vector) in pairs {
                        // Order 3 has no coefficient without an offset.
                        let zero = verdict.vanishes() || loads.order == 3;
                        let wanted = if zero { Outcome::Zero } else { Outcome::NotZero };
                        assert_eq!(vector.outcome, wanted, "{name}, λ = {ratio}, order {}", loads.order);
                        assert_eq!(vector.value.norm() == 0.0, zero, "{name}, λ = {ratio}, order {}", loads.order);
                    }
                }
            }
        }
    }
}
