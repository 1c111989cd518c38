//! Does the torque of whole engines agree with the theory's numbers, and with a model that knows bodies and forces alone?

use crankstar::engine::CycleOrder;
use crankstar::engine::Engine;
use crankstar::gas::CylinderGas;
use crankstar::loads::Missing;
use crankstar::page::{self, Format, Options};
use crankstar::torque::{EngineTorque, Peak, PeakMethod, guide_moments, torque};

use crate::gas::{DIESEL, SPARK, engine};
use crate::support::dice::Dice;
use crate::support::gas_table::{self, AMBIENT, POINTS, pressure};
use crate::support::program::{call, scratch};
use crate::support::written::assert_near;

fn torque_of(text: &str) -> EngineTorque {
    torque(&engine(text)).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Four cylinders of the theory's example in line, at a speed.
fn four(speed: u32) -> String {
    let four = SPARK.replace("throws = [0]", "throws = [0, 180, 180, 0]").replace("'1'", "'1-3-4-2'");
    format!("speed = {speed}\n{four}[flywheel]\nirregularity = '1/50'\n")
}

#[test]
fn an_in_line_four_has_the_torque_and_the_flywheel_of_the_theory() {
    for (speed, inertia, energy, peak, flywheel) in [
        (1500, 182.591 / 4.0, 246.95, 513.6, 0.500426),
        (3000, 182.591, 121.68, 398.2, 0.061645),
        (6000, 730.366, 463.10, 689.6, 0.058652),
    ] {
        let torque = torque_of(&four(speed));
        assert_near(torque.mean, 156.6245, 5e-5);
        assert!(torque.balance < 1e-9, "{}", torque.balance);
        let second = &torque.orders[3];
        assert_near(second.gas.norm(), 273.543, 5e-4);
        assert_near(second.inertia.expect("masses").norm(), inertia, 5e-4);
        assert_near(torque.highest.value, peak, 0.05);
        let evenness = torque.evenness.as_ref().expect("a speed");
        assert_near(evenness.energy, energy, 5e-3);
        assert_near(evenness.needed.inertia, flywheel, 5e-7);
        let left: Vec<String> =
            torque.orders.iter().filter(|order| !order.vanishes()).map(|order| order.order.to_string()).collect();
        assert_eq!(left, ["2", "4", "6", "8", "10", "12"]);
    }
    let without_masses = four(3000).replace("reciprocating_mass = '0.5 kg'\n", "");
    let torque = torque_of(&without_masses);
    assert!(!torque.has_inertia() && torque.orders[3].inertia.is_none());
    assert_near(torque.evenness.expect("a speed").energy, 291.55, 5e-3);
}

#[test]
fn the_balance_of_energy_refines_the_irregularity_as_the_theory_says() {
    let at = |speed: u32, inertia: &str| {
        four(speed).replace("irregularity = '1/50'", &format!("inertia = '{inertia} kg m²'"))
    };
    for (speed, inertia, refined, by_energy) in
        [(1500, "0.500426", 0.0199246, 0.0199254), (6000, "0.058652", 0.0193747, 0.0193758)]
    {
        let given = torque_of(&at(speed, inertia)).evenness.and_then(|evenness| evenness.given).expect("an inertia");
        assert_near(given.irregularity, 0.02, 1e-6);
        // The theory puts ½ Σ m r² (1 + λ²/4) for the mean of Σ m s'².
        assert_near(given.refined, refined, 3e-7);
        assert_near(given.by_energy.expect("it turns"), by_energy, 2e-7);
    }
    let none = at(3000, "0.00001");
    assert_eq!(torque_of(&none).evenness.and_then(|evenness| evenness.given).expect("an inertia").by_energy, None);
}

#[test]
fn a_v6_of_three_throws_is_as_uneven_as_the_theory_says() {
    let vee = |angle: u32| {
        // The second bank fires γ + 120° after the first, modulo 240°, or γ.
        let second = if angle < 60 { [360, 600, 120] } else { [0, 240, 480] };
        let second = second.map(|fires| (fires + angle).to_string()).join(", ");
        let gas = SPARK.split_once("[gas]").map_or("", |(_, gas)| gas);
        torque_of(&format!(
            "cycle = 'four-stroke'\nspeed = 2000\nfiring_angles = [0, 240, 480, {second}]\n[mechanism]\nstroke = '86 mm'\n\
             rod_length = '143 mm'\nreciprocating_mass = '0.5 kg'\n[vee]\nbank_angle = {angle}\nthrows = [0, 120, 240]\n\
             numbering = 'by-bank'\n[gas]{gas}"
        ))
    };
    let energy = |angle: u32| vee(angle).evenness.expect("a speed").energy;
    let even = energy(120);
    for (angle, ratio) in [(10, 1.32), (20, 1.68), (60, 3.17), (90, 2.06), (110, 1.32), (180, 3.17)] {
        assert_near(energy(angle) / even, ratio, 5e-3);
    }
}

#[test]
fn the_peak_by_orders_is_off_by_what_the_theory_says_and_by_no_more_than_is_guaranteed() {
    let spark = [(3, 0.31), (6, 0.10), (12, 1.0e-2), (24, 6.6e-4), (48, 3.4e-4)];
    let diesel = [(3, 0.34), (6, 0.080), (12, 5.9e-3), (24, 1.5e-3), (48, 2.9e-4)];
    for (text, errors) in [(SPARK, spark), (DIESEL, diesel)] {
        let torque = torque_of(&text.replace("reciprocating_mass = '0.5 kg'\n", ""));
        let peak = Peak::new(&torque);
        for (order, error) in errors {
            let method = PeakMethod::Orders(CycleOrder::of_halves(2 * order).expect("an order"));
            assert!(peak.methods().contains(&method));
            let found = peak.farthest(method).expect("orders") / torque.highest.value;
            assert!((found - error).abs() < 0.06 * error, "order {order}: {found} is not {error}");
        }
    }
    for text in [four(3000), four(6000), format!("speed = 4000\n{SPARK}")] {
        let torque = torque_of(&text);
        let peak = Peak::new(&torque);
        let mut guaranteed = f64::INFINITY;
        for method in peak.methods() {
            let error = (peak.value(method) - torque.highest.value).abs();
            if let (Some(bound), Some(farthest)) = (peak.bound(method), peak.farthest(method)) {
                assert!(
                    error <= farthest && farthest <= bound && bound <= guaranteed,
                    "{method:?}: {error} of {bound}"
                );
                guaranteed = bound;
            }
        }
        assert_near(peak.value(PeakMethod::Refined), torque.highest.value, 1e-9);
        // Half a step from the peak the torque is lower by a part that shrinks with the square of the step.
        let samples = [36, 3600].map(|steps| peak.error(peak.value(PeakMethod::Samples(steps))));
        assert!(samples[1] < 1e-3 * samples[0].max(1e-3), "{samples:?}");
    }
}

#[test]
fn a_marine_two_stroke_has_the_guide_force_moments_of_the_theory() {
    let text = "cycle = 'two-stroke'\nfiring_order = '1-5-3-4-2-6'\nspeed = 127\n[mechanism]\nstroke = '2 m'\nrod_length = '2.05 m'\n\
        reciprocating_mass = 3000\n[inline]\nthrows = [0, 120, 240, 180, 300, 60]\nspacing = '0.85 m'\n[gas]\nbore = '0.5 m'\n\
        crankcase = '3.4 bar'\nprocess = 'diesel'\ncompression_ratio = 17\nintake_pressure = '3.4 bar'\nintake_closes = -110\nheat = '1.6 MJ'\n\
        wiebe_exponent = 1\ncombustion_starts = 0\ncombustion_lasts = 60\nexhaust_opens = 110\nblowdown = 40\n";
    let engine = engine(text);
    let torque = torque(&engine).expect("a torque");
    assert_near(torque.classes[0].gas.mean_pressure() / 1e5, 19.7147, 5e-5);
    let moments = guide_moments(&engine, &torque).expect("distances");
    for (order, moment) in moments.iter().enumerate().map(|(place, moment)| (place + 1, moment)) {
        let kilo = |moment: Option<f64>| moment.map(|moment| (moment / 10.0).round() / 100.0);
        let rocking = match order {
            6 => Some(381.74),
            12 => Some(10.89),
            _ => None,
        };
        assert_eq!(kilo(moment.rocking), rocking, "H of order {order}");
        match order {
            2 => assert_near(moment.twisting.expect("X") / 1e3, 80.04, 5e-3),
            3 => assert_near(moment.twisting.expect("X") / 1e3, 217.97, 5e-3),
            4 => assert_near(moment.twisting.expect("X") / 1e3, 186.29, 5e-3),
            1 | 5 | 6 | 7 | 11 | 12 => assert_eq!(moment.twisting, None, "X of order {order}"),
            _ => assert!(moment.twisting.is_some(), "X of order {order}"),
        }
    }
}

/// One cylinder as its bodies: lengths in metres, angles in degrees.
struct Bodies {
    radius: f64,
    length: f64,
    offset: f64,
    mass: f64,
    area: f64,
    fires: f64,
    table: usize,
}

impl Bodies {
    /// Torque on the crank, moment on the frame and force of the wall on the piston, by Newton's law for the piston: along its axis the rod's push balances gas and inertia.
    fn moments(&self, theta: f64, omega: f64, tables: &[Vec<f64>]) -> [f64; 3] {
        let degrees = theta - self.fires;
        let psi = degrees.to_radians();
        let (sin, cos) = psi.sin_cos();
        let pin = (self.radius * cos, self.radius * sin);
        let across = self.offset - pin.1;
        let along = (self.length * self.length - across * across).sqrt();
        // (s − x)² + (e − y)² = l², differentiated once and twice, x' = −y, y' = x.
        let speed = (across * pin.0) / along - pin.1;
        let relative = (speed + pin.1, -pin.0);
        let acceleration = -(relative.0 * relative.0 + relative.1 * relative.1 + across * pin.1) / along - pin.0;
        let gas = (pressure(&tables[self.table], degrees) - AMBIENT) * self.area;
        // m s̈ = −F_gas + N_rod · (direction from pin to piston along the axis).
        let push = (self.mass * acceleration * omega * omega + gas) * self.length / along;
        let direction = (along / self.length, across / self.length);
        // The rod pushes the pin the other way: the moment of −push·direction about the shaft.
        let torque = -(pin.0 * direction.1 - pin.1 * direction.0) * push;
        // Head and wall are pushed by gas and piston, at the offset and at the piston's place; the main bearings have no lever.
        let wall = push * direction.1;
        let roll = (pin.0 + along) * wall - self.offset * gas;
        [torque, roll, -wall]
    }
}

/// A random engine: its layout, its bodies, its tables.
fn random(dice: &mut Dice) -> (String, Vec<Bodies>, Vec<Vec<f64>>, f64) {
    let four_stroke = dice.below(2) == 0;
    let cycle = if four_stroke { 720.0 } else { 360.0 };
    let count = 1 + dice.below(6) as usize;
    let tables = vec![gas_table::random(dice, cycle, 60), gas_table::random(dice, cycle, 30)];
    let other = dice.below(count as u64) as usize;
    let speed = 500 + dice.below(5000);
    let (mut cylinders, mut bodies) = (String::new(), Vec::new());
    let (mut strokes, mut rods, mut offsets, mut masses, mut fires) = (vec![], vec![], vec![], vec![], vec![]);
    for index in 0..count {
        let (throw, bank) = (dice.below(360) as i64, dice.below(360) as i64 - 180);
        cylinders += &format!("[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = {index}\n");
        let stroke = 60 + dice.below(80);
        let rod = stroke + dice.below(90);
        let offset = dice.below(21) as i64 - 10;
        let grams = dice.below(2000);
        let angle = (bank - throw).rem_euclid(360) + 360 * dice.below(2) as i64 * i64::from(four_stroke);
        strokes.push(format!("'{stroke} mm'"));
        rods.push(format!("'{rod} mm'"));
        offsets.push(format!("'{offset} mm'"));
        masses.push(format!("'{grams} g'"));
        fires.push(angle);
        bodies.push(Bodies {
            radius: stroke as f64 / 2e3,
            length: rod as f64 / 1e3,
            offset: offset as f64 / 1e3,
            mass: grams as f64 / 1e3,
            area: std::f64::consts::PI / 4.0 * 0.08 * 0.08,
            fires: angle as f64,
            table: usize::from(index == other),
        });
    }
    let fires: Vec<String> = fires.iter().map(ToString::to_string).collect();
    let text = format!(
        "cycle = '{}'\nspeed = {speed}\nfiring_angles = [{}]\n[mechanism]\nstroke = [{}]\nrod_length = [{}]\npin_offset = [{}]\n\
         reciprocating_mass = [{}]\n[gas]\nbore = '80 mm'\ndead_centre = 'crank'\nunit = 'bar'\npressure = [{}]\n\
         [[gas.cylinder]]\ncylinders = [{}]\npressure = [{}]\n{cylinders}",
        if four_stroke { "four-stroke" } else { "two-stroke" },
        fires.join(", "),
        strokes.join(", "),
        rods.join(", "),
        offsets.join(", "),
        masses.join(", "),
        gas_table::rows(&tables[0]),
        other + 1,
        gas_table::rows(&tables[1]),
    );
    (text, bodies, tables, speed as f64 / 60.0 * std::f64::consts::TAU)
}

#[test]
fn the_torque_of_a_hundred_random_engines_is_that_of_their_bodies() {
    let mut dice = Dice::new(1313);
    for _ in 0..100 {
        let (text, bodies, tables, omega) = random(&mut dice);
        let torque = torque_of(&text);
        let model = |theta: f64| -> f64 { bodies.iter().map(|body| body.moments(theta, omega, &tables)[0]).sum() };
        let rolled = |theta: f64| -> f64 { bodies.iter().map(|body| body.moments(theta, omega, &tables)[1]).sum() };
        let cycle = torque.course.period().to_degrees().round();
        let mut sums = [num_complex::Complex::new(0.0, 0.0); 9];
        let revolutions = cycle / 360.0;
        let (mut work, mut scale) = (0.0, 0.0_f64);
        let mut reached = Vec::new();
        for degree in 0..cycle as usize {
            for (point, weight) in POINTS {
                let theta = degree as f64 + point;
                let value = model(theta);
                scale = scale.max(value.abs());
                let psi = theta.to_radians();
                work += value * weight * 1_f64.to_radians();
                for (index, sum) in sums.iter_mut().enumerate() {
                    *sum += num_complex::Complex::cis(-psi * index as f64 / revolutions) * value * weight / cycle;
                }
            }
            reached.push(work - torque.mean * ((degree + 1) as f64).to_radians());
        }
        for theta in (0..60).map(|step| f64::from(step) * cycle / 60.0 + 0.123) {
            assert_near(torque.course.total(theta.to_radians()), model(theta), 1e-9 * scale);
            assert_near(torque.course.roll(theta.to_radians()).expect("one crankshaft"), rolled(theta), 1e-9 * scale);
        }
        assert_near(torque.mean, sums[0].re, 1e-9 * scale);
        for class in &torque.classes {
            // At rest there is gas alone; the first degree of its own cycle is that of its firing.
            let body = &bodies[class.cylinders[0]];
            let wall = |psi: f64| body.moments(body.fires + psi, 0.0, &tables)[2];
            let mut side = [num_complex::Complex::new(0.0, 0.0); 7];
            for psi in 0..cycle as usize {
                for (point, weight) in POINTS {
                    let psi = psi as f64 + point;
                    let value = wall(psi) * weight / cycle;
                    for (index, sum) in side.iter_mut().enumerate() {
                        *sum += num_complex::Complex::cis(-psi.to_radians() * index as f64 / revolutions) * value;
                    }
                }
            }
            let largest = class.harmonics.force.iter().map(|one| one.norm()).fold(0.0, f64::max);
            for (index, sum) in side.iter().enumerate() {
                let wanted = sum * if index == 0 { 1.0 } else { 2.0 };
                assert_near((class.harmonics.side[index] - wanted).norm(), 0.0, 1e-9 * largest);
            }
            for psi in [0.0_f64, 33.3, 211.7] {
                let at = psi.to_radians();
                let side = class.gas.force(at) * class.gas.geometry().slope(at);
                assert_near(side, wall(psi), 1e-9 * largest);
            }
        }
        for (index, sum) in sums.iter().enumerate().skip(1) {
            assert_near((torque.orders[index - 1].total() - sum * 2.0).norm(), 0.0, 1e-9 * scale);
        }
        let energy = torque.evenness.as_ref().expect("a speed").energy;
        let found = reached.iter().copied().fold(f64::NEG_INFINITY, f64::max)
            - reached.iter().copied().fold(f64::INFINITY, f64::min);
        // The model looks at whole degrees only.
        assert!(
            found <= energy * (1.0 + 1e-9) && energy <= found * (1.0 + 1e-3) + 1e-3 * scale,
            "{found} {energy}\n{text}"
        );
        let at = |theta: f64| torque.course.work(theta.to_radians());
        for degree in (10..cycle as usize).step_by(37) {
            assert_near(at(degree as f64) - at(10.0), reached[degree - 1] - reached[9], 1e-9 * scale);
        }
    }
}

#[test]
fn loops_and_series_agree_in_every_engine() {
    let mut dice = Dice::new(5);
    for _ in 0..20 {
        let (text, ..) = random(&mut dice);
        let torque = torque_of(&text);
        assert!(torque.balance < 1e-9, "{}", torque.balance);
    }
}

#[test]
fn an_order_whose_star_vanishes_is_zero_at_any_pressure() {
    let twin = |angles: &str, throws: &str| {
        let text = SPARK.replace("throws = [0]", &format!("throws = {throws}")).replace("firing_order = '1'", angles);
        torque_of(&text)
    };
    let zeros = |torque: &EngineTorque| -> Vec<String> {
        torque.orders.iter().filter(|order| order.vanishes()).take(3).map(|order| order.order.to_string()).collect()
    };
    // 360-360, and 180-540: the half order is not zero.
    assert_eq!(zeros(&twin("firing_angles = [0, 360]", "[0, 0]")), ["½", "1½", "2½"]);
    assert_eq!(zeros(&twin("firing_angles = [0, 180]", "[0, 180]")), ["1", "3", "5"]);
    // A cylinder that misfires belongs to no class of the others: nothing is proved.
    let misfire = SPARK.replace("throws = [0]", "throws = [0, 180, 180, 0]").replace("'1'", "'1-3-4-2'")
        + "[[gas.cylinder]]\ncylinders = [2]\nheat = 0\n";
    let torque = torque_of(&misfire);
    assert_eq!(torque.classes.len(), 2);
    assert_eq!(zeros(&torque), Vec::<String>::new());
    assert!(torque.orders[0].gas.norm() > 10.0, "a half order betrays it");
    // The inertia knows nothing of the misfire.
    assert!(torque.orders.iter().all(|order| order.inertia_vanishes != (order.order.halves() % 4 == 0)));
}

/// `−s′s″` of an infinitely long rod is made of sin 2ψ and cos 2ψ (theory, section 2).
#[test]
fn the_inertia_torque_of_scotch_yokes_has_order_2_alone() {
    let yoke = four(3000).replace("rod_length = '143 mm'", "scotch_yoke = true");
    for order in torque_of(&yoke).orders {
        assert_eq!(order.inertia_vanishes, order.order.halves() != 4, "{}", order.order);
    }
}

#[test]
fn what_a_layout_lacks_for_its_torque_is_told() {
    let lacks = |text: &str| torque(&engine(text)).expect_err("it lacks something").to_string();
    let firing = SPARK.replace("throws = [0]", "throws = [0, 0]").replace("firing_order = '1'\n", "");
    assert_eq!(torque(&engine(&firing)).expect_err("no order"), Missing::Firing);
    assert!(lacks(&firing).contains("firing_order = \"1-3-4-2\""));
    let (before, _) = SPARK.split_once("[gas]").expect("gas");
    assert!(lacks(before).contains("add [gas]"));
    assert!(lacks(&SPARK.replace("stroke = '86 mm'\nrod_length = '143 mm'", "rod_ratio = 0.3")).contains("stroke"));
    assert!(lacks(&SPARK.replace("rod_length = '143 mm'\n", "")).contains("rod_length"));
    let at_rest: Engine = engine(&four(3000).replace("speed = 3000", "speed = 0"));
    assert!(torque(&at_rest).expect("a torque").evenness.is_none());
    assert!(CylinderGas::new(&at_rest, 3).is_ok());
}

/// The four as a layout file whose pressures lie beside it.
fn with_table(name: &str) -> (std::path::PathBuf, std::path::PathBuf) {
    let folder = scratch(name);
    let (before, after) =
        four(3000).split_once("process").map(|(a, b)| (a.to_owned(), b.to_owned())).expect("a process");
    let (_, flywheel) = after.split_once("[flywheel]").expect("a flywheel");
    let layout = folder.join("four.toml");
    std::fs::write(&layout, format!("{before}unit = 'bar'\ntable = 'indicator.csv'\n[flywheel]{flywheel}"))
        .expect("a file");
    let gas = CylinderGas::new(&engine(SPARK), 0).expect("gas");
    let row = |half: i32| {
        format!("{},{:.5}\n", f64::from(half) / 2.0, gas.pressure((f64::from(half) / 2.0).to_radians()) / 1e5)
    };
    let csv: String = (-720..=720).map(row).collect();
    std::fs::write(folder.join("indicator.csv"), format!("angle,pressure\n{csv}")).expect("a file");
    (layout, folder)
}

#[test]
fn the_command_reads_the_table_beside_the_layout_and_writes_the_page() {
    let (layout, folder) = with_table("torque-page");
    let layout = layout.to_str().expect("a path");
    let output = call(&["torque", layout]);
    let text = String::from_utf8(output.stdout).expect("a text");
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    // Half a degree from row to row costs a part in ten thousand.
    for words in [
        "The mean is 157 N·m",
        "At 3000 rpm the gas delivers 49.2 kW",
        "For a coefficient of fluctuation of 0.02",
        "0.0616 kg·m²",
    ] {
        assert!(text.contains(words), "{words:?} in {text}");
    }
    let page = folder.join("page");
    for format in ["markdown", "latex", "html", "typst", "text"] {
        let output = call(&["torque", layout, "--format", format, "--output", page.to_str().expect("a path")]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let markdown = std::fs::read_to_string(page.join("torque.md")).expect("the page");
    for picture in ["gas-torque.svg", "pressure.svg", "loop.svg"] {
        assert!(markdown.contains(picture) && page.join(picture).is_file(), "{picture}");
    }
    let output = call(&["torque", layout, "--json"]);
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a document");
    assert_eq!(document["orders"][3]["order"], 2.0);
    assert_eq!(document["orders"][2]["gas_vanishes"], true);
    assert!(document["cycle"]["energy_balance"].as_f64().expect("a number") < 1e-9);
    std::fs::remove_file(folder.join("indicator.csv")).expect("it was there");
    let output = call(&["torque", layout]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && told.contains("indicator.csv") && told.contains("four.toml"), "{told}");
}

#[test]
fn a_sweep_reads_the_table_beside_its_layout() {
    let (layout, _) = with_table("torque-sweep");
    let output = call(&["sweep", layout.to_str().expect("a path"), "--speed", "1000..3000:1000"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn a_report_has_the_torque_only_where_it_is_asked_for() {
    let page = |effects: &str| {
        let document = crate::support::pages::document(&engine(&format!("{effects}{}", four(3000))));
        page::write(&document, Format::GITHUB, &Options::default()).remove(0).text
    };
    let (with, without) = (page("effects = ['gas']\n"), page(""));
    assert!(with.contains("# Torque of gas and inertia") && with.contains("(gas-torque.svg)"));
    assert!(!without.contains("Torque of gas") && !without.contains("gas-torque"));
}

#[test]
fn the_unevenness_of_a_machine_that_is_driven_is_in_sizes_of_its_mean() {
    let said = |layout: &str| crate::true_sentences::said("torque", layout, &[]);
    assert!(said(&four(3000)).contains("times the mean."), "{}", said(&four(3000)));
    let pump = "cycle = 'two-stroke'\nspeed = 1000\n[inline]\nthrows = [0]\n[mechanism]\nstroke = '80 mm'\nrod_length = '150 mm'\n\
        reciprocating_mass = '0.5 kg'\n[gas]\nbore = '80 mm'\nprocess = 'compressor'\nintake_pressure = '1 bar'\n\
        delivery_pressure = '8 bar'\nclearance = 0.05\n";
    let said = said(pump);
    assert!(said.contains("The mean is −") && said.contains("times the size of the mean."), "{said}");
}

#[test]
fn an_irregularity_of_a_layout_may_be_in_per_cent_of_the_mean() {
    let delta = |text: &str| {
        let engine = engine(&four(3000).replace("'1/50'", &format!("'{text}'")));
        engine.flywheel().irregularity.clone()
    };
    for text in ["2 %", "±1 %", "±1%", "± 0.01", "0.02"] {
        assert_eq!(delta(text), delta("1/50"), "{text}");
    }
}
