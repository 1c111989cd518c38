//! Sentences that were false of engines that can be written: are they true of these now?

use crankstar::claim::{self, Status, parse_statement};
use crankstar::engine::Engine;
use crankstar::file::FileResolver;
use crankstar::loads::{Loads, usual_orders};
use crankstar::page::Format;
use crankstar::proof::{Axial, Sense, read_document};
use crankstar::remedy::{Request, corrected_file, remedy};
use crankstar::report::{Question, TorqueStudy};
use num_rational::BigRational;
use num_traits::Signed;

use crate::support::pages;
use crate::support::program::{call, scratch};
use crate::support::written::engine;

/// What the program prints of a layout, on one line.
pub fn said(question: &str, layout: &str, more: &[&str]) -> String {
    printed(&[&[question, written(layout).as_str()], more].concat())
}

/// The path of a file that holds a layout.
pub fn written(layout: &str) -> String {
    let path = scratch("true-sentences").join("layout.toml");
    std::fs::write(&path, layout).expect("a layout");
    path.to_str().expect("UTF-8").to_owned()
}

/// What it prints when it is asked so, on lines joined to one.
pub fn printed(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
}

fn loads_of(engine: &Engine) -> Loads {
    crankstar::loads::loads(engine, &usual_orders(engine)).expect("numbers")
}

const TWIN: &str = "speed = 4500\neffects = ['torque']\n[u]\nthrows = [0, 170]\nsense = 'against'\nphase = 180\ndistance = '110 mm'\nspacing = '70 mm'\n\
    [mechanism]\nstroke = '54 mm'\nrod_length = '104 mm'\npin_offset = '4 mm'\nreciprocating_mass = '0.21 kg'\nrotating_mass = '0.17 kg'\n\
    [[balancer]]\norder = 1\nsense = 'with'\nmass = '0.1 kg'\nradius = '20 mm'\nposition = 0\nangle = 0\n";

#[test]
fn a_roll_moment_that_hangs_on_a_length_left_out_is_named_nowhere_as_one() {
    for layout in
        [TWIN, &TWIN.replace("[u]", "[inline]").replace("sense = 'against'\nphase = 180\ndistance = '110 mm'\n", "")]
    {
        let given = layout.replace("position = 0\n", "position = 0\nheight = '10 mm'\noffset = '20 mm'\n");
        assert_eq!(loads_of(&engine(layout)).rolling(), None);
        assert_eq!(loads_of(&engine(&given)).rolling(), Some(Axial::Roll));
        let told = said("classify", layout, &[]);
        let built = told.split("The pistons alone.").next().expect("a text");
        assert!(!built.contains("Roll moment") && built.contains("All other"), "{told}");
        assert!(
            told.contains("The roll moment is not given: it depends on the position of balancer shaft 1."),
            "{told}"
        );
        assert!(said("classify", &given, &[]).contains("Roll moment"));
    }
    let centric = "speed = 4500\neffects = ['torque']\n[inline]\nthrows = [0, 180]\n[mechanism]\nstroke = '54 mm'\nrod_length = '104 mm'\nreciprocating_mass = 1\n";
    assert_eq!(loads_of(&engine(centric)).rolling(), Some(Axial::Torque));
    assert!(said("classify", centric, &[]).contains("Roll moment"));
}

#[test]
fn the_roll_moment_of_a_crankshaft_that_turns_against_another_tells_what_it_assumes() {
    let told = |sense: &str| {
        said(
            "classify",
            &TWIN
                .replace("sense = 'against'", &format!("sense = '{sense}'"))
                .replace("position = 0\n", "position = 0\nheight = 0\noffset = 0\n"),
            &[],
        )
    };
    assert!(told("against").contains("assumes that each crankshaft has its own flywheel"));
    assert!(!told("with").contains("flywheel"));
}

const FOUR: &str = "speed = 3000\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = '100 mm'\n[mechanism]\nstroke = '90 mm'\nrod_ratio = '1/4'\n\
    reciprocating_mass = ['0.65 kg', '0.65', '0.65', '0.70']\n";

#[test]
fn orders_that_are_small_beside_others_are_those_of_the_force_or_of_the_moment() {
    let engine = engine(FOUR);
    let text = pages::text(&pages::document(&engine), Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
    // Order 4 of the force is 1.6 % of order 2, and told; of the moment it is among the small ones.
    assert!(text.contains("48.2 N (order 4)"), "{text}");
    let (force, moment) = ("% of the largest force (6, …), ", "% of the largest moment (4, 6, …).");
    assert!(
        text.contains("All other orders. Together at most") && text.contains(force) && text.contains(moment),
        "{text}"
    );
    // Whose mass the multiples are of.
    assert!(text.contains("in m r ω² c_k, m being 0.65 kg:"), "{text}");
    assert!(!text.contains("times kilograms"), "{text}");
}

#[test]
fn the_mass_of_the_multiples_is_the_one_that_they_count() {
    let told = |above: &str| {
        let one = |throw: u32| {
            format!("[[cylinder]]\nthrow = {throw}\nbank = 0\nposition = 0\nreciprocating_mass = '0.8 kg'\n")
        };
        let text = pages::text(&pages::document(&engine(&(above.to_owned() + &one(0) + &one(90)))), Format::PLAIN);
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    // √2 of two masses of 0.8 kg is 1.13 of one kilogram.
    assert!(told("").contains("m being the unit of the reciprocating masses in the table of cylinders:"));
    assert!(told("[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\n").contains("m being 1 kg:"));
}

#[test]
fn a_bound_in_newtons_is_never_rounded_down() {
    let yokes = "speed = '3000 rpm'\n[mechanism]\nstroke = '80 mm'\nscotch_yoke = true\nreciprocating_mass = ['1 kg', '1.00614 kg']\n\
        [[cylinder]]\nthrow = 0\nbank = -90\nposition = 0\n[[cylinder]]\nthrow = 180\nbank = 90\nposition = 0\n";
    // 6.14 g · 40 mm · ω² = 24.24 N.
    let text = pages::text(&pages::document(&engine(yokes)), Format::PLAIN);
    assert!(text.contains("Order 1. At most 24.3 N of force."), "{text}");
}

#[test]
fn what_a_cure_leaves_is_rounded_and_not_raised() {
    // 1 of 3 vectors: a third is 33 %, not 34.
    let fan = "[fan]\nbanks = [-60, 0, 60]\nthrows = [0, 240, 120]\n";
    let told = said("classify", fan, &[]);
    assert!(!told.contains("34 %"), "{told}");
}

/// The axes of its cylinders miss the crankshaft, so that its top dead centres do not come at the firing intervals.
pub const VR6: &str = "cycle = 'four-stroke'\nspeed = 6000\nfiring_order = '1-5-3-6-2-4'\neffects = ['firing']\n[vr]\nbank_angle = 15\npin_splay = 22\npin_offset = '12.5 mm'\n\
    spacing = '65 mm'\n[mechanism]\nstroke = '90.3 mm'\nrod_length = '164 mm'\nreciprocating_mass = '0.55 kg'\n";

/// `22° − 2 arcsin(12.5/209.15) = 15.147°` are 0.147° more than the banks are apart.
#[test]
fn firing_angles_of_displaced_axes_say_what_they_count_and_how_far_apart_the_dead_centres_are() {
    let told = said("firing", VR6, &[]);
    let moved = "from one top dead centre to the next are ≈ 119.9° to ≈ 120.1°";
    assert!(told.contains("fire unevenly") && told.contains(moved), "{told}");
    // Even by the pins, and uneven by the pistons.
    let pins = said("firing", &VR6.replace("pin_splay = 22", "pin_splay = 15"), &[]);
    assert!(pins.contains("fire evenly") && pins.contains("≈ 113.1° to ≈ 126.9°"), "{pins}");
    let page = pages::text(&pages::document(&engine(VR6)), Format::GITHUB);
    assert!(
        page.contains("from one top dead centre to the next") && !page.contains("its piston is at top dead centre"),
        "{page}"
    );
    // One offset for all moves every dead centre alike.
    let alike = engine(
        "cycle = 'four-stroke'\nfiring_order = '1-3-4-2'\n[inline]\nthrows = [0, 180, 180, 0]\n[mechanism]\nrod_ratio = '1/4'\nstroke = '80 mm'\npin_offset = '2 mm'\n",
    );
    assert!(alike.has_offset() && !alike.has_dead_centres_apart());
    let claim = parse_statement("fires evenly").expect("a claim");
    assert_eq!(claim::answer(&engine(VR6), &claim, None).status, Status::NotDecided);
    assert_eq!(claim::answer(&alike, &claim, None).status, Status::True);
}

/// `2 arcsin(12.5/209.15) = 6.853°` less than the splay the dead centres of a pair are apart.
#[test]
fn a_sweep_and_a_comparison_of_displaced_axes_say_what_firing_intervals_count() {
    let told = said("sweep", VR6, &["--set", "vr.pin_splay=15..24:1"]);
    let moved = "Offsets move the top dead centres: these are most even at 22°, ≈ 119.9° to ≈ 120.1° apart.";
    assert!(
        told.contains("Firing, counted between crankpins in line with their cylinders: even, every 120°, at 15°.")
            && told.contains(moved),
        "{told}"
    );
    // Where the offset grows from 0 the dead centres are at first those of the pins.
    let offsets = VR6.replace("pin_splay = 22", "pin_splay = 15");
    let told = said("sweep", &offsets, &["--set", "vr.pin_offset=0mm..20mm:5mm"]);
    assert!(told.contains("these are most even at 0 mm, ≈ 120.0° to ≈ 120.0° apart"), "{told}");
    // Nor is it silent where the file does not say when the cylinders fire.
    let thrown = VR6.replace("[vr]\n", "[vr]\nthrows = [0, 240, 120, 120, 240, 0]\n");
    let unsaid = thrown.replace("firing_order = '1-5-3-6-2-4'\neffects = ['firing']\n", "");
    let told = said("sweep", &unsaid, &["--set", "vr.pin_splay=15..24:1"]);
    assert!(told.contains("Offsets move the top dead centres, which come at other intervals."), "{told}");
    // Without offsets there is nothing to say.
    let centric = thrown.replace("pin_offset = '12.5 mm'\n", "");
    assert!(!said("sweep", &centric, &["--set", "vr.pin_splay=15..24:1"]).contains("Offsets move"));
    let told = said("compare", VR6, &["I6"]);
    assert!(told.contains("uneven: 113° to 127°; top dead centres: ≈ 119.9° to ≈ 120.1°"), "{told}");
}

#[test]
fn the_own_angle_of_a_cylinder_counts_from_the_dead_centre_of_its_gas() {
    let gas = |keys: &str| {
        format!(
            "[gas]\nbore = '81 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 10\npeak_pressure = '60 bar'\n{keys}"
        )
    };
    let list = |engine: &str, keys: &str| {
        let engine = self::engine(&format!("{engine}{}", gas(keys)));
        let page = TorqueStudy::new(&engine).expect("a torque").page();
        let text = pages::text(&page, Format::GITHUB);
        let counts = ["its crank points along", "its piston is farthest", "the volume between its two pistons"];
        let told = counts.map(|words| text.contains(&format!("own angle ψ is 0 where {words}")));
        (told, text)
    };
    let of = |engine: &str, keys: &str| list(engine, keys).0;
    let centric = "cycle = 'four-stroke'\nfiring_order = '1-3-4-2'\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = '90 mm'\n[mechanism]\n\
                   stroke = '86 mm'\nrod_length = '143 mm'\n";
    assert_eq!(of(centric, ""), [true, false, false]);
    assert_eq!(of(VR6, "dead_centre = 'crank'\n"), [true, false, false]);
    let opposed = "cycle = 'two-stroke'\n[opposed_piston]\nthrows = [0, 120]\nlead = 11\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\n";
    let opposed_gas = "intake_pressure = '1.5 bar'\n";
    assert_eq!(of(opposed, opposed_gas), [false, false, true]);
    assert_eq!(of(opposed, &format!("{opposed_gas}dead_centre = 'crank'\n")), [true, false, false]);
    assert_eq!(of(VR6, "dead_centre = 'piston'\n"), [false, true, false]);
    let (_, text) = list(VR6, "dead_centre = 'piston'\n");
    assert!(text.contains("| angles of the gas count from | the piston farthest out | given |"), "{text}");
    let mixed = "dead_centre = 'piston'\n[[gas.cylinder]]\ncylinders = [2, 4]\ndead_centre = 'crank'\n";
    let (told, text) = list(VR6, mixed);
    assert_eq!(told, [true, true, false]);
    assert!(text.contains("Cylinders 2, 4: ") && text.contains("Cylinders 1, 3, 5, 6: "), "{text}");
}

#[test]
fn greek_and_latin_letters_stand_in_latex_as_they_are_written() {
    let radial = "title = 'Škoda ε η Ω ∞ ł'\n[vee]\nbank_angle = 90\nthrows = [0]\n[articulated]\nmaster = 1\nknuckle_ratio = '1/4'\nknuckle_correction = 3\n[mechanism]\nrod_ratio = '1/4'\n";
    let text = pages::text(&pages::document(&engine(radial)), Format::Latex);
    assert!(!text.contains("[U+"), "{text}");
    assert!(text.contains("Škoda $\\varepsilon$ $\\eta$ $\\Omega$ $\\infty$ ł"), "{text}");
}

/// Pins that a factor is asked for, with weights that a file has beside them already.
const WEIGHTED: &str = "speed = 7000\n[inline]\nthrows = [0, 90]\nspacing = '90 mm'\n[mechanism]\nstroke = '68 mm'\nrod_length = '125 mm'\n\
    reciprocating_mass = '0.42 kg'\nrotating_mass = '0.35 kg'\n[crankshaft]\ncounterweights = { rotating = 1, reciprocating = 0.5 }\ncounterweight_radius = '40 mm'\n";

#[test]
fn a_balance_factor_takes_the_place_of_the_weights_of_the_file_or_is_refused() {
    // (0.35 + 0.3·0.42) kg · 34 mm, whatever stands in the planes of the throws before.
    let size = "16.2 kg·mm at z = 45 mm, 16.2 kg·mm at z = −45 mm.";
    let told = said("remedy", WEIGHTED, &["--reciprocating", "0.3"]);
    assert!(told.contains(&format!("by the balance factors asked for: {size}")), "{told}");
    let apart = format!("{WEIGHTED}web_offset = '22 mm'\n");
    let output = call(&["remedy", &written(&apart), "--reciprocating", "0.3"]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && error.contains("beside the planes of the throws"), "{error}");
}

#[test]
fn parts_of_masses_that_are_negative_are_not_called_balanced() {
    let light = "[[counterweight]]\nthrow = 1\nangle = 180\nmass_radius = '5 kg mm'\n";
    let bare = WEIGHTED.split("[crankshaft]").next().expect("what stands before");
    let told = said("remedy", &format!("{bare}{light}"), &[]);
    assert!(told.contains("balance not even the rotating masses") && !told.contains("balance all rotating masses and"));
    assert!(said("remedy", WEIGHTED, &[]).contains("balance all rotating masses and these parts"));
}

#[test]
fn what_a_knuckle_pin_carries_keeps_the_section_on_counterweights_alone_away() {
    let radial = "speed = 2000\neffects = ['remedy']\n[radial]\ncylinders = 3\n[articulated]\nmaster = 1\nknuckle_radius = '50 mm'\n\
        [mechanism]\nstroke = '120 mm'\nrod_length = '240 mm'\nreciprocating_mass = '2 kg'\nrotating_mass = [1, 0, 0]\n";
    let page = |layout: &str| pages::text(&pages::document(&engine(layout)), Format::GITHUB);
    assert!(page(radial).contains("where the force vanishes"));
    let with_mass = radial.replace("'50 mm'\n", "'50 mm'\nknuckle_mass = '1 kg'\n");
    assert!(!page(&with_mass).contains("where the force vanishes"), "548 N are left at f = 1/2");
}

/// The table of an order with offsets below 0 adds up: what is multiplied by −1 says so.
#[test]
fn a_star_with_offsets_below_zero_shows_the_weights_that_its_sum_has() {
    let text = "[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\npin_offset = ['8 mm', '-8 mm']\nreciprocating_mass = '0.5 kg'\n\
        [inline]\nthrows = [0, 180]\nspacing = '90 mm'\n";
    let page = pages::text(&pages::document(&engine(&format!("orders = [3]\n{text}"))), Format::GITHUB);
    assert!(page.contains("| 2 | 180° | −45 | −1 |"), "{page}");
    assert!(page.contains("A vector with a negative weight is drawn turned"));
    assert!(page.contains("in odd orders above 1 its term is multiplied by −1"));
}

#[test]
fn every_order_of_the_roll_moment_that_stands_out_is_named_in_the_box() {
    let twin = "speed = 5500\neffects = ['torque']\n[vee]\nbank_angle = 45\nthrows = [22.5]\nspacing = '1 in'\n[mechanism]\nstroke = '4.375 in'\n\
        rod_length = '7.667 in'\nreciprocating_mass = ['1.62 lb', '1.66 lb']\n";
    let page = pages::text(&pages::document(&engine(twin)), Format::GITHUB);
    assert!(page.contains("(order 2), ") && page.contains("(order 3); smaller at order 1."), "{page}");
}

#[test]
fn what_counterweights_leave_is_told_of_force_and_moment_where_the_parts_differ() {
    let w = "cycle = 'four-stroke'\n[w]\nbank_angle = 72\nnarrow_angle = 15\nthrows = [0, 90, 270, 180]\npin_split = 18\nbank_offset = '1/5'\n";
    let told = said("classify", w, &[]);
    assert!(told.contains("leave 100 % of the force and 3"), "{told}");
}

#[test]
fn stars_that_are_equally_good_are_all_counted() {
    let told = printed(&["search", "--cylinders", "5", "--cycle", "four-stroke"]);
    assert!(told.contains("24 of the 24 crank stars are the best, with 8 different sets of values"), "{told}");
}

/// With infinitely long rods force and moment have order 1 alone, whatever the sums of the others would be.
#[test]
fn of_infinitely_long_rods_no_order_above_1_is_called_left() {
    let yoke = "inline.throws = [0, 180, 180, 0]\nmechanism.scotch_yoke = true\n";
    let told = said("classify", yoke, &[]);
    assert!(told.contains("All other orders. No force or moment."), "{told}");
    assert!(checked(yoke, "forces vanish at every order").contains("true."));
    let document = printed(&["classify", &written(yoke), "--all-orders", "--json"]);
    assert!(read_document(document.as_bytes()).is_ok_and(|document| document.check().is_ok()), "{document}");
}

/// A weight in one plane would be at z = 28.7 m.
#[test]
fn weights_of_a_remedy_are_between_the_ends_of_the_engine() {
    let four = "speed = 6000\ninline = { throws = [0, 180, 180, 0], spacing = '96 mm' }\n[mechanism]\nstroke = '86 mm'\nrod_length = '146 mm'\n\
        reciprocating_mass = ['0.560 kg', '0.55 kg', '0.55 kg', '0.5401 kg']\n";
    let found = remedy(&engine(four), &Request { orders: vec![1, 2], ..Request::default() }).expect("a remedy");
    assert!(found.holds() && found.crankshaft.as_ref().is_some_and(|weights| weights.weights.len() == 2));
    let end = BigRational::new(144.into(), 1000.into());
    assert!(found.weights().iter().all(|weight| weight.position.abs() <= end));
}

const WITH_SHAFTS: &str = "speed = 6000\ninline = { throws = [0, 180, 180, 0], spacing = '96 mm' }\n[mechanism]\nstroke = '86 mm'\n\
    rod_length = '146 mm'\nreciprocating_mass = '0.55 kg'\n\
    [[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '0.0045 kg m'\nangle = 180\nposition = '60 mm'\n\
    [[balancer]]\norder = 2\nsense = 'against'\nmass_radius = '0.0045 kg m'\nangle = 180\nposition = '60 mm'\n";

/// The shafts of order 2 are not multiplied by λ, and their moment is not that of the pistons.
#[test]
fn what_is_said_of_pistons_is_not_said_of_the_balancer_shafts_beside_them() {
    let page = pages::text(&pages::document(&engine(WITH_SHAFTS)), Format::GITHUB);
    assert!(!page.contains("c_2 = \\lambda}"), "the first term alone");
    assert!(said("classify", WITH_SHAFTS, &[]).contains("so that the pistons' moments of all orders vanish"));
    let told = checked(WITH_SHAFTS, "second-order moment vanishes");
    assert!(told.contains("the claim is false of all masses"), "{told}");
    let told = checked(WITH_SHAFTS, "second-order force = 2964 N ± 1 %");
    assert!(told.contains("of all masses the claim is not decided"), "{told}");
}

/// What turns against the reference can be counterweights on the crankshaft that does.
#[test]
fn no_shaft_is_asked_for_what_another_crankshaft_can_carry() {
    let h = "speed = 5000\n[h]\nthrows = [0, 180]\nsense = 'against'\nphase = 90\ndistance = '250 mm'\nspacing = '120 mm'\n\
        [mechanism]\nstroke = '80 mm'\nrod_length = '150 mm'\nreciprocating_mass = '0.6 kg'\nrotating_mass = '0.5 kg'\n";
    assert!(said("classify", h, &[]).contains("added on crankshaft lower"));
    let told = checked(h, "order 1 needs counterweights alone");
    assert!(told.contains("true. Order 1 needs counterweights"), "{told}");
    assert!(printed(&["compare", &written(h), "I4"]).contains("on crankshaft lower"));
}

#[test]
fn one_cylinder_needs_no_firing_order() {
    let told = said("firing", "cycle = 'four-stroke'\ninline.throws = [0]\n", &[]);
    assert!(told.contains("The one cylinder fires every 720°."), "{told}");
}

/// A claim about a layout, answered.
pub fn checked(layout: &str, says: &str) -> String {
    let folder = scratch("true-sentences");
    std::fs::write(folder.join("layout.toml"), layout).expect("a layout");
    let claims =
        format!("[[statement]]\ntext = 'a claim'\n[[statement.claim]]\nlayout = 'layout.toml'\nsays = '{says}'\n");
    let path = folder.join("claims.toml");
    std::fs::write(&path, claims).expect("claims");
    let output = call(&["check", path.to_str().expect("UTF-8")]);
    String::from_utf8_lossy(&output.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A plane in millimetres is one of metres, in a file that has no other position with a unit.
#[test]
fn planes_in_millimetres_have_their_unit_in_every_engine() {
    let output = call(&["remedy", "examples/radial.toml", "--planes", "-30mm,30mm"]);
    let said = String::from_utf8(output.stdout).expect("a text").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("at z = −30 mm") && said.contains("at z = 30 mm"), "{said}");
    let alike = call(&["remedy", "examples/radial.toml", "--planes", "30mm,0.03m"]);
    assert!(String::from_utf8_lossy(&alike.stderr).contains("both planes are at 30 mm"), "{alike:?}");
}

/// A pair of shafts at crank speed beside one cylinder, each on its side of the crankshaft.
const PAIR: &str = "speed = 3000\norders = [1, 2]\neffects = ['torque']\n[inline]\nspacing = '100 mm'\nthrows = [0]\n\
    [mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\n\
    [[balancer]]\norder = 1\nsense = 'with'\nmass_radius = '3 kg mm'\nangle = 180\nposition = '0 mm'\nheight = '0 mm'\noffset = '90 mm'\n\
    [[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '3 kg mm'\nangle = 180\nposition = '0 mm'\nheight = '0 mm'\noffset = '-90 mm'\n";

#[test]
fn a_shaft_that_turns_with_the_crank_is_no_counterweight_and_keeps_its_axis() {
    let found = remedy(&engine(PAIR), &Request { orders: vec![1], ..Request::default() }).expect("a remedy");
    let text = corrected_file(&found, "pair.toml", FileResolver::nothing()).expect("a layout").text;
    let corrected = engine(&text);
    let axes: Vec<bool> = corrected.crankshaft().balancers.iter().map(|shaft| shaft.axis.is_some()).collect();
    assert_eq!(axes, [true, true], "{text}");
    assert_eq!(corrected.crankshaft().counterweights.len(), 1, "{text}");
    let told = said("remedy", PAIR, &["--orders", "1"]);
    assert!(told.contains("counterweight 1×, with 0 7.00 kg·mm"), "{told}");
}

#[test]
fn weights_of_one_order_on_two_axes_are_two_shafts_and_a_new_one_takes_the_axis_of_its_shaft() {
    let two = PAIR.replace("order = 1\nsense = 'with'", "order = 2\nsense = 'with'");
    let two = two.replace("order = 1\nsense = 'against'", "order = 2\nsense = 'with'");
    let two =
        two.replacen("position = '0 mm'", "position = '50 mm'", 1).replacen("throws = [0]", "throws = [0, 90]", 1);
    let told = said("remedy", &two, &["--orders", "2"]);
    assert!(told.contains("The weights called shaft 1 are on 2 axes in the file"), "{told}");
    let one =
        two.replacen("position = '0 mm'", "position = '50 mm'", 1).replacen("offset = '-90 mm'", "offset = '90 mm'", 1);
    let found = remedy(&engine(&one), &Request { orders: vec![2], ..Request::default() }).expect("a remedy");
    let text = corrected_file(&found, "one.toml", FileResolver::nothing()).expect("a layout").text;
    let corrected = engine(&text);
    let with: Vec<_> = corrected.crankshaft().balancers.iter().filter(|shaft| shaft.sense == Sense::Direct).collect();
    assert!(with.len() > 1 && !said("remedy", &one, &["--orders", "2"]).contains("called shaft"), "{text}");
    assert!(with.iter().all(|shaft| shaft.axis.is_some()), "{text}");
}

#[test]
fn no_load_is_told_of_one_rod_where_links_hang_on_it() {
    let fan = "speed = 2400\nbearings = ['60 mm', '-60 mm']\n[fan]\nbanks = [-60, 0, 60]\nthrows = [0]\npositions = ['0 mm']\n\
        [mechanism]\ncrank_radius = '60 mm'\nrod_length = '200 mm'\nreciprocating_mass = '1.3 kg'\n\
        [articulated]\nmaster = [2]\nknuckle_radius = '50 mm'\nlink_length = '154 mm'\n";
    let page = |layout: &str| {
        let folder = scratch("one-rod");
        let output = call(&["bearings", written(layout).as_str(), "--output", folder.to_str().expect("UTF-8")]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        std::fs::read_to_string(folder.join("bearings.md")).expect("a page")
    };
    let plain = fan.split("[articulated]").next().expect("a layout");
    assert!(page(plain).contains("## Crankpins") && !page(fan).contains("## Crankpins"));
    assert!(page(fan).contains("## Articulated rods"));
    // Nor is it drawn.
    let gas = "cycle = 'four-stroke'\nfiring_angles = [0, 60, 480]\neffects = ['gas']\n";
    let gas = format!(
        "{gas}{fan}[gas]\nbore = '100 mm'\ndead_centre = 'crank'\npressure = [[0, '40 bar'], [180, '2 bar'], [540, '1 bar'], [720, '40 bar']]\n"
    );
    let folder = scratch("one-rod-drawn");
    let output = call(&["bearings", written(&gas).as_str(), "--output", folder.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let drawn = std::fs::read_to_string(folder.join("shared-pin-1-crank.svg")).expect("a drawing");
    assert!(drawn.contains("Crankpin 1") && !drawn.contains("cylinder 1"), "{drawn}");
}

const FAN: &str = "speed = 2000\n[fan]\nbanks = [-60, 0, 60]\nthrows = [0, 240, 120]\nspacing = '150 mm'\n\
    [mechanism]\nstroke = '150 mm'\nrod_length = '280 mm'\nreciprocating_mass = [2, 2, 2, 2.1, 2, 2, 2, 2, 1.9]\n";

#[test]
fn a_speed_that_is_swept_has_its_unit() {
    let swept = ["--speed", "500..2000:500"];
    let told = said("sweep", FAN, &swept);
    assert!(told.contains("speed from 500 rpm to 2000 rpm") && told.contains(" at 2000 rpm."), "{told}");
    let page = said("sweep", FAN, &[&swept[..], &["--format", "html"]].concat());
    assert!(page.contains("speed in rpm</th>") && page.contains(">speed in rpm<"), "{page}");
    let german = said("sweep", FAN, &[&swept[..], &["--format", "html", "--lang", "de"]].concat());
    assert!(german.contains("Drehzahl in 1/min</th>") && german.contains(">größter</th>"), "{german}");
}

#[test]
fn an_angle_that_is_swept_is_in_degrees_and_a_length_in_its_unit() {
    let vee = "[vee]\nbank_angle = 90\nthrows = [0, 90]\nspacing = '90 mm'\n";
    let told = said("sweep", vee, &["--set", "vee.pin_split=0..30:15", "--lang", "de"]);
    assert!(told.contains("Hubzapfenversatz durchlaufen") && told.contains("von 0° bis 30°"), "{told}");
    let told = said("sweep", vee, &["--spacing", "80..120:20 mm", "--lang", "de"]);
    assert!(told.contains("Zylinderabstand durchlaufen") && told.contains("bis 120 mm"), "{told}");
}

#[test]
fn a_pure_couple_rolls_nothing_wherever_its_axis_is() {
    let delta = "cycle = 'two-stroke'\nspeed = 1500\neffects = ['remedy']\n[delta]\nrows = [0, 120, 240, 60, 180, 300]\ncircumradius = '500 mm'\n\
        spacing = '250 mm'\n[mechanism]\nstroke = '184 mm'\nrod_length = '380 mm'\nreciprocating_mass = 8\nrotating_mass = 5\n";
    let told = said("remedy", delta, &[]);
    assert!(told.contains("Force, moment and roll moment do not depend on where its axis is."), "{told}");
    let one = "speed = 1500\neffects = ['remedy']\n[u]\nthrows = [0]\nsense = 'against'\ndistance = '110 mm'\n[mechanism]\n\
        stroke = '54 mm'\nrod_length = '104 mm'\nreciprocating_mass = 1\n";
    let told = said("remedy", one, &[]);
    assert!(told.contains("Force and moment do not depend on where its axis is, the roll moment does."), "{told}");
}

#[test]
fn arrows_are_resultants_of_crankshafts_where_all_of_a_drawing_are() {
    let h = "[h]\nthrows = [0, 90, 270, 180]\nsense = 'against'\ndistance = 5\nphase = 45\n";
    let told = said("report", h, &["--format", "markdown"]);
    assert!(told.contains("An arrow with the name of a crankshaft is its resultant."), "{told}");
    assert!(!told.contains("Each arrow is the resultant"), "{told}");
}

#[test]
fn a_pair_whose_heights_are_not_told_adds_to_the_roll_moment() {
    let one = "speed = '100 Hz'\neffects = ['remedy']\n[inline]\nthrows = ['23.45678']\n[mechanism]\nstroke = '2.5 in'\n\
        rod_length = '4.25 in'\npin_offset = '0.05 in'\npiston_mass = '10 oz'\npin_mass = '3 oz'\nrod_mass = '1 lb'\nrod_centre = '1.2 in'\n";
    let told = said("remedy", one, &[]);
    assert!(!told.contains("Lanchester pair of order 2: where"), "{told}");
    assert!(told.contains("shaft 2 with") && told.contains("shaft 3 with"), "{told}");
    let told = said("remedy", &one.replace("pin_offset = '0.05 in'\n", ""), &[]);
    assert!(told.contains("Lanchester pair of order 2: where") && !told.contains("shaft 2 with"), "{told}");
}

#[test]
fn a_scotch_yoke_has_no_rod() {
    let yoke = "speed = 1500\neffects = ['torque', 'remedy']\n[inline]\nthrows = [0]\n[mechanism]\nscotch_yoke = true\nstroke = '50 mm'\n\
        reciprocating_mass = '0.3 kg'\nrotating_mass = '0.2 kg'\n";
    let told = said("report", yoke, &["--format", "markdown"]);
    for rod in ["how the rod", "big end", "rods, pistons", "l\\sqrt", "rod ratio r/l", "equal rods", "orders 1 |"] {
        assert!(!told.contains(rod), "{rod}: {told}");
    }
    assert!(told.contains("| order 1 |") && told.contains("cannot replace this shaft: they act"), "{told}");
    assert!(said("report", yoke, &["--lang", "de", "--format", "markdown"]).contains("| Ordnung 1 |"));
}

#[test]
fn an_order_0_of_links_is_told_as_theirs() {
    let links = "speed = 2000\nbearings = ['0.1 m', '-0.1 m']\n[radial]\ncylinders = 7\n[mechanism]\nstroke = '150 mm'\n\
        rod_length = '280 mm'\nreciprocating_mass = 2\n[articulated]\nmaster = '1'\nknuckle_radius = '60 mm'\nlink_length = '220 mm'\n";
    let told = said("bearings", links, &["--format", "markdown"]);
    assert!(told.contains("pistons with an offset or with links on their rods"), "{told}");
}

#[test]
fn no_code_is_quoted_with_signs_of_one_format() {
    let mounted = "speed = 1000\n[inline]\nthrows = [0, 180]\nspacing = '90 mm'\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\n\
        reciprocating_mass = 0.5\n[block]\nmass = 60\ninertia = [2, 2, 1]\ncentre = [0, 0, 0]\n[[mount]]\nplace = [0.2, 0, 0]\nstiffness = 200000\n\
        [[mount]]\nplace = [-0.2, 0, 0.1]\nstiffness = 200000\n[[mount]]\nplace = [0, -0.2, 0.1]\nstiffness = 200000\n";
    assert!(!said("mounts", mounted, &["--format", "html"]).contains("`loads`"));
}

#[test]
fn headings_have_the_units_of_what_is_below() {
    let unequal = "[inline]\nthrows = [0, 180]\nspacing = '90 mm'\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = [1, 1.05]\n";
    assert!(said("report", unequal, &["--format", "markdown"]).contains("| Reciprocating mass / m |"));
    let open = "values = { a = '22 mm' }\n[vee]\nbank_angle = 'phi'\nthrows = [0, 180]\npositions = ['3a', '-3a']\n";
    assert!(said("report", open, &["--format", "markdown"]).contains("| Position z (m) |"));
}

#[test]
fn lines_of_verify_are_of_at_most_80_columns() {
    let path = written("title = 'Two'\n[inline]\nthrows = [0, 180]\nspacing = '90 mm'\n");
    let document = scratch("true-sentences").join("document.json");
    std::fs::write(&document, call(&["classify", &path, "--json"]).stdout).expect("a document");
    let output = call(&["verify", document.to_str().expect("UTF-8")]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(told.contains("not covered") && told.lines().all(|line| line.chars().count() <= 80), "{told}");
}

#[test]
fn effects_are_included_where_their_numbers_stand_on_the_page() {
    let gas = "speed = 3000\ncycle = 'four-stroke'\neffects = ['gas']\nbearings = [1, -1]\n[mechanism]\nstroke = '90 mm'\nrod_length = '150 mm'\n\
        reciprocating_mass = '0.5 kg'\n[gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 10\nmean_pressure = '10 bar'\n\
        [inline]\nthrows = [0, 180, 180, 0]\nspacing = '90 mm'\n";
    let silent = said("report", gas, &["--format", "markdown"]);
    assert!(silent.contains("No torque: "), "{silent}");
    assert!(silent.contains("| gas | no | asked for; its section says what is missing |"), "{silent}");
    let fired = format!("firing_order = '1-3-4-2'\n{gas}");
    let told = said("report", &fired, &["--format", "markdown"]);
    assert!(told.contains("| gas | yes | asked for, in a section of its own |"), "{told}");
    assert!(told.contains("| main bearings | yes |") && told.contains("## Main bearings"), "{told}");
    let loads = said("loads", &fired, &["--format", "markdown"]);
    let effects = loads.split("Effects included").nth(1).expect("a table");
    assert!(!effects.contains("| gas |") && !effects.contains("| main bearings |"), "{effects}");
}

#[test]
fn a_peak_that_is_a_short_number_is_told_by_it_and_one_at_rest_as_a_multiple() {
    let single = "[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.25\n";
    let told = said("accuracy", single, &[]);
    assert!(told.contains("The peak is within 10⁻") && told.contains(" of 1.25, in multiples of m r ω²."), "{told}");
    assert!(told.contains("Certain digits in multiples of m r² ω²: 0.63088388865920467195…"), "{told}");
    let rest = "speed = 0\n[inline]\nthrows = [0, 180, 180, 0]\n[mechanism]\nreciprocating_mass = 1\ncrank_radius = 0.04\nrod_length = 0.14\n";
    let told = said("accuracy", rest, &[]);
    assert!(told.contains("Peak force, λ = 2/7: 1.19 m r ω².") && !told.contains("0 N"), "{told}");
}

/// Cranks of the second one and the third carry weights at order 2, one in each sense.
const THREE_CRANKS: &str = "[[crankshaft]]\nname = 'a'\nsense = 'with'\noffset = 0\n\
    [[crankshaft]]\nname = 'b'\nsense = 'against'\nspeed = 2\noffset = 4\n\
    [[crankshaft]]\nname = 'c'\nsense = 'with'\nspeed = 2\noffset = -4\n\
    [[cylinder]]\ncrankshaft = 'a'\nthrow = 0\nbank = 0\nposition = 0\n\
    [[cylinder]]\ncrankshaft = 'b'\nthrow = 0\nbank = 0\nposition = 1\n\
    [[cylinder]]\ncrankshaft = 'c'\nthrow = 90\nbank = 0\nposition = 2\n\
    [mechanism]\nrod_ratio = 0.3\n";

#[test]
fn every_crankshaft_that_can_carry_a_weight_saves_a_shaft() {
    let told = said("remedy", THREE_CRANKS, &[]);
    let fewest = "Besides what turns on those crankshafts, the number of balancer shafts still needed is 3. Fewer are not possible";
    assert!(told.contains(fewest), "{told}");
    let told = said("classify", THREE_CRANKS, &[]);
    assert!(
        told.contains("Order 2: counterweights added on crankshaft c (0.559 m r + 0.288 m r, 2 a apart) leave 50 %; with counterweights added on crankshaft b"),
        "{told}"
    );
    let one = THREE_CRANKS.replace("throw = 90", "throw = 0").replace("speed = 2\noffset = -4", "offset = -4");
    let told = said("remedy", &one, &[]);
    assert!(told.contains("Besides what turns on that crankshaft,"), "{told}");
}

#[test]
fn a_quantity_that_vanishes_at_all_other_orders_has_no_bound_there() {
    let halves = "speed = 4344\n[inline]\nthrows = [120, 300]\nspacing = '0.17 m'\n[mechanism]\ncrank_radius = '58 mm'\n\
        rod_length = '137.3 mm'\nreciprocating_mass = '1.85 kg'\n";
    let told = said("classify", halves, &[]);
    assert!(told.contains("All other forces 6, … ≤ 0.0570 kN") && !told.contains("All other moments"), "{told}");
    let told = said("classify", &halves.replace("speed = 4344\n", ""), &[]);
    assert!(told.contains("Order 6 and all others.") && !told.contains("% of the largest moment"), "{told}");
}

#[test]
fn of_the_roll_moment_of_geared_cranks_only_orders_that_were_looked_at_have_a_bound() {
    let square = "speed = 3000\neffects = ['torque']\n[square_four]\nin_phase = 'sides'\nsense = 'with'\ndistance = '0.3 m'\nspacing = '0.06 m'\n\
        [mechanism]\ncrank_radius = '80 mm'\nrod_length = '400 mm'\nreciprocating_mass = ['4 kg', '2 kg', '2 kg', '2 kg']\n";
    let told = said("classify", square, &[]);
    assert!(told.contains("Roll moment 6 ≤ 0.990 N·m") && !told.contains("All other roll moments"), "{told}");
    let fifth = said("values", square, &["--value", "loads.roll.5.zero_to_peak"]);
    assert!(fifth.contains("1.640"), "{fifth}");
}

#[test]
fn a_roll_moment_that_vanishes_is_zero_at_no_order_and_said_to_be_balanced() {
    let yoke = "effects = ['torque']\n[inline]\nthrows = [0, 90]\nspacing = '0.1 m'\n[mechanism]\ncrank_radius = '40 mm'\nscotch_yoke = true\n";
    assert!(said("classify", yoke, &[]).contains("Balanced, proved. Inertia roll moment: all orders examined."));
    let told = printed(&["compare", &written(yoke), &written(yoke)]);
    assert!(told.matches("Roll moment 0").count() == 2 && !told.contains("(order"), "{told}");
}

#[test]
fn decimals_against_links_leave_little_wherever_moments_are_taken_about() {
    let radial = "reference_plane = '0.1 m'\n[radial]\ncylinders = 7\n[articulated]\nmaster = 1\nknuckle_radius = '50 mm'\n\
        [mechanism]\ncrank_radius = '70 mm'\nrod_length = '230 mm'\nreciprocating_mass = '2 kg'\n";
    let corrected = scratch("true-sentences").join("corrected.toml");
    let told = said("remedy", radial, &["--orders", "2", "--write", corrected.to_str().expect("UTF-8")]);
    assert!(told.contains("Written:") && corrected.is_file(), "{told}");
}

const MASSLESS: &str = "cycle = 'two-stroke'\nspeed = 1000\nbearings = ['0.17 m', '0.05 m', '-0.05 m', '-0.15 m']\neffects = ['gas']\nfiring_order = '1-2-3'\n\
    [inline]\nspacing = '0.1 m'\n[mechanism]\nstroke = '90 mm'\nrod_length = '150 mm'\nreciprocating_mass = 0\n\
    [gas]\nbore = '80 mm'\nunit = 'bar'\npressure = [[-180, 7.1], [0, 60], [90, 11], [180, 7.1]]\n";

#[test]
fn masses_of_0_load_no_bearing_and_turn_no_crank() {
    let told = said("bearings", MASSLESS, &[]);
    assert!(told.contains("31.5 kN by the gas and 0 N by the masses."), "{told}");
    let still = MASSLESS.replace("[[-180, 7.1], [0, 60], [90, 11], [180, 7.1]]", "[[0, 1.01325], [360, 1.01325]]");
    let told = said("torque", &still, &[]);
    assert!(told.contains("Neither gas nor masses turn the crank.") && !told.contains("≈ 0°"), "{told}");
}

#[test]
fn no_coefficient_of_fluctuation_is_told_of_a_shaft_that_stops() {
    let engine = "cycle = 'four-stroke'\nspeed = 60\nfiring_angles = [0]\n[inline]\nthrows = [0]\n[mechanism]\nstroke = '86 mm'\n\
        rod_length = '143 mm'\nreciprocating_mass = '0.5 kg'\n[gas]\nbore = '86 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 10\n\
        heat = '1100 J'\n[flywheel]\ninertia = '0.5 kg m²'\n";
    let stops = "the crank stops within a cycle";
    let told = said("torque", engine, &[]);
    assert!(told.contains(stops) && !told.contains("26.3"), "{told}");
    assert!(!said("torque", &engine.replace("speed = 60\n", "speed = 600\n"), &[]).contains(stops));
    let diagram = "speed = '2 rpm'\ninertia = 3\npoints = [[0, 300], [90, 500], [270, -100], [360, 300]]\n";
    let told = said("flywheel", diagram, &[]);
    assert!(told.contains("the shaft stops within a cycle at 2 rpm") && !told.contains('±'), "{told}");
    assert!(said("flywheel", &diagram.replace("2 rpm", "200 rpm"), &[]).contains('±'));
}

#[test]
fn torques_that_cancel_at_an_angle_leave_no_rounding() {
    let told = printed(&["angle", "reports/examples/v8-gas/layout.toml", "--at", "0,180"]);
    assert_eq!(told.matches("≈ 648.2 ≈ 0 ≈ 648.2").count(), 2, "{told}");
}
