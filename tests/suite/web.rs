//! Does the page get what the program says, at the right places, whatever it asks?

use crankstar::exact::Turn;
use crankstar::file::{self, Key, Layout, Template, with_value};
use crankstar::proof::Quantity;
use crankstar::verdict::Judgement;
use crankstar::web::answer;
use serde_json::{Value, json};

use crate::support::dice::Dice;
use crate::support::program::call;

fn asked(question: Value) -> Value {
    serde_json::from_str(&answer(&question.to_string())).expect("an answer is JSON")
}

fn good(question: Value) -> Value {
    let mut answer = asked(question.clone());
    assert!(answer["mistake"].is_null(), "{question}: {answer}");
    answer["ok"].take()
}

/// What the program prints.
fn printed(arguments: &[&str]) -> String {
    String::from_utf8(call(arguments).stdout).expect("a text")
}

fn texts(value: &Value) -> Vec<(String, String)> {
    let text = |value: &Value| value.as_str().expect("a text").to_owned();
    let both = |one: &Value| (text(&one["name"]), text(&one["text"]));
    value.as_array().expect("a list").iter().map(both).collect()
}

#[test]
fn the_catalogue_of_the_page_is_that_of_the_program_and_all_can_be_looked_at() {
    let known = good(json!({ "ask": "catalogue" }));
    let names: Vec<String> = texts(&known["engines"]).into_iter().map(|(name, _)| name).collect();
    let own: Vec<&str> = file::catalogue().expect("the catalogue").iter().map(|(entry, _)| entry.name).collect();
    assert_eq!(names, own);
    for (name, text) in texts(&known["starters"]) {
        good(json!({ "ask": "look", "name": name, "text": text }));
    }
    // What is proposed as a claim is read as one.
    let begin = good(json!({ "ask": "begin" }));
    for claim in begin["claims"].as_array().expect("claims") {
        good(json!({ "ask": "claim", "name": "x", "text": "inline.throws = [0, 180]", "says": claim }));
    }
}

#[test]
fn the_first_verdicts_are_those_that_stand_beside_the_engine_in_motion() {
    let open = "[vee]\nbank_angle = \"phi\"\nthrows = [0]\n";
    for text in [file::find("V8-crossplane").expect("an engine of the catalogue").text, open] {
        let first = good(json!({ "ask": "verdicts", "name": "mine", "text": text }));
        let look = good(json!({ "ask": "look", "name": "mine", "text": text }));
        let first = first.as_object().expect("words");
        assert_eq!(first.keys().collect::<Vec<_>>(), ["spoken", "summary", "title", "verdicts"]);
        assert!(first.iter().all(|(key, words)| look[key] == *words), "{text}");
    }
}

#[test]
fn an_engine_is_found_by_its_name_in_upper_or_lower_case() {
    for (entry, _) in file::catalogue().expect("the catalogue") {
        let found = good(json!({ "ask": "engine", "name": entry.name.to_uppercase() }));
        assert_eq!(found, json!({ "name": entry.name, "text": entry.text }));
    }
    let mistake = asked(json!({ "ask": "engine", "name": "V9" }))["mistake"].take();
    assert!(mistake["message"].as_str().is_some_and(|words| words.contains("no engine of this name")));
}

#[test]
fn the_certificates_of_the_page_are_those_that_the_program_prints() {
    for name in ["I5-14532", "V6-60-shared", "V8-crossplane"] {
        let text = file::find(name).expect("an engine of the catalogue").text;
        let proof = good(json!({ "ask": "proof", "name": name, "text": text }));
        assert_eq!(proof["json"], printed(&["classify", name, "--json"]), "{name}");
        assert!(proof["checked"].as_str().is_some_and(|words| words.ends_with("certificates hold.")));
        let report =
            good(json!({ "ask": "report", "name": name, "text": text, "format": "markdown", "moving": false }));
        assert_eq!(report["files"][0]["text"], printed(&["report", name]), "{name}");
    }
}

#[test]
fn a_mistake_stands_where_a_script_finds_it() {
    let text = "title = \"π 😀\"\n[vee]\nbank_angle = \"60x\"\nthrows = [0]\n";
    let mistake = asked(json!({ "ask": "look", "name": "mine", "text": text }))["mistake"].take();
    let units: Vec<u16> = text.encode_utf16().collect();
    let place = |key: &str| mistake["place"][key].as_u64().expect("a place") as usize;
    assert_eq!(String::from_utf16_lossy(&units[place("from")..place("to")]), "\"60x\"");
    assert_eq!((place("line"), place("column")), (3, 14));
    assert!(mistake["message"].as_str().is_some_and(|words| words.contains("60x")));
    assert!(mistake["right"].as_str().is_some_and(|words| !words.is_empty()));
}

/// The engine of a text with a value, as the sweeps read it: past the text.
fn engine_at(text: &str, key: &str, value: &str) -> Option<Layout> {
    let template = Template::new("x", text).expect("TOML");
    template.layout(&[(&Key::parse(key).expect("a key"), value.trim_matches('"'))]).ok()
}

#[test]
fn a_value_set_in_a_text_is_the_value_that_the_engine_has() {
    let spellings = [
        "[vee]\nbank_angle = 60 # sixty\nthrows = [0, 240, 120]\n",
        "# first\nvee = { throws = [0, 240, 120], bank_angle = \"1/6 turn\" }",
        "vee.throws = [0, 240, 120]\nvee.bank_angle = '60 deg'\n",
        "[vee]#\nthrows = [\n 0, # [vee]\n 240, 120]\n  bank_angle=60",
        "speed = 1\n  [ vee ]\nthrows = [0, 240, 120]\nbank_angle = 60\n\n[mechanism]\nrod_ratio = 0.25\nstroke = 0.1\nreciprocating_mass = 1\n",
    ];
    for text in spellings {
        for (key, value) in [("vee.bank_angle", "90"), ("vee.bank_angle", "\"540/7\""), ("vee.pin_split", "-30")] {
            let changed = with_value("x", text, key, value, &[]).expect("a place");
            let engine = |layout: Layout| match layout {
                Layout::Known(engine, _) => engine.cylinders().to_vec(),
                Layout::Open(_) => panic!("it is known"),
            };
            let read = engine(file::parse_layout("x", &changed).expect("a layout"));
            assert_eq!(
                Some(read),
                engine_at(text, key, value).map(engine),
                "{key} = {value} in\n{text}\ngives\n{changed}"
            );
            // What is no part of the value stays.
            let comments = |text: &str| text.matches('#').count();
            assert_eq!(comments(text), comments(&changed));
        }
    }
    let rods = "[inline]\nthrows = [0]\n[mechanism]\nstroke = \"80 mm\"\nrod_length = [\n\"140 mm\"] # so long\n";
    let changed = with_value("x", rods, "mechanism.rod_ratio", "0.3", &["rod_length"]).expect("a place");
    assert_eq!(changed, "[inline]\nthrows = [0]\n[mechanism]\nstroke = \"80 mm\"\nrod_ratio = 0.3 # so long\n");
    let added = with_value("x", "inline.throws = [0]", "mechanism.rod_ratio", "0.3", &[]).expect("a place");
    assert_eq!(added, "inline.throws = [0]\n\n[mechanism]\nrod_ratio = 0.3\n");
    assert!(with_value("x", "vee = 3", "vee.bank_angle", "1", &[]).is_err());
    assert!(with_value("x", "[vee]\n", "vee.bank_angle", "1]", &[]).is_err());
}

/// Whether force or moment of an order vanishes whole, judged of the engine that the text describes.
fn vanishes(text: &str, order: u32, quantity: Quantity) -> bool {
    let engine = file::parse("x", text).expect("an engine");
    let judged = Judgement::new(&engine, &[order], &Quantity::PLANAR).expect("a judgement");
    let order = &judged.orders[0];
    let whole = if quantity == Quantity::FORCE { &order.force } else { &order.moment };
    order.exists() && whole.is_balanced()
}

#[test]
fn what_is_marked_on_a_slider_vanishes_there_and_nowhere_else_on_it() {
    let text = file::find("V6-60-shared").expect("an engine of the catalogue").text;
    for slider in good(json!({ "ask": "sliders", "name": "x", "text": text })).as_array().expect("sliders") {
        let key = slider["key"].as_str().expect("a key");
        let stops = slider["stops"].as_array().expect("stops");
        let value = |stop: usize| stops[stop]["value"].as_str().expect("a value");
        let marks = slider["marks"].as_array().expect("marks");
        let marked = |stop: usize, words: &str| {
            let mark = marks.iter().find(|mark| mark["stop"] == stop);
            mark.is_some_and(|mark| mark["what"].as_array().is_some_and(|what| what.iter().any(|one| one == words)))
        };
        // Every mark, and every twelfth stop beside them.
        let of_marks = marks.iter().map(|mark| mark["stop"].as_u64().expect("a stop") as usize);
        for stop in of_marks.chain((0..stops.len()).step_by(12)) {
            let changed = with_value("x", text, key, value(stop), &[]).expect("a place");
            for order in [1, 2, 4, 6] {
                for (quantity, name) in [(Quantity::FORCE, "force"), (Quantity::MOMENT, "moment")] {
                    let found = vanishes(&changed, order, quantity);
                    let everywhere =
                        order < 6 && quantity == Quantity::FORCE || order == 6 && quantity == Quantity::MOMENT;
                    let told = marked(stop, &format!("order {order}: {name}"));
                    assert_eq!(found, told || everywhere, "order {order} of the {name} at {key} = {}", value(stop));
                }
            }
        }
        assert!(marks.len() > 5, "{key} has {} marks", marks.len());
        let rising = stops.windows(2).all(|pair| {
            let degrees =
                |stop: &Value| file::parse_angle(stop["value"].as_str().unwrap_or_default().trim_matches('"'));
            degrees(&pair[0]) < degrees(&pair[1])
        });
        assert!(rising, "the stops of {key} rise");
        let at = slider["at"].as_u64().expect("where it is") as usize;
        let now = if key == "vee.bank_angle" { Turn::fraction(1, 6) } else { Turn::zero() };
        let stands = file::parse_angle(value(at).trim_matches('"')).expect("an angle");
        assert_eq!(Turn::new(stands), now);
    }
}

#[test]
fn whatever_is_asked_there_is_an_answer() {
    let mut dice = Dice::new(15);
    let entries = file::catalogue().expect("the catalogue");
    let letters: Vec<char> = "0123456789.-\"'[]{}=,#\n \u{e9}\u{1f600}/x".chars().collect();
    for round in 0..120 {
        let (entry, _) = &entries[dice.below(28) as usize];
        let mut text: Vec<char> = entry.text.chars().collect();
        for _ in 0..=dice.below(3) {
            let at = dice.below(text.len() as u64) as usize;
            text[at] = letters[dice.below(letters.len() as u64) as usize];
        }
        let text: String = text.into_iter().collect();
        let key = ["vee.bank_angle", "vee.pin_split", "mechanism.rod_ratio", "speed"][dice.below(4) as usize];
        let set = (round % 2 == 0).then(|| json!({ "key": key, "value": "35/3" }));
        let answer = asked(json!({ "ask": "look", "name": "x", "text": text, "set": set }));
        assert_eq!(answer["ok"].is_null(), !answer["mistake"].is_null(), "{text}");
        asked(json!({ "ask": "sliders", "name": "x", "text": text }));
    }
    for wrong in ["", "{}", "[1]", "{\"ask\": \"look\"}", "{\"ask\": \"nothing\"}", "\u{0}"] {
        let answer: Value = serde_json::from_str(&answer(wrong)).expect("JSON");
        assert!(answer["mistake"]["message"].is_string(), "{wrong}");
    }
    let large = "#".repeat(2 << 20);
    assert!(asked(json!({ "ask": "look", "name": "x", "text": large }))["mistake"].is_object());
}

#[test]
fn a_claim_is_answered_as_the_command_answers_it() {
    let text = file::find("I4").expect("an engine of the catalogue").text;
    let claim = |says: &str| asked(json!({ "ask": "claim", "name": "I4", "text": text, "says": says }));
    let no = claim("the second-order force vanishes");
    assert_eq!((&no["ok"]["kind"], &no["ok"]["status"]), (&json!("fails"), &json!("false")));
    assert_eq!(claim("first-order force vanishes")["ok"]["kind"], "holds");
    assert!(claim("it runs smoothly")["mistake"]["right"].is_string());
}

#[test]
fn an_irrational_zero_is_a_stop_that_is_said_to_be_rounded() {
    // The reverse force of order 1 is (x² − x/2 + 1)(x + 2) with x = e^{iφ}: 0 where cos φ = 1/4.
    let text = "values = { phi = 60 }\ncylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
        { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 0 }]";
    let sliders = good(json!({ "ask": "sliders", "name": "x", "text": text }));
    let slider = &sliders[0];
    assert_eq!(slider["key"], "values.phi");
    let told = |mark: &Value| {
        let stop = &slider["stops"][mark["stop"].as_u64().expect("a stop") as usize];
        (stop["value"].clone(), stop["shown"].clone(), mark["what"].to_string())
    };
    let words = "order 1: reverse force (at an irrational angle, rounded here)";
    let marks: Vec<_> = slider["marks"].as_array().expect("marks").iter().map(told).collect();
    let first = marks.iter().find(|(_, _, what)| what.contains(words)).expect("a mark");
    assert_eq!((&first.0, &first.1), (&json!("75.522"), &json!("≈ 75.522°")));
    assert!(slider["note"].as_str().is_some_and(|note| note.contains("≈ where the angle is irrational")), "{slider}");
}
