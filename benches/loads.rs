//! What does one evaluation of forces and moments cost, what does each effect of the scene add, and what does NumPy take?
//!
//! `cargo bench -p benches --bench loads`. The V8 has unequal masses, so that no order of force or moment vanishes and none is saved: the worst case.
//! One evaluation is force and moment at 720 crank angles in orders 1, 2, 4 and 6. The same sum in plain NumPy (`v8.py`) is timed
//! first, if there is a `python3` with numpy.
#![allow(clippy::disallowed_types)]

use std::process::Command;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::loads::{self, Circle, Loads, Waveform};
use divan::{Bencher, black_box};

fn main() {
    let loads = computed(SCENES[0]);
    println!("{}\n", numpy(&loads).unwrap_or_else(|reason| format!("plain NumPy is not timed: {reason}")));
    divan::main();
}

const ORDERS: [u32; 4] = [1, 2, 4, 6];
const ANGLES: usize = 720;

/// What is in the scene, and the lines that call for it.
const SCENES: [Scene; 4] = [
    Scene { name: "reciprocating", effects: "", masses: "" },
    Scene { name: "reciprocating, rotating", effects: "", masses: "rotating_mass = 0.4" },
    Scene { name: "reciprocating, torque", effects: "effects = [\"torque\"]", masses: "" },
    Scene { name: "reciprocating, rotating, torque", effects: "effects = [\"torque\"]", masses: "rotating_mass = 0.4" },
];

#[derive(Clone, Copy)]
struct Scene {
    name: &'static str,
    effects: &'static str,
    masses: &'static str,
}

impl std::fmt::Display for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

fn v8(Scene { effects, masses, .. }: Scene) -> Engine {
    let text = format!(
        "speed = 6000\n{effects}\n\
         [vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\nspacing = \"0.12 m\"\nbank_offset = \"16 mm\"\n\
         [mechanism]\ncrank_radius = \"45 mm\"\nrod_ratio = 0.25\n{masses}\n\
         reciprocating_mass = [0.65, 0.66, 0.64, 0.65, 0.63, 0.67, 0.65, 0.66]\n"
    );
    file::parse("v8.toml", &text).expect("it reads")
}

fn computed(scene: Scene) -> Loads {
    let loads = loads::loads(&v8(scene), &ORDERS).expect("numbers");
    assert_eq!([loads.force.harmonics().len(), loads.moment.harmonics().len()], [ORDERS.len(); 2]);
    loads
}

/// The waveforms that a scene calls for.
fn waveforms(loads: &Loads) -> Vec<&Waveform> {
    [&loads.force, &loads.moment].into_iter().chain(loads.torque.as_ref().map(|torque| &torque.waveform)).collect()
}

/// Runs the script, and compares its largest force and moment with those of the program.
fn numpy(loads: &Loads) -> Result<String, String> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/v8.py");
    let vectors = waveforms(loads).into_iter().flat_map(|waveform| waveform.harmonics());
    let numbers = vectors.flat_map(|h| [h.direct.re, h.direct.im, h.reverse.re, h.reverse.im].map(|x| x.to_string()));
    let output =
        Command::new("python3").arg(script).args(numbers).output().map_err(|error| format!("python3: {error}"))?;
    if !output.status.success() {
        let errors = String::from_utf8_lossy(&output.stderr);
        return Err(errors.lines().last().unwrap_or("python3 fails").to_owned());
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|number| number.parse().ok()).collect();
    let [ready, angles, force, moment] = numbers[..] else { return Err(format!("it prints {text}")) };
    let circle = Circle::new(ANGLES);
    for (waveform, theirs) in waveforms(loads).into_iter().zip([force, moment]) {
        let ours = waveform.sample(&circle).iter().map(|value| value.norm()).fold(0.0, f64::max);
        assert!((ours - theirs).abs() < 1e-12 * ours, "NumPy finds {theirs}, the program {ours}");
    }
    Ok(format!(
        "plain NumPy, force and moment of the V8 at {ANGLES} angles, median: {ready:.1} µs with e^{{ikθ}} at hand, {angles:.1} µs without"
    ))
}

#[divan::bench]
fn a_force_and_moment_at_720_angles(bencher: Bencher) {
    let (loads, circle) = (computed(SCENES[0]), Circle::new(ANGLES));
    // What is found is dropped at once, as in NumPy: memory that is kept costs as much as the sums.
    bencher.bench_local(|| {
        [&loads.force, &loads.moment].map(|waveform| black_box(black_box(waveform).sample(&circle)).len())
    });
}

#[divan::bench]
fn b_the_same_with_its_sines_and_cosines(bencher: Bencher) {
    let loads = computed(SCENES[0]);
    bencher.bench_local(|| {
        let circle = Circle::new(black_box(ANGLES));
        [&loads.force, &loads.moment].map(|waveform| black_box(waveform.sample(&circle)).len())
    });
}

#[divan::bench(args = SCENES)]
fn c_all_waveforms_of_a_scene(bencher: Bencher, scene: Scene) {
    let (loads, circle) = (computed(scene), Circle::new(ANGLES));
    let waveforms = waveforms(&loads);
    bencher.bench_local(|| waveforms.iter().map(|waveform| black_box(waveform).sample(&circle).len()).sum::<usize>());
}

#[divan::bench(args = SCENES)]
fn d_exact_sums_and_coefficients_of_a_scene(bencher: Bencher, scene: Scene) {
    let layout = v8(scene);
    bencher.bench_local(|| loads::loads(black_box(&layout), &ORDERS).expect("numbers").coefficients);
}

#[divan::bench]
fn e_peaks_of_force_and_moment(bencher: Bencher) {
    let loads = computed(SCENES[0]);
    bencher.bench_local(|| [black_box(&loads).force.peak(), loads.moment.peak()]);
}
