//! Is the layout file that `remedy` writes the engine that was promised? Over random engines of every form, and by the trade's factor.

use crankstar::engine::{Engine, Mechanism};
use crankstar::file::{FileResolver, catalogue, parse};
use crankstar::order::{self, Masses};
use crankstar::proof::{Planar, Quantity, Sense, check_document, check_remedy_document};
use crankstar::remedy::{Remedy, Request, corrected_file, remedy};
use crankstar::{report, verdict};

use crate::support::dice::Dice;
use crate::support::engines::{FORMS, file};
use crate::support::written::{engine as read, fraction};

fn found(engine: &Engine, orders: &[u32]) -> Option<Remedy> {
    remedy(engine, &Request { orders: orders.to_vec(), ..Request::default() }).ok()
}

/// The engine of the file that is written, whose every order that was asked for is zero.
#[track_caller]
fn corrected(remedy: &Remedy) -> Engine {
    let written = corrected_file(remedy, "corrected.toml", FileResolver::nothing()).unwrap_or_else(|error| {
        panic!("{error}\n{}", remedy.subject.engine().file().written());
    });
    assert!(!written.is_rounded, "{}", written.text);
    let text = written.text;
    let engine = read(&text);
    for &order in &remedy.orders {
        for quantity in Planar::BOTH {
            for sense in [Sense::Direct, Sense::Reverse] {
                let sum = order::all_masses(&engine, quantity, order, sense);
                assert_eq!(sum.vanishes(), !remedy.leaves_out(order, sense), "{quantity:?} {order} {sense:?}\n{text}");
            }
        }
    }
    let again = found(&engine, &remedy.orders).expect("a remedy of the corrected engine");
    assert!(again.weights().is_empty(), "weights for a corrected engine\n{text}");
    engine
}

#[test]
fn the_file_of_a_corrected_engine_keeps_what_remedy_promised() {
    let mut dice = Dice::new(0xF11E);
    let mut written = 0;
    for round in 0..36 {
        let form = FORMS[round % (FORMS.len() - 1)];
        let Ok(engine) = parse("random.toml", &file(&mut dice, form)) else { continue };
        let Some(remedy) = found(&engine, &[1, 2, 3, 4]) else { continue };
        let corrected = corrected(&remedy);
        written += 1;
        if written % 6 == 0 {
            let quantities = [Quantity::FORCE, Quantity::MOMENT];
            let judged = verdict::classify(&corrected, &[1, 2], Masses::All, &quantities).expect("orders");
            let document = report::document(&corrected, Masses::All, &judged, &quantities, None);
            check_document(&document).unwrap_or_else(|fault| panic!("{fault}"));
            check_remedy_document(&report::remedy_document(&remedy)).unwrap_or_else(|fault| panic!("{fault}"));
        }
    }
    assert!(written > 20, "{written} files");
}

#[test]
fn the_catalogue_is_corrected_in_multiples_of_its_masses() {
    let mut written = 0;
    for (_, engine) in catalogue().expect("the catalogue").into_iter().step_by(4) {
        let remedy = found(&engine, &[1, 2]).expect("a remedy");
        if engine.mechanisms().iter().any(|mechanism| matches!(mechanism, Mechanism::Link(_))) {
            continue;
        }
        corrected(&remedy);
        written += 1;
    }
    assert!(written > 8, "{written} files");
}

/// What links leave has no exact size: the shafts are written in decimals, and what they leave is no more worth a shaft.
#[test]
fn shafts_against_links_are_written_in_decimals_that_leave_too_little_for_another() {
    let double_wasp = include_str!("../../reports/engines/pratt-whitney-r2800/engine.toml").to_owned();
    // A radial of five without lengths, an odd one whose knuckles are corrected, a V8 whose second rods are links.
    let texts = [
        double_wasp.clone(),
        double_wasp.replace("stroke = \"6 in\"", "stroke = \"6 in\"\nreciprocating_mass = \"6 lb\""),
        "radial.cylinders = 5\n[mechanism]\nrod_ratio = '1/4'\n[articulated]\nmaster = 1\nknuckle_ratio = '1/4'".to_owned(),
        "[vee]\nbank_angle = 90\nthrows = [0, 90, 270, 180]\n[mechanism]\nrod_ratio = '1/4'\n[articulated]\nmaster = [1, 2, 3, 4]\nknuckle_ratio = '1/4'"
            .to_owned(),
    ];
    let mut rounded = 0;
    for text in texts {
        let engine = read(&text);
        let remedy = found(&engine, &[1, 2, 4]).expect("a remedy");
        let written = corrected_file(&remedy, "corrected.toml", FileResolver::nothing()).expect("a file");
        rounded += usize::from(written.is_rounded);
        assert_eq!(
            written.is_rounded,
            written.text.contains("have no exact size") || written.text.contains("no exact size")
        );
        let corrected = read(&written.text);
        let again = found(&corrected, &[1, 2, 4]).expect("a remedy of the corrected engine");
        assert!(again.weights().is_empty(), "{}", written.text);
        // By the loads, in newtons or in multiples: what is left is below a millionth of the first order of all pistons.
        let loads = crankstar::loads::loads(&corrected, &[1, 2, 4]).expect("numbers");
        for order in &loads.orders {
            let left = [&order.force.direct, &order.force.reverse].map(|vector| vector.value.norm());
            assert!(left[0] + left[1] < 1e-6 * engine.cylinders().len() as f64, "order {}: {left:?}", order.order);
        }
    }
    assert!(rounded >= 3, "{rounded}");
}

const TWIN: &str = "\
[vee]
bank_angle = 45
throws = [0]
[mechanism]
stroke = '100 mm'
rod_length = '190 mm'
pin_offset = ['2 mm', '-2 mm']
piston_mass = '0.4 kg'
piston_rod_mass = '0.15 kg'
crosshead_mass = '0.05 kg'
rotating_mass = '0.33 kg'
";

#[test]
fn a_factor_of_the_trade_and_that_of_the_thesis_make_the_counterweights_that_they_say() {
    let with = |keys: &str| {
        read(
            &format!("{TWIN}[crankshaft]\ncounterweight_radius = '40 mm'\n{keys}")
                .replace("pin_offset = ['2 mm', '-2 mm']\n", ""),
        )
    };
    let trade = with("counterweights = { rotating = 1, reciprocating = 0.6 }");
    // 0.66 kg rotate and 1.2 kg go to and fro, at 50 mm.
    let size = (fraction(66, 100) + fraction(12, 10) * fraction(6, 10)) * fraction(1, 20);
    assert_eq!(trade.crankshaft().counterweights[0].mass_radius(), size);
    assert_eq!(trade.reciprocating_factors(), [Some(fraction(6, 10))]);
    let whole = (fraction(66, 100) + fraction(6, 10)) * fraction(1, 20);
    assert_eq!(trade.balance_factors(), [Some(size / whole)]);
    let thesis = with("balance_factor = 0.6");
    assert_eq!(thesis.crankshaft(), with("counterweights = { rotating_and_half_reciprocating = 0.6 }").crankshaft());
    // b = BF/2 − (1 − BF) m_rot/M.
    let factor = fraction(3, 10) - fraction(4, 10) * fraction(66, 120);
    assert_eq!(thesis.reciprocating_factors(), [Some(factor)]);
    let halves = with("counterweights = { rotating = 0.6, reciprocating = 0.3 }");
    assert_eq!(thesis.crankshaft().counterweights, halves.crankshaft().counterweights);
}

#[test]
fn a_factor_that_may_be_the_other_one_is_asked_about() {
    let refused = |keys: &str| {
        let text = format!("{TWIN}[crankshaft]\ncounterweight_radius = '40 mm'\n{keys}")
            .replace("pin_offset = ['2 mm', '-2 mm']\n", "");
        parse("layout.toml", &text).expect_err(keys).to_string()
    };
    assert!(refused("balance_factor = '60 %'").contains("which part of which masses is meant?"));
    let both = refused("balance_factor = 0.6\ncounterweights = { rotating = 1, reciprocating = 0.6 }");
    assert!(both.contains("which one is meant?"), "{both}");
    assert!(refused("counterweights = { reciprocating = 0.6 }").contains("missing"));
    let sized = refused("counterweights = { rotating = 1, rotating_and_half_reciprocating = 0.6 }");
    assert!(sized.contains("sized twice"), "{sized}");
}

#[test]
fn counterweights_of_a_factor_are_listed_in_the_corrected_file_and_resized() {
    let engine = read(
        &format!("{TWIN}[crankshaft]\ncounterweight_radius = '40 mm'\nbalance_factor = 0.5\n")
            .replace("pin_offset = ['2 mm', '-2 mm']\n", ""),
    );
    let corrected = corrected(&found(&engine, &[1, 2, 4]).expect("a remedy"));
    let ([resized], [there]) =
        (corrected.crankshaft().counterweights.as_slice(), engine.crankshaft().counterweights.as_slice())
    else {
        panic!("one throw has one counterweight: {:?}", corrected.crankshaft());
    };
    assert_eq!(crankstar::engine::Counterweight { mass: there.mass.clone(), ..resized.clone() }, *there);
    assert!(resized.mass > there.mass, "half of what is needed was there");
}

#[test]
fn an_offset_is_answered_by_shafts_that_carry_its_coefficients() {
    let engine = read(&TWIN.replace("rotating_mass", "# rotating_mass"));
    let corrected = corrected(&found(&engine, &[1, 2, 3]).expect("a remedy"));
    let (first, higher): (Vec<_>, Vec<_>) = corrected.crankshaft().balancers.iter().partition(|shaft| shaft.order == 1);
    assert!(higher.iter().all(|shaft| shaft.coefficient_of.is_some()));
    // The real part of every c_1 is 1: its weights are plain numbers, beside those that carry the imaginary part.
    assert!([true, false].iter().all(|carries| first.iter().any(|shaft| shaft.coefficient_of.is_some() == *carries)));
    let loads = crankstar::loads::loads(&corrected, &[1, 2, 3]).expect("numbers");
    for order in &loads.orders {
        assert_eq!(order.force.direct.value.norm() + order.force.reverse.value.norm(), 0.0, "{}", order.order);
    }
}

#[test]
fn what_is_below_a_millionth_of_the_load_gets_no_weight_and_the_page_says_so() {
    let text = "inline.throws = [0, 180, 180, '0.00001 deg']\n[mechanism]\nrod_ratio = 0.25";
    let remedy = found(&read(text), &[1, 2]).expect("a remedy");
    assert!(remedy.crankshaft.is_none());
    assert!(remedy.leaves_out(1, Sense::Direct) && remedy.leaves_out(1, Sense::Reverse));
    assert!(!remedy.leaves_out(2, Sense::Direct));
    assert!(remedy.holds());
    let page =
        crankstar::page::write(&report::remedy_page(&remedy), crankstar::page::Format::PLAIN, &Default::default());
    let words = page[0].text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("Nothing is proposed for what turns with the crank at order 1"), "{words}");
    let document = report::remedy_document(&remedy);
    check_remedy_document(&document).unwrap_or_else(|fault| panic!("{fault}"));
    let silent = crankstar::proof::RemedyDocument { left_out: Vec::new(), ..document };
    assert!(check_remedy_document(&silent).is_err(), "what is left has to be said");
    corrected(&remedy);
}

#[test]
fn a_piston_rod_and_a_crosshead_go_to_and_fro_with_the_piston() {
    let engine = read(TWIN);
    assert_eq!(engine.dimensions().mass, Some(fraction(6, 10)));
    let error = parse("layout.toml", "inline.throws = [0]\n[mechanism]\ncrosshead_mass = 1").expect_err("no piston");
    assert!(error.to_string().contains("crosshead_mass without a piston_mass"), "{error}");
}
