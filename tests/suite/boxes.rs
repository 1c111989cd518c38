//! Does the box that a page opens with say what matters in a few lines, of every engine?

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::loads::usual_orders;
use crankstar::page::Block;
use crankstar::report::{self, Weighing};
use crankstar::verdict::{self, Judgement};
use num_rational::BigRational;

/// The engines of the catalogue, and those of the world, by their names.
fn engines() -> BTreeMap<String, Engine> {
    let catalogue = file::catalogue().expect("the catalogue").into_iter();
    let catalogue = catalogue.map(|(entry, engine)| (entry.name.to_owned(), engine));
    let world = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/engines");
    let folders = fs::read_dir(world).expect("engines").map(|entry| entry.expect("an entry").path());
    let world = folders.filter(|path| path.is_dir()).map(|path| {
        let text = fs::read_to_string(path.join("engine.toml")).expect("a layout");
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let engine = file::parse("engine.toml", &text).unwrap_or_else(|error| panic!("{name}: {error}"));
        (name, engine)
    });
    catalogue.chain(world).collect()
}

fn judged(engine: &Engine) -> Judgement {
    Judgement::new(engine, &usual_orders(engine), &verdict::quantities(engine, false)).expect("orders")
}

fn lines(engine: &Engine, weighing: &Weighing) -> Vec<String> {
    let judged = judged(engine);
    let block = match weighing == Weighing::usual() {
        true => report::engine_summary(engine, &judged),
        false => report::engine_answer_weighed(engine, &judged, weighing).blocks.swap_remove(0),
    };
    let Block::Answer(lines) = block else { panic!("no box") };
    lines.iter().map(|line| line.plain()).collect()
}

/// Words and numbers: a unit belongs to its number, and signs alone are no words.
fn words(lines: &[String]) -> usize {
    let units = [" m r ω² a", " m r² ω²", " m r ω²", " m r"];
    let plain = |line: &String| units.iter().fold(line.replace('\u{202f}', " "), |line, unit| line.replace(unit, ""));
    let is_word = |token: &&str| token.chars().any(char::is_alphanumeric);
    lines.iter().map(|line| plain(line).split_whitespace().filter(is_word).count()).sum()
}

#[test]
fn every_box_has_five_lines_and_few_words() {
    let engines = engines();
    assert!(engines.len() >= 114, "{}", engines.len());
    let mut counts: Vec<(usize, String)> = Vec::new();
    for (name, engine) in &engines {
        let lines = lines(engine, Weighing::usual());
        assert!(lines.len() <= 5, "{name}: {lines:#?}");
        counts.push((words(&lines), format!("{name}: {lines:#?}")));
    }
    counts.sort();

    let (median, most) = (counts[counts.len() / 2].0, counts.last().expect("engines"));
    assert!(median <= 70 && most.0 <= 105, "median {median}, at most {}: {}", most.0, most.1);
}

fn box_of(name: &str, weighing: &Weighing) -> String {
    lines(&file::find(name).expect("an engine").engine().expect("it reads"), weighing).join("\n")
}

/// The force of order 2 has two vectors of one length, and its moment none that turns with the crank.
#[test]
fn two_shafts_are_each_of_one_size_only_where_they_are() {
    let one = |throw: u32, bank: u32, position: i32| {
        format!(
            "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{position} mm'\nreciprocating_mass = '0.5 kg'\n"
        )
    };
    let banks = |throw, position| [0, 120, 240].map(|bank| one(throw, bank, position)).concat();
    let text = "speed = 3000\n[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\n".to_owned()
        + &banks(0, 100)
        + &banks(90, -100)
        + &one(0, 0, 0);
    let told = lines(&file::parse("seven.toml", &text).expect("it reads"), Weighing::usual()).join("\n");
    assert!(!told.contains("one each way (each") && told.contains("2.55\u{202f}kg·mm + 1.82\u{202f}kg·mm"), "{told}");
    let vee = "mechanism.rod_ratio = 0.25\nvee = { bank_angle = 70, throws = [0] }\norders = [10]";
    let told =
        lines(&file::parse("vee.toml", vee).expect("it reads"), &Weighing { all: true, ..Weighing::usual().clone() });
    assert!(!told.join("\n").contains("(each"), "{told:?}");
}

/// The first-order vectors of a crankshaft that turns twice as fast are of order 2: rods that nobody gave decide what they leave of it.
#[test]
fn a_part_of_the_largest_is_one_of_a_size_that_is_shown() {
    let text = "[[crankshaft]]\nname = 'A'\nsense = 'with'\noffset = -2\n[[crankshaft]]\nname = 'B'\nsense = 'with'\noffset = 2\nspeed = 2\n\
        [[cylinder]]\ncrankshaft = 'A'\nthrow = 270\nbank = 40.24902\nposition = 0\n\
        [[cylinder]]\ncrankshaft = 'B'\nthrow = 137\nbank = 0\nposition = 0\n";
    let engine = file::parse("two.toml", text).expect("it reads");
    let told = lines(&engine, Weighing::usual()).join("\n");
    assert!(told.contains("(order 1)") && told.contains("Not decided: whether orders 2, 4 vanish."), "{told}");
    // Order 1 is m r ω² of one piston; of orders 4 and above the first piston alone has 2.5 %.
    let part = told.split("Together at most ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a bound");
    assert!(part.parse::<f64>().expect("percent") > 2.5, "{told}");
}

#[test]
fn small_orders_are_told_together_and_large_ones_by_their_names() {
    let usual = box_of("I4", Weighing::usual());
    assert!(usual.contains("Vertical force: 1.17\u{202f}m r ω² (order 2), 0.0248\u{202f}m r ω² (order 4)."), "{usual}");
    assert!(usual.contains("Order 6 and all others. Together at most 0.053 % of the largest force."), "{usual}");
    assert!(
        usual.contains("two shafts at twice crank speed, one each way (each 0.146\u{202f}m r), leave nothing"),
        "{usual}"
    );
    // The threshold moves order 4 to the others.
    let coarse = box_of("I4", &Weighing { above: Some(0.05), ..Weighing::usual().clone() });
    assert!(
        !coarse.contains("(order 4)") && coarse.contains("Orders 4, 6 and all others. Together at most 2.2 %"),
        "{coarse}"
    );
    let written =
        file::parse("i4.toml", "title = 'Four'\nabove = 5\n[inline]\nthrows = [0, 180, 180, 0]").expect("it reads");
    let told = |weighing: &Weighing| lines(&written, weighing).join("\n");
    assert!(told(Weighing::usual()).contains("Orders 4, 6 and all others. Together at most 2.2 %"));
    let finer = Weighing { above: Some(0.01), ..Weighing::usual().clone() };
    assert!(told(&finer).contains("(order 4)"), "what is asked for goes first");
    // All are told, and cured, where that is asked for.
    let all = box_of("I4", &Weighing { all: true, ..Weighing::usual().clone() });
    assert!(all.contains("(order 6)") && all.contains("Order 6: two shafts at six times crank speed"), "{all}");
    // Orders that were asked for are told, however small, but no shaft is proposed for them.
    let asked = box_of("I4", &Weighing { asked: true, ..Weighing::usual().clone() });
    assert!(asked.contains("(order 6)") && !asked.contains("six times"), "{asked}");
}

#[test]
fn a_master_rod_needs_one_shaft_at_twice_crank_speed() {
    let radial = box_of("radial-9-master", Weighing::usual());
    assert!(
        radial.contains("Order 2: a shaft at twice crank speed with the crank (0.193\u{202f}m r) leaves 0.1 %."),
        "{radial}"
    );
}

/// The second order of an in-line four is proportional to `c_2`, which is λ + λ³/4 + 15 λ⁵/128 + ….
#[test]
fn sizes_are_those_of_the_rods_that_are_assumed() {
    for (ratio, c2) in [((1, 4), 0.254_021), ((2, 7), 0.291_775_3)] {
        let rod_ratio = Some(BigRational::new(ratio.0.into(), ratio.1.into()));
        let told = box_of("I4", &Weighing { rod_ratio, ..Weighing::usual().clone() });
        let size = format!("Vertical force: {:.2}\u{202f}m r ω² (order 2)", 4.0 * c2);
        assert!(
            told.contains(&size) && told.contains(&format!("λ = {}", if ratio.0 == 1 { "0.25" } else { "2/7" })),
            "{told}"
        );
    }
}

#[test]
fn a_box_names_the_speed_and_books_are_told_from_the_whole_series() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/thesis/i3.toml")).expect("a layout");
    let engine = file::parse("i3.toml", &text).expect("it reads");
    let told = lines(&engine, Weighing::usual());
    assert!(
        told[0].starts_with("What shakes (at 6000 rpm). Pitching and yawing couple: 3539\u{202f}N·m (order 1)."),
        "{told:#?}"
    );
    let notes: Vec<String> = report::engine_answer(&engine, &judged(&engine))
        .blocks
        .iter()
        .filter_map(|block| if let Block::Note(words) = block { Some(words.plain()) } else { None })
        .collect();
    assert!(notes.iter().any(|note| note.contains("give 500\u{202f}N·m at order 2: 1.58 % less")), "{notes:#?}");
}
