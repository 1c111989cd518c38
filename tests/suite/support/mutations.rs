//! Which changes may be made to a document? All fields that are found in the JSON, one at a time: values altered and written otherwise,
//! entries dropped, repeated and exchanged, keys dropped and added.

use serde_json::{Value, json};

/// One step into a document.
#[derive(Clone, Debug)]
pub enum Step {
    Key(String),
    Index(usize),
}

pub fn at<'a>(root: &'a mut Value, path: &[Step]) -> &'a mut Value {
    path.iter().fold(root, |value, step| match step {
        Step::Key(key) => &mut value[key.as_str()],
        Step::Index(index) => &mut value[*index],
    })
}

pub fn written(path: &[Step]) -> String {
    let step = |step: &Step| match step {
        Step::Key(key) => format!(".{key}"),
        Step::Index(_) => "[]".to_owned(),
    };
    path.iter().map(step).collect()
}

pub fn walk(value: &Value, path: &mut Vec<Step>, all: &mut Vec<(Vec<Step>, Value)>) {
    all.push((path.clone(), value.clone()));
    let children: Vec<(Step, &Value)> = match value {
        Value::Object(map) => map.iter().map(|(key, child)| (Step::Key(key.clone()), child)).collect(),
        Value::Array(list) => list.iter().enumerate().map(|(index, child)| (Step::Index(index), child)).collect(),
        _ => Vec::new(),
    };
    for (step, child) in children {
        path.push(step);
        walk(child, path, all);
        path.pop();
    }
}

/// Other values in the place of one.
pub fn changes(value: &Value) -> Vec<Value> {
    match value {
        Value::Null => vec![json!(0), json!("direct"), json!([])],
        Value::Bool(truth) => vec![json!(!truth), Value::Null, json!("true"), json!(i32::from(*truth))],
        Value::Number(number) => match number.as_u64() {
            Some(whole) => vec![json!(whole + 1), json!(whole * 2), json!(0), Value::Null, json!(whole.to_string())],
            None => {
                let decimal = number.as_f64().expect("a decimal");
                let near = if decimal == 0.0 { 1e-12 } else { decimal * (1.0 + 1e-12) };
                vec![json!(near), json!(-decimal - 1.0), json!(decimal / 2.0 + 1.0), Value::Null]
            }
        },
        Value::String(text) => {
            let mut all = vec![json!(format!("{text}1")), json!(""), json!(format!(" {text}")), json!(7), Value::Null];
            if let Ok(number) = text.parse::<num_rational::BigRational>() {
                let fraction = |n: i64, d: i64| num_rational::BigRational::new(n.into(), d.into());
                all.extend([
                    json!((&number + fraction(1, 7)).to_string()),
                    json!((&number + fraction(1, 1)).to_string()),
                    json!((-&number + fraction(1, 3)).to_string()),
                    json!((&number * fraction(2, 1)).to_string()),
                    json!("0"),
                    json!(format!("{}/{}", number.numer() * 2, number.denom() * 2)),
                    json!(format!("+{text}")),
                ]);
                all.extend(text.parse::<u64>().map(|whole| json!(whole)));
            }
            for word in
                ["force", "moment", "torque", "direct", "reverse", "planar", "all", "unknown", "polygons", "never"]
            {
                all.push(json!(word));
            }
            all
        }
        Value::Array(list) => {
            let mut all = vec![json!([]), Value::Null, json!({})];
            for index in 0..list.len() {
                let mut dropped = list.clone();
                dropped.remove(index);
                let mut repeated = list.clone();
                repeated.insert(index, list[index].clone());
                let mut last = list.clone();
                last.push(list[index].clone());
                all.extend([json!(dropped), json!(repeated), json!(last)]);
                if index > 0 {
                    let mut exchanged = list.clone();
                    exchanged.swap(index - 1, index);
                    all.push(json!(exchanged));
                }
            }
            all
        }
        Value::Object(map) => {
            let mut all = vec![Value::Null, json!([])];
            for key in map.keys() {
                let mut dropped = map.clone();
                dropped.remove(key);
                all.push(json!(dropped));
            }
            for (key, value) in [
                ("note", json!("1")),
                ("of", json!([])),
                ("certificate", Value::Null),
                ("angle", json!("0")),
                ("1", json!("0")),
            ] {
                let mut more = map.clone();
                if more.insert(key.to_owned(), value).is_none() {
                    all.push(json!(more));
                }
            }
            all
        }
    }
}
