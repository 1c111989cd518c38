//! How is a layout file written with other weights? The tables of weights, and the text without those that it has.

use num_rational::BigRational;

use crate::engine::{Balancer, Convention, Counterweight, Engine, throws};
use crate::exact::fraction;

/// A balancer shaft as a table of a layout file; its mass-radius is written in multiples of m r, where `unit` is m r in
/// kilogram-metres and the file does not give it, else in kilogram-metres.
pub fn balancer_table(engine: &Engine, shaft: &Balancer, unit: Option<&BigRational>) -> String {
    let mass_radius = match unit {
        Some(unit) => format!("\"{} m r\"", &shaft.mass_radius / unit),
        None => exact_number(&shaft.mass_radius),
    };
    let sense = shaft.sense.choose("with", "against");
    let cylinder = shaft.coefficient_of.and_then(|index| engine.cylinders().get(index));
    let coefficient = cylinder.map(|cylinder| format!("coefficient_of = \"{}\"\n", cylinder.name)).unwrap_or_default();
    // Without either key the axis is omitted: one in the middle is written.
    let axis = shaft.axis.as_ref().map_or_else(String::new, |axis| {
        let offset = engine.convention().in_the_sense_of_rotation(axis.offset.clone());
        format!("height = {}\noffset = {}\n", exact_number(&axis.height), exact_number(&offset))
    });
    format!(
        "[[balancer]]\norder = {}\nsense = \"{sense}\"\nmass_radius = {mass_radius}\n{coefficient}angle = {}\nposition = {}\n{axis}",
        shaft.order,
        exact_number(&engine.convention().as_written(&shaft.angle).degrees()),
        exact_number(&shaft.position),
    )
}

/// A counterweight in multiples of m r, which is `unit` in kilogram-metres.
pub fn counterweight_in_multiples(weight: &Counterweight, convention: Convention, unit: &BigRational) -> String {
    counterweight(weight, convention, &format!("mass_radius = \"{} m r\"", weight.mass_radius() / unit))
}

fn counterweight(weight: &Counterweight, convention: Convention, size: &str) -> String {
    let angle = exact_number(&convention.as_written(&weight.angle).degrees());
    format!("[[counterweight]]\nangle = {angle}\n{size}\nposition = {}\n", exact_number(&weight.position))
}

/// Lines of a file that say something to its reader.
pub fn comment(text: &str) -> String {
    text.lines().map(|line| format!("# {line}\n")).collect()
}

/// A counterweight as a table of a layout file that draws its engine so, by its own angle.
pub fn counterweight_table(weight: &Counterweight, convention: Convention) -> String {
    let [mass, radius] = [&weight.mass, &weight.radius].map(exact_number);
    counterweight(weight, convention, &format!("mass = {mass}\nradius = {radius}"))
}

/// The table of a counterweight whose angle counts from its throw, where it has one; `table` writes any.
pub fn counted_from_its_throw(
    engine: &Engine,
    weight: &Counterweight,
    table: impl Fn(&Counterweight) -> String,
) -> String {
    let throws = throws(engine);
    let Some((index, throw)) = weight.throw.and_then(|index| Some((index, throws.get(index)?))) else {
        return table(weight);
    };
    let turned = Counterweight { angle: &weight.angle - &throw.angle, ..weight.clone() };
    table(&turned).replacen('\n', &format!("\nthrow = {}\n", index + 1), 1)
}

/// An exact number as a layout file has it: a decimal where it ends and its whole part fits a float's digits, else a fraction in quotes.
pub fn exact_number(value: &BigRational) -> String {
    let written = fraction::written(value, fraction::MOST_PLACES);
    let whole = written.split('.').next().unwrap_or_default().trim_start_matches('-');
    if written.contains('/') || whole.len() > 18 { format!("\"{value}\"") } else { written }
}

/// The same without quotes: as a person reads it, or before a unit.
pub fn bare_number(value: &BigRational) -> String {
    exact_number(value).trim_matches('"').to_owned()
}

/// The text of a layout file without `[[balancer]]` tables.
pub fn without_balancers(text: &str) -> String {
    let mut is_left_out = false;
    let kept = text.lines().filter(|line| {
        let bare = line.split('#').next().unwrap_or(line).trim();
        if bare.starts_with('[') {
            is_left_out = bare == "[[balancer]]";
        }
        !is_left_out
    });
    kept.collect::<Vec<_>>().join("\n")
}

/// The text of a layout file without `[[counterweight]]` tables and the keys of `[crankshaft]` that make counterweights.
pub fn without_counterweights(text: &str) -> String {
    const MAKERS: [&str; 4] = ["balance_factor", "counterweights", "counterweight_radius", "web_offset"];
    let mut kept = Vec::new();
    let (mut table, mut open) = (String::new(), 0_i32);
    for line in text.lines() {
        let bare = line.split('#').next().unwrap_or(line).trim();
        if open > 0 {
            // The rest of a list that is omitted.
            open += brackets(bare);
            continue;
        }
        if bare.starts_with('[') {
            table = bare.to_owned();
        }
        let key = bare.split('=').next().unwrap_or_default().trim();
        let makes = table == "[crankshaft]" && MAKERS.contains(&key.split('.').next().unwrap_or_default().trim());
        let first = |key: &str| key.split('.').next().unwrap_or_default().trim().to_owned();
        let dotted = key.strip_prefix("crankshaft.").is_some_and(|key| MAKERS.contains(&first(key).as_str()));
        if makes || dotted {
            open = brackets(bare);
        } else if table != "[[counterweight]]" && table != "[crankshaft.counterweights]" {
            kept.push(line);
        }
    }
    kept.join("\n")
}

fn brackets(text: &str) -> i32 {
    text.chars().map(|letter| i32::from(letter == '[') - i32::from(letter == ']')).sum()
}
