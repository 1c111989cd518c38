//! Sentences that were false of unusual engines: at rest, with yokes, needless shafts, faster crankshafts, several lengths, unequal cylinders.

use crate::support::program::call;
use crate::true_sentences::{printed, said, written};

const SINGLE: &str = "speed = 3000\ninline = { throws = [0] }\n\
    mechanism = { stroke = '80 mm', rod_length = '140 mm', reciprocating_mass = '0.5 kg', rotating_mass = '0.3 kg' }\n";
const AT_REST: &str = "speed = 0\ncycle = 'four-stroke'\nfiring_order = '1-3-4-2'\neffects = ['gas']\nbearings = ['0.2 m', '0.1 m', 0, '-0.1 m', '-0.2 m']\n\
    inline = { throws = [0, 180, 180, 0], spacing = '100 mm' }\n\
    mechanism = { stroke = '86 mm', rod_length = '146 mm', reciprocating_mass = '0.5 kg', rotating_mass = '0.3 kg' }\n\
    gas = { bore = '86 mm', process = 'spark-ignition', compression_ratio = 10, mean_pressure = '9 bar' }\n";
/// Two singles side by side, the second of `SPEED` times the speed of the first.
const GEARED: &str = "speed = 1000\nbearings = ['0.1 m', '-0.1 m']\n\
    [[crankshaft]]\nname = 'slow'\nsense = 'with'\noffset = '100 mm'\n\
    [[crankshaft]]\nname = 'fast'\nsense = 'with'\nspeed = SPEED\noffset = '-100 mm'\n\
    [mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\nrotating_mass = '0.2 kg'\n\
    [[cylinder]]\ncrankshaft = 'slow'\nthrow = 0\nbank = 0\nposition = 0\n\
    [[cylinder]]\ncrankshaft = 'fast'\nthrow = 30\nbank = 0\nposition = '10 mm'\n";
const TWO_STROKE: &str = "speed = 1000\ncycle = 'two-stroke'\neffects = ['gas']\ninline = { throws = [0] }\n\
    mechanism = { stroke = '80 mm', rod_length = '140 mm', reciprocating_mass = '0.5 kg' }\n\
    gas = { bore = '80 mm', process = 'diesel', compression_ratio = 16, intake_pressure = '1.4 bar', heat = '500 J' }\n";
const ONE_COLD: &str = "speed = 3000\ncycle = 'four-stroke'\nfiring_order = '1-2'\neffects = ['gas']\n\
    inline = { throws = [0, 0], spacing = '90 mm' }\n\
    mechanism = { stroke = '80 mm', rod_length = '140 mm', reciprocating_mass = '0.5 kg' }\n\
    [gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 9\nmean_pressure = '9 bar'\n\
    [[gas.cylinder]]\ncylinders = [2]\nheat = 0\n";

#[track_caller]
fn tells(text: &str, told: &[&str], untold: &[&str]) {
    for words in told {
        assert!(text.contains(words), "`{words}` is not in: {text}");
    }
    for words in untold {
        assert!(!text.contains(words), "`{words}` is in: {text}");
    }
}

/// A crankshaft that turns against the first has counterweights that change the reverse vector; so have balancer shafts.
#[test]
fn what_counterweights_alone_do_is_told_where_they_change_the_direct_vector_alone() {
    let twin =
        SINGLE.replace("inline = { throws = [0] }", "u = { throws = [0], sense = 'against', distance = '120 mm' }");
    let shaft = "[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '10 kg mm'\nangle = 180\nposition = 0\n";
    for layout in [twin, format!("{SINGLE}{shaft}")] {
        tells(&said("remedy", &layout, &["--format", "text"]), &["The weights"], &["Counterweights alone"]);
    }
    tells(&said("remedy", SINGLE, &["--format", "text"]), &["Counterweights alone"], &[]);
}

#[test]
fn the_coefficients_of_a_faster_crankshaft_are_of_its_own_orders() {
    let told = said("bearings", &GEARED.replace("SPEED", "2"), &["--format", "markdown"]);
    tells(&told, &["3.3 $`c_{2}`$"], &["3.3 $`c_{4}`$"]);
    let offset = SINGLE.replace("stroke =", "pin_offset = '-2.5 mm', stroke =");
    let told = said("bearings", &format!("bearings = ['40 mm', '-35 mm']\n{offset}"), &["--format", "text"]);
    tells(&told, &["u₁"], &["rods differ"]);
}

#[test]
fn at_rest_nothing_shakes_and_no_bearing_is_loaded_by_masses() {
    tells(&said("classify", AT_REST, &[]), &["m r ω² (order 2)"], &["at 0 rpm"]);
    tells(&said("bearings", AT_REST, &[]), &["Without gas no load is on a bearing."], &["0.000 N", "bearings ."]);
    let masses = AT_REST.replace("effects = ['gas']\n", "");
    tells(&said("bearings", &masses, &[]), &["No bearing carries a force: 0 exactly"], &["worst", "≈ 0"]);
    tells(&said("compare", &masses, &["I4"]), &["0 in all"], &["≈ 0 "]);
    let multiples = said("compare", &masses, &["examples/four.toml"]);
    tells(&multiples, &["the stroke and a speed above 0 of true-sentences"], &[]);
    let weights = "[crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = '50 mm'\nweb_offset = '20 mm'\n";
    let still = call(&["optimise", &written(&format!("{masses}{weights}"))]);
    assert_eq!(still.status.code(), Some(1), "{still:?}");
    tells(&String::from_utf8_lossy(&still.stderr), &["at a speed of 0", "`speed` above 0, or none"], &[]);
}

#[test]
fn a_steady_torque_accelerates_nothing_and_a_mean_of_0_gives_no_power() {
    let steady = "speed = 100\nirregularity = '2 %'\npoints = [[0, 300], [720, 300]]\nangles = [10]\n";
    tells(&said("flywheel", steady, &["--format", "text"]), &[], &["NaN"]);
    let none = "speed = 100\ninertia = 1\npoints = [[0, 0], [90, 100], [270, -100], [360, 0]]\n";
    tells(&said("flywheel", none, &[]), &["At 100 rpm: 0 kW."], &["0.000"]);
}

#[test]
fn a_needless_shaft_is_taken_away_and_none_is_added() {
    let six = "speed = 3000\ninline = { throws = [0, 120, 240, 240, 120, 0], spacing = '0.1 m' }\n\
               mechanism = { crank_radius = '43 mm', rod_length = '150 mm', reciprocating_mass = '0.5 kg' }\n\
               [[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '1 kg mm'\nangle = 0\nposition = 0\nheight = 0\noffset = 0\n";
    tells(&said("report", six, &[]), &["the removal of a shaft against the crank leaves nothing"], &["(removed)"]);
    tells(
        &said("remedy", six, &["--format", "text"]),
        &["With these changes force and moment vanish"],
        &["The weights -"],
    );
}

#[test]
fn cylinders_whose_turning_masses_differ_are_not_alike_and_faster_crankshafts_have_odd_orders() {
    let unequal = SINGLE.replace("[0]", "[0, 180], spacing = '0.1 m'").replace("'0.3 kg'", "['0.3 kg', '0.9 kg']");
    tells(
        &said("loads", &unequal, &["--format", "markdown"]),
        &["masses, radii, rods or offsets differ"],
        &["all are alike"],
    );
    let geared = said("loads", &GEARED.replace("SPEED", "3"), &["--format", "markdown"]);
    tells(&geared, &[], &["no odd orders but 1"]);
    let shaft = "[[balancer]]\norder = 3\nsense = 'with'\nmass_radius = '1 kg mm'\nangle = 0\nposition = 0\n";
    let told = said("loads", &format!("{SINGLE}{shaft}"), &["--format", "markdown"]);
    tells(&told, &["orders 1, 2, 4, 6"], &["no odd orders but 1"]);
}

#[test]
fn an_order_of_the_torque_that_some_pistons_lack_is_told_of_these() {
    let rods = "speed = 2000\neffects = ['torque']\ninline = { throws = [0, 180], spacing = '60 mm' }\n\
                mechanism = { stroke = '60 mm', rod_ratio = [0, '1/4'], reciprocating_mass = '0.5 kg' }\n";
    let told = said("report", rods, &["--format", "text"]);
    tells(&told, &["Order 3 (cylinder 1): the order does not exist."], &["Order 3: the order does not exist."]);
}

#[test]
fn the_torque_of_several_classes_is_no_single_star_and_a_two_stroke_has_no_exhaust_pressure() {
    let told = said("torque", ONE_COLD, &["--format", "text"]);
    tells(
        &told,
        &["The cylinders are of several classes", "where it is not given"],
        &["the harmonic of one cylinder times"],
    );
    let told = said("torque", TWO_STROKE, &["--format", "text"]);
    tells(
        &told,
        &["where the pressure falls to that of the intake."],
        &["exhaust and, in 20°", "where it is not given"],
    );
}

#[test]
fn nothing_is_said_of_rods_where_yokes_push_the_crankpins() {
    let yokes = "speed = 3000\neffects = ['gas']\ncycle = 'four-stroke'\nfiring_order = '1-2'\nbearings = ['60 mm', '-60 mm']\n\
                 boxer = { throws = [0], stagger = '40 mm' }\nmechanism = { stroke = '70 mm', scotch_yoke = true, reciprocating_mass = '0.5 kg' }\n\
                 gas = { bore = '70 mm', process = 'spark-ignition', compression_ratio = 9, mean_pressure = '9 bar' }\n";
    let told = said("bearings", yokes, &["--format", "text"]);
    tells(&told, &["The yokes of cylinders 1, 2", "A Scotch yoke pushes its crankpin"], &["rod ", "rods "]);
    tells(&said("torque", yokes, &["--format", "text"]), &[], &["connecting rod"]);
}

#[test]
fn axes_that_miss_the_crankshaft_and_banks_alike_are_told_of_those_that_are() {
    let three = "inline = { throws = [0, 120, 240], spacing = '60 mm' }\n\
                 mechanism = { stroke = '60 mm', rod_length = '120 mm', pin_offset = ['2 mm', 0, 0], reciprocating_mass = '0.5 kg' }\n";
    tells(&said("report", three, &["--format", "text"]), &["Cylinder axes miss"], &["The cylinder axes miss"]);
    let banks = "vee = { bank_angle = 90, throws = [0, 120, 240], bank_offset = '38.1 mm', spacing = '100 mm', pin_offset = ['1 mm', '-1 mm'] }\n\
                 mechanism = { stroke = '86 mm', rod_length = '150 mm', reciprocating_mass = '0.6 kg' }\n";
    let told = said("report", banks, &["--format", "text"]);
    tells(
        &told,
        &["at every order the sum of the force is the star of one bank"],
        &["at every order the sum is the star"],
    );
}

#[test]
fn a_roll_moment_that_is_slight_beside_one_pistons_is_not_what_shakes() {
    let long = "speed = 1200\ncycle = 'four-stroke'\neffects = ['torque']\nfiring_order = [1,24,5,20,9,16,11,14,7,18,3,22,12,13,8,17,4,21,2,23,6,19,10,15]\n\
                inline = { spacing = '0.2 m' }\nmechanism = { stroke = '0.3 m', rod_length = '0.6 m', reciprocating_mass = '50 kg' }\n";
    tells(&said("classify", long, &[]), &["All other roll moments"], &[]);
}

#[test]
fn the_box_and_the_section_on_remedies_have_the_same_counterweights() {
    let two = "speed = 1000\nbearings = ['0.2 m', '-0.2 m']\ninline = { throws = [0, 180], spacing = '0.1 m' }\n\
               mechanism = { stroke = '80 mm', rod_length = '200 mm', reciprocating_mass = [0, '1 kg'], rotating_mass = ['1 kg', 0] }\n";
    tells(&said("classify", two, &[]), &["20.0 kg·mm"], &["40.0 kg·mm"]);
    tells(&said("remedy", two, &[]), &["20.0 kg·mm"], &["40.0 kg·mm"]);
}

/// The moment of an in-line six vanishes for a mirrored crankshaft, and for no angle of the other for all lengths.
#[test]
fn a_moment_of_several_lengths_is_told_of_all_of_them() {
    let six = "orders = [1, 2]\ninline = { throws = [0, 120, 240, 240, 120, 0], positions = ['a', 'b', 'c', '-d', '-e', '-f'] }\n";
    tells(&said("classify", six, &[]), &["0 for some", "where it does not for all"], &["never 0"]);
    let two =
        "orders = [1, 2]\nvee = { bank_angle = 'phi', throws = [0, 90], positions = ['a', 'b'], bank_offset = 'c' }\n";
    tells(&said("classify", two, &[]), &["for all lengths", "where it does not for all"], &["never 0"]);
    let one = "orders = [1]\nvee = { bank_angle = 'phi', throws = [0, 90], spacing = 'a' }\n";
    tells(&said("classify", one, &[]), &[], &["for all lengths", "where it does not for all"]);
}

/// The best point of the grid was on a lower hill.
#[test]
fn the_largest_residual_of_a_family_is_that_of_its_highest_hill() {
    let cylinder =
        |throw: &str, bank: &str| format!("[[cylinder]]\nthrow = '{throw}'\nbank = '{bank}'\nposition = 0\n");
    let three = [cylinder("90 + 7phi", "-phi"), cylinder("120 + 7phi", "0"), cylinder("120 - 4phi", "0")].concat();
    let pins =
        (1..=3).fold(three, |text, pin| text.replacen("position = 0\n[", &format!("position = 0\npin = {pin}\n["), 1));
    tells(
        &said("classify", &format!("orders = [2]\nreference_plane = 0\n{pins}pin = 3\n"), &[]),
        &["force 0.852 m r"],
        &[],
    );
    let split = "orders = [1, 2, 4, 6]\nreference_plane = 0\nvee = { bank_angle = 'phi', throws = [90, 0, 270], pin_split = '60 - phi' }\n";
    tells(&said("classify", split, &[]), &["0.0372 m r ω² (order 4)"], &[]);
}

#[test]
fn the_lowest_order_that_is_left_is_named_where_no_statement_is_made_on_all() {
    let odd = "speed = 3000\nvee = { bank_angle = 77.12345, throws = [0, 131.54321, 240], pin_split = -17.5, spacing = '90 mm' }\n\
               mechanism = { crank_radius = '40 mm', rod_length = '140 mm', reciprocating_mass = [0.5, 0.6, 0.5, 0.5, 0.6, 0.5] }\n";
    tells(&said("compare", odd, &["I4"]), &["1, elliptical"], &["long period"]);
}

#[test]
fn a_report_of_an_open_layout_says_which_effects_wait_for_values() {
    let open = "effects = ['torque', 'gas']\nvee = { bank_angle = 'phi', throws = [0, 180] }\n";
    let words = "The layout asks for `torque`, `gas` too: a report has them once the unknowns have values.";
    tells(&said("report", open, &[]), &[words], &[]);
}

#[test]
fn without_a_reciprocating_mass_multiples_say_of_which_mass_they_are() {
    let two = "inline = { throws = [0, 180], spacing = '90 mm' }\n\
               mechanism = { crank_radius = '40 mm', rod_length = '140 mm', reciprocating_mass = 0, rotating_mass = 0.5 }\n";
    tells(&said("classify", two, &[]), &["m is 1 kg"], &[]);
    tells(&said("classify", &two.replace("mass = 0,", "mass = 1,"), &[]), &[], &["m is 1 kg"]);
}

/// The line was told in coordinates that turn with the engine.
#[test]
fn a_line_of_mounts_has_the_direction_that_the_file_gives_it() {
    let mount = |place: &str| format!("[[mount]]\nplace = [{place}]\nstiffness = 90000\n");
    let two = mount("'50 mm', '320 mm', '200 mm'") + &mount("'-50 mm', '-320 mm', '-200 mm'");
    for rotation in ["clockwise", "anticlockwise"] {
        let layout = format!(
            "rotation = '{rotation}'\ninline = {{ throws = [0, 180], spacing = '88 mm' }}\n\
             block = {{ mass = 180, inertia = [13, 11, 6.5], centre = [0, 0, 0] }}\n{two}"
        );
        let told = crankstar::file::parse("line.toml", &layout).expect_err("one line").to_string();
        assert!(told.contains("its direction (5/32, 1, 5/8)"), "{told}");
    }
}

#[test]
fn counterweights_on_the_limit_of_a_mass_are_told_where_they_do_not_decide_a_claim() {
    let layout = written(
        "inline.throws = [0]\n[mechanism]\nstroke = '80 mm'\nrod_length = '150 mm'\nreciprocating_mass = '0.5 kg'\nrotating_mass = '0.4 kg'\n",
    );
    let claim = |mass: &str| {
        let says = format!(
            "counterweights at 0 can balance the direct first-order force and moment with a crankshaft lighter than {mass} kg"
        );
        let file = written(&format!("[[claim]]\nlayout = '{layout}'\nsays = '{says}'\n"));
        // A claim that does not hold ends the program with 1.
        String::from_utf8_lossy(&call(&["check", &file, "--format", "markdown"]).stdout)
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
    };
    tells(
        &claim("1.3"),
        &["The crankshaft's mass is then ≈ 1.300 kg, which does not decide the claim."],
        &["No counterweights"],
    );
    tells(&claim("1.30001"), &["The crankshaft's mass is then ≈ 1.300 kg."], &["does not decide"]);
    tells(&claim("1.2"), &["No counterweights at these positions do that."], &[]);
}

#[test]
fn what_is_asked_of_the_catalogue_for_one_engine_is_refused() {
    for arguments in [&["firing", "--orders", "1/2"][..], &["firing", "--mode-shape", "1,2"]] {
        assert_eq!(call(arguments).status.code(), Some(2), "{arguments:?}");
    }
    tells(&String::from_utf8_lossy(&call(&["check", "nofile"]).stderr), &["cannot read `nofile`"], &["catalogue"]);
}

#[test]
fn cylinders_that_are_alike_and_weigh_more_than_the_unit_have_no_weight_of_1() {
    let told = |mass: &str| {
        let cylinder =
            |throw: u32| format!("{{ throw = {throw}, bank = 0, position = 0, reciprocating_mass = '{mass}' }}");
        let layout = format!("cylinder = [{}, {}]\n", cylinder(0), cylinder(90));
        said("report", &layout, &["--format", "markdown"])
    };
    tells(&told("5/2"), &["in multiples of"], &["1 where all cylinders are alike"]);
    tells(&told("1"), &["1 where all cylinders are alike"], &[]);
}

#[test]
fn what_is_one_is_told_in_the_singular() {
    let single = "inline = { throws = [0] }\n";
    tells(&said("exercise", single, &["--format", "text"]), &["An engine with 1 cylinder."], &[]);
    let german = said("exercise", single, &["--format", "text", "--lang", "de"]);
    tells(&german, &["Ein Motor mit 1 Zylinder."], &[]);
    let twin = "vee = { bank_angle = 'phi', throws = [0] }\n";
    tells(&said("report", twin, &["--format", "text"]), &["Free parameter: φ."], &[]);
}

/// The moment of a star's table is the sum of its vectors times their arms, those of masses that turn too; its weights are doubled, which is said.
#[test]
fn tables_of_stars_tell_arms_and_weights_of_all_that_turns() {
    let offset = SINGLE.replace("stroke", "pin_offset = '4 mm', stroke")
        + "[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '10 kg mm'\nangle = 180\nposition = '20 mm'\n\
            [crankshaft]\nbalance_factor = 1\ncounterweight_radius = '40 mm'\nweb_offset = '25 mm'\n";
    let page = said("report", &offset, &["--orders", "1", "--format", "markdown"]);
    tells(
        &page,
        &[
            "| ½ direct in m r ω² | ½ reverse in m r ω² |",
            "| cw 1 | 25 | ≈",
            "| cw 2 | −25 | ≈",
            "| shaft 1 | 20 | – | ≈",
            "| **Σ moment** in metres |",
            "its weight is twice its mass times radius",
        ],
        &[],
    );
    tells(&said("report", "inline = { throws = [0, 120, 240] }", &[]), &["The weight"], &["A mass that turns with"]);
}

/// Only what has an open length has moments that vanish for all lengths, and what stands behind ≈ is a residue as well.
#[test]
fn the_legend_of_a_family_speaks_of_lengths_only_where_some_are_open() {
    let fan = "[fan]\nbanks = ['-phi', 0, 'phi']\nthrows = [0, 'delta', 180]\npositions = ['3a+b', 'a', '-2a-b']\nbank_offsets = ['b', 0, '-b']\n";
    let valued = format!("values = {{ a = '22 mm', b = '16 mm' }}\n{fan}");
    let residues = "behind ≡ and ≈ they are modulo 360°";
    tells(
        &said("report", &valued, &["--orders", "1", "--format", "markdown"]),
        &["2φ ≈ 113.3°", residues],
        &["for all lengths"],
    );
    tells(&said("classify", &valued, &["--orders", "1"]), &[residues], &["lengths"]);
    let open = "[vee]\nbank_angle = 'phi'\nthrows = [0, 180]\npositions = ['a', 0]\n";
    tells(&said("report", open, &["--orders", "1"]), &[residues, "a vanishing moment vanishes for all lengths"], &[]);
}

#[test]
fn an_engine_at_rest_has_no_share_and_no_direction() {
    let page = said("loads", AT_REST, &["--orders", "1,2", "--format", "markdown"]);
    tells(
        &page,
        &["| 2 | force | **0** | **0** | – |", "| reciprocating masses | yes | orders 1, 2 | **0** | **0** |"],
        &["≈ 0 N"],
    );
}

/// ψ is 0 where the crank points along the axis; the gas may count its angles from where the piston is farthest out.
#[test]
fn a_page_of_angles_says_from_where_each_cylinder_counts() {
    let single = "speed = 2400\ncycle = 'four-stroke'\n[inline]\nthrows = [20]\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\n\
        reciprocating_mass = '0.6 kg'\npin_offset = '-8 mm'\n[gas]\nbore = '80 mm'\ndead_centre = 'piston'\nprocess = 'spark-ignition'\n\
        compression_ratio = 9\npeak_pressure = '60 bar'\n";
    let page = said("angle", single, &["--at", "340", "--format", "markdown"]);
    tells(
        &page,
        &["| 340° | ≈ 0 |", "ψ is 0 where the crank of the cylinder points along its axis"],
        &["ψ is the crank angle after"],
    );
}

#[test]
fn several_bearings_of_geared_crankshafts_are_named_in_german() {
    let twin = "speed = 1600\nbearings = ['200 mm', '70 mm', '-70 mm', '-200 mm']\n[opposed_piston]\nthrows = [0, 120, 240]\nlead = 11\n\
        leading = 'lower'\nsense = 'against'\ndistance = '900 mm'\nspacing = '130 mm'\n[mechanism]\nstroke = ['120 mm', '120 mm', '120 mm', '100 mm', '100 mm', '100 mm']\n\
        rod_length = '220 mm'\nreciprocating_mass = 4\nrotating_mass = 3\n";
    let page = said("report", twin, &["--lang", "de", "--format", "markdown"]);
    tells(&page, &["Lager unten 2, unten 3"], &["lower 2", "lower 3"]);
}

#[test]
fn proofs_of_open_firing_say_from_where_whole_orders_count() {
    let twin = "cycle = 'four-stroke'\nfiring_angles = [0, '360 + phi']\n[vee]\nbank_angle = 'phi'\nthrows = [0]\n";
    let page = said("firing", twin, &["--orders", "1", "--format", "markdown"]);
    tells(&page, &["proofs of whole orders count them from θ = 0"], &[]);
}

/// German names: a fan has no V angle, what a sum is has one name, and at a dot of a sweep the tip runs on a circle.
#[test]
fn german_drawings_name_angles_and_resultants_as_the_pages_do() {
    let fan = said("report", "[fan]\nbanks = [-60, 'phi', 60]\nthrows = [0]\n", &["--lang", "de", "--format", "html"]);
    tells(&fan, &["Bankwinkel φ"], &["V-Winkel"]);
    let offset = SINGLE.replace("stroke", "pin_offset = '4 mm', stroke");
    let drawn = said("report", &offset, &["--lang", "de", "--format", "html", "--orders", "1"]);
    tells(&drawn, &[">Result. ≈ "], &["Summe ≈ "]);
}

/// The short names of masses that turn are explained where the tables are, also where no drawing has them, and in German.
#[test]
fn short_names_in_tables_are_explained_in_every_format() {
    let layout = SINGLE.to_owned()
        + "[crankshaft]\npin_mass = '0.1 kg'\nbalance_factor = 1\ncounterweight_radius = '40 mm'\nweb_offset = '25 mm'\n";
    let english = said("report", &layout, &["--format", "text", "--orders", "1"]);
    tells(&english, &["Short names: cw for a counterweight, pin for a crankpin, rod for the big end of a rod."], &[]);
    let german = said("report", &layout, &["--lang", "de", "--format", "markdown", "--orders", "1"]);
    let (_, proofs) = german.split_once("| Hz 1 |").expect("a table");
    assert!(!proofs.contains("| pin 1 |"), "{german}");
    tells(&german, &["Gg für ein Gegengewicht, Hz für einen Hubzapfen, Pl für das große Auge eines Pleuels."], &[]);
    tells(&said("report", "inline = { throws = [0, 180] }", &["--format", "text"]), &[], &["Short names"]);
    let radial = printed(&["report", "radial-9-master", "--lang", "de", "--format", "html"]);
    tells(&radial, &[], &[" off<", " on<"]);
}

#[test]
fn lengths_of_a_family_in_metres_have_their_unit() {
    let layout = "values = { a = '22 mm' }\n[vee]\nbank_angle = 'phi'\nthrows = [0, 180]\npositions = ['a', '-0.03']\nbank_offset = '0.01'\n";
    let page = said("report", layout, &["--format", "markdown", "--orders", "1"]);
    tells(&page, &["| Moment, direct (m) | Moment, reverse (m) |", "about the plane z = −0.004 m."], &[]);
    let spaced = said("report", "[vee]\nbank_angle = 'phi'\nthrows = [0, 180]\n", &["--format", "markdown"]);
    tells(&spaced, &["| Moment, direct | Moment, reverse |", "about the plane z = 0."], &[]);
}
