//! Is it one answer whether an engine has an order: in the document, the tables, on the terminal, for both checkers?

use crankstar::file::{Layout, parse_layout};
use crankstar::order::Masses;
use crankstar::proof::{Quantity, Shape, read_document};
use crankstar::{report, verdict};
use serde_json::{Value, json};

use crate::support::dice::Dice;
use crate::support::program::call;
use crate::support::{every_form, second};

fn told(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn the_order_that_an_in_line_three_has_not_is_told_alike_everywhere() {
    let asked = ["classify", "I3", "--orders", "3"];
    let document: Value = serde_json::from_str(&told(&[&asked[..], &["--json"]].concat())).expect("JSON");
    for shape in document["shapes"].as_array().expect("shapes") {
        assert_eq!(shape["shape"], "does-not-exist");
        assert_eq!(shape.as_object().expect("an object").len(), 3, "nothing is compared");
    }
    let csv = told(&[&asked[..], &["--format", "csv"]].concat());
    assert!(csv.contains("3,reciprocating,,false,true,does not exist,0,0,true,does not exist,0,0,true"), "{csv}");
    assert!(told(&asked).contains(" 3       does not exist    does not exist"));
    let compare: Value =
        serde_json::from_str(&told(&["compare", "I3", "I4", "--orders", "3", "--json"])).expect("JSON");
    assert_eq!(compare["evidence"][0]["shapes"], document["shapes"]);
    let mut cheats = Vec::new();
    for shape in ["planar", "balanced", "not-decided"] {
        let mut cheat = document.clone();
        cheat["shapes"][0]["shape"] = json!(shape);
        cheats.push((shape, cheat));
    }
    let mut other: Value = serde_json::from_str(&told(&["classify", "I3", "--orders", "2", "--json"])).expect("JSON");
    other["shapes"][0] = json!({ "quantity": "force", "order": 2, "shape": "does-not-exist" });
    cheats.push(("an order that is there", other));
    for (name, cheat) in &cheats {
        let read = read_document(cheat.to_string().as_bytes());
        assert!(read.is_err() || read.is_ok_and(|document| document.check().is_err()), "{name}");
    }
    second::refuses(&cheats);
}

#[test]
fn the_shape_of_an_order_says_of_random_engines_whether_it_exists() {
    let (mut dice, mut documents, mut without) = (Dice::new(26), Vec::new(), 0);
    let masses = [Masses::All, Masses::Reciprocating, Masses::Rotating, Masses::Counterweights];
    for index in 0..40 {
        let text = every_form::known(&mut dice);
        let Ok(Layout::Known(engine, _)) = parse_layout("engine", &text) else { continue };
        let quantities = [Quantity::FORCE, Quantity::MOMENT];
        let Ok(judged) = verdict::classify(&engine, &[1, 2, 3, 4, 5], masses[index % 4], &quantities) else { continue };
        let document = report::document(&engine, masses[index % 4], &judged, &quantities, None);
        for claim in &document.shapes {
            let order = judged.iter().find(|order| order.order == claim.order).expect("the order");
            assert_eq!(claim.shape != Shape::DoesNotExist, order.exists(), "order {}\n{text}", claim.order);
            without += usize::from(!order.exists());
        }
        let read = read_document(&serde_json::to_vec(&document).expect("JSON")).expect("reads");
        read.check().unwrap_or_else(|fault| panic!("{fault}\n{text}"));
        documents.push(document);
    }
    assert!(documents.len() > 20 && without > 20, "{} documents, {without} orders are not there", documents.len());
    second::accepts(&documents, &[]);
}
