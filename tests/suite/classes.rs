//! Is an engine with unequal rods judged class by class, and does its document say so?

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::proof::{Document, check_document};
use crankstar::verdict::EveryOrderTheorem;

use crate::support::verdicts::{self, judged, pistons, theorem};

fn engine(rods: &str) -> Engine {
    let text =
        format!("[inline]\nthrows = [0, 120, 240, 240, 120, 0]\n[mechanism]\ncrank_radius = 1\nrod_length = {rods}\n");
    file::parse("engine.toml", &text).expect("it reads")
}

fn two_rods() -> Engine {
    engine("[4, 4, 5, 5, 4, 4]")
}

fn document(layout: &Engine) -> Document {
    verdicts::document(layout, &judged(layout, &[1, 2, 4], false), false, None)
}

#[test]
fn equal_rods_are_judged_together_and_unequal_ones_by_class() {
    let classes = |layout: &Engine| -> Vec<(u32, usize)> {
        let orders = pistons(layout, &[1, 2]);
        orders
            .iter()
            .map(|order| (order.order, order.class.as_ref().map_or(0, |class| class.cylinders.len())))
            .collect()
    };
    assert_eq!(classes(&engine("4")), [(1, 0), (2, 0)]);
    // All centric cranks have c_1 = 1, so order 1 is one sum all the same.
    assert_eq!(classes(&two_rods()), [(1, 0), (2, 4), (2, 2)]);
}

#[test]
fn a_six_with_two_rods_of_another_length_is_not_balanced_at_order_2() {
    let orders = pistons(&two_rods(), &[1, 2]);
    assert!(orders[0].force.is_balanced());
    assert!(!orders[1].force.is_balanced() && !orders[2].force.is_balanced());
}

#[test]
fn a_class_that_vanishes_by_itself_is_proved_to() {
    // Cylinders 1 to 3 on one rod and 4 to 6 on another: each three is a whole star.
    let orders = pistons(&engine("[4, 4, 4, 5, 5, 5]"), &[2, 4]);
    assert!(orders.iter().all(|order| order.class.is_some() && order.force.is_balanced()));
}

#[test]
fn the_document_of_unequal_rods_is_accepted() {
    let document = document(&two_rods());
    assert!(document.verdicts.iter().any(|verdict| verdict.of == ["3", "4"]));
    check_document(&document).expect("it holds");
    let json = serde_json::to_string(&document).expect("it is written");
    check_document(&serde_json::from_str(&json).expect("it is read")).expect("it holds when read again");
}

#[test]
fn a_class_cannot_hide_a_cylinder_or_name_one_that_is_not_there() {
    let place = |document: &Document| document.verdicts.iter().position(|v| v.of == ["3", "4"]).expect("a class");
    let mut unknown = document(&two_rods());
    let index = place(&unknown);
    unknown.verdicts[index].of.push("7".to_owned());
    assert!(check_document(&unknown).expect_err("refused").to_string().contains("here stands a verdict on"));
    let mut hidden = document(&two_rods());
    hidden.verdicts[index].of = vec!["3".to_owned()];
    assert!(check_document(&hidden).expect_err("refused").to_string().contains("here stands a verdict on"));
    let mut heavier = document(&two_rods());
    heavier.verdicts[index].terms[0].weight += num_rational::BigRational::from_integer(1.into());
    assert!(check_document(&heavier).expect_err("refused").to_string().contains("the weight of 3 is"));
}

#[test]
fn every_order_is_stated_class_by_class_of_unequal_rods_and_of_an_offset() {
    let is_by_classes = |engine: &Engine| match theorem(engine).expect("a short pattern") {
        EveryOrderTheorem::Recurrences(_) => true,
        EveryOrderTheorem::Period(_) => false,
    };
    assert!(is_by_classes(&two_rods()));
    let offset =
        file::parse("o.toml", "inline.throws = [0, 180]\n[mechanism]\nrod_ratio = 0.25\noffset_ratio = 0.02\n");
    assert!(is_by_classes(&offset.expect("it reads")));
    assert!(!is_by_classes(&engine("4")));
}
