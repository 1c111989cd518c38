//! Do the schemas say what is read and written? Layout files against their reader, documents as the program writes them.

use std::fs;
use std::path::{Path, PathBuf};

use crankstar::file;
use crankstar::report::{questions, schema, schema_names};
use serde_json::{Value, json};

use crate::support::dice::Dice;
use crate::support::every_form;
use crate::support::json_schema::refused;
use crate::support::mutations::{Step, at, walk};
use crate::support::program::call;

fn layout_schema() -> Value {
    schema("layout").expect("a schema")
}

/// A table with one key that no table has.
fn with_a_strange_key(table: &str) -> String {
    match table {
        "" => "strange = 1".to_owned(),
        "cylinder" | "counterweight" | "balancer" | "mount" => format!("[[{table}]]\nstrange = 1"),
        "crankshaft.geared" => "[[crankshaft]]\nstrange = 1".to_owned(),
        "torsion.shaft" | "torsion.gear" | "torsion.damper" | "torsion.harmonic" => {
            format!("[torsion]\n[[{table}]]\nstrange = 1")
        }
        "gas.cylinder" => "[gas]\n[[gas.cylinder]]\nstrange = 1".to_owned(),
        _ => format!("[{table}]\nstrange = 1"),
    }
}

#[test]
fn the_reader_has_the_keys_of_the_schema() {
    let mut found = 0;
    for (table, keys) in file::tables() {
        let text = with_a_strange_key(table);
        let error = file::parse("layout.toml", &text).expect_err("a strange key");
        assert_eq!(error.message(), "unknown key `strange`", "{table}");
        let read: Vec<&str> = error.right().split('`').skip(1).step_by(2).collect();
        assert_eq!(keys, read, "[{table}]");
        found += keys.len();
    }
    assert!(found > 200, "only {found} keys");
}

#[test]
fn the_page_of_keys_names_every_key() {
    let page = include_str!("../../src/kernel/file/README.md");
    let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    for (table, keys) in file::tables() {
        for key in keys {
            let is_told = page.split(|letter| !is_part(letter)).any(|word| word == key);
            assert!(is_told, "{key} of [{table}] is not told");
        }
    }
}

fn files(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        match entry.is_dir() {
            true => files(&entry, all),
            false if entry.extension().is_some_and(|ending| ending == "toml") => all.push(entry),
            false => (),
        }
    }
}

/// The stored files that are read as layouts, the examples of the page of keys that are whole, and some of every form.
fn layouts() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut stored = Vec::new();
    for folder in ["src/kernel/file/catalogue", "reports", "docs/conventions"] {
        files(&root.join(folder), &mut stored);
    }
    let stored = stored.iter().map(|path| fs::read_to_string(path).expect("a text"));
    let mut texts: Vec<String> = stored.filter(|text| is_read(text)).collect();
    assert!(texts.len() > 150, "only {} stored layouts are read", texts.len());
    let page = include_str!("../../src/kernel/file/README.md");
    let examples = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next());
    texts.extend(examples.filter(|text| is_read(text)).map(str::to_owned));
    let mut dice = Dice::new(29);
    texts.extend((0..60).map(|_| every_form::known(&mut dice)).filter(|text| is_read(text)));
    texts.extend((0..20).map(|_| every_form::open(&mut dice)).filter(|text| is_read(text)));
    texts
}

fn is_read(text: &str) -> bool {
    file::parse_layout("layout.toml", text).is_ok()
}

/// A file as an editor takes it: a date is a text.
fn as_json(value: &toml::Value) -> Value {
    match value {
        toml::Value::String(text) => json!(text),
        toml::Value::Integer(number) => json!(number),
        toml::Value::Float(number) => json!(number),
        toml::Value::Boolean(truth) => json!(truth),
        toml::Value::Datetime(date) => json!(date.to_string()),
        toml::Value::Array(list) => list.iter().map(as_json).collect(),
        toml::Value::Table(table) => {
            Value::Object(table.iter().map(|(key, value)| (key.clone(), as_json(value))).collect())
        }
    }
}

/// The tables of a file, and all that is in them, by their paths.
fn changed(value: &Value) -> Vec<(String, Value)> {
    let mut places = Vec::new();
    walk(value, &mut Vec::new(), &mut places);
    let mut all = Vec::new();
    for (path, found) in &places {
        let mut with = |what: &str, change: &dyn Fn(&mut Value)| {
            let mut other = value.clone();
            change(at(&mut other, path));
            all.push((format!("{what} at {path:?}"), other));
        };
        if let Value::Object(map) = found {
            with("a strange key", &|table| table["strange"] = json!(1));
            for key in map.keys() {
                with(&format!("no {key}"), &|table| drop(table.as_object_mut().map(|table| table.remove(key))));
            }
        }
        if !path.is_empty() {
            with("a truth", &|value| *value = json!(true));
            with("a table", &|value| *value = json!({ "strange": 1 }));
            with("a word", &|value| *value = json!("no such word"));
            with("a list in a list", &|value| *value = json!([[[1]]]));
        }
    }
    all
}

#[test]
fn the_schema_takes_every_layout_and_refuses_nothing_that_is_read() {
    let schema = layout_schema();
    let (mut refusals, mut strange) = (0, 0);
    for text in layouts() {
        let table: toml::Value = toml::from_str(&text).expect("TOML");
        let layout = as_json(&table);
        assert_eq!(refused(&schema, &layout), None, "{text}");
        for (what, changed) in changed(&layout) {
            let is_strange = what.starts_with("a strange key") && !what.contains("\"values\"");
            match refused(&schema, &changed) {
                None => assert!(!is_strange, "{what} is taken in\n{text}"),
                Some(why) => {
                    let written = toml::to_string(&changed).expect("TOML");
                    assert!(!is_read(&written), "{what}: {why}, but this is read:\n{written}");
                    refusals += 1;
                    strange += usize::from(is_strange);
                }
            }
        }
    }
    assert!(refusals > 5_000 && strange > 500, "{refusals} refusals, {strange} of strange keys");
}

#[test]
fn needed_keys_are_those_without_which_nothing_is_read() {
    let schema = layout_schema();
    let needs = |layout: Value| refused(&schema, &layout).is_some();
    assert!(needs(json!({ "title": "no form" })) && needs(json!({ "vee": { "throws": [0] } })));
    assert!(needs(json!({ "inline": { "throws": [0] }, "flat": { "throws": [0] } })));
    assert!(!needs(json!({ "inline": { "throws": [0, 180] } })));
    assert!(needs(json!({ "inline": { "throws": [0] }, "orders": [0] })));
    assert!(needs(json!({ "inline": { "throws": [0] }, "cycle": "three-stroke" })));
}

/// Each question that any engine can be asked, with the document of the first of these layouts that it fits.
fn asked() -> impl Iterator<Item = (&'static str, Value)> {
    let layouts = ["v8-gas", "i4-mounts", "i6-torsion"].map(|name| format!("reports/examples/{name}/layout.toml"));
    questions().map(move |question| {
        let mut calls = layouts.iter().map(|layout| call(&[question, layout, "--format", "json"]));
        let out = calls.find(|out| out.status.success()).unwrap_or_else(|| panic!("no layout for {question}"));
        (question, serde_json::from_slice(&out.stdout).expect("JSON"))
    })
}

/// Documents that the program prints, and the schema of each.
fn documents() -> Vec<(&'static str, Value)> {
    let examples = "reports/examples";
    let calls: Vec<(&str, Vec<String>)> = [
        ("list", "list --json".to_owned()),
        ("classify", "classify I4 --json".to_owned()),
        ("classify", "classify V8-crossplane --all-orders --json".to_owned()),
        ("classify", "classify radial-9-master --json".to_owned()),
        ("classify", format!("classify {examples}/i6-two-rods/layout.toml --all-orders --json")),
        ("classify", format!("classify {examples}/i6-offset/layout.toml --json")),
        ("classify", "classify reports/engines/napier-deltic-18/engine.toml --json".to_owned()),
        ("family", "classify reports/families/v6-split-pins/layout.toml --json".to_owned()),
        ("family", "classify reports/families/v6-thesis/layout.toml --json".to_owned()),
        ("family", "classify reports/families/three-unequal/layout.toml --json".to_owned()),
        ("family", "classify reports/families/w-three-banks/layout.toml --json".to_owned()),
        ("remedy", "remedy radial-9-master --json".to_owned()),
        ("loads", format!("loads {examples}/boxer-4-ej25/layout.toml --auto --json")),
        ("compare", format!("compare I4 V6-60-even {examples}/thesis-i3/layout.toml --json")),
        ("search", "search --cylinders 6 --cycle four-stroke --json".to_owned()),
        ("search", "search --cylinders 6 --cycle four-stroke --torsion --json".to_owned()),
        ("search", "search --cylinders 7 --cycle two-stroke --json".to_owned()),
        ("search", "search --cylinders 15 --cycle two-stroke --json".to_owned()),
        ("sweep", "sweep V6-60-shared --bank-angle 0..180:60 --format json".to_owned()),
        ("sweep", format!("sweep {examples}/v8-gas/layout.toml --speed 1000..3000:1000 --format json")),
        ("sweep", "sweep V8-crossplane --bank-angle 0..180:60 --format json".to_owned()),
        ("values", "values examples/four.toml --value loads.orders.2.force --format json".to_owned()),
        ("rotor", "rotor examples/shaft.toml --json".to_owned()),
        ("flywheel", "flywheel examples/turning-moment.toml --json".to_owned()),
    ]
    .map(|(name, line)| (name, line.split(' ').map(str::to_owned).collect()))
    .into();
    let document = |(name, words): (&'static str, Vec<String>)| {
        let out = call(&words);
        assert!(out.status.success(), "{words:?}: {}", String::from_utf8_lossy(&out.stderr));
        (name, serde_json::from_slice(&out.stdout).expect("JSON"))
    };
    calls.into_iter().map(document).chain(asked()).collect()
}

#[test]
fn the_schemas_take_the_documents_and_refuse_others() {
    let mut seen = std::collections::BTreeSet::from(["layout"]);
    for (name, document) in documents() {
        seen.insert(name);
        let schema = schema(name).expect("a schema");
        assert_eq!(refused(&schema, &document), None, "{name}");
        let mut places = Vec::new();
        walk(&document, &mut Vec::new(), &mut places);
        let is_free = |path: &[Step]| {
            // Columns of tables, and coefficients by symbol.
            let with_more = ["classify", "loads", "firing", "remedy", "compare", "search"];
            let is_table =
                crankstar::data::TABLES.iter().any(|(question, _)| *question == name && !with_more.contains(&name));
            let keys = ["throw", "bank", "position", "reference_plane"];
            let is_linear = matches!(path.last(), Some(Step::Key(key)) if keys.contains(&key.as_str()));
            (is_table || is_linear && name == "family") && !path.is_empty()
        };
        let evidence = |path: &[Step]| matches!(path, [Step::Key(key), _, _, ..] if key == "evidence");
        // A large document is tried at some of its places.
        let step = places.len() / 100 + 1;
        for (path, found) in places.iter().step_by(step).filter(|(path, _)| !is_free(path) && !evidence(path)) {
            let wrong = |with: Value| {
                let mut other = document.clone();
                *at(&mut other, path) = with;
                refused(&schema, &other)
            };
            if let Value::Object(map) = found {
                let mut more = map.clone();
                more.insert("strange".to_owned(), json!(1));
                assert!(wrong(Value::Object(more)).is_some(), "{name} takes a strange key at {path:?}");
            }
            assert!(wrong(json!({ "strange": [] })).is_some(), "{name} takes a table at {path:?}");
            if !found.is_boolean() {
                assert!(wrong(json!(true)).is_some(), "{name} takes a truth at {path:?}");
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), {
        let mut names = schema_names();
        names.sort_unstable();
        names
    });
}

#[test]
fn the_program_prints_the_schemas() {
    for name in schema_names() {
        let out = call(&["schema", name]);
        let printed: Value = serde_json::from_slice(&out.stdout).expect("JSON");
        assert_eq!(Some(printed), schema(name));
    }
    assert_eq!(call(&["schema", "nothing"]).status.code(), Some(2));
}
