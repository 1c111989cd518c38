//! Does every command print its JSON, and do both checkers accept it, however finely the angles of the engine are told?
//!
//! Some engines are tried every time; `CRANKSTAR_ENGINES=2000 cargo test --test suite -- --ignored every_document_of_many`
//! tries as many as it says.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::support::dice::Dice;
use crate::support::fine::fine;
use crate::support::program::{call, scratch};
use crate::support::second::second_checker;
use crate::support::trust::{grouped, renew};
use crate::support::{engines, every_form, verdicts};
use crankstar::exact::{PhasorSum, Term};
use crankstar::numbers;

/// Documents of numbers alone, which have no certificates.
const OF_NUMBERS: [&str; 5] = ["bearings", "torque", "torsion", "angle", "sweep"];

const USUAL: usize = 6;
const MANY: usize = 1_000;

/// A folder of documents, and how many of each command there are.
struct Documents {
    folder: PathBuf,
    files: Vec<PathBuf>,
}

impl Documents {
    /// Keeps what a call prints; false where the program has no answer, which is never a fault of its own.
    fn add(&mut self, name: &str, arguments: &[&str], layout: &str) -> bool {
        let output = call(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        let about = || format!("{arguments:?}: {error}\n{}", fs::read_to_string(layout).unwrap_or_default());
        assert!(!error.contains("fault") && !error.contains("beyond the range"), "{}", about());
        if !output.status.success() {
            assert_eq!(output.status.code(), Some(1), "{}", about());
            return false;
        }
        let tree: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|why| panic!("{why} {}", about()));
        let is_proved =
            tree["format"].as_str().is_some_and(|format| !OF_NUMBERS.iter().any(|kind| format.contains(kind)));
        if is_proved {
            let path = self.folder.join(format!("{name}.json"));
            fs::write(&path, output.stdout).expect("written");
            let verified = call(&[Path::new("verify"), &path]);
            let error = String::from_utf8_lossy(&verified.stderr);
            assert!(verified.status.success(), "{error} {}", about());
            self.files.push(path);
        }
        true
    }
}

/// The layouts of number `index`: one of each maker, fine and in a file.
fn layouts(folder: &Path, index: usize) -> [String; 3] {
    let mut dice = Dice::new(index as u64);
    let form = engines::FORMS[index % (engines::FORMS.len() - 1)];
    let texts = [every_form::known(&mut dice), engines::file(&mut dice, form), whole(&mut dice)];
    let mut place = 0;
    texts.map(|text| {
        place += 1;
        let path = folder.join(format!("{index}-{place}.toml"));
        fs::write(&path, fine(&text, &mut dice)).expect("written");
        path.to_str().expect("UTF-8").to_owned()
    })
}

/// An engine of which all is known: masses, lengths, speed, bearings, firing, gas and a shaft that twists; or one with links.
fn whole(dice: &mut Dice) -> String {
    let form = match dice.below(3) {
        0 => {
            let (cylinders, rods) = (3 + dice.below(3), "[mechanism]\nrod_ratio = '1/4'\nreciprocating_mass = 0.5\n");
            return format!("radial.cylinders = {cylinders}\n{rods}[articulated]\nmaster = 1\nknuckle_ratio = '1/5'\n");
        }
        1 => format!("[vee]\nbank_angle = {}\nthrows = [0, {}]\n", 40 + dice.below(80), dice.below(360)),
        _ => format!("[inline]\nthrows = [0, {}]\n", dice.below(360)),
    };
    format!(
        "cycle = 'two-stroke'\nspeed = 3000\nbearings = ['100 mm', 0, '-100 mm']\n{form}spacing = '90 mm'\n\
         [mechanism]\nstroke = '90 mm'\nrod_length = '150 mm'\nreciprocating_mass = '0.5 kg'\n\
         [gas]\nbore = '85 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 10\nmean_pressure = '10 bar'\nintake_pressure = '1 bar'\n\
         [torsion]\ninertias = [0.03, 0.03, 0.3]\nstiffnesses = ['1 MN m/rad', '1 MN m/rad']\n"
    )
}

fn tried(folder: &str, numbers: std::ops::Range<usize>) -> usize {
    let folder = scratch(folder);
    let mut documents = Documents { folder: folder.clone(), files: Vec::new() };
    let mut answered = std::collections::BTreeMap::<&str, usize>::new();
    let asked = numbers.end - numbers.start;
    for index in numbers {
        for (place, layout) in layouts(&folder, index).iter().enumerate() {
            let written = folder.join(format!("cured-{index}-{place}.toml"));
            let written = written.to_str().expect("UTF-8");
            let mut ask = |name: &'static str, arguments: &[&str]| {
                let told = documents.add(&format!("{name}-{index}-{place}"), arguments, layout);
                *answered.entry(name).or_default() += usize::from(told);
                told
            };
            ask("classify", &["classify", layout, "--json", "--orders", "1,2,3,4,6"]);
            ask("torque-of-inertia", &["classify", layout, "--json", "--torque"]);
            ask("every", &["classify", layout, "--json", "--all-orders"]);
            ask("firing", &["classify", layout, "--json", "--firing"]);
            ask("loads", &["loads", layout, "--json"]);
            ask("compare", &["compare", layout, "I4", "--json"]);
            if ask("remedy", &["remedy", layout, "--json", "--write", written]) {
                ask("cured", &["classify", written, "--json"]);
                ask("cured-loads", &["loads", written, "--json"]);
            }
            for question in ["bearings", "torque", "torsion", "angle"] {
                ask(question, &[question, layout, "--json"]);
            }
            ask("sweep", &["sweep", layout, "--speed=1000..2000:500", "--format=json"]);
        }
    }
    println!("{answered:?}, {} documents", documents.files.len());
    for (name, least) in [("classify", asked), ("torque-of-inertia", asked), ("compare", asked), ("remedy", asked / 2)]
    {
        assert!(answered[name] >= least, "{name} is answered for {} engines", answered[name]);
    }
    assert!(answered.values().all(|&count| count > 0), "{answered:?}");
    if let Some((told, code)) = second_checker(&documents.files) {
        let fails: Vec<&str> =
            told.lines().filter(|line| !line.starts_with(' ') && !line.contains(": verified, ")).collect();
        assert!(fails.is_empty() && code == 0, "{code} {fails:#?}");
    }
    documents.files.len()
}

#[test]
fn every_document_of_finely_told_engines_is_printed_and_accepted_by_both_checkers() {
    assert!(tried("every-json", 0..USUAL) > 10 * USUAL);
}

#[test]
#[ignore = "an hour"]
fn every_document_of_many_finely_told_engines_is_printed_and_accepted_by_both_checkers() {
    let count = std::env::var("CRANKSTAR_ENGINES").map_or(MANY, |count| count.parse().expect("a number of engines"));
    let documents: usize =
        (0..count).step_by(50).map(|first| tried("every-json-many", first..count.min(first + 50))).sum();
    let page = format!(
        "# Documents of engines in every detail\n\n\
         {} engines of every form, pseudo-random and the same every time, whose angles are written with 1 to 12 decimals or over large primes. Each was asked \
         `classify` (`--torque`, `--all-orders`, `--firing`), `loads`, `compare`, `remedy` with the file that it writes asked again, `bearings`, `torque`, \
         `torsion` and `sweep`, with `--json`. Each document is printed, and the {} with certificates are accepted by `crankstar verify` and by \
         `formal/verify.py`.\n\n\
         `CRANKSTAR_RENEW=1 CRANKSTAR_ENGINES={count} cargo test --test suite -- --ignored every_document_of_many` writes this page anew.\n",
        grouped(3 * count),
        grouped(documents),
    );
    renew("documents.md", &page);
}

#[test]
fn a_path_of_classes_is_no_length() {
    let folder = scratch("path-of-classes");
    let file = folder.join("two.toml");
    fs::write(&file, "inline.throws = [0, 149.12345]\nmechanism.rod_ratio = 0.25\n").expect("written");
    let large = Path::new(env!("CARGO_MANIFEST_DIR")).join("formal/engines/large-denominator.toml");
    let mut documents = Documents { folder, files: Vec::new() };
    for layout in [&file, &large].map(|path| path.to_str().expect("UTF-8")) {
        for command in [&["classify", layout, "--json"][..], &["compare", layout, "I4", "--json"]] {
            assert!(documents.add("one", command, layout));
            let text = fs::read_to_string(documents.files.last().expect("a document")).expect("text");
            assert!(text.contains("\"class\""), "a path of classes proves something here");
        }
    }
    let two = file.to_str().expect("UTF-8");
    assert!(documents.add("loads", &["loads", two, "--json"], two));
}

#[test]
fn a_length_beyond_the_decimals_is_no_number_and_makes_no_document() {
    let power = |exponent: i32| num_rational::BigRational::from_integer(10.into()).pow(exponent);
    let length = |weight| {
        numbers::length_of(&PhasorSum::new(vec![Term { angle: crankstar::exact::Turn::fraction(1, 7), weight }]))
    };
    assert!((length(power(-300)) / 1e-300 - 1.0).abs() < 1e-12);
    assert!(length(power(309)).is_nan() && length(power(-309)).is_nan());
    let engine = crankstar::file::parse("engine", "inline.throws = [0]").expect("a layout");
    let mut document = verdicts::document(&engine, &verdicts::judged(&engine, &[1], false), false, None);
    assert!(serde_json::to_string(&document).is_ok());
    document.verdicts[0].modulus = length(power(309));
    let error = serde_json::to_string(&document).expect_err("it has no decimal");
    assert!(error.to_string().starts_with("a length is beyond the range of decimals"), "{error}");
}
