//! Is what a remedy leaves out below a millionth of the load, for both checkers, all of an order together?

use crankstar::numbers::evaluate;
use crankstar::proof::{
    Coefficient, LeftOutClaim, Quantity, RemedyDocument, RodCylinder, Sense, TurningClaim, check_remedy_document,
};
use crankstar::remedy::{Remedy, Request, remedy};
use crankstar::report::remedy_document;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use crate::support::dice::Dice;
use crate::support::second;
use crate::support::whole_documents::number;
use crate::support::written::{engine as read, sum};

const RODS: &str = "[mechanism]\nrod_ratio = 0.25";

fn found(text: &str, orders: &[u32]) -> Remedy {
    remedy(&read(text), &Request { orders: orders.to_vec(), ..Request::default() }).expect("a remedy")
}

/// The sums of an engine, nothing against them, and the claim that these orders and senses are too little for a weight.
fn without_weights(text: &str, orders: &[u32], left_out: &[(u32, Sense)]) -> RemedyDocument {
    let mut bare = found(text, orders);
    (bare.crankshaft, bare.shafts, bare.left_out) = (None, Vec::new(), Vec::new());
    bare.corrected = crankstar::remedy::corrected(&bare.subject, orders, &[]);
    let left_out = left_out.iter().map(|&(order, sense)| LeftOutClaim { order, sense }).collect();
    RemedyDocument { left_out, ..remedy_document(&bare) }
}

const BOTH: [Sense; 2] = [Sense::Direct, Sense::Reverse];

#[test]
fn an_order_that_is_left_as_it_is_is_no_remedy() {
    let order = |order: u32| BOTH.map(|sense| (order, sense));
    let four = format!("inline.throws = [0, 180, 180, 0]\n{RODS}");
    let cheats = [
        ("order 2 of an in-line four", without_weights(&four, &[1, 2], &order(2))),
        ("the same, its rods not known", without_weights("inline.throws = [0, 180, 180, 0]", &[1, 2], &order(2))),
        ("the couple of an in-line three", without_weights("inline.throws = [0, 120, 240]", &[1], &order(1))),
        (
            "order 2 of rods that differ",
            without_weights("inline.throws = [0, 180]\n[mechanism]\nrod_ratio = [0.25, 0.3]", &[2], &order(2)),
        ),
        ("a piston alone", without_weights(&format!("inline.throws = [0]\n{RODS}"), &[2], &order(2))),
    ];
    for (name, cheat) in &cheats {
        let fault = check_remedy_document(cheat).expect_err(name);
        assert!(fault.to_string().contains("a millionth of the load"), "{name}: {fault}");
    }
    second::refuses(&cheats);
}

/// The load and its arm are those of pistons: nothing far off makes them larger.
#[test]
fn a_mass_or_a_plane_far_off_makes_no_couple_small() {
    let order = BOTH.map(|sense| (1, sense));
    let three = || without_weights("inline.throws = [0, 120, 240]", &[1], &order);
    let far = || BigRational::from_integer(10_000_000.into());
    let [mut of_mass, mut of_cylinder, mut of_weights] = [three(), three(), three()];
    of_mass.turning_masses.push(TurningClaim {
        order: 1,
        sense: Sense::Direct,
        position: far(),
        angle: BigRational::zero(),
        mass_radius: BigRational::zero(),
        coefficient_of: None,
    });
    let light = "inline = { throws = [0, 120, 240, 0], positions = [0, 1, 2, 10000000] }\nmechanism.reciprocating_mass = [1, 1, 1, '1e-30']";
    let cylinder = three().cylinders[0].clone();
    of_cylinder.cylinders.push(RodCylinder { position: far(), weight: BigRational::zero(), ..cylinder.clone() });
    for weight in [far(), -far()] {
        of_weights.cylinders.push(RodCylinder { weight, ..cylinder.clone() });
    }
    let cheats = [
        ("a mass", of_mass),
        ("a cylinder", of_cylinder),
        ("a light piston", without_weights(light, &[1], &order)),
        ("a plane", without_weights("reference_plane = 10000000\ninline.throws = [0, 120, 240]", &[1], &order)),
        ("pistons that weigh less than nothing", of_weights),
    ];
    for (name, cheat) in &cheats {
        let fault = check_remedy_document(cheat).expect_err(name).to_string();
        assert!(fault.contains("a millionth of the load") || fault.contains("less than nothing"), "{name}: {fault}");
    }
    second::refuses(&cheats);
}

#[test]
fn left_out_names_what_is_left_and_nothing_else() {
    let text = format!("inline.throws = [0, 180, 180, 0]\n{RODS}\nreciprocating_mass = [1, 1, 1, '1.0000003']");
    let honest = remedy_document(&found(&text, &[1, 2]));
    let named: Vec<(u32, Sense)> = honest.left_out.iter().map(|one| (one.order, one.sense)).collect();
    assert_eq!(named, [(1, Sense::Direct), (1, Sense::Reverse)]);
    check_remedy_document(&honest).unwrap_or_else(|fault| panic!("{fault}"));
    second::accepts(&[&honest], &[]);
    let cheat = |change: &dyn Fn(&mut Vec<LeftOutClaim>)| {
        let mut cheat = honest.clone();
        change(&mut cheat.left_out);
        cheat
    };
    let more = |order, sense| cheat(&move |list: &mut Vec<LeftOutClaim>| list.push(LeftOutClaim { order, sense }));
    let cheats = [
        ("one twice", more(1, Sense::Direct)),
        ("one that is zero", more(2, Sense::Direct)),
        ("an order not asked for", more(3, Sense::Direct)),
        ("one not named", cheat(&|list| list.truncate(1))),
    ];
    for (name, cheat) in &cheats {
        assert!(check_remedy_document(cheat).is_err(), "{name}");
    }
    second::refuses(&cheats);
}

/// Each weight of the pair would make 0.7 millionths of the load, both together 1.4.
#[test]
fn what_both_senses_leave_counts_together() {
    let text = format!("inline.throws = [0, 180, 180, 0]\n{RODS}\nreciprocating_mass = [1, 1, 1, '1.0000037']");
    let remedy = found(&text, &[1]);
    assert_eq!(remedy.left_out.len(), 1, "one of them at most");
    assert!(remedy.crankshaft.is_some() != remedy.shafts.iter().any(|shaft| shaft.order == 1));
    let document = remedy_document(&remedy);
    check_remedy_document(&document).unwrap_or_else(|fault| panic!("{fault}"));
    let cheat = without_weights(&text, &[1], &BOTH.map(|sense| (1, sense)));
    assert!(check_remedy_document(&cheat).is_err());
    second::accepts(&[&document], &[]);
    second::refuses(&[("both senses", &cheat)]);
}

/// A number that is not the engine's could be as small as one likes, and cannot be enclosed where no rod has it.
#[test]
fn what_is_left_is_multiplied_by_numbers_of_the_engine() {
    let text = format!("inline.throws = [0, 180, 180, 0]\n{RODS}");
    let mut cheat = remedy_document(&found(&text, &[2]));
    let other = crankstar::proof::RodClaim {
        ratio: BigRational::new(5.into(), 1.into()),
        offset: BigRational::new(0.into(), 1.into()),
    };
    for weight in &mut cheat.weights {
        weight.parts[0].coefficient = Coefficient::Rod(other.clone());
    }
    let bare = without_weights(&text, &[2], &BOTH.map(|sense| (2, sense)));
    cheat.left_out = bare.left_out.clone();
    let mut sums = Vec::new();
    for own in &bare.sums {
        sums.push(own.clone());
        if !own.terms.is_empty() {
            let turned =
                own.terms.iter().map(|term| crankstar::proof::Vector { weight: -&term.weight, ..term.clone() });
            let terms: Vec<_> = turned.collect();
            let certificate = sum_of(&terms).certificate();
            sums.push(crankstar::proof::CorrectedClaim {
                coefficient: Coefficient::Rod(other.clone()),
                terms,
                certificate,
                ..own.clone()
            });
        }
    }
    cheat.sums = sums;
    let fault = check_remedy_document(&cheat).expect_err("no number of the engine").to_string();
    assert!(fault.contains("a number that the engine does not have"), "{fault}");
    second::refuses(&[("another number", &cheat)]);
}

fn sum_of(terms: &[crankstar::proof::Vector]) -> crankstar::exact::PhasorSum {
    let written: Vec<String> = terms.iter().map(|term| format!("{}@{}", term.weight, term.angle)).collect();
    sum(&written.join(" "))
}

/// Balanced but for some millionths of a mass or of a position, to either side of the limit.
fn nearly_balanced(dice: &mut Dice) -> String {
    let (throws, rods) = match dice.below(3) {
        0 => ("0, 180, 180, 0", 4),
        1 => ("0, 120, 240, 240, 120, 0", 6),
        _ => ("0, 180", 2),
    };
    let off = |dice: &mut Dice| {
        let most = 10_u64.pow(3 + dice.below(4) as u32);
        format!("'1.{:010}'", dice.below(most))
    };
    let masses: Vec<String> = (0..rods).map(|_| off(dice)).collect();
    let lengths = ["", "rod_ratio = 0.25", "rod_ratio = 0.25\noffset_ratio = 0.05"][dice.below(3) as usize];
    format!("inline.throws = [{throws}]\n[mechanism]\n{lengths}\nreciprocating_mass = [{}]", masses.join(", "))
}

/// What is left of a quantity in an order, by floats: both vectors end to end; a c_k that is not known counts as 2.
fn left(document: &RemedyDocument, quantity: Quantity, order: u32) -> f64 {
    let of = |sense: Sense| {
        let sums = document.sums.iter().filter(|one| (one.quantity, one.order, one.sense) == (quantity, order, sense));
        let value = |claim: &crankstar::proof::CorrectedClaim| {
            let c = number(&claim.coefficient, order).unwrap_or(Complex::new(2.0, 0.0));
            evaluate(&sum_of(&claim.terms)) * if sense == Sense::Reverse { c.conj() } else { c }
        };
        sums.map(value).sum::<Complex<f64>>().norm()
    };
    of(Sense::Direct) + of(Sense::Reverse)
}

#[test]
fn remedies_of_nearly_balanced_engines_leave_less_than_a_millionth_of_the_load_in_each_order() {
    let mut dice = Dice::new(26);
    let (mut slight, mut documents) = ([0, 0], Vec::new());
    for _ in 0..60 {
        let text = nearly_balanced(&mut dice);
        let document = remedy_document(&found(&text, &[1, 2]));
        check_remedy_document(&document).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
        let float = |number: &BigRational| number.to_f64().expect("a float");
        let load: f64 = document.cylinders.iter().map(|one| float(&one.weight.abs())).sum();
        let along = || document.cylinders.iter().map(|one| float(&one.position));
        let length = along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min);
        for order in [1, 2] {
            let [force, moment] = [Quantity::FORCE, Quantity::MOMENT].map(|quantity| left(&document, quantity, order));
            let why = || format!("order {order}: {force} {moment}\n{text}");
            assert!(force < 2.001e-6 * load && moment < 2.001e-6 * load * length, "{}", why());
            let count = document.left_out.iter().filter(|one| one.order == order).count();
            if count > 0 {
                slight[count - 1] += 1;
            }
        }
        documents.push(document);
    }
    assert!(slight.iter().all(|count| *count > 3), "{slight:?} orders with one sense omitted, and both");
    second::accepts(&documents, &[]);
}
