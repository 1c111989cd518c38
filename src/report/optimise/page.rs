//! What stands on the page of the best crankshafts?

use num_traits::ToPrimitive;
use serde::Serialize;

use super::super::dialect::Dialect;
use super::super::folder::File;
use super::super::old::Rows;
use super::super::old::Table;
use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::super::{render, svg};
use super::{amounts, tables};
use crate::engine::Engine;
use crate::optimise::{Couple, Design, Front};
use crate::text::Format;

#[derive(Serialize)]
struct Page {
    title: String,
    summary: String,
    front: Table,
    weights: Table,
    method: Vec<String>,
    files: Vec<String>,
}

#[derive(Serialize)]
struct Summary {
    headline: Vec<String>,
    compared: Option<Table>,
    drawing: String,
}

const METHOD: [&str; 5] = [
    "Chosen is the mass-radius of each counterweight, in its plane: its size, which is the balance factor that the weight adds to its throw, and its \
     direction, told as the skew from opposite to its throw, positive ahead of it. A larger radius makes the same mass-radius of less mass, so that the \
     largest radius is always the best one.",
    "The mass is that of the source of the balance factors: the masses of the throws brought to their crank radii, half the reciprocating ones among them, and \
     the counterweights. The load is the largest force on any main bearing in a revolution, all orders together, on a continuous beam.",
    "For a given mass this is a convex problem (a second-order cone program): every bearing load is affine in the mass-radii. Crank angles are sampled, and \
     those at which a solution peaks higher are added until peak and samples agree. The multipliers of the solution prove, by weak duality, how low any \
     crankshaft of that mass could come: the figure after “proved least within”, reckoned in floats.",
    "The solution is then rounded to whole steps of mass-radius, and two of the weights (one where a couple may be left) are solved anew, exactly, so that \
     force and couple vanish: 0 is decided on the exact sums of the layout file of the point. A weight that no direction of the throws \
     meets is written as parts along two of them.",
    "Figures after ≈ have four digits. They are measured on the layout files of the points, not taken from the solver.",
];

/// What follows the table on a terminal, and stands first on the page.
pub fn optimise_lines(layout: &Engine, front: &Front, couple: &Couple) -> Vec<String> {
    let units = tables::units(layout, front);
    let told = |design: &Design| {
        format!("{} kg with {} {}", amounts::kilograms(&design.mass), amounts::load(design, units), units.force)
    };
    let ends = match (front.points.first(), front.points.last()) {
        (Some(first), Some(last)) if front.points.len() > 1 => {
            format!(
                "From the lightest crankshaft, {}, to that with the least load, {}.",
                told(&first.design),
                told(&last.design)
            )
        }
        (Some(only), _) => format!("The least load: {}.", told(&only.design)),
        (None, _) => String::new(),
    };
    let condition = match couple {
        Couple::Zero => {
            "First-order force and couple that turn with the crank are removed; 0 is exact and proved.".to_owned()
        }
        Couple::AtMost(most) => format!(
            "The first-order force that turns with the crank is removed, its couple bounded by {} N·m; 0 is exact and proved, ≈ the upper end of an enclosure.",
            most.to_f64().unwrap_or(f64::NAN)
        ),
    };
    vec![ends, condition]
}

/// Headline, comparison with uniform balance factors, and plot, for a page that holds them beside others.
pub fn optimise_summary(layout: &Engine, front: &Front, couple: &Couple, folder: &str) -> String {
    let compared = (!front.uniform.is_empty()).then(|| set(tables::optimise_compared(layout, front)));
    let dialect = Dialect::GithubMarkdown;
    let headline = optimise_lines(layout, front, couple).iter().map(|line| dialect.prose(line)).collect();
    render::optimise_summary(&Summary { headline, compared, drawing: format!("{folder}front.svg") })
}

/// The page, its plot, and the layout file of each point.
pub fn optimise_files(layout: &Engine, front: &Front, couple: &Couple) -> Vec<File> {
    let dialect = Dialect::GithubMarkdown;
    let mut layouts: Vec<File> = Vec::new();
    for (index, point) in front.points.iter().enumerate() {
        layouts
            .push(File { name: format!("point-{}.toml", index + 1), text: point.engine.file().written().to_owned() });
    }
    for uniform in &front.uniform {
        let factor = uniform.factor.to_f64().unwrap_or(f64::NAN);
        let compared = [("heavy", &uniform.best), ("calm", &uniform.lightest)];
        let named = compared.into_iter().filter_map(|(as_what, point)| Some((as_what, point.as_ref()?)));
        layouts.extend(named.map(|(as_what, point)| File {
            name: format!("as-{as_what}-as-{factor}.toml"),
            text: point.engine.file().written().to_owned(),
        }));
    }
    let page = Page {
        title: dialect.quoted(layout.title()),
        summary: optimise_summary(layout, front, couple, ""),
        front: set(tables::optimise_rows(layout, front)),
        weights: set(tables::weights(layout, front)),
        method: METHOD.iter().map(|line| dialect.prose(line)).collect(),
        files: layouts.iter().map(|file| file.name.clone()).collect(),
    };
    let page = File { name: "optimise.md".into(), text: render::optimise(&page) };
    let drawing = File { name: "front.svg".into(), text: drawing(layout, front) };
    [page, drawing].into_iter().chain(layouts).collect()
}

fn set(rows: Rows) -> Table {
    let header: Vec<&str> = rows.header.iter().map(String::as_str).collect();
    Table::new(Dialect::GithubMarkdown, &header, rows.rows)
}

/// Load over mass: the front, and uniform balance factors beside it.
fn drawing(layout: &Engine, front: &Front) -> String {
    let units = tables::units(layout, front);
    // Four digits, so that the drawing is the same wherever the figures are.
    let rounded = |value: f64| format!("{value:.3e}").parse::<f64>().unwrap_or(value);
    let at =
        |design: &Design| (rounded(design.mass.to_f64().unwrap_or(f64::NAN)), rounded(design.peak() * units.newtons));
    let load = Axis::linear(format!("Largest bearing load in {}", units.force));
    let mut plot = Plot::new(layout.title().escaped(Format::Plain), Axis::linear("Crankshaft mass in kg"), load);
    let best: Vec<(f64, f64)> = front.points.iter().map(|point| at(&point.design)).collect();
    plot.marks.extend(best.iter().map(|&at| PointMark::dot(at, "")));
    plot.curves.push(Curve::new(0, "the best counterweights", best));
    let uniform = |uniform: &crate::optimise::Uniform| {
        let name = format!("balance factor {}", amounts::factor(&uniform.factor));
        PointMark::ring(at(&uniform.design), name).of("one balance factor for all throws")
    };
    plot.marks.extend(front.uniform.iter().map(uniform));
    svg(&plot.figure(), "Largest bearing load over the mass of the crankshaft")
}
