//! Does the page of the loads stand in every format, say what the JSON document says, and say no more than is known?

use std::fs;
use std::path::{Path, PathBuf};

use crankstar::engine::Engine;
use crankstar::file::{self, Layout, parse};
use crankstar::loads::usual_orders;
use crankstar::page::{Block, Document, Format};
use crankstar::report::{self, Numbers};

use crate::support::pages;
use crate::support::program::{call, scratch};

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The engines of the layout files that have rods: examples, and what is odd.
fn engines() -> Vec<Engine> {
    let folders = ["reports/examples", "tests/pages"].map(|folder| fs::read_dir(project(folder)).expect("a folder"));
    let files = folders.into_iter().flatten().map(|entry| entry.expect("an entry").path());
    let files = files.map(|path| if path.is_dir() { path.join("layout.toml") } else { path });
    let layouts = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let engine = |path| match file::parse_layout("layout.toml", &fs::read_to_string(path).expect("a text")) {
        Ok(Layout::Known(engine, _)) => Some(*engine),
        Ok(Layout::Open(_)) | Err(_) => None,
    };
    layouts.filter_map(engine).filter(|engine| engine.rods().next().is_some()).collect()
}

fn numbers(engine: &Engine, orders: &[u32]) -> Numbers {
    Numbers::new(engine, orders, None).unwrap_or_else(|missing| panic!("{missing}"))
}

fn page(engine: &Engine) -> (Document, serde_json::Value) {
    let numbers = numbers(engine, &usual_orders(engine));
    let document = serde_json::to_value(report::loads_document(engine, &numbers, None)).expect("a document");
    (report::loads_page(engine, &numbers, None), document)
}

fn page_text(text: &str) -> String {
    let engine = parse("loads.toml", text).unwrap_or_else(|error| panic!("{error}"));
    pages::text(&page(&engine).0, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The decimal that a text begins with, after ≈.
fn decimal(text: &str) -> f64 {
    let number = text.trim_start_matches(['≈', ' ', '\u{a0}']).split([' ', '\u{a0}', '°']).next().unwrap_or_default();
    let (digits, power) = number.split_once("·10").unwrap_or((number, ""));
    let power: String = power
        .chars()
        .map(|sign| "⁻-⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9".chars().skip_while(|c| *c != sign).nth(1).unwrap_or(sign))
        .collect();
    let digits: f64 = digits.replace('−', "-").parse().unwrap_or_else(|_| panic!("no number in {text:?}"));
    digits * 10_f64.powi(if power.is_empty() { 0 } else { power.parse().expect("a power") })
}

/// Newtons, or newton metres, of the unit behind a number; multiples of m r ω² are counted as they are.
fn size_of(text: &str) -> f64 {
    let unit = text.trim_start_matches(['≈', ' ', '\u{a0}']).split([' ', '\u{a0}']).nth(1).unwrap_or_default();
    match unit {
        unit if unit.starts_with("kN") => 1e3,
        unit if unit.starts_with("MN") => 1e6,
        _ => 1.0,
    }
}

fn assert_near(shown: f64, known: f64, part: f64, what: &str) {
    assert!(
        (shown - known).abs() <= part * known.abs() + 1e-12,
        "{what}: {shown} on the page, {known} in the document"
    );
}

#[test]
fn the_page_is_written_in_every_format() {
    let layout = project("reports/examples/v8-small-block/layout.toml");
    let formats = [("markdown", "md"), ("latex", "tex"), ("html", "html"), ("typst", "typ"), ("text", "txt")];
    for (format, ending) in formats {
        let folder = scratch(&format!("loads-page-{format}"));
        let paths = [layout.to_str(), folder.to_str()].map(|path| path.expect("a path in UTF-8"));
        let output = call(&["loads", paths[0], "--format", format, "--output", paths[1], "--stamp"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let page = fs::read_to_string(folder.join(format!("loads.{ending}"))).expect("a page");
        for words in ["forces, moments and torque", "5500", "Conventions", env!("CARGO_PKG_VERSION")] {
            assert!(page.contains(words), "{format} lacks {words}");
        }
        let pictures = fs::read_dir(&folder).expect("a folder").count() - 1;
        assert_eq!(pictures > 0, ["markdown", "typst"].contains(&format), "{format}: {pictures} pictures");
    }
    let both = call(&["loads", "I4", "--json", "--output", "somewhere"]);
    assert_eq!(both.status.code(), Some(2), "JSON is printed, a page is written");
}

#[test]
fn the_page_speaks_german() {
    let layout = project("reports/examples/i6-offset/layout.toml");
    let folder = scratch("loads-page-german");
    let paths = [layout.to_str(), folder.to_str()].map(|path| path.expect("a path in UTF-8"));
    let output = call(&["loads", paths[0], "--lang", "de", "--format", "html", "--output", paths[1]]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = fs::read_to_string(folder.join("loads.html")).expect("a page");
    assert!(page.contains("<html lang=\"de\">") && page.contains("Größte Kraft"), "{page}");
}

#[test]
fn the_numbers_on_the_page_are_those_of_the_document() {
    let engines = engines();
    assert!(engines.len() > 8, "{}", engines.len());
    for engine in engines {
        let (page, document) = page(&engine);
        let text = pages::text(&page, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
        let named = [
            ("force", "Largest force: "),
            ("moment", "Largest moment: "),
            ("inertia_torque", "Largest inertia torque: "),
        ];
        for (key, words) in named {
            let entry = &document["largest"][key];
            let Some(shown) = text.split(words).nth(1) else {
                assert!(entry.is_null(), "{key} is not on the page");
                continue;
            };
            let known = entry["value"].as_f64().expect("a value");
            match entry["error_bound"].as_f64().expect("a bound") {
                _ if known == 0.0 => assert!(shown.starts_with("0, at every order, proved."), "{shown}"),
                // Between nothing and twice the middle.
                bound if bound == known => assert!(shown.starts_with("below"), "{shown}"),
                _ => assert_near(decimal(shown) * size_of(shown), known, 1e-5, words),
            }
        }
        for (key, words) in
            [("force", "The force of the listed orders is "), ("moment", "The moment of the listed orders is ")]
        {
            let Some(shown) = text.split(words).nth(1) else { continue };
            let peak = document["peaks"][key]["value"].as_f64().expect("a value");
            if peak > 0.0 {
                assert_near(decimal(shown) * size_of(shown), peak, 1e-5, words);
            }
        }
        by_order(&engine, &page, &document);
    }
}

/// The first table, and that of the ellipses.
fn by_order(engine: &Engine, page: &Document, document: &serde_json::Value) {
    let tables = pages::tables(page);
    let entries = document["orders"].as_array().expect("orders");
    let of = |order: &str, quantity: &str| {
        let is_meant =
            |entry: &&serde_json::Value| entry["order"].as_u64() == order.parse().ok() && entry["quantity"] == quantity;
        entries.iter().find(is_meant).expect("an entry")
    };
    let mut compared = 0;
    // Thousands of newtons are kN on the page.
    let tables_of = |page: &Document| {
        page.blocks
            .iter()
            .filter_map(|block| if let Block::Table(table) = block { Some(table.clone()) } else { None })
            .collect::<Vec<_>>()
    };
    let header: Vec<String> = tables_of(page)[0].header.iter().map(|cell| cell.plain()).collect();
    let size_of = |quantity: &str| {
        let place = if quantity == "force" { 1 } else { 2 };
        let prefix = header[place].split(" in ").nth(1).and_then(|unit| unit.chars().next());
        match prefix {
            Some('k') => 1e3,
            Some('M') => 1e6,
            _ => 1.0,
        }
    };
    let mut compare = |cell: &str, entry: &serde_json::Value, key: &str| {
        let size = if key == "dimensionless" { 1.0 } else { size_of(entry["quantity"].as_str().expect("a word")) };
        let known = entry[key].as_f64().expect("a value") / size;
        match cell {
            "0" => assert_eq!(known, 0.0, "{cell} {entry}"),
            "≈ 0" => assert!(known.abs() < 1e-6, "{cell} {entry}"),
            cell if cell.starts_with('≈') => assert_near(decimal(cell), known, 5e-3, &entry.to_string()),
            cell => assert!(
                ["does not exist", "not decided", "–"].contains(&cell) || cell.starts_with("not decided"),
                "{cell}"
            ),
        }
        compared += 1;
    };
    for row in &tables[1] {
        let entry = of(&row[0], &row[1]);
        for (place, key) in [(2, "largest"), (3, "smallest"), (5, "along"), (6, "across"), (7, "dimensionless")] {
            compare(&row[place], entry, key);
        }
    }
    for row in &tables[0] {
        for (place, quantity) in [(1, "force"), (2, "moment")] {
            // A row of the torque alone has no force and no moment.
            if entries.iter().any(|entry| entry["order"].as_u64() == row[0].parse().ok()) {
                compare(&row[place], of(&row[0], quantity), "largest");
            } else {
                assert!(["not computed", "does not exist"].contains(&row[place].as_str()), "{row:?}");
            }
        }
    }
    assert!(compared >= 12, "{}", engine.title().written());
}

#[test]
fn the_direction_of_the_largest_force_is_where_the_vector_points() {
    for engine in engines() {
        let (page, _) = page(&engine);
        let text = pages::text(&page, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
        let loads = numbers(&engine, &usual_orders(&engine)).loads;
        for (waveform, words) in
            [(&loads.force, "The force of the listed orders"), (&loads.moment, "The moment of the listed orders")]
        {
            let Some(sentence) = text.split(words).nth(1) else { continue };
            let sentence = sentence.split(" there.").next().expect("a sentence");
            let Some((before, direction)) = sentence.split_once(" and points to ") else { continue };
            let theta = decimal(before.split("θ ").nth(1).expect("a crank angle"));
            let there = waveform.at(theta.to_radians());
            let off = (there.arg().to_degrees() - decimal(direction)).rem_euclid(360.0);
            // θ has six digits, and a vector of order k turns k times as fast.
            assert!(off.min(360.0 - off) < 0.05, "{}: {sentence}", engine.title().written());
        }
    }
}

#[test]
fn without_numbers_the_page_counts_in_multiples_and_at_rest_in_zeros() {
    let bare = page_text("inline = { throws = [0, 180, 180, 0] }\nmechanism = { rod_ratio = 0.25 }");
    assert!(bare.contains(
        "forces in m r ω², moments in m r ω² a: the layout does not give mass, crank radius and speed together."
    ));
    assert!(bare.contains("Largest moment: 0, at every order, proved.") && !bare.contains("rpm"), "{bare}");
    let still = page_text(
        "speed = 0\neffects = [\"torque\"]\ninline = { throws = [0, 90], spacing = \"0.1 m\" }\n\
         mechanism = { crank_radius = 0.05, rod_ratio = 0.25, reciprocating_mass = 1 }",
    );
    assert!(still.contains("at 0 rpm, where m r ω² is 0 N.") && still.contains("Largest force: 0."), "{still}");
    assert!(!still.contains("points to"), "nothing points anywhere at rest");
}

#[test]
fn what_is_not_decided_is_not_drawn_and_points_nowhere() {
    let less = format!("0.24{}", "9".repeat(58));
    let text = format!(
        "orders = [2]\ninline = {{ throws = [0, 0, 90, 90], spacing = 1 }}\n\
         mechanism = {{ rod_ratio = [0.25, 0.25, \"{less}\", \"{less}\"], reciprocating_mass = 1 }}"
    );
    let engine = parse("undecided.toml", &text).expect("an engine");
    let numbers = numbers(&engine, &[2]);
    let page = report::loads_page(&engine, &numbers, None);
    assert!(page.pictures().iter().all(|picture| !picture.name.starts_with("force")));
    let text = pages::text(&page, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("not decided, below") && !text.contains("The force of the listed orders"), "{text}");
}

/// Two crankshafts: the page shows the roll moment that the document has, order by order, in the units of the reader.
#[test]
fn the_roll_moment_of_several_crankshafts_is_on_the_page_as_in_the_document() {
    use crankstar::page::{self, Options, Units};
    let text = "speed = '6000 rpm'\neffects = ['torque']\n[square_four]\nin_phase = 'sides'\nsense = 'with'\ndistance = '120 mm'\nspacing = '0.1 m'\n\
                [mechanism]\nreciprocating_mass = '0.6 kg'\ncrank_radius = '40 mm'\nrod_ratio = 0.25\n";
    let engine = parse("layout.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let (document, json) = page(&engine);
    let orders = json["roll"].as_array().expect("a roll moment");
    assert!(!orders.is_empty());
    let written = |units| {
        let options = Options { units, ..Options::default() };
        let text = page::write(&document, Format::PLAIN, &options)[0].text.clone();
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let (si, inch) = (written(Units::Si), written(Units::Inch));
    for words in ["Orders of the roll moment", "The roll moment is that on the frame about the origin of the layout"] {
        assert!(si.contains(words) && inch.contains(words), "{words}: {si}");
    }
    let numbers = numbers(&engine, &usual_orders(&engine));
    let roll = numbers.loads.roll.as_ref().expect("a roll moment");
    let scale = numbers.loads.scale.as_ref().expect("a scale").torque();
    let mut left = 0;
    for order in roll.orders.iter().filter(|order| order.vector.value.norm() > 0.0) {
        let size = order.vector.value.norm() * scale;
        let shown = |size: f64| format!("≈\u{a0}{}", four_digits(size));
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(si.contains(&plain(&shown(size))), "order {}: {} in {si}", order.order, shown(size));
        assert!(inch.contains(&plain(&shown(size / 1.3558179483314004))), "order {} in {inch}", order.order);
        left += 1;
    }
    assert!(left >= 2, "{left}");
    let answer = report::loads_answer(&engine, &numbers, None, None);
    let answer = page::write(&answer, Format::PLAIN, &Options::default())[0].text.clone();
    assert!(answer.contains("Roll in N·m"), "{answer}");
}

/// Four digits, as tables have them.
fn four_digits(value: f64) -> String {
    match value {
        size if size >= 999.95 => format!("{size:.0}"),
        size if size >= 99.995 => format!("{size:.1}"),
        size if size >= 9.9995 => format!("{size:.2}"),
        size if size >= 0.99995 => format!("{size:.3}"),
        size => format!("{size:.4}"),
    }
}
