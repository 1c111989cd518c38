//! How is the atlas written for a spreadsheet? One line per engine and order, exact and in decimals.

use std::fmt::Write;

use super::super::residual::shape_name;
use super::entry::{EngineRow, Origin, Remaining};
use crate::engine::Cycle;
use crate::page::Text;
use crate::proof::Shape;
use crate::text::{self, Format};

const HEADER: &str = "origin,engine,title,firing,firing_order,stars,all_stars,position_unit,order,force,force_exact,force_shape,\
    moment,moment_exact,moment_shape,first_force_residual,first_moment_residual,remedy_of_orders_1_and_2";

/// The lines, with a header. Force in m r ω² c_k, moment in that times the unit of the positions; 0 is exact.
pub(super) fn csv(all: &[EngineRow]) -> String {
    let mut lines = format!("{HEADER}\n");
    for engine in all {
        for order in &engine.orders {
            let origin = match engine.origin {
                Origin::Catalogue => "catalogue",
                Origin::Found(Cycle::TwoStroke) => "best two-stroke star",
                Origin::Found(Cycle::FourStroke) => "best four-stroke star",
            };
            let ties = engine.ties.as_ref().map(|ties| [ties.stars.to_string(), ties.all.to_string()]);
            let [stars, all] = ties.unwrap_or_default();
            let mut fields = vec![
                origin.to_owned(),
                engine.name.clone(),
                engine.title.escaped(Format::Csv),
                engine.firing.plain(),
                engine.firing_order.clone(),
                stars,
                all,
                engine.unit.name().to_owned(),
                order.order.to_string(),
            ];
            fields.extend(amount(&order.force));
            fields.extend(amount(&order.moment));
            fields.extend(engine.first_left.each_ref().map(Text::plain));
            fields.push(engine.remedy.plain());
            let quoted: Vec<String> = fields.iter().map(|field| text::field(field)).collect();
            // Writing to a string cannot fail.
            let _ = writeln!(lines, "{}", quoted.join(","));
        }
    }
    lines
}

/// The largest value in decimals, its closed form where one is known, the shape.
fn amount(left: &Remaining) -> [String; 3] {
    let shape = shape_name(left.shape).to_owned();
    if left.shape == Shape::Balanced {
        return ["0".to_owned(), "0".to_owned(), shape];
    }
    // Of an order that does not exist it is the length of the star.
    let Some(largest) = &left.largest else { return [String::new(), String::new(), shape] };
    if largest.exact.as_ref().is_some_and(|form| form.terms().is_empty()) {
        return ["0".to_owned(), "0".to_owned(), shape];
    }
    let exact = largest.exact.as_ref().map(ToString::to_string).unwrap_or_default();
    [format!("{:.9}", largest.decimal), exact, shape]
}
